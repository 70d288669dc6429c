#include "solver/rigid/sphere_contacts.hpp"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <new>
#include <utility>

namespace cleave::rigid {
namespace {

using Wrapper = const btCollisionObjectWrapper;

const btCompoundShape* spheres_of(Wrapper* body) {
    return body->getCollisionShape()->getShapeType() == COMPOUND_SHAPE_PROXYTYPE ? static_cast<const btCompoundShape*>(body->getCollisionShape()) : nullptr;
}

const btVector3& centre(const btCompoundShape& spheres, int i) { return spheres.getChildTransform(i).getOrigin(); }
btScalar radius(const btCompoundShape& spheres, int i) { return static_cast<const btSphereShape*>(spheres.getChildShape(i))->getRadius(); }

constexpr std::size_t most_points = MANIFOLD_CACHE_SIZE;  // four

/// Moves the deepest to the front, then each time the one whose nearest chosen one is farthest; ties go to the first found.
void choose(std::vector<SphereContacts::Touch>& touches) {
    for (std::size_t chosen = 0; chosen < most_points; ++chosen) {
        std::size_t best = chosen;
        btScalar most = -SIMD_INFINITY;
        for (std::size_t i = chosen; i < touches.size(); ++i) {
            btScalar worth = chosen == 0 ? -touches[i].distance : SIMD_INFINITY;
            for (std::size_t k = 0; k < chosen; ++k) worth = btMin(worth, touches[i].point.distance2(touches[k].point));
            if (worth > most) most = worth, best = i;
        }
        std::swap(touches[chosen], touches[best]);
    }
}

class SphereAlgorithm final : public btCollisionAlgorithm {
public:
    SphereAlgorithm(const btCollisionAlgorithmConstructionInfo& info, SphereContacts::Scratch& scratch) : btCollisionAlgorithm(info), scratch_(scratch) {}
    ~SphereAlgorithm() override { release(); }

    void processCollision(Wrapper* a, Wrapper* b, const btDispatcherInfo&, btManifoldResult* result) override {
        scratch_.touches.clear();
        if (!spheres_of(a) || !spheres_of(b)) with_plane(a, b);
        else if (spheres_of(a)->getNumChildShapes() <= spheres_of(b)->getNumChildShapes()) with_spheres(a, b, false);
        else with_spheres(b, a, true);
        if (scratch_.touches.size() > most_points) {
            choose(scratch_.touches);
            scratch_.touches.resize(most_points);
        }
        if (!manifold_ && scratch_.touches.empty()) return;
        if (!manifold_) manifold_ = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
        result->setPersistentManifold(manifold_);
        for (const SphereContacts::Touch& touch : scratch_.touches) {
            result->setShapeIdentifiersA(-1, touch.of_a);
            result->setShapeIdentifiersB(-1, touch.of_b);
            result->addContactPoint(touch.normal, touch.point, touch.distance);
        }
        result->refreshContactPoints();
        if (manifold_->getNumContacts() == 0) release();
    }

    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }

    void getAllContactManifolds(btManifoldArray& manifolds) override {
        if (manifold_) manifolds.push_back(manifold_);
    }

private:
    void release() {
        if (manifold_) m_dispatcher->releaseManifold(manifold_);
        manifold_ = nullptr;
    }

    /// Each of the few among the many, in the frame of the many.
    void with_spheres(Wrapper* few, Wrapper* many, bool few_is_b) {
        const btCompoundShape &of_few = *spheres_of(few), &of_many = *spheres_of(many);
        const btTransform& world = many->getWorldTransform();
        const btTransform relative = world.inverseTimes(few->getWorldTransform());
        const btDbvt& tree = *of_many.getDynamicAabbTree();
        for (int i = 0; i < of_few.getNumChildShapes(); ++i) {
            const btVector3 place = relative * centre(of_few, i);
            const btDbvtVolume box = btDbvtVolume::FromCR(place, radius(of_few, i));
            if (!Intersect(tree.m_root->volume, box)) continue;
            scratch_.near.clear();
            tree.collideTV(tree.m_root, box, scratch_);
            for (const int j : scratch_.near) {
                const btVector3 apart = place - centre(of_many, j);
                const btScalar reach = radius(of_few, i) + radius(of_many, j), length = apart.length();
                if (length >= reach) continue;
                const btVector3 to_few = length > SIMD_EPSILON ? btVector3(world.getBasis() * (apart / length)) : btVector3(1, 0, 0);
                if (few_is_b) scratch_.touches.push_back({j, i, -to_few, world * place - to_few * radius(of_few, i), length - reach});
                else scratch_.touches.push_back({i, j, to_few, world * centre(of_many, j) + to_few * radius(of_many, j), length - reach});
            }
        }
    }

