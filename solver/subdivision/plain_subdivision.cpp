#include "solver/subdivision/plain_subdivision.hpp"

#include "solver/subdivision/child_geometry.hpp"
#include "solver/subdivision/links.hpp"
#include "solver/subdivision/surface_tags.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace cleave::subdivision {
namespace {

using Eigen::Vector3d;

/// The sorted parent's vertices without the one of a face.
std::array<int, 3> sorted_face(const std::array<int, 4>& sorted, int face) {
    std::array<int, 3> vertices{};
    for (int i = 0, count = 0; i < 4; ++i) {
        if (i != face) vertices[count++] = sorted[i];
    }
    return vertices;
}

std::array<int, 2> edge_of(const std::array<int, 4>& sorted, int edge) {
    return {sorted[edge_ends[edge][0]], sorted[edge_ends[edge][1]]};
}

}  // namespace

PlainSubdivision::PlainSubdivision(mesh::TetMesh mesh, const Options& options)
    : mesh_(std::move(mesh)), shortest_edges_(shortest_incident_edges(mesh_)), options_(options), is_cut_(mesh_.tets.size(), false) {
    counts_.uncut = static_cast<int>(mesh_.tets.size());
}

Counts PlainSubdivision::cut(const Cut& cut) {
    // Points of earlier cuts belong to tets that are cut already: only the original vertices count.
    const std::vector<Vector3d> originals(mesh_.vertices.begin(), mesh_.vertices.begin() + static_cast<long>(shortest_edges_.size()));
    const std::vector<double> distances = vertex_distances(originals, shortest_edges_, cut, options_.tau);
    const std::vector<Parent> parents = parents_of(cut, distances);
    NewPoints points;
    Counts done;
    for (const Parent& parent : parents) {
        const std::array<int, 15> numbers = make_points(parent, distances, points);
        add_children(parent, numbers, volumes_of(parent, distances));
        is_cut_[parent.tet] = true;
        (std::popcount(parent.plus_mask) == 2 ? done.two_two : done.three_one) += 1;
    }
    counts_.three_one += done.three_one;
    counts_.two_two += done.two_two;
    counts_.uncut -= done.three_one + done.two_two;
    done.uncut = counts_.uncut;
    ++cuts_;
    return done;
}

std::vector<PlainSubdivision::Parent> PlainSubdivision::parents_of(const Cut& cut, const std::vector<double>& distances) const {
    std::vector<Parent> parents;
    for (std::size_t tet = 0; tet < mesh_.tets.size(); ++tet) {
        if (is_cut_[tet]) continue;
        const auto& vertices = mesh_.tets[tet];
        Parent parent{.tet = static_cast<int>(tet), .sorted = {}, .position = {0, 1, 2, 3}, .odd = false, .plus_mask = 0};
        std::sort(parent.position.begin(), parent.position.end(), [&](int a, int b) { return vertices[a] < vertices[b]; });
        std::array<Vector3d, 4> corners;
        std::array<double, 4> at{};
        for (int i = 0; i < 4; ++i) {
            parent.sorted[i] = vertices[parent.position[i]];
            corners[i] = mesh_.vertices[parent.sorted[i]];
            at[i] = distances[parent.sorted[i]];
            if (at[i] >= 0) parent.plus_mask |= 1U << i;
            for (int j = 0; j < i; ++j) parent.odd ^= parent.position[j] > parent.position[i];
        }
        if (passes(cut, corners, at)) parents.push_back(parent);
    }
    return parents;
}

int PlainSubdivision::add_vertex(const Vector3d& position) {
    mesh_.vertices.push_back(position);
    return static_cast<int>(mesh_.vertices.size()) - 1;
}

/// The numbers of all points of a parent, by code; makes those that no parent before it made.
std::array<int, 15> PlainSubdivision::make_points(const Parent& parent, const std::vector<double>& distances, NewPoints& points) {
    const CutTemplate& cut = cut_template(parent.plus_mask);
    std::array<int, 15> numbers;
    numbers.fill(-1);
    std::copy(parent.sorted.begin(), parent.sorted.end(), numbers.begin());
    for (const PointCode code : cut.points) {
        const int face = code - first_face_code;
        numbers[code] = code < first_face_code ? edge_point_of(parent, code - first_edge_code, distances, points)
                        : code == centre_code  ? centre_of(cut, numbers)
                        : face == cut.base_face ? base_point_of(parent, face)
                                                : quad_point_of(parent, face, numbers, points);
    }
    return numbers;
}

int PlainSubdivision::edge_point_of(const Parent& parent, int edge, const std::vector<double>& distances, NewPoints& points) {
    const auto [known, is_new] = points.edges.emplace(edge_of(parent.sorted, edge), -1);
    if (is_new) {
        auto [plus, minus] = known->first;
        if (distances[minus] >= 0) std::swap(plus, minus);
        known->second = add_vertex(edge_point(mesh_.vertices[plus], mesh_.vertices[minus], distances[plus], distances[minus]));
    }
    return known->second;
}

int PlainSubdivision::quad_point_of(const Parent& parent, int face, const std::array<int, 15>& numbers, NewPoints& points) {
    const auto [known, is_new] = points.quads.emplace(sorted_face(parent.sorted, face), -1);
    if (is_new) {
        // The two vertices that share a side, then the two cut points.
        std::vector<Vector3d> same_side, cut_points;
        for (int e = 0; e < 6; ++e) {
            const auto& [i, j] = edge_ends[e];
            if (i == face || j == face) continue;
            const int cut_point = numbers[first_edge_code + e];
            if (cut_point >= 0) cut_points.push_back(mesh_.vertices[cut_point]);
            else same_side = {mesh_.vertices[parent.sorted[i]], mesh_.vertices[parent.sorted[j]]};
        }
        known->second = add_vertex(((same_side.at(0) + same_side.at(1)) + (cut_points.at(0) + cut_points.at(1))) / 4);
    }
    return known->second;
}

