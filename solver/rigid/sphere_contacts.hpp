#pragma once

// Private to this folder: Bullet's headers (see bullet_body.hpp).

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace cleave::rigid {

/// Contacts of compounds of spheres with each other and with a plane, in the place of Bullet's own for compounds. That one keeps a contact cache
/// for every pair of spheres; here a pair of bodies has one, with at most four points at a time: the deepest, then each time the one farthest
/// from those chosen. Points carry the numbers of their spheres. To be registered before bodies come.
class SphereContacts {
public:
    /// Lives as long as the dispatcher.
    void register_with(btCollisionDispatcher& dispatcher);

    /// Where two spheres, or a sphere and the plane, touch.
    struct Touch {
        int of_a, of_b;             ///< spheres of the two bodies as Bullet orders them, -1 for the plane
        btVector3 normal, point;    ///< world: from b to a; on b
        btScalar distance;          ///< negative where they overlap
    };
    /// Shared by all pairs, one at work at a time.
    struct Scratch : btDbvt::ICollide {
        std::vector<int> near;
        std::vector<Touch> touches;
        void Process(const btDbvtNode* leaf) override { near.push_back(leaf->dataAsInt); }
    };

private:
    struct Maker : btCollisionAlgorithmCreateFunc {
        Scratch scratch;
        btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                                                       const btCollisionObjectWrapper* b) override;
    };
    Maker maker_;
};

}  // namespace cleave::rigid
