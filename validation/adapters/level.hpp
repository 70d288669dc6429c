#pragma once

#include "validation/adapters/sources.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace cleave::validation {

/// One size of a case's ladder: the mesh, and each solver's answer on it, computed when first asked for.
class LevelSources {
public:
    LevelSources(const Case& of, double size, const std::filesystem::path& mesh_folder);
    FieldSource& get(const std::string& solver);
    /// The answer of a solver that has been asked for; null if it has not.
    const FieldSource* find(const std::string& solver) const;
    const Case& of() const { return of_; }
    double size() const { return size_; }
    const std::vector<SolveNote>& notes() const { return notes_; }

private:
    std::vector<Point> displacement_at(const std::vector<Point>& points);

    const Case& of_;
    double size_;
    geometry::Body body_;
    std::map<std::string, std::unique_ptr<FieldSource>> sources_;
    std::vector<SolveNote> notes_;
};

}  // namespace cleave::validation
