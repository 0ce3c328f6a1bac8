// SPDX-License-Identifier: BSL-1.0
// What lies on a soft surface: it sinks, floats or bounces; forces against their energy, against closed forms, as a
// part of a world's value, and what is refused.
// Runs long with the sanitizers.

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/water/surface_contacts.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/before_allocation.hpp"
#include "tests/water/support.hpp"

#include <sstream>

using namespace water_tests;

namespace {

constexpr double g = 9.81;
std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}
SurfaceSpring spring(double k, double c, double breaks_at = 3) {
    return {k * newton_per_metre, c * newton_second_per_metre, breaks_at * metre};
}
template <class I> using On = World<I, Gravity, Springs<>, SurfaceContacts>;

/// A pond of 6 m by 6 m, a bed 4 m below it, and things on it.
template <class I> struct Scene {
    struct Thing {
        Handle body;
        SurfaceContactHandle on, bed;
    };
    On<I> world{{}, {}, {}, {}};
    SoftSurfaceParts pond{ColumnGrid(3, 3, 2.0 * metre), {}, {}, {}}, bed = pond;
    std::vector<Thing> things;

    explicit Scene(double gamma = 10, double tension = 2000) {
        pond = add_soft_surface(world, {.grid = ColumnGrid(24, 24, 0.25 * metre),
                                        .mass_per_area = 50.0 * kilogram / square_metre,
                                        .tension = tension * newton_per_metre,
                                        .damping = gamma / second});
        for (int n = 0; n < 9; ++n)
            bed.bodies.push_back(world.add(position(metres(2 * (n % 3) + 1, -4, 1 + 2 * (n / 3))), fixed));
    }
    const Thing& put(double x, double y, double z, double kilograms, const SurfaceSpring& by) {
        const auto body = world.add(position(metres(x, y, z)), mass(kilograms * kilogram));
        const auto on = world.add(SurfaceContact::of(pond, body, by, 0.3 * metre));
        const auto floor = world.add(SurfaceContact::of(bed, body, spring(20000, 3000), 0.3 * metre));
        things.push_back({body, on, floor});
        return things.back();
    }
    void stone_raft_and_ball() {
        put(1.5, 0.6, 1.5, 60, spring(800, 100, 0.6));
        put(4.5, 0.35, 4.5, 20, spring(700, 60, 0.6));
        put(3, 1.2, 3, 10, spring(300, 1));
    }
    auto touch(std::size_t n) const { return surface_touch(world, things[n].on); }
};

/// What a minute of the three did.
struct Minute {
    double rise = 0, energy = 0, least_gap = 99, leap = 0;
    std::vector<double> landings;
    bool ok = true, sunk = false, floats = true, fell_through = false;
};
template <class I> Minute minute(int rate) {
    Scene<I> scene;
    scene.stone_raft_and_ball();
    auto& world = scene.world;
    Minute all;
    all.energy = total_energy(world).value();
    double least = all.energy;
    std::vector<std::uint64_t> begun(6);
    std::vector<double> last(6, -9);
    for (int step = 1; step <= 60 * rate; ++step) {
        world.step(1.0 / rate * second);
        const double energy = total_energy(world).value(), time = double(step) / rate;
        all.rise = std::max(all.rise, energy - least);
        least = std::min(least, energy);
        for (std::size_t n = 0; n < 6; ++n) {
            const auto now = surface_touch(world, n < 3 ? scene.things[n].on : scene.things[n - 3].bed);
            if (now.begun == begun[n]) continue;
            all.least_gap = std::min(all.least_gap, time - last[n]);
            if (n == 2) all.landings.push_back(time);
            begun[n] = now.begun;
            last[n] = time;
        }
        if (time > 5) all.floats = all.floats && scene.touch(1).touches;
        if (time > 2) all.leap = std::max(all.leap, y(world.position(scene.things[2].body)).value());
        all.fell_through = all.fell_through || scene.touch(1).broken || scene.touch(2).broken;
    }
    all.ok = world.status().ok() && is_finite(total_energy(world));
    const double stone = y(world.position(scene.things[0].body)).value();
    all.sunk = scene.touch(0).broken && std::abs(stone + 3.7 + 60 * g / 20000) < 1e-6;
    all.energy -= least;
    return all;
}

} // namespace

