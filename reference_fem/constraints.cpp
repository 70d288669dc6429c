#include "reference_fem/constraints.hpp"

#include "reference_fem/vector3.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

using Rigid = Eigen::Matrix<double, 6, 1>;

constexpr char axis_name[] = "xyz";

struct Prescribed {
    double value = 0;
    Point position{};
    int component = 0;
    int cell = 0;
};

/// Gathers prescribed components; the first condition on a dof wins, later ones must agree.
class Collector {
public:
    Collector(const Mesh& mesh, const Discretization& space) : mesh_(mesh), space_(space) {}

    void add(const Displacement& displacement, const std::vector<BoundaryFace>& faces) {
        const std::string name = fmt::format("surface {}", displacement.surface);
        if (!displacement.value) throw Error(fmt::format("{}: a displacement without a value", name));
        for (const BoundaryFace& face : faces)
            for (int node = 0; node < space_.nodes_per_cell(); ++node)
                if (space_.node_barycentrics()[node][face.opposite] == 0) {
                    const Point position = node_position(face.cell, node);
                    add_node(face.cell, node, position, displacement.components, displacement.value(position), name);
                }
    }

    void add(const LineDisplacement& displacement, const std::vector<BoundaryEdge>& edges) {
        const std::string name = fmt::format("line of the surfaces {} and {}", displacement.line.first, displacement.line.second);
        if (!displacement.value) throw Error(fmt::format("{}: a displacement without a value", name));
        for (const BoundaryEdge& edge : edges)
            for (const int node : space_.edge_nodes(edge.ends)) {
                const Point position = node_position(edge.cell, node);
                add_node(edge.cell, node, position, displacement.components, displacement.value(position), name);
            }
    }

    void add(const Support& support) {
        int best_cell = 0, best_vertex = 0;
        double best = INFINITY;
        for (int cell = 0; cell < static_cast<int>(mesh_.cells.size()); ++cell)
            for (int vertex = 0; vertex < 4; ++vertex) {
                const double distance = norm(mesh_.vertices[mesh_.cells[cell][vertex]] - support.point);
                if (distance < best) best = distance, best_cell = cell, best_vertex = vertex;
            }
        add_node(best_cell, best_vertex, node_position(best_cell, best_vertex), support.components, support.value, "support");
    }

    const std::map<int, Prescribed>& by_dof() const { return by_dof_; }

    /// Called once all are in, since the scale of the values is only known then.
    void check_agreement() const {
        for (const auto& [dof, other, name] : repeated_) {
            const Prescribed& first = by_dof_.at(dof);
            if (std::abs(first.value - other) > 1e-8 * largest_)
                throw Error(fmt::format("{}: u_{} = {:g} m at ({:g}, {:g}, {:g}) contradicts another condition, which says {:g} m", name,
                                        axis_name[first.component], other, first.position[0], first.position[1], first.position[2],
                                        first.value));
        }
    }

private:
    Point node_position(int cell, int node) const {
        Point position{};
        for (int vertex = 0; vertex < 4; ++vertex)
            position = position + space_.node_barycentrics()[node][vertex] * mesh_.vertices[mesh_.cells[cell][vertex]];
        return position;
    }

    void add_node(int cell, int node, const Point& position, const std::array<bool, 3>& components, const Point& value,
                  const std::string& name) {
        for (int component = 0; component < 3; ++component) {
            if (!components[component]) continue;
            if (!std::isfinite(value[component])) throw Error(fmt::format("{}: a prescribed displacement is not finite", name));
            largest_ = std::max(largest_, std::abs(value[component]));
            const int dof = space_.dof(cell, node, component);
            if (!by_dof_.emplace(dof, Prescribed{value[component], position, component, cell}).second)
                if (by_dof_.at(dof).value != value[component]) repeated_.push_back({dof, value[component], name});
        }
    }

    struct Repeated {
        int dof;
        double value;
        std::string name;
    };
    const Mesh& mesh_;
    const Discretization& space_;
    std::map<int, Prescribed> by_dof_;
    std::vector<Repeated> repeated_;
    double largest_ = 0;
};

/// What each unit rigid motion (3 translations, 3 rotations about `centre`, scaled to unit displacement at distance `size`) does to a
/// component.
Rigid rigid_row(const Prescribed& held, const Point& centre, double size) {
    Rigid row = Rigid::Zero();
    row[held.component] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        Point rotation{};
        rotation[axis] = 1 / size;
        row[3 + axis] = cross(rotation, held.position - centre)[held.component];
    }
    return row;
}

struct Part {
    Point centre{};
    double size = 0;
    Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
};

std::vector<Part> measure_parts(const Mesh& mesh, const std::vector<int>& part_of_cell) {
    std::vector<Point> low, high;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
        const std::size_t part = part_of_cell[cell];
        if (part == low.size()) low.push_back({INFINITY, INFINITY, INFINITY}), high.push_back({-INFINITY, -INFINITY, -INFINITY});
        for (const int vertex : mesh.cells[cell])
            for (int i = 0; i < 3; ++i) {
                low[part][i] = std::min(low[part][i], mesh.vertices[vertex][i]);
                high[part][i] = std::max(high[part][i], mesh.vertices[vertex][i]);
            }
    }
    std::vector<Part> parts(low.size());
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = {.centre = 0.5 * (low[i] + high[i]), .size = 0.5 * norm(high[i] - low[i])};
    return parts;
}

/// The Gram matrix of the rigid rows of each part must have full rank. 1e-10 is a ratio of 1e-5 between held motions: supports
/// 1e-5 of the part's size apart still count as apart.
void check_held(const Mesh& mesh, const std::map<int, Prescribed>& by_dof) {
    const std::vector<int> part_of_cell = connected_parts(mesh);
    std::vector<Part> parts = measure_parts(mesh, part_of_cell);
    for (const auto& [dof, held] : by_dof) {
        Part& part = parts[part_of_cell[held.cell]];
        const Rigid row = rigid_row(held, part.centre, part.size);
        part.gram += row * row.transpose();
    }
    for (const Part& part : parts) {
        const Rigid values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(part.gram, Eigen::EigenvaluesOnly).eigenvalues();
        const auto loose = (values.array() <= 1e-10 * std::max(values[5], 1.0)).count();
        if (loose > 0)
            throw Error(fmt::format("{}: {} can still move rigidly in {} of 6 ways; hold it by displacements", mesh.file,
                                    parts.size() == 1
                                        ? "the body"
                                        : fmt::format("the part around ({:g}, {:g}, {:g})", part.centre[0], part.centre[1], part.centre[2]),
                                    loose));
    }
}

}  // namespace

PrescribedValues prescribe(const Problem& problem, const Mesh& mesh, const FaceTable& faces, const Discretization& space) {
    Collector collector(mesh, space);
    for (const Displacement& displacement : problem.displacements) collector.add(displacement, faces.surface(displacement.surface));
    for (const LineDisplacement& displacement : problem.line_displacements)
        collector.add(displacement, faces.line(displacement.line));
    for (const Support& support : problem.supports) collector.add(support);
    collector.check_agreement();
    check_held(mesh, collector.by_dof());
    PrescribedValues values;
    for (const auto& [dof, held] : collector.by_dof()) values.emplace(dof, held.value);
    return values;
}

}  // namespace cleave::fem
