#include "solver/elasticity/strain_pass.hpp"

#include "solver/elasticity/operators.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>
#include <stdexcept>

// The baseline x86-64-v3 has AVX2 and FMA but no AES, without which Highway would take it for less.
#define HWY_DISABLE_PCLMUL_AES
#include <hwy/highway.h>

namespace cleave::elasticity {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
// Four lanes wherever there are more: the order of the sums, and so every bit, is that of the baseline.
constexpr hn::CappedTag<double, 4> tag;
using Lanes = hn::Vec<hn::CappedTag<double, 4>>;
static_assert(hn::MaxLanes(tag) == 4, "four doubles: AVX2, the baseline");

/// S is left to the pseudo-inverse where det S is below this part of (tr S / 3)^3, which is one where the neighbours lie alike all round.
constexpr double singular = 1e-9;

struct Four {
    Lanes a, b, c, d;
};

/// Rows to columns.
Four transposed(Lanes r0, Lanes r1, Lanes r2, Lanes r3) {
    const Lanes t0 = hn::InterleaveLower(tag, r0, r1), t1 = hn::InterleaveUpper(tag, r0, r1);
    const Lanes t2 = hn::InterleaveLower(tag, r2, r3), t3 = hn::InterleaveUpper(tag, r2, r3);
    return {hn::ConcatLowerLower(tag, t2, t0), hn::ConcatLowerLower(tag, t3, t1), hn::ConcatUpperUpper(tag, t2, t0),
            hn::ConcatUpperUpper(tag, t3, t1)};
}

/// The sums of the lanes of four vectors.
void store_sums(Lanes r0, Lanes r1, Lanes r2, Lanes r3, double* sums) {
    const Four columns = transposed(r0, r1, r2, r3);
    hn::Store(hn::Add(hn::Add(columns.a, columns.b), hn::Add(columns.c, columns.d)), tag, sums);
}

/// The sums B and S of one particle. Two loops over blocks of pairs, since one would need more registers than the baseline has.
class PairSums {
public:
    /// Sums all pairs. `tensor` must be symmetric.
    PairSums(const PackedParticle& own, const Eigen::Matrix3d& tensor, std::span<const int> list, const std::vector<PackedParticle>& packed) {
        for (std::size_t first = 0; first < list.size(); first += block) {
            const std::size_t count = std::min(block, list.size() - first);
            for (std::size_t n = 0; n < count; ++n) pair_[n] = &packed[list[first + n]];
            // Lanes beyond the end hold the particle itself: y = 0, and it counts nothing.
            for (std::size_t n = count; n % 4 != 0; ++n) pair_[n] = &own;
            add_moments(own, tensor, count);
            add_displacements(own, count);
        }
    }

    Eigen::Matrix3d moment() const {
        const double* s = moment_;
        return (Eigen::Matrix3d() << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5]).finished();
    }
    Eigen::Matrix3d displacements() const { return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(moved_); }

private:
    static constexpr std::size_t block = 128;

    /// S, and w y of every pair of the block.
    void add_moments(const PackedParticle& own, const Eigen::Matrix3d& g, std::size_t count) {
        const Lanes x = hn::Set(tag, own.x), y = hn::Set(tag, own.y), z = hn::Set(tag, own.z);
        const Lanes g00 = hn::Set(tag, g(0, 0)), g01 = hn::Set(tag, g(0, 1)), g02 = hn::Set(tag, g(0, 2));
        const Lanes g11 = hn::Set(tag, g(1, 1)), g12 = hn::Set(tag, g(1, 2)), g22 = hn::Set(tag, g(2, 2));
        const Lanes zero = hn::Zero(tag), one = hn::Set(tag, 1.0), least = hn::Set(tag, std::numeric_limits<double>::min());
        Lanes s00 = zero, s01 = zero, s02 = zero, s11 = zero, s12 = zero, s22 = zero;
        for (std::size_t n = 0; n < count; n += 4) {
            const Four at = transposed(hn::Load(tag, &pair_[n]->x), hn::Load(tag, &pair_[n + 1]->x), hn::Load(tag, &pair_[n + 2]->x),
                                       hn::Load(tag, &pair_[n + 3]->x));
            const Lanes rx = hn::Sub(at.a, x), ry = hn::Sub(at.b, y), rz = hn::Sub(at.c, z);
            const Lanes y0 = hn::MulAdd(g00, rx, hn::MulAdd(g01, ry, hn::Mul(g02, rz)));
            const Lanes y1 = hn::MulAdd(g01, rx, hn::MulAdd(g11, ry, hn::Mul(g12, rz)));
            const Lanes y2 = hn::MulAdd(g02, rx, hn::MulAdd(g12, ry, hn::Mul(g22, rz)));
            const Lanes q = hn::Sqrt(hn::Max(hn::MulAdd(y0, y0, hn::MulAdd(y1, y1, hn::Mul(y2, y2))), least));
            const Lanes rest = hn::Max(hn::Sub(one, q), zero);
            const Lanes w = hn::Div(hn::Mul(at.d, hn::Mul(rest, rest)), q);
            const Lanes w0 = hn::Mul(w, y0), w1 = hn::Mul(w, y1), w2 = hn::Mul(w, y2);
            hn::Store(w0, tag, weighted_[0] + n), hn::Store(w1, tag, weighted_[1] + n), hn::Store(w2, tag, weighted_[2] + n);
            s00 = hn::MulAdd(w0, y0, s00), s01 = hn::MulAdd(w0, y1, s01), s02 = hn::MulAdd(w0, y2, s02);
            s11 = hn::MulAdd(w1, y1, s11), s12 = hn::MulAdd(w1, y2, s12), s22 = hn::MulAdd(w2, y2, s22);
        }
        alignas(32) double sums[8];
        store_sums(s00, s01, s02, s11, sums), store_sums(s12, s22, zero, zero, sums + 4);
        for (int k = 0; k < 6; ++k) moment_[k] += sums[k];
    }

