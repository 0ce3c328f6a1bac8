// expect: the Datum<T> of the new one is a copy, which this T does not allow
// SPDX-License-Identifier: BSL-1.0
// A vertex that splits has its datum twice.

#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/world.hpp>

#include <memory>

using namespace ansatz;

int main() {
#ifdef ANSATZ_MISTAKE
    using Mine = std::unique_ptr<int>;
#else
    using Mine = std::shared_ptr<int>;
#endif
    World world{SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 10}, Datum<Mine>{}};
    world.step(0.1 * second);
}
