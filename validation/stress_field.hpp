#pragma once

#include "validation/adapters/level.hpp"
#include "validation/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// What two solvers say of the stress at the same points: the particles.
struct StressPair {
    std::string particle_solver, fem_solver;
    std::vector<Point> position;  ///< m
    std::vector<double> volume;   ///< m^3
    std::vector<Voigt> particles, fem;  ///< Pa
};

/// Most points of one field that are kept to be drawn.
inline constexpr std::size_t max_field_points = 4000;

/// A measure of the stress that fields are compared and coloured by: the largest principal stress (`largest_principal`), or a component.
struct StressMeasure {
    std::string name;
    double (*of)(const Voigt& stress);
};
const std::vector<StressMeasure>& stress_measures();

/// The text of a field, schema cleave.stress_field/1, for 3D views. `measures`: for each measure, over all points, the volume-weighted rms of
/// the finite elements and of the difference particles - FEM, and its largest size with the point where it is. Then at most max_field_points
/// points, evenly chosen by their numbers: position (m), radius (m; of the sphere that has the volume a drawn point stands for), stress of the
/// particles and the difference (Pa; xx, yy, zz, yz, xz, xy), each as `scale` and base64 of little-endian 16-bit whole numbers of it.
/// The difference has a scale of its own, so that a small one is as sharp as a large one. Throws std::invalid_argument for no points.
std::string stress_field_json(const StressPair& pair);

/// Writes `case_folder`/stress_field.json below `out`, of the best particles that a case has run on this size (the conforming ones in front)
/// and its best finite elements; nothing where it has not run both.
std::optional<Artifact> write_stress_field(const std::string& case_folder, const std::filesystem::path& out, const LevelSources& sources);
Artifact write_stress_field(const StressPair& pair, const std::string& file, const std::string& title, const std::filesystem::path& out);

}  // namespace cleave::validation
