#include "solver/mesh/morton.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace cleave::mesh {
namespace {

/// The lowest 21 bits, two zeros after each.
std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

namespace {

/// Calls visit(key) for each point in turn: its place on the curve, 21 bits an axis.
template <class Visit>
void for_each_key(const std::vector<Eigen::Vector3d>& points, const Visit& visit) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : points) box.extend(point);
    // A flat box still has a width to divide by.
    Eigen::Vector3d width = Eigen::Vector3d::Ones();
    if (!points.empty()) width = box.sizes().cwiseMax(std::numeric_limits<double>::min());
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d share = (point - box.min()).cwiseQuotient(width) * double{0x1fffff};
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) key |= spread(static_cast<std::uint64_t>(share[axis])) << axis;
        visit(key);
    }
}

}  // namespace

std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points) {
    std::vector<std::pair<std::uint64_t, int>> keys;
    keys.reserve(points.size());
    for_each_key(points, [&](std::uint64_t key) { keys.emplace_back(key, static_cast<int>(keys.size())); });
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    order.reserve(keys.size());
    for (const auto& [key, number] : keys) order.push_back(number);
    return order;
}

std::vector<int> coarse_morton_order(const std::vector<Eigen::Vector3d>& points) {
    struct Item {
        std::uint32_t key;
        int number;
    };
    constexpr int bits = 10, digits = 3;  // of the key, from the lowest (radix sort: each pass keeps the order of equal digits)
    std::vector<Item> items, sorted(points.size());
    items.reserve(points.size());
    for_each_key(points, [&](std::uint64_t key) { items.push_back({static_cast<std::uint32_t>(key >> 33), static_cast<int>(items.size())}); });
    std::array<std::array<int, 1 << bits>, digits> start{};
    const auto digit = [](const Item& item, int pass) { return item.key >> bits * pass & ((1U << bits) - 1); };
    for (const Item& item : items) {
        for (int pass = 0; pass < digits; ++pass) ++start[pass][digit(item, pass)];
    }
    for (int pass = 0; pass < digits; ++pass) {
        std::exclusive_scan(start[pass].begin(), start[pass].end(), start[pass].begin(), 0);
        for (const Item& item : items) sorted[static_cast<std::size_t>(start[pass][digit(item, pass)]++)] = item;
        items.swap(sorted);
    }
    std::vector<int> order;
    order.reserve(items.size());
    for (const Item& item : items) order.push_back(item.number);
    return order;
}

TetMesh in_morton_order(const TetMesh& mesh) {
    TetMesh out = mesh;
    const std::vector<int> vertices = morton_order(mesh.vertices);
    std::vector<int> number(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        out.vertices[v] = mesh.vertices[vertices[v]];
        number[vertices[v]] = static_cast<int>(v);
    }
    std::vector<Eigen::Vector3d> centroids;
    centroids.reserve(mesh.tets.size());
    for (std::size_t tet = 0; tet < mesh.tets.size(); ++tet) centroids.push_back(tet_centroid(mesh, static_cast<int>(tet)));
    const std::vector<int> tets = morton_order(centroids);
    for (std::size_t tet = 0; tet < tets.size(); ++tet) {
        out.tets[tet] = mesh.tets[tets[tet]];
        for (int& v : out.tets[tet]) v = number[v];
        out.regions[tet] = mesh.regions[tets[tet]];
    }
    for (SurfaceTriangle& triangle : out.surface) {
        for (int& v : triangle.vertices) v = number[v];
    }
    return out;
}

}  // namespace cleave::mesh
