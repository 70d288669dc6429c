#include "validation/studies/contact_cross.hpp"

#include "solver/contact/contact_displacement.hpp"
#include "solver/mesh/msh_file.hpp"
#include "solver/particles/neighbourhood.hpp"
#include "solver/particles/smoothing_tensor.hpp"
#include "solver/particles/wpca.hpp"
#include "validation/adapters/particle_bodies.hpp"
#include "validation/analytic/half_space_fourier.hpp"
#include "validation/analytic/half_space_isotropic.hpp"
#include "validation/solutions.hpp"
#include "validation/stress_field.hpp"
#include "validation/studies/contact_plate.hpp"
#include "validation/studies/contact_surfaces.hpp"
#include "validation/studies/direction_tools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

namespace cleave::validation {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const contact::ContactLoad load{.force = {0, 0, 1}, .radius = 1};
constexpr double neighbourhood_radius = 2.5;  // m, support radius of the contact's kernel; the patch has radius 1
/// Half width and thickness (m) of the free block. It adds stresses like (radius/width)^2 to the half-space's: 6 to 7 % of the
/// neighbourhood's at 10 m under a standing fibre, 0.1 % at 80 m (at 40 m, 0.4 %), for a quarter more unknowns. In the shadow beside the
/// column of fibres that carries the load, where the stress is 3 % of the neighbourhood's, 10 m made it twice as large and turned it by 60 degrees.
constexpr double block_size = 80;
/// Directions are looked at where the stress is at least this share of the neighbourhood's rms, since errors anywhere are a share of that,
/// and from this distance on from the circle's rim (m), where the pressure's kink leaves quadratic elements first order.
constexpr double least_stress = 0.1, least_rim_distance = 0.25;
constexpr double least_depth = 0.1;           // over the distance from the axis, or from the centre to the rim: the analytic transform gets slow below

/// Stress and strain of the sampled particles, one way.
struct Way {
    std::vector<Matrix3d> stress;
    std::vector<double> energy_density;
};

/// The particles looked at, in the kernel of the particle nearest to the contact.
struct Sample {
    std::vector<int> ids;
    double support_radius;  ///< m
    std::vector<Vector3d> place;
    std::vector<double> volume;
};

Sample neighbourhood_of(const particles::Particles& particles) {
    int nearest = 0;
    for (int i = 1; i < particles.size(); ++i)
        if (particles.position[i].norm() < particles.position[nearest].norm()) nearest = i;
    const particles::CellGrid grid(particles.position, particles::suitable_cell(particles));
    const particles::LocalShape shape = particles::local_shape(particles, grid, nearest, particles::WpcaOptions{}.window);
    const Vector3d axes = neighbourhood_radius * particles::relative_axes(shape.variances, {});
    const Matrix3d kernel = particles::tensor_from_axes(shape.axes, axes);
    Sample sample{{}, neighbourhood_radius, {}, {}};
    for (const int i : particles::neighbours_of_point(particles, grid, Vector3d::Zero(), kernel)) {
        const Vector3d& x = particles.position[i];
        if (x[2] >= least_depth * std::max(load.radius, std::hypot(x[0], x[1]))) sample.ids.push_back(i);
    }
    constexpr std::size_t most = 300;
    const std::size_t stride = (sample.ids.size() + most - 1) / most;
    for (std::size_t k = 0; k * stride < sample.ids.size(); ++k) sample.ids[k] = sample.ids[k * stride];
    sample.ids.resize((sample.ids.size() + stride - 1) / stride);
    for (const int i : sample.ids) {
        sample.place.push_back(particles.position[i]);
        sample.volume.push_back(particles.volume[i]);
    }
    return sample;
}

void append(Way& way, const material::Stiffness& c, const Matrix3d& gradient) {
    const material::Voigt strain = elasticity::strain_of(gradient), stress = c * strain;
    way.stress.push_back(material::stress_from_voigt(stress));
    way.energy_density.push_back(0.5 * strain.dot(stress));
}

Matrix3d eigen_gradient(const analytic::Gradient& g) {
    return (Matrix3d() << g[0][0], g[0][1], g[0][2], g[1][0], g[1][1], g[1][2], g[2][0], g[2][1], g[2][2]).finished();
}

Way analytic_way(const ContactSurface& surface, const std::vector<Vector3d>& places) {
    Way way;
    const analytic::FourierHalfSpace fourier(plain_stiffness(surface.stiffness));
    const double G = surface.stiffness(5, 5), nu = surface.stiffness(0, 1) / (2 * (surface.stiffness(0, 1) + G));
    const material::Stiffness compliance = material::compliance(surface.stiffness);
    for (const Vector3d& x : places) {
        if (!surface.isotropic) {
            append(way, surface.stiffness, eigen_gradient(fourier.response(plain(load.force), load.radius, plain(x), 1e-3).gradient));
            continue;
        }
        const analytic::Voigt s = analytic::hertz_interior({G, nu, plain(load.force), load.radius}, plain(x)).stress;
        const material::Voigt stress = Eigen::Map<const material::Voigt>(s.data());
        way.stress.push_back(material::stress_from_voigt(stress));
        way.energy_density.push_back(0.5 * stress.dot(compliance * stress));
    }
    return way;
}

/// Hill's mean moduli in the displacement, the true stiffness in the stress: what an isotropic contact law makes of an anisotropic body.
Way isotropic_way(const ContactSurface& surface, const std::vector<Vector3d>& places) {
    const double young = material::hill_youngs_modulus(surface.stiffness), bulk = surface.stiffness.topLeftCorner<3, 3>().sum() / 9;
    const contact::HalfSpaceField field = contact::half_space_field(material::isotropic(young, std::clamp(0.5 - young / (6 * bulk), -0.9, 0.49)), load);
    Way way;
    for (const Vector3d& x : places) append(way, surface.stiffness, field.gradient(x));
    return way;
}

Way operator_way(const elasticity::StrainOperator& op, const contact::ParticleDisplacement& displacement, const ContactSurface& surface,
                 const Sample& sample) {
    std::set<int> needed(sample.ids.begin(), sample.ids.end());
    for (const int i : sample.ids) needed.insert(op.neighbours.of(i).begin(), op.neighbours.of(i).end());
    const std::vector<int> ids(needed.begin(), needed.end());
    std::vector<Vector3d> values(ids.size()), all(op.neighbours.size(), Vector3d::Zero());
    displacement(ids, values);
    for (std::size_t k = 0; k < ids.size(); ++k) all[ids[k]] = values[k];
    Way way;
    for (const int i : sample.ids) append(way, surface.stiffness, elasticity::displacement_gradient(op, i, all));
    return way;
}

Way fields_way(const elasticity::Fields& fields, const ContactSurface& surface, const Sample& sample) {
    Way way;
    for (const int i : sample.ids) append(way, surface.stiffness, fields.gradient[i]);
    return way;
}

Way fem_way(const fem::Solution& solution, const std::vector<Vector3d>& places) {
    Way way;
    for (const fem::FieldSample& one : solution.recovered_at(plain(places))) {
        const material::Voigt stress = Eigen::Map<const material::Voigt>(one.stress.data()), strain = Eigen::Map<const material::Voigt>(one.strain.data());
        way.stress.push_back(material::stress_from_voigt(stress));
        way.energy_density.push_back(0.5 * stress.dot(strain));
    }
    return way;
}

/// Where a direction is looked at, and how many are left out for which reason (the first that holds).
struct Directions {
    std::vector<char> seen;  ///< of each sampled particle; its gap is compare()'s matter
    int weak = 0, at_rim = 0, degenerate = 0;
};

Directions directions_of(const Way& reference, const Sample& sample) {
    double square = 0, volume = 0;
    for (std::size_t k = 0; k < sample.volume.size(); ++k) {
        square += sample.volume[k] * reference.stress[k].squaredNorm();
        volume += sample.volume[k];
    }
    Directions directions;
    for (std::size_t k = 0; k < sample.volume.size(); ++k) {
        const Vector3d& x = sample.place[k];
        const bool weak = reference.stress[k].norm() < least_stress * std::sqrt(square / volume);
        const bool at_rim = std::hypot(std::hypot(x[0], x[1]) - load.radius, x[2]) < least_rim_distance;
        directions.weak += weak;
        directions.at_rim += !weak && at_rim;
        directions.degenerate += !weak && !at_rim && principal_direction(reference.stress[k]).gap < defined_gap;
        directions.seen.push_back(!weak && !at_rim);
    }
    return directions;
}

/// Volume-weighted comparison of two ways over those sampled particles that `in` keeps.
struct Comparison {
    double stress = 0;     ///< rms |difference| / rms |reference|
    double direction = 0;  ///< rms angle of those seen whose gap suffices
    double share = 0;      ///< of the volume, of those
};

template <typename In>
Comparison compare(const Way& way, const Way& reference, const Sample& sample, const Directions& directions, double least_gap, const In& in) {
    double difference = 0, size = 0, angle = 0, defined = 0, all = 0;
    for (std::size_t k = 0; k < sample.volume.size(); ++k) {
        const PrincipalDirection exact = principal_direction(reference.stress[k]);
        if (!in(k, exact.gap)) continue;
        const double volume = sample.volume[k];
        difference += volume * (way.stress[k] - reference.stress[k]).squaredNorm();
        size += volume * reference.stress[k].squaredNorm();
        all += volume;
        if (!directions.seen[k] || exact.gap < least_gap) continue;
        angle += volume * std::pow(angle_between(principal_direction(way.stress[k]).direction, exact.direction), 2);
        defined += volume;
    }
    return {std::sqrt(difference / size), std::sqrt(angle / defined), defined / all};
}

analytic::Voigt plain_stress(const Matrix3d& s) { return {s(0, 0), s(1, 1), s(2, 2), s(1, 2), s(0, 2), s(0, 1)}; }

double energy(const Way& way, const std::vector<double>& volume) {
    double sum = 0;
    for (std::size_t k = 0; k < volume.size(); ++k) sum += volume[k] * way.energy_density[k];
    return sum;
}

class ContactCross final : public Study {
public:
    struct Level {
        std::vector<ContactSurface> surfaces;
        std::vector<double> sizes;
    };
    ContactCross(Level quick, Level full) : quick_(std::move(quick)), full_(std::move(full)) {}

