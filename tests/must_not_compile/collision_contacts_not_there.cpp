// expect: a policy sees the contacts of a world whose bodies do not collide
// SPDX-License-Identifier: BSL-1.0
// Contacts are a table of worlds that collide.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Counter {
    using role = roles::Observer;
    using sees = Types<Contacts>;
    void observe(const auto& view) { seen = view.template table<Contacts>().size(); }
    std::size_t seen = 0;
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Counter{}};
#else
    World world{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Sphere>{}, Projection{}, Counter{}};
#endif
    world.step(0.1 * second);
}
