// SPDX-License-Identifier: BSL-1.0

// Gravity: the same for every mass, and hard case I8, the offset that each scheme shows in free fall.

#include <ansatz/motion/gravity.hpp>

#include "tests/measured.hpp"
#include "tests/motion/support.hpp"

#include <string>

using namespace motion_tests;

TEST_CASE("I8 free fall: after a second each scheme is off by g h T / 2, to its own side, or not at all",
          "[motion][I8][gravity]") {
    for_each_type(AllIntegrators{}, []<class I> {
        for_each_type(Types<Space<double, 3>, Space<float, 2>>{}, []<class S> {
            World world{S{}, I{}, Gravity{}};
            const auto body = world.add(at<S>(3, 0), going<S>(1, 2));
            run(world, 60, 1.0 / 60);
            const double offset = double(world.position(body).value()[1]) - (2 - 0.5 * 9.81);
            const double expected = std::is_same_v<I, ExplicitEuler> ? 0.08175
                                    : std::is_same_v<I, SemiImplicitEuler> || std::is_same_v<I, ImplicitEuler>
                                        ? -0.08175
                                        : 0;
            constexpr bool narrow = std::is_same_v<typename S::Scalar, float>;
            INFO("offset " << offset << " m, should be " << expected << " m");
            // For float the row asks for 1e-5. Verlet keeps its velocity as a difference of positions: a rounding of a
            // number near 3 m, 2^-23 m, goes on as a velocity for up to 60 steps.
            const double bound = !narrow ? 1e-12 : std::is_same_v<I, Verlet> ? 60 * 60 / 2 * std::pow(2.0, -23) : 1e-5;
            CHECK(test::measured("I8", narrow ? "error of the offset in float" : "error of the offset",
                                 std::abs(offset - expected), test::at_most(bound), "m"));
            // Across the fall nothing acts: only the 60 roundings of numbers up to 4 m, each of 2^-23 m at most.
            CHECK(std::abs(double(world.position(body).value()[0]) - 4) <=
                  (!narrow ? 1e-12 : (std::is_same_v<I, Verlet> ? 60 / 2 : 2) * 60 * std::pow(2.0, -23)));
        });
    });
}

TEST_CASE("gravity accelerates every mass alike, to the bit", "[motion][gravity]") {
    World world{SemiImplicitEuler{}, Gravity{}, Keep<InverseMass>{}};
    const auto light = world.add(position(metres(0, 10, 0)), mass(1e-9 * kilogram)),
               heavy = world.add(position(metres(0, 10, 0)), mass(1e9 * kilogram));
    run(world, 100, 1.0 / 60);
    CHECK(same_state(world, light, world, heavy));
    CHECK(world.position(light).value()[1] < 10);
}

TEST_CASE("gravity can be varied while the world runs, and the motion so far is kept", "[motion][gravity]") {
    for_each_type(Types<SemiImplicitEuler, VelocityVerlet, Verlet>{}, []<class I> {
        World world{I{}, Gravity{}};
        const auto body = world.add(velocity(metres_per_second(0, 5, 0)));
        run(world, 30, 1.0 / 60);
        const auto v = world.velocity(body);
        world.set(Gravity{metres_per_second_squared(0, 1.62, 0)}); // upwards
        CHECK(std::abs((world.velocity(body) - v).value().norm()) <= 1e-12);
        CHECK(world.acceleration(body).value() == Eigen::Vector3d(0, 1.62, 0));
        CHECK(world.template get<Gravity>().acceleration.value()[1] == 1.62);
        run(world, 30, 1.0 / 60);
        INFO("velocity should be " << v.value()[1] + 0.5 * 1.62 << " m/s");
        CHECK(std::abs(world.velocity(body).value()[1] - (v.value()[1] + 0.5 * 1.62)) <= 1e-12);
    });
}

TEST_CASE("gravity refuses what it cannot mean, with a sentence", "[motion][gravity]") {
    auto sentence = [](auto&& f) -> std::string {
        try {
            f();
        } catch (const std::invalid_argument& e) {
            return e.what();
        }
        return "nothing was refused";
    };
    const double infinite = std::numeric_limits<double>::infinity();
    CHECK(sentence([&] {
              World world{SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, -infinite, 0)}};
          }).find("Gravity: acceleration is") == 0);
    // A third component where there is none, at construction and at set(), which leaves the world as it was.
    CHECK(sentence([&] {
              World world{Space<double, 2>{}, SemiImplicitEuler{}, Gravity{metres_per_second_squared(0, 0, 1)}};
          }).find("two dimensions") != std::string::npos);
    World flat{Space<float, 2>{}, SemiImplicitEuler{}, Gravity{}};
    const auto body = flat.add();
    CHECK(sentence([&] { flat.set(Gravity{metres_per_second_squared(0, 0, 1)}); }).find("Gravity::acceleration") !=
          std::string::npos);
    CHECK(flat.acceleration(body).value()[1] == -9.81f);
}

TEST_CASE("gravity's potential is -g.x, zero at the origin", "[motion][gravity]") {
    World world{VelocityVerlet{}, Gravity{metres_per_second_squared(1, -2, 3)}, Keep<InverseMass>{}};
    world.add(position(metres(5, 7, 11)), mass(2.0 * kilogram));
    CHECK(potential_energy(world).value() == -2.0 * (5 - 14 + 33));
}
