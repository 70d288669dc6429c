#include "benchmarks/scenarios.hpp"

#include "benchmarks/timing.hpp"
#include "solver/fracture/interfaces.hpp"
#include "solver/material/material.hpp"
#include "solver/mesh/recipes/recipes.hpp"

#include <Eigen/Geometry>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <set>

namespace cleave::benchmarks {
namespace {

using Eigen::Vector3d;

/// Meshes are kept beside the program, where that may be written.
std::filesystem::path mesh_cache() {
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    return ::access(folder.c_str(), W_OK) == 0 ? folder / "meshes" : std::filesystem::path{};
}

/// Boundary faces: centre, inward unit normal, tet.
struct BoundaryFace {
    Vector3d centre, inward;
    int tet;
};

std::vector<BoundaryFace> boundary(const mesh::TetMesh& mesh) {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    std::vector<BoundaryFace> faces;
    for (int h = 0; h < static_cast<int>(links.opposite.size()); ++h) {
        if (links.opposite[h] >= 0) continue;
        const auto [a, b, c] = mesh::face_of(mesh.tets[h / 4], h % 4);
        const Vector3d &x = mesh.vertices[a], &y = mesh.vertices[b], &z = mesh.vertices[c];
        faces.push_back({(x + y + z) / 3, -(y - x).cross(z - x).normalized(), h / 4});
    }
    return faces;
}

}  // namespace

const std::map<std::string, Scenario>& scenarios() {
    static const std::map<std::string, Scenario> all{
        {"pot", {"pot", {"soda_lime_glass"}, 1e6, 1, {86, 2869, 1505, 6163, 15'717}}},
        {"glass", {"window", {"soda_lime_glass"}, 1e6, 1, {91, 1593, 329, 1743, 9027}}},
        {"pots", {"pot", {"soda_lime_glass"}, 1e6, 13, {588, 12'923, 11'037, 80'119, 144'975}}},
        {"pet", {"pet", {"soda_lime_glass"}, 1e6, 1, {341, 86'784, 3386, 23'664, 57'882}}},
        {"tai_chi", {"tai_chi", {"t300_5208", "sitka_spruce"}, 1e6, 1, {649, 12'330, 4010, 3880, 27'278}}}};
    return all;
}

ScenarioBody::ScenarioBody(const Scenario& scenario)
    : mesh_(mesh::make_body({.recipe = scenario.recipe, .file = {}, .particles = 0, .mesher = {}, .layers = {}}, mesh_cache()).mesh),
      particles_(particles::from_mesh(mesh_)) {
    std::map<int, int> material_of;  // by region
    std::vector<fracture::Brittleness> brittleness;
    for (const int region : std::set<int>(mesh_.regions.begin(), mesh_.regions.end())) {
        const material::Material material = material::find_material(scenario.materials[material_of.size() % scenario.materials.size()]);
        material_of[region] = static_cast<int>(solid_.stiffness.size());
        stiffness_[region] = material.stiffness;
        regions_.push_back(region);
        solid_.stiffness.push_back(material.stiffness);
        brittleness.push_back(fracture::uniform_brittleness(3e7, 10, material.stiffness));
    }
    for (const int region : mesh_.regions) solid_.material.push_back(material_of.at(region));
    strain_operator_ = elasticity::make_strain_operator("corrected", particles_, particles::build_neighbourhood(particles_));
    generator_ = std::make_unique<fracture::CrackGenerator>(fracture::Body{particles_, strain_operator_, solid_, brittleness,
                                                                           fracture::interface_faces(mesh_, solid_.material),
                                                                           fracture::mean_thickness(mesh_), fracture::diameter(particles_)});
    broken_ = std::make_unique<fragments::FragmentedBody>(mesh_);
    contacts_ = contacts(scenario.force);
}

std::vector<ScenarioBody::Contact> ScenarioBody::contacts(double force) const {
    const std::vector<BoundaryFace> faces = boundary(mesh_);
    std::vector<Contact> found;
    for (const Vector3d& direction : {Vector3d(1, 0.2, 0.3), Vector3d(-0.4, 1, 0.5), Vector3d(-0.3, -0.8, 1), Vector3d(0.6, -1, -0.4)}) {
        const auto reach = [&](const BoundaryFace& face) { return direction.dot(face.centre); };
        const BoundaryFace& face = *std::max_element(faces.begin(), faces.end(), [&](const auto& a, const auto& b) { return reach(a) < reach(b); });
        found.push_back({{.point = face.centre, .inward = face.inward, .force = force * face.inward, .radius = 1e-3}, face.tet});
    }
    return found;
}

StageSeconds ScenarioBody::break_up() {
    StageSeconds seconds;
    broken_->reset();
    cracks_ = 0;
    for (const Contact& contact : contacts_) {
        fracture::CrackAnalysis analysis;
        seconds.stress_analysis += seconds_of([&] {
            const auto displacement = contact::contact_displacement(contact::DisplacementSource::half_space, {mesh_, particles_, stiffness_}, contact.load);
            analysis = generator_->generate({.position = contact.load.point, .normal = contact.load.inward}, displacement, {.groups = 4});
        });
        const int near = contact.particle;
        for (const fracture::Crack& crack : analysis.cracks) {
            const fragments::Crack opened{.disc = {.centre = crack.centre, .normal = crack.normal, .radius = crack.outer_radius},
                                          .inner_radius = crack.inner_radius, .region = regions_[crack.material]};
            // The fragment at the contact; once its tet has been subdivided, the one of its first child.
            const int particle = broken_->is_particle(near) ? near : broken_->originals() + broken_->engine().first_child(near);
            const int fragment = broken_->fragment_of(particle);
            seconds.subdivision += seconds_of([&] { broken_->subdivide(opened, fragment); });
            seconds.crack_generation += seconds_of([&] { broken_->open(opened, fragment); });
            ++cracks_;
        }
    }
    return seconds;
}

}  // namespace cleave::benchmarks
