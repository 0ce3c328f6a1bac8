// SPDX-License-Identifier: BSL-1.0
// A policy of the user's that throws in the midst of a step (hard case V10): the exception arrives as it is, and the
// world is as it was, or says that it is lost and refuses all but another world in its place.

#include "tests/collision/support.hpp"

#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <sstream>
#include <string>

using namespace collision_tests;

namespace {

struct Oops {
    int number;
};
/// How many calls of a user's policies go well until one throws; negative: all do.
long calls_until_it_throws = -1;
void call() {
    if (calls_until_it_throws >= 0 && calls_until_it_throws-- == 0) throw Oops{42};
}

struct Wind {
    using role = roles::Force;
    using reads = Columns<Velocity>;
    template <class S> struct In {
        explicit In(const Wind&) {}
        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const {
            call();
            return -v / (typename S::Time::value_type(10) * second);
        }
    };
};
struct Brake {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::after_integration;
    template <class S> struct In {
        explicit In(const Brake&) {}
        void prepare(const auto&) { call(); }
        void apply(typename S::Velocity& v, const auto&) const {
            call();
            v *= typename S::Scalar(0.999);
        }
    };
};
struct Everybody {
    using role = roles::Filter;
    using reads = Columns<>;
    template <class S> struct In {
        explicit In(const Everybody&) {}
        bool passes(const auto&, const auto&) const {
            call();
            return true;
        }
    };
};

/// What can be told of a world from outside.
template <class W> std::string told(const W& world) {
    std::ostringstream out;
    out << world.hash() << ' ' << world.size() << ' ' << world.contacts().size() << ' ' << world.events().size();
    for (const auto h : world.handles()) out << ' ' << h.id << ':' << world.position(h) << world.velocity(h);
    return out.str();
}

template <class S, class... P> void check_throws(const P&... policies) {
    auto make = [&] {
        return World{S{},         Wind{},        Brake{},
                     Everybody{}, Gravity{},     Springs{},
                     Rest{},      UniformGrid{}, Narrowphase<Sphere, Plane>{},
                     policies...};
    };
    using W = decltype(make());
    auto world = make();
    world.add(Plane::ground(), fixed);
    std::vector<Handle> balls;
    for (int i = 0; i < 6; ++i) // a row of pairs that lie on each other
        balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(i / 2 * 1.5, 0.5 + i % 2 * 1.0)),
                                  mass((1.0 + i) * kilogram)));
    world.add(Spring{balls[0], balls[3], 20.0 * newton_per_metre});
    for (int i = 0; i < 3; ++i) world.step(1.0 / 120 * second);
    auto stepped = world;
    stepped.step(1.0 / 120 * second);

    const auto refused = [](const std::string& s) {
        return s.find("this world is lost, because its last step was broken off") != std::string::npos;
    };
    long n = 0, lost = 0;
    for (bool threw = true; threw; ++n) {
        INFO("call " << n << " of a step");
        auto now = world;
        threw = false;
        calls_until_it_throws = n;
        try {
            now.step(1.0 / 120 * second);
        } catch (const Oops& oops) {
            threw = true;
            CHECK(oops.number == 42);
        }
        calls_until_it_throws = -1;
        if (!threw) {
            CHECK(told(now) == told(stepped));
            break;
        }
        if (!now.status().lost) { // nothing was begun
            CHECK(told(now) == told(world));
            now.step(1.0 / 120 * second);
            CHECK(told(now) == told(stepped));
            continue;
        }
        ++lost;
        CHECK_FALSE(now.status().ok());
        CHECK(refused(refusal([&] { now.step(1.0 / 120 * second); })));
        CHECK(refused(refusal([&] { now.set_velocity(balls[1], now.velocity(balls[1])); })));
        CHECK(refused(refusal([&] { now.remove(balls[1]); })));
        std::ostringstream out;
        CHECK(refused(refusal([&] { save(now, out); })));
        (void)told(now); // reading does no harm
        W copy = now;
        CHECK(copy.status().lost);
        copy = world;
        now = std::move(copy);
        CHECK(told(now) == told(world));
        now.step(1.0 / 120 * second);
        CHECK(told(now) == told(stepped));
    }
    CHECK(n > 20); // the policies are called for each of six bodies
    CHECK(lost > 0);
}

} // namespace

TEST_CASE("V10: a policy that throws at any call of a step leaves the world as it was, or lost",
          "[collision][refusals][V10]") {
    using Plain = Space<double, 2>;
    check_throws<Plain>(SemiImplicitEuler{}, Impulse<>{}, Projection{});
    check_throws<Plain>(RungeKutta4{}, Penalty{});
    check_throws<Plain>(Verlet{}, SoftSubsteps<Friction>{});
    check_throws<Space<float, 2>>(VelocityVerlet{}, Impulse<Friction>{}, Projection{});
    check_throws<Plain>(SemiImplicitEuler{}, SoftSubsteps<>{}, StepLimit<Divide>{});
    check_throws<Plain>(SemiImplicitEuler{}, SoftSubsteps<Coloured, Friction>{});
}
