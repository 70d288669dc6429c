#include "validation/coverage.hpp"

#include "validation/symmetry_class.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>

namespace cleave::validation {

namespace {

const std::map<std::string, std::string>& family_of_quantity() {
    static const std::map<std::string, std::string> families = [] {
        std::map<std::string, std::string> all;
        const auto add = [&](const char* family, std::initializer_list<const char*> quantities) {
            for (const char* quantity : quantities) all[quantity] = family;
        };
        add("displacement", {"displacement", "displacement_error", "crack_opening"});
        add("strain", {"strain"});
        add("stress", {"stress", "stress_error", "principal_stress", "principal_stress_error", "axial_stress", "edge_tension", "boussinesq_error",
                       "patch_error"});
        add("energy and stiffness", {"energy", "external_work", "estimated_error", "bar_modulus_error", "wave_speed_error"});
        add("balance", {"residual", "patch_residual", "net_force", "net_torque", "force_error", "acceleration_balance", "load_imbalance",
                        "load_imbalance_of_catalogue", "divergence", "rotated_energy_error"});
        add("energy release rate", {"energy_release_rate", "energy_release_rate_domain", "energy_release_rate_at", "energy_release_rate_from_k",
                                    "energy_release_gap", "equilibrium_radius", "load_exponent", "front_energy_release_error",
                                    "penny_energy_release_error"});
        add("stress intensity", {"stress_intensity"});
        add("crack direction", {"crack_direction", "direction", "direction_difference", "direction_error", "crack_turn", "turn_at_interface",
                                "principal_direction", "principal_gap"});
        add("contact", {"contact_radius", "peak_pressure", "approach", "depth", "force", "indentation_modulus", "surface_compliance_error", "paraboloid_error",
                        "differentiation_error", "shear_over_pressure", "depth_over_radius", "relative_radius", "peak_force", "duration", "misfit", "resultant"});
        return all;
    }();
    return families;
}

/// Why the shipped cases leave cells empty. The first rule that matches counts; no method matches any.
struct Rule {
    std::string family;
    std::optional<Side> method;
    std::string why;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> list{
        {"contact", Side::fem, "contact by finite elements is judged where a closed form exists: isotropic bodies, cubic and transversely isotropic punches"},
        {"contact", {}, "half-space fields and indentation take any stiffness by the same code (Stroh): every material of the catalogue at level full"},
        {"stress intensity", Side::particles, "the particles give stress intensities along straight fronts only, in the classes judged"},
        {"stress intensity", {}, "closed forms for every class share one code with those judged (Stroh); by finite elements as well"},
        {"energy release rate", Side::fem, "cracks of every anisotropy take one path (Barnett and Lothe's L): literature values, and at level full pennies in random tensors of every class"},
        {"crack direction", {}, "criteria are functions of stress intensities or of principal stresses; judged on the classes with literature values"},
        {"strain", {}, "strain operators see no material: judged on one, the limit is the same for all (operators_sweep)"},
        {"displacement", {}, "patch tests judge the stress, which is exact only if the displacement is"},
        {"balance", {}, "balance of forces is checked on the general (triclinic) tensor, which contains the others"},
    };
    return list;
}

std::string reason(const CoverageCell& cell) {
    for (const Rule& rule : rules())
        if (rule.family == cell.family && (!rule.method || *rule.method == cell.method)) return rule.why;
    return "";
}

/// Rows of a sweep over materials have their class for a place.
bool is_symmetry_class(const std::string& place) {
    return std::find(symmetry_classes().begin(), symmetry_classes().end(), place) != symmetry_classes().end();
}

}  // namespace

const std::vector<std::string>& quantity_families() {
    static const std::vector<std::string> families{"displacement", "strain", "stress", "energy and stiffness", "balance", "energy release rate",
                                                   "stress intensity", "crack direction", "contact"};
    return families;
}

std::string quantity_family(const std::string& quantity) {
    const auto found = family_of_quantity().find(quantity);
    return found == family_of_quantity().end() ? "" : found->second;
}

std::vector<CoverageCell> coverage(const std::vector<CaseResult>& cases) {
    std::vector<CoverageCell> cells;
    for (const std::string& symmetry : symmetry_classes())
        for (const std::string& family : quantity_families())
            for (const Side method : {Side::particles, Side::fem, Side::mathematics}) cells.push_back({symmetry, family, method, 0, {}, ""});
    for (const CaseResult& of : cases)
        for (const Row& row : of.rows) {
            if (row.must_fail) continue;
            const std::string family = quantity_family(row.quantity);
            const bool of_one_class = is_symmetry_class(row.place);
            for (CoverageCell& cell : cells) {
                if (cell.family != family || std::find(of.symmetry.begin(), of.symmetry.end(), cell.symmetry) == of.symmetry.end()) continue;
                if (of_one_class && row.place != cell.symmetry) continue;
                if (row.side != cell.method && !(cell.method == Side::mathematics && row.reference_side == Side::mathematics)) continue;
                ++cell.checks;
                if (cell.cases.empty() || cell.cases.back() != of.name) cell.cases.push_back(of.name);
            }
        }
    for (CoverageCell& cell : cells)
        if (cell.checks == 0) cell.why = reason(cell);
    return cells;
}

}  // namespace cleave::validation
