#pragma once

#include <Eigen/Core>

#include <compare>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace cleave::rigid {

/// A collision sphere in a body's rest coordinates (a boundary particle), m.
struct Sphere {
    Eigen::Vector3d centre;
    double radius;
};

/// What a body is. Everything in its rest coordinates, in which it was meshed.
struct BodyDescription {
    double mass = 0;                                     ///< kg
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< m, of mass
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< kg m^2 about the centre of mass
    std::vector<Sphere> spheres;                         ///< its shape: a compound of spheres,
    std::vector<Eigen::Vector3d> hull;                   ///< or, where there are none, the convex hull of these points, m
    bool held = false;                                   ///< does not move, whatever hits it
};

/// Where a body is and how it moves: x = rotation x0 + translation, x0 in rest coordinates.
struct Motion {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s, of the centre of mass
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, in world axes

    Eigen::Vector3d at(const Eigen::Vector3d& rest) const { return rotation * rest + translation; }
    /// m/s, of the body's point at `world`, for a body whose centre of mass is at `centre` (world).
    Eigen::Vector3d velocity_at(const Eigen::Vector3d& world, const Eigen::Vector3d& centre) const {
        return velocity + angular_velocity.cross(world - centre);
    }
};

inline constexpr int ground_body = -1;

/// Two bodies touch, in the last step; compounds of spheres at four points at most. Ordered: a < b, except that the ground is always b.
struct Contact {
    int a = 0, b = 0;                      ///< ids, b may be ground_body
    int sphere_a = -1, sphere_b = -1;      ///< which spheres; -1 for hulls and the ground
    Eigen::Vector3d point;                 ///< m, world, half-way between the two surfaces
    Eigen::Vector3d normal;                ///< unit, from b to a
    double distance = 0;                   ///< m, negative where they overlap
    double impulse = 0;                    ///< N s, along the normal, in this step
    double approach_speed = 0;             ///< m/s, of the two points towards each other, before the step; may be negative
};

struct WorldOptions {
    Eigen::Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    double ground = -std::numeric_limits<double>::infinity();  ///< m, height of the ground; -infinity: none
    double friction = 0.5;
    double restitution = 0.1;
};

/// The moving state of one body, bit for bit: what a checkpoint stores.
struct BodyState {
    int id = 0;
    Eigen::Matrix3d basis = Eigen::Matrix3d::Identity();  ///< principal axes, world
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< centre of mass, world, m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angular_velocity = Eigen::Vector3d::Zero();
    double idle_time = 0;   ///< s, since it has come to rest
    int activation = 1;     ///< 1 moves, 2 sleeps, 3 wants to sleep
};

struct WorldState {
    int next_id = 0;
    std::vector<BodyState> bodies;                   ///< ascending ids
    std::vector<std::pair<int, int>> ignored_pairs;  ///< siblings that have not yet separated, ascending
};

/// Rigid bodies under gravity on a plane ground (Bullet, double precision). No damping: what moves freely keeps its momentum.
/// Penetration is mended without adding energy (split impulses). Deterministic: the same calls give the same bits; a contact cache
/// makes the future depend on the past, therefore `rebuild`.
class World {
public:
    explicit World(const WorldOptions& options);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Adds a body and returns its id: 0, 1, ..., never used again. Throws std::invalid_argument for a body without shape, with a
    /// mass or a moment of inertia that is not positive.
    int add(const BodyDescription& body, const Motion& motion);
    void remove(int id);

    std::vector<int> ids() const;
    const BodyDescription& description(int id) const;
    Motion motion(int id) const;
    bool sleeps(int id) const;

    /// Fragments of one body are born with overlapping spheres: contacts of each pair among `ids` whose spheres overlap are ignored until they
    /// no longer do (looked at by release_separated). Bodies given by hulls: by the boxes around them.
    void ignore_until_separated(const std::vector<int>& ids);
    /// Pairs that still are ignored.
    const std::vector<std::pair<int, int>>& ignored_pairs() const;
    /// Ends the ignoring for pairs that have come apart.
    void release_separated();

    /// Moves everything on by `dt` (s).
    void step(double dt);
    /// Of the last step, sorted by (a, b, sphere_a, sphere_b).
    const std::vector<Contact>& contacts() const;

    WorldState save() const;
    /// Forgets everything but the bodies' descriptions and their states: contact caches, order of pairs. The same as a world that
    /// was restored from save().
    void rebuild();
    /// A world as `save` saw it. `bodies`: the description of each body, in the order of state.bodies.
    static std::unique_ptr<World> restored(const WorldOptions& options, const std::vector<BodyDescription>& bodies, const WorldState& state);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

/// Whether two sphere compounds overlap. The plain search within the common part of their boxes.
bool overlap(const std::vector<Sphere>& a, const Motion& motion_a, const std::vector<Sphere>& b, const Motion& motion_b);

}  // namespace cleave::rigid
