#include "reference_fem/contact.hpp"

#include "reference_fem/constraints.hpp"
#include "reference_fem/contact_law.hpp"
#include "reference_fem/nodal_forces.hpp"
#include "reference_fem/vector3.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <set>

namespace cleave::fem {
namespace {

using Vector = Eigen::VectorXd;

void check(const Indentation& indentation) {
    if (!(indentation.radius > 0)) throw Error("the indenter's radius must be positive");
    if (!(indentation.share > 0 && indentation.share <= 1)) throw Error("the body's share of the whole must be above 0 and at most 1");
    const bool punch = indentation.shape == Indentation::Shape::flat_punch;
    if (punch && !(indentation.depth > 0)) throw Error("a punch needs a positive depth");
    if (!punch && !(indentation.force > 0)) throw Error("a sphere needs a positive force");
}

/// The displacements of the outer surface, as those of the place half-way to the contact, halved.
class FarField {
public:
    FarField(const Solution::Data& data, const std::vector<BoundaryFace>& outer, const std::set<int>& held_by_symmetry) : data_(data) {
        std::set<int> seen;
        std::vector<double> values(data.space.nodes_per_cell());
        std::vector<Point> gradients(data.space.nodes_per_cell());
        for (const BoundaryFace& face : outer)
            for (int node = 0; node < data.space.nodes_per_cell(); ++node) {
                if (data.space.node_barycentrics()[node][face.opposite] != 0) continue;
                if (!seen.insert(data.space.dof(face.cell, node, 0)).second) continue;
                Point x{};
                for (int i = 0; i < 4; ++i) x = x + data.space.node_barycentrics()[node][i] * data.mesh.vertices[data.mesh.cells[face.cell][i]];
                const PointLocator::Place half = data.locate(0.5 * x);
                data.space.shape(half.unit, values, gradients);
                Node entry{.dofs = {}, .cell = half.cell, .shape = values};
                for (int i = 0; i < 3; ++i) {
                    const int dof = data.space.dof(face.cell, node, i);
                    entry.dofs[i] = held_by_symmetry.contains(dof) ? -1 : dof;
                }
                nodes_.push_back(std::move(entry));
            }
    }

    /// Sets the outer entries of `boundary` from the displacement; returns the largest change over the largest value.
    double update(const std::vector<double>& displacement, std::vector<double>& boundary) const {
        double change = 0, largest = 0;
        for (const Node& node : nodes_)
            for (int i = 0; i < 3; ++i) {
                if (node.dofs[i] < 0) continue;
                double value = 0;
                for (int a = 0; a < data_.space.nodes_per_cell(); ++a) value += 0.5 * node.shape[a] * displacement[data_.space.dof(node.cell, a, i)];
                change = std::max(change, std::abs(value - boundary[node.dofs[i]]));
                largest = std::max(largest, std::abs(value));
                boundary[node.dofs[i]] = value;
            }
        return change / largest;
    }

private:
    struct Node {
        std::array<int, 3> dofs{};
        int cell = 0;  // where half the place lies
        std::vector<double> shape;
    };
    const Solution::Data& data_;
    std::vector<Node> nodes_;
};

/// The outer surface is held at values that FarField finds; a punch holds the contact as well.
Problem held_problem(const Indentation& indentation) {
    Problem problem;
    problem.mesh_file = indentation.mesh_file;
    problem.displacements = indentation.symmetry;
    problem.displacements.push_back({indentation.outer, {true, true, true}, [](const Point&) { return Point{}; }});
    if (indentation.shape == Indentation::Shape::flat_punch)
        problem.displacements.push_back({indentation.contact, {false, false, true}, [depth = indentation.depth](const Point&) {
                                             return Point{0, 0, -depth};
                                         }});
    return problem;
}

std::set<int> symmetry_dofs(const Solution::Data& data, const FaceTable& faces, const std::vector<Displacement>& symmetry) {
    std::set<int> dofs;
    for (const Displacement& plane : symmetry)
        for (const BoundaryFace& face : faces.surface(plane.surface))
            for (int node = 0; node < data.space.nodes_per_cell(); ++node)
                if (data.space.node_barycentrics()[node][face.opposite] == 0)
                    for (int i = 0; i < 3; ++i)
                        if (plane.components[i]) dofs.insert(data.space.dof(face.cell, node, i));
    return dofs;
}

/// The factorised body.
class HalfSpaceBody {
public:
    HalfSpaceBody(Solution::Data& data, const FaceTable& faces, const Indentation& indentation)
        : data_(data),
          prescribed_(prescribe(held_problem(indentation), data.mesh, faces, data.space)),
          assembly_(assemble(data.space, data.materials, std::vector<double>(data.space.dofs(), 0.0), prescribed_)),
          factor_(assembly_.system),
          far_field_(data, faces.surface(indentation.outer), symmetry_dofs(data, faces, indentation.symmetry)) {
        for (int cell = 0; cell < static_cast<int>(data.mesh.cells.size()); ++cell)
            if (has_prescribed_dof(cell)) boundary_cells_.push_back(cell);
    }

