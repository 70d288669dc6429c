#include "solver/simulation/scene_body.hpp"

#include "solver/contact/contact_displacement.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/indentation.hpp"
#include "solver/elasticity/conforming_body.hpp"
#include "solver/fracture/interfaces.hpp"
#include "solver/fragments/surface.hpp"
#include "solver/input/input_error.hpp"
#include "solver/material/voigt.hpp"
#include "solver/mesh/check.hpp"
#include "solver/particles/nearest.hpp"
#include "solver/particles/neighbourhood.hpp"
#include "solver/particles/wpca.hpp"
#include "solver/simulation/closest_point.hpp"
#include "solver/simulation/fragment_shape.hpp"
#include "solver/simulation/stopwatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace cleave::simulation {

namespace {

particles::Particles shaped_particles(const mesh::TetMesh& mesh, const KernelSpec& kernel) {
    particles::Particles particles = particles::from_mesh(mesh, kernel.support);
    if (kernel.wpca) {
        particles::WpcaOptions options;
        options.scale = kernel.scale;
        particles::apply_wpca(particles, options);
    }
    return particles;
}

/// E / (1 - nu^2) where isotropic, at once; else by Stroh's sum over directions.
double modulus_of(const material::Stiffness& stiffness, const Eigen::Vector3d& inward) {
    if (!contact::is_isotropic(stiffness)) return contact::indentation_modulus(stiffness, inward);
    const material::EngineeringConstants constants = material::engineering_constants(stiffness);
    return constants.E1 / (1 - constants.nu12 * constants.nu12);
}

}  // namespace

struct SceneBody::Analysis {
    particles::Particles particles;
    elasticity::StrainOperator strain_operator;
    elasticity::Solid solid;
    std::unique_ptr<fracture::CrackGenerator> generator;
    fracture::Options options;
    contact::DisplacementSource source = contact::DisplacementSource::half_space;

    Analysis(const Scene& scene, const BodySpec& spec, const mesh::TetMesh& mesh, const std::map<int, material::Stiffness>& stiffness)
        : particles(shaped_particles(mesh, spec.kernel)), options(scene.analysis), source(scene.displacement) {
        options.groups = spec.groups;
        if (scene.strain_operator == "conforming") {
            strain_operator = elasticity::conforming_operator(elasticity::make_conforming_body(mesh, particles, stiffness));
        } else {
            particles::Neighbourhood neighbourhood = particles::build_neighbourhood(particles);  // first: it enlarges supports
            strain_operator = elasticity::make_strain_operator(scene.strain_operator, particles, std::move(neighbourhood));
        }
        solid = elasticity::solid_of_regions(particles.region, stiffness);
    }
};

SceneBody::SceneBody(const BodySpec& spec, const Scene& scene, const std::filesystem::path& cache)
    : spec_(spec), boundary_(scene.boundary), hulls_(scene.hulls) {
    if (is_ball()) return;
    mesh::Body body = mesh::make_body(*spec.source, cache);
    mesh_ = std::move(body.mesh);
    frames_ = std::move(body.frames);
    if (mesh_.regions.empty()) mesh_.regions.assign(mesh_.tets.size(), 0);
    set_materials();
    fragmented_ = std::make_unique<fragments::FragmentedBody>(mesh_, scene.scheme);
    results_.resize(mesh_.tets.size());
    find_surface();
    if (!spec.breakable) return;
    if (static_cast<std::size_t>(spec.groups) > mesh_.tets.size())
        throw InputError(scene.file, spec.name + ".groups", fmt::format("at most as many as the body has particles, {} (not {})", mesh_.tets.size(), spec.groups));
    analysis_ = std::make_unique<Analysis>(scene, spec_, mesh_, stiffness_);
    std::vector<fracture::Brittleness> brittleness(analysis_->solid.stiffness.size());
    for (std::size_t tet = 0; tet < mesh_.tets.size(); ++tet)
        brittleness[static_cast<std::size_t>(analysis_->solid.material[tet])] = material_of_region(mesh_.regions[tet]).brittleness;
    const fracture::Body seen{.particles = analysis_->particles,
                              .strain_operator = analysis_->strain_operator,
                              .solid = analysis_->solid,
                              .brittleness = brittleness,
                              .interfaces = fracture::interface_faces(mesh_, analysis_->solid.material),
                              .thickness = spec.thickness > 0 ? spec.thickness : fracture::mean_thickness(mesh_),
                              .reach = std::min(scene.largest_radius, fracture::diameter(analysis_->particles))};
    analysis_->generator = std::make_unique<fracture::CrackGenerator>(seen);
}

