// From a contact to new pieces: the half of Simulation that breaks things.

#include "solver/contact/contact_load.hpp"
#include "solver/simulation/simulation.hpp"
#include "solver/simulation/stopwatch.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cleave::simulation {
namespace {

constexpr double flattest = 1e-2;  ///< 1/m: two flat surfaces touch like a ball of 100 m on a plane

/// Momentum about the world's origin.
struct Momentum {
    double mass = 0;
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
    void add(const fragments::MassProperties& mass_properties, const rigid::Motion& motion) {
        const Eigen::Vector3d centre = motion.at(mass_properties.centre);
        const Eigen::Matrix3d inertia = motion.rotation * mass_properties.inertia * motion.rotation.transpose();
        mass += mass_properties.mass;
        linear += mass_properties.mass * motion.velocity;
        angular += mass_properties.mass * centre.cross(motion.velocity) + inertia * motion.angular_velocity;
    }
};

}  // namespace

/// 1/m, of the surface where a contact touches it: the scene's word, or the boundary particle's. Zero for the ground.
double Simulation::curvature(int rigid, int sphere) const {
    if (rigid == rigid::ground_body) return 0;
    const BodySpec& spec = bodies_[state_.pieces[piece_of(rigid)].body]->spec();
    if (spec.contact_radius > 0) return 1 / spec.contact_radius;
    return sphere < 0 ? 0 : 1 / world_->description(rigid).spheres[sphere].radius;
}

