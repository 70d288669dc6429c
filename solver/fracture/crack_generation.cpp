#include "solver/fracture/crack_generation.hpp"

#include "solver/fracture/crack_tip.hpp"
#include "solver/fracture/radii.hpp"
#include "solver/particles/nearest.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cleave::fracture {

namespace {

double mean_spacing(const particles::Particles& particles) {
    return std::cbrt(std::accumulate(particles.volume.begin(), particles.volume.end(), 0.0) / particles.size());
}

const Body& checked(const Body& body) {
    const auto count = static_cast<std::size_t>(body.particles.size());
    if (count == 0) throw std::invalid_argument("a body with particles");
    if (body.solid.material.size() != count || static_cast<std::size_t>(body.strain_operator.neighbours.size()) != count)
        throw std::invalid_argument("a material and a strain operator for every particle");
    if (body.brittleness.size() != body.solid.stiffness.size()) throw std::invalid_argument("one brittleness for every material");
    if (!(body.thickness > 0) || !(body.reach > 0)) throw std::invalid_argument("a thickness and a reach above zero");
    return body;
}

/// Materials of a crack and of those it came through: it does not return into one of them.
std::vector<int> materials_on_the_way(const std::vector<Crack>& cracks, int crack) {
    std::vector<int> materials;
    for (; crack >= 0; crack = cracks[crack].parent) materials.push_back(cracks[crack].material);
    return materials;
}

bool contains(const std::vector<int>& sorted, int value) { return std::binary_search(sorted.begin(), sorted.end(), value); }

}  // namespace

double mean_thickness(const mesh::TetMesh& mesh) {
    const mesh::HalfFaceLinks links = mesh::link_half_faces(mesh);
    double area = 0;
    for (std::size_t half = 0; half < links.opposite.size(); ++half) {
        if (links.opposite[half] >= 0) continue;
        const auto corner = mesh::face_of(mesh.tets[half / 4], static_cast<int>(half % 4));
        const Eigen::Vector3d& a = mesh.vertices[corner[0]];
        area += 0.5 * (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).norm();
    }
    return 2 * mesh::total_volume(mesh) / area;
}

double diameter(const particles::Particles& particles) {
    Eigen::Vector3d low = particles.position.front(), high = low;
    for (const Eigen::Vector3d& x : particles.position) low = low.cwiseMin(x), high = high.cwiseMax(x);
    return (high - low).norm();
}

Displacement displacement_from_field(const particles::Particles& particles, std::function<Eigen::Vector3d(const Eigen::Vector3d&)> field) {
    return [&particles, field = std::move(field)](std::span<const int> ids, std::span<Eigen::Vector3d> displacement) {
        for (std::size_t k = 0; k < ids.size(); ++k) displacement[k] = field(particles.position[ids[k]]);
    };
}

Displacement displacement_from_values(const std::vector<Eigen::Vector3d>& values) {
    return [&values](std::span<const int> ids, std::span<Eigen::Vector3d> displacement) {
        for (std::size_t k = 0; k < ids.size(); ++k) displacement[k] = values[ids[k]];
    };
}

CrackGenerator::CrackGenerator(const Body& body)
    : body_(checked(body)), grid_(body.particles.position, particles::suitable_cell(body.particles)), place_(body.particles.size(), -1) {
    const double spacing = mean_spacing(body.particles);
    extent_ = diameter(body.particles);
    reference_area_ = spacing * spacing;
}

/// By distance, then by coordinates. Searches balls that double: a ball that holds a particle holds the nearest one. -1 where the body
/// has none of the material.
int CrackGenerator::nearest_particle(const Eigen::Vector3d& position, int material) const {
    const auto& x = body_.particles.position;
    const auto nearer = [&](int a, int b) { return particles::is_nearer(position, x[a], x[b]); };
    const double farthest = 2 * (extent_ + (x.front() - position).norm());
    for (double radius = std::sqrt(reference_area_);; radius *= 2) {
        std::vector<int> inside = particles::neighbours_of_point(body_.particles, grid_, position, Eigen::Matrix3d::Identity() / radius);
        if (material != any_material) std::erase_if(inside, [&](int i) { return body_.solid.material[i] != material; });
        if (!inside.empty()) return *std::min_element(inside.begin(), inside.end(), nearer);
        if (radius > farthest) return -1;
    }
}

/// Lines 1 to 9: the particles inside the nearest particle's kernel about the point, of the material.
std::vector<int> CrackGenerator::members_of(PointAnalysis& analysis) const {
    const Eigen::Matrix3d& kernel = body_.particles.tensor[analysis.nearest];
    analysis.support_radius = 1 / std::cbrt(kernel.determinant());
    std::vector<int> members = particles::neighbours_of_point(body_.particles, grid_, analysis.position, kernel);
    const auto all = members.size();
    std::erase_if(members, [&](int i) { return body_.solid.material[i] != analysis.material; });
    analysis.considered = static_cast<int>(members.size());
    analysis.other_material = static_cast<int>(all - members.size());
    return members;
}