SceneBody::~SceneBody() = default;

const elasticity::OperatorReport* SceneBody::operator_report() const { return analysis_ ? &analysis_->strain_operator.report : nullptr; }

const BodyMaterial& SceneBody::material_of_region(int region) const {
    const auto name = mesh_.region_names.find(region);
    if (name == mesh_.region_names.end()) return spec_.material;
    const auto own = spec_.region_materials.find(name->second);
    return own == spec_.region_materials.end() ? spec_.material : own->second;
}

void SceneBody::set_materials() {
    for (const auto& [name, unused] : spec_.region_materials) {
        const auto has = [&name = name](const auto& region) { return region.second == name; };
        if (std::none_of(mesh_.region_names.begin(), mesh_.region_names.end(), has))
            throw InputError("", fmt::format("region_materials of {}", spec_.name), fmt::format("names of the mesh's regions (not '{}')", name));
    }
    for (const int region : mesh_.regions) {
        if (stiffness_.contains(region)) continue;
        const material::Stiffness own = material_of_region(region).elastic.stiffness;
        const auto frame = frames_.find(region);
        stiffness_[region] = frame == frames_.end() ? own : material::rotate_stiffness(own, frame->second);
    }
    for (const int region : mesh_.regions) density_.push_back(material_of_region(region).elastic.density);
}

void SceneBody::find_surface() {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh_);
    std::vector<Eigen::Vector3d> centroids;
    for (int half_face = 0; half_face < static_cast<int>(links.opposite.size()); ++half_face) {
        if (links.opposite[half_face] >= 0) continue;
        const std::array<int, 3> face = mesh::face_of(mesh_.tets[half_face / 4], half_face % 4);
        const Eigen::Vector3d centroid = (mesh_.vertices[face[0]] + mesh_.vertices[face[1]] + mesh_.vertices[face[2]]) / 3;
        for (const int vertex : face) surface_size_ = std::max(surface_size_, (mesh_.vertices[vertex] - centroid).norm());
        surface_.push_back(face);
        centroids.push_back(centroid);
    }
    surface_grid_ = std::make_unique<particles::CellGrid>(centroids, surface_size_);
}

int SceneBody::particles_now() const {
    if (is_ball()) return 0;
    int count = 0;
    for (const int fragment : fragmented_->current_fragments()) count += static_cast<int>(fragmented_->fragment(fragment).particles.size());
    return count;
}

std::vector<int> SceneBody::current_fragments() const { return is_ball() ? std::vector<int>{0} : fragmented_->current_fragments(); }

bool SceneBody::is_held(const fragments::Fragment& fragment) const {
    for (const int particle : fragment.particles)
        for (const Eigen::AlignedBox3d& box : spec_.held)
            if (box.contains(fragmented_->centroid(particle))) return true;
    return false;
}

std::vector<rigid::SurfaceParticle> surface_pieces(const fragments::FragmentedBody& body, const fragments::Fragment& fragment,
                                                   const std::vector<int>& at_surface, const std::function<double(int original)>& density) {
    std::vector<int> parents;
    for (const int particle : at_surface) parents.push_back(body.parent(particle));
    std::sort(parents.begin(), parents.end());
    parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
    std::vector<rigid::SurfaceParticle> pieces(parents.size(), {.position = Eigen::Vector3d::Zero()});
    for (const int particle : fragment.particles) {
        const int parent = body.parent(particle);
        const auto place = std::lower_bound(parents.begin(), parents.end(), parent);
        if (place == parents.end() || *place != parent) continue;
        rigid::SurfaceParticle& piece = pieces[static_cast<std::size_t>(place - parents.begin())];
        const double volume = body.volume(particle);
        piece.position += volume * body.centroid(particle);
        piece.volume += volume;
        piece.id = parent;
    }
    for (rigid::SurfaceParticle& piece : pieces) {
        piece.position /= piece.volume;
        piece.mass = density(piece.id) * piece.volume;
    }
    return pieces;
}

