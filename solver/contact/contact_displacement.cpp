#include "solver/contact/contact_displacement.hpp"

#include "solver/input/input_error.hpp"
#include "solver/particles/nearest.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace cleave::contact {

namespace {

/// Hertz's pressure over its peak at tangential coordinates t (m) in the axes of the patch; 0 outside.
double patch_pressure(const ContactLoad& load, const Eigen::Vector2d& t) {
    const double other = load.other_radius > 0 ? load.other_radius : load.radius;
    const double rest = 1 - std::pow(t[0] / load.radius, 2) - std::pow(t[1] / other, 2);
    return rest > 0 ? std::sqrt(rest) : 0;
}

/// Mean of the pressure over a triangle: over the centroids of its 4^depth equal parts.
double mean_pressure(const ContactLoad& load, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, int depth) {
    if (depth == 0) return patch_pressure(load, (a + b + c) / 3);
    const Eigen::Vector2d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    return 0.25 * (mean_pressure(load, a, ab, ca, depth - 1) + mean_pressure(load, ab, b, bc, depth - 1) +
                   mean_pressure(load, ca, bc, c, depth - 1) + mean_pressure(load, ab, bc, ca, depth - 1));
}

/// A boundary triangle with its share of the contact's force.
struct LoadedFace {
    std::array<int, 3> vertices;
    Eigen::Vector3d centroid;
    double area, share;
};

std::vector<LoadedFace> boundary_triangles(const mesh::TetMesh& mesh, const elasticity::FaceSet& faces) {
    std::vector<LoadedFace> all;
    for (std::size_t half = 0; half < faces.of_half_face.size(); ++half) {
        const elasticity::Face& face = faces.faces[faces.of_half_face[half]];
        if (face.is_boundary()) all.push_back({mesh::face_of(mesh.tets[half / 4], static_cast<int>(half % 4)), face.centroid, face.area.norm(), 0});
    }
    return all;
}

/// Leaves the faces that carry load, their shares adding to one: those below the patch, seen from outside and within a radius of the
/// tangent plane, by their part of the pressure; the nearest one where there is none.
std::vector<LoadedFace> loaded_faces(const mesh::TetMesh& mesh, const ContactLoad& load) {
    std::vector<LoadedFace> all = boundary_triangles(mesh, elasticity::collect_faces(mesh));
    if (all.empty()) throw std::invalid_argument("a body with a boundary");
    const Eigen::Matrix3d axes = surface_axes(load.inward, load.axis);
    const double reach = std::max(load.radius, load.other_radius);
    double sum = 0;
    for (LoadedFace& face : all) {
        std::array<Eigen::Vector3d, 3> x;
        for (int k = 0; k < 3; ++k) x[k] = axes.transpose() * (mesh.vertices[face.vertices[k]] - load.point);
        const bool outside_in = (x[1] - x[0]).cross(x[2] - x[0])[2] < 0, near_plane = std::abs((x[0] + x[1] + x[2])[2] / 3) <= reach;
        if (load.radius <= 0 || !outside_in || !near_plane) continue;
        face.share = face.area * mean_pressure(load, x[0].head<2>(), x[1].head<2>(), x[2].head<2>(), 3);
        sum += face.share;
    }
    if (sum > 0) {
        std::erase_if(all, [](const LoadedFace& face) { return face.share == 0; });
        for (LoadedFace& face : all) face.share /= sum;
        return all;
    }
    const auto nearer = [&](const LoadedFace& a, const LoadedFace& b) { return particles::is_nearer(load.point, a.centroid, b.centroid); };
    LoadedFace nearest = *std::min_element(all.begin(), all.end(), nearer);
    nearest.share = 1;
    return {nearest};
}

ParticleDisplacement half_space_displacement(const ContactBody& body, const ContactLoad& load, const HalfSpaceOptions& options) {
    const int region = body.particles.region[particles::nearest_place(body.particles.position, load.point)];
    const auto stiffness = body.stiffness.find(region);
    if (stiffness == body.stiffness.end()) throw std::invalid_argument("a stiffness for region " + std::to_string(region));
    return [field = half_space_field(stiffness->second, load, options), &particles = body.particles](std::span<const int> ids,
                                                                                                     std::span<Eigen::Vector3d> values) {
        std::vector<Eigen::Vector3d> positions;
        positions.reserve(ids.size());
        for (const int i : ids) positions.push_back(particles.position[i]);
        field.displacements(positions, values);
    };
}

ParticleDisplacement equilibrium_displacement(const ContactBody& body, const ContactLoad& load) {
    return [all = contact_equilibrium(body, load).displacement](std::span<const int> ids, std::span<Eigen::Vector3d> values) {
        for (std::size_t k = 0; k < ids.size(); ++k) values[k] = all[ids[k]];
    };
}

}  // namespace

DisplacementSource displacement_source(const std::string& word) {
    if (word == "half_space") return DisplacementSource::half_space;
    if (word == "equilibrium") return DisplacementSource::equilibrium;
    throw InputError("", "displacement", "half_space or equilibrium (not '" + word + "')");
}

ParticleDisplacement contact_displacement(DisplacementSource source, const ContactBody& body, const ContactLoad& load,
                                          const HalfSpaceOptions& options) {
    return source == DisplacementSource::half_space ? half_space_displacement(body, load, options) : equilibrium_displacement(body, load);
}

elasticity::EquilibriumSolution contact_equilibrium(const ContactBody& body, const ContactLoad& load,
                                                    const elasticity::EquilibriumOptions& options) {
    constexpr int loaded = 1;
    mesh::TetMesh mesh = body.mesh;
    mesh.surface.clear();
    std::map<std::array<double, 3>, Eigen::Vector3d> traction;  // by centroid
    for (const LoadedFace& face : loaded_faces(body.mesh, load)) {
        mesh.surface.push_back({face.vertices, loaded});
        traction[{face.centroid[0], face.centroid[1], face.centroid[2]}] = face.share / face.area * load.force;
    }
    elasticity::EquilibriumProblem problem{.mesh = mesh, .stiffness = body.stiffness, .density = body.density};
    problem.free_body = true;
    problem.tractions.push_back({loaded, [&traction](const Eigen::Vector3d& x, const Eigen::Vector3d&) { return traction.at({x[0], x[1], x[2]}); }});
    return elasticity::solve_equilibrium(problem, options);
}

}  // namespace cleave::contact
