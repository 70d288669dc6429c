#include "solver/particles/neighbour_search.hpp"

#include "solver/particles/smoothing_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
using IdLanes = hn::Vec<hn::CappedTag<int, lanes>>;
static_assert(hn::MaxLanes(tag) == lanes, "eight floats: AVX2, the baseline");

/// So few particles are not halved again: a box of a dozen is about as wide as a support, and smaller ones gain less than they cost.
constexpr std::size_t few = 16;
constexpr std::size_t doubt = std::numeric_limits<std::size_t>::max();

/// Lanes that bring those whose bit is set to the front, for each set of eight. (Highway's own table is built anew in every call.)
struct FrontTable {
    std::uint8_t lane[256][lanes]{}, count[256]{};

    constexpr FrontTable() {
        for (unsigned bits = 0; bits < 256; ++bits)
            for (unsigned k = 0; k < lanes; ++k)
                if (bits >> k & 1u) lane[bits][count[bits]++] = static_cast<std::uint8_t>(k);
    }
};
constexpr FrontTable front;

/// Stores the lanes whose bit is set one after the other; writes whole vectors.
class Front {
public:
    explicit Front(std::size_t bits)
        : order_(hn::IndicesFromVec(id_tag, hn::PromoteTo(id_tag, hn::Load(hn::CappedTag<std::uint8_t, lanes>(), front.lane[bits])))) {}
    void store(Lanes value, float* to) const { hn::StoreU(hn::BitCast(tag, hn::TableLookupLanes(hn::BitCast(id_tag, value), order_)), tag, to); }
    void store(IdLanes value, int* to) const { hn::StoreU(hn::TableLookupLanes(value, order_), id_tag, to); }

private:
    decltype(hn::IndicesFromVec(id_tag, hn::Zero(id_tag))) order_;
};

template <class Mask>
std::size_t bits_of(Mask mask) {
    std::uint8_t bits[8];
    hn::StoreMaskBits(tag, mask, bits);
    return bits[0];
}

/// The first `rest` of eight bits, all where there are more.
std::size_t first_bits(std::size_t rest) { return 0xffu >> (lanes - std::min(lanes, rest)); }

float rounded_up(double value) { return static_cast<float>((1 + 0x1p-22) * value); }

/// G is a multiple of one.
bool is_round(const Eigen::Matrix3d& g) {
    return g(0, 1) == 0 && g(0, 2) == 0 && g(1, 2) == 0 && g(0, 0) == g(1, 1) && g(0, 0) == g(2, 2);
}

}  // namespace

bool is_inside(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& r) { return (tensor * r).squaredNorm() < 1; }

template <std::size_t columns>
void NeighbourSearch::Table<columns>::make_room(std::size_t rows) {
    const std::size_t whole = rows + 2 * lanes;
    if (id.size() >= whole) return;
    for (std::vector<float>& values : column) values.resize(whole);
    id.resize(whole);
}

/// Rows beyond the last have no finite x: in no box, and in no support.
template <std::size_t columns>
void NeighbourSearch::Table<columns>::close() {
    hn::StoreU(hn::Inf(tag), tag, &column[0][count]);
}

/// The rows of `from` whose bit `wanted(n)` sets, n the first of eight, in their order. Bits beyond the last row must not be set.
template <std::size_t columns, class Wanted>
void NeighbourSearch::filter(const Table<columns>& from, Table<columns>& to, const Wanted& wanted) {
    to.make_room(from.count);
    // Pointers of our own, which no store of a float can have changed.
    std::array<const float*, columns> source;
    std::array<float*, columns> target;
    for (std::size_t k = 0; k < columns; ++k) source[k] = from.column[k].data(), target[k] = to.column[k].data();
    const int* const source_id = from.id.data();
    int* const target_id = to.id.data();
    std::size_t end = 0;
    for (std::size_t n = 0, count = from.count; n < count; n += lanes) {
        const std::size_t in = wanted(n);
        const Front chosen(in);
        for (std::size_t k = 0; k < columns; ++k) chosen.store(hn::LoadU(tag, source[k] + n), target[k] + end);
        chosen.store(hn::LoadU(id_tag, source_id + n), target_id + end);
        end += front.count[in];
    }
    to.count = end;
    to.close();
}

