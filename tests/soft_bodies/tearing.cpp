// SPDX-License-Identifier: BSL-1.0
// Tearing: what a spring that breaks takes with it, and vertices that split, against a plain model of who exists; what
// a tear keeps; copies, hashes and files; room that is used up.

#include <ansatz/soft_bodies/tearing.hpp>

#include <ansatz/soft_bodies/area.hpp>
#include <ansatz/soft_bodies/tear.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/world/save.hpp>

#include "tests/soft_bodies/letting_go.hpp"
#include "tests/soft_bodies/support.hpp"

#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <utility>

using namespace soft_tests;
using Catch::Matchers::ContainsSubstring;

namespace {

template <class I, class Scalar, class Policy> auto tearing_world(const Policy& policy) {
    return World{Space<Scalar, 3>{},
                 I{},
                 Gravity{metres_per_second_squared(0, 0, 0)},
                 Springs<Breaking>{},
                 Bending{},
                 Wind{},
                 Area{},
                 policy};
}
/// A sheet that has everything on its triangles; two corners are held.
template <class World_> ClothParts add_sheet(World_& world, std::size_t n, std::size_t m) {
    auto cloth = woven(n, m);
    cloth.rigidity = 1e-4 * joule;
    cloth.drag = 0.5;
    cloth.pins = {0, std::uint32_t(n - 1)};
    const auto parts = add_cloth(world, cloth);
    for (const auto& [a, b, c] : cloth.mesh.triangles())
        world.add(Membrane{{parts.bodies[a], parts.bodies[b], parts.bodies[c]}, 5.0 * N_per_m});
    return parts;
}

using Ids = std::vector<std::uint32_t>;
template <class Of> Ids ids_of(const Of& bodies) {
    Ids all;
    for (const auto& body : bodies) all.push_back(body.id);
    return all;
}

/// As std::erase_if, which hands elements on as const.
template <class F> void erase(std::map<std::uint32_t, Ids>& all, F&& f) {
    for (auto it = all.begin(); it != all.end();) it = f(*it) ? all.erase(it) : std::next(it);
}

/// Who exists, by the rules as the header says them and by looking at everything.
struct Model {
    struct Triangle {
        Ids corners;
        bool torn;
        bool has(std::uint32_t body) const { return std::count(corners.begin(), corners.end(), body) > 0; }
    };
    std::map<std::uint32_t, Triangle> triangles;
    std::map<std::uint32_t, Ids> sails, membranes, hinges, springs; // their bodies

