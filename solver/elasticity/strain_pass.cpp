#include "solver/elasticity/strain_pass.hpp"

#include "solver/elasticity/operators.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
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

/// The same of four pairs of two halves, lower and upper.
Four columns_of(const double* a, const double* b, const double* c, const double* d) {
    const hn::CappedTag<double, 2> half;
    const auto joined = [&](const double* low, const double* high) { return hn::Combine(tag, hn::Load(half, high), hn::Load(half, low)); };
    const Lanes ac = joined(a, c), bd = joined(b, d), ac_upper = joined(a + 2, c + 2), bd_upper = joined(b + 2, d + 2);
    return {hn::InterleaveLower(tag, ac, bd), hn::InterleaveUpper(tag, ac, bd), hn::InterleaveLower(tag, ac_upper, bd_upper),
            hn::InterleaveUpper(tag, ac_upper, bd_upper)};
}

constexpr std::size_t sums_of_s = 6, sums_of_b = 9, all_sums = sums_of_s + sums_of_b;

/// The sums of four particles, S as 00, 01, 02, 11, 12, 22 and B by rows, each in four parts: [sum][particle][lane].
struct alignas(32) PartialSums {
    double part[all_sums][4][4];

    /// One sum, lane by particle.
    Lanes total(std::size_t sum) const {
        const auto of = [&](int particle) { return hn::Load(tag, part[sum][particle]); };
        const Four columns = transposed(of(0), of(1), of(2), of(3));
        return hn::Add(hn::Add(columns.a, columns.b), hn::Add(columns.c, columns.d));
    }
};

/// Sums over the pairs of one particle. Two loops over blocks of pairs, since one would need more registers than the baseline has.
class PairLoop {
public:
    PairLoop(const PackedParticle& own, const SupportForm& form, const std::vector<PackedParticle>& packed)
        : own_(own), form_(form), packed_(packed.data()) {}

    /// A multiple of four pairs.
    void sum(std::span<const int> list, int particle, PartialSums& to) {
        Lanes s[sums_of_s], b[sums_of_b];
        for (Lanes& zero : s) zero = hn::Zero(tag);
        for (Lanes& zero : b) zero = hn::Zero(tag);
        for (std::size_t first = 0; first < list.size(); first += block) {
            const auto part = list.subspan(first, std::min(block, list.size() - first));
            add_moments(part, s);
            add_displacements(part, b);
        }
        for (std::size_t k = 0; k < sums_of_s; ++k) hn::Store(s[k], tag, to.part[k][particle]);
        for (std::size_t k = 0; k < sums_of_b; ++k) hn::Store(b[k], tag, to.part[sums_of_s + k][particle]);
    }

private:
    static constexpr std::size_t block = 128;

    /// S, and w r of every pair of the block.
    void add_moments(std::span<const int> list, Lanes* s) {
        const Lanes x = hn::Set(tag, own_.x), y = hn::Set(tag, own_.y), z = hn::Set(tag, own_.z);
        const Lanes a00 = hn::Set(tag, form_.a00), a01 = hn::Set(tag, form_.twice01), a02 = hn::Set(tag, form_.twice02);
        const Lanes a11 = hn::Set(tag, form_.a11), a12 = hn::Set(tag, form_.twice12), a22 = hn::Set(tag, form_.a22);
        const Lanes zero = hn::Zero(tag), one = hn::Set(tag, 1.0), least = hn::Set(tag, 1e-300);
        Lanes s00 = s[0], s01 = s[1], s02 = s[2], s11 = s[3], s12 = s[4], s22 = s[5];
        const PackedParticle* const packed = packed_;
        const int* const j = list.data();
        for (std::size_t n = 0, count = list.size(); n < count; n += 4) {
            const Four at = columns_of(&packed[j[n]].x, &packed[j[n + 1]].x, &packed[j[n + 2]].x, &packed[j[n + 3]].x);
            const Lanes rx = hn::Sub(at.a, x), ry = hn::Sub(at.b, y), rz = hn::Sub(at.c, z);
            const Lanes form = hn::MulAdd(rx, hn::MulAdd(a00, rx, hn::MulAdd(a01, ry, hn::Mul(a02, rz))),
                                          hn::MulAdd(ry, hn::MulAdd(a11, ry, hn::Mul(a12, rz)), hn::Mul(a22, hn::Mul(rz, rz))));
            // Root and reciprocal side by side: 1 / q = q (1 / q^2) is there sooner than a quotient that waits for the root.
            const Lanes square = hn::Max(form, least), q = hn::Sqrt(square), per_square = hn::Div(one, square);
            const Lanes rest = hn::Max(hn::Sub(one, q), zero);
            const Lanes w = hn::Mul(hn::Mul(at.d, hn::Mul(q, per_square)), hn::Mul(rest, rest));
            const Lanes w0 = hn::Mul(w, rx), w1 = hn::Mul(w, ry), w2 = hn::Mul(w, rz);
            hn::Store(w0, tag, weighted_[0] + n), hn::Store(w1, tag, weighted_[1] + n), hn::Store(w2, tag, weighted_[2] + n);
            s00 = hn::MulAdd(w0, rx, s00), s01 = hn::MulAdd(w0, ry, s01), s02 = hn::MulAdd(w0, rz, s02);
            s11 = hn::MulAdd(w1, ry, s11), s12 = hn::MulAdd(w1, rz, s12), s22 = hn::MulAdd(w2, rz, s22);
        }
        s[0] = s00, s[1] = s01, s[2] = s02, s[3] = s11, s[4] = s12, s[5] = s22;
    }

