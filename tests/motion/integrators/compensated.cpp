// SPDX-License-Identifier: BSL-1.0
// Compensated: motion far from the origin (hard case V7), and that nothing else of the inner integrator changes.

#include <ansatz/motion/integrators/compensated.hpp>

#include "tests/measured.hpp"
#include "tests/motion/global_order.hpp"
#include "tests/refusal.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include <sstream>

using namespace motion_tests;
using test::measured;

namespace {

using Inner = Types<ExplicitEuler, SemiImplicitEuler, VelocityVerlet, RungeKutta4>;

/// A body's place to all digits that are kept, as a distance from another along the first axis, m.
template <class World_> double gone(const World_& world, Handle body, double from) {
    double dropped = 0;
    if constexpr (World_::composition::template stores<PositionRemainder>)
        dropped = double(world.template read<PositionRemainder>(body).value()[0]);
    return double(world.position(body).value()[0]) - from + dropped;
}
template <class S, class I> auto free_body(double from, double v = 0.05) {
    World world{S{}, I{}};
    const auto body = world.add(at<S>(from), going<S>(v));
    return std::pair(world, body);
}
/// The share of a way of 1 m at 0.05 m/s and 240 Hz that a body moves, this far out.
template <class S, class I> double moved(double from) {
    auto [world, body] = free_body<S, I>(from);
    run(world, 20 * 240, 1.0 / 240);
    return gone(world, body, from);
}
/// As far out for a double as 1 m is for a float.
template <class Scalar> double far_in() {
    return std::ldexp(1.0, std::numeric_limits<Scalar>::digits - std::numeric_limits<float>::digits);
}

/// A spring to a place that is far away from the origin.
struct Tether {
    using role = roles::Force;
    using reads = Columns<Position>;
    double at = 0, w = 0; // m, 1/s
    template <class S> struct In {
        typename S::Position anchor;
        typename S::Scalar w2;
        explicit In(const Tether& t) : anchor(vector_in<S, unit::Length>(t.at)), w2(typename S::Scalar(t.w * t.w)) {}
        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            return S::Acceleration::from_value(-w2 * (x - anchor).value());
        }
    };
};

/// Between explicit Euler (0) and semi-implicit Euler (1).
struct Blend {
    using role = roles::Integrator;
    using writes = Columns<Position, Velocity>;
    static constexpr int stages = 1;
    double share = 1;
    static void parameters(auto& self, auto&& visit) { visit("share", self.share); }
    void check() const {
        if (!(share >= 0 && share <= 1)) refuse_value("Blend", "share", share, "it is 0 to 1");
    }
    template <class S> struct In {
        typename S::Scalar share;
        explicit In(const Blend& blend) : share(typename S::Scalar(blend.share)) {}
        void advance(Stage<0>, auto& x, auto& v, const auto& a, const auto& dt) const {
            const auto old = v;
            v += a * dt;
            x += (share * v + (typename S::Scalar(1) - share) * old) * dt;
        }
    };
};

/// Pushed by the time: the stages ask at theirs.
struct Later {
    using role = roles::Force;
    using reads = Columns<Clock>;
    template <class S> struct In {
        explicit In(const Later&) {}
        typename S::Acceleration acceleration(const auto& context) const {
            return vector_in<S, unit::Acceleration>(context.time().value());
        }
    };
};

static_assert(StagedIntegratorIn<Compensated<RungeKutta4>, Space<float, 2>>);
static_assert(StagedIntegratorIn<Compensated<Blend>, Space<>>);

} // namespace

