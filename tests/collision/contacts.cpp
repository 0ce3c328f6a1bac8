// SPDX-License-Identifier: BSL-1.0
// Contacts of a world: begin, last, end; order; sensors; layers; removed bodies; saved and copied worlds.

#include "tests/collision/support.hpp"

#include <ansatz/collision/collisions.hpp>
#include <ansatz/collision/contact_order.hpp>
#include <ansatz/collision/filter/layers.hpp>
#include <ansatz/collision/save_collisions.hpp>
#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world/save.hpp>
#include <ansatz/world/save_parameters.hpp>

using namespace collision_tests;

TEST_CASE("a contact begins, lasts and ends", "[collision][contacts]") {
    auto world = world_of(SemiImplicitEuler{}, Space<double, 2>{}, Projection{10.0 * metre}); // it moves no body
    const auto a = world.add(Sphere{0.5 * metre}, position(metres(0, 0)), mass(1.0 * kilogram));
    const auto b = world.add(Sphere{0.5 * metre}, position(metres(-1.25, 0)), velocity(metres_per_second(1, 0)),
                             mass(1.0 * kilogram));
    auto step = [&] { world.step(0.5 * second); };
    step(); // at -0.75
    REQUIRE(world.contacts().size() == 1);
    CHECK((world.contacts()[0].first == a && world.contacts()[0].second == b && world.contacts()[0].begins()));
    CHECK(world.contacts()[0].normal[0] == 1);
    step();
    step(); // at 0.25
    REQUIRE(world.contacts().size() == 1);
    CHECK((world.contacts()[0].steps == 2 && !world.contacts()[0].begins()));
    CHECK(world.contacts_ended().empty());
    step();
    step(); // at 1.25
    CHECK(world.contacts().empty());
    REQUIRE(world.contacts_ended().size() == 1);
    CHECK(world.contacts_ended()[0] == ContactEnd{a, b});
    step();
    CHECK(world.contacts_ended().empty());
}

TEST_CASE("a body that is removed ends its contacts in the next step", "[collision][contacts]") {
    auto world = world_of(SemiImplicitEuler{}, Space<double, 2>{}, Impulse<>{});
    const auto [a, b] = two_spheres(world, 0, 0);
    world.step(0.01 * second);
    REQUIRE(world.contacts().size() == 1);
    world.remove(a);
    CHECK(world.contacts().size() == 1); // until then; but it is told that the body is gone
    CHECK((!world.contains(world.contacts()[0].first) && world.contains(world.contacts()[0].second)));
    const auto c = world.add(Sphere{0.5 * metre}, position(metres(0, 0)), mass(1.0 * kilogram)); // takes the id
    world.step(0.01 * second);
    REQUIRE(world.contacts().size() == 1);
    CHECK((world.contacts()[0].first == c && world.contacts()[0].begins()));
    REQUIRE(world.contacts_ended().size() == 1);
    CHECK(world.contacts_ended()[0] == ContactEnd{a, b});
}

TEST_CASE("I19: a contact of a body that is removed ends once, too, where the world was saved before the next step",
          "[collision][contacts]") {
    for (const bool smaller : {true, false})
        for (const bool taken : {false, true}) {
            auto world = world_of(SemiImplicitEuler{}, Space<double, 2>{}, Rest{}, Impulse<>{});
            const auto [a, b] = two_spheres(world, 0, 0);
            world.step(0.01 * second);
            REQUIRE(world.contacts().size() == 1);
            world.remove(smaller ? a : b);
            if (taken) world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram)); // has the id of the one that is gone
            std::stringstream file;
            save(world, file);
            auto loaded = world_of(SemiImplicitEuler{}, Space<double, 2>{}, Rest{}, Impulse<>{});
            load(loaded, file);
            CHECK(loaded.hash() == world.hash());
            for (auto* one : {&world, &loaded}) {
                REQUIRE(one->contacts().size() == 1);
                CHECK((one->contacts()[0].first == a && one->contacts()[0].second == b));
                one->step(0.01 * second);
                REQUIRE(one->contacts_ended().size() == 1);
                CHECK(one->contacts_ended()[0] == ContactEnd{a, b});
                CHECK(one->contacts().size() == std::size_t(taken));
                one->step(0.01 * second);
                CHECK(one->contacts_ended().empty());
            }
        }
}

