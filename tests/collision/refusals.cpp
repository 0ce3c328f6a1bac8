// SPDX-License-Identifier: BSL-1.0
// What a world in which bodies collide refuses at its doors: each bad number by its name, value, unit and what would be
// right, and the world goes on as if nothing had been asked.

#include <ansatz/world/column_range.hpp>
#include <ansatz/world/save.hpp>

#include "tests/collision/support.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

using namespace collision_tests;

namespace {

using Json = nlohmann::ordered_json;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
using Plain = Quantity<unit::Dimensionless>;

/// A column of a user's own, with a bound.
struct Depth {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "depth";
    static constexpr double most = 2;
};

/// A sphere that rolls and one that falls on it, above the ground.
template <class... P> auto scene(P... policies) {
    World world{SemiImplicitEuler{}, Gravity{}, Layers{}, Narrowphase<Sphere, Plane, Box>{}, policies...};
    world.add(Plane::ground(), fixed);
    world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 0)), velocity(metres_per_second(1, 0, 0)),
              mass(1.0 * kilogram));
    world.add(Sphere{0.5 * metre}, position(metres(0.2, 1.45, 0)), mass(2.0 * kilogram), member_of(4));
    for (int i = 0; i < 3; ++i) world.step(0.01 * second);
    return world;
}

/// It says that, and the world is what it was and goes on as it would have.
template <class World_> void refuses(World_& world, const std::string& expected, const std::function<void()>& ask) {
    INFO("expected: " << expected);
    const auto before = world;
    CHECK(refusal(ask) == expected);
    CHECK(world.hash() == before.hash());
    CHECK(world.size() == before.size());
    auto asked = world, untouched = before;
    for (int i = 0; i < 5; ++i) asked.step(0.01 * second), untouched.step(0.01 * second);
    CHECK(asked.hash() == untouched.hash());
}
/// A policy, spoiled: a world that has it takes it no more than one that is made with it.
/// \param make the world of that policy
template <class Policy, class Make>
void refuses_policy(Policy policy, const Make& make, const std::string& expected,
                    const std::function<void(Policy&)>& spoil) {
    auto world = make(policy);
    spoil(policy);
    refuses(world, expected, [&] { world.set(policy); });
    CHECK(refusal([&] { make(policy); }) == expected);
}
const auto with_broadphase = [](const auto& policy) { return scene(policy, Impulse<>{}); };
const auto with_response = [](const auto& policy) { return scene(BoundingBoxes{}, policy); };

/// A good file of a world with one number changed.
template <class World_>
std::string load_spoiled(const World_& world, World_& into, const std::function<void(Json&)>& spoil) {
    std::ostringstream out;
    save(world, out);
    auto json = Json::parse(out.str());
    spoil(json);
    std::istringstream in(json.dump());
    return refusal([&] { load(into, in, "game.json"); });
}

} // namespace

TEST_CASE("shapes: radii, half widths, normals and offsets that mean nothing", "[collision][refusals]") {
    auto world = scene(BoundingBoxes{}, Impulse<>{});
    auto add = [&](const std::string& expected, const auto& shape) {
        refuses(world, expected, [&] { world.add(shape, mass(1.0 * kilogram)); });
    };
    for (const auto& [radius, shown] : {std::pair(0.0, "0"), {-0.5, "-0.5"}, {not_a_number, "nan"}, {infinite, "inf"}})
        add("Sphere: radius is " + std::string(shown) + " m; it must be finite and greater than zero",
            Sphere{radius * metre});
    const std::string box = " m; three lengths, finite and greater than zero";
    add("Box: half is (1, 0, 1)" + box, Box{metres(1, 0, 1)});
    add("Box: half is (1, 1, -1)" + box, Box{metres(1, 1, -1)});
    add("Box: half is (nan, 1, 1)" + box, Box{metres(not_a_number, 1, 1)});
    add("Box: half is (1, inf, 1)" + box, Box{metres(1, infinite, 1)});
    add("Plane: normal is (0, 0, 0); it has a direction; the ground's is (0, 1, 0)",
        Plane{Eigen::Vector3d(0, 0, 0), 0.0 * metre});
    add("Plane: normal is (0, nan, 0); it must be finite", Plane{Eigen::Vector3d(0, not_a_number, 0), 0.0 * metre});
    add("Plane: offset is inf m; it must be finite", Plane{Eigen::Vector3d(0, 1, 0), infinite * metre});
    // The free function refuses the same.
    CHECK(refusal([] { contact(Sphere{0.0 * metre}, metres(0, 0, 0), Sphere{1.0 * metre}, metres(0, 0, 0)); }) ==
          "Sphere: radius is 0 m; it must be finite and greater than zero");
    // A normal of any length is a direction: 0.001 and 1000 make the same plane.
    auto plane = scene(BoundingBoxes{}, Impulse<>{});
    for (const double length : {0.001, 1.0, 1000.0}) {
        auto other = plane;
        const auto ball = other.add(Sphere{0.5 * metre}, position(metres(5, 0.4, 0)), mass(1.0 * kilogram));
        other.add(Plane{Eigen::Vector3d(length, 0, 0), 4.6 * metre}, fixed);
        other.step(0.01 * second);
        const auto contacts = other.contacts();
        const auto found = std::find_if(contacts.begin(), contacts.end(),
                                        [&](const auto& c) { return c.first == ball && c.normal[0] == 1.0; });
        REQUIRE(found != contacts.end()); // the ball's left end is at 4.5 m, the surface at 4.6 m
        CHECK(found->depth.value() == Approx(0.1).epsilon(1e-12));
    }
}

