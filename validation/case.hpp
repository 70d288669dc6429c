#pragma once

#include "solver/input/table_reader.hpp"
#include "solver/material/material.hpp"
#include "validation/check.hpp"
#include "validation/geometry/shape.hpp"
#include "validation/norms.hpp"
#include "validation/study.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cleave::validation {

/// A named analytic solution with its own keys, from `reference = { solution = "...", plane = "strain" }` or the table
/// [solution.NAME] of the case (keys given in place win).
struct SolutionCall {
    std::string name;
    std::map<std::string, std::string> words;              ///< keys with string values
    std::map<std::string, double> numbers;                 ///< keys with numbers or quantities, SI
    std::map<std::string, std::array<double, 3>> vectors;  ///< keys with quantities, SI
    std::string where;                                     ///< dotted key, for messages
};

/// One boundary condition; either a constant vector (or pressure) or an analytic solution's field.
struct SurfaceLoad {
    enum class Kind { traction, pressure, displacement };
    Kind kind = Kind::traction;
    std::vector<std::string> on;                    ///< surface names; "all" stands for every one
    std::array<bool, 3> components{true, true, true};  ///< displacement only
    std::array<double, 3> vector{};                 ///< Pa or m
    double pressure = 0;                            ///< Pa, positive pushes
    std::optional<SolutionCall> solution;
};

/// Six well-chosen components at three points (3-2-1) hold a body without stressing it. Finite elements only.
struct PointSupport {
    std::array<double, 3> at{};                        ///< m; the mesh vertex nearest to it counts
    std::array<bool, 3> components{true, true, true};
    std::array<double, 3> vector{};                    ///< prescribed displacement, m
};

/// A condition on the line in which two surfaces meet: a load per length, or a displacement. Finite elements only.
struct LineCondition {
    std::array<std::string, 2> on;                     ///< surface names
    bool load = false;
    std::array<bool, 3> components{true, true, true};  ///< displacement only
    std::array<double, 3> vector{};                    ///< N/m or m
};

struct Reference {
    enum class Kind { none, value, solution, solver };
    Kind kind = Kind::none;
    double value = 0;              ///< SI
    std::string source;            ///< literature or solver name
    std::optional<SolutionCall> solution;
};

/// One [[check]] of a case.
struct Check {
    Observable observable;
    std::vector<std::string> solvers;
    Reference reference;
    std::map<std::string, Band> bands;  ///< by solver; "" for all
    std::string basis;                  ///< why the bands are that wide; of a check without any, why nothing judges it
    std::string region = "";            ///< over.region
    std::string norm = "rms";           ///< over.norm
    std::vector<std::array<double, 3>> at;
    std::vector<std::string> places;    ///< of a study; empty for all it has
    double divide_by = 1;               ///< SI; makes a stress concentration of a stress
    Dimension unit;                     ///< of value and reference, after divide_by
    bool angle = false;                 ///< value, reference and absolute band in degrees
    bool must_fail = false;
    std::optional<double> at_size;      ///< m: the ladder ends there for this check, which is made only where the ladder has that size
    std::string where;                  ///< "check[2]", for messages
    Band band(const std::string& solver) const;
    bool takes(double size, const std::vector<double>& ladder) const;
};

/// One [[profile]]: curves along a line, for the report.
struct Profile {
    std::string title;
    Observable observable;
    std::vector<std::string> solvers;
    std::optional<SolutionCall> reference;
    std::array<double, 3> from{}, to{};
    int points = 61;
    std::string x;         ///< term, like "y/a"
    std::string y;         ///< axis title
    double divide_by = 1;
    double reach = 0;      ///< particles this near to the line are shown, m
    std::string where;
};

/// How the strain operators of the particles are fed and tuned.
struct ParticleSettings {
    std::optional<double> residual_tolerance;    ///< |f - K u| / |f| at which the equilibrium of `conforming` stops
    std::optional<double> link_penalty;          ///< alpha of `conforming`; the solver's own where absent
    double support_factor = 2.5;                 ///< k in h = k s
    double kernel_aspect = 1;                    ///< longest over shortest support axis, determinant kept
    long kernel_seed = 1;                        ///< of the random orientations of stretched kernels
    std::optional<std::array<double, 3>> kernel_axis;  ///< one long axis for all of them instead
    std::string displacement = "solution";       ///< an analytic solution's name, or "fem.p2"
    std::optional<SolutionCall> solution;
};

/// Toughness by the direction of the crack's plane, K_c / K_0 = cos^2 + ratio sin^2 of its angle from a weak plane (Saouma et al. 1987).
struct Toughness {
    double ratio = 1;                          ///< K_90 / K_0
    std::array<double, 3> weak_normal{0, 1, 0};  ///< unit normal of the weak plane, in the body's axes
};

/// A case file, one sweep combination of it, with every value in SI (angles of checks in degrees).
struct Case {
    std::string name;    ///< with the swept values in brackets
    std::string file;    ///< as given, for messages
    std::string tier;
    std::string about;
    std::map<std::string, std::string> parameters;  ///< swept keys
    std::shared_ptr<const Study> study;             ///< set for a case without a body of its own: [study] instead of [geometry] ... [ladder]
    const StudyInfo* study_info = nullptr;          ///< of that study
    std::shared_ptr<const geometry::Shape> shape;
    std::map<std::string, material::Material> materials;  ///< by region name; "" for the whole body
    std::vector<SurfaceLoad> loads;
    std::vector<PointSupport> supports;
    std::vector<LineCondition> lines;
    std::optional<SolutionCall> body_force_solution;
    std::array<double, 3> body_force{};
    bool free_body = false;                         ///< nothing holds the body: inertia balances the load
    std::string ladder_unit_name;                   ///< relative_to, "" where sizes are absolute
    std::map<std::string, std::vector<double>> ladder;  ///< level -> sizes, m, coarse to fine
    ParticleSettings particles;
    Toughness toughness;
    std::vector<Check> checks;
    std::vector<Profile> profiles;
    std::string text;                               ///< the file with overrides, for fingerprints
    std::string command;                            ///< that runs it again, for the report
    std::size_t position = 0;                       ///< among all cases of the run, before it was split into shards

    const std::vector<double>& sizes(const std::string& level) const;
    /// Elastic symmetry classes of its materials, or its study's, sorted, each once.
    std::vector<std::string> symmetry() const;
    /// The side that a check's solver stands for.
    Side side(const std::string& solver) const;
    [[noreturn]] void fail(const std::string& key, const std::string& expected) const;
};

/// `--set KEY=VALUE` and `--ladder`.
struct Overrides {
    std::vector<std::pair<std::string, std::string>> values;
    std::string ladder;
};

/// Reads a case file and expands its [sweep]. Throws InputError (file, line, key, what was expected).
std::vector<Case> read_cases(const std::string& file, const Overrides& overrides);

}  // namespace cleave::validation
