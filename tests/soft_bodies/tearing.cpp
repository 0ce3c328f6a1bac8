// SPDX-License-Identifier: BSL-1.0
// Tearing: what a spring that breaks takes with it, and vertices that split, against a plain model of which bodies
// exist; what a tear keeps; copies, hashes and files; room that is used up.

#include <ansatz/soft_bodies/tearing.hpp>

#include <ansatz/soft_bodies/tear.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/tear_model.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

TEMPLATE_TEST_CASE("Random tears leave what is left by the rules, and keep mass and momentum", "[soft_bodies][tearing]",
                   double, float) {
    const double exact = std::is_same_v<TestType, double> ? 1e-13 : 2e-5;
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::mt19937 random(seed);
        auto world = tearing_world<SemiImplicitEuler, TestType>(Tearing<Splitting>{.room = 400});
        world.set(Wind{.density = 0.0 * kilogram_per_cubic_metre});
        const auto parts = add_sheet(world, 7, 6);
        for (const std::size_t held : {0U, 6U}) world.remove(parts.bodies[held]); // so that nothing holds it
        shake(world, random);
        auto model = Model::of(world);
        const double mass = mass_of_all(world);
        std::size_t split = 0;
        for (int i = 0; i < 60; ++i) {
            let_some_go(world, random, i % 3);
            const auto before = momentum_of(world);
            const auto bodies = world.size();
            world.step(1e-3 * second);
            REQUIRE(mass_of_all(world) == Approx(mass).epsilon(exact));
            REQUIRE(norm(momentum_of(world) - before).value() < exact * mass);
            const auto waiting = follow(model, world, {});
            REQUIRE(waiting % 0xffff == 0);
            REQUIRE(Model::of(world) == model);
            REQUIRE(world.size() == bodies + world.split_vertices().size());
            split += world.split_vertices().size();
            for (const auto& [from, to] : world.split_vertices()) {
                const double ratio = double(world.mass(to).value() / world.mass(from).value());
                CHECK(ratio == Approx(whole_area_at(world, to) / whole_area_at(world, from)).epsilon(100 * exact));
            }
        }
        const auto status = world.tearing();
        CHECK(split > 8); // or nothing was tested
        CHECK(status.split == split);
        CHECK(status.waiting == 0);
        CHECK(status.torn == std::size_t(std::count_if(model.triangles.begin(), model.triangles.end(),
                                                       [](const auto& t) { return t.second.torn; })));
        CHECK(world.status().ok());
    }
}

TEMPLATE_TEST_CASE("Beside a far larger side of its vertex a side keeps a mass", "[soft_bodies][tearing]", double,
                   float) {
    const double rounding = std::numeric_limits<TestType>::epsilon();
    // Short sides of three fans; the first stays with the body, the others go in this order.
    for (const std::array<double, 3>& sides :
         {std::array{0.5, 0.25, 1.0}, std::array{0.1 * rounding, 1.0, 0.0}, std::array{1.0, 0.1 * rounding, 0.0},
          std::array{1e-4, 1.0, 1e-4}, std::array{1.0, 1e-9, 0.1 * rounding}}) {
        World world{Space<TestType, 3>{}, SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 10}};
        const auto at = [&](double x, double y) { return world.add(position(metres(x, y, 0)), mass(3.0 * kilogram)); };
        const auto middle = at(0, 0);
        double all = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double turn = 2.0 * double(i), side = sides[i];
            if (side == 0) continue;
            const auto corner = [&](double angle) { return at(side * std::cos(angle), side * std::sin(angle)); };
            const auto one = corner(turn), other = corner(turn + 1);
            world.add(TearableTriangle{{middle, one, other}});
            all += side * side;
        }
        const auto torn = at(1, -1), pulled = at(2, -1);
        world.add(TearableTriangle{{middle, torn, pulled}});
        world.add(Spring{.first = torn, .second = pulled, .stiffness = 1.0 * newton_per_metre}, breaks_at(0.3));
        world.set_position(pulled, metres(5, -1, 0));
        const double before = mass_of_all(world);
        world.step(0.01 * second);
        CAPTURE(sides[0], sides[1], sides[2], rounding);
        REQUIRE(world.split_vertices().size() == (sides[2] == 0 ? 1 : 2));
        CHECK(mass_of_all(world) == Approx(before).epsilon(4 * rounding));
        CHECK(world.status().ok());
        std::vector<Handle> holders = {middle};
        for (const auto& [from, to] : world.split_vertices()) holders.push_back(to);
        for (std::size_t i = 0; i < holders.size(); ++i) {
            const double has = double(world.mass(holders[i]).value());
            CHECK(has > 0);
            // To the rounding of what is in the larger sides.
            CHECK(std::abs(has - 3 * sides[i] * sides[i] / all) <= 12 * rounding);
        }
        std::stringstream file;
        save(world, file);
        auto loaded =
            World{Space<TestType, 3>{}, SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 10}};
        load(loaded, file);
        CHECK(loaded.hash() == world.hash());
    }
}

