#include "benchmarks/rows.hpp"

#include "benchmarks/timing.hpp"
#include "solver/contact/half_space.hpp"
#include "solver/fracture/crack_generation.hpp"
#include "solver/material/material.hpp"
#include "solver/mesh/morton.hpp"
#include "solver/mesh/test/test_meshes.hpp"
#include "solver/particles/neighbourhood.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

namespace cleave::benchmarks {
namespace {

constexpr int passes = 401;
constexpr int wished_neighbours = 100;

/// A cube of 6,000 tets (1 m), hit in the middle of its top; operator `corrected` with the default supports, and a kernel at the contact
/// that holds about a hundred particles.
struct HitBody {
    explicit HitBody(const material::Stiffness& stiffness)
        : mesh(mesh::in_morton_order(mesh::test::kuhn_cube(10, 0.15))), particles(particles::from_mesh(mesh)), op(corrected()),
          solid(elasticity::uniform_solid(stiffness, particles.size())) {
        const double factor = kernel_factor();
        for (Eigen::Matrix3d& tensor : particles.tensor) tensor /= factor;
    }

    elasticity::StrainOperator corrected() {
        const particles::Neighbourhood neighbourhood = particles::build_neighbourhood(particles);
        return elasticity::make_strain_operator("corrected", particles, neighbourhood);
    }

    /// By how much the supports have to grow for the kernel about the contact to hold the neighbours wished for.
    double kernel_factor() const {
        std::vector<double> distance;
        for (const Eigen::Vector3d& x : particles.position) distance.push_back((x - load.point).norm());
        const auto nearest = std::min_element(distance.begin(), distance.end()) - distance.begin();
        const double support = particles.support_radius[nearest];
        std::nth_element(distance.begin(), distance.begin() + wished_neighbours, distance.end());
        return distance[wished_neighbours] / support;
    }

    fracture::Body body() const { return {particles, op, solid, {{.strength = 1e6, .strain_limit = 1e-4, .toughness = fracture::Toughness::uniform(8)}}, {}, 0.3, 2}; }

    contact::ContactLoad load{.point = {0.5, 0.5, 1}, .inward = {0, 0, -1}, .force = {2e4, 0, -1e5}, .radius = 0.015};
    mesh::TetMesh mesh;
    particles::Particles particles;
    elasticity::StrainOperator op;
    elasticity::Solid solid;
};

/// A displacement source over a half-space field made for this contact.
fracture::Displacement displacement(const HitBody& body, const std::shared_ptr<const contact::HalfSpace>& half_space) {
    return [&body, field = contact::HalfSpaceField(half_space, body.load)](std::span<const int> ids, std::span<Eigen::Vector3d> values) {
        std::vector<Eigen::Vector3d> positions;
        positions.reserve(ids.size());
        for (const int i : ids) positions.push_back(body.particles.position[i]);
        field.displacements(positions, values);
    };
}

void report(benchmark::State& state, const std::vector<double>& seconds) {
    state.SetIterationTime(median(seconds));
    state.counters["microseconds"] = 1e6 * median(seconds);
}

/// One contact: half-space field, Algorithm 1 with its displacements, gradients, stresses, principal directions and radii, 4 groups. The
/// half-space itself is made before: see the rows of new normals.
void one_contact(benchmark::State& state, const material::Stiffness& stiffness, const contact::HalfSpaceOptions& options_of_space,
                 fracture::Grouping grouping) {
    const HitBody body(stiffness);
    const auto half_space = std::make_shared<contact::HalfSpace>(stiffness, body.load.inward, options_of_space);
    fracture::CrackGenerator generator(body.body());
    fracture::Options options;
    options.groups = 4;
    options.grouping = grouping;
    const fracture::AnalysedPoint point{body.load.point, body.load.inward, {1, 0, 0}};
    std::size_t displacements = 0;
    const auto counted = [&](std::span<const int> ids, std::span<Eigen::Vector3d> values) {
        displacements = ids.size();
        displacement(body, half_space)(ids, values);
    };
    fracture::CrackAnalysis analysis = generator.generate(point, counted, options);
    std::vector<double> seconds;
    for (auto _ : state) {
        for (int pass = 0; pass < passes; ++pass)
            seconds.push_back(seconds_of([&] { analysis = generator.generate(point, displacement(body, half_space), options); }));
        report(state, seconds);
    }
    if (analysis.points.front().groups.size() != 4) throw std::logic_error("stress analysis: four groups");
    state.counters["neighbours"] = analysis.points.front().considered;
    state.counters["displacements"] = static_cast<double>(displacements);
    state.counters["cracks"] = static_cast<double>(analysis.cracks.size());
}

/// The same with groups by azimuth, which need no iteration.
void one_contact_by_azimuth(benchmark::State& state, const material::Stiffness& stiffness, const contact::HalfSpaceOptions& options) {
    one_contact(state, stiffness, options, fracture::Grouping::azimuth);
}

/// The default's contact.
void one_default_contact(benchmark::State& state, const material::Stiffness& stiffness, const contact::HalfSpaceOptions& options) {
    one_contact(state, stiffness, options, fracture::Options{}.grouping);
}

/// The first contact under a new direction of the surface: also the Stroh eigenvectors, and the table where one is asked for.
void first_contact(benchmark::State& state, const material::Stiffness& stiffness, const contact::HalfSpaceOptions& options) {
    const HitBody body(stiffness);
    std::vector<double> seconds;
    for (auto _ : state) {
        for (int pass = 0; pass < 21; ++pass)
            seconds.push_back(seconds_of([&] {
                const auto half_space = std::make_shared<contact::HalfSpace>(stiffness, body.load.inward, options);
                const contact::HalfSpaceField field(half_space, body.load);
                for (const Eigen::Vector3d& x : body.particles.position)
                    if ((x - body.load.point).norm() < 0.15) benchmark::DoNotOptimize(field.displacement(x));
            }));
        report(state, seconds);
    }
}

void add(const std::string& name, void (*row)(benchmark::State&, const material::Stiffness&, const contact::HalfSpaceOptions&),
         const std::string& material, bool tabulated) {
    benchmark::RegisterBenchmark(("stress_analysis/" + name).c_str(), [=](benchmark::State& state) {
        row(state, material::find_material(material).stiffness, {.accuracy = 1e-3, .tabulated = tabulated});
    })->UseManualTime()->Iterations(1)->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_stress_analysis() {
    add("isotropic", one_default_contact, "soda-lime glass", false);
    add("isotropic_by_azimuth", one_contact_by_azimuth, "soda-lime glass", false);
    add("anisotropic", one_default_contact, "silicon", true);
    add("anisotropic_by_azimuth", one_contact_by_azimuth, "silicon", true);
    add("anisotropic_sum", one_default_contact, "silicon", false);
    add("anisotropic_new_normal", first_contact, "silicon", true);
    add("anisotropic_sum_new_normal", first_contact, "silicon", false);
}

}  // namespace cleave::benchmarks
