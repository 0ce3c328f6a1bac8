// SPDX-License-Identifier: BSL-1.0
// Floating bodies as a part of a world: a value under every integrator, any order of verbs, sleep, drift, float and two
// dimensions, and what is refused.

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/water.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/before_allocation.hpp"
#include "tests/water/support.hpp"

#include <sstream>

using namespace water_tests;

namespace {

constexpr double g = 9.81;
const Sphere ball{0.5 * metre};
const Box cube{metres(0.5, 0.5, 0.5)};
const WaterColumns calm{3.0 * mps, 0.5 / second};
const SurfaceSpring hook{300.0 * newton_per_metre, 20.0 * newton_second_per_metre, 0.6 * metre};
ColumnGrid pond() { return ColumnGrid(20, 20, 0.5 * metre); }

std::size_t allocations = 0;
bool count(std::size_t) noexcept {
    ++allocations;
    return true;
}

/// One of each kind in one pool.
template <class W> struct Scene {
    W world;
    PoolHandle<Pipes> pool;
    std::vector<Handle> bodies;
    std::vector<FloatingHandle> floating;
    explicit Scene(W w) : world(std::move(w)) {
        pool = world.add(Pool{Surface{Pipes{9.81 * metre_per_second_squared, 0.3 / second}, pond(), 2.0 * metre}});
        float_one(ball, 2, 2.3, 3, 300);
        float_one(cube, 6, 2.4, 6, 500);
        float_one(FixedLift{4.0 * metre_per_second_squared}, 8, 3, 2, 20);
        float_one(hook, 3, 1.9, 8, 15);
    }
    template <class By> void float_one(const By& by, double x, double y, double z, double kilograms) {
        const auto body =
            world.add(position(metres(x, y, z)), velocity(metres_per_second(0.3, 0, 0.1)), mass(kilograms * kilogram));
        bodies.push_back(body);
        floating.push_back(world.add(Floating{body, by, 0.3, 0.4 / second}));
    }
    double water() const { return world.water(pool).volume().value(); }
};
template <class I> using Under = World<I, Gravity, Pools<Pipes>, Buoyancy>;
template <class I> Scene<Under<I>> scene() { return Scene<Under<I>>(Under<I>(I{}, {}, {}, {})); }

} // namespace

