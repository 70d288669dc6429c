#include "validation/symmetry_class.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::validation {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using std::numbers::pi;

constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

/// Kelvin's matrix: orthonormal basis of the symmetric tensors, so that an orthogonal map of space is an orthogonal matrix.
Matrix6d kelvin(const material::Stiffness& stiffness) {
    Matrix6d result = stiffness;
    result.topRightCorner<3, 3>() *= std::sqrt(2.0);
    result.bottomLeftCorner<3, 3>() *= std::sqrt(2.0);
    result.bottomRightCorner<3, 3>() *= 2;
    return result;
}

Matrix6d kelvin_map(const Matrix3d& q) {
    Matrix6d result;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            const auto [a, b] = pairs[i];
            const auto [c, d] = pairs[j];
            const double scale = (i < 3 ? 1 : std::sqrt(2.0)) * (j < 3 ? 1 : std::sqrt(2.0)) / 2;
            result(i, j) = scale * (q(a, c) * q(b, d) + q(a, d) * q(b, c));
        }
    return result;
}

/// Relative change of the tensor when space is mirrored in the plane with normal n.
double mirror_change(const Matrix6d& tensor, const Vector3d& n) {
    const Matrix6d map = kelvin_map(Matrix3d::Identity() - 2 * n * n.transpose());
    return (map * tensor * map.transpose() - tensor).norm() / tensor.norm();
}

/// Walks downhill in ever smaller steps across n; stops at a mirror, gives up early where that leads nowhere.
Vector3d refined(const Matrix6d& tensor, Vector3d n, double tolerance) {
    double best = mirror_change(tensor, n);
    for (double step = 0.05; best > tolerance / 2 && step > 1e-6 && best < tolerance + 20 * step;) {
        const Vector3d a = n.unitOrthogonal(), b = n.cross(a);
        Vector3d better = n;
        for (int k = 0; k < 8; ++k) {
            const Vector3d tried = (n + step * (std::cos(pi * k / 4) * a + std::sin(pi * k / 4) * b)).normalized();
            if (const double change = mirror_change(tensor, tried); change < best) best = change, better = tried;
        }
        if (better == n) step /= 2;
        n = better;
    }
    return n;
}

/// Directions over half the sphere, some 7 degrees apart (a spiral).
std::vector<Vector3d> half_sphere() {
    constexpr int count = 400;
    std::vector<Vector3d> directions;
    for (int i = 0; i < count; ++i) {
        const double z = (i + 0.5) / count, r = std::sqrt(1 - z * z), phi = i * pi * (3 - std::sqrt(5.0));
        directions.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
    return directions;
}

/// Normals of the planes of mirror symmetry, each once; more than `enough` stand for infinitely many.
std::vector<Vector3d> mirror_normals(const Matrix6d& tensor, double tolerance, std::size_t enough) {
    std::vector<Vector3d> normals;
    for (const Vector3d& start : half_sphere()) {
        const Vector3d n = refined(tensor, start, tolerance);
        if (mirror_change(tensor, n) > tolerance) continue;
        const bool known = std::any_of(normals.begin(), normals.end(), [&](const Vector3d& m) { return std::abs(m.dot(n)) > std::cos(pi / 30); });
        if (!known) normals.push_back(n);
        if (normals.size() > enough) break;
    }
    return normals;
}

bool orthogonal(const std::vector<Vector3d>& normals) {
    for (std::size_t i = 0; i < normals.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(normals[i].dot(normals[j])) > 0.1) return false;
    return true;
}

/// Distance to the nearest isotropic tensor (the mean over all rotations: Kelvin's 3K once, 2G five times), relative.
double distance_to_isotropy(const Matrix6d& tensor) {
    Matrix6d spherical = Matrix6d::Zero();
    spherical.topLeftCorner<3, 3>().setConstant(1.0 / 3);
    const Matrix6d deviatoric = Matrix6d::Identity() - spherical;
    const Matrix6d nearest = (spherical * tensor).trace() * spherical + (deviatoric * tensor).trace() / 5 * deviatoric;
    return (tensor - nearest).norm() / tensor.norm();
}

/// Infinitely many planes: about one axis, or about all. Three mirrors that are no plane of a transversely isotropic tensor tell.
std::string round_class(const Matrix6d& tensor, double tolerance) {
    for (const Vector3d& n : half_sphere())
        if (mirror_change(tensor, n) > tolerance) return "transversely isotropic";
    return "isotropic";
}

}  // namespace

const std::vector<std::string>& symmetry_classes() {
    static const std::vector<std::string> classes{"triclinic", "monoclinic", "orthotropic", "trigonal", "tetragonal", "transversely isotropic", "cubic", "isotropic"};
    return classes;
}

std::string symmetry_class(const material::Stiffness& stiffness, double tolerance) {
    const Matrix6d tensor = kelvin(stiffness / stiffness.cwiseAbs().maxCoeff());  // norms square: 1e160 Pa would overflow
    const double anisotropy = distance_to_isotropy(tensor);
    if (anisotropy < tolerance) return "isotropic";
    // Mirroring changes the anisotropic part only, by at most twice its size: where that is small, a fixed tolerance would accept planes that
    // are none.
    tolerance = std::min(tolerance, anisotropy / 4);
    const std::vector<Vector3d> normals = mirror_normals(tensor, tolerance, 9);
    switch (normals.size()) {
        case 0: return "triclinic";
        case 1: return "monoclinic";
        case 2:  // two orthogonal mirrors imply the third
        case 3: return orthogonal(normals) ? "orthotropic" : "trigonal";
        case 4:
        case 5: return "tetragonal";
        case 6:
        case 7:
        case 8:
        case 9: return "cubic";
        default: return round_class(tensor, tolerance);
    }
}

}  // namespace cleave::validation
