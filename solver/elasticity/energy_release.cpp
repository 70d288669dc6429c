#include "solver/elasticity/energy_release.hpp"

#include "solver/elasticity/equilibrium_system.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <stdexcept>

namespace cleave::elasticity {

namespace {

/// Growth at every vertex of the mesh.
Vectors vertex_growth(const mesh::TetMesh& mesh, const CrackExtension& extension) {
    Vectors growth;
    for (const Eigen::Vector3d& x : mesh.vertices) growth.push_back(extension.growth(x));
    return growth;
}

mesh::TetMesh moved_mesh(const mesh::TetMesh& mesh, const Vectors& growth, double step) {
    mesh::TetMesh moved = mesh;
    for (std::size_t v = 0; v < growth.size(); ++v) moved.vertices[v] += step * growth[v];
    return moved;
}

EquilibriumSystem moved_system(const EquilibriumProblem& problem, const EquilibriumOptions& options, const ConformingBody& body,
                               const mesh::TetMesh& moved) {
    return make_system(problem, options.link_penalty, std::make_shared<const ConformingBody>(move_body(body, moved)));
}

/// Rate of the area vector (m^2 per m) of a face whose vertices grow.
Eigen::Vector3d area_rate(const std::array<int, 3>& face, const Vectors& x, const Vectors& q) {
    const auto [a, b, c] = face;
    return 0.5 * ((q[b] - q[a]).cross(x[c] - x[a]) + (x[b] - x[a]).cross(q[c] - q[a]));
}

Eigen::Vector3d area_of(const std::array<int, 3>& face, const Vectors& x) {
    return 0.5 * (x[face[1]] - x[face[0]]).cross(x[face[2]] - x[face[0]]);
}

double width_of(const mesh::TetMesh& mesh, int crack_surface, const Vectors& growth) {
    double rate = 0;
    for (const mesh::SurfaceTriangle& triangle : mesh.surface)
        if (triangle.id == crack_surface)
            rate += area_of(triangle.vertices, mesh.vertices).normalized().dot(area_rate(triangle.vertices, mesh.vertices, growth));
    if (!(rate > 0)) throw std::invalid_argument("a growth that enlarges the crack's surface " + std::to_string(crack_surface));
    return 0.5 * rate;
}

/// Power (J per m) of the dead loads as their surfaces and volumes grow, at the displacement as it is.
double load_rate(const EquilibriumProblem& problem, const EquilibriumSystem& base, const Vectors& trace, const Vectors& growth,
                 const std::vector<Eigen::Matrix3d>& slope, const EquilibriumSolution& solution) {
    double rate = 0;
    const FaceSet& faces = base.body->faces;
    for (std::size_t half = 0; half < faces.of_half_face.size(); ++half) {
        const int f = faces.of_half_face[half];
        if (!faces.faces[f].is_boundary() || base.surface_loads[f].isZero(0)) continue;
        const auto vertices = mesh::face_of(problem.mesh.tets[half / 4], static_cast<int>(half % 4));
        const Eigen::Vector3d area = faces.faces[f].area;
        rate += base.surface_loads[f].dot(trace[f]) * area.dot(area_rate(vertices, problem.mesh.vertices, growth)) / area.squaredNorm();
    }
    if (!problem.body_force) return rate;
    const particles::Particles& particles = base.body->particles;
    for (int i = 0; i < particles.size(); ++i)
        rate += particles.volume[i] * slope[i].trace() * problem.body_force(particles.position[i]).dot(solution.displacement[i]);
    return rate;
}

double domain_integral(const EquilibriumProblem& problem, const EquilibriumSystem& base, const EquilibriumSolution& solution,
                       const Vectors& trace, const Vectors& growth) {
    const particles::Particles& particles = base.body->particles;
    std::vector<Eigen::Matrix3d> slope(particles.size());
    double integral = 0;
    for (int i = 0; i < particles.size(); ++i) {
        slope[i] = growth_gradient(problem.mesh, i, growth);
        const Eigen::Matrix3d stress = material::stress_from_voigt(solution.fields.stress[i]);
        const Eigen::Matrix3d turned = solution.fields.gradient[i] * slope[i];
        integral += particles.volume[i] * stress.cwiseProduct(turned).sum() - solution.fields.energy[i] * slope[i].trace();
    }
    return integral + load_rate(problem, base, trace, growth, slope, solution);
}

}  // namespace

Eigen::Matrix3d growth_gradient(const mesh::TetMesh& mesh, int tet, const Vectors& growth) {
    const auto& corners = mesh.tets[tet];
    Eigen::Matrix3d edges, changes;
    for (int k = 0; k < 3; ++k) {
        edges.col(k) = mesh.vertices[corners[k + 1]] - mesh.vertices[corners[0]];
        changes.col(k) = growth[corners[k + 1]] - growth[corners[0]];
    }
    return changes * edges.inverse();
}

double crack_width(const mesh::TetMesh& mesh, const CrackExtension& extension) {
    return width_of(mesh, extension.crack_surface, vertex_growth(mesh, extension));
}

std::vector<EnergyRelease> energy_release(const EquilibriumProblem& problem, const EquilibriumOptions& options,
                                          const EquilibriumSolution& solution, const std::vector<CrackExtension>& extensions, double step) {
    const EquilibriumSystem base = make_system(problem, options.link_penalty, solution.body);
    const Vectors inertia = inertia_forces(problem, base);
    Vectors trace;
    face_displacements(*solution.body, solution.displacement, trace);
    std::vector<EnergyRelease> results;
    for (const CrackExtension& extension : extensions) {
        const Vectors growth = vertex_growth(problem.mesh, extension);
        EnergyRelease result;
        result.width = width_of(problem.mesh, extension.crack_surface, growth);
        const auto potential = [&](double by) {
            const mesh::TetMesh moved = moved_mesh(problem.mesh, growth, by);
            return moved_system(problem, options, *solution.body, moved).potential(solution.displacement, inertia);
        };
        result.by_movement = (potential(-step) - potential(step)) / (2 * step * result.width);
        result.by_domain_integral = domain_integral(problem, base, solution, trace, growth) / result.width;
        results.push_back(result);
    }
    return results;
}

double energy_release_by_solving(const EquilibriumProblem& problem, const EquilibriumOptions& options,
                                 const EquilibriumSolution& solution, const CrackExtension& extension, double step) {
    const Vectors growth = vertex_growth(problem.mesh, extension);
    const Vectors inertia = inertia_forces(problem, make_system(problem, options.link_penalty, solution.body));
    const auto potential = [&](double by) {
        const EquilibriumSystem system = moved_system(problem, options, *solution.body, moved_mesh(problem.mesh, growth, by));
        Vectors displacement = solution.displacement;
        EquilibriumReport report;
        solve_system(system, options, inertia, displacement, report);
        return system.potential(displacement, inertia);
    };
    return (potential(-step) - potential(step)) / (2 * step * width_of(problem.mesh, extension.crack_surface, growth));
}

}  // namespace cleave::elasticity