TEST_CASE("V7: a slow body far out moves its way, with every integrator, scalar and dimension", "[motion][far]") {
    double most = 0;
    for_each_type(AllSpaces{}, [&]<class S> {
        for_each_type(Inner{}, [&]<class I> {
            for (const double away : {512.0, 4096.0, 1e5, 1e7})
                for (const double side : {1.0, -1.0}) {
                    const double way = moved<S, Compensated<I>>(side * away * far_in<typename S::Scalar>());
                    INFO("from " << side * away << " m times " << far_in<typename S::Scalar>() << " a way of " << way);
                    CHECK(std::abs(way - 1) <= 0.01);
                    most = std::max(most, std::abs(way - 1));
                }
        });
    });
    CHECK(measured("V7", "0.05 m/s at 240 Hz, up to 1e7 m out in float: error of a way of 1 m", most,
                   test::at_most(0.01), "of it"));
}
TEST_CASE("V7: without it the way is 88 % at 512 m and nothing from 4096 m on", "[motion][far]") {
    for_each_type(Types<Space<float, 2>, Space<float, 3>, Space<double, 2>>{}, [&]<class S> {
        for_each_type(Inner{}, [&]<class I> {
            CHECK(moved<S, I>(512 * far_in<typename S::Scalar>()) == Approx(0.88).margin(0.005));
            CHECK(moved<S, I>(4096 * far_in<typename S::Scalar>()) == 0);
            CHECK(moved<S, I>(1e7 * far_in<typename S::Scalar>()) == 0);
        });
    });
}
TEST_CASE("V7: at 1e7 m, where a float's places are 1 m apart, the place that others see is the nearest of them",
          "[motion][far]") {
    using S = Space<float, 2>;
    auto [world, body] = free_body<S, Compensated<VelocityVerlet>>(1e7, 3);
    double apart = 0, whole = 0;
    for (int i = 1; i <= 240 * 100; ++i) {
        world.step(1.0 / 240 * second);
        const double expected = 3.0 * i / 240;
        apart = std::max(apart, std::abs(double(world.position(body).value()[0]) - 1e7 - expected));
        whole = std::max(whole, std::abs(gone(world, body, 1e7) / expected - 1));
    }
    INFO("the position is off by " << apart << " m, with its remainder by " << whole << " of the way");
    CHECK(apart <= 0.5001); // half a place, and the rounding of the ways
    CHECK(whole <= 1e-4);   // of 0.0125 m, which a remainder of up to half a metre takes to 3e-8 m
}

