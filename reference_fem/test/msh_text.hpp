#pragma once

#include "reference_fem/problem.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace cleave::fem::testing {

/// A mesh to be written as .msh text by the tests; node and element numbers start at 1, triangles before tets.
struct MshText {
    struct Triangle {
        std::array<int, 3> nodes{};
        int surface = 0;
    };
    struct Tet {
        std::array<int, 4> nodes{};
        int region = 1;
    };
    std::vector<Point> nodes;
    std::vector<Triangle> triangles;
    std::vector<Tet> tets;

    std::string version_2() const;
    /// Each physical group becomes one geometric entity of the same tag; no group has a name.
    std::string version_4() const;
};

/// The unit tet, element 3, with two of its faces as the surfaces 5 (z = 0) and 6 (y = 0).
MshText single_tet();

/// A box cut into counts[0] * counts[1] * counts[2] bricks of six tets (Kuhn 1960). Its sides are the surfaces 1 (x low), 2 (x high), 3 (y
/// low), ... 6.
struct Box {
    Point low{0, 0, 0};
    Point high{1, 1, 1};
    std::array<int, 3> counts{3, 3, 3};
    double distortion = 0.2;                             ///< inner nodes move by up to this share of a brick; sides stay flat
    std::function<int(const Point& centroid)> region{};  ///< empty: region 1
};
MshText box_mesh(const Box& box);

/// Writes a file of this name to the tests' temporary folder and returns its path.
std::string write_temporary(const std::string& name, const std::string& text);

/// box_mesh, written as version 2.2.
std::string write_box(const std::string& name, const Box& box);

}  // namespace cleave::fem::testing
