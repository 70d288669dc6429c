#include "solver/contact/stroh_field.hpp"

#include "solver/contact/patch_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleave::contact {

namespace {

constexpr int lane_count = 8;
using Lanes = Eigen::Array<double, lane_count, 1>;
using Complex = std::complex<double>;

/// W f for one load: what a root contributes, per lane.
struct RootLanes {
    Lanes root_re, root_im;
    std::array<Lanes, 3> vector_re, vector_im;
};

struct DirectionLanes {
    Lanes cosine, sine, inverse_width;  // of the patch; 1 for a point force
    std::array<RootLanes, 3> roots;
};

/// 1/s.
void point_kernel(const Lanes& re, const Lanes& im, Lanes& kernel_re, Lanes& kernel_im) {
    const Lanes inverse = 1 / (re * re + im * im);
    kernel_re = re * inverse;
    kernel_im = -im * inverse;
}

/// patch_kernel of every lane: by its series where all of them may.
void patch_kernels(const Lanes& re, const Lanes& im, Lanes& kernel_re, Lanes& kernel_im) {
    const double least = (re * re + im * im).minCoeff();
    if (least < patch_series_from) {
        for (int lane = 0; lane < lane_count; ++lane) {
            const Complex value = patch_kernel({re[lane], im[lane]});
            kernel_re[lane] = value.real();
            kernel_im[lane] = value.imag();
        }
        return;
    }
    Lanes inverse_re, inverse_im;
    point_kernel(re, im, inverse_re, inverse_im);
    const Lanes square_re = inverse_re * inverse_re - inverse_im * inverse_im, square_im = 2 * inverse_re * inverse_im;
    const int terms = least > 100 ? patch_series_terms / 2 : patch_series_terms;  // as exact: 100^-5 against 9^-10
    Lanes sum_re = Lanes::Constant(patch_series_factor(terms - 1)), sum_im = Lanes::Zero();
    for (int k = terms - 1; k-- > 0;) {
        const Lanes next = sum_re * square_re - sum_im * square_im + patch_series_factor(k);
        sum_im = sum_re * square_im + sum_im * square_re;
        sum_re = next;
    }
    kernel_re = sum_re * inverse_re - sum_im * inverse_im;
    kernel_im = sum_re * inverse_im + sum_im * inverse_re;
}

/// x = N delta with x^2 exp(-x) = accuracy, nearly: near double roots displacements have poles of second order and their gradients of third.
double digits_of(double accuracy) {
    const double simple = std::log(1 / accuracy);
    return simple + 2 * std::log(simple + 2 * std::log(simple));
}

/// Lagrange's weights at z of the values at 1, 2, 3, 4 (in units of the first depth).
std::array<double, 4> cubic_weights(double z) {
    std::array<double, 4> weights;
    for (int i = 0; i < 4; ++i) {
        weights[i] = 1;
        for (int j = 0; j < 4; ++j)
            if (j != i) weights[i] *= (z - (j + 1)) / (i - j);
    }
    return weights;
}

/// A field at a place, or extrapolated along z from `least_z` and its multiples.
template <typename Field>
auto at_depth(const Eigen::Vector3d& position, double least_z, const Field& field) -> decltype(field(position)) {
    const double z = std::max(position[2], 0.0);
    if (z >= least_z) return field({position[0], position[1], z});
    const std::array<double, 4> weights = cubic_weights(z / least_z);
    auto sum = field({position[0], position[1], least_z});
    sum *= weights[0];
    for (int i = 1; i < 4; ++i) sum += weights[i] * field({position[0], position[1], (i + 1) * least_z});
    return sum;
}

}  // namespace

struct StrohField::Prepared {
    std::once_flag made;
    int directions = 0;  // of half a turn
    std::vector<DirectionLanes> lanes;
};

