#include "solver/elasticity/equilibrium_cg.hpp"

#include <cmath>

namespace cleave::elasticity {

namespace {

/// a += factor b.
void add(Vectors& a, double factor, const Vectors& b) {
    parallel_for_each(static_cast<int>(a.size()), [&](int i) { a[i] += factor * b[i]; });
}

/// r = b - K x.
void residual_of(const LinearSystem& system, const Vectors& b, const Vectors& x, Vectors& r) {
    system.apply(x, r);
    parallel_for_each(static_cast<int>(b.size()), [&](int i) { r[i] = b[i] - r[i]; });
    if (system.project) system.project(r);
}

}  // namespace

CgResult conjugate_gradients(const LinearSystem& system, const Vectors& b, Vectors& x, double tolerance, int max_iterations) {
    const int size = static_cast<int>(b.size());
    const double scale = std::sqrt(dot(b, b));
    if (scale == 0) {
        x.assign(b.size(), Eigen::Vector3d::Zero());
        return {};
    }
    Vectors r(b.size()), z(b.size()), p(b.size(), Eigen::Vector3d::Zero()), q(b.size());
    residual_of(system, b, x, r);
    CgResult result;
    double rz = 0;
    while (std::sqrt(dot(r, r)) > tolerance * scale && result.iterations < max_iterations) {
        system.precondition(r, z);
        if (system.project) system.project(z);
        const double next = dot(r, z), beta = result.iterations == 0 ? 0 : next / rz;
        rz = next;
        parallel_for_each(size, [&](int i) { p[i] = z[i] + beta * p[i]; });
        system.apply(p, q);
        const double step = rz / dot(p, q);
        add(x, step, p);
        add(r, -step, q);
        ++result.iterations;
    }
    residual_of(system, b, x, r);
    result.residual = std::sqrt(dot(r, r)) / scale;
    return result;
}

}  // namespace cleave::elasticity
