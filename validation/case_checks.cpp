#include "validation/case_checks.hpp"

#include "solver/input/read_values.hpp"
#include "validation/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cleave::validation {

namespace {

using Defaults = std::map<std::string, SolutionCall>;

using Names = std::vector<std::string>;

std::vector<std::string> read_solvers(TableReader& table, const Names& known) {
    std::vector<std::string> solvers = table.strings("solver");
    for (const std::string& name : solvers)
        if (std::find(known.begin(), known.end(), name) == known.end())
            table.fail("solver", fmt::format("one of {} (not '{}')", fmt::join(known, ", "), name));
    if (solvers.empty()) table.fail("solver", "at least one solver");
    return solvers;
}

Names names_of(const std::vector<QuantityInfo>& list) {
    Names names;
    for (const QuantityInfo& quantity : list) names.push_back(quantity.name);
    return names;
}

const QuantityInfo& info_of(const std::string& quantity, const std::vector<QuantityInfo>& list) {
    return *std::find_if(list.begin(), list.end(), [&](const QuantityInfo& info) { return info.name == quantity; });
}

/// The dimension of a check's numbers; angles are judged and shown in degrees.
struct Unit {
    Dimension dimension;
    bool angle = false;
    double read(TableReader& table, const std::string& key) const {
        return angle ? degrees(table.angle(key)) : table.quantity(key, dimension);
    }
};

Names components_of(const std::string& quantity) {
    if (quantity == "displacement" || quantity == "principal_direction") return {"x", "y", "z"};
    if (quantity == "stress_intensity") return {"I", "II", "III"};
    if (quantity == "crack_direction") return {"hoop", "hoop_size", "energy", "weighted"};
    if (is_front_quantity(quantity) || is_principal_quantity(quantity)) return {};
    return {"xx", "yy", "zz", "yz", "xz", "xy"};
}

Observable read_observable(TableReader& table) {
    Observable observable{table.choice("quantity", names_of(quantities())), ""};
    if (!table.has("component")) return observable;
    if (is_scalar(observable.quantity)) table.fail("component", "no component for a quantity of the whole body");
    const Names components = components_of(observable.quantity);
    if (components.empty()) table.fail("component", "no component for this quantity");
    observable.component = table.choice("component", components);
    return observable;
}

void read_value(TableReader& reference, Unit unit, Reference& result) {
    result.kind = Reference::Kind::value;
    result.value = unit.read(reference, "value");
    result.source = reference.string("source");
}

Reference read_reference(TableReader& table, const Defaults& defaults, Unit unit) {
    auto reference = table.table_if("reference");
    if (!reference) return {};
    Reference result;
    if (reference->has("value") + reference->has("solution") + reference->has("solver") != 1)
        reference->fail("", "exactly one of value, solution, solver");
    if (reference->has("value")) {
        read_value(*reference, unit, result);
    } else if (reference->has("solution")) {
        result.kind = Reference::Kind::solution;
        result.solution = read_solution_call(*reference, defaults);
        result.source = result.solution->name;
    } else {
        result.kind = Reference::Kind::solver;
        result.source = reference->choice("solver", {"fem.p1", "fem.p2"});
    }
    return result;
}

Band read_limits(TableReader& table, Unit unit) {
    Band band;
    const auto positive = [&](const char* key, double value) {
        if (!(value > 0)) table.fail(key, "a positive number");
        return value;
    };
    if (table.has("relative")) band.relative = positive("relative", table.number("relative"));
    if (table.has("absolute")) band.absolute = positive("absolute", unit.read(table, "absolute"));
    if (table.has("order_at_least")) band.order_at_least = positive("order_at_least", table.number("order_at_least"));
    if (table.has("side")) band.side = table.choice("side", {"below", "above"}) == "below" ? BandSide::below : BandSide::above;
    if (band.empty()) table.fail("", "at least one of relative, absolute, order_at_least, side");
    return band;
}

/// One band for all solvers, or a table of them by solver; the solvers' names have dots and so stand in quotes.
std::map<std::string, Band> read_bands(TableReader& table, const Names& solvers, const Names& known, Unit unit) {
    std::map<std::string, Band> bands;
    auto band = table.table_if("band");
    if (!band) return bands;
    bool by_solver = false;
    for (const std::string& solver : known)
        if (band->has(solver)) {
            by_solver = true;
            if (std::find(solvers.begin(), solvers.end(), solver) == solvers.end()) band->fail(solver, "a solver of this check");
            TableReader own = band->table(solver);
            bands[solver] = read_limits(own, unit);
        }
    if (!by_solver) bands[""] = read_limits(*band, unit);
    return bands;
}

void read_place(TableReader& table, const Case& of, Check& check) {
    constexpr double any_size = 1;  // only whether the text can be read is asked here
    if (table.has("over") && table.has("at")) table.fail("over", "either 'over' or 'at'");
    if (auto over = table.table_if("over")) {
        check.region = over->string_or("region", "");
        check.norm = over->choice_or("norm", {"rms", "max", "p95"}, "rms");
        try {
            (void)Region(check.region, region_names(*of.shape, any_size));
        } catch (const std::invalid_argument& error) {
            over->fail("region", error.what());
        }
    }
    if (table.has("at")) check.at = table.vectors("at", dimension::length);
}

/// In the ladder's unit, as the ladder's sizes are.
std::optional<double> read_size(TableReader& table, const Case& of) {
    if (!table.has("at_size")) return std::nullopt;
    const double size = table.number("at_size") * (of.ladder_unit_name.empty() ? 1 : of.shape->length(of.ladder_unit_name));
    if (!(size > 0)) table.fail("at_size", "a positive size, in the unit of the ladder");
    return size;
}

/// What holds for checks of every kind.
void require_reasons(const TableReader& table, const Check& check) {
    if (!check.bands.empty() && check.reference.kind == Reference::Kind::none) table.fail("reference", "a reference for the band (the key is missing)");
    if (!check.bands.empty() && check.basis.empty()) table.fail("basis", "why the band is that wide (the key is missing)");
    if (check.must_fail && check.bands.empty()) table.fail("band", "a band for a must-fail twin (the key is missing)");
    if (check.reference.kind == Reference::Kind::value && check.reference.value == 0)
        for (const auto& [solver, band] : check.bands)
            if (band.relative) table.fail("band", "an absolute band beside a reference of zero");
}

/// Of a quantity that has places and one component where it has any.
void require_places(const TableReader& table, const Check& check) {
    if (check.at.empty()) table.fail("at", "places; of a crack's front the nearest count (the key is missing)");
    if (!components_of(check.observable.quantity).empty() && check.observable.component.empty())
        table.fail("component", fmt::format("one of {} (the key is missing)", fmt::join(components_of(check.observable.quantity), ", ")));
}

void require_consistency(const TableReader& table, const Check& check, const Case& of) {
    for (const auto& [solver, band] : check.bands)
        if (band.order_at_least && !of.shape->uniform_refinement() && !is_front_quantity(check.observable.quantity))
            table.fail("band", "no order_at_least for a shape whose mesh is graded, but for quantities of a crack's front");
    require_reasons(table, check);
    if (is_front_quantity(check.observable.quantity) || is_principal_quantity(check.observable.quantity)) return require_places(table, check);
    const bool scalar = is_scalar(check.observable.quantity);
    if (scalar && !check.at.empty()) table.fail("at", "no place for a quantity of the whole body");
    if (check.reference.kind == Reference::Kind::value && !scalar && (check.at.empty() || check.observable.component.empty()))
        table.fail("reference", "'at' and 'component' beside a reference value");
    for (const auto& [solver, band] : check.bands) {
        if (band.absolute && check.observable.component.empty() && !scalar) table.fail("band", "'component' beside an absolute band");
        if (band.side != BandSide::either && !scalar) table.fail("band", "no side for a field");
    }
}

}  // namespace

