#include "reference_fem/near_tip.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <complex>
#include <numbers>

namespace cleave::fem {
namespace {

using Complex = std::complex<double>;

/// Lame's lambda and mu of an isotropic stiffness.
struct Lame {
    double lambda, mu;
};

bool is_isotropic(const Stiffness& c) {
    const Lame lame{c[0][1], c[3][3]};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            const double expected = i < 3 && j < 3 ? lame.lambda + (i == j ? 2 * lame.mu : 0) : (i == j ? lame.mu : 0);
            if (std::abs(c[i][j] - expected) > 1e-6 * c[0][0]) return false;
        }
    return true;
}

/// Williams' fields in polar form: u = sqrt(r / 2 pi) f(theta) / (2 mu), so du/dr = u / (2 r) and du/dtheta = sqrt(r / 2 pi) f' / (2 mu).
class IsotropicTip final : public NearTip {
public:
    explicit IsotropicTip(const Lame& lame) : mu_(lame.mu), kappa_(3 - 2 * lame.lambda / (lame.lambda + lame.mu)) {}

    State at(double x1, double x2) const override {
        const double r = std::hypot(x1, x2), angle = std::atan2(x2, x1);
        const auto [f, slope] = shapes(angle);
        const double size = std::sqrt(r / (2 * std::numbers::pi)) / (2 * mu_), c = std::cos(angle), s = std::sin(angle);
        State state;
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i) {
                state.displacement[mode][i] = size * f[mode][i];
                const double outward = size * f[mode][i] / (2 * r), around = size * slope[mode][i] / r;
                state.slope[mode][0][i] = c * outward - s * around;
                state.slope[mode][1][i] = s * outward + c * around;
            }
        return state;
    }

    /// (1 - nu^2) / E = (kappa + 1) / (8 mu) in the plane, (1 + nu) / E = 1 / (2 mu) along the front; G = k L^-1 k / 2.
    Tensor compliance() const override {
        Tensor result{};
        result[0][0] = result[1][1] = (kappa_ + 1) / (4 * mu_);
        result[2][2] = 1 / mu_;
        return result;
    }

private:
    struct Shapes {
        std::array<Point, 3> f, slope;
    };
    Shapes shapes(double angle) const {
        const double c = std::cos(angle / 2), s = std::sin(angle / 2), k = kappa_;
        Shapes shapes;
        shapes.f[0] = {s * (k + 1 + 2 * c * c), -c * (k - 1 - 2 * s * s), 0};
        shapes.f[1] = {c * (k - 1 + 2 * s * s), s * (k + 1 - 2 * c * c), 0};
        shapes.f[2] = {0, 0, 4 * s};
        shapes.slope[0] = {c / 2 * (k + 1 + 2 * c * c) - 2 * s * s * c, s / 2 * (k - 1 - 2 * s * s) + 2 * c * c * s, 0};
        shapes.slope[1] = {-s / 2 * (k - 1 + 2 * s * s) + 2 * c * c * s, c / 2 * (k + 1 - 2 * c * c) + 2 * s * s * c, 0};
        shapes.slope[2] = {0, 0, 2 * c};
        return shapes;
    }
    double mu_, kappa_;  // kappa = 3 - 4 nu, nu = lambda / (2 (lambda + mu))
};

/// u = Re A <sqrt(2 z / pi)> B^-1 k with z_a = x1 + p_a x2: the stress function with B in place of A is sqrt(2 r / pi) k ahead and zero on
/// the lips.
class StrohTip final : public NearTip {
public:
    explicit StrohTip(const Stiffness& stiffness) {
        if (set(stiffness)) return;
        Stiffness parted = stiffness;
        for (int i = 0; i < 6; ++i) parted[i][i] *= 1 + 1e-7 * (i + 1);
        if (!set(parted)) throw Error("a stiffness whose Stroh eigenvalues cannot be told apart");
    }

