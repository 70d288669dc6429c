#include "solver/contact/green_table.hpp"

#include "solver/contact/patch_kernel.hpp"
#include "solver/contact/stroh_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::contact {

namespace {

constexpr int faces = 5;
static_assert(GreenTable::terms == 3, "displacement() chooses among three");

/// Point forces along the three axes.
std::array<StrohField, 3> unit_forces(const std::shared_ptr<const StrohTable>& table, double accuracy) {
    const auto along = [&](int axis) { return StrohField(table, {.force = Eigen::Vector3d::Unit(axis)}, accuracy); };
    return {along(0), along(1), along(2)};
}

/// G_0 to G_3 of a place, in the axes outside.
std::array<Eigen::Matrix3d, GreenTable::terms + 1> multipoles(const std::array<StrohField, 3>& forces, const Eigen::Matrix3d& axes,
                                                              const Eigen::Vector3d& position) {
    std::array<Eigen::Matrix3d, GreenTable::terms + 1> result;
    for (int j = 0; j < 3; ++j) {
        const StrohField::Multipoles of_force = forces[j].multipoles(position);
        for (int k = 0; k <= GreenTable::terms; ++k) result[k].col(j) = axes * of_force.col(k);
    }
    return result;
}

/// A place on a face of the cube, its largest coordinate 1.
Eigen::Vector3d on_face(int face, double along, double up) {
    switch (face) {
        case 0: return {along, up, 1};
        case 1: return {1, along, up};
        case 2: return {-1, along, up};
        case 3: return {along, 1, up};
        default: return {along, -1, up};
    }
}

/// Lagrange's weights of the values at 0, 1, 2, 3.
std::array<double, 4> cubic(double t) {
    const double a = t - 1, b = t - 2, c = t - 3;
    return {-a * b * c / 6, t * b * c / 2, -t * a * c / 2, t * a * b / 6};
}

/// sum += weight v, rounded once: three instructions of the baseline processor.
void add(Eigen::Vector4d& sum, double weight, const Eigen::Vector4d& v) {
    for (int i = 0; i < 4; ++i) sum[i] = std::fma(weight, v[i], sum[i]);
}

Eigen::Vector4d padded(const Eigen::Vector3d& v) { return {v[0], v[1], v[2], 0}; }

}  // namespace

GreenTable::GreenTable(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy) {
    // A quarter to interpolation at the probes, a quarter to the multipoles left out, the rest to places between the probes and the sums,
    // whose higher multipoles converge later (by (N delta)^2k/(2k)!, against w_k (a/R)^2k).
    for (cells_ = 12;;) {
        fill(table, axes, accuracy);
        error_ = probe(table, axes, accuracy);
        if (error_ <= accuracy / 4) return;
        const double factor = 1.1 * std::pow(4 * error_ / accuracy, 0.25);  // fourth order
        if (cells_ >= finest || cells_ * factor > 4 * finest) throw std::runtime_error("displacements of a half-space that a table can hold");
        cells_ = std::min(finest, 2 * static_cast<int>(std::ceil(cells_ / 2.0 * std::clamp(factor, 1.25, 4.0))));
    }
}

/// The top face's rows are spaced like its columns, 2/cells over -1 to 1; the others have `cells` over 0 to 1. Columns begin and end one
/// beyond the face, rows of the sides half a space above the surface (at the surface Stroh's sum does not converge) and one beyond the
/// upper edge: as fine as that, extrapolating half a space costs no more than interpolating elsewhere.
int GreenTable::rows(int face) const { return face == 0 ? cells_ + 3 : cells_ + 2; }
int GreenTable::face_start(int face) const { return face == 0 ? 0 : (cells_ + 3) * (cells_ + 3 + (face - 1) * (cells_ + 2)); }

void GreenTable::fill(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy) {
    const std::array<StrohField, 3> forces = unit_forces(table, accuracy / 20);
    const double space = 2.0 / cells_;
    std::array<double, terms + 1> largest{};  // |G_k| |x|^2k / |G_0|
    nodes_.clear();
    for (int face = 0; face < faces; ++face)
        for (int row = 0; row < rows(face); ++row)
            for (int column = 0; column < cells_ + 3; ++column) {
                const double along = -1 + (column - 1) * space, up = face == 0 ? -1 + (row - 1) * space : (row + 0.5) / cells_;
                const Eigen::Vector3d place = on_face(face, along, up);
                const auto G = multipoles(forces, axes, place);
                for (int k = 0; k <= terms; ++k) largest[k] = std::max(largest[k], G[k].norm() / G[0].norm() * std::pow(place.squaredNorm(), k));
                Node& node = nodes_.emplace_back();
                for (int k = 0; k < terms; ++k) node[k] = {padded(G[k].col(0)), padded(G[k].col(1)), padded(G[k].col(2))};
            }
    for (int k = 0; k < terms; ++k)
        nearest_[k] = std::pow(4 / accuracy * patch_series_factor(k + 1) * largest[k + 1], 1.0 / (k + 1));
}