TEST_CASE("shapes whose numbers the world's scalar cannot hold", "[collision][refusals]") {
    World world{Space<float, 2>{}, SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere, Plane, Box>{},
                Impulse<>{}};
    refuses(world, "Sphere: radius is 1e-60 m; it is greater than zero in the world's scalar",
            [&] { world.add(Sphere{1e-60 * metre}, mass(1.0 * kilogram)); });
    refuses(world, "Sphere: radius is 1e+60 m; the world's scalar holds numbers up to 3.4028234663852886e+38",
            [&] { world.add(Sphere{1e60 * metre}, mass(1.0 * kilogram)); });
    refuses(world, "Box: half is (1, 1e-60, 0) m; two lengths, finite and greater than zero",
            [&] { world.add(Box{metres(1, 1e-60)}, mass(1.0 * kilogram)); });
}

TEST_CASE("restitution, friction and layers stay within their bounds at every door", "[collision][refusals]") {
    auto world = scene(BoundingBoxes{}, Impulse<Friction>{});
    const auto ball = world.handles()[1];
    const auto give = [&](const std::string& expected, const auto& property) {
        refuses(world, expected, [&] { world.add(Sphere{0.5 * metre}, mass(1.0 * kilogram), property()); });
    };
    const std::string from_0_to_1 = "; it is a number from 0 to 1",
                      at_least_0 = "; it is a number, finite and at least 0";
    for (const auto& [value, shown] :
         {std::pair(-0.1, "-0.1"), {1.5, "1.5"}, {not_a_number, "nan"}, {infinite, "inf"}}) {
        give("restitution: e is " + std::string(shown) + from_0_to_1, [v = value] { return restitution(v); });
        if (value > 1 && value < 2) continue; // 1.5 is a coefficient of friction
        give("friction: mu is " + std::string(shown) + at_least_0, [v = value] { return friction(v); });
    }
    // Around the named properties, and of a body that is there.
    const auto one_and_a_half = Plain(1.5), minus = Plain(-0.25);
    give("World::add: restitution is 1.5" + from_0_to_1, [&] { return with<Restitution>(one_and_a_half); });
    give("World::add: friction is -0.25" + at_least_0, [&] { return with<Friction>(minus); });
    refuses(world, "World::write: restitution is 1.5" + from_0_to_1,
            [&] { world.write<Restitution>(ball, one_and_a_half); });
    refuses(world, "World::write: restitution is -0.25" + from_0_to_1, [&] { world.write<Restitution>(ball, minus); });
    refuses(world, "World::write: friction is -0.25" + at_least_0, [&] { world.write<Friction>(ball, minus); });
    refuses(world, "World::write: friction is nan; it is a finite number that the world's scalar can hold",
            [&] { world.write<Friction>(ball, Plain(not_a_number)); });
    world.write<Restitution>(ball, Plain(1)); // the bounds themselves are good
    world.write<Restitution>(ball, Plain(0));
    world.write<Friction>(ball, Plain(0));

    const std::string bits = "; it is from 0 to 16777215: a bit for each of 24 layers",
                      whole = "; it is a whole number from 0 to 16777215";
    give("member_of: layers is -1" + bits, [] { return member_of(-1); });
    give("member_of: layers is 16777216" + bits, [] { return member_of(1u << 24); });
    give("ignores: layers is 1099511627776" + bits, [] { return ignores(1ull << 40); });
    give("World::add: member of layers is 0.5" + whole, [] { return with<Member>(Plain(0.5)); });
    refuses(world, "World::write: member of layers is 1.5" + whole, [&] { world.write<Member>(ball, one_and_a_half); });
    refuses(world, "World::write: ignored layers is 16777216" + whole,
            [&] { world.write<Ignored>(ball, Plain(1 << 24)); });
    world.write<Ignored>(ball, Plain((1 << 24) - 1));
}

