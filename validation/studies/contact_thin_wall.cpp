#include "validation/studies/contact_thin_wall.hpp"

#include "solver/contact/half_space.hpp"
#include "validation/adapters/particle_bodies.hpp"
#include "validation/studies/contact_plate.hpp"
#include "validation/studies/contact_surfaces.hpp"
#include "validation/studies/direction_tools.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

namespace cleave::validation {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr int sectors = 4;  // the groups of Algorithm 1, by azimuth

/// Places round the contact: a polar grid down to 1.6 radii, above the plate's middle plane.
struct Grid {
    std::vector<Vector3d> places;
    std::vector<double> volume;
    std::vector<int> sector;
};

Grid grid(double thickness) {
    Grid grid;
    constexpr int turns = 16;
    for (const double z : {0.15, 0.4, 0.7, 1.1, 1.6})
        for (const double r : {0.25, 0.75, 1.25, 1.75, 2.25})
            for (int k = 0; k < turns; ++k) {
                if (z > thickness / 2) continue;
                const double phi = 2 * pi * (k + 0.5) / turns;  // sectors are centred on the axes
                grid.places.push_back({r * std::cos(phi), r * std::sin(phi), z});
                grid.volume.push_back(r);
                grid.sector.push_back(static_cast<int>(std::floor((phi + pi / sectors) / (2 * pi / sectors))) % sectors);
            }
    return grid;
}

std::vector<Matrix3d> half_space_stress(const material::Stiffness& stiffness, const Grid& grid) {
    const contact::HalfSpaceField field = contact::half_space_field(stiffness, {.force = {0, 0, 1}, .radius = 1});
    std::vector<Matrix3d> stress;
    for (const Vector3d& x : grid.places) stress.push_back(material::stress_from_voigt(field.stress(x)));
    return stress;
}

std::vector<Matrix3d> plate_stress(const fem::Solution& solution, const Grid& grid) {
    std::vector<Matrix3d> stress;
    for (const fem::FieldSample& one : solution.recovered_at(plain(grid.places)))
        stress.push_back(material::stress_from_voigt(Eigen::Map<const material::Voigt>(one.stress.data())));
    return stress;
}

double stress_error(const std::vector<Matrix3d>& half_space, const std::vector<Matrix3d>& plate, const Grid& grid) {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < grid.places.size(); ++k) {
        difference += grid.volume[k] * (half_space[k] - plate[k]).squaredNorm();
        size += grid.volume[k] * plate[k].squaredNorm();
    }
    return std::sqrt(difference / size);
}

std::array<Matrix3d, sectors> sector_means(const std::vector<Matrix3d>& stress, const Grid& grid) {
    std::array<Matrix3d, sectors> sum;
    sum.fill(Matrix3d::Zero());
    for (std::size_t k = 0; k < stress.size(); ++k) sum[grid.sector[k]] += grid.volume[k] * stress[k];
    return sum;
}

/// Largest angle between the crack normals that the two stresses predict, over the sectors whose direction is defined in the plate;
/// NaN where none is.
double crack_turn(const std::vector<Matrix3d>& half_space, const std::vector<Matrix3d>& plate, const Grid& grid) {
    const auto assumed = sector_means(half_space, grid), real = sector_means(plate, grid);
    double most = std::numeric_limits<double>::quiet_NaN();
    for (int s = 0; s < sectors; ++s) {
        const PrincipalDirection normal = principal_direction(real[s]);
        if (normal.gap < defined_gap) continue;
        const double angle = angle_between(normal.direction, principal_direction(assumed[s]).direction);
        most = std::isnan(most) ? angle : std::max(most, angle);
    }
    return most;
}

