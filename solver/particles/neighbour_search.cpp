#include "solver/particles/neighbour_search.hpp"

#include "solver/particles/smoothing_tensor.hpp"

#include <algorithm>
#include <cmath>
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

/// Ids by ascending value from `ids` to `sorted`, without `self`. The place of an id is the number of smaller ones: n^2 comparisons, eight
/// at a time, beat any sort for the sixty or so of a support.
void sort_small(const int* ids, std::size_t count, int self, int* rank, std::vector<int>& sorted) {
    for (std::size_t i = 0; i < count; i += 16) {
        const auto a = hn::LoadU(id_tag, ids + i), b = hn::LoadU(id_tag, ids + i + 8);
        auto rank_a = hn::Zero(id_tag), rank_b = rank_a;
        for (std::size_t k = 0; k < count; ++k) {
            const auto other = hn::Set(id_tag, ids[k]);
            rank_a = hn::Sub(rank_a, hn::VecFromMask(id_tag, hn::Gt(a, other)));
            rank_b = hn::Sub(rank_b, hn::VecFromMask(id_tag, hn::Gt(b, other)));
        }
        hn::StoreU(rank_a, id_tag, rank + i), hn::StoreU(rank_b, id_tag, rank + i + 8);
    }
    const std::size_t begin = sorted.size();
    sorted.resize(begin + count);
    int* to = sorted.data() + begin;
    for (std::size_t i = 0; i < count; ++i) to[rank[i]] = ids[i];
    if (self < 0) return;
    const auto at = std::lower_bound(sorted.begin() + static_cast<std::ptrdiff_t>(begin), sorted.end(), self);
    if (at != sorted.end() && *at == self) sorted.erase(at);
}

}  // namespace

bool is_inside(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& r) { return (tensor * r).squaredNorm() < 1; }

/// A support in single precision: |G r|^2 = r . A r, A = G G, r from the grid's origin.
struct NeighbourSearch::Query {
    Eigen::Vector3d point, box;
    const Eigen::Matrix3d& tensor;
    bool round;      ///< A is a multiple of one
    float x, y, z;   ///< of the point
    float a00, a11, a22, twice01, twice02, twice12;
    float doubtful;  ///< |G r|^2 nearer to one than this is settled by is_inside

    Query(const NeighbourSearch& of, const Eigen::Vector3d& at, const Eigen::Matrix3d& g) : point(at), tensor(g) {
        const auto narrow = [](double value) { return static_cast<float>(value); };
        const Eigen::Vector3d r = at - of.origin_;
        x = narrow(r[0]), y = narrow(r[1]), z = narrow(r[2]);
        const Eigen::Matrix3d a = g * g;
        a00 = narrow(a(0, 0)), a11 = narrow(a(1, 1)), a22 = narrow(a(2, 2));
        twice01 = narrow(2 * a(0, 1)), twice02 = narrow(2 * a(0, 2)), twice12 = narrow(2 * a(1, 2));
        round = g(0, 1) == 0 && g(0, 2) == 0 && g(1, 2) == 0 && g(0, 0) == g(1, 1) && g(0, 0) == g(2, 2);
        box = round ? Eigen::Vector3d::Constant(1 / g(0, 0)) : support_box(g);
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
    // Clamped before the conversion: a support may reach far outside.
    return static_cast<int>(std::clamp(std::floor((coordinate - origin_[axis]) / edge_[axis]), 0.0, static_cast<double>(count_[axis] - 1)));
}

std::size_t NeighbourSearch::cell_index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * count_[1] + y) * count_[0] + x;
}

double NeighbourSearch::gap(double coordinate, int cell, int axis) const {
    const double low = origin_[axis] + cell * edge_[axis], margin = 1e-9 * edge_[axis];  // rounding, in the sorting of the points too
    return std::max({low - coordinate, coordinate - low - edge_[axis], margin}) - margin;
}

