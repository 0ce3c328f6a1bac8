// expect: a response at Level::substeps with a wrong signature; its In<S> needs parts(), solve(contacts, h)
// SPDX-License-Identifier: BSL-1.0
// The number of substeps is a whole number.

#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Solve : SoftSubsteps<> {
    template <class S> struct In : SoftSubsteps<>::In<S> {
        explicit In(const Solve& policy) : SoftSubsteps<>::In<S>(policy) {}
#ifdef ANSATZ_MISTAKE
        double parts() const { return 4; }
#else
        int parts() const { return 4; }
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Gravity{}, BoundingBoxes{}, Narrowphase<Sphere>{}, Solve{}};
    world.step(0.01 * second);
}