    /// B.
    void add_displacements(std::span<const int> list, Lanes* b) const {
        const Lanes u = hn::Set(tag, own_.u), v = hn::Set(tag, own_.v), w = hn::Set(tag, own_.w);
        Lanes b00 = b[0], b01 = b[1], b02 = b[2], b10 = b[3], b11 = b[4], b12 = b[5], b20 = b[6], b21 = b[7], b22 = b[8];
        const PackedParticle* const packed = packed_;
        const int* const j = list.data();
        for (std::size_t n = 0, count = list.size(); n < count; n += 4) {
            const Four at = columns_of(&packed[j[n]].u, &packed[j[n + 1]].u, &packed[j[n + 2]].u, &packed[j[n + 3]].u);
            const Lanes du = hn::Sub(at.a, u), dv = hn::Sub(at.b, v), dw = hn::Sub(at.c, w);
            const Lanes w0 = hn::Load(tag, weighted_[0] + n), w1 = hn::Load(tag, weighted_[1] + n), w2 = hn::Load(tag, weighted_[2] + n);
            b00 = hn::MulAdd(du, w0, b00), b01 = hn::MulAdd(du, w1, b01), b02 = hn::MulAdd(du, w2, b02);
            b10 = hn::MulAdd(dv, w0, b10), b11 = hn::MulAdd(dv, w1, b11), b12 = hn::MulAdd(dv, w2, b12);
            b20 = hn::MulAdd(dw, w0, b20), b21 = hn::MulAdd(dw, w1, b21), b22 = hn::MulAdd(dw, w2, b22);
        }
        b[0] = b00, b[1] = b01, b[2] = b02, b[3] = b10, b[4] = b11, b[5] = b12, b[6] = b20, b[7] = b21, b[8] = b22;
    }

    const PackedParticle& own_;
    const SupportForm& form_;
    const PackedParticle* packed_;
    alignas(32) double weighted_[3][block];
};

/// Gradients of four particles, by columns, and which of them have an S that can be inverted.
struct Gradients {
    Lanes value[9];
    bool regular[4];

    Gradients(const PartialSums& sums, const std::array<const SupportForm*, 4>& forms) {
        const Lanes s00 = sums.total(0), s01 = sums.total(1), s02 = sums.total(2), s11 = sums.total(3), s12 = sums.total(4), s22 = sums.total(5);
        const auto minor = [](Lanes a, Lanes b, Lanes c, Lanes d) { return hn::NegMulAdd(c, d, hn::Mul(a, b)); };
        const Lanes c00 = minor(s11, s22, s12, s12), c01 = minor(s02, s12, s01, s22), c02 = minor(s01, s12, s02, s11);
        const Lanes c11 = minor(s00, s22, s02, s02), c12 = minor(s01, s02, s00, s12), c22 = minor(s00, s11, s01, s01);
        const Lanes determinant = hn::MulAdd(s00, c00, hn::MulAdd(s01, c01, hn::Mul(s02, c02)));
        const Lanes inverse = hn::Div(hn::Set(tag, 1.0), determinant);
        const Lanes minors[3][3] = {{c00, c01, c02}, {c01, c11, c12}, {c02, c12, c22}};
        for (std::size_t a = 0; a < 3; ++a) {
            const Lanes b0 = sums.total(sums_of_s + 3 * a), b1 = sums.total(sums_of_s + 3 * a + 1), b2 = sums.total(sums_of_s + 3 * a + 2);
            for (std::size_t b = 0; b < 3; ++b)
                value[3 * b + a] = hn::Mul(inverse, hn::MulAdd(b0, minors[0][b], hn::MulAdd(b1, minors[1][b], hn::Mul(b2, minors[2][b]))));
        }
        find_regular({s00, s01, s02, s11, s12, s22}, determinant, forms);
    }

