#include "validation/front_profile.hpp"

#include "solver/input/file_io.hpp"
#include "validation/case_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cleave::validation {

namespace {

struct Column {
    std::string title, quantity, component;
};

bool asks_for_the_front(const Case& of) {
    return std::any_of(of.checks.begin(), of.checks.end(), [](const Check& check) { return is_front_quantity(check.observable.quantity); });
}

const FieldSource* best_elements(const LevelSources& sources) {
    const FieldSource* quadratic = sources.find("fem.p2");
    return quadratic ? quadratic : sources.find("fem.p1");
}

std::string table(const std::vector<geometry::CrackFront>& fronts, const FieldSource& source, const std::vector<Column>& columns) {
    std::string text = "along";
    for (const Column& column : columns) text += "," + column.title;
    text += "\n";
    for (const geometry::CrackFront& front : fronts) {
        const int places = front.loop > 0 ? 12 : 1;
        for (int i = 0; i < places; ++i) {
            const double along = front.loop > 0 ? (i + 0.5) / places * front.length : 0;
            text += fmt::format("{:.9g}", along);
            for (const Column& column : columns) text += fmt::format(",{:.9g}", source.at_front(column.quantity, column.component, front.point_at(along)));
            text += "\n";
        }
    }
    return text;
}

}  // namespace

std::vector<Artifact> write_fronts(const Case& of, const LevelSources& sources, const std::string& case_folder, const std::filesystem::path& out) {
    const FieldSource* source = best_elements(sources);
    if (!source || !asks_for_the_front(of)) return {};
    const std::vector<geometry::CrackFront> fronts = of.shape->crack_fronts();
    const Artifact release{case_folder + "/front_energy_release.csv", "Energy release rate along the front", "along the front (m)", "G (J/m^2)"};
    const Artifact intensities{case_folder + "/front_intensities.csv", "Stress intensities along the front", "along the front (m)", "K (Pa m^0.5)"};
    write_file_atomic(out / release.file, table(fronts, *source, {{"domain integral", "energy_release_rate_at", ""}, {"from K", "energy_release_rate_from_k", ""}}));
    write_file_atomic(out / intensities.file,
                      table(fronts, *source, {{"K_I", "stress_intensity", "I"}, {"K_II", "stress_intensity", "II"}, {"K_III", "stress_intensity", "III"}}));
    return {release, intensities};
}

}  // namespace cleave::validation
