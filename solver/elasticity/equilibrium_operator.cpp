#include "solver/elasticity/equilibrium_operator.hpp"

#include <algorithm>

namespace cleave::elasticity {

namespace {

/// Stress (Pa) of a displacement gradient as a 3x3 matrix.
Eigen::Matrix3d stress_of(const material::Stiffness& stiffness, const Eigen::Matrix3d& gradient) {
    return material::stress_from_voigt(stiffness * strain_of(gradient));
}

/// Voigt strain of v (x) b as a 6x3 matrix times v.
Eigen::Matrix<double, 6, 3> strain_matrix(const Eigen::Vector3d& b) {
    Eigen::Matrix<double, 6, 3> m;
    m << b.x(), 0, 0, 0, b.y(), 0, 0, 0, b.z(), 0, b.z(), b.y(), b.z(), 0, b.x(), b.y(), b.x(), 0;
    return m;
}

void add_link(QuadraticEnergy& energy, int f, double link_penalty, const std::vector<double>& young) {
    const ConformingBody& body = *energy.body;
    const Face& face = body.faces.faces[f];
    const auto& x = body.particles.position;
    const int i = face.inside, j = face.outside;
    const Eigen::Vector3d x_ji = x[j] - x[i];
    const bool interface = body.solid.material[i] != body.solid.material[j];
    energy.link_inside[f] = interface ? Eigen::Vector3d(face.centroid - x[i]) : Eigen::Vector3d(0.5 * x_ji);
    energy.link_outside[f] = interface ? Eigen::Vector3d(x[j] - face.centroid) : Eigen::Vector3d(0.5 * x_ji);
    const double modulus = 0.5 * (young[body.solid.material[i]] + young[body.solid.material[j]]);
    energy.link[f] = link_penalty * modulus * (body.particles.volume[i] + body.particles.volume[j]) / (8 * x_ji.squaredNorm());
}

void add_nitsche(QuadraticEnergy& energy) {
    const ConformingBody& body = *energy.body;
    std::vector<int> count(body.particles.size(), 0);
    for (const PrescribedFace& at : energy.prescribed) ++count[body.faces.faces[at.face].inside];
    for (const PrescribedFace& at : energy.prescribed) {
        const Face& face = body.faces.faces[at.face];
        const Eigen::Matrix3d acoustic = contract(body.solid.of(face.inside), face.area, face.area);
        const double size = nitsche_margin * count[face.inside] / body.particles.volume[face.inside];
        energy.nitsche.push_back(size * (at.mask.asDiagonal() * acoustic * at.mask.asDiagonal()));
    }
}

/// The blocks that strains and links add for the particle i and the links it owns (those it is inside of).
class BlockSum {
public:
    BlockSum(const QuadraticEnergy& energy, const GradientStencils& stencils)
        : energy_(energy), body_(*energy.body), stencils_(stencils), block_(body_.particles.size(), Eigen::Matrix3d::Zero()) {}

    std::vector<Eigen::Matrix3d> sum() {
        for (int i = 0; i < body_.particles.size(); ++i) add_strain(i);
        for (int f = 0; f < body_.faces.size(); ++f)
            if (energy_.link[f] > 0) add_link_block(f);
        for (std::size_t n = 0; n < energy_.prescribed.size(); ++n) add_prescribed(n);
        return block_;
    }

private:
    void add_strain(int i) {
        for (std::size_t n = stencils_.offset[i]; n < stencils_.offset[i + 1]; ++n) {
            const Eigen::Vector3d& b = stencils_.weight[n];
            block_[stencils_.index[n]] += body_.particles.volume[i] * contract(body_.solid.of(i), b, b);
        }
    }

    /// r = u_j - u_i - sum_k (b_ik.d_i + b_jk.d_j) u_k: one number per particle.
    void add_link_block(int f) {
        const Face& face = body_.faces.faces[f];
        row_.clear();
        row_.emplace_back(face.inside, -1);
        row_.emplace_back(face.outside, 1);
        append(face.inside, energy_.link_inside[f]);
        append(face.outside, energy_.link_outside[f]);
        std::stable_sort(row_.begin(), row_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t n = 0; n < row_.size();) {
            const int k = row_[n].first;
            double value = 0;
            for (; n < row_.size() && row_[n].first == k; ++n) value += row_[n].second;
            block_[k].diagonal().array() += energy_.link[f] * value * value;
        }
    }

    void append(int i, const Eigen::Vector3d& d) {
        for (std::size_t n = stencils_.offset[i]; n < stencils_.offset[i + 1]; ++n)
            row_.emplace_back(stencils_.index[n], -stencils_.weight[n].dot(d));
    }

    void add_prescribed(std::size_t at) {
        const PrescribedFace& prescribed = energy_.prescribed[at];
        const Face& face = body_.faces.faces[prescribed.face];
        const int i = face.inside;
        for (std::size_t n = body_.traces.offset[prescribed.face]; n < body_.traces.offset[prescribed.face + 1]; ++n) {
            const int k = body_.traces.particle[n];
            const double phi = body_.traces.weight[n];
            const auto first = stencils_.index.begin() + stencils_.offset[i], last = stencils_.index.begin() + stencils_.offset[i + 1];
            const Eigen::Vector3d& b = stencils_.weight[std::lower_bound(first, last, k) - stencils_.index.begin()];
            const Eigen::Matrix3d work = phi * (prescribed.mask.asDiagonal() * contract(body_.solid.of(i), face.area, b));
            block_[k] += phi * phi * energy_.nitsche[at] - work - work.transpose();
        }
    }