    void replace(int particle, const Eigen::Matrix3d& gradient) {
        for (int k = 0; k < 9; ++k) {
            alignas(32) double lane[4];
            hn::Store(value[k], tag, lane);
            lane[particle] = gradient.data()[k];
            value[k] = hn::Load(tag, lane);
        }
    }

private:
    /// det(G S G) against (tr(G S G) / 3)^3: how alike the neighbours lie all round, in the support's own measure.
    void find_regular(const std::array<Lanes, 6>& s, Lanes determinant, const std::array<const SupportForm*, 4>& forms) {
        const auto of = [&](double SupportForm::*part) {
            alignas(32) const double values[4] = {forms[0]->*part, forms[1]->*part, forms[2]->*part, forms[3]->*part};
            return hn::Load(tag, values);
        };
        constexpr std::array parts{&SupportForm::a00, &SupportForm::twice01, &SupportForm::twice02, &SupportForm::a11, &SupportForm::twice12,
                                   &SupportForm::a22};
        Lanes trace = hn::Zero(tag);  // of A S
        for (std::size_t k = 0; k < sums_of_s; ++k) trace = hn::MulAdd(of(parts[k]), s[k], trace);
        const Lanes mean = hn::Mul(trace, hn::Set(tag, 1.0 / 3));
        const Lanes least = hn::Mul(hn::Mul(hn::Set(tag, singular), mean), hn::Mul(mean, mean));
        alignas(32) double margin[4];
        hn::Store(hn::Sub(hn::Mul(determinant, of(&SupportForm::determinant)), least), tag, margin);
        for (int p = 0; p < 4; ++p) regular[p] = margin[p] > 0;
    }
};

/// Writes `count` >= 4 values, lane by particle, to four arrays.
void store_by_particle(const Lanes* value, std::size_t count, const std::array<double*, 4>& to) {
    for (std::size_t k = 0;; k = std::min(k + 4, count - 4)) {  // the last four where fewer are left: some are written twice
        const Four rows = transposed(value[k], value[k + 1], value[k + 2], value[k + 3]);
        hn::StoreU(rows.a, tag, to[0] + k), hn::StoreU(rows.b, tag, to[1] + k);
        hn::StoreU(rows.c, tag, to[2] + k), hn::StoreU(rows.d, tag, to[3] + k);
        if (k + 4 == count) return;
    }
}

/// Strain, stress and energy of four particles from their gradients: strain_of and strain_energy (strain.hpp).
void append_fields(const Lanes* g, const std::array<const material::Stiffness*, 4>& stiffness, const std::array<std::size_t, 4>& id,
                   const std::vector<double>& volume, Fields& fields) {
    const Lanes strain[6] = {g[0], g[4], g[8], hn::Add(g[7], g[5]), hn::Add(g[6], g[2]), hn::Add(g[3], g[1])};
    const bool alike = stiffness[0] == stiffness[1] && stiffness[0] == stiffness[2] && stiffness[0] == stiffness[3];
    const auto c = [&](int a, int b) {
        if (alike) return hn::Set(tag, (*stiffness[0])(a, b));
        alignas(32) const double values[4] = {(*stiffness[0])(a, b), (*stiffness[1])(a, b), (*stiffness[2])(a, b), (*stiffness[3])(a, b)};
        return hn::Load(tag, values);
    };
    Lanes stress[6], density = hn::Zero(tag);
    for (int a = 0; a < 6; ++a) {
        stress[a] = hn::Mul(c(a, 0), strain[0]);
        for (int b = 1; b < 6; ++b) stress[a] = hn::MulAdd(c(a, b), strain[b], stress[a]);
        density = hn::MulAdd(stress[a], strain[a], density);
    }
    const auto data = [&](auto& values) {
        return std::array<double*, 4>{values[id[0]].data(), values[id[1]].data(), values[id[2]].data(), values[id[3]].data()};
    };
    store_by_particle(g, 9, data(fields.gradient));
    store_by_particle(strain, 6, data(fields.strain));
    store_by_particle(stress, 6, data(fields.stress));
    alignas(32) double densities[4];
    hn::Store(density, tag, densities);
    for (std::size_t p = 0; p < 4; ++p) fields.energy[id[p]] = 0.5 * volume[id[p]] * densities[p];
}

}  // namespace

