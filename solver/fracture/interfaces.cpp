#include "solver/fracture/interfaces.hpp"

#include "solver/particles/nearest.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <optional>

namespace cleave::fracture {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Point of the segment a-b nearest to p.
Eigen::Vector3d nearest_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
    const Eigen::Vector3d along = b - a;
    const double length2 = along.squaredNorm();
    return length2 > 0 ? Eigen::Vector3d(a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along) : a;
}

/// Of the cut of a triangle with a plane the point nearest to `centre`, which lies in the plane. Corners on the plane count as above it.
std::optional<Eigen::Vector3d> nearest_cut_point(const Corners& corner, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal) {
    std::array<double, 3> height;
    for (int k = 0; k < 3; ++k) height[k] = normal.dot(corner[k] - centre);
    std::array<Eigen::Vector3d, 2> end;
    int ends = 0;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if ((height[k] < 0) == (height[next] < 0)) continue;
        end[ends++] = corner[k] + height[k] / (height[k] - height[next]) * (corner[next] - corner[k]);
    }
    if (ends < 2) return std::nullopt;
    return nearest_on_segment(end[0], end[1], centre);
}

/// A face that a crack meets on its way to another material, at the point nearest to the disc's centre.
struct Meeting {
    Eigen::Vector3d position, normal;
    double distance, size;  ///< m, from the centre; of the face
};

/// Of all meetings the nearest, of equally near ones the one of least coordinates; its normal the mean of the faces that meet the crack in
/// that very point, since a crack comes first to an edge of a bent interface as a rule. Not a word about the faces' numbers.
Meeting nearest_of(const std::vector<Meeting>& meetings) {
    const auto nearer = [](const Meeting& a, const Meeting& b) { return a.distance < b.distance; };
    const Meeting& least = *std::min_element(meetings.begin(), meetings.end(), nearer);
    const double rounding = particles::alike * std::max(least.distance, least.size);
    Meeting result = least;
    for (const Meeting& one : meetings)
        if (one.distance <= least.distance + rounding && particles::comes_before(one.position, result.position, rounding)) result = one;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Meeting& one : meetings)
        if ((one.position - result.position).norm() <= rounding) sum += one.normal;
    if (sum.norm() > 0.01) result.normal = sum.normalized();  // else a fold back onto itself
    return result;
}

}  // namespace

std::vector<InterfaceFace> interface_faces(const mesh::TetMesh& mesh, const std::vector<int>& material) {
    std::vector<InterfaceFace> faces;
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    for (std::size_t half = 0; half < links.opposite.size(); ++half) {
        const int other = links.opposite[half];
        if (other < static_cast<int>(half)) continue;  // each face once; -1 on the boundary
        const int tet = static_cast<int>(half) / 4, beyond = other / 4;
        if (material[tet] == material[beyond]) continue;
        InterfaceFace face{{}, {tet, beyond}, {material[tet], material[beyond]}};
        const std::array<int, 3> vertices = mesh::face_of(mesh.tets[tet], static_cast<int>(half) % 4);
        for (int k = 0; k < 3; ++k) face.corner[k] = mesh.vertices[vertices[k]];
        faces.push_back(face);
    }
    return faces;
}

std::vector<InterfaceHit> interface_hits(const std::vector<InterfaceFace>& faces, int from, const Eigen::Vector3d& centre,
                                         const Eigen::Vector3d& normal, double radius) {
    std::map<int, std::vector<Meeting>> meetings;
    for (const InterfaceFace& face : faces) {
        if (face.material[0] != from && face.material[1] != from) continue;
        const int side = face.material[0] == from ? 1 : 0;
        const std::optional<Eigen::Vector3d> point = nearest_cut_point(face.corner, centre, normal);
        if (!point || (*point - centre).norm() > radius) continue;
        const Eigen::Vector3d across = (face.corner[1] - face.corner[0]).cross(face.corner[2] - face.corner[0]).normalized();
        meetings[face.material[side]].push_back({*point, side == 1 ? across : Eigen::Vector3d(-across), (*point - centre).norm(),
                                                 (face.corner[1] - face.corner[0]).norm()});
    }
    std::vector<InterfaceHit> hits;
    for (const auto& [to, all] : meetings) {
        const Meeting nearest = nearest_of(all);
        hits.push_back({nearest.position, nearest.normal, to});
    }
    return hits;
}

}  // namespace cleave::fracture