/// 1/kg, how easily a body's point gives way in a direction: 1/m + (r x n) . I^-1 (r x n). Zero for what does not move.
double Simulation::inverse_mass(int rigid, const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const {
    if (rigid == rigid::ground_body) return 0;
    const Piece& piece = state_.pieces[piece_of(rigid)];
    if (piece.held) return 0;
    const rigid::Motion now = motion(piece);
    const Eigen::Vector3d arm = now.rotation.transpose() * (point - now.at(piece.mass.centre)).cross(direction);
    return 1 / piece.mass.mass + arm.dot(piece.mass.inertia.inverse() * arm);
}

Simulation::Hit Simulation::hit_of(const rigid::Contact& contact, bool first, int piece) const {
    Hit hit{.piece = piece, .point = contact.point, .push = first ? contact.normal : Eigen::Vector3d(-contact.normal)};
    hit.impulse = contact.impulse;
    hit.speed = contact.approach_speed;
    hit.effective_mass = 1 / (inverse_mass(contact.a, contact.point, contact.normal) + inverse_mass(contact.b, contact.point, contact.normal));
    hit.curvature = std::max(flattest, curvature(contact.a, contact.sphere_a) + curvature(contact.b, contact.sphere_b));
    const int other = first ? contact.b : contact.a;
    hit.other_modulus = std::numeric_limits<double>::infinity();
    if (other != rigid::ground_body) {
        const Piece& striker = state_.pieces[piece_of(other)];
        const rigid::Motion now = motion(striker);
        hit.other_modulus = bodies_[striker.body]->indentation_modulus(now.rotation.transpose() * (contact.point - now.translation),
                                                                      now.rotation.transpose() * -hit.push);
    }
    return hit;
}

/// Of each breakable piece the contact with the largest impulse, if it is fast enough; in the order of the pieces.
std::vector<Simulation::Hit> Simulation::hits() const {
    std::map<int, std::pair<const rigid::Contact*, bool>> strongest;
    for (const rigid::Contact& contact : world_->contacts()) {
        if (!(contact.impulse > 0) || contact.approach_speed < scene_.slowest_impact) continue;
        for (const bool first : {true, false}) {
            const int rigid = first ? contact.a : contact.b;
            if (rigid == rigid::ground_body) continue;
            const int piece = piece_of(rigid);
            if (!bodies_[state_.pieces[piece].body]->spec().breakable) continue;
            const auto [place, fresh] = strongest.try_emplace(piece, &contact, first);
            if (!fresh && contact.impulse > place->second.first->impulse) place->second = {&contact, first};
        }
    }
    std::vector<Hit> hits;
    for (const auto& [piece, contact] : strongest) hits.push_back(hit_of(*contact.first, contact.second, piece));
    return hits;
}

void Simulation::fracture(const Hit& hit) {
    const Piece piece = state_.pieces[hit.piece];
    SceneBody& body = *bodies_[piece.body];
    fracture::CrackAnalysis found;
    ImpactRecord record;
    record.frame = state_.frame;
    record.body = piece.body;
    record.fragment = piece.fragment;
    record.speed = hit.speed;
    record.effective_mass = hit.effective_mass;
    {
        const Stopwatch watch(clock_.analysis);
        const rigid::Motion now = motion(piece);
        const contact::ContactLoad load = body.peak_load({.point = now.rotation.transpose() * (hit.point - now.translation),
                                                          .inward = (now.rotation.transpose() * hit.push).normalized(),
                                                          .effective_mass = hit.effective_mass,
                                                          .curvature = hit.curvature,
                                                          .other_modulus = hit.other_modulus,
                                                          .speed = hit.speed});
        record.force = load.force.norm();
        record.contact_radius = load.radius;
        record.point = load.point;
        record.inward = load.inward;
        found = body.analyse(load);
    }
    for (const fracture::PointAnalysis& point : found.points)
        for (const fracture::Group& group : point.groups) record.principals.push_back(group.principal.value);
    for (const fracture::Crack& crack : found.cracks) {
        record.normals.push_back(crack.normal);
        record.outer_radii.push_back(crack.outer_radius);
        record.inner_radii.push_back(crack.inner_radius);
    }
    const SceneBody::Opened opened = body.open_cracks(found.cracks, piece.fragment, clock_);
    record.fragments = static_cast<std::int32_t>(opened.fragments.size());
    state_.impacts.push_back(record);
    if (!opened.changed) return;
    const Stopwatch watch(clock_.fragments);
    ++state_.watch.fractures;
    ++clock_.fractures;
    replace(hit.piece, opened.fragments);
}

/// A piece gives way to the fragments it became. Its velocity field is theirs: v_f = v + w x (c_f - c), w_f = w.
void Simulation::replace(int index, const std::vector<int>& fragments) {
    const Piece old = state_.pieces[index];
    const rigid::Motion now = motion(old);
    if (old.track >= 0) state_.tracks[old.track].end = state_.frame;
    world_->remove(old.rigid);
    state_.pieces.erase(state_.pieces.begin() + index);
    const std::size_t first_new = state_.pieces.size();
    add_pieces(old.body, fragments, now, old.mass.centre);
    if (!old.held) watch_momentum(old, now, first_new);
}

/// What the fragments together lack of the old piece's mass and momenta, against the momenta it would have if all moved with its
/// fastest point, so that a piece at rest has a scale too small to matter.
void Simulation::watch_momentum(const Piece& before, const rigid::Motion& before_motion, std::size_t first_new) {
    Momentum old, made;
    old.add(before.mass, before_motion);
    double size = 0;
    for (std::size_t i = first_new; i < state_.pieces.size(); ++i) {
        const Piece& piece = state_.pieces[i];
        if (piece.held) return;  // what holds it takes its momentum
        made.add(piece.mass, motion(piece));
        size = std::max(size, (motion(piece).at(piece.mass.centre) - before_motion.at(before.mass.centre)).norm());
    }
    const double arm = size + before_motion.at(before.mass.centre).norm();
    const double speed = before_motion.velocity.norm() + before_motion.angular_velocity.norm() * size;
    Watch& watch = state_.watch;
    watch.mass_error = std::max(watch.mass_error, std::abs(made.mass - old.mass) / old.mass);
    if (!(speed > 0)) return;
    watch.momentum_error = std::max(watch.momentum_error, (made.linear - old.linear).norm() / (old.mass * speed));
    if (arm > 0) watch.angular_momentum_error = std::max(watch.angular_momentum_error, (made.angular - old.angular).norm() / (old.mass * speed * arm));
}

}  // namespace cleave::simulation
