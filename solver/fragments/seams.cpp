#include "solver/fragments/seams.hpp"

#include <algorithm>
#include <map>

namespace cleave::fragments {
namespace {

using Eigen::Vector3d;
using Edge = std::array<int, 2>;

std::vector<Edge> directed_edges(const Surface& surface) {
    std::vector<Edge> edges;
    edges.reserve(3 * surface.faces.size());
    for (const SurfaceFace& face : surface.faces) {
        for (int i = 0; i < 3; ++i) edges.push_back({face.points[i], face.points[(i + 1) % 3]});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// Directed edges that occur more often than their reverse, each once, sorted.
std::vector<Edge> unpaired_edges(const Surface& surface) {
    const std::vector<Edge> edges = directed_edges(surface);
    const auto count = [&](const Edge& edge) {
        const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge);
        return last - first;
    };
    std::vector<Edge> unpaired;
    for (auto at = edges.begin(); at != edges.end(); at = std::upper_bound(at, edges.end(), *at)) {
        if (count(*at) > count({(*at)[1], (*at)[0]})) unpaired.push_back(*at);
    }
    return unpaired;
}

/// The ends of some edges, sorted along x, so that those near a segment are found in a window.
class EndPoints {
public:
    EndPoints(const Surface& surface, const std::vector<Edge>& edges) : points_(surface.points) {
        for (const Edge& edge : edges) numbers_.insert(numbers_.end(), edge.begin(), edge.end());
        std::sort(numbers_.begin(), numbers_.end(), [&](int a, int b) { return std::pair(points_[a][0], a) < std::pair(points_[b][0], b); });
        numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    }

    template <class Visit>
    void between(double low, double high, const Visit& visit) const {
        const auto first = std::lower_bound(numbers_.begin(), numbers_.end(), low, [&](int number, double x) { return points_[number][0] < x; });
        for (auto at = first; at != numbers_.end() && points_[*at][0] <= high; ++at) visit(*at);
    }
    const std::vector<int>& numbers() const { return numbers_; }

private:
    const std::vector<Vector3d>& points_;
    std::vector<int> numbers_;
};

/// Gives points nearer than the tolerance the smallest of their numbers; drops triangles without area.
void join_points(Surface& surface, const EndPoints& ends, double tolerance) {
    std::map<int, int> becomes;
    for (const int number : ends.numbers()) {
        const Vector3d& x = surface.points[number];
        int smallest = number;
        ends.between(x[0] - tolerance, x[0] + tolerance, [&](int other) {
            if (other < smallest && (surface.points[other] - x).norm() <= tolerance) smallest = other;
        });
        if (smallest != number) becomes[number] = smallest;
    }
    if (becomes.empty()) return;
    const auto last = [&](int number) {
        for (auto at = becomes.find(number); at != becomes.end(); at = becomes.find(number)) number = at->second;
        return number;
    };
    for (SurfaceFace& face : surface.faces) {
        for (int& point : face.points) point = last(point);
    }
    std::erase_if(surface.faces, [](const SurfaceFace& face) {
        return face.points[0] == face.points[1] || face.points[1] == face.points[2] || face.points[2] == face.points[0];
    });
}

/// Points inside the edge, in order from its first end.
std::vector<int> points_on(const Surface& surface, const EndPoints& ends, const Edge& edge, double tolerance) {
    const Vector3d &a = surface.points[edge[0]], along = surface.points[edge[1]] - a;
    const double length = along.norm();
    std::vector<std::pair<double, int>> found;
    ends.between(std::min(a[0], a[0] + along[0]) - tolerance, std::max(a[0], a[0] + along[0]) + tolerance, [&](int number) {
        if (number == edge[0] || number == edge[1]) return;
        const Vector3d arm = surface.points[number] - a;
        const double at = arm.dot(along) / length;
        if (at > 0 && at < length && (arm - at / length * along).norm() <= tolerance) found.emplace_back(at, number);
    });
    std::sort(found.begin(), found.end());
    std::vector<int> numbers;
    for (const auto& [at, number] : found) numbers.push_back(number);
    return numbers;
}

using Divisions = std::map<Edge, std::vector<int>>;

/// The triangle's outline with the points on its edges: corners and how many edges are divided.
void divide(const SurfaceFace& face, const Divisions& divisions, Surface& out) {
    std::vector<int> ring;
    int divided = 0, opposite = 0;
    for (int i = 0; i < 3; ++i) {
        ring.push_back(face.points[i]);
        const auto at = divisions.find({face.points[i], face.points[(i + 1) % 3]});
        if (at == divisions.end()) continue;
        ring.insert(ring.end(), at->second.begin(), at->second.end());
        ++divided;
        opposite = face.points[(i + 2) % 3];
    }
    const auto add = [&](int a, int b, int c) { out.faces.push_back({{a, b, c}, face.particle, face.crack}); };
    int apex = opposite;
    if (divided > 1) {
        apex = static_cast<int>(out.points.size());
        out.points.push_back((out.points[face.points[0]] + out.points[face.points[1]] + out.points[face.points[2]]) / 3);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const int a = ring[i], b = ring[(i + 1) % ring.size()];
        if (a != apex && b != apex) add(a, b, apex);
    }
}

void divide_edges(Surface& surface, const std::vector<Edge>& unpaired, const EndPoints& ends, double tolerance) {
    Divisions divisions;
    for (const Edge& edge : unpaired) {
        std::vector<int> points = points_on(surface, ends, edge, tolerance);
        if (!points.empty()) divisions[edge] = std::move(points);
    }
    if (divisions.empty()) return;
    std::vector<SurfaceFace> faces;
    faces.swap(surface.faces);
    for (const SurfaceFace& face : faces) {
        const bool any = divisions.contains({face.points[0], face.points[1]}) || divisions.contains({face.points[1], face.points[2]}) ||
                         divisions.contains({face.points[2], face.points[0]});
        any ? divide(face, divisions, surface) : surface.faces.push_back(face);
    }
}

}  // namespace

void close_seams(Surface& surface, double tolerance) {
    // Where two sheets touch along an edge, both are divided although only one had to be: the next round divides their partners.
    constexpr int most_rounds = 4;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Edge> unpaired = unpaired_edges(surface);
        if (unpaired.empty()) return;
        join_points(surface, EndPoints(surface, unpaired), tolerance);
        unpaired = unpaired_edges(surface);
        divide_edges(surface, unpaired, EndPoints(surface, unpaired), tolerance);
    }
}

int open_edges(const Surface& surface) { return static_cast<int>(unpaired_edges(surface).size()); }

}  // namespace cleave::fragments
