#include "validation/case.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/input/read_values.hpp"
#include "validation/case_checks.hpp"
#include "validation/solutions.hpp"
#include "validation/symmetry_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

namespace cleave::validation {

namespace {

using Defaults = std::map<std::string, SolutionCall>;

Defaults read_solution_tables(TableReader& reader) {
    Defaults defaults;
    if (auto tables = reader.table_if("solution"))
        for (const std::string& name : tables->keys()) {
            TableReader table = tables->table(name);
            defaults[name] = read_solution_defaults(name, table, *tables);
        }
    return defaults;
}

std::map<std::string, material::Material> read_materials(TableReader& reader) {
    TableReader table = reader.table("material");
    std::map<std::string, material::Material> materials;
    if (!table.has("region")) {
        materials[""] = material::read_material(table);
        return materials;
    }
    for (TableReader& region : table.tables("region")) {
        const std::string of = region.string("of");
        if (!materials.emplace(of, material::read_material(region)).second) region.fail("of", "each region once");
    }
    return materials;
}

std::array<bool, 3> read_components(TableReader& load) {
    if (!load.has("components")) return {true, true, true};
    std::array<bool, 3> components{};
    for (const std::string& word : load.strings("components")) {
        if (word != "x" && word != "y" && word != "z") load.fail("components", fmt::format("an array of x, y, z (not '{}')", word));
        components[static_cast<std::size_t>(word[0] - 'x')] = true;
    }
    return components;
}

void check_surface(const TableReader& load, const std::string& name, const std::vector<std::string>& surfaces) {
    if (std::find(surfaces.begin(), surfaces.end(), name) == surfaces.end())
        load.fail("on", fmt::format("one of all, {} (not '{}')", fmt::join(surfaces, ", "), name));
}

PointSupport read_support(TableReader& load) {
    PointSupport support;
    support.at = load.vector("at", dimension::length);
    support.components = read_components(load);
    if (load.has("vector")) support.vector = load.vector("vector", dimension::length);
    return support;
}

LineCondition read_line(TableReader& load, bool force, const std::vector<std::string>& surfaces) {
    LineCondition line;
    const std::vector<std::string> on = load.strings("on");
    if (on.size() != 2 || on[0] == on[1]) load.fail("on", "the two surfaces that meet in the line");
    for (std::size_t i = 0; i < 2; ++i) {
        check_surface(load, on[i], surfaces);
        line.on[i] = on[i];
    }
    line.load = force;
    if (!force) line.components = read_components(load);
    line.vector = load.vector("vector", force ? dimension::force_per_length : dimension::length);
    return line;
}

SurfaceLoad read_load(TableReader& load, SurfaceLoad::Kind kind, const Defaults& defaults, const std::vector<std::string>& surfaces) {
    SurfaceLoad result;
    result.kind = kind;
    result.on = load.strings("on");
    for (const std::string& name : result.on)
        if (name != "all") check_surface(load, name, surfaces);
    if (kind == SurfaceLoad::Kind::pressure) {
        result.pressure = load.quantity("value", dimension::pressure);
        return result;
    }
    const bool displacement = kind == SurfaceLoad::Kind::displacement;
    if (displacement) result.components = read_components(load);
    if (load.has("solution") == load.has("vector")) load.fail("", "either 'vector' or 'solution'");
    if (load.has("solution"))
        result.solution = read_solution_call(load, defaults);
    else
        result.vector = load.vector("vector", displacement ? dimension::length : dimension::pressure);
    return result;
}

void read_loads(TableReader& reader, const Defaults& defaults, Case& result) {
    auto load = reader.table_if("load");
    if (!load) return;
    const std::vector<std::string> surfaces = result.shape->surface_names();
    using Kind = SurfaceLoad::Kind;
    for (const auto& [key, kind] : {std::pair{"traction", Kind::traction}, std::pair{"pressure", Kind::pressure}, std::pair{"displacement", Kind::displacement}})
        for (TableReader& entry : load->tables_if(key)) result.loads.push_back(read_load(entry, kind, defaults, surfaces));
    for (TableReader& entry : load->tables_if("support")) result.supports.push_back(read_support(entry));
    for (TableReader& entry : load->tables_if("line_displacement")) result.lines.push_back(read_line(entry, false, surfaces));
    for (TableReader& entry : load->tables_if("line_load")) result.lines.push_back(read_line(entry, true, surfaces));
    result.free_body = load->boolean_or("free_body", false);
    if (auto force = load->table_if("body_force")) {
        if (force->has("solution") == force->has("vector")) force->fail("", "either 'vector' or 'solution'");
        if (force->has("solution"))
            result.body_force_solution = read_solution_call(*force, defaults);
        else
            result.body_force = force->vector("vector", dimension::force_density);
    }
}

constexpr double most_tets = 1e8;  // a typing error: twenty times the largest body of the benchmarks

std::vector<double> checked_ladder(const TableReader& table, const std::string& key, std::vector<double> sizes, double unit, const geometry::Shape& shape) {
    if (sizes.empty()) table.fail(key, "at least one size");
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (!(sizes[i] > 0)) table.fail(key, "positive sizes");
        if (i > 0 && !(sizes[i] < sizes[i - 1])) table.fail(key, "sizes from coarse to fine");
    }
    for (double& size : sizes) size *= unit;
    const double tets = shape.expected_tets(sizes.back());
    if (tets > most_tets) table.fail(key, fmt::format("sizes that make at most {:g} tets (not about {:.1g})", most_tets, tets));
    return sizes;
}

std::vector<double> parse_ladder(const std::string& text) {
    std::vector<double> sizes;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        try {
            const Quantity size = parse_quantity(text.substr(begin, comma - begin));
            if (!(size.dimension == dimension::none)) throw std::invalid_argument("numbers");
            sizes.push_back(size.value);
        } catch (const std::invalid_argument&) {
            throw InputError("", "--ladder", fmt::format("numbers like 0.2,0.1 (not '{}')", text));
        }
        begin = comma + 1;
    }
    return sizes;
}