/// Writes the ids of the points inside, of those from first to last of the arrays, and returns the new end. Up to a vector too far.
int* NeighbourSearch::collect(const Query& query, std::size_t first, std::size_t last, int* end) const {
    const Lanes px = hn::Set(tag, query.x), py = hn::Set(tag, query.y), pz = hn::Set(tag, query.z);
    const Lanes a00 = hn::Set(tag, query.a00), a11 = hn::Set(tag, query.a11), a22 = hn::Set(tag, query.a22);
    const Lanes a01 = hn::Set(tag, query.twice01), a02 = hn::Set(tag, query.twice02), a12 = hn::Set(tag, query.twice12);
    const Lanes surely = hn::Set(tag, 1 - query.doubtful), hardly = hn::Set(tag, 1 + query.doubtful);
    for (std::size_t n = first; n < last; n += lanes) {
        const Lanes x = hn::Sub(hn::LoadU(tag, &x_[0][n]), px), y = hn::Sub(hn::LoadU(tag, &x_[1][n]), py);
        const Lanes z = hn::Sub(hn::LoadU(tag, &x_[2][n]), pz);
        const Lanes length =
            query.round ? hn::Mul(a00, hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z))))
                        : hn::MulAdd(x, hn::MulAdd(a00, x, hn::MulAdd(a01, y, hn::Mul(a02, z))),
                                     hn::MulAdd(y, hn::MulAdd(a11, y, hn::Mul(a12, z)), hn::Mul(a22, hn::Mul(z, z))));
        const unsigned maybe = bits_of(hn::Lt(length, hardly));
        unsigned in = bits_of(hn::Lt(length, surely));
        if (in != maybe) in = settle(query, n, in, maybe);
        if (last - n < lanes) in &= (1u << (last - n)) - 1;
        const auto order = hn::PromoteTo(id_tag, hn::Load(hn::CappedTag<std::uint8_t, lanes>(), front.lane[in]));
        hn::StoreU(hn::TableLookupLanes(hn::LoadU(id_tag, &ids_[n]), hn::IndicesFromVec(id_tag, order)), id_tag, end);
        end += front.count[in];
    }
    return end;
}

/// Those of eight points that are inside, the ones whose bits differ by the definition.
unsigned NeighbourSearch::settle(const Query& query, std::size_t n, unsigned in, unsigned maybe) const {
    for (std::size_t k = 0; k < lanes; ++k)
        if ((in ^ maybe) >> k & 1u && is_inside(query.tensor, points_[ids_[n + k]] - query.point)) in |= 1u << k;
    return in;
}

void NeighbourSearch::append(const Eigen::Vector3d& point, const Eigen::Matrix3d& tensor, int self, std::vector<int>& ids) {
    const Query query(*this, point, tensor);
    const Eigen::Vector3d low = point - query.box, high = point + query.box;
    const int y0 = cell_of(low[1], 1), y1 = cell_of(high[1], 1), z1 = cell_of(high[2], 2);
    double reach = query.box[0];
    std::size_t count = 0;
    for (int z = cell_of(low[2], 2); z <= z1; ++z)
        for (int y = y0; y <= y1; ++y) {
            if (query.round) {  // the part of the row that the sphere reaches
                const double dy = gap(point[1], y, 1), dz = gap(point[2], z, 2), rest = query.box[0] * query.box[0] - dy * dy - dz * dz;
                if (rest <= 0) continue;
                reach = (1 + 1e-9) * std::sqrt(rest);
            }
            // Cells along x lie one after the other.
            const std::size_t first = first_[cell_index(cell_of(point[0] - reach, 0), y, z)];
            const std::size_t last = first_[cell_index(cell_of(point[0] + reach, 0), y, z) + 1];
            if (found_.size() < count + (last - first) + 2 * lanes) {
                found_.resize(2 * (count + (last - first)) + 2 * lanes);
                rank_.resize(found_.size());
            }
            count = static_cast<std::size_t>(collect(query, first, last, found_.data() + count) - found_.data());
        }
    sort_small(found_.data(), count, self, rank_.data(), ids);
}

}  // namespace cleave::particles
