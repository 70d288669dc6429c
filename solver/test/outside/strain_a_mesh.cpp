#include "solver/elasticity/strain.hpp"
#include "solver/material/material.hpp"
#include "solver/mesh/msh_file.hpp"

#include <iostream>

int main(int, char** argv) {
    using namespace cleave;
    auto particles = particles::from_mesh(mesh::read_msh(argv[1]));
    const auto neighbourhood = particles::build_neighbourhood(particles);
    const auto corrected = elasticity::make_strain_operator("corrected", particles, neighbourhood);
    const auto solid = elasticity::uniform_solid(material::find_material("silicon").stiffness, particles.size());
    std::vector<Eigen::Vector3d> displacement;  // a stretch of 0.1 % along x
    for (const Eigen::Vector3d& x : particles.position) displacement.push_back(1e-3 * x.x() * Eigen::Vector3d::UnitX());
    const auto fields = elasticity::evaluate(corrected, particles, solid, displacement);
    material::Voigt mean = material::Voigt::Zero();
    for (int i = 0; i < particles.size(); ++i) mean += fields.stress[i] / particles.size();
    std::cout << particles.size() << " particles, mean stress " << mean.transpose() / 1e6 << " MPa\n";
}
