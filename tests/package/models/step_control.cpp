// SPDX-License-Identifier: BSL-1.0
// A step control decides into how many substeps a step is divided.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// No substep is longer than this.
struct AtMost {
    using role = roles::StepControl;
    struct Kept {};
    Parameter<unit::Time> longest = 0.01 * second;
    int parts(const auto&, const Quantity<unit::Time>& dt, Kept&) const {
        return int(std::ceil(dt.value() / longest.value() - 1e-9));
    }
};
//! [model]

int main() {
    World long_steps{SemiImplicitEuler{}, Gravity{}, AtMost{}};
    World short_steps{SemiImplicitEuler{}, Gravity{}};
    const auto a = long_steps.add(), b = short_steps.add();
    long_steps.step(0.04 * second);
    for (int i = 0; i < 4; ++i) short_steps.step(0.01 * second);
    const auto apart = norm(long_steps.position(a) - short_steps.position(b)).value();
    return apart < 1e-15 ? 0 : 1;
}