    StudyOutcome run(const StudyContext& context) const override {
        StudyOutcome outcome;
        const Level& level = context.level == "full" ? full_ : quick_;
        for (const ContactSurface& surface : level.surfaces)
            for (const double size : level.sizes) measure(surface, size, size == level.sizes.back(), context, outcome);
        return outcome;
    }

    std::vector<material::Stiffness> materials() const override { return stiffnesses(quick_.surfaces); }

private:
    /// In the order of the curves drawn.
    using Ways = std::vector<std::pair<std::string, Way>>;

    static void measure(const ContactSurface& surface, double size, bool finest, const StudyContext& context, StudyOutcome& outcome) {
        const std::filesystem::path file = contact_plate_mesh({.half_width = block_size, .thickness = block_size, .size = size, .near_growth = 0.2, .growth = 0.4}, context.meshes);
        const mesh::TetMesh mesh = mesh::read_msh(file);
        const particles::Particles plain_particles = particles::from_mesh(mesh);
        const Sample sample = neighbourhood_of(plain_particles);
        Ways ways{{"analytic", analytic_way(surface, sample.place)}};
        add_particle_ways(mesh, plain_particles, surface, sample, ways, outcome);
        ways.emplace_back("half_space.isotropic", isotropic_way(surface, sample.place));
        SolveNote note;
        ways.emplace_back("fem.p2", fem_way(solve_contact_plate(file, surface.stiffness, note), sample.place));
        outcome.solves.push_back(note);
        record(surface, ways, sample, {size, static_cast<long>(mesh.tets.size()), note.dofs}, outcome);
        if (finest) draw(surface, ways, sample, context, outcome);
    }

