// expect: World has a response but no narrowphase to find contacts; add one
// SPDX-License-Identifier: BSL-1.0
// Nobody finds contacts.

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
    World<SemiImplicitEuler, React>* world = nullptr;
#else
    World<SemiImplicitEuler, Broad, Teams, Narrow, React>* world = nullptr;
#endif
    static_assert(sizeof(*world) > 0);
}
