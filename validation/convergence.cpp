#include "validation/convergence.hpp"

#include "validation/norms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::validation {

namespace {

constexpr double lowest_order = 0.05, highest_order = 10;

/// f = f0 + C h^p for a given p, by least squares.
struct Fit {
    double order = 0, limit = 0, factor = 0, residual = 0;  ///< residual: sum of squares
    double at(double h) const { return limit + factor * std::pow(h, order); }
};

Fit fit_with(double order, const std::vector<Refinement>& ladder) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    const double scale = ladder.back().h;  // powers near one
    for (const Refinement& step : ladder) {
        const double x = std::pow(step.h / scale, order), y = *step.value;
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    Fit fit{order, 0, 0, 0};
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    fit.limit = (sy - slope * sx) / n;
    fit.factor = slope / std::pow(scale, order);
    for (const Refinement& step : ladder) fit.residual += std::pow(fit.at(step.h) - *step.value, 2);
    return fit;
}

/// The order of the curve through three values: (f1 - f2)/(f2 - f3) = (h1^p - h2^p)/(h2^p - h3^p), whose right side grows with p.
/// Nothing where they oscillate, or where p lies outside what a mesh can show.
std::optional<double> order_of_three(const Refinement& a, const Refinement& b, const Refinement& c) {
    const double ratio = (*a.value - *b.value) / (*b.value - *c.value);
    const auto right = [&](double p) {
        const double fa = std::pow(a.h / c.h, p), fb = std::pow(b.h / c.h, p);
        return (fa - fb) / (fb - 1);
    };
    if (!std::isfinite(ratio) || ratio <= right(lowest_order) || ratio >= right(highest_order)) return std::nullopt;
    double low = lowest_order, high = highest_order;
    for (int i = 0; i < 100; ++i) (right(0.5 * (low + high)) < ratio ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
}

/// The best order over all values: the best of a scan, then golden section about it.
std::optional<double> order_of_all(const std::vector<Refinement>& ladder) {
    constexpr double step = 0.05;
    double best = lowest_order;
    for (int k = 0; lowest_order + k * step <= highest_order; ++k)
        if (const double p = lowest_order + k * step; fit_with(p, ladder).residual < fit_with(best, ladder).residual) best = p;
    if (best < lowest_order + step || best > highest_order - 2 * step) return std::nullopt;  // no inner minimum
    double low = best - step, high = best + step;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (int i = 0; i < 80; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (fit_with(a, ladder).residual < fit_with(b, ladder).residual ? high : low) = fit_with(a, ladder).residual < fit_with(b, ladder).residual ? b : a;
    }
    return 0.5 * (low + high);
}

bool has_values(const std::vector<Refinement>& ladder) {
    return std::all_of(ladder.begin(), ladder.end(), [](const Refinement& step) { return step.value && std::isfinite(*step.value); });
}

bool has_errors(const std::vector<Refinement>& ladder) {
    return std::all_of(ladder.begin(), ladder.end(), [](const Refinement& step) { return std::isfinite(step.error) && step.error > 0; });
}

/// Each step goes the same way as the one before.
bool monotone(const std::vector<Refinement>& ladder) {
    for (std::size_t i = 2; i < ladder.size(); ++i)
        if (!((*ladder[i].value - *ladder[i - 1].value) * (*ladder[i - 1].value - *ladder[i - 2].value) > 0)) return false;
    return true;
}

void extrapolate(const std::vector<Refinement>& ladder, Convergence& result) {
    if (ladder.size() < 3 || !has_values(ladder) || !monotone(ladder)) return;
    const auto order = ladder.size() == 3 ? order_of_three(ladder[0], ladder[1], ladder[2]) : order_of_all(ladder);
    if (!order) return;
    const Fit fit = fit_with(*order, ladder);
    result.order_of_values = *order;
    result.extrapolated = fit.limit;
    const double scatter = ladder.size() > 3 ? std::sqrt(fit.residual / static_cast<double>(ladder.size() - 3)) : 0;
    result.uncertainty = grid_safety_factor * std::abs(*ladder.back().value - fit.limit) + scatter;
}

/// Observed order between neighbours by the errors, or of neighbouring triplets of values.
std::vector<double> local_orders(const std::vector<Refinement>& ladder, bool by_errors) {
    std::vector<double> orders;
    if (by_errors)
        for (std::size_t i = 1; i < ladder.size(); ++i)
            orders.push_back(std::log(ladder[i - 1].error / ladder[i].error) / std::log(ladder[i - 1].h / ladder[i].h));
    else
        for (std::size_t i = 2; i < ladder.size(); ++i) orders.push_back(order_of_three(ladder[i - 2], ladder[i - 1], ladder[i]).value_or(0));
    return orders;
}

std::string text_of(const std::vector<double>& orders) {
    std::string text;
    for (const double order : orders) text += fmt::format("{}{:.2f}", text.empty() ? "" : ", ", order);
    return text;
}

/// Below this an error is what the solve and the rounding leave, whatever the mesh.
constexpr double rounding_level = 1e-11;

bool at_rounding(const std::vector<Refinement>& ladder) {
    return std::all_of(ladder.begin(), ladder.end(), [](const Refinement& step) { return step.error < rounding_level; });
}

void judge_range(const std::vector<Refinement>& ladder, Convergence& result) {
    const bool by_errors = has_errors(ladder) && result.order;
    result.asymptotic = "unknown";
    if (ladder.size() < 3) {
        result.why = "two sizes";
        return;
    }
    if (!by_errors && (!has_values(ladder) || ladder.size() < 4)) {
        result.why = has_values(ladder) ? "three sizes and no error: nothing to check the order with" : "no error above zero";
        return;
    }
    if (by_errors && at_rounding(ladder)) {
        result.why = "exact on every mesh but for rounding";
        return;
    }
    const std::vector<double> orders = local_orders(ladder, by_errors);
    const double observed = by_errors ? *result.order : result.order_of_values.value_or(0);
    const bool agree = observed > 0 && std::all_of(orders.begin(), orders.end(), [&](double p) { return std::abs(p - observed) <= 0.25 * observed; });
    result.asymptotic = agree ? "stated" : "denied";
    result.why = fmt::format("orders between {} sizes: {}", by_errors ? "neighbouring" : "three neighbouring", text_of(orders));
}

}  // namespace

std::optional<Convergence> study_convergence(const std::vector<Refinement>& ladder) {
    if (ladder.size() < 2) return std::nullopt;
    for (std::size_t i = 0; i < ladder.size(); ++i)
        if (!(ladder[i].h > 0) || (i > 0 && !(ladder[i].h < ladder[i - 1].h))) return std::nullopt;
    Convergence result;
    std::vector<double> sizes, errors;
    for (const Refinement& step : ladder) sizes.push_back(step.h), errors.push_back(step.error);
    if (const double order = observed_order(sizes, errors); std::isfinite(order)) result.order = order;
    extrapolate(ladder, result);
    judge_range(ladder, result);
    return result;
}

}  // namespace cleave::validation