/// Smallest and largest coordinates.
struct NeighbourSearch::Box {
    std::array<float, 3> low, high;

    /// Around the places of queries (a = 0), or around their supports (a = 1).
    Box(const Queries& queries, float a) {
        const Lanes scale = hn::Set(tag, a), most = hn::Set(tag, std::numeric_limits<float>::max());
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Lanes least = most, largest = hn::Neg(most);
            for (std::size_t n = 0; n < queries.count; n += lanes) {
                // Eight from the end where fewer are left: some are read twice.
                const std::size_t at = queries.count < lanes ? 0 : std::min(n, queries.count - lanes);
                const auto counts = hn::FirstN(tag, std::min(lanes, queries.count));
                const Lanes x = hn::LoadU(tag, &queries.column[axis][at]), half = hn::Mul(scale, hn::LoadU(tag, &queries.column[axis + 3][at]));
                least = hn::Min(least, hn::IfThenElse(counts, hn::Sub(x, half), most));
                largest = hn::Max(largest, hn::IfThenElse(counts, hn::Add(x, half), hn::Neg(most)));
            }
            low[axis] = hn::GetLane(hn::MinOfLanes(tag, least)), high[axis] = hn::GetLane(hn::MaxOfLanes(tag, largest));
        }
    }
    std::size_t longest_axis() const {
        std::size_t longest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
        return longest;
    }
};

/// A support in single precision: |G r|^2 = r . A r, A = G G.
struct NeighbourSearch::Support {
    const Eigen::Vector3d& point;
    const Eigen::Matrix3d& tensor;
    bool round;
    float x, y, z;   ///< of the point, from the origin
    float a00 = 0, a11 = 0, a22 = 0, twice01 = 0, twice02 = 0, twice12 = 0;
    float doubtful;  ///< |G r|^2 nearer to one than this is settled by is_inside

    Support(const Particles& particles, const Queries& queries, std::size_t n)
        : point(particles.position[queries.id[n]]), tensor(particles.tensor[queries.id[n]]), x(queries.column[0][n]), y(queries.column[1][n]),
          z(queries.column[2][n]) {
        const auto narrow = [](double value) { return static_cast<float>(value); };
        const Eigen::Matrix3d& g = tensor;
        round = is_round(g);
        if (round) {
            a00 = narrow(g(0, 0) * g(0, 0));
        } else {
            const Eigen::Matrix3d a = g * g;
            a00 = narrow(a(0, 0)), a11 = narrow(a(1, 1)), a22 = narrow(a(2, 2));
            twice01 = narrow(2 * a(0, 1)), twice02 = narrow(2 * a(0, 2)), twice12 = narrow(2 * a(1, 2));
        }
        // Coordinates are rounded by 2^-24 of their size, twice, which |G r| takes times |G|; the form by 2^-24 of |A| |r|^2, a few times.
        const double unit = 0x1p-24, size = g.norm(), reach = std::max({queries.column[3][n], queries.column[4][n], queries.column[5][n]});
        doubtful = narrow(unit * 16 * size * (std::max({std::abs(x), std::abs(y), std::abs(z)}) + reach + 3 * size * reach * reach));
    }
};

