#pragma once

#include "solver/input/table_reader.hpp"
#include "validation/expression.hpp"
#include "validation/geometry/crack_front.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cleave::geometry {

/// A meshed body: ONE .msh file that both solvers read, and what its tags mean.
struct Body {
    std::filesystem::path mesh_file;
    std::map<std::string, int> surfaces;  ///< name -> physical surface tag
    std::map<std::string, int> regions;   ///< name -> physical volume tag
};

/// A parametrised body.
class Shape {
public:
    virtual ~Shape() = default;
    /// Meshes the body at element size `size` (m) into `folder`, or finds the mesh there from an earlier call.
    virtual Body mesh(double size, const std::filesystem::path& folder) const = 0;
    /// Named lengths and coordinates that checks may use, x, y and z among them.
    virtual validation::Coordinates coordinates() const = 0;
    /// A length of the shape by its key, for `relative_to` and analytic solutions. Throws std::invalid_argument.
    virtual double length(const std::string& key) const = 0;
    /// Fronts of the crack; none for bodies without one. All have the same lips.
    virtual std::vector<CrackFront> crack_fronts() const { return {}; }
    /// True where a smaller size refines every part of the mesh alike, so that an observed order means something.
    virtual bool uniform_refinement() const = 0;
    /// About how many tets a mesh of this size has, 0 where the shape does not know: asked before one is made that no memory holds.
    virtual double expected_tets(double /*size*/) const { return 0; }
    /// Files that the body is made from: a change of theirs is a change of the case.
    virtual std::vector<std::filesystem::path> input_files() const { return {}; }
    /// Names that loads may use in `on`.
    virtual std::vector<std::string> surface_names() const = 0;
};

/// What `validate --list` tells about a shape.
struct ShapeInfo {
    std::string name, about;
    std::vector<std::string> keys, surfaces, coordinates;
};
const std::vector<ShapeInfo>& shapes();

/// Reads the [geometry] table of a case. Throws InputError (unknown shape: the known ones are listed).
std::shared_ptr<const Shape> read_shape(TableReader& geometry);

}  // namespace cleave::geometry