int PlainSubdivision::base_point_of(const Parent& parent, int face) {
    const auto [known, is_new] = barycentres_.emplace(sorted_face(parent.sorted, face), -1);
    if (is_new) {
        const auto& [a, b, c] = known->first;
        known->second = add_vertex(((mesh_.vertices[a] + mesh_.vertices[b]) + mesh_.vertices[c]) / 3);
    }
    return known->second;
}

int PlainSubdivision::centre_of(const CutTemplate& cut, const std::array<int, 15>& numbers) {
    const auto point = [&](int k) { return mesh_.vertices[numbers[cut.points[k]]]; };
    return add_vertex(((point(0) + point(1)) + (point(2) + point(3))) / 4);
}

/// Of the children, by the shares at which the edges are cut.
std::vector<double> PlainSubdivision::volumes_of(const Parent& parent, const std::vector<double>& distances) const {
    std::array<Vector3d, 4> corners;
    std::array<double, 4> at{};
    for (int i = 0; i < 4; ++i) {
        const int vertex = parent.sorted[cut_template(parent.plus_mask).roles[i]];
        corners[i] = mesh_.vertices[vertex];
        at[i] = distances[vertex];
    }
    const double volume = std::abs(mesh::signed_volume(corners[0], corners[1], corners[2], corners[3]));
    if (std::popcount(parent.plus_mask) == 2) {
        std::array<double, 4> minus{}, plus{};
        for (int edge = 0; edge < 4; ++edge) {
            minus[edge] = edge_share(at[edge / 2], at[2 + edge % 2]);
            plus[edge] = 1 - minus[edge];
        }
        const auto volumes = two_two_volumes(volume, minus, plus);
        return {volumes.begin(), volumes.end()};
    }
    std::array<double, 3> away{}, back{};  // shares from the lone vertex to the base's
    for (int i = 0; i < 3; ++i) {
        const bool lone_plus = at[0] >= 0;
        const double from_plus = lone_plus ? edge_share(at[0], at[1 + i]) : edge_share(at[1 + i], at[0]);
        away[i] = lone_plus ? from_plus : 1 - from_plus;
        back[i] = lone_plus ? 1 - from_plus : from_plus;
    }
    const auto volumes = three_one_volumes(volume, away, back);
    return {volumes.begin(), volumes.end()};
}

void PlainSubdivision::add_children(const Parent& parent, const std::array<int, 15>& numbers, const std::vector<double>& volumes) {
    const std::vector<ChildTemplate>& shapes = cut_template(parent.plus_mask).children;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const ChildTemplate& shape = shapes[k];
        std::array<PointCode, 4> codes = shape.points;
        if (parent.odd) std::swap(codes[2], codes[3]);
        Child child{.vertices = {}, .parent_face = {-1, -1, -1, -1}, .parent = parent.tet, .cut = cuts_,
                    .side = static_cast<std::int8_t>(shape.side), .volume = volumes[k]};
        for (int i = 0; i < 4; ++i) child.vertices[i] = numbers[codes[i]];
        for (int face = 0; face < 4; ++face) {
            unsigned common = 15;
            for (const int corner : mesh::face_vertices[face]) common &= faces_of(codes[corner]);
            if (common != 0) child.parent_face[face] = static_cast<std::int8_t>(parent.position[std::countr_zero(common)]);
        }
        children_.push_back(child);
    }
}

namespace {

void append(Subdivided& out, const std::array<int, 4>& tet, int parent, int cut, std::int8_t side,
            const std::array<std::int8_t, 4>& parent_face) {
    out.mesh.tets.push_back(tet);
    out.parent.push_back(parent);
    out.cut.push_back(cut);
    out.side.push_back(side);
    out.parent_face.insert(out.parent_face.end(), parent_face.begin(), parent_face.end());
}

}  // namespace

Subdivided PlainSubdivision::result() const {
    Subdivided out;
    out.counts = counts_;
    out.mesh.vertices = mesh_.vertices;
    out.mesh.region_names = mesh_.region_names;
    out.mesh.surface_names = mesh_.surface_names;
    for (std::size_t tet = 0; tet < mesh_.tets.size(); ++tet) {
        if (is_cut_[tet]) continue;
        append(out, mesh_.tets[tet], static_cast<int>(tet), -1, 0, {0, 1, 2, 3});
        out.volume.push_back(mesh::tet_volume(mesh_, static_cast<int>(tet)));
        out.centroid.push_back(mesh::tet_centroid(mesh_, static_cast<int>(tet)));
    }
    for (const Child& child : children_) {
        append(out, child.vertices, child.parent, child.cut, child.side, child.parent_face);
        const auto& [a, b, c, d] = child.vertices;
        out.volume.push_back(child.volume);
        out.centroid.push_back(child_centroid(mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c], mesh_.vertices[d]));
    }
    for (const int parent : out.parent) out.mesh.regions.push_back(mesh_.regions[parent]);
    out.mesh.surface = cut_surface(mesh_, out);
    find_links(mesh_, out);
    return out;
}

Subdivided subdivide(const mesh::TetMesh& mesh, const std::vector<Cut>& cuts, const Options& options) {
    PlainSubdivision subdivision(mesh, options);
    for (const Cut& cut : cuts) subdivision.cut(cut);
    return subdivision.result();
}

}  // namespace cleave::subdivision
