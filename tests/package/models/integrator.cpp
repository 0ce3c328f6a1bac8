// SPDX-License-Identifier: BSL-1.0
// An integrator is written for one body, stage by stage.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
/// Heun's method: the mean of the slopes at both ends of the step.
struct Heun {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    using scratch =
        Columns<ScratchVector<unit::Length>, ScratchVector<unit::Velocity>, ScratchVector<unit::Velocity, 1>>;
    static constexpr int stages = 2;
    static constexpr double nodes[] = {0, 1};
    static constexpr int order = 2;

    static void advance(Stage<0>, auto& x, auto& v, auto& x0, auto& v0, auto& half, const auto& a, const auto& dt) {
        x0 = x;
        v0 = v;
        half = v0 + 0.5 * dt * a;
        x = x0 + dt * v0;
        v = v0 + dt * a;
    }
    static void advance(Stage<1>, auto& x, auto& v, auto& x0, auto& v0, auto& half, const auto& a, const auto& dt) {
        x = x0 + 0.5 * dt * (v0 + v);
        v = half + 0.5 * dt * a;
    }
};
//! [model]

int main() {
    const auto error = [](int n) {
        World world{Heun{}, QuadraticDrag{0.3 * kilogram_per_metre}};
        const auto ball = world.add(velocity(metres_per_second(5, 0, 0)), mass(1.0 * kilogram));
        for (int i = 0; i < n; ++i) world.step(1.0 / n * second);
        return world.velocity(ball).value()[0];
    };
    const double exact = error(6400);
    return std::abs(std::log2(std::abs(error(50) - exact) / std::abs(error(100) - exact)) - Heun::order) < 0.1 ? 0 : 1;
}
