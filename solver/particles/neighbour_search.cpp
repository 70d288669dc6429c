#include "solver/particles/neighbour_search.hpp"

#include "solver/particles/smoothing_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// The baseline x86-64-v3 has AVX2 and FMA but no AES, without which Highway would take it for less.
#define HWY_DISABLE_PCLMUL_AES
#include <hwy/highway.h>

namespace cleave::particles {

namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t lanes = 8;
constexpr hn::CappedTag<float, lanes> tag;
constexpr hn::CappedTag<int, lanes> id_tag;
using Lanes = hn::Vec<hn::CappedTag<float, lanes>>;
static_assert(hn::MaxLanes(tag) == lanes, "eight floats: AVX2, the baseline");

/// More cells than this per point cost memory and gain nothing.
constexpr double cells_per_point = 8;
/// Cells are longer than wide: rows along x are few, and still end near the support.
constexpr double cells_across = 4;
/// Arrays of one query are longer than it needs by this: whole vectors are read and written.
constexpr std::size_t padding = 96;

/// Lanes that bring the ids whose bit is set to the front, for each set of eight. (Highway's own table is built anew in every call.)
struct FrontTable {
    std::uint8_t lane[256][lanes]{}, count[256]{};

    constexpr FrontTable() {
        for (unsigned bits = 0; bits < 256; ++bits)
            for (unsigned k = 0; k < lanes; ++k)
                if (bits >> k & 1u) lane[bits][count[bits]++] = static_cast<std::uint8_t>(k);
    }
};
constexpr FrontTable front;

unsigned bits_of(hn::Mask<hn::CappedTag<float, lanes>> mask) {
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, mask, bits);
    return bits[0];
}

/// For each key the number of smaller ones: n^2 comparisons, five vectors at a time, beat any sort for the sixty or so of a support.
/// Reads and writes whole blocks of five vectors.
template <class Key>
void find_ranks(const Key* keys, std::size_t count, Key* rank) {
    constexpr std::size_t width = 32 / sizeof(Key);
    const hn::CappedTag<Key, width> of_keys;
    const auto counted = [&](auto so_far, auto key, auto other) { return hn::Sub(so_far, hn::VecFromMask(of_keys, hn::Gt(key, other))); };
    for (std::size_t i = 0; i < count; i += 5 * width) {
        const auto at = [&](std::size_t k) { return hn::LoadU(of_keys, keys + i + k * width); };
        const auto a = at(0), b = at(1), c = at(2), d = at(3), e = at(4);
        auto rank_a = hn::Zero(of_keys), rank_b = rank_a, rank_c = rank_a, rank_d = rank_a, rank_e = rank_a;
        for (std::size_t k = 0; k < count; ++k) {
            const auto other = hn::Set(of_keys, keys[k]);
            rank_a = counted(rank_a, a, other), rank_b = counted(rank_b, b, other), rank_c = counted(rank_c, c, other);
            rank_d = counted(rank_d, d, other), rank_e = counted(rank_e, e, other);
        }
        const auto store = [&](auto value, std::size_t k) { hn::StoreU(value, of_keys, rank + i + k * width); };
        store(rank_a, 0), store(rank_b, 1), store(rank_c, 2), store(rank_d, 3), store(rank_e, 4);
    }
}

}  // namespace

bool is_inside(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& r) { return (tensor * r).squaredNorm() < 1; }

/// A support in single precision: |G r|^2 = r . A r, A = G G, r from the grid's origin.
struct NeighbourSearch::Query {
    Eigen::Vector3d point, box;
    const Eigen::Matrix3d& tensor;
    bool round;      ///< A is a multiple of one
    float x, y, z;   ///< of the point
    float a00 = 0, a11 = 0, a22 = 0, twice01 = 0, twice02 = 0, twice12 = 0;
    float doubtful;  ///< |G r|^2 nearer to one than this is settled by is_inside