/// The thickness at which a figure that grows as plates get thinner first passes `limit`, between two of the ladder by the logarithms of
/// both; NaN where it never does.
double thickness_at(const std::vector<double>& thickness, const std::vector<double>& figure, double limit) {
    for (std::size_t k = 0; k < thickness.size(); ++k) {
        if (!(figure[k] > limit)) continue;
        if (k == 0 || !(figure[k - 1] > 0)) return thickness[k];
        const double share = std::log(limit / figure[k - 1]) / std::log(figure[k] / figure[k - 1]);
        return thickness[k - 1] * std::pow(thickness[k] / thickness[k - 1], share);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

class ContactThinWall final : public Study {
public:
    struct Level {
        std::vector<ContactSurface> surfaces;
        std::vector<double> thicknesses;
        double size;  // tet edge at the contact, m
    };
    ContactThinWall(Level quick, Level full) : quick_(std::move(quick)), full_(std::move(full)) {}

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        const Level& level = context.level == "full" ? full_ : quick_;
        for (const ContactSurface& surface : level.surfaces) measure(surface, level, context, outcome);
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return stiffnesses(quick_.surfaces); }

private:
    static void measure(const ContactSurface& surface, const Level& level, const StudyContext& context, StudyOutcome& outcome) {
        const std::vector<double>& thicknesses = level.thicknesses;
        std::vector<double> errors, turns;
        for (const double thickness : thicknesses) {
            const Grid places = grid(thickness);
            const std::vector<Matrix3d> assumed = half_space_stress(surface.stiffness, places);
            const std::filesystem::path file = contact_plate_mesh({.half_width = 10, .thickness = thickness, .size = level.size, .near_growth = 0.5, .growth = 0.5}, context.meshes);
            SolveNote note;
            const std::vector<Matrix3d> real = plate_stress(solve_contact_plate(file, surface.stiffness, note), places);
            outcome.solves.push_back(note);
            errors.push_back(stress_error(assumed, real, places));
            turns.push_back(crack_turn(assumed, real, places));
            const std::string place = fmt::format("{}, t/a = {:g}", surface.name, thickness);
            const Resolution resolution{level.size, note.cells, note.dofs};
            outcome.values.push_back({"stress_error", "half_space", place, errors.back(), resolution});
            outcome.values.push_back({"crack_turn", "half_space", place, turns.back(), resolution});
        }
        outcome.values.push_back({"thickness_over_radius", "half_space", surface.name + ", stress 10 % off", thickness_at(thicknesses, errors, 0.1)});
        outcome.values.push_back({"thickness_over_radius", "half_space", surface.name + ", stress 50 % off", thickness_at(thicknesses, errors, 0.5)});
        outcome.values.push_back({"thickness_over_radius", "half_space", surface.name + ", crack turned by 10 deg", thickness_at(thicknesses, turns, pi / 18)});
        draw(surface, thicknesses, errors, turns, context, outcome);
    }

    static void draw(const ContactSurface& surface, const std::vector<double>& thicknesses, const std::vector<double>& errors,
                     const std::vector<double>& turns, const StudyContext& context, StudyOutcome& outcome) {
        std::string stem = surface.name;
        for (char& c : stem)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        std::filesystem::create_directories(context.out / context.folder);
        std::ofstream file(context.out / context.folder / (stem + ".csv"));
        file << "thickness / contact radius,error of the stress,turn of the crack / 90 deg\n";
        for (std::size_t k = thicknesses.size(); k-- > 0;)
            file << fmt::format("{:g},{:.4g},{:.4g}\n", thicknesses[k], errors[k], std::isnan(turns[k]) ? 0 : turns[k] / (pi / 2));
        outcome.artifacts.push_back({context.folder + "/" + stem + ".csv", surface.name + ": the half-space against a free plate",
                                     "thickness / contact radius", "error"});
    }

    Level quick_, full_;
};

std::vector<double> read_thicknesses(TableReader& table, const std::string& key) {
    const std::vector<double> list = table.numbers(key);
    for (std::size_t k = 0; k < list.size(); ++k)
        if (!(list[k] >= 0.5 && list[k] <= 40) || (k > 0 && !(list[k] < list[k - 1]))) table.fail(key, "thicknesses from 40 down to 0.5, falling");
    if (list.empty()) table.fail(key, "one thickness at least");
    return list;
}

double read_size(TableReader& table, const std::string& key) {
    const double size = table.number(key);
    if (!(size >= 0.1 && size <= 1)) table.fail(key, "0.1 to 1");
    return size;
}

ContactThinWall::Level read_level(TableReader& table, const std::string& suffix) {
    return {read_surfaces(table, "surfaces" + suffix), read_thicknesses(table, "thicknesses" + suffix), read_size(table, "size" + suffix)};
}

std::shared_ptr<const Study> read(TableReader& table) { return std::make_shared<ContactThinWall>(read_level(table, ""), read_level(table, "_full")); }

}  // namespace

StudyInfo contact_thin_wall_study() {
    return {"contact_thin_wall",
            "stress and predicted crack by the half-space against finite elements on free plates of falling thickness",
            {"surfaces", "thicknesses", "size", "surfaces_full", "thicknesses_full", "size_full"},
            {{"stress_error", dimension::none}, {"crack_turn", dimension::none, true}, {"thickness_over_radius", dimension::none}},
            {"half_space"},
            read};
}

}  // namespace cleave::validation
