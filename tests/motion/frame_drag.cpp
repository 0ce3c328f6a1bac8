// SPDX-License-Identifier: BSL-1.0

// FrameDrag: the notes' factor for each frame, and what is wrong with it (hard case I23).

#include <ansatz/motion/frame_drag.hpp>

#include "tests/motion/support.hpp"

using namespace motion_tests;

TEST_CASE("I23 a factor for each frame depends on the frame rate: .740, .547, .299", "[motion][I23][frame_drag]") {
    for_each_type(AllIntegrators{}, []<class I> {
        struct Row {
            int rate;
            double left;
        };
        for (const auto& [rate, left] : {Row{30, 0.740}, Row{60, 0.547}, Row{120, 0.299}}) {
            World world{I{}, FrameDrag{0.99}};
            const auto body = world.add(velocity(metres_per_second(1, 0, -2)));
            run(world, rate, 1.0 / rate);
            const double exact = std::pow(0.99, rate);
            CHECK(std::abs(exact - left) <= 5e-4);
            const auto v = world.velocity(body);
            INFO(rate << " Hz: " << v.value()[0] << " of the velocity is left, should be " << exact);
            CHECK(std::abs(v.value()[0] - exact) <= 1e-12);
            CHECK(std::abs(v.value()[2] + 2 * exact) <= 1e-12);
        }
    });
}

TEST_CASE("frame drag does not know the length of the step", "[motion][frame_drag]") {
    World world{SemiImplicitEuler{}, FrameDrag{0.5}};
    const auto body = world.add(velocity(metres_per_second(8, 0, 0)));
    for (const double dt : {1e-6, 1.0, 100.0}) world.step(dt * second);
    CHECK(world.velocity(body).value()[0] == 1); // powers of two: exact
    world.step(0.0 * second);                    // a step of zero is no frame
    CHECK(world.velocity(body).value()[0] == 1);
}

TEST_CASE("frame drag is above 0 and at most 1", "[motion][frame_drag]") {
    for (const double factor : {0.0, -0.5, 1.0000001, std::numeric_limits<double>::quiet_NaN()}) {
        INFO("factor " << factor);
        CHECK_THROWS_AS((World{SemiImplicitEuler{}, FrameDrag{factor}}), std::invalid_argument);
    }
    CHECK_NOTHROW((World{SemiImplicitEuler{}, FrameDrag{1.0}}));
    CHECK_NOTHROW((World{SemiImplicitEuler{}, FrameDrag{1e-300}}));
}
