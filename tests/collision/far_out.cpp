// SPDX-License-Identifier: BSL-1.0
// Contacts far from the origin under Compensated (hard case V7): what responses do to positions goes together with what
// rounding has dropped from them.

#include "tests/collision/support.hpp"

#include <ansatz/motion/integrators/compensated.hpp>
#include <ansatz/motion/rest.hpp>
#include <ansatz/soft_bodies.hpp>

#include "tests/measured.hpp"

using namespace collision_tests;

namespace {

constexpr double away = 4096; // m, where the places of a float are 0.49 mm apart
constexpr double dt = 1.0 / 240;
const Rest rest{.threshold = 0.01 * metre_per_second};

template <class World_> double place(const World_& world, Handle body) {
    double dropped = 0;
    if constexpr (World_::composition::template stores<PositionRemainder>)
        dropped = double(world.template read<PositionRemainder>(body).value()[0]);
    return x_of(world, body) + dropped;
}
/// How far a ball of 0.05 m/s comes in 20 s on a plane, m; NaN where it leaves the plane or falls asleep.
template <class S, class I, class... P> double rolled(const P&... responses) {
    auto world = world_of(S{}, I{}, Gravity{}, rest, responses...);
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, at<S>(away, 0.5), going<S>(0.05), mass(1.0 * kilogram));
    bool stays = true;
    for (int i = 0; i < 20 * 240; ++i) {
        world.step(dt * second);
        stays = stays && std::abs(height_of(world, ball) - 0.5) <= 0.01 && world.motion(ball) == Motion::awake;
    }
    return stays ? place(world, ball) - away : std::nan("");
}
/// The same for each way to answer contacts.
template <class S, class I> std::vector<double> all_rolled() {
    return {rolled<S, I>(Impulse<>{}, Projection{}), rolled<S, I>(SoftSubsteps{})};
}

} // namespace

TEST_CASE("V7: a ball on a plane rolls on at 4096 m, whatever answers its contact", "[collision][far]") {
    double most = 0;
    for_each_type(Types<Space<float, 3>, Space<float, 2>>{}, [&]<class S> {
        for (const auto& ways :
             {all_rolled<S, Compensated<SemiImplicitEuler>>(), all_rolled<S, Compensated<VelocityVerlet>>()})
            for (const double way : ways) {
                CHECK(way == Approx(1).margin(0.01));
                most = std::max(most, std::abs(way - 1));
            }
        for (const double way : all_rolled<S, SemiImplicitEuler>()) CHECK(!(way > 0.5)); // the control
    });
    CHECK(test::measured("V7", "a ball on a plane at 4096 m in float, 0.05 m/s at 240 Hz: error of a way of 1 m", most,
                         test::at_most(0.01), "of it"));
}
TEST_CASE("V7: it meets a wall there, stays before it, and falls asleep", "[collision][far]") {
    using S = Space<float, 2>;
    const auto meet = [](const auto&... responses) {
        auto world = world_of(S{}, Compensated<SemiImplicitEuler>{}, Gravity{}, rest, responses...);
        world.add(Plane::ground(), fixed);
        world.add(Box{vector_in<S, unit::Length>(0.5, 2)}, at<S>(away + 1.5, 0), fixed);
        const auto ball =
            world.add(Sphere{0.5 * metre}, at<S>(away, 0.5), going<S>(0.05), mass(1.0 * kilogram), restitution(0));
        run(world, 20 * 240, dt);
        CHECK(place(world, ball) == Approx(away + 0.5).margin(0.01));
        CHECK(world.motion(ball) == Motion::resting);
        const auto before = place(world, ball);
        run(world, 240, dt);
        CHECK(place(world, ball) == before);
        world.set_velocity(ball, metres_per_second(-0.05, 0)); // it wakes, and goes back
        run(world, 2400, dt);
        CHECK(place(world, ball) == Approx(before - 0.5).margin(0.01));
    };
    meet(Impulse<>{}, Projection{});
    meet(SoftSubsteps{});
}
TEST_CASE("V7: projection moves a heavy body by less than a place, and the centre of mass stays", "[collision][far]") {
    using S = Space<float, 2>;
    const auto shifted = []<class I>() {
        auto world = world_of(S{}, I{}, Projection{});
        const auto heavy = world.add(Sphere{0.5 * metre}, at<S>(away), mass(1000.0 * kilogram)),
                   light = world.add(Sphere{0.5 * metre}, at<S>(away + 0.875), mass(1.0 * kilogram));
        run(world, 60, dt);
        CHECK(x_of(world, light) - x_of(world, heavy) > 0.95);
        return std::abs(1000 * (place(world, heavy) - away) + (place(world, light) - away - 0.875)) / 1001;
    };
    const double with = shifted.operator()<Compensated<SemiImplicitEuler>>(),
                 without = shifted.operator()<SemiImplicitEuler>();
    INFO("the centre of mass moves by " << with << " m, without it by " << without << " m");
    CHECK(with <= 1e-9);
    CHECK(without >= 1e-5); // the control
}
TEST_CASE("V7: beside a solver of positions a pair on a spring goes on, and so do its copies", "[collision][far]") {
    using S = Space<float, 2>;
    const auto fly = [](const auto& solver) {
        World world{S{}, Compensated<SemiImplicitEuler>{}, solver, Springs{}};
        const auto a = world.add(at<S>(away), going<S>(0.05), mass(1.0 * kilogram)),
                   b = world.add(at<S>(away + 1), going<S>(0.05), mass(1.0 * kilogram));
        world.add(Spring{a, b, 100.0 * newton_per_metre, 0.0 * newton_second_per_metre, 1.0 * metre});
        run(world, 20 * 240, dt);
        CHECK((place(world, a) + place(world, b) - 2 * away - 1) / 2 == Approx(1).margin(0.01));
        auto copy = world;
        run(world, 100, dt);
        run(copy, 100, dt);
        CHECK(copy.hash() == world.hash());
    };
    fly(Xpbd{});
    fly(VertexBlockDescent{});
}