    /// As near as Bullet keeps a contact.
    void with_plane(Wrapper* a, Wrapper* b) {
        const bool plane_is_b = spheres_of(a) != nullptr;
        Wrapper* const body = plane_is_b ? a : b;
        const auto& plane = *static_cast<const btStaticPlaneShape*>((plane_is_b ? b : a)->getCollisionShape());
        const btTransform& world = body->getWorldTransform();  // the plane's own is the identity
        const btVector3& up = plane.getPlaneNormal();
        const btVector3 up_here = up * world.getBasis();
        const btScalar height = up.dot(world.getOrigin()) - plane.getPlaneConstant();
        const btCompoundShape& spheres = *spheres_of(body);
        const btScalar margin = body->getCollisionShape()->getContactBreakingThreshold(gContactBreakingThreshold);
        for (int i = 0; i < spheres.getNumChildShapes(); ++i) {
            const btScalar distance = height + up_here.dot(centre(spheres, i)) - radius(spheres, i);
            if (distance >= margin) continue;
            const btVector3 lowest = world * centre(spheres, i) - up * radius(spheres, i);
            if (plane_is_b) scratch_.touches.push_back({i, -1, up, lowest - up * distance, distance});
            else scratch_.touches.push_back({-1, i, -up, lowest, distance});
        }
    }

    SphereContacts::Scratch& scratch_;
    btPersistentManifold* manifold_ = nullptr;
};

/// Whether the boxes of two bodies still meet without the threshold of contacts, by which Bullet widens both.
bool boxes_meet(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
    const btScalar widened = 2 * gContactBreakingThreshold;
    const btVector3 both(widened, widened, widened);
    return TestAabbAgainstAabb2(a.m_aabbMin + both, a.m_aabbMax - both, b.m_aabbMin, b.m_aabbMax);
}

bool is_compound(const btBroadphaseProxy& proxy) {
    return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getCollisionShape()->getShapeType() == COMPOUND_SHAPE_PROXYTYPE;
}

/// Bullet's broad phase pairs bodies within 10 cm, many times the size of a fragment: what is apart is dropped before it costs more.
void look_at_near(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
    if (boxes_meet(*pair.m_pProxy0, *pair.m_pProxy1) || !is_compound(*pair.m_pProxy0) || !is_compound(*pair.m_pProxy1))
        return btCollisionDispatcher::defaultNearCallback(pair, dispatcher, info);
    if (!pair.m_algorithm) return;
    pair.m_algorithm->~btCollisionAlgorithm();
    dispatcher.freeCollisionAlgorithm(pair.m_algorithm);
    pair.m_algorithm = nullptr;
}

}  // namespace

btCollisionAlgorithm* SphereContacts::Maker::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, Wrapper*, Wrapper*) {
    return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(SphereAlgorithm))) SphereAlgorithm(info, scratch);
}

void SphereContacts::register_with(btCollisionDispatcher& dispatcher) {
    for (const auto& [one, other] : {std::pair{COMPOUND_SHAPE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE}, std::pair{COMPOUND_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE},
                                     std::pair{STATIC_PLANE_PROXYTYPE, COMPOUND_SHAPE_PROXYTYPE}})
        dispatcher.registerCollisionCreateFunc(one, other, &maker_);
    dispatcher.setNearCallback(look_at_near);
}

}  // namespace cleave::rigid
