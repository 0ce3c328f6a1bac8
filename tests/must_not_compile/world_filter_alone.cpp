// expect: World has a collision filter but no broadphase whose pairs it could filter; add one
// SPDX-License-Identifier: BSL-1.0
// A filter of nothing.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Broad {
    using role = roles::Broadphase;
};
struct Narrow {
    using role = roles::Narrowphase;
};
struct React {
    using role = roles::Response;
};
struct Teams {
    using role = roles::Filter;
};

int main() {
#ifdef ANSATZ_MISTAKE
    World<SemiImplicitEuler, Teams>* world = nullptr;
#else
    World<SemiImplicitEuler, Broad, Teams, Narrow, React>* world = nullptr;
#endif
    static_assert(sizeof(*world) > 0);
}
