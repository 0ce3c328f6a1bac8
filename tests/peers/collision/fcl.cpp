// SPDX-License-Identifier: BSL-1.0
// FCL's dynamic tree of boxes in an array, updated each frame.

#include "tests/peers/collision/spheres.hpp"
#include "tests/peers/versions.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/sphere.h>

static const peers::Version version("FCL", FCL_VERSION);

peers::Broadphase peers::fcl_tree_array(const Spheres& spheres) {
    struct Kept {
        std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
        fcl::DynamicAABBTreeCollisionManager_Array<double> tree;
    };
    auto kept = std::make_shared<Kept>();
    std::vector<fcl::CollisionObjectd*> all;
    for (std::size_t i = 0; i < spheres.start.size(); ++i) {
        const auto x = spheres.at(i, 0);
        const auto ball = std::make_shared<fcl::Sphered>(spheres.radius[i]);
        kept->objects.push_back(
            std::make_unique<fcl::CollisionObjectd>(ball, fcl::Matrix3d::Identity(), fcl::Vector3d(x[0], x[1], x[2])));
        all.push_back(kept->objects.back().get());
    }
    kept->tree.registerObjects(all);
    kept->tree.setup();
    return [kept](const Spheres& moved, int frame) {
        for (std::size_t i = 0; i < moved.start.size(); ++i) {
            const auto x = moved.at(i, frame);
            kept->objects[i]->setTranslation(fcl::Vector3d(x[0], x[1], x[2]));
            kept->objects[i]->computeAABB();
        }
        kept->tree.update();
        std::size_t pairs = 0;
        kept->tree.collide(&pairs, [](fcl::CollisionObjectd*, fcl::CollisionObjectd*, void* counted) {
            ++*static_cast<std::size_t*>(counted);
            return false;
        });
        return pairs;
    };
}