/// The size of an imported mesh, which needs no ladder.
std::optional<double> own_size(const geometry::Shape& shape) {
    try {
        return shape.length("mesh_size");
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

void read_ladder(TableReader& reader, const std::string& override_text, Case& result) {
    if (const auto size = own_size(*result.shape); size && !reader.has("ladder")) {
        result.ladder = {{"quick", {*size}}};
        return;
    }
    TableReader ladder = reader.table("ladder");
    double unit = 1;
    if (ladder.has("relative_to")) {
        result.ladder_unit_name = ladder.string("relative_to");
        try {
            unit = result.shape->length(result.ladder_unit_name);
        } catch (const std::invalid_argument& error) {
            ladder.fail("relative_to", error.what());
        }
    }
    for (const char* level : {"quick", "full"})
        if (ladder.has(level)) result.ladder[level] = checked_ladder(ladder, level, ladder.numbers(level), unit, *result.shape);
    if (!result.ladder.count("quick")) ladder.fail("quick", "an array of sizes (the key is missing)");
    if (!override_text.empty()) {
        const std::vector<double> sizes = checked_ladder(ladder, "quick", parse_ladder(override_text), unit, *result.shape);
        result.ladder = {{"quick", sizes}, {"full", sizes}};
    }
}

void read_particles(TableReader& reader, const Defaults& defaults, Case& result) {
    auto table = reader.table_if("particles");
    if (!table) return;
    result.particles.support_factor = table->number_or("support_factor", 2.5);
    if (auto kernel = table->table_if("kernel")) {
        result.particles.kernel_aspect = kernel->number_or("aspect", 1);
        result.particles.kernel_seed = kernel->integer_or("seed", 1);
        if (kernel->has("axis")) result.particles.kernel_axis = read_direction(*kernel, "axis");
        if (!(result.particles.kernel_aspect >= 1)) kernel->fail("aspect", "a number from 1 (longest over shortest axis)");
    }
    if (table->has("residual_tolerance")) {
        result.particles.residual_tolerance = table->number("residual_tolerance");
        if (!(*result.particles.residual_tolerance > 0)) table->fail("residual_tolerance", "a positive number");
    }
    if (table->has("link_penalty")) {
        result.particles.link_penalty = table->number("link_penalty");
        if (!(*result.particles.link_penalty >= 0)) table->fail("link_penalty", "a number that is not negative");
    }
    if (!(result.particles.support_factor > 1)) table->fail("support_factor", "a number above 1 (support radius / particle spacing)");
    result.particles.displacement = "fem.p2";
    if (table->has("solution") && table->has("displacement")) table->fail("", "either 'displacement' (fem.p2) or 'solution' (exact displacements)");
    if (!table->has("solution") && !table->has("displacement")) return;
    if (table->has("solution")) {
        result.particles.displacement = "solution";
        result.particles.solution = read_solution_call(*table, defaults);
    } else {
        result.particles.displacement = table->choice("displacement", {"fem.p1", "fem.p2"});
    }
}

void read_study_case(TableReader& reader, Case& result) {
    TableReader table = reader.table("study");
    const StudyInfo& info = study_info(table);
    result.study = info.read(table);
    result.study_info = &info;
    result.ladder = {{"quick", {0}}};  // one step: a study has its own sizes
    for (TableReader& check : reader.tables("check")) result.checks.push_back(read_study_check(check, info));
    reader.finish();
}

void read_toughness(TableReader& reader, Case& result) {
    auto table = reader.table_if("toughness");
    if (!table) return;
    result.toughness.ratio = table->number("ratio");
    if (!(result.toughness.ratio > 0)) table->fail("ratio", "a positive number, K across over K along the weak plane");
    const std::array<double, 3> normal = read_direction(*table, "weak_normal");
    double square = 0;
    for (const double n : normal) square += n * n;
    for (std::size_t i = 0; i < 3; ++i) result.toughness.weak_normal[i] = normal[i] / std::sqrt(square);
}

/// A name is a folder's name too.
std::string read_name(TableReader& reader) {
    const std::string name = reader.string("name");
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; };
    if (name.empty() || name[0] == '.' || !std::all_of(name.begin(), name.end(), plain))
        reader.fail("name", fmt::format("letters, digits, '_', '-' and '.', not '.' first (not '{}')", name));
    return name;
}

Case read_one(TableReader reader, const std::string& file, const std::string& ladder) {
    Case result;
    result.file = file;
    result.name = read_name(reader);
    result.tier = reader.choice("tier", {"verification", "cross_code", "paper"});
    result.about = reader.string("about");
    if (reader.has("study")) {
        read_study_case(reader, result);
        return result;
    }
    TableReader geometry = reader.table("geometry");
    result.shape = geometry::read_shape(geometry);
    result.materials = read_materials(reader);
    const Defaults defaults = read_solution_tables(reader);
    read_loads(reader, defaults, result);
    read_ladder(reader, ladder, result);
    read_particles(reader, defaults, result);
    read_toughness(reader, result);
    for (TableReader& table : reader.tables("check")) result.checks.push_back(read_check(table, defaults, result));
    for (TableReader& table : reader.tables_if("profile")) result.profiles.push_back(read_profile(table, defaults, result));
    reader.finish();
    return result;
}

constexpr std::size_t most_combinations = 10'000;  // each is a case of its own, meshed and solved

using Assignment = std::vector<std::pair<std::string, std::string>>;

/// Every combination of the values in [sweep].
std::vector<Assignment> combinations(TableReader& reader) {
    std::vector<Assignment> all{{}};
    auto sweep = reader.table_if("sweep");
    if (!sweep) return all;
    for (const std::string& key : sweep->keys()) {
        const std::vector<std::string> values = sweep->strings(key);
        if (all.size() * values.size() > most_combinations) reader.fail("sweep", fmt::format("at most {} combinations", most_combinations));
        std::vector<Assignment> longer;
        for (const Assignment& assignment : all)
            for (const std::string& value : values) {
                longer.push_back(assignment);
                longer.back().emplace_back(key, value);
            }
        all = std::move(longer);
    }
    return all;
}

}  // namespace

