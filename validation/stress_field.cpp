#include "validation/stress_field.hpp"

#include "solver/input/base64.hpp"
#include "solver/input/file_io.hpp"
#include "validation/analytic/principals.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cleave::validation {

namespace {

using Json = nlohmann::ordered_json;

template <std::size_t i>
double component(const Voigt& stress) {
    return stress[i];
}

double largest_principal(const Voigt& stress) { return analytic::principals(analytic::stress_tensor(stress)).value[0]; }

/// Over all points.
Json measure_json(const StressMeasure& measure, const StressPair& pair) {
    double volume = 0, square = 0, difference_square = 0, largest = -1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < pair.position.size(); ++i) {
        const double fem = measure.of(pair.fem[i]), difference = measure.of(pair.particles[i]) - fem;
        volume += pair.volume[i];
        square += pair.volume[i] * fem * fem;
        difference_square += pair.volume[i] * difference * difference;
        if (std::abs(difference) > largest) largest = std::abs(difference), at = i;
    }
    return {{"name", measure.name}, {"fem_rms", std::sqrt(square / volume)}, {"difference_rms", std::sqrt(difference_square / volume)},
            {"difference_max", largest}, {"at", pair.position[at]}};
}

/// Numbers of the points to draw.
std::vector<std::size_t> chosen(std::size_t total) {
    const std::size_t count = std::min(total, max_field_points);
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < count; ++k) numbers.push_back(count > 1 ? k * (total - 1) / (count - 1) : 0);
    return numbers;
}

/// Whole numbers of a scale that the largest value fills.
Json packed(const std::vector<double>& values) {
    constexpr double most = std::numeric_limits<std::int16_t>::max();
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    const double scale = largest > 0 ? largest / most : 1;
    std::string bytes;
    for (const double value : values) {
        const auto whole = static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value / scale)));
        bytes += static_cast<char>(whole & 0xff);
        bytes += static_cast<char>(whole >> 8);
    }
    return {{"scale", scale}, {"data", base64(bytes)}};
}

const FieldSource* first_found(const LevelSources& sources, const std::vector<std::string>& names, std::string& name) {
    for (const std::string& one : names)
        if (const FieldSource* source = sources.find(one)) {
            name = one;
            return source;
        }
    return nullptr;
}

}  // namespace

const std::vector<StressMeasure>& stress_measures() {
    static const std::vector<StressMeasure> measures{{"largest_principal", largest_principal}, {"xx", component<0>}, {"yy", component<1>}, {"zz", component<2>},
                                                     {"yz", component<3>}, {"xz", component<4>}, {"xy", component<5>}};
    return measures;
}

std::string stress_field_json(const StressPair& pair) {
    if (pair.position.empty()) throw std::invalid_argument("a stress field of one point at least");
    Json json{{"schema", "cleave.stress_field/1"}, {"particles", pair.particle_solver}, {"fem", pair.fem_solver}};
    const std::vector<std::size_t> points = chosen(pair.position.size());
    json["total"] = pair.position.size();
    json["shown"] = points.size();
    json["measures"] = Json::array();
    for (const StressMeasure& measure : stress_measures()) json["measures"].push_back(measure_json(measure, pair));
    std::vector<double> position, radius, stress, difference;
    const double stands_for = static_cast<double>(pair.position.size()) / static_cast<double>(points.size());
    for (const std::size_t i : points) {
        position.insert(position.end(), pair.position[i].begin(), pair.position[i].end());
        radius.push_back(std::cbrt(stands_for * pair.volume[i] * 3 / (4 * std::numbers::pi)));
        for (std::size_t k = 0; k < 6; ++k) {
            stress.push_back(pair.particles[i][k]);
            difference.push_back(pair.particles[i][k] - pair.fem[i][k]);
        }
    }
    json["position"] = packed(position);
    json["radius"] = packed(radius);
    json["stress"] = packed(stress);
    json["difference"] = packed(difference);
    return json.dump() + "\n";
}

Artifact write_stress_field(const StressPair& pair, const std::string& file, const std::string& title, const std::filesystem::path& out) {
    write_file_atomic(out / file, stress_field_json(pair));
    return {file, title, "", ""};
}

std::optional<Artifact> write_stress_field(const std::string& case_folder, const std::filesystem::path& out, const LevelSources& sources) {
    StressPair pair;
    const FieldSource* particles = first_found(
        sources, {"sph.conforming", "sph.conforming_recovered", "sph.quadratic", "sph.corrected", "sph.conforming_operator", "sph.paper"}, pair.particle_solver);
    const FieldSource* fem = first_found(sources, {"fem.p2", "fem.p1"}, pair.fem_solver);
    if (!particles || !fem) return std::nullopt;
    const Samples& samples = particles->everywhere();
    pair.position = samples.position;
    pair.volume = samples.weight;
    pair.particles = samples.stress;
    pair.fem = fem->inside(samples.position).stress;
    return write_stress_field(pair, case_folder + "/stress_field.json", fmt::format("Stress by {} and {}", pair.particle_solver, pair.fem_solver), out);
}

}  // namespace cleave::validation
