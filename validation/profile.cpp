#include "validation/profile.hpp"

#include "solver/input/file_io.hpp"
#include "validation/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleave::validation {

namespace {

struct Entry {
    double x;
    std::size_t column;
    double y;
};

std::vector<Point> points_on(const Profile& profile) {
    std::vector<Point> points;
    for (int i = 0; i < profile.points; ++i) {
        const double t = static_cast<double>(i) / (profile.points - 1);
        Point point{};
        for (std::size_t k = 0; k < 3; ++k) point[k] = profile.from[k] + t * (profile.to[k] - profile.from[k]);
        points.push_back(point);
    }
    return points;
}

double distance_to_line(const Profile& profile, const Point& point) {
    double along = 0, square = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double d = profile.to[k] - profile.from[k], p = point[k] - profile.from[k];
        along += d * p, square += p * p, length += d * d;
    }
    const double t = along / length;
    if (t < 0 || t > 1) return INFINITY;
    return std::sqrt(std::max(0.0, square - along * along / length));
}

Samples near_the_line(const Profile& profile, const Samples& all) {
    Samples near;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!(distance_to_line(profile, all.position[i]) <= profile.reach)) continue;
        near.position.push_back(all.position[i]);
        near.displacement.push_back(all.displacement[i]);
        near.strain.push_back(all.strain[i]);
        near.stress.push_back(all.stress[i]);
    }
    return near;
}

}  // namespace

Artifact write_profile(const Profile& profile, const std::string& file, const std::filesystem::path& folder, LevelSources& sources) {
    const auto abscissa = parse_term(profile.x, sources.of().shape->coordinates());
    std::vector<std::string> columns;
    std::vector<Entry> entries;
    const auto add = [&](const std::string& name, const Samples& samples) {
        columns.push_back(name);
        for (std::size_t i = 0; i < samples.size(); ++i)
            entries.push_back({abscissa(samples.position[i]), columns.size(), observe(profile.observable, samples, i)[0] / profile.divide_by});
    };
    if (profile.reference) add("reference", evaluate(make_field(*profile.reference, sources.of()), points_on(profile)));
    for (const std::string& solver : profile.solvers) {
        FieldSource& source = sources.get(solver);
        add(solver, solver.starts_with("fem.") ? source.at(points_on(profile)) : near_the_line(profile, source.everywhere()));
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.x < b.x; });
    std::string text = profile.x + "," + fmt::format("{}\n", fmt::join(columns, ","));
    for (const Entry& entry : entries) {
        if (!std::isfinite(entry.y)) continue;
        text += fmt::format("{:.9g}", entry.x);
        for (std::size_t column = 1; column <= columns.size(); ++column)
            text += column == entry.column ? fmt::format(",{:.9g}", entry.y) : std::string(",");
        text += "\n";
    }
    write_file_atomic(folder / file, text);
    return {file, profile.title, profile.x, profile.y};
}

}  // namespace cleave::validation