    /// Prescribed displacements by dof, zero elsewhere, with the far field that belongs to the nodal loads. Of an error in it, half or less
    /// is left after each step.
    std::vector<double> boundary_under(const std::vector<double>& load) {
        std::vector<double> boundary(data_.space.dofs(), 0.0);
        for (const auto& [dof, value] : prescribed_) boundary[dof] = value;
        for (double change = 1; change > 1e-5; ++iterations_) {
            if (iterations_ == 60) throw Error("the far field did not settle: the outer surface must be far from the contact on every side");
            change = far_field_.update(displacement(load, boundary), boundary);
        }
        return boundary;
    }

    /// All displacements under nodal loads and prescribed values.
    std::vector<double> displacement(const std::vector<double>& load, const std::vector<double>& boundary) {
        data_.displacement = boundary;
        const std::vector<double> internal = internal_forces(data_, boundary_cells_);
        std::vector<double> right;
        for (const int dof : assembly_.free_dofs) right.push_back(load[dof] - internal[dof]);
        const std::vector<double> values = factor_.solve(right);
        std::vector<double> result = boundary;
        for (std::size_t row = 0; row < values.size(); ++row) result[assembly_.free_dofs[row]] = values[row];
        return result;
    }

    /// The block of the inverse at these dofs, all of them free.
    Eigen::MatrixXd compliance(const std::vector<int>& dofs) {
        std::vector<int> row_of(data_.space.dofs(), -1), rows;
        for (std::size_t row = 0; row < assembly_.free_dofs.size(); ++row) row_of[assembly_.free_dofs[row]] = static_cast<int>(row);
        for (const int dof : dofs) rows.push_back(row_of[dof]);
        const std::vector<double> block = factor_.inverse_block(rows);
        return Eigen::Map<const Eigen::MatrixXd>(block.data(), static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows.size()));
    }

    /// |load - internal| over the free dofs, over |internal|.
    double residual(const std::vector<double>& load, const std::vector<double>& internal) const {
        double rest = 0, size = 0;
        for (const int dof : assembly_.free_dofs) rest += std::pow(load[dof] - internal[dof], 2);
        for (const double force : internal) size += force * force;
        return std::sqrt(rest / size);
    }

    const PrescribedValues& prescribed() const { return prescribed_; }
    int far_field_iterations() const { return iterations_; }
    double bytes() const { return factor_.bytes(); }

private:
    bool has_prescribed_dof(int cell) const {
        for (int node = 0; node < data_.space.nodes_per_cell(); ++node)
            for (int i = 0; i < 3; ++i)
                if (prescribed_.contains(data_.space.dof(cell, node, i))) return true;
        return false;
    }

    Solution::Data& data_;
    PrescribedValues prescribed_;
    Assembly assembly_;
    DirectFactor factor_;
    FarField far_field_;
    std::vector<int> boundary_cells_;
    int iterations_ = 0;
};

/// Pressure at the centre: least squares of 1, x^2, xy, y^2 over half the contact radius. On Hertz's pressure this errs by 1e-3. The
/// largest pressure, where so few elements are in contact that the fit has too few points.
double peak_of(const std::vector<PressureSample>& samples, double contact_radius) {
    std::vector<const PressureSample*> inner;
    for (const PressureSample& sample : samples)
        if (std::hypot(sample.position[0], sample.position[1]) < contact_radius / 2) inner.push_back(&sample);
    const auto rows = static_cast<Eigen::Index>(inner.size());
    if (rows < 16)
        return std::max_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; })->pressure;
    Eigen::MatrixXd terms(rows, 4);
    Vector values(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double x = inner[i]->position[0] / contact_radius, y = inner[i]->position[1] / contact_radius, root = std::sqrt(inner[i]->area);
        terms.row(i) << root, root * x * x, root * x * y, root * y * y;
        values[i] = root * inner[i]->pressure;
    }
    return terms.completeOrthogonalDecomposition().solve(values)[0];
}

/// Where the pressure ends. At the edge of any smooth contact it falls like a square root, so its square is a straight line in r^2 there: fitted
/// between 0.6 and 0.95 of the radius of the area under pressure (whose own edge is as ragged as the elements), and followed to zero. With a few
/// elements only, where no such line shows, the radius of the area counts.
double edge_of(const std::vector<PressureSample>& samples, double area_radius) {
    double weight = 0, x_mean = 0, y_mean = 0, xx = 0, xy = 0;
    const auto visit = [&](const auto& use) {
        for (const PressureSample& sample : samples) {
            const double square = sample.position[0] * sample.position[0] + sample.position[1] * sample.position[1], t = std::sqrt(square) / area_radius;
            if (t > 0.6 && t < 0.95) use(sample.area, square, sample.pressure * sample.pressure);
        }
    };
    visit([&](double w, double x, double y) { weight += w, x_mean += w * x, y_mean += w * y; });
    x_mean /= weight, y_mean /= weight;
    visit([&](double w, double x, double y) { xx += w * (x - x_mean) * (x - x_mean), xy += w * (x - x_mean) * (y - y_mean); });
    const double square = x_mean - y_mean * xx / xy;
    return xy < 0 && square < 2 * area_radius * area_radius ? std::sqrt(square) : area_radius;
}