/// Lines 10 and 11.
std::vector<Group> CrackGenerator::divide_members(const std::vector<int>& members, const AnalysedPoint& point,
                                                  const Options& options) const {
    std::vector<Neighbour> neighbours;
    for (const int i : members) neighbours.push_back({body_.particles.position[i] - point.position, body_.particles.volume[i]});
    std::vector<Group> groups;
    for (const std::vector<int>& set : divide(neighbours, {point.normal, point.tangent}, options.grouping, options.groups)) {
        Group& group = groups.emplace_back();
        for (const int k : set) group.members.push_back(members[k]);
    }
    return groups;
}

/// Line 7, for all particles that the gradients need: one call of the source.
void CrackGenerator::gather_displacements(const std::vector<int>& members, const Displacement& displacement, GroupGradient rule) {
    for (const int i : gathered_) place_[i] = -1;
    gathered_.clear();
    const auto gather = [&](int i) {
        if (place_[i] >= 0) return;
        place_[i] = static_cast<int>(gathered_.size());
        gathered_.push_back(i);
    };
    for (const int i : members) gather(i);
    if (rule == GroupGradient::neighbourhoods)
        for (const int i : members)
            for (const int j : body_.strain_operator.neighbours.of(i)) gather(j);
    displacement_.resize(gathered_.size());
    displacement(gathered_, displacement_);
    padded_.resize(gathered_.size());
    for (std::size_t k = 0; k < gathered_.size(); ++k) padded_[k] << displacement_[k], 0;
}

/// Eq. 7 over the whole neighbourhood, most of a contact's time: rows of four lanes, whose last one takes the first number of the next
/// weight and is dropped. The same bits as three lanes.
Eigen::Matrix3d CrackGenerator::whole_gradient(int particle) const {
    const auto neighbours = body_.strain_operator.neighbours.of(particle);
    const auto weights = body_.strain_operator.weights_of(particle);
    const Eigen::Vector4d own = padded_[place_[particle]];
    std::array<Eigen::Vector4d, 3> row{Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()};
    const auto add = [&](int neighbour, const Eigen::Vector4d& weight) {
        const Eigen::Vector4d u = padded_[place_[neighbour]] - own;
        for (int a = 0; a < 3; ++a) row[a] += u[a] * weight;
    };
    for (std::size_t n = 0; n + 1 < neighbours.size(); ++n) add(neighbours[n], Eigen::Map<const Eigen::Vector4d>(weights[n].data()));
    if (!neighbours.empty()) add(neighbours.back(), (Eigen::Vector4d() << weights.back(), 0).finished());
    Eigen::Matrix3d gradient;
    for (int a = 0; a < 3; ++a) gradient.row(a) = row[a].head<3>().transpose();
    return gradient;
}

/// Eq. 7 of one member: over its whole neighbourhood, or over its group only.
Eigen::Matrix3d CrackGenerator::member_gradient(int particle, const std::vector<int>& group, GroupGradient rule) const {
    if (rule == GroupGradient::neighbourhoods) return whole_gradient(particle);
    const auto neighbours = body_.strain_operator.neighbours.of(particle);
    const auto weights = body_.strain_operator.weights_of(particle);
    const Eigen::Vector3d own = displacement_[place_[particle]];
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    for (std::size_t n = 0; n < neighbours.size(); ++n) {
        if (!contains(group, neighbours[n])) continue;
        gradient += (displacement_[place_[neighbours[n]]] - own) * weights[n].transpose();
    }
    return gradient;
}

/// Lines 13 and 14: means over the group, and the SUM of the members' energies (a mean would vanish under refinement).
void CrackGenerator::strain_group(Group& group, GroupGradient rule) const {
    double volume = 0;
    for (const int i : group.members) {
        const Eigen::Matrix3d gradient = member_gradient(i, group.members, rule);
        const material::Voigt strain = elasticity::strain_of(gradient);
        group.gradient += body_.particles.volume[i] * gradient;
        group.energy += elasticity::strain_energy(body_.particles.volume[i], strain, body_.solid.of(i) * strain);
        volume += body_.particles.volume[i];
    }
    group.gradient /= volume;
    group.strain = elasticity::strain_of(group.gradient);
    group.stress = body_.solid.of(group.members.front()) * group.strain;
}

/// Lines 15 and 16.
void CrackGenerator::judge(Group& group, const Brittleness& brittleness, const Options& options) const {
    group.principal = rankine(group.stress, group.strain, options.criterion);
    group.defined = group.principal.gap >= options.defined_gap;
    group.cracked = group.principal.value > (options.criterion == Criterion::stress ? brittleness.strength : brittleness.strain_limit);
}