FragmentForm SceneBody::ball_form() const {
    FragmentForm form;
    const double radius = spec_.ball_radius, volume = 4 * std::numbers::pi / 3 * radius * radius * radius;
    const double mass = spec_.material.elastic.density * volume;
    form.mass = {volume, mass, Eigen::Vector3d::Zero(), 0.4 * mass * radius * radius * Eigen::Matrix3d::Identity()};
    form.rigid.spheres = {{Eigen::Vector3d::Zero(), radius}};
    form.rigid.mass = mass;
    form.rigid.inertia = form.mass.inertia;
    form.shape = ball_shape(radius);
    form.boundary_particles = 1;
    return form;
}

FragmentForm SceneBody::form(int fragment_number) const {
    if (is_ball()) return ball_form();
    const fragments::Fragment& fragment = fragmented_->fragment(fragment_number);
    const auto density = [&](int original) { return density_of(original); };
    FragmentForm form;
    form.mass = fragments::mass_properties(*fragmented_, fragment, density);
    const fragments::Surface surface = fragments::surface(*fragmented_, fragment);
    form.shape = shape_of(surface);
    std::vector<int> at_surface;
    for (const fragments::SurfaceFace& face : surface.faces) at_surface.push_back(face.particle);
    const auto boundary = rigid::boundary_particles(surface_pieces(*fragmented_, fragment, at_surface, density), boundary_);
    form.boundary_particles = static_cast<int>(boundary.size());
    form.rigid.mass = form.mass.mass;
    form.rigid.centre = form.mass.centre;
    form.rigid.inertia = form.mass.inertia;
    form.rigid.held = is_held(fragment);
    if (hulls_) form.rigid.hull = surface.points;
    else
        for (const rigid::BoundaryParticle& particle : boundary) form.rigid.spheres.push_back({particle.position, particle.radius});
    return form;
}

double SceneBody::indentation_modulus(const Eigen::Vector3d& place, const Eigen::Vector3d& inward) const {
    if (is_ball()) return modulus_of(spec_.material.elastic.stiffness, inward);
    int nearest = 0;
    if (stiffness_.size() > 1)
        for (int i = 1; i < original_particles(); ++i)
            if (particles::is_nearer(place, mesh::tet_centroid(mesh_, i), mesh::tet_centroid(mesh_, nearest))) nearest = i;
    return modulus_of(stiffness_.at(mesh_.regions[static_cast<std::size_t>(nearest)]), inward);
}

Eigen::Vector3d SceneBody::surface_point(const Eigen::Vector3d& place, double reach) const {
    if (is_ball()) return place;
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach + surface_size_);
    std::vector<int> near;
    surface_grid_->collect(place - half, place + half, near);
    Eigen::Vector3d best = place;
    bool found = false;
    for (const int triangle : near) {
        const auto& [a, b, c] = surface_[static_cast<std::size_t>(triangle)];
        const Eigen::Vector3d point = closest_point(place, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
        if (!((point - place).norm() < reach) || (found && !particles::is_nearer(place, point, best))) continue;
        found = true;
        best = point;
    }
    return best;
}

contact::ContactLoad SceneBody::peak_load(const Blow& blow) const {
    contact::ContactLoad load;
    load.inward = blow.inward;
    load.point = surface_point(blow.point, 1 / blow.curvature);
    const double modulus = contact::contact_modulus(indentation_modulus(load.point, load.inward), blow.other_modulus);
    const contact::HertzContact peak = contact::hertz_impact(blow.effective_mass, 1 / blow.curvature, modulus, blow.speed).peak;
    load.force = peak.force * load.inward;
    load.radius = peak.radius;
    return load;
}

