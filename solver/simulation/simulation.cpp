#include "solver/simulation/simulation.hpp"

#include "solver/parallel/for_each.hpp"
#include "solver/simulation/stopwatch.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::simulation {
namespace {

constexpr int most_substeps = 64;  ///< times the scene's own, however fast things are

rigid::WorldOptions world_options(const Scene& scene) {
    return {.gravity = scene.gravity, .ground = scene.ground, .friction = scene.friction, .restitution = scene.restitution};
}

std::vector<std::unique_ptr<SceneBody>> make_bodies(const Scene& scene, const std::filesystem::path& meshes) {
    std::vector<std::unique_ptr<SceneBody>> bodies;
    for (const BodySpec& spec : scene.bodies) bodies.push_back(std::make_unique<SceneBody>(spec, scene, meshes));
    return bodies;
}

/// The velocities of the scene file are those of the centre of mass.
rigid::Motion start_of(const BodySpec& spec) {
    return {.rotation = spec.rotation, .translation = spec.position, .velocity = spec.velocity, .angular_velocity = spec.angular_velocity};
}

Track new_track(const Piece& piece, const BodySpec& spec) {
    Track track;
    track.name = spec.name;
    if (piece.fragment > 0) track.name.append(1, '.').append(std::to_string(piece.fragment));
    track.colour = piece.body;
    return track;
}

/// Kinetic energy, J.
double kinetic(const fragments::MassProperties& mass, const rigid::Motion& motion) {
    const Eigen::Vector3d spin = motion.rotation.transpose() * motion.angular_velocity;
    return 0.5 * mass.mass * motion.velocity.squaredNorm() + 0.5 * spin.dot(mass.inertia * spin);
}

}  // namespace

Simulation::Simulation(const Scene& scene, const std::filesystem::path& meshes)
    : scene_(scene), bodies_(make_bodies(scene, meshes)), world_(std::make_unique<rigid::World>(world_options(scene))) {
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body)
        add_pieces(body, bodies_[body]->current_fragments(), start_of(scene.bodies[body]), {});
    for (const Piece& piece : state_.pieces)
        if (!bodies_[piece.body]->is_ball()) state_.watch.boundary_at_start += piece.boundary_particles;
    record_frame();
}

Simulation::Simulation(const Scene& scene, const std::filesystem::path& meshes, State state)
    : scene_(scene), bodies_(make_bodies(scene, meshes)),
      world_(rigid::World::restored(world_options(scene), state.descriptions, state.world)), state_(std::move(state)) {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (!bodies_[i]->is_ball()) bodies_[i]->repeat(state_.bodies.at(i).history, state_.bodies.at(i).results);
    state_.bodies.clear();  // kept by the bodies and the world from here on
    state_.descriptions.clear();
}

State Simulation::save() {
    world_->rebuild();
    State saved = state_;
    saved.world = world_->save();
    for (const int id : world_->ids()) saved.descriptions.push_back(world_->description(id));
    for (const auto& body : bodies_)
        saved.bodies.push_back(body->is_ball() ? BodyState{} : BodyState{body->history(), body->results()});
    return saved;
}

rigid::Motion Simulation::motion(const Piece& piece) const { return piece.rigid < 0 ? piece.motion : world_->motion(piece.rigid); }

/// Forms are found in parallel, numbers given in order.
void Simulation::add_pieces(int body, const std::vector<int>& fragments, const rigid::Motion& motion, const FieldCentre& centre) {
    std::vector<FragmentForm> forms(fragments.size());
    parallel::for_each(forms.size(), [&](std::size_t i) { forms[i] = bodies_[body]->form(fragments[i]); });
    std::vector<int> siblings;
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        FragmentForm& form = forms[i];
        Piece piece{.body = body, .fragment = fragments[i], .boundary_particles = form.boundary_particles, .held = form.rigid.held, .mass = form.mass,
                    .motion = motion, .shape = std::move(form.shape)};
        if (centre) piece.motion.velocity = motion.velocity_at(motion.at(form.mass.centre), motion.at(*centre));
        const bool debris = !piece.held && !bodies_[body]->is_ball() && form.mass.mass < scene_.debris_below;
        if (!debris) siblings.push_back(piece.rigid = world_->add(form.rigid, piece.motion));
        state_.pieces.push_back(std::move(piece));
    }
    world_->ignore_until_separated(siblings);
    ++topology_;
}

/// As many that nothing moves farther than `travel` in one.
int Simulation::substeps_of_frame() const {
    if (!std::isfinite(scene_.travel)) return scene_.substeps;
    double fastest = 0;
    for (const Piece& piece : state_.pieces)
        if (piece.rigid >= 0) fastest = std::max(fastest, motion(piece).velocity.norm());
    fastest += scene_.gravity.norm() / scene_.frame_rate;
    const double wanted = std::ceil(fastest / (scene_.frame_rate * scene_.travel));
    return static_cast<int>(std::clamp(wanted, 1.0 * scene_.substeps, 1.0 * most_substeps * scene_.substeps));
}

