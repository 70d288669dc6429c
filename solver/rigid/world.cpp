#include "solver/rigid/world.hpp"

#include "solver/rigid/bullet_body.hpp"
#include "solver/rigid/sphere_contacts.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace cleave::rigid {
namespace {

using Pair = std::pair<int, int>;

/// Asks for each pair of bodies whether it may collide.
class Dispatcher : public btCollisionDispatcher {
public:
    Dispatcher(btCollisionConfiguration* configuration, const std::vector<Pair>& ignored)
        : btCollisionDispatcher(configuration), ignored_(ignored) {}
    bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override {
        if (!btCollisionDispatcher::needsCollision(a, b)) return false;
        const Pair pair = std::minmax(a->getUserIndex(), b->getUserIndex());
        return !std::binary_search(ignored_.begin(), ignored_.end(), pair);
    }

private:
    const std::vector<Pair>& ignored_;
};

/// Bullet's own objects, in the order in which they must die (last first).
struct Engine {
    explicit Engine(const WorldOptions& options, const std::vector<Pair>& ignored)
        : dispatcher(&configuration, ignored), world(&dispatcher, &broadphase, &solver, &configuration) {
        sphere_contacts.register_with(dispatcher);
        world.setGravity(to_bullet(options.gravity));
        world.getDispatchInfo().m_deterministicOverlappingPairs = true;
        // Penetration is mended by pushes that leave the velocities alone; Bullet's default does so only below 4 cm.
        world.getSolverInfo().m_splitImpulse = 1;
        world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
    }
    btDefaultCollisionConfiguration configuration;
    SphereContacts sphere_contacts;
    Dispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world;
};

/// The velocity field of a body before a step.
struct Before {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero(), angular_velocity = Eigen::Vector3d::Zero();
    Eigen::Vector3d at(const Eigen::Vector3d& x) const { return velocity + angular_velocity.cross(x - centre); }
};

Eigen::AlignedBox3d box_of(const BulletBody& body) {
    btVector3 low, high;
    body.body().getCollisionShape()->getAabb(body.body().getWorldTransform(), low, high);
    return {from_bullet(low), from_bullet(high)};
}

bool still_overlap(const BulletBody& a, const BulletBody& b) {
    if (!box_of(a).intersects(box_of(b))) return false;
    const auto &spheres_a = a.description().spheres, &spheres_b = b.description().spheres;
    if (spheres_a.empty() || spheres_b.empty()) return true;
    return overlap(spheres_a, a.motion(), spheres_b, b.motion());
}

}  // namespace

class World::Impl {
public:
    explicit Impl(const WorldOptions& options) : options_(options) { start(); }
    ~Impl() { stop(); }

    int add(const BodyDescription& description, const Motion& motion) {
        auto body = std::make_unique<BulletBody>(next_id_, description, options_);
        body->set(motion);
        insert(std::move(body));
        return next_id_++;
    }

    void remove(int id) {
        engine_->world.removeRigidBody(&at(id).body());
        bodies_.erase(id);
        std::erase_if(ignored_, [&](const Pair& pair) { return pair.first == id || pair.second == id; });
    }

    const BulletBody& at(int id) const { return *bodies_.at(id); }
    const std::map<int, std::unique_ptr<BulletBody>>& bodies() const { return bodies_; }
    const std::vector<Pair>& ignored() const { return ignored_; }
    const std::vector<Contact>& contacts() const { return contacts_; }

    void ignore(const std::vector<int>& ids) {
        for (std::size_t i = 0; i < ids.size(); ++i)
            for (std::size_t j = i + 1; j < ids.size(); ++j)
                if (still_overlap(at(ids[i]), at(ids[j]))) ignored_.push_back(std::minmax(ids[i], ids[j]));
        std::sort(ignored_.begin(), ignored_.end());
        ignored_.erase(std::unique(ignored_.begin(), ignored_.end()), ignored_.end());
    }

    void release() {
        std::erase_if(ignored_, [&](const Pair& pair) { return !still_overlap(at(pair.first), at(pair.second)); });
    }

    void step(double dt) {
        std::map<int, Before> before;
        for (const auto& [id, body] : bodies_) {
            const BodyState state = body->state();
            before[id] = {state.origin, state.velocity, state.angular_velocity};
        }
        engine_->world.stepSimulation(dt, 0);
        contacts_.clear();
        for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i) collect(*engine_->dispatcher.getManifoldByIndexInternal(i), before);
        const auto key = [](const Contact& c) { return std::make_tuple(c.a, c.b, c.sphere_a, c.sphere_b); };
        std::stable_sort(contacts_.begin(), contacts_.end(), [&](const Contact& x, const Contact& y) { return key(x) < key(y); });
    }

    WorldState save() const {
        WorldState state{.next_id = next_id_, .bodies = {}, .ignored_pairs = ignored_};
        for (const auto& [id, body] : bodies_) state.bodies.push_back(body->state());
        return state;
    }

    void restore(const std::vector<BodyDescription>& descriptions, const WorldState& state) {
        stop();
        bodies_.clear();
        contacts_.clear();
        start();
        ignored_ = state.ignored_pairs;
        next_id_ = state.next_id;
        for (std::size_t i = 0; i < state.bodies.size(); ++i) {
            auto body = std::make_unique<BulletBody>(state.bodies[i].id, descriptions.at(i), options_);
            body->set(state.bodies[i]);
            insert(std::move(body));
        }
    }