    template <class World_> static Model of(const World_& world) {
        Model model;
        world.template elements<TearableTriangle>().for_each([&](std::uint32_t id, const auto& row) {
            model.triangles[id] = {ids_of(row.corners), row.torn};
        });
        world.template elements<Sail>().for_each(
            [&](std::uint32_t id, const auto& row) { model.sails[id] = ids_of(row.corners); });
        world.template elements<Membrane>().for_each(
            [&](std::uint32_t id, const auto& row) { model.membranes[id] = ids_of(row.corners); });
        world.template elements<Hinge>().for_each(
            [&](std::uint32_t id, const auto& row) { model.hinges[id] = ids_of(row.bodies); });
        world.template elements<Spring>().for_each([&](std::uint32_t id, const auto& link) {
            model.springs[id] = {link.a, link.b};
        });
        return model;
    }
    bool operator==(const Model& other) const {
        const auto same = [](const Triangle& a, const Triangle& b) {
            return a.corners == b.corners && a.torn == b.torn;
        };
        return sails == other.sails && membranes == other.membranes && hinges == other.hinges &&
               springs == other.springs && triangles.size() == other.triangles.size() &&
               std::equal(triangles.begin(), triangles.end(), other.triangles.begin(),
                          [&](const auto& a, const auto& b) { return a.first == b.first && same(a.second, b.second); });
    }
    const Triangle* with(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        for (const auto& [id, triangle] : triangles)
            if (triangle.has(a) && triangle.has(b) && triangle.has(c)) return &triangle;
        return nullptr;
    }
    bool edge(std::uint32_t a, std::uint32_t b) const {
        for (const auto& [id, triangle] : triangles)
            if (triangle.has(a) && triangle.has(b)) return true;
        return false;
    }
    void tear(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& broken) {
        for (const auto& [a, b] : broken)
            for (auto& [id, triangle] : triangles)
                triangle.torn = triangle.torn || (triangle.has(a) && triangle.has(b));
        erase(sails, [&](const auto& s) { return with(s.second[0], s.second[1], s.second[2])->torn; });
        erase(membranes, [&](const auto& s) { return with(s.second[0], s.second[1], s.second[2])->torn; });
        erase(hinges, [&](const auto& h) {
            return with(h.second[0], h.second[1], h.second[2])->torn ||
                   with(h.second[0], h.second[1], h.second[3])->torn;
        });
        erase(springs, [&](const auto& s) {
            if (edge(s.second[0], s.second[1])) return false;
            for (const auto& [id, triangle] : triangles)
                for (const bool turned : {false, true}) {
                    const auto near = s.second[turned], far = s.second[!turned];
                    if (!triangle.torn || !triangle.has(near)) continue;
                    for (const auto middle : triangle.corners)
                        if (middle != near && edge(middle, far)) return true;
                }
            return false;
        });
    }
    /// The sides of a vertex: sets of triangles that hang together by edges, by their first ones.
    std::vector<Ids> sides(std::uint32_t body) const {
        std::vector<Ids> all;
        std::set<std::uint32_t> left;
        for (const auto& [id, triangle] : triangles)
            if (!triangle.torn && triangle.has(body)) left.insert(id);
        while (!left.empty()) {
            Ids side{*left.begin()};
            left.erase(left.begin());
            for (std::size_t k = 0; k < side.size(); ++k)
                for (auto it = left.begin(); it != left.end();) {
                    int shared = 0;
                    for (const auto corner : triangles.at(*it).corners) shared += triangles.at(side[k]).has(corner);
                    if (shared == 2) {
                        side.push_back(*it);
                        it = left.erase(it);
                    } else ++it;
                }
            all.push_back(side);
        }
        return all;
    }
    /// \param parts the new bodies in the order in which they came
    /// \return how many sides found no room
    std::size_t split(const std::set<std::uint32_t>& held, const std::vector<SplitVertex>& parts) {
        const auto before = *this;
        std::size_t used = 0, waiting = 0;
        std::set<std::uint32_t> bodies;
        for (const auto& [id, triangle] : triangles) bodies.insert(triangle.corners.begin(), triangle.corners.end());
        for (const auto body : bodies) {
            if (held.count(body) > 0) continue;
            const auto all = before.sides(body);
            for (std::size_t k = 1; k < all.size(); ++k) {
                if (used == parts.size()) {
                    ++waiting;
                    continue;
                }
                CHECK(parts[used].from.id == body);
                for (const auto id : all[k])
                    std::replace(triangles[id].corners.begin(), triangles[id].corners.end(), body, parts[used].to.id);
                ++used;
            }
        }
        CHECK(used == parts.size());
        const auto now = [&](std::uint32_t triangle, std::uint32_t body) {
            const auto& were = before.triangles.at(triangle).corners;
            return triangles.at(triangle)
                .corners[std::size_t(std::find(were.begin(), were.end(), body) - were.begin())];
        };
        const auto which = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            for (const auto& [id, triangle] : before.triangles)
                if (triangle.has(a) && triangle.has(b) && triangle.has(c)) return id;
            return 0xffffffffu;
        };
        for (auto* all : {&sails, &membranes})
            for (auto& [id, s] : *all) {
                const auto t = which(s[0], s[1], s[2]);
                s = {now(t, s[0]), now(t, s[1]), now(t, s[2])};
            }
        for (auto& [id, h] : hinges) {
            const auto t = which(h[0], h[1], h[2]), u = which(h[0], h[1], h[3]);
            CHECK(now(t, h[0]) == now(u, h[0])); // an edge that is whole is not divided
            h = {now(t, h[0]), now(t, h[1]), now(t, h[2]), now(u, h[3])};
        }
        erase(springs, [&](auto& spring) {
            auto& s = spring.second;
            const bool is_edge = before.edge(s[0], s[1]);
            bool across = false;
            for (const auto& [t, one] : before.triangles) {
                if (one.torn || !one.has(s[0])) continue;
                if (is_edge && one.has(s[1])) {
                    s = {now(t, s[0]), now(t, s[1])};
                    return false;
                }
                if (is_edge) continue;
                for (const auto& [u, other] : before.triangles)
                    for (const auto middle : one.corners)
                        if (!other.torn && other.has(s[1]) && middle != s[0] && other.has(middle)) {
                            across = true;
                            if (now(t, middle) != now(u, middle)) continue;
                            s = {now(t, s[0]), now(u, s[1])};
                            return false;
                        }
            }
            return across;
        });
        return waiting;
    }
};

template <class World_> VectorQuantity<unit::Momentum> momentum_of(const World_& world) {
    VectorQuantity<unit::Momentum> sum{};
    world.for_each([&](Handle body) {
        if (world.motion(body) == Motion::awake)
            sum += scalar_cast<double>(world.mass(body)) * scalar_cast<double>(world.velocity(body));
    });
    return sum;
}
/// The area of the triangles at a body that are not torn.
template <class World_> double whole_area_at(const World_& world, Handle body) {
    double sum = 0;
    world.template elements<TearableTriangle>().for_each([&](std::uint32_t, const auto& row) {
        if (!row.torn && row.has(body.id)) sum += double(row.area.value());
    });
    return sum;
}
template <class World_> void shake(World_& world, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-0.2, 0.2);
    for (const Handle body : world.handles())
        if (world.motion(body) == Motion::awake)
            world.set_velocity(body, metres_per_second(number(random), number(random), number(random)));
}
/// What a step with breaks makes of a model.
template <class World_> std::size_t follow(Model& model, const World_& world, const std::set<std::uint32_t>& held) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> broken;
    for (const auto& one : world.template elements<Spring>().broken()) {
        broken.push_back({one.first.body().id, one.second.body().id});
        model.springs.erase(one.which.id);
    }
    std::vector<bool> were;
    for (const auto& [id, triangle] : model.triangles) were.push_back(triangle.torn);
    auto torn = model;
    torn.tear(broken);
    bool any = false;
    std::size_t i = 0;
    for (const auto& [id, triangle] : torn.triangles) any = any || triangle.torn != were[i++];
    if (!any) return 0xffff; // only a thread, or a spring across
    model = torn;
    if constexpr (requires { world.split_vertices(); }) {
        const auto parts = world.split_vertices();
        return model.split(held, {parts.begin(), parts.end()});
    }
    return 0;
}

} // namespace

TEMPLATE_TEST_CASE("Random tears leave who is left by the rules, and keep mass and momentum", "[soft_bodies][tearing]",
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

TEST_CASE("Without room vertices wait, and part at the next tear when there is some", "[soft_bodies][tearing]") {
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
    CHECK(unbreakable.size() == 0);
    CHECK(world.size() == 3);
}
