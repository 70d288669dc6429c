#include "solver/fragments/mass_properties.hpp"

namespace cleave::fragments {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d centre_of_mass(const FragmentedBody& body, const Fragment& fragment, const std::function<double(int)>& density, MassProperties& out) {
    // About the first centroid, not the origin: a fragment far away must not lose digits.
    const Vector3d near = fragment.particles.empty() ? Vector3d::Zero().eval() : body.centroid(fragment.particles.front());
    Vector3d moment = Vector3d::Zero();
    for (const int particle : fragment.particles) {
        const double volume = body.volume(particle), mass = density(body.parent(particle)) * volume;
        out.volume += volume;
        out.mass += mass;
        moment += mass * (body.centroid(particle) - near);
    }
    return out.mass > 0 ? (near + moment / out.mass).eval() : near;
}

/// Second moments of a tet of mass m about the point x: m (c - x)(c - x)^T + m/20 sum_i (x_i - c)(x_i - c)^T.
Matrix3d second_moments(const FragmentedBody& body, int particle, double mass, const Vector3d& x) {
    const Vector3d c = body.centroid(particle);
    Matrix3d corners = Matrix3d::Zero();
    for (const int vertex : body.vertices(particle)) {
        const Vector3d arm = body.point(vertex) - c;
        corners += arm * arm.transpose();
    }
    return mass * ((c - x) * (c - x).transpose() + corners / 20);
}

}  // namespace

MassProperties mass_properties(const FragmentedBody& body, const Fragment& fragment, const std::function<double(int)>& density) {
    MassProperties out;
    out.centre = centre_of_mass(body, fragment, density, out);
    Matrix3d second = Matrix3d::Zero();
    for (const int particle : fragment.particles) {
        second += second_moments(body, particle, density(body.parent(particle)) * body.volume(particle), out.centre);
    }
    out.inertia = second.trace() * Matrix3d::Identity() - second;
    return out;
}

}  // namespace cleave::fragments
