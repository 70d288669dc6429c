#include "validation/timings.hpp"

#include <nlohmann/json.hpp>

namespace cleave::validation {

void Timings::add(const std::string& case_name, double seconds, const std::vector<SolveNote>& solves) {
    entries_.push_back({case_name, seconds, solves});
}

std::string Timings::json() const {
    nlohmann::ordered_json json{{"cases", nlohmann::ordered_json::object()}, {"solves", nlohmann::ordered_json::array()}};
    for (const Entry& entry : entries_) {
        json["cases"][entry.name] = {{"seconds", entry.seconds}};
        for (const SolveNote& note : entry.solves)
            json["solves"].push_back({{"case", entry.name}, {"solver", note.solver}, {"method", note.method}, {"cells", note.cells},
                                      {"dofs", note.dofs}, {"iterations", note.iterations}, {"relative_residual", note.residual},
                                      {"seconds", note.seconds}});
    }
    return json.dump(1) + "\n";
}

}  // namespace cleave::validation
