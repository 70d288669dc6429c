#include "validation/suite.hpp"

#include "solver/input/input_error.hpp"
#include "solver/mesh/gmsh_session.hpp"
#include "validation/case_checks.hpp"
#include "validation/solutions.hpp"

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace cleave::validation {

namespace {

namespace fs = std::filesystem;

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string with_unit(const QuantityInfo& quantity) {
    return fmt::format("{} [{}]", quantity.name, quantity.angle ? "deg" : unit_name(quantity.dimension));
}

bool is_path(const std::string& name) { return name.ends_with(".toml") || name.find('/') != std::string::npos; }

std::string tier_and_about(const fs::path& file) {
    try {
        TableReader reader = TableReader::from_file(file.string());
        return fmt::format("{:13} {}", reader.string("tier"), reader.string("about"));
    } catch (const InputError& error) {
        return error.what();
    }
}

}  // namespace

fs::path case_folder() {
    if (const char* folder = std::getenv("CLEAVE_CASES")) return folder;
    return CLEAVE_CASE_FOLDER;
}

std::vector<fs::path> shipped_case_files() {
    if (!fs::is_directory(case_folder())) throw EnvironmentError(fmt::format("{}: the folder of the shipped cases is missing", case_folder().string()));
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(case_folder()))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<fs::path> select_files(const std::vector<std::string>& names) {
    const std::vector<fs::path> shipped = shipped_case_files();
    if (names.empty()) return shipped;
    std::vector<fs::path> chosen;
    for (const std::string& name : names) {
        if (is_path(name)) {
            chosen.emplace_back(name);
            continue;
        }
        bool matched = false;
        for (const fs::path& file : shipped) {
            if (fnmatch(name.c_str(), file.stem().c_str(), 0) != 0) continue;
            matched = true;
            if (std::find(chosen.begin(), chosen.end(), file) == chosen.end()) chosen.push_back(file);
        }
        if (!matched) throw InputError("", name, "the name of a case (see cleave validate --list), a glob, or a .toml file");
    }
    return chosen;
}

std::vector<Case> shard(const std::vector<Case>& cases, const std::string& text) {
    int index = 0, number = 0;
    const char* end = text.data() + text.size();
    const auto [slash, first] = std::from_chars(text.data(), end, index);
    const bool split = first == std::errc{} && slash != end && *slash == '/';
    if (split) {
        const auto [rest, second] = std::from_chars(slash + 1, end, number);
        if (second == std::errc{} && rest == end && index >= 1 && number >= 1 && index <= number) {
            std::vector<Case> own;
            for (std::size_t i = 0; i < cases.size(); ++i)
                if (static_cast<int>(i % static_cast<std::size_t>(number)) == index - 1) own.push_back(cases[i]);
            return own;
        }
    }
    throw InputError("", "--shard", fmt::format("I/N with 1 <= I <= N (not '{}')", text));
}

std::string listing() {
    std::string text = "cases:\n";
    for (const fs::path& file : shipped_case_files()) text += fmt::format("  {:24} {}\n", file.stem().string(), tier_and_about(file));
    text += "\nshapes ([geometry]):\n";
    for (const geometry::ShapeInfo& shape : geometry::shapes())
        text += fmt::format("  {:24} {}\n  {:24}   keys: {}; surfaces: {}; coordinates: {}\n", shape.name, shape.about, "",
                            fmt::join(shape.keys, ", "), fmt::join(shape.surfaces, ", "), fmt::join(shape.coordinates, ", "));
    text += "\nanalytic solutions:\n";
    for (const SolutionInfo& solution : solutions()) {
        std::vector<std::string> keys;
        for (const SolutionInfo::Key& key : solution.keys) keys.push_back(key.name);
        text += fmt::format("  {:24} {}{}\n", solution.name, solution.about, keys.empty() ? "" : fmt::format("; keys: {}", fmt::join(keys, ", ")));
    }
    text += fmt::format("\nsolvers: {}\nquantities:", fmt::join(solver_names(), ", "));
    for (const QuantityInfo& quantity : quantities()) text += fmt::format(" {}", with_unit(quantity));
    text += "\n\nstudies ([study]):\n";
    for (const StudyInfo& study : studies()) {
        text += fmt::format("  {:24} {}\n  {:24}   keys: {}; methods: {}\n  {:24}   quantities:", study.name, study.about, "",
                            study.keys.empty() ? "none" : fmt::format("{}", fmt::join(study.keys, ", ")), fmt::join(study.methods, ", "), "");
        for (const QuantityInfo& quantity : study.quantities) text += fmt::format(" {}", with_unit(quantity));
        text += "\n";
    }
    return text;
}

std::string provenance_json(const std::string& level) {
    const char* commit = std::getenv("CLEAVE_COMMIT");
    const nlohmann::ordered_json json{
        {"commit", commit ? commit : "unknown"},
        {"compiler", fmt::format("g++ {}", __VERSION__)},
        {"build_type", CLEAVE_BUILD_TYPE},
        {"cpu", cpu_model()},
        {"threads", std::thread::hardware_concurrency()},
        {"level", level},
        {"versions",
         {{"cleave", CLEAVE_VERSION},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"gmsh", mesh::GmshSession::version()},
          {"deal.II", CLEAVE_DEAL_II_VERSION}}}};
    return json.dump(1) + "\n";
}

}  // namespace cleave::validation
