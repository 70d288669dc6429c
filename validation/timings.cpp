#include "validation/timings.hpp"

#include "validation/results_json.hpp"

namespace cleave::validation {

void Timings::add(const std::string& case_name, double seconds, const std::vector<SolveNote>& solves) {
    entries_.push_back({case_name, seconds, solves});
}

std::string Timings::json() const {
    Json json{{"cases", Json::object()}, {"solves", Json::array()}};
    for (const Entry& entry : entries_) {
        json["cases"][entry.name] = {{"seconds", entry.seconds}};
        for (const SolveNote& note : entry.solves) {
            Json solve{{"case", entry.name}};
            solve.update(note_json(note));
            json["solves"].push_back(std::move(solve));
        }
    }
    return json.dump(1) + "\n";
}

}  // namespace cleave::validation
