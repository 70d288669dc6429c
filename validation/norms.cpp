#include "validation/norms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cleave::validation {

namespace {

constexpr std::array<const char*, 6> tensor_names{"xx", "yy", "zz", "yz", "xz", "xy"};
constexpr std::array<const char*, 3> vector_names{"x", "y", "z"};

std::vector<double> tensor(const Voigt& voigt, const std::string& component, bool engineering_strain) {
    std::vector<double> values;
    for (std::size_t i = 0; i < 6; ++i) {
        const bool shear = i >= 3;
        if (component.empty())
            values.push_back(voigt[i] * (shear ? (engineering_strain ? 0.5 : 1.0) * std::sqrt(2.0) : 1.0));
        else if (component == tensor_names[i])
            return {voigt[i]};
    }
    if (values.empty()) throw std::invalid_argument("one of xx, yy, zz, yz, xz, xy (not '" + component + "')");
    return values;
}

std::vector<double> vector(const Point& point, const std::string& component) {
    if (component.empty()) return {point[0], point[1], point[2]};
    for (std::size_t i = 0; i < 3; ++i)
        if (component == vector_names[i]) return {point[i]};
    throw std::invalid_argument("one of x, y, z (not '" + component + "')");
}

double length(const std::vector<double>& v) { return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0)); }

/// The error that 95 % of the total weight stays below.
double percentile(std::vector<std::pair<double, double>> error_and_weight, double share) {
    std::sort(error_and_weight.begin(), error_and_weight.end());
    double total = 0, sum = 0;
    for (const auto& [error, weight] : error_and_weight) total += weight;
    for (const auto& [error, weight] : error_and_weight) {
        sum += weight;
        if (sum >= share * total) return error;
    }
    return error_and_weight.back().first;
}

}  // namespace

std::vector<double> observe(const Observable& observable, const Samples& samples, std::size_t point) {
    if (observable.quantity == "displacement") return vector(samples.displacement.at(point), observable.component);
    if (observable.quantity == "stress") return tensor(samples.stress.at(point), observable.component, false);
    if (observable.quantity == "strain") return tensor(samples.strain.at(point), observable.component, true);
    throw std::invalid_argument("one of displacement, strain, stress (not '" + observable.quantity + "')");
}

FieldError compare(const Observable& observable, const Samples& method, const Samples& reference, const std::string& norm) {
    if (method.size() == 0) throw std::invalid_argument("a region that holds at least one point of the method");
    double square_method = 0, square_reference = 0, square_error = 0, volume = 0;
    double max_method = 0, max_reference = 0, max_error = 0;
    std::vector<std::pair<double, double>> errors;
    for (std::size_t i = 0; i < method.size(); ++i) {
        const std::vector<double> a = observe(observable, method, i), b = observe(observable, reference, i);
        std::vector<double> difference(a.size());
        for (std::size_t k = 0; k < a.size(); ++k) difference[k] = a[k] - b[k];
        const double weight = method.weight[i], of_a = length(a), of_b = length(b), error = length(difference);
        if (!std::isfinite(error)) return {of_a, of_b, std::numeric_limits<double>::quiet_NaN()};
        volume += weight;
        square_method += weight * of_a * of_a;
        square_reference += weight * of_b * of_b;
        square_error += weight * error * error;
        max_method = std::max(max_method, of_a);
        max_reference = std::max(max_reference, of_b);
        max_error = std::max(max_error, error);
        errors.emplace_back(error, weight);
    }
    const double rms_method = std::sqrt(square_method / volume), rms_reference = std::sqrt(square_reference / volume);
    if (!(max_reference > 0)) throw std::invalid_argument("a reference that is not zero everywhere in the region");
    if (norm == "rms") return {rms_method, rms_reference, std::sqrt(square_error / volume) / rms_reference};
    if (norm == "max") return {max_method, max_reference, max_error / max_reference};
    if (norm == "p95") return {rms_method, rms_reference, percentile(std::move(errors), 0.95) / rms_reference};
    throw std::invalid_argument("one of rms, max, p95 (not '" + norm + "')");
}

double observed_order(const std::vector<double>& sizes, const std::vector<double>& errors) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (!(sizes[i] > 0) || !(errors[i] > 0)) return std::numeric_limits<double>::quiet_NaN();
        const double x = std::log(sizes[i]), y = std::log(errors[i]);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return n >= 2 && spread > 0 ? (n * sxy - sx * sy) / spread : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace cleave::validation