/// At the centres of cells (where interpolation is worst) on a grid over each face, and just below the surface.
double GreenTable::probe(const std::shared_ptr<const StrohTable>& table, const Eigen::Matrix3d& axes, double accuracy) const {
    const std::array<StrohField, 3> forces = unit_forces(table, accuracy / 20);
    const int step = std::max(1, cells_ / 8);
    double worst = 0;
    for (int face = 0; face < faces; ++face)
        for (int row = 0; row < cells_; row += step)
            for (int column = step / 2; column < cells_; column += step) {
                const double along = -1 + 2 * (column + 0.5) / cells_, up = face == 0 ? -1 + 2 * (row + 0.5) / cells_ : (row + 0.1) / cells_;
                const Eigen::Vector3d place = on_face(face, along, up);
                const Eigen::Matrix3d exact = multipoles(forces, axes, place)[0];
                const Columns columns = interpolated<1>(stencil(place))[0];  // the place's largest coordinate is 1
                Eigen::Matrix3d found;
                for (int j = 0; j < 3; ++j) found.col(j) = columns[j].head<3>();
                worst = std::max(worst, (found - exact).norm() / exact.norm());
            }
    return worst;
}

GreenTable::Stencil GreenTable::stencil(const Eigen::Vector3d& position) const {
    const double x = position[0], y = position[1], z = std::max(position[2], 0.0), wide = std::abs(x), deep = std::abs(y);
    const bool top = z >= wide && z >= deep, along_x = wide >= deep;
    const double largest = top ? z : along_x ? wide : deep, inverse = 1 / largest;
    const int face = top ? 0 : along_x ? (x > 0 ? 1 : 2) : (y > 0 ? 3 : 4);
    const double along = ((top || !along_x ? x : y) * inverse + 1) * cells_ / 2;                    // cells from the face's edge
    const double up = top ? (y * inverse + 1) * cells_ / 2 : z * inverse * cells_ - 0.5;            // rows from the second or the first
    const int column = std::clamp(static_cast<int>(along), 0, cells_ - 1);                          // node column is the one before it
    const int row = std::clamp(static_cast<int>(std::floor(up)) - (top ? 0 : 1), 0, rows(face) - 4);
    const int stride = cells_ + 3;
    return {face_start(face) + row * stride + column, stride, cubic(along - column + 1), cubic(top ? up - row + 1 : up - row), largest};
}

/// G_0 to G_(count-1), for a largest coordinate of 1. One after the other: three sums stay in registers.
template <int count>
std::array<GreenTable::Columns, count> GreenTable::interpolated(const Stencil& stencil) const {
    std::array<Columns, count> result;
    for (int k = 0; k < count; ++k) {
        const Node* node = nodes_.data() + stencil.first;
        Eigen::Vector4d x = Eigen::Vector4d::Zero(), y = x, z = x;
        for (int i = 0; i < 4; ++i, node += stencil.stride)
            for (int j = 0; j < 4; ++j) {
                const double weight = stencil.up[i] * stencil.along[j];
                const Columns& columns = node[j][k];
                add(x, weight, columns[0]);
                add(y, weight, columns[1]);
                add(z, weight, columns[2]);
            }
        result[k] = {x, y, z};
    }
    return result;
}

template <int count>
Eigen::Vector3d GreenTable::sum_of(const Stencil& stencil, const Eigen::Vector3d& force, double radius) const {
    const std::array<Columns, count> G = interpolated<count>(stencil);
    const double inverse = 1 / stencil.largest, square = radius * radius * inverse * inverse;
    double power = inverse;  // radius^2k / largest^(2k+1)
    Eigen::Vector4d u = Eigen::Vector4d::Zero();
    for (int k = 0; k < count; ++k, power *= square) {
        const double factor = patch_series_factor(k) * power;
        for (int c = 0; c < 3; ++c) add(u, factor * force[c], G[k][c]);
    }
    return u.head<3>();
}

Eigen::Vector3d GreenTable::displacement(const Eigen::Vector3d& position, const Eigen::Vector3d& force, double radius) const {
    const Stencil at = stencil(position);
    const double square = position.squaredNorm(), radius2 = radius * radius;
    if (square >= nearest_[0] * radius2) return sum_of<1>(at, force, radius);
    return square >= nearest_[1] * radius2 ? sum_of<2>(at, force, radius) : sum_of<3>(at, force, radius);
}

}  // namespace cleave::contact
