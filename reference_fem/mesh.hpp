#pragma once

#include "reference_fem/problem.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace cleave::fem {

/// A triangle of a physical surface.
struct SurfaceTriangle {
    std::array<int, 3> vertices{};
    int surface = 0;   ///< tag of the physical surface
    long element = 0;  ///< its number in the file
};

/// Straight-sided tets as they stand in a .msh. Vertices that no tet uses are left out.
struct Mesh {
    std::string file;
    std::vector<Point> vertices;
    std::vector<std::array<int, 4>> cells;
    std::vector<int> cell_regions;    ///< tag of the physical volume, 0 if none
    std::vector<long> cell_elements;  ///< the tet's number in the file, for messages
    std::vector<SurfaceTriangle> triangles;
};

/// Reads an ASCII .msh, version 2.2 or 4.1. Physical tags count whether or not they have a name. Throws Error.
/// Own reader, since deal.II's cannot name the element at fault, gives a face one tag only, and fails on tagged interior faces.
Mesh read_msh(const std::string& path);

/// m^3; positive if the fourth vertex lies on the side to which the first three turn counter-clockwise.
double signed_volume(const Mesh& mesh, int cell);

/// Longest edge, m.
double diameter(const Mesh& mesh, int cell);

/// Throws Error for a mesh without tets, and for an inverted or flat tet (volume <= 1e-12 diameter^3), naming file and tet.
void check_cells(const Mesh& mesh);

/// A face of one tet on the surface of the body.
struct BoundaryFace {
    int cell = 0;
    int opposite = 0;  ///< local number 0..3 of the cell's vertex that is not on the face
};

/// An edge of one tet: two of its local vertex numbers 0..3.
struct BoundaryEdge {
    int cell = 0;
    std::array<int, 2> ends{};
};

/// Finds faces by their vertices.
class FaceTable {
public:
    /// Throws Error where three tets share a face (a tet that stands twice in the file, say).
    explicit FaceTable(const Mesh& mesh);

    /// The faces of a physical surface, in the order of the file. Throws Error if the mesh has no such surface, or if a triangle of it
    /// is no face of a tet or lies between two tets: nothing can be prescribed inside the body. Surfaces nobody asks for are free to.
    std::vector<BoundaryFace> surface(int id) const;

    /// The edges that triangles of both surfaces have, each once, in ascending order of their vertices. Throws Error as `surface` does,
    /// and where the surfaces do not meet.
    std::vector<BoundaryEdge> line(const Line& line) const;

private:
    struct Entry {
        std::array<int, 3> vertices;
        BoundaryFace face;
        bool operator<(const Entry& other) const { return vertices < other.vertices; }
    };
    std::span<const Entry> find(std::array<int, 3> vertices) const;

    const Mesh& mesh_;
    std::vector<Entry> entries_;  // sorted by vertices
};

/// Part number of each cell; parts are joined by shared vertices and numbered from 0 in the order of the file.
std::vector<int> connected_parts(const Mesh& mesh);

}  // namespace cleave::fem
