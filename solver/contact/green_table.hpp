#pragma once

#include "solver/contact/stroh_table.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace cleave::contact {

/// Displacement of a half-space of any stiffness under a force or Hertz's pressure on a circle of radius a, from tables over the directions
/// of space: some ten nanoseconds where Stroh's sum takes microseconds. Outside some radii (covers()) the pressure is its multipoles
///
///   u = sum over k of w_k a^2k G_k(x) f,   w_k = 3/((2k+1)(2k+3)),
///   G_k(x) = -(1/4 pi^2) integral over a turn of A diag[1/(m . x + p_alpha z)^(2k+1)] B^-1 dphi
///
/// (patch_kernel.hpp's series), and G_k(c x) = c^-(2k+1) G_k(x): a function of two coordinates, those of x over its largest one, on five faces
/// of a cube. Each face has a grid, G_0 to G_2 at its nodes by Stroh's sum, bicubic in between. The grid is refined until interpolated and
/// summed values agree at probes all over the faces. Immutable once made, safe to share between threads.
class GreenTable {
public:
    /// `axes`: columns are the surface's tangents and inward normal, which the table's stiffness refers to. `accuracy`: largest error of a
    /// displacement over its length, from interpolation, multipoles left out and sums together.
    /// Throws std::runtime_error where a grid of `finest` cells is too coarse for it.
    GreenTable(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy);

    static constexpr int terms = 3;    ///< multipoles tabulated
    static constexpr int finest = 160; ///< most cells along a face's edge

    /// Whether the multipoles tabulated suffice at a place (surface axes; z < 0 counts as the surface) under a patch of that radius (0: a
    /// point force).
    bool covers(const Eigen::Vector3d& position, double radius) const {
        const double square = position.squaredNorm();
        return square > nearest_[terms - 1] * radius * radius && square > 0;
    }

    /// Displacement (m, axes outside) at a place in surface axes that it covers, under a force (N) in surface axes.
    Eigen::Vector3d displacement(const Eigen::Vector3d& position, const Eigen::Vector3d& force, double radius) const;

    int cells() const { return cells_; }                ///< along a face's edge
    double probed_error() const { return error_; }      ///< largest error of G_0 at the probes, relative

private:
    /// A matrix, a column per axis of the force; the fourth numbers are zero.
    using Columns = std::array<Eigen::Vector4d, 3>;
    using Node = std::array<Columns, terms>;  // G_0, G_1, ...
    /// Face 0: z largest, coordinates x/z and y/z. 1 to 4: +x, -x, +y, -y largest, coordinates the other of x, y and z over it.
    struct Stencil {
        int first;                     // of its 4 x 4 nodes, in nodes_
        int stride;                    // between rows
        std::array<double, 4> along, up;
        double largest;                // the coordinate divided by, m
    };
    Stencil stencil(const Eigen::Vector3d& position) const;
    int face_start(int face) const;
    int rows(int face) const;
    void fill(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy);
    double probe(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy) const;
    template <int count>
    std::array<Columns, count> interpolated(const Stencil& stencil) const;
    template <int count>
    Eigen::Vector3d sum_of(const Stencil& stencil, const Eigen::Vector3d& force, double radius) const;

    int cells_ = 0;
    double error_ = 0;
    std::vector<Node> nodes_;
    std::array<double, terms> nearest_{};  // (distance / radius)^2 from which on terms 0 to k suffice
};

}  // namespace cleave::contact