    static void add_particle_ways(const mesh::TetMesh& mesh, const particles::Particles& plain_particles, const ContactSurface& surface,
                                  const Sample& sample, Ways& ways, StudyOutcome& outcome) {
        const std::map<int, material::Stiffness> stiffness{{1, surface.stiffness}};
        const contact::ContactBody body{mesh, plain_particles, stiffness};
        const contact::ParticleDisplacement half_space = contact::contact_displacement(contact::DisplacementSource::half_space, body, load, {.accuracy = 1e-5});
        particles::Particles supported = plain_particles;
        const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(supported);
        for (const std::string& name : elasticity::strain_operator_names())
            ways.emplace_back("half_space." + name, operator_way(elasticity::make_strain_operator(name, supported, neighbourhood), half_space, surface, sample));
        const auto start = std::chrono::steady_clock::now();
        const elasticity::EquilibriumSolution solution = contact::contact_equilibrium(body, load, {.tolerance = 1e-8});
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        outcome.solves.push_back({"equilibrium", "conjugate gradients", static_cast<long>(mesh.tets.size()), 3L * plain_particles.size(),
                                  solution.report.iterations, solution.report.residual, seconds});
        ways.emplace_back("half_space.conforming", operator_way(elasticity::conforming_operator(*solution.body), half_space, surface, sample));
        ways.emplace_back("equilibrium", fields_way(solution.fields, surface, sample));
        ways.emplace_back("equilibrium_recovered", fields_way(solution.recovered, surface, sample));
    }

