#include "solver/particles/particles.hpp"

#include "solver/particles/smoothing_tensor.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cleave::particles {

namespace {

/// Mean volume (m^3) of the tets around each vertex.
std::vector<double> vertex_volumes(const mesh::TetMesh& mesh, const std::vector<double>& volume) {
    std::vector<double> sum(mesh.vertices.size(), 0);
    std::vector<int> count(mesh.vertices.size(), 0);
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet)
        for (const int vertex : mesh.tets[tet]) {
            sum[vertex] += volume[tet];
            ++count[vertex];
        }
    for (std::size_t vertex = 0; vertex < sum.size(); ++vertex)
        if (count[vertex] > 0) sum[vertex] /= count[vertex];
    return sum;
}

double local_spacing(const std::array<int, 4>& tet, const std::vector<double>& vertex_volume) {
    double mean = 0;
    for (const int vertex : tet) mean += vertex_volume[vertex] / 4;
    return std::cbrt(mean);
}

void append(Particles& particles, const Eigen::Vector3d& position, double volume, double spacing, double support_ratio, int region) {
    if (!(volume > 0)) throw std::invalid_argument("particles of positive volume");
    particles.position.push_back(position);
    particles.volume.push_back(volume);
    particles.radius.push_back(std::cbrt(3 * volume / (4 * std::numbers::pi)));
    particles.spacing.push_back(spacing);
    particles.support_radius.push_back(support_ratio * spacing);
    particles.tensor.push_back(isotropic_tensor(support_ratio * spacing));
    particles.region.push_back(region);
}

}  // namespace

Particles from_mesh(const mesh::TetMesh& mesh, double support_ratio) {
    const int count = static_cast<int>(mesh.tets.size());
    std::vector<double> volume(count);
    for (int tet = 0; tet < count; ++tet) volume[tet] = mesh::tet_volume(mesh, tet);
    const std::vector<double> around = vertex_volumes(mesh, volume);
    Particles particles;
    for (int tet = 0; tet < count; ++tet)
        append(particles, mesh::tet_centroid(mesh, tet), volume[tet], local_spacing(mesh.tets[tet], around), support_ratio,
               mesh.regions.empty() ? 0 : mesh.regions[tet]);
    return particles;
}

Particles from_points(const std::vector<Eigen::Vector3d>& position, const std::vector<double>& volume, double spacing,
                      double support_ratio) {
    Particles particles;
    for (std::size_t i = 0; i < position.size(); ++i) append(particles, position[i], volume[i], spacing, support_ratio, 0);
    return particles;
}

}  // namespace cleave::particles