TEST_CASE("contacts stand in the order of ids, whatever the broadphase and the order in which bodies sleep",
          "[collision][contacts]") {
    auto look = [](auto broadphase) {
        World world{SemiImplicitEuler{}, Space<double, 3>{}, broadphase, Narrowphase<Sphere>{}, Impulse<>{}};
        std::mt19937_64 engine(3);
        auto number = [&] { return 4 * double(engine() >> 11) * 0x1p-53; };
        for (int i = 0; i < 200; ++i)
            world.add(Sphere{0.3 * metre}, position(metres(number(), number(), number())), mass(1.0 * kilogram),
                      restitution(0.5));
        for (int i = 0; i < 20; ++i) world.step(0.01 * second);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (const auto& c : world.contacts()) pairs.emplace_back(c.first.id, c.second.id);
        CHECK(std::is_sorted(pairs.begin(), pairs.end()));
        return std::pair(pairs, world.hash());
    };
    const auto [pairs, hash] = look(AllPairs{});
    CHECK(pairs.size() > 50);
    auto check = [&, expected = std::pair(pairs, hash)](const auto& found) { CHECK(found == expected); };
    check(look(BoundingBoxes{}));
    check(look(UniformGrid{}));
    check(look(Octree{}));
    check(look(BinarySplit{}));
    check(look(SortAndSweep{}));
    check(look(UniformGrid<SortAndSweep>{}));
}

TEST_CASE("a sensor notices and pushes no body", "[collision][contacts]") {
    auto world = world_of(SemiImplicitEuler{}, Space<double, 2>{}, Impulse<>{}, Projection{});
    const auto gate = world.add(Box{metres(1, 1)}, fixed, sensor);
    const auto ball = world.add(Sphere{0.1 * metre}, position(metres(-2, 0)), velocity(metres_per_second(1, 0)),
                                mass(1.0 * kilogram), restitution(1));
    int inside = 0;
    for (int i = 0; i < 400; ++i) {
        world.step(0.01 * second);
        inside += int(world.contacts().size());
        for (const auto& c : world.contacts()) CHECK(c.first == gate);
    }
    CHECK(std::abs(inside - 220) <= 1);
    CHECK(std::abs(x_of(world, ball) - 2) <= 1e-12);
}

TEST_CASE("layers: which bodies ignore each other", "[collision][contacts]") {
    auto contacts = [](auto ma, auto ia, auto mb, auto ib) {
        auto world = World{SemiImplicitEuler{},   Space<double, 2>{},      BoundingBoxes{}, Layers{},
                           Narrowphase<Sphere>{}, Projection{10.0 * metre}};
        world.add(Sphere{1.0 * metre}, mass(1.0 * kilogram), member_of(ma), ignores(ia));
        world.add(Sphere{1.0 * metre}, mass(1.0 * kilogram), member_of(mb), ignores(ib));
        world.step(0.01 * second);
        return world.contacts().size();
    };
    CHECK(contacts(0, 0, 0, 0) == 1);
    CHECK(contacts(1, 0, 2, 0) == 1);
    CHECK(contacts(1, 2, 2, 0) == 0);
    CHECK(contacts(1, 0, 2, 1) == 0);
    CHECK(contacts(1, 4, 2, 8) == 1);
    CHECK(contacts(1u << 23, 0, 0, 1u << 23) == 0);
    CHECK(refusal([] { member_of(1u << 24); }).find("layers is 16777216") != std::string::npos);
}

TEST_CASE("a body without a shape meets no body, and one with an infinite position is told of",
          "[collision][contacts]") {
    auto world = world_of(SemiImplicitEuler{}, Space<float, 2>{}, Impulse<>{}, Projection{});
    world.add(shapeless, mass(1.0 * kilogram));
    const auto fast = world.add(Sphere{1.0 * metre}, velocity(metres_per_second(3e38, 0)), mass(1.0 * kilogram));
    world.add(Sphere{1.0 * metre}, position(metres(0.5, 0)), fixed);
    for (int i = 0; i < 3; ++i) world.step(1.0 * second);
    CHECK(world.status().first_not_finite == fast);
}

