// expect: Datum<T> needs a T with a default constructor
// SPDX-License-Identifier: BSL-1.0
// A datum that cannot be made for a body added without one.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Named {
    explicit Named(int);
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Datum<Named>{}};
#else
    World world{SemiImplicitEuler{}, Datum<int>{}};
#endif
}