    const QuadraticEnergy& energy_;
    const ConformingBody& body_;
    const GradientStencils& stencils_;
    std::vector<Eigen::Matrix3d> block_;
    std::vector<std::pair<int, double>> row_;
};

}  // namespace

Eigen::Matrix3d contract(const material::Stiffness& stiffness, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return strain_matrix(a).transpose() * stiffness * strain_matrix(b);
}

QuadraticEnergy make_energy(const ConformingBody& body, double link_penalty, std::vector<PrescribedFace> prescribed) {
    const int faces = body.faces.size();
    QuadraticEnergy energy{&body, std::vector<double>(faces, 0), Vectors(faces, Eigen::Vector3d::Zero()),
                           Vectors(faces, Eigen::Vector3d::Zero()), std::move(prescribed), std::vector<int>(faces, -1), {}};
    std::vector<double> young;
    for (const material::Stiffness& stiffness : body.solid.stiffness) young.push_back(material::hill_youngs_modulus(stiffness));
    for (int f = 0; f < faces; ++f)
        if (!body.faces.faces[f].is_boundary()) add_link(energy, f, link_penalty, young);
    for (std::size_t n = 0; n < energy.prescribed.size(); ++n) energy.prescription_of[energy.prescribed[n].face] = static_cast<int>(n);
    add_nitsche(energy);
    return energy;
}

Eigen::Vector3d link_mismatch(const QuadraticEnergy& energy, int face, const Vectors& displacement,
                              const std::vector<Eigen::Matrix3d>& gradient) {
    const Face& link = energy.body->faces.faces[face];
    return displacement[link.outside] - displacement[link.inside] - gradient[link.inside] * energy.link_inside[face] -
           gradient[link.outside] * energy.link_outside[face];
}

double link_energy(const QuadraticEnergy& energy, const Vectors& displacement) {
    const ConformingBody& body = *energy.body;
    Vectors trace;
    face_displacements(body, displacement, trace);
    std::vector<Eigen::Matrix3d> gradient(body.particles.size());
    parallel_for_each(body.particles.size(), [&](int i) { gradient[i] = face_gradient(body, i, trace); });
    double sum = 0;
    for (int f = 0; f < body.faces.size(); ++f)
        if (energy.link[f] > 0) sum += 0.5 * energy.link[f] * link_mismatch(energy, f, displacement, gradient).squaredNorm();
    return sum;
}

std::vector<Eigen::Matrix3d> diagonal_blocks(const QuadraticEnergy& energy, const GradientStencils& stencils) {
    return BlockSum(energy, stencils).sum();
}

/// Per particle: P_i = dE / d grad u_i (V_i sigma_i less the links' and Nitsche's part), and the links' direct force on it.
void StiffnessOperator::particle_stresses(const Vectors& displacement) {
    const ConformingBody& body = *energy_.body;
    const int count = body.particles.size();
    gradient_.resize(count), weighted_stress_.resize(count), self_force_.resize(count), link_force_.resize(body.faces.faces.size());
    face_displacements(body, displacement, trace_);
    parallel_for_each(count, [&](int i) { gradient_[i] = face_gradient(body, i, trace_); });
    parallel_for_each(body.faces.size(), [&](int f) {
        if (energy_.link[f] > 0) link_force_[f] = energy_.link[f] * link_mismatch(energy_, f, displacement, gradient_);
    });
    parallel_for_each(count, [&](int i) {
        Eigen::Matrix3d stress = body.particles.volume[i] * stress_of(body.solid.of(i), gradient_[i]);
        Eigen::Vector3d self = Eigen::Vector3d::Zero();
        for (int k = 0; k < 4; ++k) {
            const int f = body.faces.of_half_face[4 * i + k];
            const Face& face = body.faces.faces[f];
            if (energy_.link[f] > 0) {
                const bool inside = face.inside == i;
                stress -= link_force_[f] * (inside ? energy_.link_inside[f] : energy_.link_outside[f]).transpose();
                self += (inside ? -1 : 1) * link_force_[f];
            }
            const int at = energy_.prescription_of[f];
            if (at >= 0) stress -= stress_of(body.solid.of(i), energy_.prescribed[at].mask.cwiseProduct(trace_[f]) * face.area.transpose());
        }
        weighted_stress_[i] = stress;
        self_force_[i] = self;
    });
}

void StiffnessOperator::face_forces() {
    const ConformingBody& body = *energy_.body;
    face_force_.resize(body.faces.faces.size());
    parallel_for_each(body.faces.size(), [&](int f) {
        const Face& face = body.faces.faces[f];
        Eigen::Vector3d force = weighted_stress_[face.inside] * face.area / body.particles.volume[face.inside];
        if (!face.is_boundary()) force -= weighted_stress_[face.outside] * face.area / body.particles.volume[face.outside];
        const int at = energy_.prescription_of[f];
        if (at >= 0) {
            const Eigen::Vector3d reaction = stress_of(body.solid.of(face.inside), gradient_[face.inside]) * face.area;
            force += energy_.nitsche[at] * trace_[f] - energy_.prescribed[at].mask.cwiseProduct(reaction);
        }
        face_force_[f] = force;
    });
}

void StiffnessOperator::apply(const Vectors& displacement, Vectors& force) {
    const TraceWeights& traces = energy_.body->traces;
    particle_stresses(displacement);
    face_forces();
    force.resize(displacement.size());
    parallel_for_each(static_cast<int>(displacement.size()), [&](int k) {
        Eigen::Vector3d sum = self_force_[k];
        for (std::size_t n = traces.transposed_offset[k]; n < traces.transposed_offset[k + 1]; ++n)
            sum += traces.transposed_weight[n] * face_force_[traces.face[n]];
        force[k] = sum;
    });
}

}  // namespace cleave::elasticity