/// Fills what the contact's pressure tells.
void measure_pressure(const ContactSurface& surface, const std::vector<double>& pressure, double share, IndentationResult& result) {
    double area = 0, reach = 0, rim = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        const Point& x = surface.points()[i].position;
        rim = std::max(rim, std::hypot(x[0], x[1]));
        if (!(pressure[i] > 0)) continue;
        reach = std::max(reach, std::hypot(x[0], x[1]));
        area += surface.points()[i].area;
        result.pressure.push_back({x, surface.points()[i].area, pressure[i]});
    }
    if (reach > 0.95 * rim) throw Error("the contact reaches the rim of its surface; make that larger");
    result.contact_radius = edge_of(result.pressure, std::sqrt(area / (share * std::numbers::pi)));
    result.peak_pressure = peak_of(result.pressure, result.contact_radius);
}

Vector uniform_forces(const ContactSurface& surface) {
    Vector forces = Vector::Zero(static_cast<Eigen::Index>(surface.normal_dofs().size()));
    for (const auto& point : surface.points())
        for (std::size_t a = 0; a < point.nodes.size(); ++a) forces[point.nodes[a]] += point.area * point.shape[a] / surface.area();
    return forces;
}

std::vector<double> load_of(const Vector& forces, const ContactSurface& surface, int dofs) {
    std::vector<double> load(dofs, 0.0);
    for (Eigen::Index i = 0; i < forces.size(); ++i) load[surface.normal_dofs()[i]] = forces[i];
    return load;
}

/// Sets the displacement and the result's numbers; returns the nodal loads.
std::vector<double> press_punch(const Indentation& indentation, const ContactSurface& surface, HalfSpaceBody& body, Solution::Data& data,
                                IndentationResult& result) {
    const std::vector<double> no_load(data.space.dofs(), 0.0);
    data.displacement = body.displacement(no_load, body.boundary_under(no_load));
    result.depth = indentation.depth;
    result.iterations = 1;
    result.contact_radius = std::sqrt(surface.area() / (indentation.share * std::numbers::pi));
    return no_load;
}

std::vector<double> press_sphere(const Indentation& indentation, const ContactSurface& surface, HalfSpaceBody& body, Solution::Data& data,
                                 IndentationResult& result) {
    const int dofs = data.space.dofs();
    const Vector uniform = uniform_forces(surface);
    std::vector<double> far_boundary = body.boundary_under(load_of(-uniform, surface, dofs));  // under 1 N
    const std::vector<double> far = body.displacement(std::vector<double>(dofs, 0.0), far_boundary);
    CondensedBody condensed{body.compliance(surface.normal_dofs()), Vector(uniform.size())};
    for (Eigen::Index i = 0; i < uniform.size(); ++i) condensed.far_field[i] = far[surface.normal_dofs()[i]];

    // 1000 times the mean pressure over the mean displacement under a uniform pressure on the whole surface.
    const double penalty = 1000 / (surface.area() * uniform.dot(condensed.compliance * uniform));
    const double force = indentation.share * indentation.force;
    const ContactState state = press_paraboloid(condensed, surface, indentation.radius, force, penalty);
    const Vector top = condensed.compliance * state.forces + condensed.far_field * force;
    measure_pressure(surface, penalty_pressure(surface, top, indentation.radius, state.depth, penalty), indentation.share, result);
    result.depth = state.depth;
    result.iterations = state.iterations;
    for (double& value : far_boundary) value *= force;
    std::vector<double> load = load_of(state.forces, surface, dofs);
    data.displacement = body.displacement(load, far_boundary);
    return load;
}

}  // namespace

IndentationResult solve_indentation(const Indentation& indentation, const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    check(indentation);
    Mesh mesh = read_msh(indentation.mesh_file);
    check_cells(mesh);
    const auto data = std::make_shared<Solution::Data>(std::move(mesh), options, indentation.regions);
    const FaceTable faces(data->mesh);
    const ContactSurface surface(faces.surface(indentation.contact), data->mesh, data->space);
    HalfSpaceBody body(*data, faces, indentation);

    IndentationResult result{.solution = Solution(data), .pressure = {}};
    const bool punch = indentation.shape == Indentation::Shape::flat_punch;
    const std::vector<double> load = punch ? press_punch(indentation, surface, body, *data, result) : press_sphere(indentation, surface, body, *data, result);
    const std::vector<double> internal = add_energies(*data, load, body.prescribed());
    for (const int dof : surface.normal_dofs()) result.force -= internal[dof] / indentation.share;
    result.far_field_iterations = body.far_field_iterations();
    data->record = {.cells = static_cast<long>(data->mesh.cells.size()),
                    .dofs = data->space.dofs(),
                    .solver = "cholmod",
                    .iterations = result.iterations,
                    .relative_residual = body.residual(load, internal),
                    .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                    .matrix_bytes = body.bytes()};
    return result;
}

}  // namespace cleave::fem
