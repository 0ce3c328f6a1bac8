// expect: a policy that decides how a step is taken, with a wrong signature
// SPDX-License-Identifier: BSL-1.0
// A step control that answers with a length of time instead of a number of substeps.

#include <ansatz/world.hpp>

using namespace ansatz;

struct Halves {
    using role = roles::StepControl;
    struct Kept {};
#ifdef ANSATZ_MISTAKE
    Quantity<unit::Time> parts(const auto&, const Quantity<unit::Time>& dt, Kept&) const { return 0.5 * dt; }
#else
    int parts(const auto&, const Quantity<unit::Time>&, Kept&) const { return 2; }
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Halves{}};
    world.add();
    world.step(1.0 / 60 * second);
}
