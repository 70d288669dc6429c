#include "reference_fem/crack_integrals.hpp"

#include "reference_fem/constitutive.hpp"
#include "reference_fem/vector3.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <fmt/format.h>

#include <cmath>

namespace cleave::fem {
namespace {

double full_product(const Voigt& stress, const Tensor& gradient) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum += stress[voigt_index(i, j)] * gradient[i][j];
    return sum;
}

/// sigma_ij a_i,k q_k,j.
double turned_product(const Voigt& stress, const Tensor& gradient, const Tensor& slope) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) sum += stress[voigt_index(i, j)] * gradient[i][k] * slope[k][j];
    return sum;
}

double trace(const Tensor& t) { return t[0][0] + t[1][1] + t[2][2]; }
Point times(const Tensor& t, const Point& v) { return {dot(t[0], v), dot(t[1], v), dot(t[2], v)}; }
Point times(const Voigt& s, const Point& v) {
    Point result{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) result[i] += s[voigt_index(i, j)] * v[j];
    return result;
}

/// (q.grad) of a field, by a central difference over 1e-5 of `size` (m), the body's, which may be a nanometre's.
Point change_along(const VectorField& field, const Point& x, const Point& q, double size) {
    const double length = norm(q);
    if (length == 0) return {};
    const double step = 1e-5 / length * std::max({size, std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
    return 1 / (2 * step) * (field(x + step * q) - field(x - step * q));
}

/// The growth as linear elements see it.
class LinearGrowth {
public:
    explicit LinearGrowth(const CrackGrowth& crack) : cells_(crack.solution.cells()), vertices_(crack.solution.vertices()) {
        Point low = vertices_.front(), high = low;
        for (const Point& x : vertices_) {
            values_.push_back(crack.growth(x));
            for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
        }
        size_ = norm(high - low);
        for (std::size_t cell = 0; cell < cells_.size(); ++cell)
            if (!vanishes(static_cast<int>(cell))) active_.push_back(static_cast<int>(cell));
    }

    /// Diagonal of the box around the body, m.
    double size() const { return size_; }
    /// Cells where it is not zero.
    const std::vector<int>& active() const { return active_; }
    bool vanishes(int cell) const {
        for (const int v : cells_[cell])
            if (norm(values_[v]) > 0) return false;
        return true;
    }
    /// slope[k][j] = dq_k/dx_j.
    Tensor slope(int cell) const {
        const auto [edges, changes] = differences(cell);
        const Eigen::Matrix3d gradient = changes * edges.inverse();
        Tensor result{};
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j) result[k][j] = gradient(k, j);
        return result;
    }
    Point at(int cell, const Tensor& slope, const Point& x) const {
        const int first = cells_[cell][0];
        return values_[first] + times(slope, x - vertices_[first]);
    }

private:
    std::pair<Eigen::Matrix3d, Eigen::Matrix3d> differences(int cell) const {
        Eigen::Matrix3d edges, changes;
        const auto& v = cells_[cell];
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i) {
                edges(i, k) = vertices_[v[k + 1]][i] - vertices_[v[0]][i];
                changes(i, k) = values_[v[k + 1]][i] - values_[v[0]][i];
            }
        return {edges, changes};
    }
    std::vector<std::array<int, 4>> cells_;
    std::vector<Point> vertices_, values_;
    std::vector<int> active_;
    double size_ = 0;
};

void put_gradient(const CrackGrowth& crack, FieldSample& sample) {
    if (!crack.gradient) return;
    sample.gradient = crack.gradient(sample.position);
    sample.stress = crack.solution.material(sample.cell).stress(sample.gradient);
}