TEST_CASE("a file with a coefficient out of its bounds is refused with its place", "[collision][refusals]") {
    const auto world = scene(BoundingBoxes{}, SoftSubsteps<Friction>{});
    auto into = world;
    into.step(0.01 * second);
    const auto before = into.hash();
    const auto spoiled = [&](const std::function<void(Json&)>& spoil) {
        const auto said = load_spoiled(world, into, spoil);
        CHECK(into.hash() == before);
        return said;
    };
    auto good = into;
    CHECK(load_spoiled(world, good, [](Json&) {}) == "nothing"); // the file itself is good
    CHECK(spoiled([](Json& f) { f["bodies"][1]["restitution"] = 1.5; }) ==
          "game.json: bodies[1].restitution is 1.5; expected a number from 0 to 1");
    CHECK(spoiled([](Json& f) { f["bodies"][0]["restitution"] = -1e-9; }) ==
          "game.json: bodies[0].restitution is -1e-09; expected a number from 0 to 1");
    CHECK(spoiled([](Json& f) { f["bodies"][2]["friction"] = -1; }) ==
          "game.json: bodies[2].friction is -1; expected a number, finite and at least 0");
    CHECK(spoiled([](Json& f) { f["bodies"][0]["ignored layers"] = 0.5; }) ==
          "game.json: bodies[0].ignored layers is 0.5; expected a whole number from 0 to 16777215");
    CHECK(spoiled([](Json& f) { f["policies"]["SoftSubsteps"]["parts"] = 0; }) ==
          "game.json: policies: SoftSubsteps: parts is 0; it is at least 1");
    CHECK(spoiled([](Json& f) { f["collisions"]["expected"] = -1; }) ==
          "game.json: collisions.expected is -1; expected a time step that is not negative");
    const auto begins_with = [](const std::string& said, const std::string& text) {
        INFO(said);
        CHECK(said.substr(0, text.size()) == text);
    };
    begins_with(spoiled([](Json& f) { f["collisions"]["contacts"][0]["normal"][1] = 7; }),
                "game.json: collisions.contacts[0].normal is [");
    begins_with(spoiled([](Json& f) { f["collisions"]["acting"][0]["numbers"][0] = -1; }),
                "game.json: collisions.acting[0].numbers[0] is -1; expected an impulse that is not negative");
    begins_with(spoiled([](Json& f) { f["collisions"]["acting"].push_back(f["collisions"]["acting"][0]); }),
                "game.json: collisions.acting[");
}

TEST_CASE("broadphases: cells, thresholds and depths", "[collision][refusals]") {
    const auto grid = [](const std::string& shown, double cell) {
        refuses_policy<UniformGrid<>>({}, with_broadphase,
                                      "UniformGrid: cell is " + shown + " m; it must be finite and not negative",
                                      [&](auto& g) { g.cell = cell * metre; });
    };
    grid("-1", -1), grid("nan", not_a_number), grid("inf", infinite);
    const auto tree = [&]<class Tree>(Tree policy, const std::string& name) {
        for (const int threshold : {0, -3})
            refuses_policy<Tree>(policy, with_broadphase,
                                 name + ": threshold is " + std::to_string(threshold) +
                                     "; a cell holds at least 1 body",
                                 [&](auto& t) { t.threshold = threshold; });
        for (const int depth : {-1, 65})
            refuses_policy<Tree>(policy, with_broadphase,
                                 name + ": depth is " + std::to_string(depth) + "; it is 0 to 64 divisions",
                                 [&](auto& t) { t.depth = depth; });
    };
    tree(Octree<>{}, "Octree");
    tree(BinarySplit<>{}, "BinarySplit");
}