    State at(double x1, double x2) const override {
        std::array<Complex, 3> root, slope;
        for (int a = 0; a < 3; ++a) {
            root[a] = std::sqrt(2 / std::numbers::pi * (x1 + p_[a] * x2));
            slope[a] = 1.0 / (std::numbers::pi * root[a]);
        }
        State state;
        for (int mode = 0; mode < 3; ++mode)
            for (int i = 0; i < 3; ++i) {
                Complex u = 0, first = 0, second = 0;
                for (int a = 0; a < 3; ++a) {
                    const Complex weight = A_(i, a) * B_inverse_(a, mode);
                    u += weight * root[a];
                    first += weight * slope[a];
                    second += weight * slope[a] * p_[a];
                }
                state.displacement[mode][i] = u.real();
                state.slope[mode][0][i] = first.real();
                state.slope[mode][1][i] = second.real();
            }
        return state;
    }

    /// A B^-1 = S L^-1 - i L^-1 up to the sign of its real part (Ting 1996, Eq. 6.7-14).
    Tensor compliance() const override {
        const Eigen::Matrix3cd product = A_ * B_inverse_;
        Tensor result{};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result[i][j] = -(product(i, j).imag() + product(j, i).imag()) / 2;
        return result;
    }

private:
    /// False where the eigenvectors nearly coincide.
    bool set(const Stiffness& stiffness) {
        const double scale = stiffness[3][3];
        Eigen::Matrix3d Q, R, T;  // Q_ik = C_i1k1, R_ik = C_i1k2, T_ik = C_i2k2
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) {
                Q(i, k) = stiffness[voigt_index(i, 0)][voigt_index(k, 0)] / scale;
                R(i, k) = stiffness[voigt_index(i, 0)][voigt_index(k, 1)] / scale;
                T(i, k) = stiffness[voigt_index(i, 1)][voigt_index(k, 1)] / scale;
            }
        const Eigen::Matrix3d inverse = T.inverse();
        Eigen::Matrix<double, 6, 6> N;
        N << -inverse * R.transpose(), inverse, R * inverse * R.transpose() - Q, -R * inverse;
        const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> eigen(N);
        Eigen::Matrix3cd A, B;
        int found = 0;
        for (int k = 0; k < 6 && found < 3; ++k) {
            if (!(eigen.eigenvalues()[k].imag() > 0)) continue;
            p_[found] = eigen.eigenvalues()[k];
            A.col(found) = eigen.eigenvectors().col(k).head<3>() / scale;
            B.col(found) = eigen.eigenvectors().col(k).tail<3>();
            ++found;
        }
        const Eigen::Vector3d sizes = Eigen::JacobiSVD<Eigen::Matrix3cd>(B).singularValues();
        if (found < 3 || !(sizes[2] > 1e-5 * sizes[0])) return false;
        A_ = A;
        B_inverse_ = B.inverse();
        return true;
    }

    std::array<Complex, 3> p_{};
    Eigen::Matrix3cd A_, B_inverse_;
};

}  // namespace

std::shared_ptr<const NearTip> near_tip(const Stiffness& stiffness, TipForm form) {
    const bool isotropic = is_isotropic(stiffness);
    if (form == TipForm::isotropic && !isotropic) throw Error("isotropic crack-tip fields for a stiffness that is not isotropic");
    if (form == TipForm::stroh || !isotropic) return std::make_shared<StrohTip>(stiffness);
    return std::make_shared<IsotropicTip>(Lame{stiffness[0][1], stiffness[3][3]});
}

Stiffness in_axes(const Elasticity& material, const std::array<Point, 3>& axes) {
    constexpr std::array<std::array<int, 2>, 6> pair{{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
    Stiffness turned{};
    for (int I = 0; I < 6; ++I)
        for (int J = 0; J < 6; ++J) {
            const auto [i, j] = pair[I];
            const auto [k, l] = pair[J];
            for (int p = 0; p < 3; ++p)
                for (int q = 0; q < 3; ++q)
                    for (int r = 0; r < 3; ++r)
                        for (int s = 0; s < 3; ++s) turned[I][J] += axes[i][p] * axes[j][q] * axes[k][r] * axes[l][s] * material(p, q, r, s);
        }
    return turned;
}

double energy_release(const NearTip& tip, const Intensities& k) {
    const Tensor compliance = tip.compliance();
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += k[i] * compliance[i][j] * k[j] / 2;
    return sum;
}

}  // namespace cleave::fem