/// Calls visit(sample, slope of q, q) at the points of all active cells.
template <class Visit>
void for_each_cell_sample(const CrackGrowth& crack, const LinearGrowth& growth, const Visit& visit) {
    constexpr std::size_t batch = 2000;  // cells; the samples of all of them would take much memory
    const std::vector<int>& cells = growth.active();
    for (std::size_t begin = 0; begin < cells.size(); begin += batch) {
        const std::vector<int> some(cells.begin() + static_cast<long>(begin), cells.begin() + static_cast<long>(std::min(cells.size(), begin + batch)));
        int cell = -1;
        Tensor slope{};
        for (FieldSample& sample : crack.solution.cell_samples(some)) {
            put_gradient(crack, sample);
            if (sample.cell != cell) slope = growth.slope(cell = sample.cell);
            visit(sample, slope, growth.at(cell, slope, sample.position));
        }
    }
}

/// The same on a surface.
template <class Visit>
void for_each_surface_sample(const CrackGrowth& crack, const LinearGrowth& growth, int surface, const Visit& visit) {
    for (SurfaceSample& sample : crack.solution.surface_samples(surface, [&](int cell) { return !growth.vanishes(cell); })) {
        put_gradient(crack, sample);
        const Tensor slope = growth.slope(sample.cell);
        visit(sample, slope, growth.at(sample.cell, slope, sample.position));
    }
}

/// Rate of the vector area n dS over dS: div q n - grad q^T n (Nanson).
Point area_rate(const Tensor& slope, const Point& n) {
    Point rate = trace(slope) * n;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) rate[j] -= slope[k][j] * n[k];
    return rate;
}

/// A load over a surface as a field over space.
VectorField traction_field(const Traction& load, const Point& normal) {
    if (load.value) return load.value;
    return [&load, normal](const Point& x) { return times(load.stress(x), normal); };
}

/// Calls add(surface, sample, rate of the load's vector over dS) at the points of all loaded surfaces: the load that a moved surface element gains.
template <class Add>
void for_each_load_rate(const CrackGrowth& crack, const LinearGrowth& growth, const Add& add) {
    for (const Traction& load : crack.problem.tractions)
        for_each_surface_sample(crack, growth, load.surface, [&](const SurfaceSample& s, const Tensor& slope, const Point& q) {
            const Point spread = area_rate(slope, s.normal);
            const Point grown = load.value ? dot(s.normal, spread) * load.value(s.position) : times(load.stress(s.position), spread);
            add(load.surface, s, grown + change_along(traction_field(load, s.normal), s.position, q, growth.size()));
        });
    for (const Pressure& load : crack.problem.pressures)
        for_each_surface_sample(crack, growth, load.surface,
                                [&](const SurfaceSample& s, const Tensor& slope, const Point&) { add(load.surface, s, -load.value * area_rate(slope, s.normal)); });
}

/// The same of the body force, over dV.
Point body_force_rate(const VectorField& force, const Point& x, const Tensor& slope, const Point& q, double size) {
    return trace(slope) * force(x) + change_along(force, x, q, size);
}

/// Where the auxiliary fields are taken for a place of a surface: on the lips, which part them, on the side that the normal tells. Faces of
/// a curved crack lie off its surface, and the distance from it must stay small against that from the front, for the sake of the traction.
Point auxiliary_place(const SurfaceSample& s, bool on_lips, const AuxiliaryField& field) {
    if (!on_lips) return s.position;
    const FrontPlace place = field.front().locate(s.position);
    const double side = dot(s.normal, place.axes[1]) < 0 ? 1 : -1;
    return s.position + (side * 1e-6 * std::hypot(place.ahead, place.above) - place.above) * place.axes[1];
}

/// Tractions of the auxiliary fields on all surfaces: zero on the lips of a straight front only.
void add_auxiliary_tractions(const CrackGrowth& crack, const LinearGrowth& growth, const AuxiliaryField& field, Intensities& sum) {
    for (const int surface : crack.solution.surfaces())
        for_each_surface_sample(crack, growth, surface, [&](const SurfaceSample& s, const Tensor&, const Point& q) {
            const AuxiliaryField::State state = field.at(auxiliary_place(s, surface == crack.lips, field), false);
            const Point along = times(s.gradient, q);
            for (int mode = 0; mode < 3; ++mode) sum[mode] -= s.weight * dot(times(state.stress[mode], s.normal), along);
        });
}

}  // namespace