TEST_CASE("responses: thresholds, stiffnesses, shares and parts", "[collision][refusals]") {
    const std::string not_negative = "; it must be finite and not negative",
                      positive = "; it must be finite and greater than zero";
    for (const auto& [value, shown] : {std::pair(-2.0, "-2"), {not_a_number, "nan"}, {infinite, "inf"}}) {
        const auto v = value;
        const std::string is = std::string(" is ") + shown;
        refuses_policy<Impulse<>>({}, with_response, "Impulse: threshold" + is + " m/s" + not_negative,
                                  [&](auto& p) { p.threshold = v * metre_per_second; });
        refuses_policy<Projection>({}, with_response, "Projection: slop" + is + " m" + not_negative,
                                   [&](auto& p) { p.slop = v * metre; });
        refuses_policy<Projection>({}, with_response, "Projection: share" + is + "; it is greater than 0 and at most 1",
                                   [&](auto& p) { p.share = v; });
        refuses_policy<Penalty>({}, with_response, "Penalty: stiffness" + is + " N/m" + positive,
                                [&](auto& p) { p.stiffness = v * newton_per_metre; });
        refuses_policy<Penalty>({}, with_response, "Penalty: damping" + is + " kg/s" + not_negative,
                                [&](auto& p) { p.damping = v * newton_second_per_metre; });
        using Soft = SoftSubsteps<Friction>;
        refuses_policy<Soft>({}, with_response, "SoftSubsteps: frequency" + is + " 1/s" + positive,
                             [&](auto& p) { p.frequency = v * hertz; });
        refuses_policy<Soft>({}, with_response,
                             "SoftSubsteps: damping_ratio" + is + "; it is finite and greater than zero",
                             [&](auto& p) { p.damping_ratio = v; });
        refuses_policy<Soft>({}, with_response, "SoftSubsteps: slop" + is + " m" + not_negative,
                             [&](auto& p) { p.slop = v * metre; });
        refuses_policy<Soft>({}, with_response, "SoftSubsteps: push_out" + is + " m/s" + positive,
                             [&](auto& p) { p.push_out = v * metre_per_second; });
        refuses_policy<Soft>({}, with_response, "SoftSubsteps: threshold" + is + " m/s" + not_negative,
                             [&](auto& p) { p.threshold = v * metre_per_second; });
    }
    refuses_policy<Penalty>({}, with_response, "Penalty: stiffness is 0 N/m" + positive,
                            [](auto& p) { p.stiffness = 0.0 * newton_per_metre; });
    for (const int n : {0, -1}) {
        refuses_policy<Impulse<Friction>>({}, with_response,
                                          "Impulse: sweeps is " + std::to_string(n) + "; it is at least 1",
                                          [&](auto& p) { p.sweeps = n; });
        refuses_policy<SoftSubsteps<>>({}, with_response,
                                       "SoftSubsteps: parts is " + std::to_string(n) + "; it is at least 1",
                                       [&](auto& p) { p.parts = n; });
    }
}

TEST_CASE("what a policy is set to acts from the next step on, and wakes bodies that lie on it", "[collision][set]") {
    // A ball that lies asleep on a soft floor wakes when the floor becomes stiffer, and comes up: m g / k.
    World world{SemiImplicitEuler{},
                Gravity{},
                Rest{},
                BoundingBoxes{},
                Narrowphase<Sphere, Plane>{},
                Penalty{1e3 * newton_per_metre, 60.0 * newton_second_per_metre}};
    world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 0.5, 0)), mass(1.0 * kilogram));
    for (int i = 0; i < 2000 && world.motion(ball) != Motion::resting; ++i) world.step(0.002 * second);
    REQUIRE(world.motion(ball) == Motion::resting);
    const double g = 9.81, soft = height_of(world, ball);
    CHECK(0.5 - soft == Approx(g / 1e3).epsilon(0.1)); // it fell asleep before it lay quite still
    world.set(Penalty{4e3 * newton_per_metre, 120.0 * newton_second_per_metre});
    CHECK(world.motion(ball) == Motion::awake);
    for (int i = 0; i < 2000 && world.motion(ball) != Motion::resting; ++i) world.step(0.002 * second);
    CHECK(0.5 - height_of(world, ball) == Approx(g / 4e3).epsilon(0.1));

    // Another broadphase parameter changes how pairs are found, and nothing else.
    auto one = scene(UniformGrid<>{}, Impulse<>{}), other = one;
    other.set(UniformGrid<>{3.0 * metre});
    for (auto* w : {&one, &other})
        for (int i = 0; i < 50; ++i) w->step(0.01 * second);
    CHECK(one.hash() == other.hash());
}

TEST_CASE("bounds of a column, in words and with its unit", "[collision][refusals]") {
    CHECK(ansatz::detail::range_of<Depth>() == "a number, finite and at most 2 m");
    CHECK(ansatz::detail::range_of<Position>() == "a number"); // none
    CHECK(ansatz::detail::in_range<Depth>(2.0));
    CHECK_FALSE(ansatz::detail::in_range<Depth>(2.1));
    CHECK(ansatz::detail::in_range<Depth>(-1e300));
    World world{SemiImplicitEuler{}, Keep<Depth>{}};
    refuses(world, "World::add: depth is 3 m; it is a number, finite and at most 2 m",
            [&] { world.add(with<Depth>(3.0 * metre)); });
}