namespace {
template <class S, class... P> void check_shapeless(const P&... policies) {
    World world{S{},           policies...,        Gravity{}, Springs{}, Narrowphase<Sphere, Plane>{},
                UniformGrid{}, SemiImplicitEuler{}};
    using W = decltype(world);
    // The same particles where no body collides: what they meet must make no difference.
    World alone{S{}, Gravity{}, Springs{}, SemiImplicitEuler{}};
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> number(-1, 1);
    auto vector = [&](double size) {
        Vector<typename S::Scalar, S::dimension> v;
        for (int k = 0; k < S::dimension; ++k) v[k] = typename S::Scalar(size * number(engine));
        return v;
    };
    world.add(Plane::ground(), fixed);
    std::vector<Handle> particles, images;
    for (int i = 0; i < 40; ++i) {
        const auto x = position(vector(2) * metre);
        const auto v = velocity(vector(3) * metre_per_second);
        const auto m = mass((1.5 + number(engine)) * kilogram);
        if (i % 2 == 0) world.add(m, Sphere{0.4 * metre}, v, x);
        // wherever the word stands among the properties
        if (i % 3 == 0) particles.push_back(world.add(shapeless, x, v, m));
        else if (i % 3 == 1) particles.push_back(world.add(x, shapeless, v, m));
        else particles.push_back(world.add(x, v, m, shapeless));
        images.push_back(alone.add(shapeless, x, v, m)); // said where it goes without saying
    }
    for (std::size_t i = 1; i < particles.size(); ++i) {
        world.add(Spring{particles[i - 1], particles[i], 30.0 * newton_per_metre, 0.2 * newton_second_per_metre});
        alone.add(Spring{images[i - 1], images[i], 30.0 * newton_per_metre, 0.2 * newton_second_per_metre});
    }
    std::stringstream file;
    std::size_t met = 0;
    for (int i = 0; i < 120; ++i) {
        if (i == 60) { // they are shapeless in a copy and in a file too
            save(world, file);
            W loaded{S{},           policies...,        Gravity{}, Springs{}, Narrowphase<Sphere, Plane>{},
                     UniformGrid{}, SemiImplicitEuler{}};
            load(loaded, file);
            CHECK(loaded.hash() == world.hash());
            world = loaded;
        }
        world.step(1.0 / 120 * second);
        alone.step(1.0 / 120 * second);
        met += world.contacts().size();
        for (const auto& contact : world.contacts())
            for (const auto h : particles) CHECK((contact.first != h && contact.second != h));
    }
    CHECK(met > 0);
    for (std::size_t i = 0; i < particles.size(); ++i)
        CHECK((world.position(particles[i]) - alone.position(images[i])).value().norm() == 0);
}
} // namespace

TEST_CASE("a shapeless body meets no body and feels all else", "[collision][contacts]") {
    check_shapeless<Space<double, 3>>(Impulse<>{}, Projection{});
    check_shapeless<Space<float, 2>>(Impulse<Friction>{}, Projection{});
    check_shapeless<Space<double, 2>>(Penalty{});
}

namespace {
template <class... P> void check_restart(P... policies) {
    auto make = [&] {
        return World{policies...,      Gravity{}, Rest{}, UniformGrid{}, Narrowphase<Sphere, Plane, Box>{},
                     Space<float, 3>{}};
    };
    auto world = make();
    world.add(Plane::ground(), fixed);
    world.add(Box{metres(0.3, 0.3, 0.3)}, position(metres(3, 0.3, 3)), fixed, sensor);
    for (int i = 0; i < 40; ++i)
        world.add(Sphere{0.2 * metre},
                  position(metres(0.39 * (i % 5) + 0.001 * i, 0.3 + 0.5 * (i / 20), 0.39 * (i / 5 % 4))),
                  mass(1.0 * kilogram));
    run(world, 100, 1.0 / 60);
    std::stringstream file;
    save(world, file);
    auto loaded = make();
    load(loaded, file);
    auto copy = world;
    CHECK(loaded.hash() == world.hash());
    CHECK(loaded.contacts().size() == world.contacts().size());
    for (auto* w : {&world, &loaded, &copy}) run(*w, 100, 1.0 / 60);
    CHECK(loaded.hash() == world.hash());
    CHECK(copy.hash() == world.hash());
}
} // namespace

