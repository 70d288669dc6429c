#include "reference_fem/contact_law.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace cleave::fem {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Forces of the penalty, and their derivatives with respect to displacement and depth. The overlap at a point is
/// g = w - (r^2 / (2 R) - depth): the top, moved up by w, above the paraboloid.
struct Penalty {
    Vector force;     // of the body on the indenter by node, N: int penalty max(0, g) phi
    Matrix by_place;  // int penalty H(g) phi phi^T
    Vector by_depth;  // int penalty H(g) phi
};

Penalty evaluate(const ContactSurface& surface, const Vector& displacement, double radius, double depth, double penalty) {
    const Eigen::Index size = displacement.size();
    Penalty result{Vector::Zero(size), Matrix::Zero(size, size), Vector::Zero(size)};
    const std::vector<double> pressure = penalty_pressure(surface, displacement, radius, depth, penalty);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        const ContactSurface::SurfacePoint& point = surface.points()[i];
        for (std::size_t a = 0; a < point.nodes.size(); ++a) {
            const double weight = point.area * point.shape[a];
            result.force[point.nodes[a]] += weight * pressure[i];
            result.by_depth[point.nodes[a]] += weight * penalty;
            for (std::size_t b = 0; b < point.nodes.size(); ++b) result.by_place(point.nodes[a], point.nodes[b]) += weight * penalty * point.shape[b];
        }
    }
    return result;
}

}  // namespace

std::vector<double> penalty_pressure(const ContactSurface& surface, const Vector& displacement, double radius, double depth, double penalty) {
    std::vector<double> pressure;
    for (const ContactSurface::SurfacePoint& point : surface.points()) {
        const double square = point.position[0] * point.position[0] + point.position[1] * point.position[1];
        double overlap = depth - square / (2 * radius);
        for (std::size_t a = 0; a < point.nodes.size(); ++a) overlap += point.shape[a] * displacement[point.nodes[a]];
        pressure.push_back(penalty * std::max(0.0, overlap));
    }
    return pressure;
}

ContactState press_paraboloid(const CondensedBody& body, const ContactSurface& surface, double radius, double force, double penalty) {
    const Eigen::Index size = body.far_field.size();
    // Unknowns: displacements, then depth. Residuals: w + S q - g sum(q) (q = -f, the forces on the indenter), and sum(q) - force.
    const auto residual = [&](const Vector& unknown, const Penalty& law) {
        Vector result(size + 1);
        result.head(size) = unknown.head(size) + body.compliance * law.force - body.far_field * law.force.sum();
        result[size] = law.force.sum() - force;
        return result;
    };
    // In metres, all of them: the force through the compliance of the first node.
    const double compliance = body.compliance(0, 0);
    const auto magnitude = [&](const Vector& r) { return std::hypot(r.head(size).norm() / std::sqrt(size), compliance * r[size]); };
    Vector unknown = Vector::Zero(size + 1);
    double reach = 0;
    for (const auto& point : surface.points()) reach = std::max(reach, std::hypot(point.position[0], point.position[1]));
    unknown[size] = reach * reach / (8 * radius);  // half of the surface is under pressure to begin with
    Penalty law = evaluate(surface, unknown.head(size), radius, unknown[size], penalty);
    for (int iteration = 1; iteration <= 60; ++iteration) {
        const Vector rest = residual(unknown, law);
        Matrix jacobian(size + 1, size + 1);
        const auto of = [&](const auto& change) { return body.compliance * change - body.far_field * change.colwise().sum(); };
        jacobian.topLeftCorner(size, size) = Matrix::Identity(size, size) + of(law.by_place);
        jacobian.topRightCorner(size, 1) = of(Matrix(law.by_depth));
        jacobian.bottomLeftCorner(1, size) = law.by_place.colwise().sum();
        jacobian(size, size) = law.by_depth.sum();
        const Vector step = jacobian.partialPivLu().solve(-rest);
        double length = 1;
        Vector next = unknown + step;
        law = evaluate(surface, next.head(size), radius, next[size], penalty);
        while (magnitude(residual(next, law)) > magnitude(rest) && length > 0.02) {
            length /= 2;
            next = unknown + length * step;
            law = evaluate(surface, next.head(size), radius, next[size], penalty);
        }
        unknown = next;
        if (magnitude(residual(unknown, law)) < 1e-10 * std::abs(unknown[size])) return {-law.force, unknown[size], iteration};
    }
    throw Error("the contact did not settle in 60 steps of Newton's method");
}

}  // namespace cleave::fem