StrainPass::StrainPass(const particles::Particles& particles, const particles::NeighbourLists& neighbours, Solid solid)
    : particles_(particles), solid_(std::move(solid)), packed_(particles.position.size()) {
    if (neighbours.size() != particles_.size() || solid_.material.size() != packed_.size())
        throw std::invalid_argument("one list and one material per particle");
    lists_.offset.reserve(packed_.size() + 1), lists_.index.reserve(neighbours.index.size() + 2 * packed_.size());
    lists_.offset.push_back(0);
    for (int i = 0; i < particles_.size(); ++i) {
        const Eigen::Vector3d& x = particles_.position[i];
        packed_[i] = {x[0], x[1], x[2], particles_.volume[i], 0, 0, 0, 0};
        const Eigen::Matrix3d a = particles_.tensor[i] * particles_.tensor[i];
        forms_.push_back({a(0, 0), 2 * a(0, 1), 2 * a(0, 2), a(1, 1), 2 * a(1, 2), a(2, 2), a.determinant()});
        const auto list = neighbours.of(i);
        lists_.index.insert(lists_.index.end(), list.begin(), list.end());
        while (lists_.index.size() % 4 != 0) lists_.index.push_back(i);
        lists_.offset.push_back(lists_.index.size());
    }
}

Eigen::Matrix3d StrainPass::gradient_by_pseudo_inverse(int i) const {
    const auto list = lists_.of(i);
    std::vector<Eigen::Vector3d> weights(list.size());
    corrected_weights(particles_, i, list, weights);
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < list.size(); ++n) {
        const PackedParticle &j = packed_[list[n]], &own = packed_[i];
        gradient += Eigen::Vector3d(j.u - own.u, j.v - own.v, j.w - own.w) * weights[n].transpose();
    }
    return gradient;
}

void StrainPass::evaluate_four(const std::array<std::size_t, 4>& id, Fields& fields) {
    PartialSums sums;
    std::array<const SupportForm*, 4> forms;
    std::array<const material::Stiffness*, 4> stiffness;
    for (int p = 0; p < 4; ++p) {
        forms[p] = &forms_[id[p]], stiffness[p] = &solid_.of(static_cast<int>(id[p]));
        PairLoop(packed_[id[p]], *forms[p], packed_).sum(lists_.of(static_cast<int>(id[p])), p, sums);
    }
    Gradients gradients(sums, forms);
    for (int p = 0; p < 4; ++p) {
        if (gradients.regular[p]) continue;
        if (p == 0 || id[p] != id[p - 1]) ++fallbacks_;
        const Eigen::Matrix3d mended = gradient_by_pseudo_inverse(static_cast<int>(id[p]));
        gradients.replace(p, mended);
    }
    append_fields(gradients.value, stiffness, id, particles_.volume, fields);
}

void StrainPass::evaluate(const std::vector<Eigen::Vector3d>& displacement, Fields& fields) {
    if (displacement.size() != packed_.size()) throw std::invalid_argument("one displacement per particle");
    const std::size_t count = packed_.size();
    for (std::size_t i = 0; i < count; ++i)
        packed_[i].u = displacement[i][0], packed_[i].v = displacement[i][1], packed_[i].w = displacement[i][2];
    fields.gradient.resize(count), fields.strain.resize(count), fields.stress.resize(count), fields.energy.resize(count);
    fallbacks_ = 0;
    for (std::size_t i = 0; i < count; i += 4) {
        const auto or_last = [&](std::size_t id) { return std::min(id, count - 1); };
        evaluate_four({i, or_last(i + 1), or_last(i + 2), or_last(i + 3)}, fields);
    }
}

}  // namespace cleave::elasticity
