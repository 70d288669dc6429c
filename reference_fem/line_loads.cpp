#include "reference_fem/line_loads.hpp"

#include "reference_fem/vector3.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cleave::fem {
namespace {

struct GaussPoint {
    double position, weight;  // on the unit interval
};

/// Exact to degree 5.
std::array<GaussPoint, 3> gauss_points() {
    const double offset = 0.5 * std::sqrt(0.6);
    return {{{0.5 - offset, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + offset, 5.0 / 18}}};
}

/// Lagrange's polynomials of the nodes of Discretization::edge_nodes: ends, then midpoint.
std::array<double, 3> shape(double s, std::size_t nodes) {
    if (nodes == 2) return {1 - s, s, 0};
    return {(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)};
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

}  // namespace

void add_line_loads(const std::vector<LineLoad>& line_loads, const Mesh& mesh, const FaceTable& faces, const Discretization& space,
                    std::vector<double>& load) {
    for (const LineLoad& line : line_loads) {
        const std::string name = fmt::format("line of the surfaces {} and {}", line.line.first, line.line.second);
        if (!line.value) throw Error(fmt::format("{}: a load without a value", name));
        for (const BoundaryEdge& edge : faces.line(line.line)) {
            const std::vector<int> nodes = space.edge_nodes(edge.ends);
            const Point &a = mesh.vertices[mesh.cells[edge.cell][edge.ends[0]]], &b = mesh.vertices[mesh.cells[edge.cell][edge.ends[1]]];
            for (const GaussPoint& point : gauss_points()) {
                const Point force = line.value((1 - point.position) * a + point.position * b);
                if (!is_finite(force)) throw Error(fmt::format("{}: a load is not finite", name));
                const auto phi = shape(point.position, nodes.size());
                for (std::size_t n = 0; n < nodes.size(); ++n)
                    for (int i = 0; i < 3; ++i) load[space.dof(edge.cell, nodes[n], i)] += point.weight * norm(b - a) * phi[n] * force[i];
            }
        }
    }
}

}  // namespace cleave::fem
