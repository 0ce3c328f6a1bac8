// expect: a ray is cast at a shape of which nothing knows where rays meet it
// SPDX-License-Identifier: BSL-1.0
// A ray is cast in a world with a shape of the user's own that has no ray function.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

/// All points within a distance of a point; written for this case.
struct Blob {
    using shape = Blob;
    static constexpr bool bounded = true;
    static constexpr std::string_view name = "Blob";
    static void parameters(auto&, auto&&) {}
    template <class S> struct In {
        using description = Blob;
        explicit In(const Blob&) {}
        void bounds(const typename S::Position& x, typename S::Position& lower, typename S::Position& upper) const {
            lower = upper = x;
        }
    };
};
template <class S>
bool collide(const Blob::In<S>&, const typename S::Position&, const Blob::In<S>&, const typename S::Position&,
             Touch<S>&) {
    return false;
}
#ifndef ANSATZ_MISTAKE
template <class S> bool ray_hits(const Blob::In<S>&, const RayIn<S>&, const typename S::Position&, RayTouch<S>&) {
    return false;
}
#endif

int main() {
    World world{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Blob>{}, Impulse<>{}};
    world.query().closest(Ray{metres(0, 0, 0), Eigen::Vector3d(1, 0, 0)});
}