bool Simulation::advance(const std::function<bool()>& stop) {
    const int substeps = substeps_of_frame();
    const double dt = 1 / (scene_.frame_rate * substeps);
    ++state_.frame;
    for (int i = 0; i < substeps; ++i) {
        if (stop && stop()) return false;
        step(dt);
    }
    {
        const Stopwatch watch(clock_.dynamics);
        world_->release_separated();
    }
    record_frame();
    return true;
}

void Simulation::step(double dt) {
    const std::vector<double> before = mechanical_energies();
    {
        const Stopwatch watch(clock_.dynamics);
        world_->step(dt);
        move_debris(dt);
    }
    ++state_.watch.steps;
    state_.watch.energy_scale = std::max(state_.watch.energy_scale, kinetic_energy());
    watch_energy(before);
    for (const rigid::Contact& contact : world_->contacts()) state_.watch.penetration = std::max(state_.watch.penetration, -contact.distance);
    // A fracture renumbers the pieces: each is looked up again by its rigid body.
    std::vector<std::pair<int, Hit>> waiting;
    for (const Hit& hit : hits()) waiting.emplace_back(state_.pieces[hit.piece].rigid, hit);
    for (auto& [rigid, hit] : waiting) {
        hit.piece = piece_of(rigid);
        fracture(hit);
    }
}

/// Debris flies on without colliding, until it reaches the ground and lies there.
void Simulation::move_debris(double dt) {
    for (Piece& piece : state_.pieces) {
        if (piece.rigid >= 0 || piece.lies) continue;
        rigid::Motion& motion = piece.motion;
        const Eigen::Vector3d centre = motion.at(piece.mass.centre);
        const Eigen::Vector3d velocity = motion.velocity + dt * scene_.gravity;
        const double angle = dt * motion.angular_velocity.norm();
        const Eigen::Matrix3d turn =
            angle > 0 ? Eigen::AngleAxisd(angle, motion.angular_velocity.normalized()).toRotationMatrix() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
        motion.rotation = turn * motion.rotation;
        motion.velocity = velocity;
        motion.translation = centre + dt * velocity - motion.rotation * piece.mass.centre;
        if (motion.at(piece.mass.centre)[2] > scene_.ground) continue;
        motion.translation[2] += scene_.ground - motion.at(piece.mass.centre)[2];
        motion.velocity.setZero();
        motion.angular_velocity.setZero();
        piece.lies = true;
    }
}

void Simulation::record_frame() {
    for (Piece& piece : state_.pieces) {
        if (piece.track < 0) {
            piece.track = static_cast<std::int32_t>(state_.tracks.size());
            state_.tracks.push_back(new_track(piece, scene_.bodies[piece.body]));
            state_.tracks.back().shape = std::move(piece.shape);
            piece.shape = {};
        }
        const rigid::Motion now = motion(piece);
        state_.tracks[piece.track].add(key_of(state_.frame, now.rotation, now.translation));
    }
}

double Simulation::kinetic_energy() const {
    double sum = 0;
    for (const Piece& piece : state_.pieces)
        if (!piece.held) sum += kinetic(piece.mass, motion(piece));
    return sum;
}

/// Of each piece, J; zero for those that are held, and for debris, which loses energy on the ground without contacts.
std::vector<double> Simulation::mechanical_energies() const {
    std::vector<double> energies;
    for (const Piece& piece : state_.pieces) {
        energies.push_back(0);
        if (piece.held || piece.rigid < 0) continue;
        const rigid::Motion now = motion(piece);
        energies.back() = kinetic(piece.mass, now) - piece.mass.mass * scene_.gravity.dot(now.at(piece.mass.centre));
    }
    return energies;
}

/// Pieces that nothing touched in the last step must not have gained energy. (A point without a normal impulse in the end may have had friction
/// while the solver went on.)
void Simulation::watch_energy(const std::vector<double>& before) {
    std::vector<int> touched;
    for (const rigid::Contact& contact : world_->contacts()) touched.insert(touched.end(), {contact.a, contact.b});
    std::sort(touched.begin(), touched.end());
    const std::vector<double> after = mechanical_energies();
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Piece& piece = state_.pieces[i];
        if (piece.held || piece.rigid < 0 || std::binary_search(touched.begin(), touched.end(), piece.rigid)) continue;
        ++state_.watch.free_steps;
        state_.watch.energy_growth = std::max(state_.watch.energy_growth, after[i] - before[i]);
    }
}

int Simulation::piece_of(int rigid) const {
    for (std::size_t i = 0; i < state_.pieces.size(); ++i)
        if (state_.pieces[i].rigid == rigid) return static_cast<int>(i);
    return -1;
}

}  // namespace cleave::simulation