TEMPLATE_TEST_CASE("Areas of a file whose sum is no number leave each side a mass", "[soft_bodies][tearing]", double,
                   float) {
    const auto make = [] {
        return World{Space<TestType, 3>{}, SemiImplicitEuler{}, Springs<Breaking>{}, Tearing<Splitting>{.room = 10}};
    };
    auto world = make();
    const auto at = [&](double x, double y) { return world.add(position(metres(x, y, 0)), mass(3.0 * kilogram)); };
    const auto middle = at(0, 0), a = at(1, 0), b = at(1, 1), c = at(-1, 0), d = at(-1, -1), e = at(0, -1),
               f = at(1, -1), g = at(2, -1);
    for (const auto& t : {std::array{middle, a, b}, {middle, c, d}, {middle, d, e}, {middle, f, g}})
        world.add(TearableTriangle{t});
    world.add(Spring{.first = f, .second = g, .stiffness = 1.0 * newton_per_metre}, breaks_at(0.3));
    world.set_position(g, metres(5, -1, 0));
    std::stringstream file, changed;
    save(world, file);
    auto json = nlohmann::ordered_json::parse(file);
    for (auto& one : json["elements"]["Tearing"]["list"])
        one["row"]["area"] = double(std::numeric_limits<TestType>::max());
    changed << json;
    auto loaded = make();
    load(loaded, changed);
    const double before = mass_of_all(loaded);
    loaded.step(0.01 * second);
    REQUIRE(loaded.split_vertices().size() == 1);
    CHECK(loaded.status().ok());
    CHECK(mass_of_all(loaded) == Approx(before));
    for (const Handle side : {middle, loaded.split_vertices()[0].to}) CHECK(loaded.mass(side).value() > 0);
}

TEST_CASE("Without room vertices wait, and split at the next tear when there is some", "[soft_bodies][tearing]") {
    std::mt19937 random(5);
    auto world = tearing_world<SemiImplicitEuler, double>(Tearing<Splitting>{.room = 3});
    const auto parts = add_sheet(world, 7, 6);
    const std::set<std::uint32_t> held = {parts.bodies[0].id, parts.bodies[6].id};
    shake(world, random);
    auto model = Model::of(world);
    for (int i = 0; i < 14; ++i) {
        let_some_go(world, random, 2);
        world.step(1e-3 * second);
        const auto waiting = follow(model, world, held); // what is held does not split
        REQUIRE(Model::of(world) == model);
        if (waiting != 0xffff) CHECK(world.tearing().waiting == waiting);
    }
    const auto waiting = world.tearing().waiting;
    CHECK(world.tearing().split == 3);
    CHECK(waiting > 3);
    CHECK(world.size() == 45);
    world.set(Tearing<Splitting>{.room = 400});
    for (int i = 0; i < 40 && world.tearing().waiting > 0; ++i) {
        let_some_go(world, random, 2);
        world.step(1e-3 * second);
        follow(model, world, held);
        REQUIRE(Model::of(world) == model);
    }
    CHECK(world.tearing().waiting == 0);
    CHECK(world.tearing().split > 3 + waiting / 2); // some have been torn off meanwhile
}

