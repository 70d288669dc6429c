#include "validation/solutions.hpp"

#include "validation/analytic/laminate.hpp"
#include "validation/analytic/lekhnitskii_hole.hpp"
#include "validation/analytic/linear_displacement.hpp"
#include "validation/analytic/manufactured_trigonometric.hpp"
#include "validation/analytic/sneddon_penny.hpp"
#include "validation/analytic/uniform_stress.hpp"
#include "validation/crack_solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cleave::validation {

namespace {

const SolutionInfo& info(const std::string& name, const TableReader& reader, const std::string& key) {
    std::string known;
    for (const SolutionInfo& solution : solutions()) {
        if (solution.name == name) return solution;
        known += (known.empty() ? "" : ", ") + solution.name;
    }
    reader.fail(key, fmt::format("one of {} (not '{}')", known, name));
}

void read_keys(const SolutionInfo& solution, TableReader& table, SolutionCall& call) {
    for (const SolutionInfo::Key& key : solution.keys) {
        if (!table.has(key.name)) continue;
        switch (key.kind) {
            case SolutionInfo::Key::Kind::word: call.words[key.name] = table.choice(key.name, key.choices); break;
            case SolutionInfo::Key::Kind::angle: call.numbers[key.name] = table.angle(key.name); break;
            case SolutionInfo::Key::Kind::number: call.numbers[key.name] = table.number(key.name); break;
            case SolutionInfo::Key::Kind::quantity: call.numbers[key.name] = table.quantity(key.name, key.dimension); break;
            case SolutionInfo::Key::Kind::vector: call.vectors[key.name] = table.vector(key.name, key.dimension); break;
        }
    }
}

std::string word(const SolutionCall& call, const std::string& key, const std::string& fallback) {
    const auto found = call.words.find(key);
    return found == call.words.end() ? fallback : found->second;
}

double number(const SolutionCall& call, const std::string& key, double fallback) {
    const auto found = call.numbers.find(key);
    return found == call.numbers.end() ? fallback : found->second;
}

double quantity(const SolutionCall& call, const std::string& key) {
    const auto found = call.numbers.find(key);
    if (found == call.numbers.end()) throw std::invalid_argument("the key '" + key + "' in [solution." + call.name + "]");
    return found->second;
}

/// The edge of the shape's bounding box or its "length": the scale of a manufactured wave.
double body_length(const Case& of) {
    for (const char* key : {"extent", "length", "half_width"})
        try {
            return of.shape->length(key);
        } catch (const std::invalid_argument&) {
        }
    return 1;
}

analytic::Field build_uniform_stress(const SolutionCall& call, const analytic::Stiffness& stiffness) {
    const auto vector = [&](const char* key, const std::array<double, 3>& fallback) {
        const auto found = call.vectors.find(key);
        return found == call.vectors.end() ? fallback : found->second;
    };
    const auto normal = vector("normal", {}), shear = vector("shear", {});
    const analytic::Voigt stress{normal[0], normal[1], normal[2], shear[0], shear[1], shear[2]};
    return analytic::uniform_stress(stiffness, stress, vector("axis", {0, 0, 1}), number(call, "angle", 0));
}

analytic::Field build(const SolutionCall& call, const Case& of, const analytic::Stiffness& stiffness) {
    if (is_crack_solution(call.name)) return make_crack_field(call, of, stiffness);
    if (call.name == "linear_displacement") return analytic::linear_displacement(stiffness, analytic::generic_gradient());
    if (call.name == "manufactured_trigonometric")
        return analytic::manufactured_trigonometric(stiffness, number(call, "wavelength", 1) * body_length(of), number(call, "scale", 1));
    if (call.name == "uniform_stress") return build_uniform_stress(call, stiffness);
    if (call.name == "sneddon_penny")
        return analytic::sneddon_penny(stiffness, of.shape->length("crack_radius"), quantity(call, "pressure"), number(call, "box_factor", 1));
    const auto remote = call.vectors.find("remote");
    if (remote == call.vectors.end()) throw std::invalid_argument("the key 'remote' (xx, yy, xy) in [solution.lekhnitskii_hole]");
    const auto state = word(call, "plane", "strain") == "strain" ? analytic::PlaneState::strain : analytic::PlaneState::stress;
    const auto& [xx, yy, xy] = remote->second;
    return analytic::lekhnitskii_hole(stiffness, of.shape->length("hole_radius"), {xx, yy, xy}, state);
}

}  // namespace