NeighbourSearch::NeighbourSearch(const Particles& particles) : particles_(particles), origin_(Eigen::Vector3d::Zero()) {
    const std::vector<Eigen::Vector3d>& points = particles.position;
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    if (!points.empty()) origin_ = high = points[0];
    for (const Eigen::Vector3d& point : points) origin_ = origin_.cwiseMin(point), high = high.cwiseMax(point);
    const double extent = points.empty() ? 0 : (high - origin_).maxCoeff();
    first_.resize(points.size()), length_.resize(points.size());
    all_.make_room(points.size()), everywhere_.make_room(points.size());
    all_.count = everywhere_.count = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Matrix3d& g = particles.tensor[i];
        const Eigen::Vector3d box = is_round(g) ? Eigen::Vector3d(Eigen::Vector3d::Constant(1 / g(0, 0))) : support_box(g);
        all_.id[i] = everywhere_.id[i] = static_cast<int>(i);
        for (int axis = 0; axis < 3; ++axis) {
            all_.column[axis][i] = everywhere_.column[axis][i] = static_cast<float>(points[i][axis] - origin_[axis]);
            // Two coordinates and their difference are rounded by 2^-24 of their size each.
            all_.column[axis + 3][i] = rounded_up(box[axis] + 8 * 0x1p-24 * (extent + box[axis]));
        }
    }
    all_.close(), everywhere_.close();
}

void NeighbourSearch::divide(const Queries& queries, const Points& near, std::size_t depth) {
    if (queries.count == 0) return;
    if (queries.count <= few) return search(queries, near);
    const Box places(queries, 0);
    const std::size_t axis = places.longest_axis();
    const Lanes middle = hn::Set(tag, places.low[axis] + 0.5f * (places.high[axis] - places.low[axis]));
    if (depth == levels_.size()) levels_.push_back(std::make_unique<Level>());
    Level& level = *levels_[depth];
    const float* const place = queries.column[axis].data();
    const std::size_t count = queries.count;
    const auto is_low = [=](std::size_t n) { return bits_of(hn::Lt(hn::LoadU(tag, place + n), middle)); };
    filter(queries, level.low, [=](std::size_t n) { return is_low(n) & first_bits(count - n); });
    filter(queries, level.high, [=](std::size_t n) { return ~is_low(n) & first_bits(count - n); });
    if (level.low.count == 0) return search(queries, near);  // all at one place
    for (const Queries* half : {&level.low, &level.high}) {
        const Box box(*half, 1);
        const auto bound = [&](float value) { return hn::Set(tag, value); };
        const Lanes x0 = bound(box.low[0]), y0 = bound(box.low[1]), z0 = bound(box.low[2]);
        const Lanes x1 = bound(box.high[0]), y1 = bound(box.high[1]), z1 = bound(box.high[2]);
        const float *xs = near.column[0].data(), *ys = near.column[1].data(), *zs = near.column[2].data();
        filter(near, level.near, [=](std::size_t n) {
            const Lanes x = hn::LoadU(tag, xs + n), y = hn::LoadU(tag, ys + n), z = hn::LoadU(tag, zs + n);
            const auto above = hn::And(hn::And(hn::Ge(x, x0), hn::Ge(y, y0)), hn::Ge(z, z0));
            return bits_of(hn::And(above, hn::And(hn::And(hn::Le(x, x1), hn::Le(y, y1)), hn::Le(z, z1))));
        });
        divide(*half, level.near, depth + 1);
    }
}

void NeighbourSearch::search(const Queries& queries, const Points& near) {
    for (std::size_t n = 0; n < queries.count; ++n) {
        const Support support(particles_, queries, n);
        make_room_for(near.count + lanes);
        int* to = found_.get() + end_;
        const int i = queries.id[n];
        first_[i] = end_;
        end_ += length_[i] = support.round ? collect_surely<true>(support, near, to) : collect_surely<false>(support, near, to);
    }
}

