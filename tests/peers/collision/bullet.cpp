// SPDX-License-Identifier: BSL-1.0
// Bullet's btDbvtBroadphase. It keeps its pairs from frame to frame, of boxes in float that are a little wider.

#include "tests/peers/collision/spheres.hpp"
#include "tests/peers/versions.hpp"

#include <btBulletCollisionCommon.h>

static const peers::Version version("Bullet",
                                    std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100));

peers::Broadphase peers::bullet_dbvt(const Spheres& spheres) {
    struct Kept {
        btDbvtBroadphase tree;
        std::vector<btBroadphaseProxy*> proxies;
    };
    auto kept = std::make_shared<Kept>();
    auto corners = [](const Spheres& of, std::size_t i, int frame) {
        const auto x = of.at(i, frame);
        const btScalar r{of.radius[i]};
        const btVector3 centre{btScalar(x[0]), btScalar(x[1]), btScalar(x[2])}, half{r, r, r};
        return std::pair(centre - half, centre + half);
    };
    for (std::size_t i = 0; i < spheres.start.size(); ++i) {
        const auto [low, high] = corners(spheres, i, 0);
        kept->proxies.push_back(kept->tree.createProxy(low, high, SPHERE_SHAPE_PROXYTYPE, nullptr, 1, 1, nullptr));
    }
    return [kept, corners](const Spheres& moved, int frame) {
        for (std::size_t i = 0; i < moved.start.size(); ++i) {
            const auto [low, high] = corners(moved, i, frame);
            kept->tree.setAabb(kept->proxies[i], low, high, nullptr);
        }
        kept->tree.calculateOverlappingPairs(nullptr);
        return std::size_t(kept->tree.getOverlappingPairCache()->getNumOverlappingPairs());
    };
}