const std::vector<SolutionInfo>& solutions() {
    using Kind = SolutionInfo::Key::Kind;
    static const std::vector<SolutionInfo> own{
        {"linear_displacement", "u = A x with a generic A: the patch test, any material and shape", {}},
        {"manufactured_trigonometric", "plane waves with the body force that balances them, any material; scale multiplies the strain, wavelength the waves' length",
         {{"scale", Kind::number, {}, {}}, {"wavelength", Kind::number, {}, {}}}},
        {"lekhnitskii_hole",
         "circular hole in an infinite plate, z = 0 a plane of elastic symmetry (Lekhnitskii 1968)",
         {{"plane", Kind::word, {"strain", "stress"}, {}}, {"remote", Kind::vector, {}, dimension::pressure}}},
        {"laminate", "two layers, piecewise linear displacement: exact for any two materials (laminate_block)", {}},
        {"uniform_stress",
         "the same stress everywhere, any material and shape; normal xx, yy, zz and shear yz, xz, xy in axes turned by angle about axis",
         {{"normal", Kind::vector, {}, dimension::pressure}, {"shear", Kind::vector, {}, dimension::pressure},
          {"axis", Kind::vector, {}, dimension::none}, {"angle", Kind::angle, {}, {}}}},
        {"sneddon_penny",
         "penny crack under pressure in infinite isotropic space: energy_release_rate, crack_opening, energy (Sneddon 1946)",
         {{"pressure", Kind::quantity, {}, dimension::pressure}, {"box_factor", Kind::number, {}, {}}}}};
    static const std::vector<SolutionInfo> list = [] {
        std::vector<SolutionInfo> all = own;
        all.insert(all.end(), crack_solutions().begin(), crack_solutions().end());
        return all;
    }();
    return list;
}

SolutionCall read_solution_call(TableReader& table, const std::map<std::string, SolutionCall>& defaults) {
    const std::string name = table.string("solution");
    const SolutionInfo& solution = info(name, table, "solution");
    const auto found = defaults.find(name);
    SolutionCall call = found == defaults.end() ? SolutionCall{} : found->second;
    call.name = name;
    call.where = table.dotted("solution");
    read_keys(solution, table, call);
    return call;
}

SolutionCall read_solution_defaults(const std::string& name, TableReader& table, const TableReader& parent) {
    SolutionCall call;
    call.name = name;
    call.where = parent.dotted(name);
    read_keys(info(name, parent, name), table, call);
    return call;
}

namespace {
analytic::Field build_laminate(const Case& of) {
    const auto lower = of.materials.find("lower"), upper = of.materials.find("upper");
    if (lower == of.materials.end() || upper == of.materials.end()) throw std::invalid_argument("materials for the regions lower and upper");
    return analytic::laminate(plain_stiffness(lower->second.stiffness), plain_stiffness(upper->second.stiffness), of.shape->length("interface"),
                              analytic::generic_gradient());
}
}  // namespace

analytic::Field make_field(const SolutionCall& call, const Case& of) try {
    if (call.name == "laminate") return build_laminate(of);
    const auto whole = of.materials.find("");
    if (whole == of.materials.end()) of.fail(call.where, "a body of one material for this solution");
    return build(call, of, plain_stiffness(whole->second.stiffness));
} catch (const std::invalid_argument& error) {
    of.fail(call.where, error.what());
}

analytic::Stiffness plain_stiffness(const material::Stiffness& stiffness) {
    analytic::Stiffness plain{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) plain[i][j] = stiffness(static_cast<int>(i), static_cast<int>(j));
    return plain;
}

}  // namespace cleave::validation
