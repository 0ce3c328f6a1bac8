// expect: World has more than one collision filter; keep one
// SPDX-License-Identifier: BSL-1.0
// Two policies in a role for one.

#include <ansatz/world.hpp>

using namespace ansatz;

#ifdef ANSATZ_MISTAKE
struct Another {
    using role = roles::Filter;
};
#else
struct Another {
    using role = roles::Observer;
};
#endif

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

World<SemiImplicitEuler, Broad, Teams, Narrow, React, Another>* world = nullptr;
static_assert(sizeof(*world) > 0);
int main() {}
