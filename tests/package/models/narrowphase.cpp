// SPDX-License-Identifier: BSL-1.0
// A narrowphase may be wrapped: everything is asked of the inner one, and one thing is said otherwise.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

//! [model]
/// What is less deep than this is no contact.
template <class N> struct Tolerant : N {
    static constexpr std::string_view name = "Tolerant";
    template <class S>
    static bool collide_bodies(const auto& shapes, std::uint32_t a, const typename S::Position& xa, std::uint32_t b,
                               const typename S::Position& xb, Touch<S>& touch) {
        return N::template collide_bodies<S>(shapes, a, xa, b, xb, touch) && touch.depth.value() > 0.1;
    }
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, AllPairs{}, Tolerant<Narrowphase<Sphere>>{}, Projection{}};
    world.add(Sphere{0.5 * metre}, fixed);
    const auto near = world.add(Sphere{0.5 * metre}, position(metres(0.95, 0, 0)), mass(1.0 * kilogram));
    const auto deep = world.add(Sphere{0.5 * metre}, position(metres(-0.5, 0, 0)), mass(1.0 * kilogram));
    world.step(0.01 * second);
    return world.position(near) == metres(0.95, 0, 0) && world.position(deep).value()[0] < -0.85 ? 0 : 1;
}
