#pragma once

#include "solver/material/stiffness.hpp"

#include <array>
#include <complex>
#include <memory>
#include <mutex>
#include <vector>

namespace cleave::contact {

/// Stroh's eigenvalues and matrices of one direction m = (cos phi, sin phi, 0) of a surface with normal n = z into the body: roots p with
/// Im p > 0, and W_alpha = a_alpha (row alpha of B^-1), so that A diag(f(p)) B^-1 = sum of f(p_alpha) W_alpha.
struct StrohDirection {
    double cosine, sine;
    std::array<std::complex<double>, 3> root;
    std::array<Eigen::Matrix3cd, 3> matrix;  ///< 1/Pa
};

/// Of a stiffness in surface axes. Where two roots are nearer than 1e-3 (isotropic materials, or planes that are: a double root has too
/// few eigenvectors) the stiffness is changed by 1e-8 of itself, which balances the change against the rounding it saves.
/// Throws std::runtime_error where the eigenvalues do not come in three conjugate pairs.
StrohDirection stroh_direction(const material::Stiffness& stiffness, double phi);

/// The directions of half a turn (the other half gives the complex conjugate), evenly spaced, half a step off the axes, at several
/// finenesses, each made when first asked for.
class StrohTable {
public:
    /// `stiffness` in surface axes; `most_directions` of a full turn.
    StrohTable(const material::Stiffness& stiffness, int most_directions);

    static constexpr int coarsest = 32;  ///< directions of a full turn on level 0; each level has twice as many
    int levels() const { return static_cast<int>(levels_.size()); }
    int directions(int level) const { return coarsest << level; }
    const std::vector<StrohDirection>& level(int level) const;

    const material::Stiffness& stiffness() const { return stiffness_; }

    /// What bounds the convergence of sums over directions.
    struct Bounds {
        double least_decay = 1;    ///< the smallest Im p of level 0, at most 1
        double largest_shift = 0;  ///< the largest |Re p| of level 0
        double strip = 1;          ///< half width of the strip of complex directions in which p and W are analytic
    };
    const Bounds& bounds() const;  ///< found when first asked for

private:
    struct Level {
        std::once_flag made;
        std::vector<StrohDirection> directions;
    };
    Bounds find_bounds() const;

    material::Stiffness stiffness_;
    mutable std::once_flag bounded_;
    mutable Bounds bounds_;
    mutable std::vector<std::unique_ptr<Level>> levels_;
};

}  // namespace cleave::contact
