// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on rest (notes 1.8).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

using S = Space<double, 2>;
using Velocities = std::vector<S::Velocity>;
static_assert(EffectIn<exercise::Rest, S>,
              "Rest is no effect any more: keep role, reads, writes, place, and in In<S> the parameters of apply");

const auto none = 0.0 * second;

/// What the clock of a body shows that had these velocities at the end of its steps. The threshold is 0.05 m/s.
S::Time clock_after(const Velocities& velocities, Quantity<unit::Time> dt, Quantity<unit::Mass> mass = 2.0 * kilogram) {
    const exercise::Rest::In<S> rest(exercise::Rest{0.05 * metre_per_second, 0.5 * second});
    const Context<S, false> context(S::ClockTime(), TimeStep<S>(dt, dt));
    S::Time slow_for{};
    auto one_step = [&](const auto& r, const S::Velocity& v) {
        if constexpr (requires { r.apply(slow_for, v, context); }) r.apply(slow_for, v, context);
        else r.apply(slow_for, v, 1.0 / mass, context); // an answer that asks for the mass too
    };
    for (const auto& v : velocities) one_step(rest, v);
    return slow_for;
}
const auto slow = metres_per_second(0.03, -0.01), fast = metres_per_second(0.2, 0.1);

bool long_enough(Quantity<unit::Time> slow_for, Quantity<unit::Time> time = 0.5 * second) {
    return exercise::Rest::In<S>(exercise::Rest{0.05 * metre_per_second, time}).long_enough(slow_for);
}
void expect_sleep(Quantity<unit::Time> slow_for, Quantity<unit::Time> time, bool sleeps, const char* why) {
    std::ostringstream text;
    text << "may a body sleep that has been slow for " << slow_for << ", where the time is " << time << "?\n    yours  "
         << (sleeps ? "no" : "yes") << "\n    right  " << (sleeps ? "yes" : "no") << "\n"
         << why;
    expect(long_enough(slow_for, time) == sleeps, text.str());
}

/// A world needs both tasks. The second is asked for first, so that whoever has done the first is told of that one.
auto world_with_rest() {
    (void)long_enough(none);
    return World{exercise::Rest{0.05 * metre_per_second, 0.5 * second}, SemiImplicitEuler{}, AppliedForces{}};
}

} // namespace

TEST_CASE("the steps of a slow body add up", "[task-1][adds-up]") {
    for (const double dt : {0.1, 0.25}) {
        std::ostringstream what;
        what << "the clock after three steps of " << dt << " s with (0.03, -0.01) m/s, where the threshold is 0.05 m/s";
        expect_near(what.str(), clock_after(Velocities(3, slow), dt * second), 3 * dt * second, 1e-12 * second,
                    "Each step in which it is slow adds the length of that step.");
    }
}

TEST_CASE("slow is said of the length of the velocity", "[task-1][length]") {
    for (const auto& v :
         {metres_per_second(0.04, 0.04), metres_per_second(-0.2, 0), metres_per_second(-0.2, 0.2), fast}) {
        std::ostringstream what;
        what << "the clock after a step with " << v << ", which are " << norm(v) << ", where the threshold is 0.05 m/s";
        expect_near(
            what.str(), clock_after({v}, 0.1 * second), none, none,
            "This body is fast: the root of the sum of the squares is above the threshold, whatever its components "
            "or their signs are.");
    }
}

TEST_CASE("a fast moment begins the time anew", "[task-1][anew]") {
    expect_near("the clock after three slow steps of 0.1 s, a fast one, and one more slow one",
                clock_after({slow, slow, slow, fast, slow}, 0.1 * second), 0.1 * second, 1e-12 * second,
                "Without a break: after a fast step the time starts from zero.");
}

TEST_CASE("a heavy body rests like a light one", "[task-1][mass]") {
    for (const double m : {0.001, 1000.0}) {
        std::ostringstream what;
        what << "the clock of a body of " << m << " kg after two slow steps of 0.1 s";
        expect_near(what.str(), clock_after({slow, slow}, 0.1 * second, m * kilogram), 0.2 * second, 1e-12 * second,
                    "A threshold for the speed says nothing about the mass.");
    }
}