/// Writes the ids of the points in the support one after the other; returns their number. Unless it settles doubtful points itself it
/// returns `doubt` where there is one.
template <bool round, bool settles>
std::size_t NeighbourSearch::collect(const Support& support, const Points& near, int* to) const {
    const Lanes px = hn::Set(tag, support.x), py = hn::Set(tag, support.y), pz = hn::Set(tag, support.z);
    // A round support compares r^2 with h^2, any other r . A r with one.
    const float one = round ? 1 / support.a00 : 1;
    const Lanes a00 = hn::Set(tag, support.a00), a11 = hn::Set(tag, support.a11), a22 = hn::Set(tag, support.a22);
    const Lanes a01 = hn::Set(tag, support.twice01), a02 = hn::Set(tag, support.twice02), a12 = hn::Set(tag, support.twice12);
    const Lanes surely = hn::Set(tag, one * (1 - support.doubtful)), hardly = hn::Set(tag, one * (1 + support.doubtful));
    const float *xs = near.column[0].data(), *ys = near.column[1].data(), *zs = near.column[2].data();
    const int* const ids = near.id.data();
    std::size_t end = 0;
    IdLanes maybe_inside = hn::Zero(id_tag);  // minus the number
    for (std::size_t n = 0, count = near.count; n < count; n += lanes) {
        const Lanes x = hn::Sub(hn::LoadU(tag, xs + n), px), y = hn::Sub(hn::LoadU(tag, ys + n), py), z = hn::Sub(hn::LoadU(tag, zs + n), pz);
        const Lanes length = round ? hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)))
                                   : hn::MulAdd(x, hn::MulAdd(a00, x, hn::MulAdd(a01, y, hn::Mul(a02, z))),
                                                hn::MulAdd(y, hn::MulAdd(a11, y, hn::Mul(a12, z)), hn::Mul(a22, hn::Mul(z, z))));
        const auto maybe = hn::Lt(length, hardly);
        std::size_t in = bits_of(hn::Lt(length, surely));
        if (settles) {
            if (in != bits_of(maybe)) in = settle(support, near, n, in, bits_of(maybe));
        } else {
            maybe_inside = hn::Add(maybe_inside, hn::BitCast(id_tag, hn::VecFromMask(tag, maybe)));
        }
        Front(in).store(hn::LoadU(id_tag, ids + n), to + end);
        end += front.count[in];
    }
    if (!settles && hn::GetLane(hn::SumOfLanes(id_tag, maybe_inside)) + static_cast<int>(end) != 0) return doubt;
    return end;
}

template <bool round>
std::size_t NeighbourSearch::collect_surely(const Support& support, const Points& near, int* to) const {
    const std::size_t count = collect<round, false>(support, near, to);
    return count != doubt ? count : collect<round, true>(support, near, to);
}

/// Those of eight points that are inside, the ones whose bits differ by the definition.
std::size_t NeighbourSearch::settle(const Support& support, const Points& near, std::size_t n, std::size_t in, std::size_t maybe) const {
    for (std::size_t k = 0; k < lanes; ++k)
        if ((in ^ maybe) >> k & 1u && is_inside(support.tensor, particles_.position[near.id[n + k]] - support.point)) in |= 1u << k;
    return in;
}

void NeighbourSearch::make_room_for(std::size_t more) {
    if (end_ + more <= room_) return;
    room_ = 2 * (end_ + more) + 64 * first_.size();
    auto larger = std::make_unique_for_overwrite<int[]>(room_);  // vectors would write zeros first
    std::copy_n(found_.get(), end_, larger.get());
    found_ = std::move(larger);
}

/// The lists without the particles themselves.
void NeighbourSearch::copy_by_id(NeighbourLists& lists) const {
    lists.offset.resize(first_.size() + 1);
    lists.index.resize(end_ + lanes);
    std::size_t end = lists.offset[0] = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
        const IdLanes self = hn::Set(id_tag, static_cast<int>(i));
        const int* from = found_.get() + first_[i];
        for (std::size_t n = 0; n < length_[i]; n += lanes) {
            const IdLanes ids = hn::LoadU(id_tag, from + n);
            std::uint8_t bits[8];
            hn::StoreMaskBits(id_tag, hn::Ne(ids, self), bits);
            const std::size_t others = bits[0] & first_bits(length_[i] - n);
            Front(others).store(ids, &lists.index[end]);
            end += front.count[others];
        }
        lists.offset[i + 1] = end;
    }
    lists.index.resize(end);
}

void NeighbourSearch::find(NeighbourLists& lists) {
    end_ = 0;
    divide(all_, everywhere_, 0);
    copy_by_id(lists);
}

}  // namespace cleave::particles
