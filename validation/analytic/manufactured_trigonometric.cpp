#include "validation/analytic/manufactured_trigonometric.hpp"

#include <cmath>

namespace cleave::analytic {

namespace {

struct Waves {
    double length;
    // |q| of 3.8 to 4.1: about two thirds of a wave over the length, smooth enough for coarse meshes.
    std::array<Point, 3> vector{{{3.1, 1.7, -1.3}, {-1.1, 2.9, 2.1}, {1.9, -1.5, 3.3}}};
    Point phase{0.3, 1.1, -0.7};
    Point amplitude{1.0e-3, 0.8e-3, 1.2e-3};

    double argument(std::size_t k, const Point& x) const {
        return (vector[k][0] * x[0] + vector[k][1] * x[1] + vector[k][2] * x[2]) / length + phase[k];
    }
    Point displacement(const Point& x) const {
        Point u{};
        for (std::size_t k = 0; k < 3; ++k) u[k] = amplitude[k] * length * std::sin(argument(k, x));
        return u;
    }
    Gradient gradient(const Point& x) const {
        Gradient g{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; l < 3; ++l) g[k][l] = amplitude[k] * vector[k][l] * std::cos(argument(k, x));
        return g;
    }
    Point body_force(const Stiffness& stiffness, const Point& x) const {
        Point force{};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k < 3; ++k)
                    for (int l = 0; l < 3; ++l) {
                        const auto K = static_cast<std::size_t>(k), J = static_cast<std::size_t>(j), L = static_cast<std::size_t>(l);
                        // u_k,lj = -A_k q_l q_j / L sin(.), and f_i = -C_ijkl u_k,lj
                        force[static_cast<std::size_t>(i)] += component(stiffness, i, j, k, l) * amplitude[K] / length *
                                                              vector[K][L] * vector[K][J] * std::sin(argument(K, x));
                    }
        return force;
    }
};

}  // namespace

Field manufactured_trigonometric(const Stiffness& stiffness, double length, double scale) {
    Waves waves{length};
    for (double& amplitude : waves.amplitude) amplitude *= scale;
    Field field;
    field.displacement = [waves](const Point& x) { return waves.displacement(x); };
    field.gradient = [waves](const Point& x) { return waves.gradient(x); };
    field.stress = [waves, stiffness](const Point& x) { return stress_of(stiffness, waves.gradient(x)); };
    field.body_force = [waves, stiffness](const Point& x) { return waves.body_force(stiffness, x); };
    field.source = "manufactured plane waves (method: Roache 2002)";
    return field;
}

}  // namespace cleave::analytic