Coordinates region_names(const geometry::Shape& shape, double size) {
    Coordinates names = shape.coordinates();
    names["size"] = [size](const Point&) { return size; };
    return names;
}

std::optional<Side> reference_side(const Check& check, const Case& of) {
    switch (check.reference.kind) {
        case Reference::Kind::none: return std::nullopt;
        case Reference::Kind::solver: return of.side(check.reference.source);
        default: return Side::mathematics;
    }
}

const std::vector<std::string>& solver_names() {
    static const std::vector<std::string> names{"fem.p1", "fem.p2", "sph.paper", "sph.corrected", "sph.quadratic",
                                                "sph.conforming_operator", "sph.conforming", "sph.conforming_recovered",
                                                "sph.relaxed_paper", "sph.relaxed_corrected"};
    return names;
}

const std::vector<QuantityInfo>& quantities() {
    static const std::vector<QuantityInfo> list{
        {"displacement", dimension::length},
        {"strain", dimension::none},
        {"stress", dimension::pressure},
        {"energy", dimension::energy},                 // strain energy
        {"external_work", dimension::energy},          // of the loads
        {"residual", dimension::none},                 // |f - K u| / |f| of an equilibrium solve
        {"patch_residual", dimension::none},           // the same for the exact field of [particles] solution, not solved for
        {"estimated_error", dimension::none},          // of finite elements in the energy norm (Zienkiewicz and Zhu), relative
        {"vertex_sensitivity", dimension::none},       // relative change of the energy when every vertex moves by 1e-9 of the size
        {"net_force", dimension::none},                // |sum F| / sum |F|
        {"net_torque", dimension::none},               // |sum x cross F| / sum |x| |F|
        {"force_error", dimension::none},              // force against finite differences of the energy
        {"force_error_as_printed", dimension::none},   // the same for Eq. 9 as printed
        {"rotated_energy_error", dimension::none},     // change of the corotated energy when the body turns by 1 rad
        {"energy_release_rate", dimension::energy_per_area},         // moved vertices, whole front
        {"energy_release_rate_domain", dimension::energy_per_area},  // domain integral, whole front
        {"stress_intensity", dimension::stress_intensity},           // at a place of the front, by interaction integral
        {"energy_release_rate_at", dimension::energy_per_area},      // at a place of the front, domain integral
        {"energy_release_rate_from_k", dimension::energy_per_area},  // the same from the stress intensities
        {"energy_release_gap", dimension::none},                     // |from_k / at - 1|
        {"crack_direction", dimension::none, true},                  // kink at a place of the front, from its stress intensities; hoop_size: of two equal maxima
        {"principal_direction", dimension::none, true},              // largest principal stress at a point: angle from an axis, 0 to 90 deg
        {"principal_gap", dimension::none},                          // its distance to the second over the tensor's norm
        {"crack_opening", dimension::length},                        // at the crack's centre
        {"acceleration_balance", dimension::none}};    // free body: |load - mass * acceleration| and its moment, relative
    return list;
}