PointAnalysis CrackGenerator::analyse(const AnalysedPoint& point, int material, const Displacement& displacement, const Options& options) {
    PointAnalysis analysis;
    analysis.position = point.position;
    analysis.nearest = nearest_particle(point.position, material);
    if (analysis.nearest < 0) return analysis;
    analysis.material = body_.solid.material[analysis.nearest];
    const std::vector<int> members = members_of(analysis);
    analysis.groups = divide_members(members, point, options);
    gather_displacements(members, displacement, options.group_gradient);
    for (Group& group : analysis.groups) {
        if (group.members.empty()) {
            ++analysis.empty;
            continue;
        }
        strain_group(group, options.group_gradient);
        judge(group, body_.brittleness[analysis.material], options);
        analysis.below += !group.cracked;
        analysis.undefined += group.cracked && !group.defined;
    }
    return analysis;
}

/// Force (N) with which the group pulls its crack plane open: n.sigma.n times the area of the members' section. A slab of volume V that
/// reaches t to both sides of the plane has a mean distance of t/2 from it and the section V / 2t. Twice that at a free surface: a
/// half penny under F is one half of a penny under 2 F.
double CrackGenerator::opening_force(const Group& group, const Crack& crack) const {
    double volume = 0, moment = 0;
    for (const int i : group.members) {
        volume += body_.particles.volume[i];
        moment += body_.particles.volume[i] * std::abs(crack.normal.dot(body_.particles.position[i] - crack.centre));
    }
    const double tension = crack.normal.dot(material::stress_from_voigt(group.stress) * crack.normal);
    return 2 * std::max(tension, 0.0) * volume * volume / (4 * moment);
}

double CrackGenerator::outer_radius(const Crack& crack, const Group& group, const AnalysedPoint& point, const Options& options) const {
    if (options.outer_radius == OuterRadius::balance) {
        const double modulus = effective_modulus(body_.solid.stiffness[crack.material], crack.normal);
        return wedged_radius(opening_force(group, crack), crack.toughness, modulus, body_.reach);
    }
    const double area = point.contact_area > 0 ? point.contact_area : reference_area_;
    const double weight = contact_weight(area, reference_area_, options.contact_area_exponent);
    return proportional_radius(group.energy, crack.toughness, body_.thickness, weight, body_.reach);
}

/// Lines 16 and 17.
Crack CrackGenerator::crack_of(const PointAnalysis& analysis, int number, const AnalysedPoint& point, const Options& options) const {
    const Group& group = analysis.groups[number];
    Crack crack;
    crack.centre = point.position;
    crack.normal = group.principal.direction;
    crack.principal = group.principal.value;
    crack.gap = group.principal.gap;
    crack.energy = group.energy;
    crack.toughness = body_.brittleness[analysis.material].toughness.energy(crack.normal);
    crack.material = analysis.material;
    crack.group = number;
    crack.members = group.members;
    crack.outer_radius = outer_radius(crack, group, point, options);
    crack.inner_radius = inner_radius(group.energy, analysis.support_radius, options.energy_limit, crack.outer_radius);
    return crack;
}

/// Algorithm 1 at one point: appends the analysis and its cracks to the result.
int CrackGenerator::analyse_into(CrackAnalysis& result, const AnalysedPoint& point, int material, int parent,
                                 const Displacement& displacement, const Options& options) {
    const int number = static_cast<int>(result.points.size());
    result.points.push_back(analyse(point, material, displacement, options));
    const PointAnalysis& analysis = result.points.back();
    for (std::size_t g = 0; g < analysis.groups.size(); ++g) {
        if (!analysis.groups[g].cracked) continue;
        Crack crack = crack_of(analysis, static_cast<int>(g), point, options);
        crack.analysis = number;
        crack.parent = parent;
        result.cracks.push_back(std::move(crack));
    }
    return number;
}

CrackAnalysis CrackGenerator::generate(const AnalysedPoint& point, const Displacement& displacement, const Options& options) {
    CrackAnalysis result;
    analyse_into(result, point, any_material, -1, displacement, options);
    for (int c = 0; c < static_cast<int>(result.cracks.size()); ++c) {  // grows while cracks enter other materials
        const Crack crack = result.cracks[c];
        const std::vector<int> way = materials_on_the_way(result.cracks, c);
        const bool ended = static_cast<int>(way.size()) > options.interface_crossings;
        for (const InterfaceHit& hit : interface_hits(body_.interfaces, crack.material, crack.centre, crack.normal, crack.outer_radius)) {
            if (std::find(way.begin(), way.end(), hit.to) != way.end()) continue;
            const AnalysedPoint beyond{hit.position, hit.normal, point.tangent, point.contact_area};
            const int analysis = ended ? -1 : analyse_into(result, beyond, hit.to, c, displacement, options);
            result.critical.push_back({hit.position, c, crack.material, hit.to, analysis});
        }
    }
    return result;
}

}  // namespace cleave::fracture