TEMPLATE_TEST_CASE("copies and loaded worlds go on to the same bits", "[water]", SemiImplicitEuler, Verlet,
                   VelocityVerlet, RungeKutta4, ImplicitEuler) {
    auto one = scene<TestType>();
    for (int i = 0; i < 25; ++i) one.world.step(0.02 * second);
    auto copy = one.world;
    std::stringstream file;
    save(one.world, file);
    Under<TestType> loaded(TestType{}, {}, {}, {});
    load(loaded, file);
    CHECK(loaded.hash() == one.world.hash());
    for (auto* world : {&one.world, &copy, &loaded})
        for (int i = 0; i < 25; ++i) world->step(0.02 * second);
    CHECK(copy.hash() == one.world.hash());
    CHECK(loaded.hash() == one.world.hash());
    CHECK(one.water() == Approx(200).epsilon(1e-13));
    CHECK(one.world.status().ok());
    if constexpr (std::same_as<TestType, VelocityVerlet>) {
        allocations = 0;
        ansatz::test::before_allocation = count;
        for (int i = 0; i < 25; ++i) one.world.step(0.02 * second);
        ansatz::test::before_allocation = nullptr;
        CHECK(allocations == 0);
        // Any number of a row is a part of the hash.
        const auto hash = one.world.hash();
        const auto described = one.world.get(one.floating[3]);
        CHECK(std::get<SurfaceSpring>(described.by).breaks_at == 0.6 * metre);
        auto other = described;
        other.drag = 0.31;
        one.world.set(one.floating[3], other);
        CHECK(one.world.hash() != hash);
    }
}
TEST_CASE("integrators agree on how a ball floats, to their order", "[water]") {
    auto after = []<class I>(I, int steps) {
        auto one = scene<I>();
        for (int i = 0; i < steps; ++i) one.world.step(0.5 / steps * second);
        return one.world.position(one.bodies[0]).value()[1];
    };
    const double fine = after(RungeKutta4{}, 800);
    CHECK(after(VelocityVerlet{}, 200) == Approx(fine).margin(2e-3));
    CHECK(after(ImplicitEuler{}, 400) == Approx(fine).margin(1e-2));
    CHECK(after(SemiImplicitEuler{}, 400) == Approx(fine).margin(5e-3));
}
TEST_CASE("an integrator that solves meets a drag that stops a body within a step", "[water]") {
    Under<ImplicitEuler> world{{}, {}, {}, {}};
    const auto pool = world.add(Pool{Surface{Pipes{}, pond(), 2.0 * metre}});
    const auto light = world.add(position(metres(3, 1.6, 5)), mass(100 * pi / 6 * kilogram));
    world.add(Floating{light, ball, 0, 30.0 / second, false}); // c dt / m is 5 under water
    const auto hung = world.add(position(metres(7, 1.9, 5)), mass(0.1 * kilogram));
    const SurfaceSpring spring{20.0 * newton_per_metre, 30.0 * newton_second_per_metre, 1.0 * metre}; // and 5 here
    world.add(Floating{hung, spring, 0, 0.0 / second, false});
    world.set_velocity(light, metres_per_second(2, 0, 0));
    world.set_velocity(hung, metres_per_second(0.2, 0, 0));
    for (int i = 0; i < 300; ++i) world.step(1.0 / 60 * second);
    CHECK(world.status().unsolved == 0);
    CHECK(world.velocity(light).value().norm() < 1e-3);
    CHECK(world.velocity(hung).value()[0] == Approx(0.2).epsilon(1e-9)); // nothing holds it along the surface
    CHECK(world.water(pool).volume().value() == Approx(200).epsilon(1e-12));
}
TEST_CASE("any order of verbs keeps the water, and handles name the bodies that they named", "[water]") {
    std::mt19937 random(11);
    auto one = scene<SemiImplicitEuler>();
    auto& world = one.world;
    auto chance = [&](int n) { return int(random() % unsigned(n)); };
    double poured = 200;
    for (int k = 0; k < 1500; ++k) {
        const double x = 0.01 * chance(1200) - 1, z = 0.01 * chance(1200) - 1, y = 0.01 * chance(300);
        switch (chance(9)) {
        case 0:
            if (one.bodies.size() < 12) {
                if (chance(2)) one.float_one(ball, x, y, z, 10 + chance(500));
                else one.float_one(cube, x, y, z, 10 + chance(900));
            }
            break;
        case 1:
            if (one.bodies.size() > 2) {
                const auto i = std::size_t(chance(int(one.bodies.size())));
                world.remove(one.bodies[i]);
                CHECK_FALSE(world.contains(one.floating[i]));
                one.bodies.erase(one.bodies.begin() + int(i));
                one.floating.erase(one.floating.begin() + int(i));
            }
            break;
        case 2: world.set_position(one.bodies[std::size_t(chance(2))], metres(x, y, z)); break;
        case 3: world.set_mass(one.bodies[std::size_t(chance(2))], (1.0 + chance(900)) * kilogram); break;
        case 4:
            world.pour(one.pool, 5.0 * metre, 5.0 * metre, 0.02 * cubic_metre);
            poured += 0.02;
            break;
        default: world.step(0.01 * second);
        }
        for (const auto& handle : one.floating) REQUIRE(world.contains(handle));
        REQUIRE(one.water() == Approx(poured).epsilon(1e-12));
        REQUIRE(*std::min_element(world.water(one.pool).surface().heights().begin(),
                                  world.water(one.pool).surface().heights().end()) >= 0);
    }
    CHECK(world.status().ok());
    while (!one.bodies.empty()) {
        world.remove(one.bodies.back());
        one.bodies.pop_back();
    }
    for (int i = 0; i < 500; ++i) world.step(0.01 * second);
    CHECK(world.water(one.pool).displaced().value() == Approx(0).margin(1e-12));
}
TEST_CASE("what bobs by more than v_s / omega does not fall asleep; what lies still may (hard case B10)", "[water]") {
    using Sleepy = World<SemiImplicitEuler, Gravity, Pools<WaterColumns>, Buoyancy, Rest>;
    auto asleep_after_a_minute = [](double amplitude) {
        Sleepy world{{}, {}, {}, {}, {}};
        world.add(Pool{Surface{calm, pond(), 2.0 * metre}});
        const auto body = world.add(position(metres(5, 1.9 + amplitude, 5)), mass(600.0 * kilogram));
        world.add(Floating{body, cube, 0, 0.0 / second, false});
        for (int i = 0; i < 3600; ++i) world.step(1.0 / 60 * second);
        return world.motion(body) == Motion::resting;
    };
    const double may = 0.05 / std::sqrt(g / 0.6); // m
    for (const double more : {1.05, 1.2, 1.5, 2.0, 4.0}) CHECK_FALSE(asleep_after_a_minute(more * may));
    CHECK(asleep_after_a_minute(0));
    CHECK(asleep_after_a_minute(1e-5));
    // A wave wakes it, and two that float in one pool sleep and wake each by itself.
    Sleepy world{{}, {}, {}, {}, {}};
    const auto pool = world.add(Pool{Surface{calm, pond(), 2.0 * metre}});
    std::vector<Handle> both;
    for (const double lift : {0.0, 0.1}) {
        both.push_back(world.add(position(metres(3 + 40 * lift, 1.9 + lift, 5)), mass(600.0 * kilogram)));
        world.add(Floating{both.back(), cube, 0, 0.0 / second, false});
    }
    for (int i = 0; i < 120; ++i) world.step(1.0 / 60 * second);
    CHECK(world.motion(both[0]) == Motion::resting);
    CHECK(world.motion(both[1]) == Motion::awake);
    world.pour(pool, 5.0 * metre, 5.0 * metre, 0.2 * cubic_metre);
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    CHECK(world.motion(both[0]) == Motion::awake);
}
TEST_CASE("drag is against the water: what floats goes with the flow, and rides a wave", "[water][T19]") {
    auto carried = [](const auto& policy, bool flows) {
        using Policy = std::decay_t<decltype(policy)>;
        World world{SemiImplicitEuler{}, Gravity{}, Pools<Policy>{}, Buoyancy{}};
        Surface sea{policy, ColumnGrid(100, 1, 0.2 * metre, 2.0 * metre), 1.0 * metre};
        for (std::size_t i = 0; i < 25 && flows; ++i) sea.set_height(i, 0, 1.5 * metre);
        const auto pool = world.add(Pool{sea});
        const auto body = world.add(position(metres(9, 0.99, 1)), mass(20.0 * kilogram));
        const auto floating = world.add(Floating{body, Sphere{0.2 * metre}, 0, 20.0 / second, false});
        double with_it = 0, level = 0, above = 0;
        for (int i = 0; i < 200; ++i) {
            world.step(0.01 * second);
            const auto now = world.afloat(floating);
            const double u = x(now.flow).value(), v = x(world.velocity(body)).value();
            if (i > 150) with_it = std::max(with_it, std::abs(v - u));
            level = std::max(level, now.level.value());
            above = std::max(above, std::abs(world.position(body).value()[1] - now.level.value()));
        }
        CHECK(world.status().ok());
        CHECK(world.water(pool).volume().value() == Approx(sea.volume().value()).epsilon(1e-12));
        if (flows) CHECK(level > 1.15);
        CHECK(with_it < 0.15);
        CHECK(above < 0.2); // it rides up with the wave, by its own radius at most
        return world.position(body).value()[0] - 9;
    };
    CHECK(carried(Pipes{}, true) > 0.3);
    CHECK(carried(ShallowWater{}, true) > 0.3);
    CHECK(carried(Pipes{}, false) == 0);
    CHECK(carried(ShallowWater{}, false) == 0);
}
TEST_CASE("the surface's rise is that of the next step, whatever moves it", "[water]") {
    auto differs = [](const auto& policy) {
        Surface sea{policy, unequal(9, 7), 1.0 * metre};
        set_heights(sea, [](double x, double z) { return 1 + 0.05 * std::sin(x) * std::cos(0.7 * z); });
        for (int i = 0; i < 30; ++i) sea.step(0.01 * second);
        const auto before = sea;
        sea.step(1e-4 * second);
        double most = 0, largest = 0;
        for (std::size_t n = 0; n < sea.heights().size(); ++n) {
            const double rate = (sea.heights()[n] - before.heights()[n]) / 1e-4;
            most = std::max(most, std::abs(detail::rise_of(before, n, n % 9, n / 9) - rate));
            largest = std::max(largest, std::abs(rate));
        }
        return most / largest;
    };
    CHECK(differs(WaterColumns{3.0 * mps}) < 1e-2);
    CHECK(differs(Pipes{}) < 1e-2);
    CHECK(differs(ShallowWater{}) < 0.5); // fluxes of first order, against central differences
}
TEST_CASE("what moves by itself makes a wake, and what stands still displaces", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}, Buoyancy{}};
    const auto pool = world.add(Pool{Surface{WaterColumns{3.0 * mps}, pond(), 2.0 * metre}});
    const auto pier = world.add(position(metres(2, 2, 2)), fixed);
    world.add(Floating{pier, cube});
    const auto hull = world.add(position(metres(3, 2, 7)), velocity(metres_per_second(2, 0, 0)), moving);
    world.add(Floating{hull, ball});
    world.step(0.01 * second);
    const double both = 0.5 + 2.0 / 3 * pi * 0.125; // m^3 at the level of before; around them it has risen at once
    CHECK(world.water(pool).displaced().value() > both);
    CHECK(world.water(pool).displaced().value() < 1.1 * both);
    for (int i = 0; i < 200; ++i) world.step(0.01 * second);
    CHECK(world.water(pool).volume().value() == Approx(200).epsilon(1e-12));
    CHECK(world.position(hull).value()[0] == Approx(7.02));
    CHECK(world.position(pier).value() == Vector<double, 3>(2, 2, 2));
}
TEST_CASE("in float, in two dimensions: a disc settles at its draft, and the channel's volume stays", "[water]") {
    using Flat = World<Space<float, 2>, SemiImplicitEuler, Gravity, Pools<WaterColumns>, Buoyancy>;
    Flat world{{}, {}, {}, {}, {}};
    const auto pool = world.add(Pool{Surface{calm, ColumnGrid(80, 1, 0.25 * metre, 2.0 * metre), 2.0 * metre}});
    const auto disc = world.add(position(metres(10, 2.3)), mass(500 * pi * 0.25 * 2.0 * kilogram)); // half of 2 m
    const auto rectangle = world.add(position(metres(4, 2.3)), mass(600.0 * kilogram));
    const auto first = world.add(Floating{disc, ball, 0, 2.0 / second});
    const auto second_ = world.add(Floating{rectangle, Box{metres(0.5, 0.5)}, 0, 2.0 / second});
    double farthest = 0;
    for (int i = 0; i < 10000; ++i) {
        world.step(1.0 / 60 * second);
        farthest = std::max(farthest, std::abs(double(world.water(pool).volume().value()) / 80 - 1));
    }
    CHECK(farthest < 1e-5);
    CHECK(world.afloat(first).submerged.value() == Approx(pi * 0.25).epsilon(1e-4));
    CHECK(world.afloat(first).level.value() - world.position(disc).value()[1] == Approx(0).margin(2e-3));
    CHECK(world.afloat(second_).submerged.value() == Approx(0.6).epsilon(1e-3));
    CHECK(world.afloat(first).level.value() == Approx(2 + (pi * 0.25 + 0.6) / 40).epsilon(1e-4));
    // What a float cannot hold is refused by its name, and is not infinite in a step.
    const auto hash = world.hash();
    auto said = [&](const Floating& floating) { return refusal([&] { world.add(floating); }); };
    CHECK(said({disc, ball, 1e39}).find("drag is 1e+39") != std::string::npos);
    CHECK(said({disc, ball, 0, 1e39 / second}).find("damping is 1e+39") != std::string::npos);
    CHECK(said({disc, FixedLift{1e39 * metre_per_second_squared}}).find("acceleration is 1e+39") != std::string::npos);
    const auto k = 1.0 * newton_per_metre;
    const auto c = 1e39 * newton_second_per_metre;
    CHECK(said({disc, SurfaceSpring{1e39 * k, c, 1.0 * metre}}).find("stiffness is 1e+39") != std::string::npos);
    CHECK(said({disc, SurfaceSpring{k, c, 1.0 * metre}}).find("damping is 1e+39") != std::string::npos);
    CHECK(said({disc, SurfaceSpring{k, 0.0 * c, 1e39 * metre}}).find("breaks_at is 1e+39") != std::string::npos);
    CHECK(world.hash() == hash);
    // The same numbers in a file.
    detail::FloatingRow<Flat::S> row;
    row.body = {0};
    row.size[0] = 1;
    CHECK_NOTHROW(row.check());
    for (float detail::FloatingRow<Flat::S>::*number :
         {&detail::FloatingRow<Flat::S>::drag, &detail::FloatingRow<Flat::S>::damping,
          &detail::FloatingRow<Flat::S>::displaced})
        for (const float bad : {-1.0f, HUGE_VALF, float(not_a_number)}) {
            auto other = row;
            other.*number = bad;
            CHECK(refusal([&] { other.check(); }).find("it must be finite") != std::string::npos);
        }
}
TEST_CASE("at a shore a body floats on what water there is, and lies dry where there is none", "[water]") {
    World world{SemiImplicitEuler{}, Gravity{}, Pools<Pipes>{}, Buoyancy{}};
    const ColumnGrid grid(60, 12, 0.25 * metre);
    std::vector<double> bed;
    for (std::size_t n = 0; n < grid.size(); ++n)
        bed.push_back(std::max(0.0, 0.3 * (grid.centre_x(n % 60).value() - 5)));
    const Pipes slow{9.81 * metre_per_second_squared, 1.0 / second};
    const auto pool = world.add(Pool{Surface{slow, grid, std::span<const double>(bed), 1.0 * metre}});
    const auto water = world.water(pool).volume();
    auto put = [&](double at) {
        const auto body = world.add(position(metres(at, 1.1, 1.5)), mass(5.0 * kilogram));
        return std::pair(body, world.add(Floating{body, Sphere{0.2 * metre}, 0, 4.0 / second}));
    };
    const auto deep = put(3), shallow = put(7.6), dry = put(12);
    for (int i = 0; i < 500; ++i) {
        world.step(0.01 * second);
        world.set_position(dry.first, metres(12, 3, 1.5));
        world.set_velocity(dry.first, metres_per_second(0, 0, 0));
        REQUIRE(world.water(pool).volume().value() == Approx(water.value()).epsilon(1e-12));
    }
    CHECK(world.afloat(deep.second).submerged.value() == Approx(0.005).epsilon(1e-2));
    CHECK(world.afloat(shallow.second).submerged.value() == Approx(0.005).epsilon(5e-2));
    CHECK_FALSE(world.afloat(dry.second).in_pool);
}
TEST_CASE("what a floating body cannot be is refused, and the world is as it was", "[water]") {
    auto one = scene<SemiImplicitEuler>();
    auto& world = one.world;
    const auto body = one.bodies[0];
    const auto hash = world.hash();
    auto said = [&](const Floating& floating) { return refusal([&] { world.add(floating); }); };
    CHECK(said({body, Sphere{-1.0 * metre}}).find("Sphere") != std::string::npos);
    CHECK(said({body, Box{metres(1, 0, 1)}}).find("half") != std::string::npos);
    CHECK(said({body, ball, -0.1}).find("drag is -0.1") != std::string::npos);
    CHECK(said({body, ball, not_a_number}).find("drag") != std::string::npos);
    CHECK(said({body, ball, 0, -1.0 / second}).find("damping is -1") != std::string::npos);
    CHECK(said({body, FixedLift{-1.0 * metre_per_second_squared}}).find("acceleration is -1") != std::string::npos);
    const auto k = 1.0 * newton_per_metre;
    const auto c = 1.0 * newton_second_per_metre;
    CHECK(said({body, SurfaceSpring{0.0 * newton_per_metre, c, 1.0 * metre}}).find("stiffness") != std::string::npos);
    CHECK(said({body, SurfaceSpring{k, -c, 1.0 * metre}}).find("damping") != std::string::npos);
    CHECK(said({body, SurfaceSpring{k, c, 0.0 * metre}}).find("breaks_at") != std::string::npos);
    // From a file: whose number it is, and what it may be.
    detail::FloatingRow<Space<>> row;
    auto put = [&](std::string_view which, std::uint8_t number) {
        detail::FloatingRow<Space<>>::fields(row, [&](std::string_view name, auto& x) {
            if constexpr (std::same_as<std::remove_cvref_t<decltype(x)>, std::uint8_t>)
                if (name == which) x = number;
        });
    };
    CHECK(refusal([&] { put("model", 9); }) == "Floating: model is 9; it is a whole number from 0 to 3");
    auto number = [&](std::uint8_t model, std::size_t at, double x) {
        put("model", model);
        row.size = {1, 1, 1};
        row.size[at] = x;
        return refusal([&] { row.check(); });
    };
    CHECK_NOTHROW(row = {}, row.body = {0}, put("model", 2), row.check()); // a lift of 0 m/s^2
    CHECK(number(2, 0, -1).find("not negative") != std::string::npos);
    CHECK(number(3, 1, -1).find("not negative") != std::string::npos);
    for (const std::size_t at : {0, 2}) CHECK(number(3, at, 0).find("greater than zero") != std::string::npos);
    CHECK(number(0, 0, 0).find("greater than zero") != std::string::npos);
    world.remove(one.bodies[2]);
    CHECK(sentence<std::out_of_range>([&] {
              world.add(Floating{one.bodies[2], ball});
          }).find("World::add") != std::string::npos);
    CHECK(sentence<std::out_of_range>([&] { world.afloat(one.floating[2]); }).find("World::afloat") !=
          std::string::npos);
    CHECK(world.hash() != hash); // the body that was removed, and nothing else
}

TEST_CASE("a file lets water carry no body that is not there", "[water]") {
    const auto one = scene<SemiImplicitEuler>();
    std::stringstream file;
    save(one.world, file);
    const std::string text = file.str();
    for (const std::string number : {"4294967295", "4294967294", "4", "-1"}) {
        auto changed = text;
        const auto at = changed.find("\"body\": ", changed.find("\"Buoyancy\"", changed.find("\"elements\""))) + 8;
        changed.replace(at, changed.find(',', at) - at, number);
        std::stringstream other(changed);
        Under<SemiImplicitEuler> loaded({}, {}, {}, {});
        const auto empty = loaded.hash();
        CAPTURE(number);
        CHECK(refusal([&] { load(loaded, other); }) != "nothing");
        CHECK(loaded.hash() == empty);
    }
}