StrohField::StrohField(std::shared_ptr<const StrohTable> table, const StrohLoad& load, double accuracy)
    : table_(std::move(table)), load_(load), bounds_(table_->bounds()), digits_(digits_of(accuracy)),
      levels_(std::make_shared<std::vector<std::unique_ptr<Prepared>>>()) {
    for (int level = 0; level < table_->levels(); ++level) levels_->push_back(std::make_unique<Prepared>());
}

const StrohField::Prepared& StrohField::prepared(int level) const {
    Prepared& asked = *(*levels_)[level];
    std::call_once(asked.made, [&] {
        const std::vector<StrohDirection>& directions = table_->level(level);
        asked.directions = static_cast<int>(directions.size());
        asked.lanes.resize(directions.size() / lane_count);
        for (std::size_t k = 0; k < directions.size(); ++k) {
            const StrohDirection& one = directions[k];
            DirectionLanes& lanes = asked.lanes[k / lane_count];
            const int lane = static_cast<int>(k % lane_count);
            const double along = one.cosine * load_.axis[0] + one.sine * load_.axis[1], across = one.cosine * load_.axis[1] - one.sine * load_.axis[0];
            lanes.cosine[lane] = one.cosine;
            lanes.sine[lane] = one.sine;
            lanes.inverse_width[lane] = load_.radius > 0 ? 1 / std::hypot(load_.radius * along, load_.other_radius * across) : 1;
            for (int root = 0; root < 3; ++root) {
                const Eigen::Vector3cd vector = one.matrix[root] * load_.force.cast<Complex>();
                lanes.roots[root].root_re[lane] = one.root[root].real();
                lanes.roots[root].root_im[lane] = one.root[root].imag();
                for (int i = 0; i < 3; ++i) {
                    lanes.roots[root].vector_re[i][lane] = vector[i].real();
                    lanes.roots[root].vector_im[i][lane] = vector[i].imag();
                }
            }
        }
    });
    return asked;
}

/// Imaginary part of the nearest angle at which r cos(phi) + p z reaches the rim of the patch (its centre for a point force), for the
/// worst p that occurs, but never more than the strip.
double StrohField::decay(double distance, double z) const {
    const double most = std::min(bounds_.strip, bounds_.least_decay);
    if (distance <= 0) return most;
    const double rim = std::clamp(distance, std::min(load_.radius, load_.other_radius), std::max(load_.radius, load_.other_radius));
    const double nearest = std::max(0.0, rim - bounds_.largest_shift * z);
    return std::min(most, std::abs(std::acos(Complex(nearest, bounds_.least_decay * z) / distance).imag()));
}

StrohField::Choice StrohField::choose(const Eigen::Vector3d& position, int poles) const {
    const double distance = std::hypot(position[0], position[1]), z = std::max(position[2], 0.0);
    const int finest = table_->levels() - 1;
    const double strip = std::max(decay(distance, z), 1e-300), wanted = (digits_ - poles * std::min(0.0, std::log(strip))) / strip;
    int level = 0;
    while (level < finest && table_->directions(level) < wanted) ++level;
    const double most = table_->directions(finest), radius = std::max(load_.radius, load_.other_radius);
    // Enough directions meet a near patch for its kinks at the rim to be resolved (the error is the square of their spacing).
    if (table_->directions(level) >= wanted || most * radius > 1500 * distance) return {level, 0};
    const double delta = (digits_ + poles * std::log(most / digits_)) / most, reach = radius / (distance * std::cosh(delta));
    return {level, distance * std::sinh(delta) * std::sqrt(1 - reach * reach) / bounds_.least_decay};
}

int StrohField::directions_at(const Eigen::Vector3d& position) const { return table_->directions(choose(position).level); }

