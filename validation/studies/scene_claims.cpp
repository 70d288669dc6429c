#include "validation/studies/scene_claims.hpp"

#include "solver/simulation/statistics.hpp"
#include "validation/studies/scene_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace cleave::validation {

namespace {

using simulation::Simulation;

struct Claim {
    std::string name, quantity, larger, smaller;
};

class SceneClaims final : public Study {
public:
    std::vector<std::string> scenes;
    std::vector<Claim> claims;
    int quick_frames = 20, full_frames = 200;
    simulation::Overrides quick_set;

    StudyOutcome run(const StudyContext& context) const override {
        const bool quick = context.level == "quick";
        std::map<std::string, std::map<std::string, double>> measured;
        StudyOutcome outcome;
        for (const std::string& name : scenes) {
            Simulation simulation(simulation::find_scene(name, quick ? quick_set : simulation::Overrides{}), context.meshes);
            while (simulation.frame() < (quick ? quick_frames : full_frames)) simulation.advance();
            measured[name] = scene_figures(simulation);
            const Resolution resolution{.particles = simulation::count(simulation).physical};
            for (const auto& [quantity, value] : measured[name]) outcome.values.push_back({quantity, "solver", name, value, resolution});
            if (context.progress) context.progress(fmt::format("{}: {} frames", name, simulation.frame()));
        }
        for (const Claim& claim : claims) {
            const bool holds = measured.at(claim.larger).at(claim.quantity) > measured.at(claim.smaller).at(claim.quantity);
            outcome.values.push_back({"claim_holds", "solver", claim.name, holds ? 1.0 : 0.0, {}});
        }
        return outcome;
    }
};

std::vector<QuantityInfo> quantities() {
    std::vector<QuantityInfo> list = scene_quantities();
    list.push_back({"claim_holds", dimension::none});
    return list;
}

int frames(TableReader& table, const std::string& key) {
    const long value = table.integer(key);
    if (value < 1 || value > 100'000) table.fail(key, "an integer from 1 to 100000");
    return static_cast<int>(value);
}

std::vector<std::string> shipped_scenes(TableReader& table) {
    const std::vector<std::string> shipped = simulation::scene_names(), names = table.strings("scenes");
    for (const std::string& scene : names)
        if (std::find(shipped.begin(), shipped.end(), scene) == shipped.end())
            table.fail("scenes", fmt::format("names of shipped scenes ({})", fmt::join(shipped, ", ")));
    return names;
}

std::shared_ptr<const Study> read(TableReader& table) {
    auto study = std::make_shared<SceneClaims>();
    study->scenes = shipped_scenes(table);
    study->quick_frames = frames(table, "quick_frames");
    study->full_frames = frames(table, "full_frames");
    if (table.has("quick_set")) study->quick_set = read_overrides(table, "quick_set");
    std::vector<std::string> names;
    for (const QuantityInfo& quantity : scene_quantities()) names.push_back(quantity.name);
    for (TableReader& claim : table.tables_if("claims"))
        study->claims.push_back({claim.string("name"), claim.choice("quantity", names), claim.choice("larger", study->scenes),
                                 claim.choice("smaller", study->scenes)});
    return study;
}

}  // namespace

simulation::Overrides read_overrides(TableReader& table, const std::string& key) {
    simulation::Overrides overrides;
    for (const std::string& text : table.strings(key)) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) table.fail(key, fmt::format("texts KEY=VALUE (not '{}')", text));
        overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return overrides;
}

StudyInfo scene_claims_study() {
    return {"scene_claims", "what the paper's figures claim, measured on running scenes",
            {"scenes", "quick_frames", "full_frames", "quick_set", "claims"}, quantities(), {"solver"}, read};
}

}  // namespace cleave::validation
