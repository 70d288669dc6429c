#include "reference_fem/test/msh_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>

#include <unistd.h>

namespace cleave::fem::testing {
namespace {

/// Order in which the axes are walked from corner 0 to corner 7 of a brick, even permutations first: odd ones are mirrored.
constexpr std::array<std::array<int, 3>, 6> walks{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

struct Grid {
    std::array<int, 3> counts;
    int node(const std::array<int, 3>& at) const { return (at[2] * (counts[1] + 1) + at[1]) * (counts[0] + 1) + at[0]; }
};

Point node_position(const Box& box, const std::array<int, 3>& at) {
    Point position{};
    for (int i = 0; i < 3; ++i) {
        const double brick = (box.high[i] - box.low[i]) / box.counts[i];
        position[i] = box.low[i] + brick * at[i];
        if (at[i] > 0 && at[i] < box.counts[i])
            position[i] += box.distortion * brick * std::sin(12.9 * at[0] + 78.2 * at[1] + 37.7 * at[2] + 5.0 * i);
    }
    return position;
}

void add_brick(MshText& mesh, const Box& box, const std::array<int, 3>& corner) {
    const Grid grid{box.counts};
    for (std::size_t walk = 0; walk < walks.size(); ++walk) {
        std::array<int, 3> at = corner;
        std::array<int, 4> nodes{grid.node(at)};
        for (int step = 0; step < 3; ++step) {
            ++at[walks[walk][step]];
            nodes[step + 1] = grid.node(at);
        }
        if (walk >= 3) std::swap(nodes[0], nodes[1]);
        Point centroid{};
        for (const int node : nodes)
            for (int i = 0; i < 3; ++i) centroid[i] += mesh.nodes[node][i] / 4;
        mesh.tets.push_back({nodes, box.region ? box.region(centroid) : 1});
    }
}

/// The faces of tets that lie in a side of the box, found by coordinates.
void add_sides(MshText& mesh, const Box& box) {
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const double plane = side % 2 == 0 ? box.low[axis] : box.high[axis];
        for (const auto& tet : mesh.tets) {
            std::vector<int> on_side;
            std::copy_if(tet.nodes.begin(), tet.nodes.end(), std::back_inserter(on_side),
                         [&](int node) { return mesh.nodes[node][axis] == plane; });
            if (on_side.size() == 3) mesh.triangles.push_back({{on_side[0], on_side[1], on_side[2]}, side + 1});
        }
    }
}

}  // namespace

std::string MshText::version_2() const {
    std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) text += fmt::format("{} {:.17g}\n", i + 1, fmt::join(nodes[i], " "));
    text += fmt::format("$EndNodes\n$Elements\n{}\n", triangles.size() + tets.size());
    int number = 0;
    for (const auto& [n, surface] : triangles)
        text += fmt::format("{} 2 2 {} {} {} {} {}\n", ++number, surface, surface, n[0] + 1, n[1] + 1, n[2] + 1);
    for (const auto& [n, region] : tets)
        text += fmt::format("{} 4 2 {} {} {} {} {} {}\n", ++number, region, region, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    return text + "$EndElements\n";
}

std::string MshText::version_4() const {
    std::set<int> surfaces, regions;
    for (const auto& triangle : triangles) surfaces.insert(triangle.surface);
    for (const auto& tet : tets) regions.insert(tet.region);
    std::string text = fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 {} {}\n", surfaces.size(), regions.size());
    for (const int surface : surfaces) text += fmt::format("{} 0 0 0 1 1 1 1 {} 0\n", surface, surface);
    for (const int region : regions) text += fmt::format("{} 0 0 0 1 1 1 1 {} 0\n", region, region);
    text += fmt::format("$EndEntities\n$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n", nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) text += fmt::format("{}\n", i + 1);
    for (const Point& node : nodes) text += fmt::format("{:.17g}\n", fmt::join(node, " "));
    const std::size_t count = triangles.size() + tets.size();
    text += fmt::format("$EndNodes\n$Elements\n{} {} 1 {}\n", count, count, count);  // one block per element: legal, if wasteful
    int number = 0;
    for (const auto& [n, surface] : triangles)
        text += fmt::format("2 {} 2 1\n{} {} {} {}\n", surface, ++number, n[0] + 1, n[1] + 1, n[2] + 1);
    for (const auto& [n, region] : tets)
        text += fmt::format("3 {} 4 1\n{} {} {} {} {}\n", region, ++number, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    return text + "$EndElements\n";
}

MshText single_tet() {
    MshText mesh;
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.tets = {{{0, 1, 2, 3}, 1}};
    mesh.triangles = {{{0, 2, 1}, 5}, {{0, 1, 3}, 6}};
    return mesh;
}

MshText box_mesh(const Box& box) {
    MshText mesh;
    const auto& [nx, ny, nz] = box.counts;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) mesh.nodes.push_back(node_position(box, {i, j, k}));
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) add_brick(mesh, box, {i, j, k});
    add_sides(mesh, box);
    return mesh;
}

/// Removes the files when the test program ends.
struct TemporaryFiles {
    std::set<std::string> paths;
    ~TemporaryFiles() {
        for (const std::string& path : paths) std::remove(path.c_str());
    }
};

std::string write_temporary(const std::string& name, const std::string& text) {
    static TemporaryFiles files;
    const std::string path = fmt::format("{}cleave_fem_{}_{}", ::testing::TempDir(), ::getpid(), name);
    files.paths.insert(path);
    std::ofstream(path) << text;
    return path;
}

std::string write_box(const std::string& name, const Box& box) { return write_temporary(name, box_mesh(box).version_2()); }

}  // namespace cleave::fem::testing