Eigen::Vector3d StrohField::sum_displacement(const Eigen::Vector3d& position, const Prepared& level) const {
    std::array<Lanes, 3> sum{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
    const bool patch = load_.radius > 0;
    for (const DirectionLanes& lanes : level.lanes) {
        const Lanes along = lanes.cosine * position[0] + lanes.sine * position[1];
        for (const RootLanes& root : lanes.roots) {
            Lanes re = along + root.root_re * position[2], im = root.root_im * position[2], kernel_re, kernel_im;
            if (patch) {
                re *= lanes.inverse_width;
                im *= lanes.inverse_width;
                patch_kernels(re, im, kernel_re, kernel_im);
                kernel_re *= lanes.inverse_width;
                kernel_im *= lanes.inverse_width;
            } else {
                point_kernel(re, im, kernel_re, kernel_im);
            }
            for (int i = 0; i < 3; ++i) sum[i] += root.vector_re[i] * kernel_re - root.vector_im[i] * kernel_im;
        }
    }
    return Eigen::Vector3d(sum[0].sum(), sum[1].sum(), sum[2].sum()) / (-2 * M_PI * level.directions);
}

StrohField::Multipoles StrohField::sum_multipoles(const Eigen::Vector3d& position, const Prepared& level) const {
    std::array<std::array<Lanes, 3>, 4> sum;
    for (auto& of_power : sum) of_power.fill(Lanes::Zero());
    for (const DirectionLanes& lanes : level.lanes) {
        const Lanes along = lanes.cosine * position[0] + lanes.sine * position[1];
        for (const RootLanes& root : lanes.roots) {
            Lanes re, im;
            point_kernel(along + root.root_re * position[2], root.root_im * position[2], re, im);
            const Lanes square_re = re * re - im * im, square_im = 2 * re * im;
            for (auto& of_power : sum) {
                for (int i = 0; i < 3; ++i) of_power[i] += root.vector_re[i] * re - root.vector_im[i] * im;
                const Lanes next = re * square_re - im * square_im;
                im = re * square_im + im * square_re;
                re = next;
            }
        }
    }
    Multipoles result;
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i) result(i, k) = sum[k][i].sum();
    return result / (-2 * M_PI * level.directions);
}

Eigen::Matrix3d StrohField::sum_gradient(const Eigen::Vector3d& position, const Prepared& level) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const DirectionLanes& lanes : level.lanes)
        for (int lane = 0; lane < lane_count; ++lane) {
            const double c = lanes.cosine[lane], s = lanes.sine[lane], inverse = lanes.inverse_width[lane];
            for (const RootLanes& root : lanes.roots) {
                const Complex p(root.root_re[lane], root.root_im[lane]);
                const Complex argument = (c * position[0] + s * position[1] + p * position[2]) * inverse;
                const Complex slope = (load_.radius > 0 ? patch_kernel_derivative(argument) : -1.0 / (argument * argument)) * inverse * inverse;
                for (int i = 0; i < 3; ++i) {
                    const Complex value = Complex(root.vector_re[i][lane], root.vector_im[i][lane]) * slope;
                    sum(i, 0) += value.real() * c;
                    sum(i, 1) += value.real() * s;
                    sum(i, 2) += (value * p).real();
                }
            }
        }
    return sum / (-2 * M_PI * level.directions);
}

Eigen::Vector3d StrohField::displacement(const Eigen::Vector3d& position) const {
    const Choice choice = choose(position);
    const Prepared& level = prepared(choice.level);
    return at_depth(position, choice.least_z, [&](const Eigen::Vector3d& x) { return sum_displacement(x, level); });
}

StrohField::Multipoles StrohField::multipoles(const Eigen::Vector3d& position) const {
    const Choice choice = choose(position, 6);  // s^-7
    const Prepared& level = prepared(choice.level);
    Multipoles result = at_depth(position, choice.least_z, [&](const Eigen::Vector3d& x) { return sum_multipoles(x, level); });
    result.col(0) = displacement(position);
    return result;
}

Eigen::Matrix3d StrohField::gradient(const Eigen::Vector3d& position) const {
    const Choice choice = choose(position);
    const Prepared& level = prepared(choice.level);
    return at_depth(position, choice.least_z, [&](const Eigen::Vector3d& x) { return sum_gradient(x, level); });
}

}  // namespace cleave::contact