    Query(const NeighbourSearch& of, const Eigen::Vector3d& at, const Eigen::Matrix3d& g) : point(at), tensor(g) {
        const auto narrow = [](double value) { return static_cast<float>(value); };
        const Eigen::Vector3d r = at - of.origin_;
        x = narrow(r[0]), y = narrow(r[1]), z = narrow(r[2]);
        round = g(0, 1) == 0 && g(0, 2) == 0 && g(1, 2) == 0 && g(0, 0) == g(1, 1) && g(0, 0) == g(2, 2);
        if (round) {
            box.setConstant(1 / g(0, 0));
            a00 = narrow(g(0, 0) * g(0, 0));
        } else {
            box = support_box(g);
            const Eigen::Matrix3d a = g * g;
            a00 = narrow(a(0, 0)), a11 = narrow(a(1, 1)), a22 = narrow(a(2, 2));
            twice01 = narrow(2 * a(0, 1)), twice02 = narrow(2 * a(0, 2)), twice12 = narrow(2 * a(1, 2));
        }
        // Coordinates are rounded by 2^-24 of their size, twice, which |G r| takes times |G|; the form by 2^-24 of |A| |r|^2, a few times.
        const double unit = 0x1p-24, size = g.norm();
        doubtful = narrow(unit * (16 * size * (r.cwiseAbs().maxCoeff() + box.maxCoeff()) + 16 * size * size * box.squaredNorm()));
    }
};

NeighbourSearch::NeighbourSearch(const std::vector<Eigen::Vector3d>& points, double cell)
    : points_(points), origin_(Eigen::Vector3d::Zero()) {
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    if (!points.empty()) origin_ = high = points[0];
    for (const Eigen::Vector3d& point : points) origin_ = origin_.cwiseMin(point), high = high.cwiseMax(point);
    const Eigen::Vector3d extent = high - origin_;
    edge_ = {cell / cells_across, cell, cell};
    const double limit = cells_per_point * static_cast<double>(points.size()) + 64;
    while ((extent.cwiseQuotient(edge_).array().floor() + 1).prod() > limit) edge_ *= 1.25;
    for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(std::floor(extent[axis] / edge_[axis])) + 1;

    per_edge_ = edge_.cwiseInverse();

    std::vector<std::size_t> cell_of_point(points.size());
    first_.assign(cell_index(0, 0, count_[2]) + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        cell_of_point[i] = cell_index(cell_of(points[i][0], 0), cell_of(points[i][1], 1), cell_of(points[i][2], 2));
        ++first_[cell_of_point[i] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    ids_.resize(points.size() + lanes);
    for (std::vector<float>& x : x_) x.resize(points.size() + lanes);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t at = next[cell_of_point[i]]++;
        ids_[at] = static_cast<int>(i);
        for (int axis = 0; axis < 3; ++axis) x_[axis][at] = static_cast<float>(points[i][axis] - origin_[axis]);
    }
}

int NeighbourSearch::cell_of(double coordinate, int axis) const {
    // Clamped before the conversion, which then rounds down: a support may reach far outside.
    return static_cast<int>(std::clamp((coordinate - origin_[axis]) * per_edge_[axis], 0.0, static_cast<double>(count_[axis] - 1)));
}

std::size_t NeighbourSearch::cell_index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x;
}

double NeighbourSearch::gap(double coordinate, int cell, int axis) const {
    const double low = origin_[axis] + cell * edge_[axis], margin = 1e-9 * edge_[axis];  // rounding, in the sorting of the points too
    return std::max({low - coordinate, coordinate - low - edge_[axis], margin}) - margin;
}

/// The rows of cells that the box of the support touches, x cut to what a round support reaches; fills ranges_.
void NeighbourSearch::find_rows(const Query& query) {
    const Eigen::Vector3d low = query.point - query.box, high = query.point + query.box;
    const int y0 = cell_of(low[1], 1), y1 = cell_of(high[1], 1), z0 = cell_of(low[2], 2), z1 = cell_of(high[2], 2);
    const double radius = query.box[0], centre = (query.point[0] - origin_[0]) * per_edge_[0], most = count_[0] - 1;
    ranges_.resize(static_cast<std::size_t>(y1 - y0 + 1) * static_cast<std::size_t>(z1 - z0 + 1));
    std::size_t rows = 0;
    for (int z = z0; z <= z1; ++z) {
        const double dz = query.round ? gap(query.point[2], z, 2) : 0, rest_z = radius * radius - dz * dz;
        for (int y = y0; y <= y1; ++y) {
            const double dy = query.round ? gap(query.point[1], y, 1) : 0, rest = rest_z - dy * dy;
            const double reach = (1 + 1e-9) * per_edge_[0] * std::sqrt(std::max(rest, 0.0));
            // Cells along x lie one after the other.
            const std::size_t* row = &first_[cell_index(0, y, z)];
            ranges_[rows] = {row[static_cast<int>(std::clamp(centre - reach, 0.0, most))],
                             row[static_cast<int>(std::clamp(centre + reach, 0.0, most)) + 1]};
            rows += rest > 0;  // without a branch that nobody can foretell
        }
    }
    ranges_.resize(rows);
}

