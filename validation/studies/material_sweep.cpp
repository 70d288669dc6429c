#include "validation/studies/material_sweep.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/read_values.hpp"
#include "validation/studies/tensor_checks.hpp"
#include "validation/symmetry_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cleave::validation {

namespace {

/// Methods with a mistake of theirs: the value is that of the tensor where it shows least.
const std::vector<std::string>& mistakes() {
    static const std::vector<std::string> list{"kelvin_as_voigt", "stiffness_along", "modes_swapped", "without_half"};
    return list;
}

bool is_mistake(const std::string& method) { return std::find(mistakes().begin(), mistakes().end(), method) != mistakes().end(); }

/// A tensor and what the checks found.
struct Tried {
    SweepTensor tensor;
    std::vector<TensorError> errors;
};

using Column = std::pair<std::string, std::string>;  // quantity, method

/// In the order in which they come up first.
std::vector<Column> columns_of(const std::vector<Tried>& all) {
    std::vector<Column> columns;
    for (const Tried& one : all)
        for (const TensorError& error : one.errors)
            if (const Column column{error.quantity, error.method}; std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
    return columns;
}

const TensorError* find(const Tried& one, const Column& column) {
    const auto at = std::find_if(one.errors.begin(), one.errors.end(),
                                 [&](const TensorError& error) { return error.quantity == column.first && error.method == column.second; });
    return at == one.errors.end() ? nullptr : &*at;
}

/// An undefined error is worse than any.
bool farther(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a > b; }

/// The tensor of a class that a method is worst for; least off, of a mistake.
void add_extreme(const std::vector<Tried>& all, const std::string& symmetry, const Column& column, StudyOutcome& outcome) {
    const bool mistake = is_mistake(column.second);
    const Tried* extreme = nullptr;
    double value = 0;
    int count = 0;
    for (const Tried& one : all) {
        const TensorError* error = one.tensor.symmetry == symmetry ? find(one, column) : nullptr;
        if (error == nullptr) continue;
        ++count;
        if (extreme != nullptr && !(mistake ? farther(value, error->error) : farther(error->error, value))) continue;
        extreme = &one;
        value = error->error;
    }
    if (extreme == nullptr) return;
    const std::string detail = fmt::format("{} of {}: {}", mistake ? "least" : "worst", count, extreme->tensor.name);
    outcome.values.push_back({column.first, column.second, symmetry, value, {}, detail});
}

std::string cell(const TensorError* error) { return error != nullptr && std::isfinite(error->error) ? fmt::format("{:.3e}", error->error) : ""; }

std::string quoted(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) text += c == '"' ? '\'' : c;
    return text + "\"";
}

/// The errors by the tensor's number, for the report to draw.
std::string sweep_csv(const std::vector<Tried>& all) {
    std::string text = "tensor";
    for (const auto& [quantity, method] : columns_of(all))
        if (!is_mistake(method)) text += fmt::format(",{} of {}", quantity, method);
    text += "\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        text += fmt::format("{}", i + 1);
        for (const Column& column : columns_of(all))
            if (!is_mistake(column.second)) text += "," + cell(find(all[i], column));
        text += "\n";
    }
    return text;
}

/// The constants as `csv` takes them.
std::string tensors_csv(const std::vector<Tried>& all) {
    std::string text = "name";
    for (int i = 1; i <= 6; ++i)
        for (int j = i; j <= 6; ++j) text += fmt::format(",C{}{}", i, j);
    text += "\n";
    for (const Tried& one : all) {
        text += quoted(one.tensor.name);
        for (int i = 0; i < 6; ++i)
            for (int j = i; j < 6; ++j) text += fmt::format(",{:.17g}", one.tensor.stiffness(i, j) / 1e9);
        text += "\n";
    }
    return text;
}

class MaterialSweep final : public Study {
public:
    std::string file;
    std::filesystem::path csv;  ///< empty: the catalogue and random tensors
    std::vector<NamedStiffness> table;
    std::uint64_t seed = 1;
    int quick_random = 0, full_random = 0;  ///< random tensors
    int quick_pennies = 0, full_pennies = 0;  ///< the first random tensors (of a table: the first tensors), whose penny crack is solved
    double size = 0, penny_size = 0, full_penny_size = 0;

