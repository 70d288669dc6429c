#include "reference_fem/contact_surface.hpp"

#include "reference_fem/vector3.hpp"

#include <map>

namespace cleave::fem {
namespace {

/// Barycentric coordinates on a triangle: 16 equal parts, three points in each (exact to degree 2; Strang and Fix 1973).
std::vector<Point> fine_rule() {
    constexpr int parts = 4;
    std::vector<Point> points;
    const auto add_triangle = [&](const Point& a, const Point& b, const Point& c) {
        for (const Point& w : {Point{4, 1, 1}, Point{1, 4, 1}, Point{1, 1, 4}}) points.push_back(1.0 / 6 * (w[0] * a + w[1] * b + w[2] * c));
    };
    const auto corner = [](int i, int j) { return 1.0 / parts * Point{static_cast<double>(i), static_cast<double>(j), static_cast<double>(parts - i - j)}; };
    for (int i = 0; i < parts; ++i)
        for (int j = 0; i + j < parts; ++j) {
            add_triangle(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            if (i + j + 2 <= parts) add_triangle(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    return points;
}

}  // namespace

ContactSurface::ContactSurface(const std::vector<BoundaryFace>& faces, const Mesh& mesh, const Discretization& space) {
    std::map<int, int> number;  // of a node by its dof along z
    const std::vector<Point> rule = fine_rule();
    std::vector<double> values(space.nodes_per_cell());
    std::vector<Point> gradients(space.nodes_per_cell());
    for (const BoundaryFace& face : faces) {
        const auto& cell = mesh.cells[face.cell];
        std::vector<int> local, corners;
        for (int node = 0; node < space.nodes_per_cell(); ++node)
            if (space.node_barycentrics()[node][face.opposite] == 0) local.push_back(node);
        for (int vertex = 0; vertex < 4; ++vertex)
            if (vertex != face.opposite) corners.push_back(vertex);
        std::vector<int> nodes;
        for (const int node : local) {
            const int dof = space.dof(face.cell, node, 2);
            const auto [entry, is_new] = number.emplace(dof, static_cast<int>(normal_dofs_.size()));
            if (is_new) normal_dofs_.push_back(dof);
            nodes.push_back(entry->second);
        }
        const Point &a = mesh.vertices[cell[corners[0]]], &b = mesh.vertices[cell[corners[1]]], &c = mesh.vertices[cell[corners[2]]];
        const double area = norm(cross(b - a, c - a)) / 2;
        for (const Point& weights : rule) {
            std::array<double, 4> barycentric{};
            for (int i = 0; i < 3; ++i) barycentric[corners[i]] = weights[i];
            space.shape({barycentric[1], barycentric[2], barycentric[3]}, values, gradients);
            SurfacePoint point{.position = weights[0] * a + weights[1] * b + weights[2] * c,
                               .area = area / static_cast<double>(rule.size()),
                               .nodes = nodes,
                               .shape = {}};
            for (const int node : local) point.shape.push_back(values[node]);
            points_.push_back(std::move(point));
        }
    }
}

double ContactSurface::area() const {
    double area = 0;
    for (const SurfacePoint& point : points_) area += point.area;
    return area;
}

}  // namespace cleave::fem