/// Writes the ids of the points in the support, of those in ranges_, one after the other into found_; returns their number.
template <bool round>
std::size_t NeighbourSearch::collect(const Query& query) {
    const Lanes px = hn::Set(tag, query.x), py = hn::Set(tag, query.y), pz = hn::Set(tag, query.z);
    const Lanes a00 = hn::Set(tag, query.a00), a11 = hn::Set(tag, query.a11), a22 = hn::Set(tag, query.a22);
    const Lanes a01 = hn::Set(tag, query.twice01), a02 = hn::Set(tag, query.twice02), a12 = hn::Set(tag, query.twice12);
    const Lanes surely = hn::Set(tag, 1 - query.doubtful), hardly = hn::Set(tag, 1 + query.doubtful);
    int* end = found_.data();
    for (const auto& [first, last] : ranges_)
        for (std::size_t n = first; n < last; n += lanes) {
            const Lanes x = hn::Sub(hn::LoadU(tag, &x_[0][n]), px), y = hn::Sub(hn::LoadU(tag, &x_[1][n]), py);
            const Lanes z = hn::Sub(hn::LoadU(tag, &x_[2][n]), pz);
            const Lanes length = round ? hn::Mul(a00, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))))
                                       : hn::MulAdd(x, hn::MulAdd(a00, x, hn::MulAdd(a01, y, hn::Mul(a02, z))),
                                                    hn::MulAdd(y, hn::MulAdd(a11, y, hn::Mul(a12, z)), hn::Mul(a22, hn::Mul(z, z))));
            const unsigned maybe = bits_of(hn::Lt(length, hardly));
            unsigned in = bits_of(hn::Lt(length, surely));
            if (in != maybe) in = settle(query, n, in, maybe);
            in &= 0xffu >> (lanes - std::min(lanes, last - n));
            const auto order = hn::PromoteTo(id_tag, hn::Load(hn::CappedTag<std::uint8_t, lanes>(), front.lane[in]));
            hn::StoreU(hn::TableLookupLanes(hn::LoadU(id_tag, &ids_[n]), hn::IndicesFromVec(id_tag, order)), id_tag, end);
            end += front.count[in];
        }
    return static_cast<std::size_t>(end - found_.data());
}

/// Those of eight points that are inside, the ones whose bits differ by the definition.
unsigned NeighbourSearch::settle(const Query& query, std::size_t n, unsigned in, unsigned maybe) const {
    for (std::size_t k = 0; k < lanes; ++k)
        if ((in ^ maybe) >> k & 1u && is_inside(query.tensor, points_[ids_[n + k]] - query.point)) in |= 1u << k;
    return in;
}

/// Appends the first `count` of found_ by ascending id, without self.
void NeighbourSearch::append_sorted(std::size_t count, int self, std::vector<int>& ids) {
    if (count == 0) return;
    const std::size_t begin = ids.size();
    ids.resize(begin + count);
    int* to = ids.data() + begin;
    const auto place = [&](const auto* rank) {
        for (std::size_t i = 0; i < count; ++i) to[rank[i]] = found_[i];
    };
    int least = found_[0], most = found_[0], own = 0;  // own: where self is
    for (std::size_t i = 0; i < count; ++i) least = std::min(least, found_[i]), most = std::max(most, found_[i]), own += found_[i] < self;
    if (most - least <= std::numeric_limits<std::int16_t>::max()) {  // half the work
        for (std::size_t i = 0; i < count; ++i) short_keys_[i] = static_cast<std::int16_t>(found_[i] - least);
        find_ranks(short_keys_.data(), count, short_rank_.data());
        place(short_rank_.data());
    } else {
        find_ranks(found_.data(), count, rank_.data());
        place(rank_.data());
    }
    if (own < static_cast<int>(count) && to[own] == self) ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(begin) + own);
}

void NeighbourSearch::append(const Eigen::Vector3d& point, const Eigen::Matrix3d& tensor, int self, std::vector<int>& ids) {
    const Query query(*this, point, tensor);
    find_rows(query);
    std::size_t most = 0;
    for (const auto& [first, last] : ranges_) most += last - first;
    if (found_.size() < most + padding) {
        for (std::vector<int>* array : {&found_, &rank_}) array->resize(2 * most + padding);
        for (std::vector<std::int16_t>* array : {&short_keys_, &short_rank_}) array->resize(2 * most + padding);
    }
    append_sorted(query.round ? collect<true>(query) : collect<false>(query), self, ids);
}

}  // namespace cleave::particles