TEST_CASE("in a world, a slow body that nothing pulls sleeps after its time", "[task-2][world]") {
    auto world = world_with_rest();
    const auto puck = world.add(velocity(metres_per_second(0.03, 0, 0)), mass(2.0 * kilogram));
    const auto ball = world.add(velocity(metres_per_second(0.06, 0, 0)), mass(2.0 * kilogram));
    int steps = 0;
    while (steps < 100 && world.motion(puck) != Motion::resting) world.step(0.03125 * second), ++steps;
    std::ostringstream text;
    text << "a puck with 0.03 m/s, a threshold of 0.05 m/s, a time of 0.5 s, steps of 1/32 s\n    yours  "
         << (world.motion(puck) == Motion::resting ? "it falls asleep in step " : "it is still awake after step ")
         << steps
         << "\n    right  it falls asleep in step 16\nIt is slow all the time, and sixteen steps are half a second.";
    expect(steps == 16, text.str());
    expect(world.motion(ball) != Motion::resting,
           "a ball with 0.06 m/s, above the threshold of 0.05 m/s, was put to sleep.\n"
           "Only what is slower than the threshold may rest.");
}

TEST_CASE("a body that turns round is not put to sleep in the turning point", "[task-2][turning-point]") {
    // An engine brakes it from 1 m/s with 1.6 m/s^2, as a moon would. It is below 0.05 m/s for 1/16 s, eight times too
    // short.
    auto world = world_with_rest();
    const auto body = world.add(velocity(metres_per_second(0, 1, 0)), mass(2.0 * kilogram));
    bool slept = false;
    for (int i = 0; i < 160; ++i) {
        world.apply_force(body, newtons(0, -3.2, 0));
        world.step(1.0 / 128 * second);
        slept = slept || world.motion(body) == Motion::resting;
    }
    expect(!slept, "a body that an engine brakes and drives back was put to sleep where it turned round.\n"
                   "Slow for a moment is not slow for a while: the clock must have reached the time.");
}

TEST_CASE("after the time it may sleep, and not before", "[task-2][time]") {
    for (const double slow_for : {0.01, 0.25, 0.49})
        expect_sleep(slow_for * second, 0.5 * second, false, "The time has not come yet.");
    for (const double slow_for : {0.51, 3.0}) expect_sleep(slow_for * second, 0.5 * second, true, "The time is over.");
}

TEST_CASE("a sum of steps that ends a rounding short is long enough", "[task-2][rounding]") {
    expect_sleep(0.5 * second, 0.5 * second, true, "It has been slow for exactly the time.");
    for (const double steps : {30.0, 6000.0}) { // a rounding each, at worst all in one direction
        const double short_by = steps * 1.2e-16;
        std::ostringstream why;
        why << "(It lacks " << short_by << " of the time, as a sum of " << steps << " steps may.)\n"
            << "Ask for a little less than the time: a hundred-thousandth less is fine.";
        expect_sleep(0.5 * (1 - short_by) * second, 0.5 * second, true, why.str().c_str());
    }
}

TEST_CASE("where the time is zero, a fast body still goes on", "[task-2][no-time]") {
    expect_sleep(none, none, false, "Its clock shows zero, which means that it is fast.");
    expect_sleep(0.01 * second, none, true, "It is slow, and no time is asked for.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1) {
        for (const Velocities& v : {Velocities{slow, slow},
                                    {slow, fast, slow},
                                    {fast},
                                    {metres_per_second(0.04, 0.04)},
                                    {metres_per_second(-0.2, 0.2)},
                                    {metres_per_second(-0.2, 0)},
                                    // Testing one component alone does not compare each of them.
                                    {metres_per_second(0.01, 0.2)},
                                    {metres_per_second(0.2, -0.01)}})
            numbers.push_back(clock_after(v, 0.1 * second).value());
        for (const double m : {0.001, 1000.0})
            numbers.push_back(clock_after({slow}, 0.1 * second, m * kilogram).value());
        return numbers;
    }
    for (const double slow_for : {0.01, 0.25, 0.49, 0.5 - 1e-15, 0.5, 0.51})
        numbers.push_back(long_enough(slow_for * second));
    numbers.push_back(long_enough(none, none));
    numbers.push_back(long_enough(0.01 * second, none));
    return numbers;
}
