// SPDX-License-Identifier: BSL-1.0

// Hard case I16: Arenstorf's orbit, a closed one with three loops past the moon, and a force that depends on the
// velocity.

#include "tests/motion/support.hpp"

using namespace motion_tests;

namespace {

template <class I> auto state_after(int steps, double T) {
    World world{Space<double, 2>{}, I{}, Arenstorf{}};
    const auto body = add_body(world, Arenstorf::start());
    run(world, steps, T / steps);
    return state(world, body);
}

} // namespace

TEST_CASE("I16 Arenstorf: the orbit closes", "[motion][I16]") {
    const double T = Arenstorf::period().value();
    auto closure = [&](int steps) { // of the position
        const auto s = state_after<RungeKutta4>(steps, T);
        return std::hypot(s[0] - Arenstorf::start().x.value()[0], s[1]);
    };
    const double coarse = closure(20000), middle = closure(200000), fine = closure(2000000);
    INFO("after one period RungeKutta4 misses the start by " << coarse << ", " << middle << ", " << fine
                                                             << " with 2e4, 2e5, 2e6 steps");
    CHECK(std::abs(coarse / 2.7e-3 - 1) <= 0.1);
    CHECK(std::abs(middle / 2.1e-7 - 1) <= 0.1);
    CHECK(fine <= 5e-11); // rounding begins to show: measured 1.2e-11 on a prototype
}

TEST_CASE("I16 Arenstorf: order of every explicit integrator past the moon", "[motion][I16]") {
    // The start is 0.0063 from the moon, at 2 per unit of time: steps of 1e-5 resolve that.
    const double T = 0.1;
    const auto reference = state_after<OdeintFehlberg78>(4000, T);
    REQUIRE(distance(reference, state_after<OdeintFehlberg78>(8000, T)) <= 1e-11);
    for_each_type(Types<ExplicitEuler, SemiImplicitEuler, Verlet, VelocityVerlet, RungeKutta4, OdeintRungeKutta4>{},
                  [&]<class I> {
                      check_order(I::order, 0.05,
                                  I::order >= 4   ? 1000
                                  : I::order == 2 ? 8000
                                                  : 400000,
                                  3, [&](int steps) { return distance(state_after<I>(steps, T), reference); });
                  });
}

TEST_CASE("I16 Arenstorf: what the orbit keeps", "[motion][I16]") {
    const detail::Bound<Arenstorf, Space<double, 2>> law(Arenstorf{});
    auto invariant = [&](const std::array<double, 6>& s) {
        return law.invariant(metres(s[0], s[1]), metres_per_second(s[3], s[4])).value();
    };
    const double before = invariant(state(Arenstorf::start())),
                 after = invariant(state_after<RungeKutta4>(200000, Arenstorf::period().value()));
    INFO("Jacobi's constant " << before << " became " << after);
    CHECK(std::abs(after / before - 1) <= 1e-6);
}