TEST_CASE("Copies and worlds from files go on tearing bit for bit, with room of their own", "[soft_bodies][tearing]") {
    std::mt19937 random(6);
    const Tearing<Splitting> policy{.room = 60};
    auto world = tearing_world<SemiImplicitEuler, double>(policy);
    add_sheet(world, 7, 6);
    shake(world, random);
    for (int i = 0; i < 12; ++i) {
        let_some_go(world, random, 2);
        world.step(1e-3 * second);
    }
    const auto early = world.tearing().split;
    CHECK(early > 0);
    auto copy = world;
    std::stringstream file;
    save(world, file);
    auto loaded = tearing_world<SemiImplicitEuler, double>(policy);
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    CHECK(loaded.tearing().torn == world.tearing().torn);
    auto same = random, again = random;
    for (int i = 0; i < 30; ++i) {
        let_some_go(world, random, 2);
        let_some_go(copy, same, 2);
        let_some_go(loaded, again, 2);
        for (auto* one : {&world, &copy, &loaded}) one->step(1e-3 * second);
        REQUIRE(copy.hash() == world.hash());
        REQUIRE(loaded.hash() == world.hash());
    }
    CHECK(world.tearing().split > early + 3);
    const auto hash = world.hash();
    world.set(world.elements<TearableTriangle>().handle(0), world.get(world.elements<TearableTriangle>().handle(0)));
    CHECK(hash != world.hash()); // torn or not is a part of it, and so is a triangle that is mended
}

TEST_CASE("Where velocities are derived, the sides of a vertex go on with that which it had",
          "[soft_bodies][tearing]") {
    std::mt19937 random(7);
    auto world = tearing_world<Verlet, double>(Tearing<Splitting>{.room = 100});
    world.set(Wind{.velocity = metres_per_second(0, 0, 2)}); // which reads velocities
    const auto parts = add_sheet(world, 6, 5);
    for (const std::size_t held : {0U, 5U}) world.remove(parts.bodies[held]);
    shake(world, random);
    run(world, 5, 1e-3);
    auto still = world; // without any tear
    std::size_t split = 0;
    for (int i = 0; i < 25; ++i) {
        let_some_go(world, random, 2);
        still = world;
        for (const auto spring : still.elements<Spring>().handles()) still.set(spring, still.get(spring));
        world.step(1e-3 * second);
        still.step(1e-3 * second);
        // The step ends with the velocities that the forces of the step made, whatever is torn behind it.
        for (const auto body : still.handles())
            REQUIRE(norm(world.velocity(body) - still.velocity(body)).value() < 1e-9);
        for (const auto& [from, to] : world.split_vertices()) {
            CHECK(norm(world.velocity(to) - world.velocity(from)).value() < 1e-9);
            CHECK(world.position(to) == world.position(from));
            ++split;
        }
    }
    CHECK(split > 3);
}

TEST_CASE("In a plane, by hand: a spring takes the two triangles along it, and their spring across",
          "[soft_bodies][tearing]") {
    // 2 - 3      Two triangles, 0 1 3 and 0 3 2, and a third, 1 4 3. The spring from 0 to 3 breaks.
    // | / | \      .
    // 0 - 1 - 4
    World world{Space<float, 2>{}, SemiImplicitEuler{}, Springs<Breaking>{}, Area{}, Tearing<>{}};
    std::vector<Handle> b;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}})
        b.push_back(world.add(position(metres(x, y)), mass(1.0 * kilogram)));
    const auto spring = [&](std::size_t i, std::size_t j) { return world.add(Spring{b[i], b[j], 1.0 * N_per_m}); };
    const auto first = world.add(TearableTriangle{{b[0], b[1], b[3]}}),
               second_ = world.add(TearableTriangle{{b[0], b[3], b[2]}}),
               third = world.add(TearableTriangle{{b[1], b[4], b[3]}});
    const auto film = world.add(Membrane{{b[1], b[4], b[3]}, 1.0 * N_per_m});
    world.add(Membrane{{b[0], b[1], b[3]}, 1.0 * N_per_m});
    std::vector<SpringHandle> edges;
    for (const auto& [i, j] : {std::pair{0U, 1U}, {1U, 3U}, {3U, 2U}, {2U, 0U}, {1U, 4U}, {4U, 3U}})
        edges.push_back(spring(i, j));
    const auto across = spring(1, 2), reaching = spring(0, 4), apart = spring(2, 4);
    const auto diagonal = spring(0, 3);
    auto description = world.get(diagonal);
    description.rest_length = 1.0 * metre;
    world.set(diagonal, description, breaks_at(0.1));
    world.step(1e-3 * second);
    CHECK_FALSE(world.contains(diagonal));
    CHECK(world.is_torn(first));
    CHECK(world.is_torn(second_));
    CHECK_FALSE(world.is_torn(third));
    CHECK_FALSE(world.contains(across));   // from one torn triangle past it to the other
    CHECK_FALSE(world.contains(reaching)); // from the first past 1 and 3 to 4
    CHECK(world.contains(apart) == false); // from the second past 3
    for (const auto edge : edges) CHECK(world.contains(edge));
    CHECK(world.contains(film));
    CHECK(world.elements<Membrane>().size() == 1);
    CHECK(world.size() == 5);
    CHECK(world.tearing().torn == 2);
    world.set(first, TearableTriangle{{b[0], b[1], b[3]}});
    CHECK_FALSE(world.is_torn(first)); // mended
    world.remove(b[0]);
    CHECK_FALSE(world.contains(first));
    CHECK(world.contains(third));
    CHECK(refusal([&] { world.is_torn(first); }) != "");
}

