#include "solver/elasticity/equilibrium_loads.hpp"

#include "solver/elasticity/equilibrium_rigid.hpp"

#include <Eigen/Eigenvalues>

#include <stdexcept>
#include <string>

namespace cleave::elasticity {

namespace {

/// The boundary faces of a surface id.
std::vector<int> faces_of(int id, const std::vector<int>& surface) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < surface.size(); ++f)
        if (surface[f] == id) faces.push_back(static_cast<int>(f));
    if (faces.empty()) throw std::invalid_argument("a surface id that boundary faces carry (none carries " + std::to_string(id) + ")");
    return faces;
}

void prescribe(PrescribedFace& at, const PrescribedDisplacement& condition, const Eigen::Vector3d& position) {
    const Eigen::Vector3d value = condition.value(position);
    for (int axis = 0; axis < 3; ++axis) {
        if (!condition.components[axis]) continue;
        if (at.mask[axis] != 0) {
            throw std::invalid_argument("each displacement component prescribed once (component " + std::string(1, "xyz"[axis]) +
                                        " twice on surface " + std::to_string(condition.surface) + ")");
        }
        at.mask[axis] = 1;
        at.value[axis] = value[axis];
    }
}

/// Face loads as particle forces: the transposed traces.
Vectors gather(const ConformingBody& body, const Vectors& face_loads) {
    Vectors force(body.particles.size(), Eigen::Vector3d::Zero());
    for (int k = 0; k < body.particles.size(); ++k)
        for (std::size_t n = body.traces.transposed_offset[k]; n < body.traces.transposed_offset[k + 1]; ++n)
            force[k] += body.traces.transposed_weight[n] * face_loads[body.traces.face[n]];
    return force;
}

}  // namespace

std::vector<PrescribedFace> prescribed_faces(const EquilibriumProblem& problem, const ConformingBody& body,
                                             const std::vector<int>& surface) {
    std::vector<PrescribedFace> all(body.faces.faces.size(), {0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    for (const PrescribedDisplacement& condition : problem.displacements)
        for (const int f : faces_of(condition.surface, surface)) prescribe(all[f], condition, body.faces.faces[f].centroid);
    std::vector<PrescribedFace> kept;
    for (std::size_t f = 0; f < all.size(); ++f)
        if (!all[f].mask.isZero(0)) kept.push_back({static_cast<int>(f), all[f].mask, all[f].value});
    return kept;
}

Vectors surface_loads(const EquilibriumProblem& problem, const ConformingBody& body, const std::vector<int>& surface) {
    Vectors loads(body.faces.faces.size(), Eigen::Vector3d::Zero());
    for (const Traction& traction : problem.tractions)
        for (const int f : faces_of(traction.surface, surface)) {
            const Face& face = body.faces.faces[f];
            const double area = face.area.norm();
            loads[f] += area * traction.value(face.centroid, face.area / area);
        }
    for (const Pressure& pressure : problem.pressures)
        for (const int f : faces_of(pressure.surface, surface)) loads[f] -= pressure.value * body.faces.faces[f].area;
    return loads;
}

Vectors external_forces(const EquilibriumProblem& problem, const ConformingBody& body, const Vectors& surface_loads) {
    Vectors force = gather(body, surface_loads);
    if (problem.body_force)
        for (int i = 0; i < body.particles.size(); ++i)
            force[i] += body.particles.volume[i] * problem.body_force(body.particles.position[i]);
    return force;
}

Vectors nitsche_forces(const QuadraticEnergy& energy) {
    const ConformingBody& body = *energy.body;
    Vectors loads(body.faces.faces.size(), Eigen::Vector3d::Zero());
    for (std::size_t n = 0; n < energy.prescribed.size(); ++n) {
        const PrescribedFace& at = energy.prescribed[n];
        const int i = body.faces.faces[at.face].inside;
        loads[at.face] += energy.nitsche[n] * at.value;
        // -(sigma_i(v) A n).g = -sum over the faces of i of (C : (g (x) A n)) A_f n_f . v_f / V_i.
        const Eigen::Matrix3d gradient = at.value * body.faces.faces[at.face].area.transpose();
        const Eigen::Matrix3d stress = material::stress_from_voigt(body.solid.of(i) * strain_of(gradient)) / body.particles.volume[i];
        for (int k = 0; k < 4; ++k) {
            const int f = body.faces.of_half_face[4 * i + k];
            loads[f] -= (body.faces.faces[f].inside == i ? 1 : -1) * (stress * body.faces.faces[f].area);
        }
    }
    return gather(body, loads);
}

double nitsche_constant(const QuadraticEnergy& energy) {
    double sum = 0;
    for (std::size_t n = 0; n < energy.prescribed.size(); ++n)
        sum += 0.5 * energy.prescribed[n].value.dot(energy.nitsche[n] * energy.prescribed[n].value);
    return sum;
}

void check_held(const ConformingBody& body, const std::vector<int>& piece, const std::vector<PrescribedFace>& prescribed) {
    using Gram = Eigen::Matrix<double, 6, 6>;
    int pieces = 0;
    Eigen::AlignedBox3d box;
    for (const int number : piece) pieces = std::max(pieces, number + 1);
    for (const Eigen::Vector3d& x : body.particles.position) box.extend(x);
    std::vector<Gram> gram(pieces, Gram::Zero());
    for (const PrescribedFace& at : prescribed) {
        const Face& face = body.faces.faces[at.face];
        const auto basis = (at.mask.asDiagonal() * rigid_basis((face.centroid - box.center()) / box.diagonal().norm())).eval();
        gram[piece[face.inside]] += basis.transpose() * basis;
    }
    for (int p = 0; p < pieces; ++p) {
        const Eigen::SelfAdjointEigenSolver<Gram> eigen(gram[p], Eigen::EigenvaluesOnly);
        // Squared, and a held piece may be small against the body: rounding only.
        if (eigen.eigenvalues()(0) > 1e-13 * eigen.eigenvalues()(5)) continue;
        throw std::invalid_argument("prescribed displacements that hold the body against every rigid motion, or a free body" +
                                    (pieces > 1 ? " (piece " + std::to_string(p + 1) + " of " + std::to_string(pieces) + " can move)"
                                                : std::string()));
    }
}

}  // namespace cleave::elasticity