    static void record(const ContactSurface& surface, const Ways& ways, const Sample& sample, const Resolution& resolution, StudyOutcome& outcome) {
        const Way& reference = ways.front().second;
        const Directions directions = directions_of(reference, sample);
        const auto add = [&](const std::string& quantity, const std::string& method, double value) {
            outcome.values.push_back({quantity, method, surface.name, value, resolution});
        };
        for (const auto& [name, way] : ways) {
            add("energy", name, energy(way, sample.volume));
            if (name == "analytic") continue;
            const Comparison all = compare(way, reference, sample, directions, defined_gap, [](std::size_t, double) { return true; });
            add("stress_error", name, all.stress);
            add("direction_error", name, all.direction);
            if (name == "fem.p2") add("defined_share", "analytic", all.share);
        }
        add("directions_weak", "analytic", directions.weak);
        add("directions_at_rim", "analytic", directions.at_rim);
        add("directions_degenerate", "analytic", directions.degenerate);
        add("directions_judged", "analytic", static_cast<double>(sample.ids.size()) - directions.weak - directions.at_rim - directions.degenerate);
    }

    /// One CSV by depth over the kernel's support radius, one by the gap of the principal stresses: middle of each bin, a column per way.
    static void draw(const ContactSurface& surface, const Ways& ways, const Sample& sample, const StudyContext& context, StudyOutcome& outcome) {
        std::string stem = surface.name;
        for (char& c : stem)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        write_bins(context, stem + "_depth.csv", "depth / h", ways, sample, {0, 0.1, 0.2, 0.35, 0.5, 0.75, 1},
                   [&](std::size_t k, double) { return sample.place[k][2] / sample.support_radius; }, [](const Comparison& c) { return c.stress; });
        write_bins(context, stem + "_gap.csv", "gap / |stress|", ways, sample, {0, 0.1, 0.2, 0.4, 0.6, 0.8, 1}, [](std::size_t, double gap) { return gap; },
                   [](const Comparison& c) { return degrees(c.direction); });
        outcome.artifacts.push_back({context.folder + "/" + stem + "_depth.csv", surface.name + ": error of the stress by depth", "depth / h", "rms error"});
        outcome.artifacts.push_back({context.folder + "/" + stem + "_gap.csv", surface.name + ": error of the direction by gap", "gap / |stress|", "rms angle / deg"});
        outcome.artifacts.push_back(draw_fields(stem, surface, ways, sample, context));
    }

