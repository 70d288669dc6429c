#include "solver/simulation/scene_table.hpp"

#include "solver/input/file_io.hpp"
#include "solver/input/input_error.hpp"
#include "solver/simulation/statistics.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cleave::simulation {
namespace {

using Json = nlohmann::json;

struct Row {
    std::filesystem::path folder;
    std::string scene;
    char run = 'a';
    Json statistics, timings;
};

Json read_json(const std::filesystem::path& file, const std::string& schema) {
    const Json json = Json::parse(read_file(file), nullptr, false);
    if (!json.is_object() || json.value("schema", Json()) != schema) throw InputError(file.string(), "schema", fmt::format("{}, of cleave simulate", schema));
    return json;
}

/// Runs what reads one of a run's files; a value that is missing or of another kind is that file's fault.
template <class Read>
auto from_file(const std::filesystem::path& file, const Read& read) try {
    return read();
} catch (const Json::exception& error) {
    throw InputError(file.string(), "", fmt::format("a file of cleave simulate ({})", error.what()));
}

/// A double beyond the integers' range would be undefined behaviour. Throws where the number is none.
long integer(const Json& json) { return json.get_ref<const Json::number_integer_t&>(); }

void read_head(Row& row) {
    row.scene = row.statistics.at("scene").get<std::string>();
    row.run = row.statistics.at("debris").at("below").get<double>() > 0 ? 'b' : 'a';
}

Row read_row(const std::filesystem::path& folder) {
    Row row{.folder = folder, .scene = {}, .statistics = read_json(folder / "statistics.json", "cleave.statistics/1"),
            .timings = read_json(folder / "timings.json", "cleave.timings/1")};
    from_file(folder / "statistics.json", [&] { read_head(row); });
    return row;
}

/// "ours / paper's", the paper's left out where it says nothing.
std::string pair(const std::string& ours, double paper) { return paper > 0 ? fmt::format("{} / {:g}", ours, paper) : ours; }

std::string counts_line(const Row& row) {
    const Json& ours = row.statistics;
    const PaperRow* paper = paper_row(row.scene);
    const auto beside = [&](const char* key, int PaperRow::*member) { return pair(fmt::format("{}", integer(ours.at(key))), paper ? paper->*member : 0); };
    const Json& debris = ours.at("debris");
    return fmt::format("{:<17}{:>3}{:>16}{:>18}{:>16}{:>12}{:>9}{:>11.3g}{:>10.3g}\n", row.scene, row.run, beside("physical_particles", &PaperRow::physical),
                       beside("subdivided_particles", &PaperRow::subdivided), beside("boundary_particles", &PaperRow::boundary),
                       beside("fragments", &PaperRow::fragments), integer(debris.at("count")), debris.at("mass").get<double>(),
                       ours.at("mass").get<double>());
}

std::string times_line(const Row& row) {
    const Json& ours = row.timings;
    const PaperRow* paper = paper_row(row.scene);
    const double rate = ours.at("frame_rate").get<double>(), paper_rate = paper ? paper->frame_rate : 0;
    const auto beside = [&](const char* key, double PaperRow::*member) {
        return pair(fmt::format("{:.3g}", 1e3 * ours.at(key).at("total_s").get<double>()), paper ? paper->*member : 0);
    };
    return fmt::format("{:<17}{:>3}{:>7}{:>16}{:>18}{:>16}{:>16}{:>9}{:>11.1f}{:>9}\n", row.scene, row.run, integer(ours.at("frames")),
                       beside("stress_analysis", &PaperRow::analysis), beside("subdivision", &PaperRow::subdivision),
                       beside("crack_generation", &PaperRow::cracks), pair(fmt::format("{:.1f}", rate), paper_rate),
                       paper_rate > 0 ? fmt::format("{:.1f}", rate / paper_rate) : "", ours.at("frame_rate_of_processor").get<double>(),
                       integer(ours.at("threads")));
}

}  // namespace

std::string scene_table(const std::vector<std::filesystem::path>& folders) {
    std::vector<Row> rows;
    for (const std::filesystem::path& folder : folders) rows.push_back(read_row(folder));
    std::string text = "Table 1, ours / the paper's. Run a: all fragments dynamic, b: debris as the scene says (kg).\n";
    text += fmt::format("{:<17}{:>3}{:>16}{:>18}{:>16}{:>12}{:>9}{:>11}{:>10}\n", "scene", "run", "physical", "subdivided", "boundary", "fragments",
                        "debris", "its mass", "of all");
    for (const Row& row : rows) text += from_file(row.folder / "statistics.json", [&] { return counts_line(row); });
    text += "\nTable 2, ours / the paper's (2010 Xeon): ms in total, frames per second by the clock and per second of processor time.\n";
    text += fmt::format("{:<17}{:>3}{:>7}{:>16}{:>18}{:>16}{:>16}{:>9}{:>11}{:>9}\n", "scene", "run", "frames", "stress", "subdivision", "cracks",
                        "frame rate", "times", "processor", "threads");
    for (const Row& row : rows) text += from_file(row.folder / "timings.json", [&] { return times_line(row); });
    return text;
}

}  // namespace cleave::simulation
