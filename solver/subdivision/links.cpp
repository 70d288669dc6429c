#include "solver/subdivision/links.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleave::subdivision {
namespace {

/// Overlaps below this share of the original face are rounding.
constexpr double no_overlap = 1e-14;

Triangle triangle_of(const mesh::TetMesh& mesh, int half_face) {
    const auto [a, b, c] = mesh::face_of(mesh.tets[half_face / 4], half_face % 4);
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// The original half face that a half face of the result is a part of; -1 inside a parent.
int original_half_face(const Subdivided& subdivided, int half_face) {
    const int face = subdivided.parent_face[half_face];
    return face < 0 ? -1 : 4 * subdivided.parent[half_face / 4] + face;
}


/// (cut, tet, rank of the vertex opposite): see links.hpp on the order of extra links.
using FaceKey = std::array<int, 3>;

FaceKey face_key(const mesh::TetMesh& original, const std::vector<int>& cut_of_parent, int original_half_face) {
    const auto& tet = original.tets[original_half_face / 4];
    const int opposite = tet[original_half_face % 4];
    const auto smaller = std::count_if(tet.begin(), tet.end(), [opposite](int v) { return v < opposite; });
    return {cut_of_parent[original_half_face / 4], original_half_face / 4, static_cast<int>(smaller)};
}

/// The unlinked pieces on the two sides of original faces, and the smaller original half face.
struct LooseFace {
    int half_face;
    FaceSide low, high;
};

std::map<FaceKey, LooseFace> loose_faces(const mesh::TetMesh& original, const Subdivided& subdivided) {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(original);
    std::vector<int> cut_of_parent(original.tets.size(), -1);
    for (std::size_t tet = 0; tet < subdivided.parent.size(); ++tet) cut_of_parent[subdivided.parent[tet]] = subdivided.cut[tet];
    std::map<FaceKey, LooseFace> faces;
    const int half_faces = static_cast<int>(subdivided.links.opposite.size());
    for (int h = 0; h < half_faces; ++h) {
        const int here = subdivided.links.opposite[h] < 0 ? original_half_face(subdivided, h) : -1;
        const int there = here < 0 ? -1 : links.opposite[here];
        if (there < 0) continue;
        LooseFace& face = faces[std::max(face_key(original, cut_of_parent, here), face_key(original, cut_of_parent, there))];
        face.half_face = std::min(here, there);
        (here < there ? face.low : face.high).add(h, triangle_of(subdivided.mesh, h));
    }
    return faces;
}

double longest_edge(const mesh::TetMesh& mesh, int tet) {
    double longest = 0;
    for (const int a : mesh.tets[tet]) {
        for (const int b : mesh.tets[tet]) longest = std::max(longest, (mesh.vertices[a] - mesh.vertices[b]).norm());
    }
    return longest;
}

/// Area of all partners of each half face, and the links that are wrong.
std::vector<double> partner_areas(const Subdivided& subdivided, Audit& found) {
    const std::vector<int>& opposite = subdivided.links.opposite;
    std::vector<double> areas(opposite.size(), 0);
    const auto sorted_vertices = [&](int h) {
        auto vertices = mesh::face_of(subdivided.mesh.tets[h / 4], h % 4);
        std::sort(vertices.begin(), vertices.end());
        return vertices;
    };
    for (std::size_t h = 0; h < opposite.size(); ++h) {
        if (opposite[h] < 0) continue;
        areas[h] += triangle_area(triangle_of(subdivided.mesh, opposite[h]));
        const bool mutual = opposite[opposite[h]] == static_cast<int>(h);
        found.asymmetric += !mutual || sorted_vertices(static_cast<int>(h)) != sorted_vertices(opposite[h]);
    }
    for (const ExtraLink& link : subdivided.extra_links) {
        areas[link.first] += link.area;
        areas[link.second] += link.area;
    }
    return areas;
}

void audit_areas(const mesh::TetMesh& original, const Subdivided& subdivided, Audit& found) {
    const mesh::HalfFaceLinks original_links = mesh::link_half_faces(original);
    const std::vector<double> partners = partner_areas(subdivided, found);
    for (std::size_t h = 0; h < partners.size(); ++h) {
        const int face = original_half_face(subdivided, static_cast<int>(h));
        if (face >= 0 && original_links.opposite[face] < 0) {
            found.paired_boundary += partners[h] > 0;
            continue;
        }
        found.unpaired += partners[h] == 0;
        const double own = triangle_area(triangle_of(subdivided.mesh, static_cast<int>(h)));
        found.worst_area_error = std::max(found.worst_area_error, std::abs(partners[h] - own) / own);
    }
}

void audit_volumes(const mesh::TetMesh& original, const Subdivided& subdivided, Audit& found) {
    std::vector<double> sums(original.tets.size(), 0);
    for (std::size_t tet = 0; tet < subdivided.mesh.tets.size(); ++tet) {
        const double volume = mesh::tet_volume(subdivided.mesh, static_cast<int>(tet));
        const int parent = subdivided.parent[tet];
        sums[parent] += volume;
        found.smallest_share = std::min(found.smallest_share, volume / mesh::tet_volume(original, parent));
        found.stated_volume_error =
            std::max(found.stated_volume_error, std::abs(subdivided.volume[tet] - volume) / std::pow(longest_edge(original, parent), 3));
    }
    for (std::size_t parent = 0; parent < sums.size(); ++parent) {
        const int tet = static_cast<int>(parent);
        const double error = std::abs(sums[parent] - mesh::tet_volume(original, tet)) / std::pow(longest_edge(original, tet), 3);
        found.volume_error = std::max(found.volume_error, error);
    }
}

}  // namespace

namespace {

Triangle sorted_triangle(const mesh::TetMesh& mesh, int half_face) {
    auto corners = mesh::face_of(mesh.tets[half_face / 4], half_face % 4);
    std::sort(corners.begin(), corners.end());
    return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

}  // namespace

void find_links(const mesh::TetMesh& original, Subdivided& subdivided) {
    subdivided.links = mesh::link_half_faces(subdivided.mesh);
    subdivided.extra_links.clear();
    for (const auto& [key, face] : loose_faces(original, subdivided)) {
        link_pieces(face.low, face.high, sorted_triangle(original, face.half_face), subdivided.extra_links);
    }
}

void link_pieces(const FaceSide& low, const FaceSide& high, const Triangle& face, std::vector<ExtraLink>& links) {
    const auto add = [&](int i, int j, double area) {
        const int a = low.half_faces[i], b = high.half_faces[j];
        links.push_back({std::min(a, b), std::max(a, b), area});
    };
    if (low.count + high.count == 4) {
        // One triangle beside three about its barycentre: thirds.
        const double third = triangle_area(face) / 3;
        for (int i = 0; i < low.count; ++i) {
            for (int j = 0; j < high.count; ++j) add(i, j, third);
        }
        return;
    }
    if (low.count == 1 || high.count == 1) {
        // One triangle covers the face: it shares with each piece all of that piece.
        for (int i = 0; i < low.count; ++i) {
            for (int j = 0; j < high.count; ++j) add(i, j, triangle_area(low.count == 1 ? high.triangles[j] : low.triangles[i]));
        }
        return;
    }
    const FaceFrame frame(face);
    const double threshold = no_overlap * triangle_area(face);
    for (int i = 0; i < low.count; ++i) {
        const FlatTriangle flat = frame.flat(low.triangles[i]);
        for (int j = 0; j < high.count; ++j) {
            const double shared = overlap_area(flat, frame.flat(high.triangles[j]));
            if (shared > threshold) add(i, j, shared);
        }
    }
}

Audit audit(const mesh::TetMesh& original, const Subdivided& subdivided) {
    Audit found;
    audit_areas(original, subdivided, found);
    audit_volumes(original, subdivided, found);
    return found;
}

}  // namespace cleave::subdivision