TEST_CASE("What cannot tear is refused", "[soft_bodies][tearing]") {
    auto world = tearing_world<SemiImplicitEuler, double>(Tearing<Splitting>{.room = 5});
    const auto a = world.add(position(metres(0, 0, 0)), mass(1.0 * kilogram)),
               b = world.add(position(metres(1, 0, 0)), mass(1.0 * kilogram)),
               c = world.add(position(metres(2, 0, 0)), mass(1.0 * kilogram));
    CHECK_THAT(refusal([&] { world.add(TearableTriangle{{a, b, c}}); }), ContainsSubstring("the area of the triangle"));
    CHECK_THAT(refusal([&] { world.add(TearableTriangle{{a, b, b}}); }), ContainsSubstring("two of its corners"));
    CHECK_THAT(refusal([&] { world.set(Tearing<Splitting>{.room = -1}); }), ContainsSubstring("room is -1"));
    World unbreakable{SemiImplicitEuler{}, Springs<>{}};
    auto cloth = woven(3, 3);
    const auto refused = [&](auto& in, const BreakLimit& limit) {
        cloth.shear.breaks = limit;
        return refusal([&] { add_cloth(in, cloth); });
    };
    CHECK_THAT(refused(unbreakable, breaks_at(0.2)), ContainsSubstring("add_cloth: break strain is 0.2"));
    CHECK_THAT(refused(unbreakable, breaks_at(3.0 * newton)), ContainsSubstring("Springs<Breaking>{}"));
    CHECK_THAT(refused(world, breaks_at(-3.0 * newton)), ContainsSubstring("break force is -3 N"));
    CHECK_THAT(refused(world, breaks_at(0.0)), ContainsSubstring("break strain is 0"));
    // Of a mesh that is no grid the springs against shear and bend are one: they have the stricter limit, and the kind
    // that does nothing has no say.
    cloth = woven(3, 3);
    cloth.mesh = TriangleMesh({cloth.mesh.vertices().begin(), cloth.mesh.vertices().end()},
                              {cloth.mesh.triangles().begin(), cloth.mesh.triangles().end()});
    CHECK_THAT(refused(unbreakable, breaks_at(0.2)), ContainsSubstring("add_cloth: break strain is 0.2"));
    CHECK_THAT(refused(world, breaks_at(-3.0 * newton)), ContainsSubstring("break force is -3 N"));
    CHECK_THAT(refused(world, {NAN * newton, 0.5}), ContainsSubstring("break force is nan N"));
    CHECK(unbreakable.size() == 0);
    CHECK(world.size() == 3);
    cloth.shear.breaks = breaks_at(0.4);
    cloth.bend.breaks = {7.0 * newton, 0.3};
    const auto limit_of = [&](const ClothParts& parts) {
        const auto& limit = world.elements<Spring>().limit(parts.bend[0].id);
        return std::pair(double(limit.force), double(limit.strain));
    };
    CHECK(limit_of(add_cloth(world, cloth)) == std::pair(7.0, 0.3));
    cloth.bend.stiffness = 0.0 * N_per_m;
    cloth.bend.damping = 0.0 * N_s_per_m;
    CHECK(limit_of(add_cloth(world, cloth)) == std::pair(double(INFINITY), 0.4));
    const auto bodies = world.size();
    cloth.shear.stiffness = cloth.bend.stiffness = 1e308 * N_per_m;
    CHECK_THAT(refusal([&] { add_cloth(world, cloth); }),
               ContainsSubstring("add_cloth: shear and bend stiffness is inf N/m"));
    CHECK(world.size() == bodies);
}