TEST_CASE("I19: a world that is saved or copied in the middle of a collision goes on to the same bits",
          "[collision][contacts]") {
    check_restart(SemiImplicitEuler{}, SoftSubsteps<>{});
    check_restart(Verlet{}, SoftSubsteps<>{});
    check_restart(SemiImplicitEuler{}, Impulse<>{}, Projection{});
    check_restart(Verlet{}, Impulse<>{}, Projection{});
    check_restart(Verlet{}, Penalty{2e4 * newton_per_metre, 50.0 * newton_second_per_metre});
    check_restart(ImplicitEuler{}, Penalty{2e4 * newton_per_metre, 50.0 * newton_second_per_metre});
}

TEST_CASE("files with shapes or contacts that mean nothing are refused with their place", "[collision][contacts]") {
    auto make = [] { return world_of(SemiImplicitEuler{}, Space<double, 2>{}, SoftSubsteps<>{}); };
    auto world = make();
    two_spheres(world, 0, 0);
    world.step(0.01 * second);
    std::stringstream file;
    save(world, file);
    auto refused = [&](const std::string& from, const std::string& to) {
        auto text = file.str();
        const auto at = text.rfind(from); // the shapes and contacts stand behind the policies
        REQUIRE(at != std::string::npos);
        text.replace(at, from.size(), to);
        std::istringstream changed(text);
        auto other = make();
        return refusal([&] { load(other, changed); });
    };
    auto says = [](const std::string& sentence, const char* what) {
        INFO(sentence);
        CHECK(sentence.find(what) != std::string::npos);
    };
    says(refused("\"radius\": 0.5", "\"radius\": -0.5"), "Sphere: radius is -0.5 m");
    says(refused("\"Sphere\"", "\"Torus\""), "a shape that the narrowphase of this world knows");
    says(refused("\"parts\": 4", "\"parts\": 0"), "a whole number of at least 1");
}

TEST_CASE("a body that is pushed or moved between two steps is tested again before the next one",
          "[collision][contacts]") {
    auto stopped = [](auto change) {
        auto world = world_of(SemiImplicitEuler{}, SoftSubsteps<>{});
        world.add(Box{metres(0.1, 5, 5)}, at<Space<>>(5), fixed);
        const auto ball = world.add(Sphere{0.1 * metre}, at<Space<>>(0), going<Space<>>(1), mass(1.0 * kilogram));
        run(world, 3, 1.0 / 60);
        change(world, ball);
        world.step(1.0 / 60 * second);
        return x_of(world, ball);
    };
    CHECK(std::abs(stopped([](auto& world, Handle ball) { world.set_velocity(ball, metres_per_second(290, 0, 0)); }) -
                   4.8) <= 1e-3);
    CHECK(std::abs(stopped([](auto& world, Handle ball) { world.apply_impulse(ball, newton_seconds(290, 0, 0)); }) -
                   4.8) <= 1e-3);
    CHECK(std::abs(stopped([](auto& world, Handle ball) { world.set_position(ball, metres(4.79, 0, 0)); }) - 4.8) <=
          1e-3);
}

TEST_CASE("I19: a world that is saved goes on to the same bits when its steps are of many lengths",
          "[collision][contacts]") {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<Friction>{});
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 12; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(0.3 * (i % 3), 0.6 + 0.9 * i, 0.2 * (i % 2))),
                  mass((1.0 + i) * kilogram), friction(0.5));
    const std::vector<double> lengths{1.0 / 60, 1.0 / 240, 1.0 / 30, 1e-6, 0.1, 1.0 / 60};
    for (int n = 0; n < 120; ++n) {
        std::stringstream file;
        save(world, file);
        auto loaded = world_of(SemiImplicitEuler{}, Gravity{}, SoftSubsteps<Friction>{});
        load(loaded, file);
        const double dt = lengths[std::size_t(n) % lengths.size()];
        world.step(dt * second);
        loaded.step(dt * second);
        INFO("step " << n);
        REQUIRE(world.hash() == loaded.hash());
    }
}