    /// B.
    void add_displacements(const PackedParticle& own, std::size_t count) {
        const Lanes u = hn::Set(tag, own.u), v = hn::Set(tag, own.v), w = hn::Set(tag, own.w), zero = hn::Zero(tag);
        Lanes b00 = zero, b01 = zero, b02 = zero, b10 = zero, b11 = zero, b12 = zero, b20 = zero, b21 = zero, b22 = zero;
        for (std::size_t n = 0; n < count; n += 4) {
            const Four at = transposed(hn::Load(tag, &pair_[n]->u), hn::Load(tag, &pair_[n + 1]->u), hn::Load(tag, &pair_[n + 2]->u),
                                       hn::Load(tag, &pair_[n + 3]->u));
            const Lanes du = hn::Sub(at.a, u), dv = hn::Sub(at.b, v), dw = hn::Sub(at.c, w);
            const Lanes w0 = hn::Load(tag, weighted_[0] + n), w1 = hn::Load(tag, weighted_[1] + n), w2 = hn::Load(tag, weighted_[2] + n);
            b00 = hn::MulAdd(du, w0, b00), b01 = hn::MulAdd(du, w1, b01), b02 = hn::MulAdd(du, w2, b02);
            b10 = hn::MulAdd(dv, w0, b10), b11 = hn::MulAdd(dv, w1, b11), b12 = hn::MulAdd(dv, w2, b12);
            b20 = hn::MulAdd(dw, w0, b20), b21 = hn::MulAdd(dw, w1, b21), b22 = hn::MulAdd(dw, w2, b22);
        }
        alignas(32) double sums[12];
        store_sums(b00, b01, b02, b10, sums), store_sums(b11, b12, b20, b21, sums + 4), store_sums(b22, zero, zero, zero, sums + 8);
        for (int k = 0; k < 9; ++k) moved_[k] += sums[k];
    }

    const PackedParticle* pair_[block];
    alignas(32) double weighted_[3][block];
    double moment_[6]{}, moved_[9]{};  // S as 00, 01, 02, 11, 12, 22; B by rows
};

}  // namespace

StrainPass::StrainPass(const particles::Particles& particles, particles::NeighbourLists neighbours, Solid solid)
    : particles_(particles), neighbours_(std::move(neighbours)), solid_(std::move(solid)), packed_(particles.position.size()) {
    if (neighbours_.size() != particles_.size() || solid_.material.size() != packed_.size())
        throw std::invalid_argument("one list and one material per particle");
    for (int i = 0; i < particles_.size(); ++i) {
        const Eigen::Vector3d& x = particles_.position[i];
        packed_[i] = {x[0], x[1], x[2], particles_.volume[i], 0, 0, 0, 0};
    }
}

Eigen::Matrix3d StrainPass::gradient_by_pseudo_inverse(int i) const {
    const auto list = neighbours_.of(i);
    std::vector<Eigen::Vector3d> weights(list.size());
    corrected_weights(particles_, i, list, weights);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < list.size(); ++n) {
        const PackedParticle &j = packed_[list[n]], &own = packed_[i];
        gradient += Eigen::Vector3d(j.u - own.u, j.v - own.v, j.w - own.w) * weights[n].transpose();
    }
    return gradient;
}

Eigen::Matrix3d StrainPass::gradient_of(int i) {
    const PairSums sums(packed_[i], particles_.tensor[i], neighbours_.of(i), packed_);
    const Eigen::Matrix3d moment = sums.moment();
    const double mean = moment.trace() / 3;
    Eigen::Matrix3d inverse;
    double determinant = 0;
    bool regular = false;
    moment.computeInverseAndDetWithCheck(inverse, determinant, regular, singular * mean * mean * mean);
    if (regular && determinant > 0) return sums.displacements().lazyProduct(inverse.lazyProduct(particles_.tensor[i]).eval());
    ++fallbacks_;
    return gradient_by_pseudo_inverse(i);
}

void StrainPass::evaluate(const std::vector<Eigen::Vector3d>& displacement, Fields& fields) {
    if (displacement.size() != packed_.size()) throw std::invalid_argument("one displacement per particle");
    for (std::size_t i = 0; i < packed_.size(); ++i)
        packed_[i].u = displacement[i][0], packed_[i].v = displacement[i][1], packed_[i].w = displacement[i][2];
    fields.gradient.resize(packed_.size()), fields.strain.resize(packed_.size());
    fields.stress.resize(packed_.size()), fields.energy.resize(packed_.size());
    fallbacks_ = 0;
    for (int i = 0; i < particles_.size(); ++i) {
        const Eigen::Matrix3d g = fields.gradient[i] = gradient_of(i);
        // strain_of and strain_energy (strain.hpp), in place.
        const material::Voigt strain{g(0, 0), g(1, 1), g(2, 2), g(1, 2) + g(2, 1), g(0, 2) + g(2, 0), g(0, 1) + g(1, 0)};
        const material::Voigt stress = solid_.of(i) * strain;
        fields.strain[i] = strain;
        fields.stress[i] = stress;
        fields.energy[i] = 0.5 * particles_.volume[i] * strain.dot(stress);
    }
}

}  // namespace cleave::elasticity