TEST_CASE("Compensated keeps the order of the inner integrator", "[motion][far][I1]") {
    for_each_type(Inner{}, []<class I> {
        GlobalOrder<2>::in_double<Compensated<I>>();
        GlobalOrder<2>::in_float<Compensated<I>>();
        GlobalOrder<3>::the_same_way<Compensated<I>>();
    });
}
TEST_CASE("V7: far out a fall ends where the closed form of the inner integrator says", "[motion][far]") {
    // From rest with a = 1 m/s^2 in n steps through a second: 1/2 + leads/n m. The velocity is a sum of n floats.
    const auto off = []<class I>(int steps, double leads) {
        World world{Space<float, 2>{}, I{}, Gravity{.acceleration = metres_per_second_squared(1, 0, 0)}};
        const auto body = world.add(at<Space<float, 2>>(1e5), going<Space<float, 2>>(0));
        run(world, steps, 1.0 / steps);
        return std::abs(gone(world, body, 1e5) - 0.5 - leads / steps);
    };
    for (const int steps : {60, 500}) {
        CHECK(off.operator()<Compensated<ExplicitEuler>>(steps, -0.5) <= 1e-5);
        CHECK(off.operator()<Compensated<SemiImplicitEuler>>(steps, 0.5) <= 1e-5);
        CHECK(off.operator()<Compensated<VelocityVerlet>>(steps, 0) <= 1e-5);
        CHECK(off.operator()<Compensated<RungeKutta4>>(steps, 0) <= 1e-5);
        CHECK(off.operator()<SemiImplicitEuler>(steps, 0.5) > 1e-3); // the control
    }
}
TEST_CASE("V7: near the origin it is at least as exact as the inner integrator", "[motion][far]") {
    for_each_type(Inner{}, []<class I> {
        const auto end = []<class Scalar, class J>() {
            using S = Space<Scalar, 2>;
            World world{S{}, J{}, Gravity{}};
            const auto body = world.add(at<S>(0.3, 0.7), going<S>(1.0 / 3, 9.81 * 5));
            run(world, 10 * 10000, 1e-4);
            return state(world, body);
        };
        const auto truth = end.template operator()<double, I>(),
                   with = end.template operator()<float, Compensated<I>>(),
                   without = end.template operator()<float, I>();
        INFO("with " << std::abs(with[0] - truth[0]) << ", without " << std::abs(without[0] - truth[0]) << " m");
        CHECK(std::abs(with[0] - truth[0]) <= 1e-6);
        CHECK(std::abs(with[0] - truth[0]) <= std::abs(without[0] - truth[0]));
        CHECK(std::abs(without[0] - truth[0]) > 1e-5); // the control
    });
}
TEST_CASE("V7: a float oscillator at 1e5 m swings on, and stands still without it", "[motion][far]") {
    const auto energies = []<class I>() {
        using S = Space<float, 2>;
        World world{S{}, I{}, Tether{1e5, 1}};
        const auto body = world.add(at<S>(1e5 + 1), going<S>(0));
        double least = 1, most = 0;
        for (int i = 0; i < 240 * 600; ++i) { // about a hundred swings
            world.step(1.0 / 240 * second);
            const double x = gone(world, body, 1e5), v = double(world.velocity(body).value()[0]);
            least = std::min(least, x * x + v * v);
            most = std::max(most, x * x + v * v);
        }
        return std::pair(least, most);
    };
    // A kick by a staircase of the position is still a kick by a function of it, and the way is exact: symplectic. The
    // stairs are 1/128 m high, and so is the share of the energy that they may take and give.
    for (const auto& [least, most] :
         {energies.operator()<Compensated<SemiImplicitEuler>>(), energies.operator()<Compensated<VelocityVerlet>>()}) {
        INFO("energy between " << least << " and " << most << " of the first");
        CHECK(least >= 1 - 1.0 / 64);
        CHECK(most <= 1 + 1.0 / 64);
    }
    const auto [least, most] = energies.operator()<Compensated<SemiImplicitEuler>>();
    CHECK(measured("V7", "an oscillator of 1 m at 1e5 m in float, a hundred swings: error of the energy",
                   std::max(1 - least, most - 1), test::at_most(1.0 / 64), "of it"));
    const auto without = energies.operator()<SemiImplicitEuler>();
    INFO("without it between " << without.first << " and " << without.second);
    CHECK(std::max(1 - without.first, without.second - 1) > 0.1);
}

