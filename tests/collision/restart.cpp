// SPDX-License-Identifier: BSL-1.0
// I19 where velocities and forces decide which bodies may come to touch: a world that is saved between two steps,
// whatever was done to it there, goes on to the same bits.

#include "tests/collision/support.hpp"

#include <ansatz/collision/response/penalty.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>

#include <random>
#include <sstream>

using namespace collision_tests;

namespace {

/// A heap of balls and boxes that is pushed, loses bodies and gets new ones; springs hold them in pairs, where the
/// world has springs. What is done to it is done to its twin as well.
template <class World_> class Heap {
public:
    using S = typename World_::S;
    World_ world;
    World_* twin = nullptr;
    explicit Heap(const World_& empty, unsigned seed) : world(empty), engine_(seed) {
        world.add(Plane::ground(), fixed);
        for (int i = 0; i < 14; ++i) put();
        if constexpr (World_::composition::element_keepers::size > 0)
            for (std::size_t i = 0; i + 1 < bodies_.size(); i += 2)
                world.add(Spring{bodies_[i], bodies_[i + 1], 300.0 * newton_per_metre, 4.0 * newton_second_per_metre});
    }
    void push() {
        const auto body = any();
        each([&](World_& w) {
            w.apply_impulse(body, vector([](auto... x) { return newton_seconds(x...); }, 0.5, 1, 0));
        });
    }
    void exchange() {
        const auto gone = any();
        std::erase(bodies_, gone);
        each([&](World_& w) { w.remove(gone); });
        put();
    }

private:
    void each(auto&& f) {
        f(world);
        if (twin) f(*twin);
    }
    double number() { return 2 * double(engine_() >> 11) * 0x1p-53 - 1; }
    Handle any() { return bodies_[engine_() % bodies_.size()]; }
    static auto vector(auto&& make, double x, double y, [[maybe_unused]] double z) {
        if constexpr (S::dimension == 2) return make(x, y);
        else return make(x, y, z);
    }
    void put() {
        const auto long_ = [](auto... x) { return metres(x...); };
        const auto fast = [](auto... x) { return metres_per_second(x...); };
        const double x = 1.5 * number(), y = 1.5 + 1.2 * number(), z = 0.3 * number(), u = 2 * number(),
                     v = 2 * number(), m = 1 + 0.5 * number();
        const auto there = position(vector(long_, x, y, z));
        const auto going = velocity(vector(fast, u, v, 0));
        const double radius = 0.3 + 0.1 * number();
        const bool round = number() < 0;
        Handle body;
        each([&](World_& w) {
            body = round ? w.add(Sphere{radius * metre}, there, going, mass(m * kilogram))
                         : w.add(Box{vector(long_, 0.3, 0.2, 0.3)}, there, going, mass(m * kilogram));
        });
        bodies_.push_back(body);
    }
    std::mt19937_64 engine_;
    std::vector<Handle> bodies_;
};

template <class... P> void check_restarts(P... policies) {
    const World empty{policies..., Gravity{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{}};
    const std::vector<double> lengths{1.0 / 120, 1.0 / 120, 1.0 / 90, 1.0 / 90, 1.0 / 90, 1.0 / 60};
    for (unsigned seed = 0; seed < 3; ++seed) {
        Heap heap(empty, seed);
        auto loaded = empty;
        for (std::size_t n = 0; n < 200; ++n) {
            INFO("seed " << seed << ", step " << n);
            if (n % 3 == 1) heap.push();
            if (n % 5 == 2) heap.exchange();
            if (n % 4 < 2) { // else it goes on from the step before
                std::stringstream file;
                save(heap.world, file);
                load(loaded, file);
            } else if (n % 3 == 1 || n % 5 == 2) loaded = heap.world;
            REQUIRE(loaded.hash() == heap.world.hash());
            for (const auto body : heap.world.handles()) { // what is known of one is summed anew in the other
                REQUIRE(loaded.velocity(body) == heap.world.velocity(body));
                REQUIRE(loaded.acceleration(body) == heap.world.acceleration(body));
            }
            heap.twin = &loaded;
            if (n % 2 == 0) heap.push();
            if (n % 7 == 3) heap.exchange();
            heap.twin = nullptr;
            REQUIRE(loaded.hash() == heap.world.hash());
            const auto dt = lengths[n % lengths.size()] * second;
            heap.world.step(dt);
            loaded.step(dt);
            REQUIRE(loaded.hash() == heap.world.hash());
            REQUIRE(loaded.contacts().size() == heap.world.contacts().size());
        }
    }
}

} // namespace

TEST_CASE("I19: a world that is saved goes on to the same bits where springs pull at those that may come to touch",
          "[collision][restart]") {
    check_restarts(SemiImplicitEuler{}, Springs{}, SoftSubsteps<>{});
    check_restarts(Space<float, 2>{}, Verlet{}, Springs{}, SoftSubsteps<Friction>{});
    check_restarts(VelocityVerlet{}, Springs{}, SoftSubsteps<Coloured, Friction>{});
}

TEST_CASE("I19: a world that is saved goes on to the same bits where a change waits to be made good",
          "[collision][restart]") {
    const Penalty soft{2e3 * newton_per_metre, 20.0 * newton_second_per_metre};
    check_restarts(Space<float, 2>{}, Verlet{}, soft);
    check_restarts(Verlet{}, Springs{}, soft);
}

namespace {
/// A filter with a parameter.
struct Some {
    bool pass = true;
    using role = roles::Filter;
    using reads = Columns<>;
    template <class S> struct In {
        bool pass;
        explicit In(const Some& some) : pass(some.pass) {}
        bool passes(const auto&, const auto&) const { return pass; }
    };
};
} // namespace

TEST_CASE("what a body lies on pushes it no longer, and its velocity is what it was", "[collision][restart]") {
    const Penalty soft{2e3 * newton_per_metre, 20.0 * newton_second_per_metre};
    World world{Verlet{}, Some{}, soft, Gravity{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{}};
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 0.45, 0)),
                                velocity(metres_per_second(0, -1, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 2; ++i) world.step(0.01 * second);
    REQUIRE(world.contacts().size() == 1);
    REQUIRE(world.acceleration(ball).value()[1] > 10);
    const double before = world.velocity(ball).value()[1];
    world.set(Some{false});
    CHECK(abs(world.velocity(ball).value()[1] - before) <= 1e-12);
    world.step(0.01 * second); // Verlet with gravity alone
    CHECK(abs(world.velocity(ball).value()[1] - (before - 0.01 * 9.81)) <= 1e-12);
}

namespace {
/// Two balls in each other, and two on dampers beside them that touch nothing at first.
template <class... P> void check_momentum(double tolerance, P... policies) {
    World world{policies..., Gravity{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{}};
    using S = typename decltype(world)::S;
    std::vector<Handle> balls;
    for (const double y : {0.0, 0.3, 1.8, 4.8})
        balls.push_back(world.add(Sphere{0.5 * metre}, position(vector_in<S, unit::Length>(0, y)),
                                  velocity(vector_in<S, unit::Velocity>(0.1 * y, 0)), mass((1.0 + y) * kilogram)));
    for (std::size_t i = 0; i < 4; ++i)
        world.add(Spring{balls[i], balls[(i + 2) % 4], 3.0 * newton_per_metre, 1.0 * newton_second_per_metre});
    for (int n = 0; n < 50; ++n) {
        const auto before = total_momentum(world).value();
        const auto dt = (n % 5 == 0 ? 0.02 : 0.01) * second;
        world.step(dt);
        auto gained = total_momentum(world).value();
        gained -= before;
        gained[1] += typename S::Scalar(10.9 * 9.81 * dt.value());
        INFO("step " << n);
        REQUIRE(double(gained.norm()) <= tolerance);
    }
}
} // namespace

TEST_CASE("momentum is kept where contacts give some bodies a velocity and dampers pull at others, under Verlet",
          "[collision][restart]") {
    check_momentum(1e-11, Verlet{}, Springs{}, SoftSubsteps<>{});
    check_momentum(1e-12, Verlet{}, Springs{}, Impulse{}, Projection{});
}

namespace {
/// A fast ball that another stops or takes along, on a damper, with a third ball on a spring.
template <class... P> void check_momentum_of_fast(double z, double speed, double tolerance, P... policies) {
    World world{policies..., Springs<>{}, SortAndSweep{}, Swept<Narrowphase<Sphere, Plane, Box>>{}};
    using S = typename decltype(world)::S;
    const auto ball = [&](double radius, double along, double v, double m) {
        return world.add(Sphere{radius * metre}, position(vector_in<S, unit::Length>(0, along)),
                         velocity(vector_in<S, unit::Velocity>(0, v)), mass(m * kilogram));
    };
    const auto slow = ball(1, 0, 0, 1), fast = ball(0.5, z, speed, 2), third = ball(0.5, 5, 1, 3);
    world.add(Spring{fast, slow, 0.0 * newton_per_metre, 1.0 * newton_second_per_metre});
    world.add(Spring{third, fast, 3.0 * newton_per_metre, 1.0 * newton_second_per_metre});
    for (int n = 0; n < 10; ++n) {
        const auto before = total_momentum(world).value();
        world.step((n % 5 == 0 ? 0.02 : 0.01) * second);
        INFO("from " << z << " m at " << speed << " m/s, step " << n);
        REQUIRE(double((total_momentum(world).value() - before).norm()) <= tolerance * speed);
    }
}
} // namespace

TEST_CASE("momentum is kept where a body is stopped on its way and dampers pull at others, under Verlet",
          "[collision][restart]") {
    // Found by the fuzzer: a slow body that was met kept its history, and the damper pulled half a step less at it.
    for (const double z : {-1.0, -1.4, -1.6, -2.0})
        for (const double speed : {30.0, 60.0, 200.0}) {
            check_momentum_of_fast(z, speed, 1e-12, Verlet{}, Impulse<>{});
            check_momentum_of_fast(z, speed, 1e-12, Verlet{}, Impulse<>{}, Projection{});
            check_momentum_of_fast(z, speed, 1e-12, Verlet{}, SoftSubsteps<>{});
            check_momentum_of_fast(z, speed, 1e-12, VelocityVerlet{}, Impulse<>{});
            check_momentum_of_fast(z, speed, 1e-12, Space<double, 2>{}, Verlet{}, Impulse<>{});
            check_momentum_of_fast(z, speed, 1e-4, Space<float, 3>{}, Verlet{}, Impulse<>{});
        }
}

TEST_CASE("a sleeper without a shape is saved with what pulled at it", "[collision][restart]") {
    const World empty{SemiImplicitEuler{}, Gravity{}, Springs{}, Rest{}, AllPairs{}, Narrowphase<Sphere>{}, Impulse{}};
    auto world = empty;
    const auto bob = world.add(shapeless, position(metres(0, -1, 0)), mass(1.0 * kilogram));
    world.add(
        Spring{bob, metres(0, 0, 0), 9.81 / 0.001 * newton_per_metre, 30.0 * newton_second_per_metre, 0.999 * metre});
    for (int n = 0; n < 200; ++n) world.step(0.01 * second);
    REQUIRE(world.motion(bob) == Motion::resting);
    std::stringstream file;
    save(world, file);
    auto loaded = empty;
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    for (auto* one : {&world, &loaded}) one->wake(bob), one->step(0.01 * second);
    CHECK(loaded.hash() == world.hash());
}