double potential_energy(const Problem& problem, const Solution& solution) {
    double work = 0;
    for (const Traction& load : problem.tractions)
        for (const SurfaceSample& s : solution.surface_samples(load.surface)) work += s.weight * dot(s.displacement, traction_field(load, s.normal)(s.position));
    for (const Pressure& load : problem.pressures)
        for (const SurfaceSample& s : solution.surface_samples(load.surface)) work -= s.weight * load.value * dot(s.displacement, s.normal);
    if (problem.body_force)
        for (const FieldSample& s : solution.quadrature_samples()) work += s.weight * dot(s.displacement, problem.body_force(s.position));
    return solution.energy() - work;
}

double crack_width(const CrackGrowth& crack) {
    const LinearGrowth growth(crack);
    double rate = 0;
    for_each_surface_sample(crack, growth, crack.lips, [&](const SurfaceSample& s, const Tensor& slope, const Point&) {
        rate += 0.5 * s.weight * dot(s.normal, area_rate(slope, s.normal));
    });
    if (!(rate > 0)) throw Error(fmt::format("a growth that enlarges the crack's lips, surface {}", crack.lips));
    return rate;
}

double energy_release_by_domain(const CrackGrowth& crack) {
    const LinearGrowth growth(crack);
    const VectorField& force = crack.problem.body_force;
    double sum = 0;
    for_each_load_rate(crack, growth, [&](int, const SurfaceSample& s, const Point& rate) { sum += s.weight * dot(s.displacement, rate); });
    for_each_cell_sample(crack, growth, [&](const FieldSample& s, const Tensor& slope, const Point& q) {
        double density = turned_product(s.stress, s.gradient, slope) - 0.5 * full_product(s.stress, s.gradient) * trace(slope);
        if (force) density += dot(s.displacement, body_force_rate(force, s.position, slope, q, growth.size()));
        sum += s.weight * density;
    });
    return sum / crack_width(crack);
}

FrontIntensities intensities_by_interaction(const CrackGrowth& crack, const AuxiliaryField& field, const Point& place) {
    const LinearGrowth growth(crack);
    const VectorField& force = crack.problem.body_force;
    Intensities sum{};
    for_each_cell_sample(crack, growth, [&](const FieldSample& s, const Tensor& slope, const Point& q) {
        const AuxiliaryField::State v = field.at(s.position, true);
        const Point along = times(s.gradient, q), loaded = force ? body_force_rate(force, s.position, slope, q, growth.size()) : Point{};
        const auto displacement = force ? field.displacement(s.position) : std::array<Point, 3>{};
        for (int mode = 0; mode < 3; ++mode) {
            const double density = turned_product(s.stress, v.gradient[mode], slope) + turned_product(v.stress[mode], s.gradient, slope) -
                                   full_product(s.stress, v.gradient[mode]) * trace(slope) + dot(v.divergence[mode], along) +
                                   dot(loaded, displacement[mode]);
            sum[mode] += s.weight * density;
        }
    });
    for_each_load_rate(crack, growth, [&](int surface, const SurfaceSample& s, const Point& rate) {
        const auto displacement = field.displacement(auxiliary_place(s, surface == crack.lips, field));
        for (int mode = 0; mode < 3; ++mode) sum[mode] += s.weight * dot(displacement[mode], rate);
    });
    add_auxiliary_tractions(crack, growth, field, sum);

    const double width = crack_width(crack);
    const std::shared_ptr<const NearTip> tip = field.tip(place);
    const Tensor compliance = tip->compliance();
    Eigen::Matrix3d inverse;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse(i, j) = compliance[i][j];
    const Eigen::Vector3d k = inverse.inverse() * Eigen::Vector3d(sum[0], sum[1], sum[2]) / width;
    FrontIntensities result;
    for (int i = 0; i < 3; ++i) result.k[i] = k[i];
    result.energy_release = energy_release(*tip, result.k);
    return result;
}

}  // namespace cleave::fem