TEST_CASE(
    "one sinks, one floats, one bounces: no contact begins twice in a second, no energy from nothing (hard case W17)",
    "[water]") {
    auto held = [](const Minute& all) {
        CHECK(all.ok);
        CHECK(all.sunk);
        CHECK(all.floats);
        CHECK_FALSE(all.fell_through);
        CHECK(all.landings.size() > 8);
        CHECK(all.leap > 0.6);
        CHECK(all.least_gap > 1.0);
        CHECK(all.least_gap > 2 * pi * std::sqrt(10.0 / 300)); // the law of the header
    };
    const auto coarse = minute<VelocityVerlet>(60), fine = minute<VelocityVerlet>(120);
    held(coarse);
    held(fine);
    held(minute<SemiImplicitEuler>(60));
    CHECK(fine.energy > 2000); // J, lost by what is damped; no step of any of them adds to it
    CHECK(fine.rise < 1e-12 * fine.energy + 1e-9);
    CHECK(coarse.rise < 1e-12 * coarse.energy + 1e-9);
}
TEST_CASE("without damping a ball and the waves that it makes keep their energy, to the order of the scheme",
          "[water]") {
    auto drift = [](int rate) {
        Scene<VelocityVerlet> scene(0);
        scene.put(2.9, 0.8, 3.2, 10, spring(300, 0));
        const double before = total_energy(scene.world).value();
        double most = 0;
        for (int i = 0; i < 4 * rate; ++i) {
            scene.world.step(1.0 / rate * second);
            most = std::max(most, std::abs(total_energy(scene.world).value() - before));
        }
        CHECK(scene.touch(0).begun >= 2);
        return most;
    };
    const double coarse = drift(120), fine = drift(240);
    CHECK(coarse < 0.5); // J; the ball fell with 49
    CHECK(coarse / fine == Approx(4).epsilon(0.25));
}
TEST_CASE("what floats displaces its mass, and hangs in its spring by its weight", "[water]") {
    Scene<SemiImplicitEuler> scene(10, 0);
    scene.put(3, 0.4, 3, 20, spring(700, 200));
    for (int i = 0; i < 3000; ++i) scene.world.step(0.01 * second);
    double displaced = 0;
    for (const auto& column : scene.pond.bodies) displaced -= y(scene.world.position(column)).value() * 0.25 * 0.25;
    CHECK(displaced == Approx(20.0 / 1000).epsilon(1e-9));
    CHECK(scene.touch(0).depth.value() == Approx(20 * g / 700).epsilon(1e-9));
    CHECK(scene.touch(0).push.value() == Approx(20 * g).epsilon(1e-9));
    CHECK(scene.touch(0).begun == 1);
}
TEST_CASE("thrown up by a surface that stands still, a ball lands when its closed form says", "[water]") {
    for (const double fall : {0.02, 0.3, 2.0}) {
        World<RungeKutta4, Gravity, SurfaceContacts> world{{}, {}, {}};
        SoftSurfaceParts still{ColumnGrid(3, 3, 1.0 * metre), {}, {}, {}};
        for (int n = 0; n < 9; ++n)
            still.bodies.push_back(world.add(position(metres(n % 3 + 0.5, 2, n / 3 + 0.5)), fixed));
        const auto ball = world.add(position(metres(1.3, 2 + fall, 1.6)), mass(2.0 * kilogram));
        const auto on = world.add(SurfaceContact::of(still, ball, spring(50, 0)));
        std::vector<double> landings;
        for (int i = 1; i <= 6000; ++i) {
            const auto before = surface_touch(world, on).begun;
            world.step(1e-3 * second);
            if (surface_touch(world, on).begun != before) landings.push_back(1e-3 * i);
        }
        const double v = std::sqrt(2 * g * fall), omega = std::sqrt(50 / 2.0);
        // The skin of a centimetre does not end the contact of a body that leaps less high.
        const double swing = (pi + 2 * std::atan(g / (omega * v))) / omega, period = 2 * v / g + swing;
        REQUIRE(landings.size() >= 2);
        CHECK(period > 2 * pi / omega);
        for (std::size_t n = 1; n < landings.size(); ++n)
            CHECK(landings[n] - landings[n - 1] == Approx(period).margin(1.1e-3));
        CHECK(landings[0] == Approx(v / g).margin(1.1e-3));
    }
}
TEST_CASE("forces are those of the energy, over any surface and up to its border", "[water]") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 1);
    for (int trial = 0; trial < 20; ++trial) {
        World<VelocityVerlet, SurfaceContacts> world{{}, {}};
        SoftSurfaceParts some{ColumnGrid(6, 5, 0.4 * metre, 0.5 * metre).at(-1.0 * metre, 2.0 * metre), {}, {}, {}};
        for (int n = 0; n < 30; ++n)
            some.bodies.push_back(
                world.add(position(metres(-0.8 + 0.4 * (n % 6), 0.3 * part(random), 2.25 + 0.5 * (n / 6))),
                          mass(3.0 * kilogram)));
        const auto body =
            world.add(position(metres(-1 + 2.4 * part(random), -0.2, 2 + 2.5 * part(random))), mass(2.0 * kilogram));
        world.add(SurfaceContact::of(some, body, spring(70, 0), (0.2 + part(random)) * metre));
        double sum = 0;
        auto energy_at = [&](Handle which, const Vector<double, 3>& at) {
            auto other = world;
            other.set_position(which, metres(at[0], at[1], at[2]));
            return total_energy(other).value();
        };
        auto force = [&](Handle which, int axis) {
            Vector<double, 3> at = world.position(which).value(), step = Vector<double, 3>::Zero();
            step[axis] = 1e-6;
            return (energy_at(which, at - step) - energy_at(which, at + step)) / 2e-6;
        };
        const auto pushed = world.acceleration(body).value();
        for (int axis = 0; axis < 3; ++axis) REQUIRE(2 * pushed[axis] == Approx(force(body, axis)).margin(1e-6));
        for (const auto& column : some.bodies) {
            const auto a = world.acceleration(column).value();
            REQUIRE(3 * a[1] == Approx(force(column, 1)).margin(1e-6));
            REQUIRE(a[0] == 0);
            sum += 3 * a[1];
        }
        REQUIRE(sum == Approx(-2 * pushed[1]).epsilon(1e-12));
        REQUIRE(pushed[1] > 1);
    }
}
TEST_CASE("a level surface pushes straight up wherever a body stands on it, and not beside it", "[water]") {
    World<VelocityVerlet, SurfaceContacts> world{{}, {}};
    SoftSurfaceParts level{ColumnGrid(8, 3, 0.5 * metre), {}, {}, {}};
    for (int n = 0; n < 24; ++n)
        level.bodies.push_back(world.add(position(metres(0.5 * (n % 8) + 0.25, 1, 0.5 * (n / 8) + 0.25)), fixed));
    const auto body = world.add(position(metres(1, 0.9, 1)), mass(2.0 * kilogram));
    const auto on = world.add(SurfaceContact::of(level, body, spring(100, 0), 0.25 * metre));
    for (double x = -0.5; x < 4.6; x += 0.0371)
        for (const double z : {-0.1, 0.01, 0.8, 1.49, 1.6}) {
            world.set_position(body, metres(x, 0.9, z));
            const bool there = x > 0 && x < 4 && z > 0 && z < 1.5;
            const auto a = world.acceleration(body).value();
            REQUIRE(a[1] == Approx(there ? 100 * 0.35 / 2 : 0.0).epsilon(1e-12));
            REQUIRE(a[0] == 0);
            REQUIRE(a[2] == 0);
            REQUIRE(surface_touch(world, on).push.value() == Approx(2 * a[1]));
        }
}
TEST_CASE("what is pulled too deep breaks its spring, and the surface is free", "[water]") {
    Scene<SemiImplicitEuler> scene;
    const auto stone = scene.put(3, 0.4, 3, 60, spring(800, 100, 0.5));
    const double before = y(scene.world.position(scene.pond.bodies[12 * 24 + 12])).value();
    double lowest = 0;
    for (int i = 0; i < 1000; ++i) {
        scene.world.step(0.01 * second);
        lowest = std::min(lowest, y(scene.world.position(scene.pond.bodies[12 * 24 + 12])).value());
    }
    CHECK(lowest < before - 0.03);
    CHECK(scene.touch(0).broken);
    CHECK_FALSE(scene.touch(0).touches);
    CHECK(y(scene.world.position(scene.pond.bodies[12 * 24 + 12])).value() == Approx(before).margin(1e-6));
    // It has nothing to do with the columns any more: they may go, and it stays.
    scene.world.remove(scene.pond.bodies[0]);
    CHECK(scene.world.contains(stone.on));
}
TEMPLATE_TEST_CASE("contacts of a soft surface are a part of the world's value", "[water]", SemiImplicitEuler,
                   ImplicitEuler) {
    Scene<TestType> scene;
    scene.stone_raft_and_ball();
    auto& world = scene.world;
    for (int i = 0; i < 40; ++i) world.step(0.01 * second);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    On<TestType> loaded{{}, {}, {}, {}};
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    for (auto* one : {&world, &copy, &loaded})
        for (int i = 0; i < 40; ++i) one->step(0.01 * second);
    CHECK(copy.hash() == world.hash());
    CHECK(loaded.hash() == world.hash());
    CHECK(world.status().unsolved == 0);
    CHECK(scene.touch(0).broken); // between the file and here
    CHECK(scene.touch(1).begun == 1);
    const auto described = world.get(scene.things[1].on);
    CHECK(described.grid == scene.pond.grid);
    CHECK(described.columns == scene.pond.bodies);
    if constexpr (std::same_as<TestType, SemiImplicitEuler>) {
        allocations = 0;
        ansatz::test::before_allocation = count;
        for (int i = 0; i < 50; ++i) world.step(0.01 * second);
        ansatz::test::before_allocation = nullptr;
        CHECK(allocations == 0);
        auto other = described;
        other.spring.breaks_at = 0.61 * metre;
        const auto hash = world.hash();
        world.set(scene.things[1].on, other);
        CHECK(world.hash() != hash);
        // The surface goes with any of its columns, and its contacts with it.
        world.remove(scene.pond.bodies[100]);
        CHECK_FALSE(world.contains(scene.things[1].on));
        CHECK(world.contains(scene.things[1].bed));
    }
}
TEST_CASE("an integrator that solves finds the same rest, with a step that no other takes", "[water]") {
    Scene<ImplicitEuler> scene;
    scene.put(3, 0.4, 3, 20, spring(700, 60));
    for (int i = 0; i < 400; ++i) scene.world.step(0.1 * second);
    CHECK(scene.world.status().unsolved == 0);
    CHECK(scene.touch(0).depth.value() == Approx(20 * g / 700).epsilon(1e-6));
    // The step that an explicit one takes is no longer than the springs of the net allow, and shorter with a stiff
    // body.
    Scene<SemiImplicitEuler> soft, stiff;
    soft.put(3, 0, 3, 20, spring(700, 60));
    stiff.put(3, 0, 3, 0.1, spring(7000, 0));
    CHECK(stable_step(stiff.world) < 0.5 * stable_step(soft.world));
}
TEST_CASE("in float and in two dimensions a boat floats on a channel", "[water]") {
    World<Space<float, 2>, SemiImplicitEuler, Gravity, Springs<>, SurfaceContacts> world{{}, {}, {}, {}, {}};
    const auto pond = add_soft_surface(world, {.grid = ColumnGrid(40, 1, 0.25 * metre, 2.0 * metre),
                                               .mass_per_area = 50.0 * kilogram / square_metre,
                                               .tension = 500.0 * newton_per_metre,
                                               .damping = 10.0 / second});
    const auto boat = world.add(position(metres(5.1, 0.3)), mass(30.0 * kilogram));
    const auto on = world.add(SurfaceContact::of(pond, boat, spring(600, 100), 0.5 * metre));
    for (int i = 0; i < 2000; ++i) world.step(0.01 * second);
    CHECK(double(surface_touch(world, on).depth.value()) == Approx(30 * g / 600).epsilon(1e-4));
    CHECK(surface_touch(world, on).begun == 1);
    CHECK(world.status().ok());
}
TEST_CASE("what a contact with a soft surface cannot be is refused, and the world is as it was", "[water]") {
    Scene<SemiImplicitEuler> scene;
    auto& world = scene.world;
    const auto ball = world.add(position(metres(3, 1, 3)), mass(1.0 * kilogram));
    const auto hash = world.hash();
    auto said = [&](auto&& change) {
        auto one = SurfaceContact::of(scene.pond, ball, spring(100, 1), 0.1 * metre);
        change(one);
        const auto text = refusal([&] { world.add(one); });
        CHECK(world.hash() == hash);
        return text;
    };
    auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    CHECK(has(said([](auto& c) { c.spring.stiffness = 0.0 * newton_per_metre; }), "stiffness is 0"));
    CHECK(has(said([](auto& c) { c.spring.damping = -1.0 * newton_second_per_metre; }), "damping is -1"));
    CHECK(has(said([](auto& c) { c.spring.breaks_at = not_a_number * metre; }), "breaks_at is nan"));
    CHECK(has(said([](auto& c) { c.radius = -0.1 * metre; }), "radius is -0.1 m"));
    CHECK(has(said([](auto& c) { c.columns.pop_back(); }), "one for each of the 576 columns"));
    CHECK(has(said([](auto& c) { c.columns[3] = c.columns[4]; }), "twice"));
    CHECK(has(said([](auto& c) { c.columns[3] = c.body; }), "twice"));
    CHECK(has(said([](auto& c) { c.grid = ColumnGrid(widths(24, 1), widths(24, 2)); }), "all alike"));
    CHECK(has(refusal([&] { world.set(SurfaceContacts{.skin = -1.0 * metre}); }), "skin is -1 m"));
    CHECK(has(refusal([&] { surface_touch(world, SurfaceContactHandle{}); }), "surface_touch"));
    // From a file: BodyId() names no body.
    scene.stone_raft_and_ball();
    const auto& row = std::as_const(world).elements<SurfaceContact>().row(scene.things[0].on.id);
    CHECK_NOTHROW(row.check());
    auto other = row;
    other.body = BodyId();
    CHECK(has(refusal([&] { other.check(); }), "nobody"));
    other = row;
    other.columns[7] = BodyId();
    CHECK(has(refusal([&] { other.check(); }), "nobody"));
}
