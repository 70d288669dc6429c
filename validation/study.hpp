#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/voigt.hpp"
#include "validation/results.hpp"
#include "validation/solve_note.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace cleave::validation {

inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// A quantity that checks may name. Angles are computed in radians, and read, judged and shown in degrees.
struct QuantityInfo {
    std::string name;
    Dimension dimension;
    bool angle = false;
};

/// One number that a study measured, SI. Several with the same quantity, method and place form a ladder, coarse to fine.
struct StudyValue {
    std::string quantity, method, place;
    double value = 0;
    Resolution resolution{};
    std::string detail{};  ///< what it is of within the place: of many, the worst one's name
};

struct StudyOutcome {
    std::vector<StudyValue> values;
    std::vector<Artifact> artifacts;
    std::vector<SolveNote> solves;
};

struct StudyContext {
    std::string level;                                     ///< quick or full
    std::filesystem::path out;                             ///< folder of the results; artifacts are named relative to it
    std::filesystem::path meshes;                          ///< cache of meshes
    std::string folder;                                    ///< of this case's artifacts, below `out`
    std::function<void(const std::string&)> progress;      ///< one line per finished part; may be empty
};

/// A case that is not one body, meshed and solved: it measures what it likes, the case's checks judge. Written by [study] in a case file.
class Study {
public:
    virtual ~Study() = default;
    /// Throws InputError, EnvironmentError.
    virtual StudyOutcome run(const StudyContext& context) const = 0;
    /// The materials it measures (Pa), for the coverage by symmetry class; none where no material matters.
    virtual std::vector<material::Stiffness> materials() const { return {}; }
    /// Files that it reads: a change of theirs is a change of the case.
    virtual std::vector<std::filesystem::path> input_files() const { return {}; }
};

struct StudyInfo {
    std::string name, about;
    std::vector<std::string> keys;             ///< of [study], for `validate --list`
    std::vector<QuantityInfo> quantities;
    std::vector<std::string> methods;          ///< what a check's `solver` may name
    std::shared_ptr<const Study> (*read)(TableReader&);  ///< reads the keys of [study]; throws InputError
    std::vector<std::string> mathematics{};    ///< those of `methods` that are mathematics; "fem..." are finite elements, the others the method
    Side side(const std::string& method) const;
};

const std::vector<StudyInfo>& studies();

/// The study that `name` in [study] names. Throws InputError.
const StudyInfo& study_info(TableReader& study);

}  // namespace cleave::validation