private:
    void start() {
        engine_ = std::make_unique<Engine>(options_, ignored_);
        if (!std::isfinite(options_.ground)) return;
        ground_shape_ = std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), options_.ground);
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, ground_shape_.get());
        info.m_friction = pair_root(options_.friction);
        info.m_restitution = pair_root(options_.restitution);
        ground_ = std::make_unique<btRigidBody>(info);
        ground_->setUserIndex(ground_body);
        engine_->world.addRigidBody(ground_.get());
    }

    void stop() {
        for (const auto& [id, body] : bodies_) engine_->world.removeRigidBody(&body->body());
        if (ground_) engine_->world.removeRigidBody(ground_.get());
        engine_.reset();
        ground_.reset();
    }

    void insert(std::unique_ptr<BulletBody> body) {
        engine_->world.addRigidBody(&body->body());
        bodies_[body->id()] = std::move(body);
    }

    void collect(const btPersistentManifold& manifold, const std::map<int, Before>& before) {
        const int id0 = manifold.getBody0()->getUserIndex(), id1 = manifold.getBody1()->getUserIndex();
        const bool keep = id1 == ground_body || (id0 != ground_body && id0 < id1);
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold.getContactPoint(p);
            Contact contact;
            contact.a = keep ? id0 : id1;
            contact.b = keep ? id1 : id0;
            contact.sphere_a = sphere_of(contact.a, keep ? point.m_index0 : point.m_index1);
            contact.sphere_b = sphere_of(contact.b, keep ? point.m_index1 : point.m_index0);
            contact.point = 0.5 * from_bullet(point.getPositionWorldOnA() + point.getPositionWorldOnB());
            contact.normal = (keep ? 1.0 : -1.0) * from_bullet(point.m_normalWorldOnB);  // of Bullet's B towards its A
            contact.distance = point.getDistance();
            contact.impulse = point.getAppliedImpulse();
            const auto velocity = [&](int id) { return id == ground_body ? Eigen::Vector3d(0, 0, 0) : before.at(id).at(contact.point); };
            contact.approach_speed = -(velocity(contact.a) - velocity(contact.b)).dot(contact.normal);
            contacts_.push_back(contact);
        }
    }

    int sphere_of(int id, int child) const { return id == ground_body || at(id).description().spheres.empty() ? -1 : child; }

    WorldOptions options_;
    std::map<int, std::unique_ptr<BulletBody>> bodies_;
    std::vector<Pair> ignored_;
    std::vector<Contact> contacts_;
    int next_id_ = 0;
    std::unique_ptr<Engine> engine_;
    std::unique_ptr<btStaticPlaneShape> ground_shape_;
    std::unique_ptr<btRigidBody> ground_;
};

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
int World::add(const BodyDescription& body, const Motion& motion) { return impl_->add(body, motion); }
void World::remove(int id) { impl_->remove(id); }
const BodyDescription& World::description(int id) const { return impl_->at(id).description(); }
Motion World::motion(int id) const { return impl_->at(id).motion(); }
bool World::sleeps(int id) const { return impl_->at(id).state().activation == ISLAND_SLEEPING; }
void World::ignore_until_separated(const std::vector<int>& ids) { impl_->ignore(ids); }
const std::vector<std::pair<int, int>>& World::ignored_pairs() const { return impl_->ignored(); }
void World::release_separated() { impl_->release(); }
void World::step(double dt) { impl_->step(dt); }
const std::vector<Contact>& World::contacts() const { return impl_->contacts(); }
WorldState World::save() const { return impl_->save(); }

std::vector<int> World::ids() const {
    std::vector<int> ids;
    for (const auto& [id, body] : impl_->bodies()) ids.push_back(id);
    return ids;
}

void World::rebuild() {
    const WorldState state = save();
    std::vector<BodyDescription> descriptions;
    for (const auto& [id, body] : impl_->bodies()) descriptions.push_back(body->description());
    impl_->restore(descriptions, state);
}

std::unique_ptr<World> World::restored(const WorldOptions& options, const std::vector<BodyDescription>& bodies, const WorldState& state) {
    auto world = std::make_unique<World>(options);
    world->impl_->restore(bodies, state);
    return world;
}

}  // namespace cleave::rigid