TEST_CASE("V7: a copy, and what is saved and loaded, goes on to the bit; the remainder counts", "[motion][far][save]") {
    using S = Space<float, 3>;
    for_each_type(Inner{}, []<class I> {
        World world{S{}, Compensated<I>{}, Gravity{}};
        const auto body = world.add(at<S>(4096, 1, -3e4), going<S>(0.05, 1, 0.3));
        run(world, 100, 1.0 / 240);
        CHECK(norm(world.template read<PositionRemainder>(body)).value() > 0);
        auto copy = world, loaded = World{S{}, Compensated<I>{}, Gravity{}};
        std::stringstream file;
        save(world, file);
        load(loaded, file);
        CHECK(loaded.hash() == world.hash());
        for (auto* one : {&world, &copy, &loaded}) run(*one, 100, 1.0 / 240);
        CHECK(copy.hash() == world.hash());
        CHECK(loaded.hash() == world.hash());
        for (const auto* one : {&copy, &loaded}) {
            CHECK(one->position(body) == world.position(body));
            CHECK(one->template read<PositionRemainder>(body) == world.template read<PositionRemainder>(body));
        }
        World other{S{}, Compensated<I>{}, Gravity{}}, same = other;
        other.add(at<S>(4096), going<S>(0.05), with<PositionRemainder>(metres(1e-4, 0, 0)));
        same.add(at<S>(4096), going<S>(0.05));
        CHECK(other.hash() != same.hash());
    });
}
TEST_CASE("V7: what is put somewhere is exactly there", "[motion][far]") {
    using S = Space<float, 2>;
    auto [world, body] = free_body<S, Compensated<RungeKutta4>>(4096);
    run(world, 1, 1.0 / 240);
    CHECK(world.read<PositionRemainder>(body).value()[0] != 0);
    world.set_position(body, metres(4096, 0));
    CHECK(world.read<PositionRemainder>(body) == S::zero_vector<unit::Length>());
    auto [fresh, other] = free_body<S, Compensated<RungeKutta4>>(4096);
    run(world, 7, 1.0 / 240);
    run(fresh, 7, 1.0 / 240);
    CHECK(world.position(body) == fresh.position(other));
    CHECK(world.read<PositionRemainder>(body) == fresh.read<PositionRemainder>(other));
}
TEST_CASE("V7: platforms far out arrive, and stage by stage it is the same to the bit", "[motion][far]") {
    using S = Space<float, 2>;
    for_each_type(Inner{}, []<class I> {
        const auto flown = [](const auto&... more) {
            World world{S{}, Compensated<I>{}, Gravity{.acceleration = metres_per_second_squared(0.01, 0, 0)},
                        Keep<InverseMass>{}, more...};
            const auto body = world.add(at<S>(4096), going<S>(0.05), mass(1.0 * kilogram)),
                       platform = world.add(at<S>(4096), going<S>(0.05), moving);
            run(world, 20 * 240, 1.0 / 240);
            CHECK(gone(world, platform, 4096) == Approx(1).margin(0.01));
            return std::array{gone(world, body, 4096), gone(world, platform, 4096)};
        };
        CHECK(flown() == flown(Springs{}));
    });
}
TEST_CASE("V7: parameters of the inner integrator are set, checked and saved; the stable step is its own",
          "[motion][far]") {
    using S = Space<float, 2>;
    const auto far = [](double share) {
        World world{S{}, Compensated{Blend{share}}, Gravity{}};
        world.add(at<S>(4096), going<S>(0.05));
        return world;
    };
    auto world = far(0.25);
    std::stringstream file;
    save(world, file);
    auto loaded = far(1);
    load(loaded, file);
    CHECK(loaded.get<Compensated<Blend>>().integrator.share == 0.25);
    loaded.set(Compensated{Blend{0.5}});
    CHECK(loaded.get<Compensated<Blend>>().integrator.share == 0.5);
    CHECK(test::refusal([&] { loaded.set(Compensated{Blend{2}}); }) == "Blend: share is 2; it is 0 to 1");
    const auto k = 100.0 / (second * second);
    CHECK(stable_step<Compensated<SemiImplicitEuler>>(k) == stable_step<SemiImplicitEuler>(k));
    CHECK(stable_step<Compensated<RungeKutta4>>(k) == stable_step<RungeKutta4>(k));
    CHECK(stable_step<Compensated<Blend>>(k, 0.0 * hertz, Compensated{Blend{1}}).value() == Approx(0.2));
}
TEST_CASE("V7: it costs one vector of a body, and nothing of a world without it", "[motion][far]") {
    using With = World<Space<float, 3>, Compensated<RungeKutta4>, Gravity>;
    using Without = World<Space<float, 3>, RungeKutta4, Gravity>;
    STATIC_REQUIRE(With::bytes_per_body == Without::bytes_per_body + 3 * sizeof(float));
    STATIC_REQUIRE(!Without::composition::stores<PositionRemainder>);
    STATIC_REQUIRE(Compensated<SemiImplicitEuler>::velocity_leads == 0.5);
    STATIC_REQUIRE(Compensated<VelocityVerlet>::reversible);
    STATIC_REQUIRE(!Compensated<RungeKutta4>::reversible);
}
TEST_CASE("V7: forces are asked at the times of the inner integrator's stages", "[motion][far]") {
    using S = Space<double, 2>;
    for_each_type(Inner{}, []<class I> {
        const auto end = []<class J>() {
            World world{S{}, J{}, Later{}};
            const auto body = world.add(at<S>(4096), going<S>(0.05));
            run(world, 10, 0.1);
            return world.velocity(body);
        };
        CHECK(end.template operator()<Compensated<I>>() == end.template operator()<I>());
    });
}
