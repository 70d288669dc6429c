#include "solver/fragments/surface.hpp"

#include "solver/fragments/seams.hpp"
#include "solver/subdivision/triangle_overlap.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_map>

namespace cleave::fragments {
namespace {

using Eigen::Vector3d;
using subdivision::FaceFrame;
using subdivision::FlatPolygon;
using subdivision::Triangle;

/// Points nearer than this share of the fragment's extent are the same: far above rounding, far below a child.
constexpr double same_point = 1e-10;

/// Collects the faces of one fragment.
class SurfaceMaker {
public:
    SurfaceMaker(const FragmentedBody& body, const Fragment& fragment) : body_(body), fragment_(fragment) { list_partners(); }

    Surface make() {
        for (const int particle : fragment_.particles) {
            for (int face = 0; face < 4; ++face) add_face(4 * particle + face);
        }
        if (!out_.points.empty()) close_seams(out_, same_point * extent());
        drop_unused_points();
        return std::move(out_);
    }

private:
    struct Partner {
        int half_face, other;
        bool removed;
    };

    void list_partners() {
        const int number = fragment_.particles.empty() ? -1 : body_.fragment_of(fragment_.particles.front());
        for (const auto& [link, removed] : body_.links().partial()) {
            if (body_.fragment_of(link.first / 4) == number) partners_.push_back({link.first, link.second, removed});
            if (body_.fragment_of(link.second / 4) == number) partners_.push_back({link.second, link.first, removed});
        }
        std::stable_sort(partners_.begin(), partners_.end(), [](const Partner& a, const Partner& b) { return a.half_face < b.half_face; });
    }

    void add_face(int half_face) {
        const LinkTable& links = body_.links();
        const int behind = links.opposite(body_.engine(), half_face);
        if (behind >= 0 && !links.is_gone(behind / 4)) {
            if (links.is_removed(half_face)) add_whole(half_face, true);
            return;
        }
        const auto before = [](const Partner& partner, int h) { return partner.half_face < h; };
        const auto first = std::lower_bound(partners_.begin(), partners_.end(), half_face, before);
        const auto last = std::lower_bound(first, partners_.end(), half_face + 1, before);
        if (first == last) {
            add_whole(half_face, false);
        } else if (std::all_of(first, last, [](const Partner& partner) { return partner.removed; })) {
            add_whole(half_face, true);
        } else {
            for (auto at = first; at != last; ++at) {
                if (at->removed) add_overlap(half_face, at->other);
            }
        }
    }

    std::array<int, 3> corners(int half_face) const { return mesh::face_of(body_.vertices(half_face / 4), half_face % 4); }

    Triangle triangle(int half_face) const {
        const auto [a, b, c] = corners(half_face);
        return {body_.point(a), body_.point(b), body_.point(c)};
    }

    void add_whole(int half_face, bool crack) {
        SurfaceFace face{{}, half_face / 4, crack};
        for (int i = 0; i < 3; ++i) {
            const int vertex = corners(half_face)[i];
            const auto [at, is_new] = numbers_.try_emplace(vertex, static_cast<int>(out_.points.size()));
            if (is_new) out_.points.push_back(body_.point(vertex));
            face.points[i] = at->second;
        }
        out_.faces.push_back(face);
    }

    /// The part of a face behind which `other` was lost.
    void add_overlap(int half_face, int other) {
        const FaceFrame frame(triangle(half_face));
        const FlatPolygon polygon = subdivision::overlap(frame.flat(triangle(half_face)), frame.flat(triangle(other)));
        const int first = static_cast<int>(out_.points.size());
        for (int i = 0; i < polygon.count; ++i) out_.points.push_back(frame.lift(polygon.corners[i]));
        for (int i = 1; i + 1 < polygon.count; ++i) out_.faces.push_back({{first, first + i, first + i + 1}, half_face / 4, true});
    }

    double extent() const {
        Vector3d low = out_.points.front(), high = low;
        for (const Vector3d& x : out_.points) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
        return (high - low).norm();
    }

    void drop_unused_points() {
        std::vector<int> number(out_.points.size(), -1);
        std::vector<Vector3d> points;
        for (SurfaceFace& face : out_.faces) {
            for (int& point : face.points) {
                if (number[point] < 0) {
                    number[point] = static_cast<int>(points.size());
                    points.push_back(out_.points[point]);
                }
                point = number[point];
            }
        }
        out_.points = std::move(points);
    }

    const FragmentedBody& body_;
    const Fragment& fragment_;
    std::vector<Partner> partners_;             ///< of non-conforming half faces, sorted by half face
    std::unordered_map<int, int> numbers_;      ///< vertex -> point; only looked up
    Surface out_;
};

}  // namespace

Surface surface(const FragmentedBody& body, const Fragment& fragment) { return SurfaceMaker(body, fragment).make(); }

double enclosed_volume(const Surface& surface) {
    if (surface.points.empty()) return 0;
    const Vector3d origin = surface.points.front();  // near the fragment, so that no digits are lost
    double six_times = 0;
    for (const SurfaceFace& face : surface.faces) {
        const Vector3d a = surface.points[face.points[0]] - origin, b = surface.points[face.points[1]] - origin,
                       c = surface.points[face.points[2]] - origin;
        six_times += a.dot(b.cross(c));
    }
    return six_times / 6;
}

}  // namespace cleave::fragments
