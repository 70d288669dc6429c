#pragma once

#include "validation/adapters/sources.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cleave::validation {

/// timings.json: seconds per case, and one record per solve. Kept apart from results.json, which repeats to the byte.
class Timings {
public:
    void add(const std::string& case_name, double seconds, const std::vector<SolveNote>& solves);
    std::string json() const;

private:
    struct Entry {
        std::string name;
        double seconds;
        std::vector<SolveNote> solves;
    };
    std::vector<Entry> entries_;
};

}  // namespace cleave::validation