bool is_front_quantity(const std::string& quantity) {
    return quantity == "stress_intensity" || quantity == "energy_release_rate_at" || quantity == "energy_release_rate_from_k" ||
           quantity == "energy_release_gap" || quantity == "crack_direction";
}

bool is_principal_quantity(const std::string& quantity) { return quantity == "principal_direction" || quantity == "principal_gap"; }

bool is_scalar(const std::string& quantity) {
    return quantity != "displacement" && quantity != "strain" && quantity != "stress" && !is_front_quantity(quantity) &&
           !is_principal_quantity(quantity);
}

namespace {

void read_unit(TableReader& table, const std::vector<QuantityInfo>& list, Check& check) {
    const QuantityInfo& info = info_of(check.observable.quantity, list);
    check.unit = info.dimension;
    check.angle = info.angle;
    if (!table.has("divide_by")) return;
    check.divide_by = Unit{check.unit, check.angle}.read(table, "divide_by");
    if (!(check.divide_by > 0)) table.fail("divide_by", "a positive quantity");
    check.unit = dimension::none;
    check.angle = false;
}

void read_judgement(TableReader& table, const Names& solvers, Check& check) {
    check.bands = read_bands(table, check.solvers, solvers, {check.unit, check.angle});
    check.basis = table.string_or("basis", "");
    check.must_fail = table.boolean_or("must_fail", false);
}

Reference read_study_reference(TableReader& table, const StudyInfo& study, Unit unit) {
    auto reference = table.table_if("reference");
    if (!reference) return {};
    if (reference->has("value") == reference->has("solver")) reference->fail("", "exactly one of value, solver");
    Reference result;
    if (reference->has("value")) {
        read_value(*reference, unit, result);
        return result;
    }
    result.kind = Reference::Kind::solver;
    result.source = reference->choice("solver", study.methods);
    return result;
}

}  // namespace

Check read_study_check(TableReader& table, const StudyInfo& study) {
    Check check;
    check.where = table.dotted("");
    check.where.pop_back();
    check.observable.quantity = table.choice("quantity", names_of(study.quantities));
    read_unit(table, study.quantities, check);
    check.solvers = read_solvers(table, study.methods);
    if (table.has("place")) check.places = table.strings("place");
    check.reference = read_study_reference(table, study, {check.unit, check.angle});
    read_judgement(table, study.methods, check);
    for (const auto& [solver, band] : check.bands)
        if (band.order_at_least) table.fail("band", "no order_at_least in a study");
    require_reasons(table, check);
    return check;
}

Check read_check(TableReader& table, const Defaults& defaults, const Case& of) {
    Check check;
    check.where = table.dotted("");
    check.where.pop_back();
    check.observable = read_observable(table);
    read_unit(table, quantities(), check);
    check.solvers = read_solvers(table, solver_names());
    check.reference = read_reference(table, defaults, {check.unit, check.angle});
    read_judgement(table, solver_names(), check);
    check.at_size = read_size(table, of);
    read_place(table, of, check);
    require_consistency(table, check, of);
    return check;
}

Profile read_profile(TableReader& table, const Defaults& defaults, const Case& of) {
    Profile profile;
    profile.where = table.dotted("");
    profile.where.pop_back();
    profile.title = table.string("title");
    profile.observable = read_observable(table);
    if (profile.observable.component.empty()) table.fail("component", "the component to draw");
    profile.solvers = read_solvers(table, solver_names());
    if (table.has("solution")) profile.reference = read_solution_call(table, defaults);
    profile.from = table.vector("from", dimension::length);
    profile.to = table.vector("to", dimension::length);
    if (table.has("points")) profile.points = read_integer(table, "points", 2, 100'000);
    profile.x = table.string("x");
    profile.y = table.string("y");
    profile.divide_by = table.quantity_or("divide_by", info_of(profile.observable.quantity, quantities()).dimension, 1);
    if (!(profile.divide_by > 0)) table.fail("divide_by", "a positive quantity");
    profile.reach = table.quantity_or("reach", dimension::length, 0);
    try {
        (void)parse_term(profile.x, of.shape->coordinates());
    } catch (const std::invalid_argument& error) {
        table.fail("x", error.what());
    }
    return profile;
}

}  // namespace cleave::validation
