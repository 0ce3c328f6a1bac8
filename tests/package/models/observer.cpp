// SPDX-License-Identifier: BSL-1.0
// An observer sees what it declared after each step, and changes nothing.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

//! [model]
/// How often bodies have met.
struct Meetings {
    using role = roles::Observer;
    using sees = Types<Contacts>;
    std::size_t begun = 0;

    void observe(const auto& view) {
        for (const auto& contact : view.template table<Contacts>()) begun += contact.begins();
    }
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Plane>{}, Impulse{}, Meetings{}};
    world.add(Plane::ground(), fixed);
    world.add(Sphere{0.5 * metre}, position(metres(0, 2, 0)), mass(1.0 * kilogram), restitution(1.0));
    for (int i = 0; i < 300; ++i) world.step(0.01 * second); // falls 1.5 m in 0.55 s, and again every 1.11 s
    return world.get<Meetings>().begun == 3 ? 0 : 1;
}