    /// The equilibrium of the particles beside the finite elements, in the kernel, for the 3D views.
    static Artifact draw_fields(const std::string& stem, const ContactSurface& surface, const Ways& ways, const Sample& sample, const StudyContext& context) {
        const auto way = [&](const std::string& name) -> const Way& {
            return std::find_if(ways.begin(), ways.end(), [&](const auto& one) { return one.first == name; })->second;
        };
        StressPair pair{"equilibrium", "fem.p2, recovered", plain(sample.place), sample.volume, {}, {}};
        for (std::size_t k = 0; k < sample.place.size(); ++k) {
            pair.particles.push_back(plain_stress(way("equilibrium").stress[k]));
            pair.fem.push_back(plain_stress(way("fem.p2").stress[k]));
        }
        return write_stress_field(pair, context.folder + "/" + stem + "_stress_field.json", surface.name + ": stress around the contact", context.out);
    }

    template <typename Abscissa, typename Value>
    static void write_bins(const StudyContext& context, const std::string& file_name, const std::string& x, const Ways& ways,
                           const Sample& sample, const std::vector<double>& limits, const Abscissa& abscissa, const Value& value) {
        const Directions directions = directions_of(ways.front().second, sample);
        std::filesystem::create_directories(context.out / context.folder);
        std::ofstream file(context.out / context.folder / file_name);
        file << x;
        for (std::size_t w = 1; w < ways.size(); ++w) file << "," << ways[w].first;
        file << "\n";
        for (std::size_t bin = 0; bin + 1 < limits.size(); ++bin) {
            const auto in = [&](std::size_t k, double gap) { return abscissa(k, gap) >= limits[bin] && abscissa(k, gap) < limits[bin + 1]; };
            std::string line = fmt::format("{:.4g}", (limits[bin] + limits[bin + 1]) / 2);
            bool empty = false;
            for (std::size_t w = 1; w < ways.size(); ++w) {
                const double one = value(compare(ways[w].second, ways.front().second, sample, directions, 0, in));
                empty = empty || !std::isfinite(one);
                line += fmt::format(",{:.4g}", one);
            }
            if (!empty) file << line << "\n";
        }
    }

    Level quick_, full_;
};

std::vector<double> read_sizes(TableReader& table, const std::string& key) {
    const std::vector<double> sizes = table.numbers(key);
    for (const double size : sizes)
        if (!(size > 0.05 && size <= 1)) table.fail(key, "sizes above 0.05 and up to 1");
    if (sizes.empty()) table.fail(key, "one size at least");
    return sizes;
}

std::shared_ptr<const Study> read(TableReader& table) {
    return std::make_shared<ContactCross>(ContactCross::Level{read_surfaces(table, "surfaces"), read_sizes(table, "sizes")},
                                          ContactCross::Level{read_surfaces(table, "surfaces_full"), read_sizes(table, "sizes_full")});
}

}  // namespace

StudyInfo contact_cross_study() {
    return {"contact_cross",
            "stress, principal direction and energy around a contact: analytic, half-space by each operator, equilibrium, finite elements",
            {"surfaces", "sizes", "surfaces_full", "sizes_full"},
            {{"stress_error", dimension::none}, {"direction_error", dimension::none, true}, {"energy", dimension::energy}, {"defined_share", dimension::none},
             {"directions_weak", dimension::none}, {"directions_at_rim", dimension::none}, {"directions_degenerate", dimension::none},
             {"directions_judged", dimension::none}},
            {"analytic", "half_space.paper", "half_space.corrected", "half_space.quadratic", "half_space.conforming", "half_space.isotropic", "equilibrium",
             "equilibrium_recovered", "fem.p2"},
            read,
            {"analytic"}};
}

}  // namespace cleave::validation