    StudyOutcome run(const StudyContext& context) const override {
        const bool full = context.level == "full";
        const SweepBodies bodies{file, context.meshes, size, full ? full_penny_size : penny_size};
        std::vector<Tried> all;
        StudyOutcome outcome;
        for (SweepTensor& tensor : csv.empty() ? default_tensors(full ? full_random : quick_random, seed) : sweep_tensors(table, seed)) {
            all.push_back({std::move(tensor), {}});
            try_all(all, bodies, full ? full_pennies : quick_pennies, outcome);
            if (context.progress) context.progress(all.back().tensor.name);
        }
        for (const std::string& symmetry : symmetry_classes())
            for (const Column& column : columns_of(all)) add_extreme(all, symmetry, column, outcome);
        write(all, context, outcome);
        return outcome;
    }

    /// The default has every class: one random tensor of each stands for all.
    std::vector<material::Stiffness> materials() const override {
        std::vector<material::Stiffness> list;
        if (csv.empty())
            for (const SweepTensor& tensor : random_tensors(static_cast<int>(symmetry_classes().size()), seed)) list.push_back(tensor.stiffness);
        for (const NamedStiffness& one : table) list.push_back(one.stiffness);
        return list;
    }

    std::vector<std::filesystem::path> input_files() const override { return csv.empty() ? std::vector<std::filesystem::path>{} : std::vector{csv}; }

private:
    /// The last tensor of the list.
    void try_all(std::vector<Tried>& all, const SweepBodies& bodies, int pennies, StudyOutcome& outcome) const {
        Tried& last = all.back();
        const auto add = [&](const std::vector<TensorError>& errors) { last.errors.insert(last.errors.end(), errors.begin(), errors.end()); };
        add(patch_errors(last.tensor, bodies));
        add(bar_errors(last.tensor, bodies));
        add(wave_errors(last.tensor));
        add(front_errors(last.tensor));
        const auto counts = [&](const Tried& one) { return takes_penny(one.tensor); };
        if (counts(last) && std::count_if(all.begin(), all.end(), counts) <= pennies) add(penny_errors(last.tensor, bodies, outcome.solves));
    }

    bool takes_penny(const SweepTensor& tensor) const { return !csv.empty() || tensor.name.starts_with("random "); }

    static void write(const std::vector<Tried>& all, const StudyContext& context, StudyOutcome& outcome) {
        const std::string sweep = context.folder + "/sweep.csv";
        write_file_atomic(context.out / sweep, sweep_csv(all));
        write_file_atomic(context.out / context.folder / "tensors.csv", tensors_csv(all));
        outcome.artifacts.push_back({sweep, "Errors of every tensor of the sweep, numbered as in tensors.csv", "tensor", "relative error"});
    }
};

constexpr int most_tensors = 100'000;

double read_penny_size(TableReader& table, const std::string& key) {
    const double size = table.number(key);
    if (!(size >= 0.02 && size <= 0.5)) table.fail(key, "a number from 0.02 to 0.5, of elements at the front over its radius");
    return size;
}

std::shared_ptr<const Study> read(TableReader& table) {
    auto study = std::make_shared<MaterialSweep>();
    study->file = table.file();
    if (table.has("csv")) {
        study->csv = table.existing_file("csv");
        study->table = read_stiffness_csv(study->csv);
    }
    study->seed = static_cast<std::uint64_t>(table.integer("seed"));
    study->quick_random = read_integer(table, "quick_random", 8, most_tensors);
    study->full_random = read_integer(table, "full_random", 8, most_tensors);
    study->quick_pennies = read_integer(table, "quick_pennies", 1, most_tensors);
    study->full_pennies = read_integer(table, "full_pennies", 1, most_tensors);
    study->size = table.quantity("size", dimension::length);
    if (!(study->size >= 0.02 && study->size <= 1)) table.fail("size", "a length from 2 cm to 1 m, of elements in a block of 1 m");
    study->penny_size = read_penny_size(table, "penny_size");
    study->full_penny_size = table.has("full_penny_size") ? read_penny_size(table, "full_penny_size") : study->penny_size;
    return study;
}

}  // namespace

StudyInfo material_sweep_study() {
    return {"material_sweep",
            "many tensors, catalogue and random or a user's table of 21 constants: patch test, bar, wave speeds, energy release rate; the worst by name",
            {"csv", "seed", "quick_random", "full_random", "quick_pennies", "full_pennies", "size", "penny_size", "full_penny_size"},
            {{"patch_error", dimension::none},
             {"bar_modulus_error", dimension::none},
             {"wave_speed_error", dimension::none},
             {"front_energy_release_error", dimension::none},
             {"penny_energy_release_error", dimension::none}},
            {"fem.p2", "sph.conforming", "sph.corrected", "sph.quadratic", "solver", "stroh", "tip_field", "effective_modulus", "kelvin_as_voigt",
             "stiffness_along", "modes_swapped", "without_half"},
            read,
            mistakes()};
}

}  // namespace cleave::validation
