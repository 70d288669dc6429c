#include "validation/studies/algorithm_1.hpp"

#include "solver/input/read_values.hpp"
#include "solver/material/material.hpp"
#include "validation/studies/algorithm_1_parts.hpp"

namespace cleave::validation {

namespace {

class Algorithm1 final : public Study {
public:
    Algorithm1(Algorithm1Setup setup, std::vector<double> quick, std::vector<double> full)
        : setup_(std::move(setup)), quick_(std::move(quick)), full_(std::move(full)) {}

    StudyOutcome run(const StudyContext& context) const override {
        Algorithm1Setup setup = setup_;
        setup.sizes = context.level == "full" ? full_ : quick_;
        StudyOutcome outcome;
        measure_groups(setup, context, outcome);
        measure_invariance(setup, context, outcome);
        measure_interface(setup, context, outcome);
        measure_kernel_axes(setup, context, outcome);
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return {setup_.stiffness, setup_.second}; }

private:
    Algorithm1Setup setup_;
    std::vector<double> quick_, full_;
};

double positive(TableReader& table, const std::string& key, Dimension dimension) {
    const double value = table.quantity(key, dimension);
    if (!(value > 0)) table.fail(key, "a value above zero");
    return value;
}

int count(TableReader& table, const std::string& key) {
    const long value = table.integer(key);
    if (value < 1 || value > 1000) table.fail(key, "a whole number from 1 to 1000");
    return static_cast<int>(value);
}

std::vector<double> lengths(TableReader& table, const std::string& key) {
    const std::vector<double> values = read_quantities(table, key, dimension::length);
    for (const double value : values)
        if (!(value > 0)) table.fail(key, "lengths above zero");
    if (values.empty()) table.fail(key, "at least one size");
    return values;
}

material::Stiffness stiffness_of(TableReader& study, const std::string& key) {
    TableReader table = study.table(key);
    return material::read_material(table).stiffness;
}

std::shared_ptr<const geometry::Shape> shape_of(TableReader& study, const std::string& key) {
    TableReader table = study.table(key);
    return geometry::read_shape(table);
}

std::shared_ptr<const Study> read(TableReader& study) {
    Algorithm1Setup setup;
    setup.stiffness = stiffness_of(study, "material");
    setup.second = stiffness_of(study, "second_material");
    setup.strength = positive(study, "strength", dimension::pressure);
    setup.toughness = positive(study, "toughness", dimension::energy_per_area);
    setup.energy_limit = positive(study, "energy_limit", dimension::pressure);
    setup.block = shape_of(study, "block");
    setup.laminate = shape_of(study, "laminate");
    setup.plate = shape_of(study, "plate");
    setup.laminate_size = positive(study, "laminate_size", dimension::length);
    setup.plate_size = positive(study, "plate_size", dimension::length);
    setup.contact_radius = positive(study, "contact_radius", dimension::length);
    setup.neighbourhood = positive(study, "neighbourhood", dimension::length);
    setup.force = positive(study, "force", dimension::force);
    setup.friction = study.number("friction");
    setup.plate_contact_radius = positive(study, "plate_contact_radius", dimension::length);
    setup.groups = count(study, "groups");
    setup.plate_groups = count(study, "plate_groups");
    return std::make_shared<Algorithm1>(setup, lengths(study, "quick"), lengths(study, "full"));
}

}  // namespace

StudyInfo algorithm_1_study() {
    return {"algorithm_1",
            "Algorithm 1 under a contact on a block, against the half-space in closed form",
            {"material", "second_material", "strength", "toughness", "energy_limit", "block", "laminate", "plate", "quick", "full",
             "laminate_size", "plate_size", "contact_radius", "plate_contact_radius", "neighbourhood", "force", "friction", "groups",
             "plate_groups"},
            {{"stress_error", dimension::none},
             {"principal_stress_error", dimension::none},
             {"direction_error", dimension::none, true},
             {"gap_error", dimension::none},
             {"undefined_groups", dimension::none},
             {"principal_stress", dimension::pressure},
             {"gap", dimension::none},
             {"normal_tilt", dimension::none, true},
             {"cracks", dimension::none},
             {"considered", dimension::none},
             {"numbering_difference", dimension::none},
             {"energy_over_one_group", dimension::none},
             {"outer_radius", dimension::length},
             {"inner_radius", dimension::length},
             {"inner_radius_decreases", dimension::none},
             {"critical_points", dimension::none},
             {"critical_point_height", dimension::length},
             {"turn_at_interface", dimension::none, true},
             {"breaking_share", dimension::none},
             {"breaking_cracks", dimension::none},
             {"breaking_ratio", dimension::none}},
            {"azimuth", "k_means", "distance", "paper", "members", "exact azimuth", "exact k_means", "exact distance", "exact members",
             "exact paper", "by_number", "of_outer_radius"},
            read,
            {"exact azimuth", "exact k_means", "exact distance", "exact members", "exact paper"}};
}

}  // namespace cleave::validation