contact::ParticleDisplacement SceneBody::displacement_under(const contact::ContactLoad& load) const {
    try {
        const contact::ContactBody body{.mesh = mesh_, .particles = analysis_->particles, .stiffness = stiffness_};
        return contact::contact_displacement(analysis_->source, body, load);
    } catch (const elasticity::NotConverged& error) {
        throw InputError("", "analysis.displacement", fmt::format("half_space, or a body '{}' of better condition: {}", spec_.name, error.what()));
    }
}

fracture::CrackAnalysis SceneBody::analyse(const contact::ContactLoad& load) {
    const contact::ParticleDisplacement displacement = displacement_under(load);
    const fracture::AnalysedPoint point{.position = load.point, .normal = load.inward,
                                        .contact_area = std::numbers::pi * load.radius * load.radius};
    fracture::CrackAnalysis found = analysis_->generator->generate(point, displacement, analysis_->options);
    for (const fracture::PointAnalysis& analysis : found.points)
        for (const fracture::Group& group : analysis.groups)
            for (const int member : group.members) {
                ParticleResult& result = results_[static_cast<std::size_t>(member)];
                for (int k = 0; k < 6; ++k) result.stress[static_cast<std::size_t>(k)] = static_cast<float>(group.stress[k]);
                result.energy_density = static_cast<float>(0.5 * group.stress.dot(group.strain));
            }
    return found;
}

SceneBody::Opened SceneBody::open_crack(const fragments::Crack& crack, int fragment, CrackTimes& times) {
    Opened opened;
    {
        const Stopwatch watch(times.subdivision);
        const subdivision::Counts counts = fragmented_->subdivide(crack, fragment);
        opened.changed = counts.three_one + counts.two_two > 0;
    }
    const Stopwatch watch(times.cracks);
    const fragments::CrackOutcome outcome = fragmented_->open(crack, fragment);
    history_.push_back({crack, fragment});
    opened.changed = opened.changed || outcome.removed_links > 0 || outcome.isolated > 0;
    opened.fragments = outcome.new_fragments.empty() ? std::vector<int>{fragment} : outcome.new_fragments;
    return opened;
}

SceneBody::Opened SceneBody::open_cracks(const std::vector<fracture::Crack>& cracks, int fragment, CrackTimes& times) {
    Opened all{.fragments = {fragment}};
    for (const fracture::Crack& crack : cracks) {
        if (!(crack.outer_radius > 0)) continue;
        const fragments::Crack disc{.disc = {.centre = crack.centre, .normal = crack.normal, .radius = crack.outer_radius},
                                    .inner_radius = crack.inner_radius, .region = region_of_material(crack.material)};
        std::vector<int> next;
        for (const int piece : all.fragments) {
            if (fragmented_->fragment(piece).particles.size() < 2) {
                next.push_back(piece);
                continue;
            }
            const Opened opened = open_crack(disc, piece, times);
            next.insert(next.end(), opened.fragments.begin(), opened.fragments.end());
            all.changed = all.changed || opened.changed;
        }
        all.fragments = std::move(next);
    }
    std::sort(all.fragments.begin(), all.fragments.end());
    return all;
}

std::optional<int> SceneBody::region_of_material(int material) const {
    const elasticity::Solid& solid = analysis_->solid;
    if (solid.stiffness.size() < 2) return std::nullopt;
    std::optional<int> found;
    for (std::size_t i = 0; i < solid.material.size(); ++i) {
        if (solid.material[i] != material) continue;
        if (found && *found != mesh_.regions[i]) return std::nullopt;
        found = mesh_.regions[i];
    }
    return found;
}

std::string SceneBody::material_name(int material) const {
    const std::optional<int> region = region_of_material(material);
    const auto name = mesh_.region_names.find(region.value_or(-1));
    return name == mesh_.region_names.end() ? spec_.name : name->second;
}

void SceneBody::repeat(const std::vector<OpenedCrack>& history, std::vector<ParticleResult> results) {
    CrackTimes times;
    for (const OpenedCrack& opened : history) open_crack(opened.crack, opened.fragment, times);
    results_ = std::move(results);
}

void SceneBody::make_whole() {
    fragmented_->reset();
    history_.clear();
    results_.assign(mesh_.tets.size(), {});
}

}  // namespace cleave::simulation
