// SPDX-License-Identifier: BSL-1.0
// A driver takes a range of phases as often as it likes: here motion runs in slow motion while somebody says so.

#include <ansatz/world.hpp>
#include <cmath>

using namespace ansatz;

//! [model]
struct SlowMotion {
    using role = roles::System;
    static constexpr std::string_view name = "SlowMotion";
    int parts = 10; // substeps of a step, of which the first alone is taken
    static void parameters(auto& self, auto&& visit) { visit("parts", self.parts); }
    template <class S> struct First {
        static constexpr Phase phase = phases::substeps, until = phases::fields;
        static constexpr std::string_view name = "slow motion";
        int parts;
        explicit First(const SlowMotion& slow) : parts(slow.parts) {}
        void run(auto&, const auto& dt, auto& part) const { part.last(dt / typename S::Scalar(parts)); }
    };
    template <class S> using systems = Types<First<S>>;
};
//! [model]

int main() {
    World world{SemiImplicitEuler{}, SlowMotion{}};
    const auto ball = world.add(velocity(metres_per_second(1, 0, 0)));
    for (int i = 0; i < 100; ++i) world.step(0.01 * second);
    if (!(std::abs(world.position(ball).value()[0] - 0.1) < 1e-12)) return 1;
    world.set(SlowMotion{1});
    for (int i = 0; i < 100; ++i) world.step(0.01 * second);
    return std::abs(world.position(ball).value()[0] - 1.1) < 1e-12 ? 0 : 1;
}