Band Check::band(const std::string& solver) const {
    const auto own = bands.find(solver);
    if (own != bands.end()) return own->second;
    const auto any = bands.find("");
    return any == bands.end() ? Band{} : any->second;
}

bool Check::takes(double size, const std::vector<double>& ladder) const {
    if (!at_size) return true;
    const auto is_it = [&](double other) { return std::abs(other - *at_size) < 1e-9 * *at_size; };
    return (size > *at_size || is_it(size)) && std::any_of(ladder.begin(), ladder.end(), is_it);
}

const std::vector<double>& Case::sizes(const std::string& level) const {
    const auto found = ladder.find(level);
    return found == ladder.end() ? ladder.at("quick") : found->second;
}

std::vector<std::string> Case::symmetry() const {
    std::set<std::string> classes;
    for (const auto& [region, material] : materials) classes.insert(symmetry_class(material.stiffness));
    if (study)
        for (const material::Stiffness& stiffness : study->materials()) classes.insert(symmetry_class(stiffness));
    return {classes.begin(), classes.end()};
}

Side Case::side(const std::string& solver) const {
    return study_info ? study_info->side(solver) : solver.starts_with("fem") ? Side::fem : Side::particles;
}

void Case::fail(const std::string& key, const std::string& expected) const { throw InputError(file, key, expected); }

std::vector<Case> read_cases(const std::string& file, const Overrides& overrides) {
    const std::string text = read_file(file);
    const auto prepared = [&] {
        TableReader reader = TableReader::from_text(text, file);
        for (const auto& [key, value] : overrides.values) reader.set(key, value);
        return reader;
    };
    std::vector<Case> cases;
    TableReader first = prepared();
    for (const Assignment& assignment : combinations(first)) {
        TableReader reader = prepared();
        (void)reader.has("sweep");
        if (auto sweep = reader.table_if("sweep"))
            for (const std::string& key : sweep->keys()) (void)sweep->has(key);
        for (const auto& [key, value] : assignment) reader.set(key, value);
        cases.push_back(read_one(reader, file, overrides.ladder));
        Case& last = cases.back();
        last.text = text + "\n" + overrides.ladder;
        for (const auto& [key, value] : overrides.values) last.text.append("\n").append(key).append("=").append(value);
        for (const auto& [key, value] : assignment) {
            last.parameters[key] = value;
            last.name += fmt::format("[{}={}]", key, value);
        }
    }
    return cases;
}

}  // namespace cleave::validation
