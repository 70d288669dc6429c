#include "solver/subdivision/plain_subdivision.hpp"

#include "solver/subdivision/links.hpp"
#include "solver/subdivision/surface_tags.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
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
    const NewPoints points = create_points(parents, distances);
    Counts done;
    for (const Parent& parent : parents) {
        const bool two_two = std::popcount(parent.plus_mask) == 2;
        const int centre = two_two ? add_centre(parent, points) : -1;
        add_children(parent, point_numbers(parent, points, centre));
        is_cut_[parent.tet] = true;
        (two_two ? done.two_two : done.three_one) += 1;
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

PlainSubdivision::NewPoints PlainSubdivision::create_points(const std::vector<Parent>& parents, const std::vector<double>& distances) {
    NewPoints points;
    create_edge_points(parents, distances, points);
    create_face_points(parents, points);
    return points;
}

void PlainSubdivision::create_edge_points(const std::vector<Parent>& parents, const std::vector<double>& distances, NewPoints& points) {
    for (const Parent& parent : parents) {
        const unsigned edges = cut_template(parent.plus_mask).edges;
        for (int e = 0; e < 6; ++e) {
            if ((edges >> e & 1U) != 0) points.edges[edge_of(parent.sorted, e)] = -1;
        }
    }
    for (auto& [edge, number] : points.edges) {
        const auto& [a, b] = edge;
        number = add_vertex(edge_point(mesh_.vertices[a], mesh_.vertices[b], distances[a], distances[b]));
    }
}

void PlainSubdivision::create_face_points(const std::vector<Parent>& parents, NewPoints& points) {
    std::map<std::array<int, 3>, Vector3d> positions;  // of all new face points of this cut, to number them in sorted order
    for (const Parent& parent : parents) {
        const CutTemplate& cut = cut_template(parent.plus_mask);
        for (int f = 0; f < 4; ++f) {
            const std::array<int, 3> face = sorted_face(parent.sorted, f);
            const auto& [a, b, c] = face;
            if (f == cut.base_face) {
                if (!barycentres_.contains(face)) positions[face] = (mesh_.vertices[a] + mesh_.vertices[b] + mesh_.vertices[c]) / 3;
            } else if ((cut.quad_faces >> f & 1U) != 0) {
                // The two vertices that share a side, then the two cut points, each pair in ascending order.
                std::vector<Vector3d> same_side, cut_points;
                for (const auto& [i, j] : {std::pair(a, b), std::pair(a, c), std::pair(b, c)}) {
                    const auto cut_point = points.edges.find({i, j});
                    if (cut_point != points.edges.end()) cut_points.push_back(mesh_.vertices[cut_point->second]);
                    else same_side = {mesh_.vertices[i], mesh_.vertices[j]};
                }
                positions[face] = ((same_side.at(0) + same_side.at(1)) + (cut_points.at(0) + cut_points.at(1))) / 4;
                points.quads[face] = -1;
            }
        }
    }
    for (const auto& [face, position] : positions) {
        const int number = add_vertex(position);
        const auto quad = points.quads.find(face);
        (quad != points.quads.end() ? quad->second : barycentres_[face]) = number;
    }
}

int PlainSubdivision::add_centre(const Parent& parent, const NewPoints& points) {
    std::vector<Vector3d> ring;
    for (int e = 0; e < 6; ++e) {
        const auto cut_point = points.edges.find(edge_of(parent.sorted, e));
        if (cut_point != points.edges.end()) ring.push_back(mesh_.vertices[cut_point->second]);
    }
    return add_vertex((((ring.at(0) + ring.at(1)) + ring.at(2)) + ring.at(3)) / 4);
}

std::array<int, 15> PlainSubdivision::point_numbers(const Parent& parent, const NewPoints& points, int centre) const {
    const CutTemplate& cut = cut_template(parent.plus_mask);
    std::array<int, 15> numbers;
    numbers.fill(-1);
    std::copy(parent.sorted.begin(), parent.sorted.end(), numbers.begin());
    for (int e = 0; e < 6; ++e) {
        if ((cut.edges >> e & 1U) != 0) numbers[first_edge_code + e] = points.edges.at(edge_of(parent.sorted, e));
    }
    for (int f = 0; f < 4; ++f) {
        const std::array<int, 3> face = sorted_face(parent.sorted, f);
        if (f == cut.base_face) numbers[first_face_code + f] = barycentres_.at(face);
        if ((cut.quad_faces >> f & 1U) != 0) numbers[first_face_code + f] = points.quads.at(face);
    }
    numbers[centre_code] = centre;
    return numbers;
}

void PlainSubdivision::add_children(const Parent& parent, const std::array<int, 15>& numbers) {
    for (const ChildTemplate& shape : cut_template(parent.plus_mask).children) {
        std::array<PointCode, 4> codes = shape.points;
        if (parent.odd) std::swap(codes[2], codes[3]);
        Child child{.vertices = {}, .parent_face = {-1, -1, -1, -1}, .parent = parent.tet, .cut = cuts_,
                    .side = static_cast<std::int8_t>(shape.side)};
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
        if (!is_cut_[tet]) append(out, mesh_.tets[tet], static_cast<int>(tet), -1, 0, {0, 1, 2, 3});
    }
    for (const Child& child : children_) append(out, child.vertices, child.parent, child.cut, child.side, child.parent_face);
    for (std::size_t tet = 0; tet < out.parent.size(); ++tet) {
        out.mesh.regions.push_back(mesh_.regions[out.parent[tet]]);
        out.volume.push_back(mesh::tet_volume(out.mesh, static_cast<int>(tet)));
        out.centroid.push_back(mesh::tet_centroid(out.mesh, static_cast<int>(tet)));
    }
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
