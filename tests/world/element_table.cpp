// SPDX-License-Identifier: BSL-1.0
// Elements of a user's own: ties between bodies that wear, and lamps that hang on no body, in a table whose rows follow
// from their fields.
// Runs long with the sanitizers.

#include <ansatz/world/element_table.hpp>

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/world/files.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <sstream>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {

//! [tie]
/// Keeps two bodies at a distance: what `world.add` takes.
struct Tie {
    using element = Tie;
    Handle first, second;
    Parameter<unit::Length> length = 1.0 * metre;
};
/// What is kept of it.
template <class S> struct TieRow {
    BodyId first, second;
    typename S::Length length{};
    std::uint64_t used = 0; // steps in which it has pulled
    static void fields(auto& self, auto&& field) {
        field("first", self.first);
        field("second", self.second);
        field("length", self.length);
        field("used", self.used);
    }
    static TieRow from(const auto& asked, const Tie& tie) {
        return {asked.body(tie.first), asked.body(tie.second), S::convert("length", tie.length)};
    }
    Tie describe(const auto& handle_of) const {
        return {handle_of(first), handle_of(second), scalar_cast<double>(length)};
    }
    void check() const {
        if (first == second) refuse_value("a tie", "its ends", "one body", "it holds two");
        if (!(length.value() > 0)) refuse_value("a tie", "length", length, "it is greater than zero");
    }
};
/// The policy: behind the integrator, bodies that are too far apart are pulled together.
struct Ties {
    using role = roles::System;
    using Element = Tie;
    static constexpr std::string_view name = "Ties";
    template <class S> using State = ElementTable<S, Tie, TieRow<S>>;
    template <class S> struct Pull {
        static constexpr Phase phase = phases::positions;
        static constexpr std::string_view name = "ties";
        using writes = Columns<Position>;
        using reads = Columns<InverseMass>;
        explicit Pull(const Ties&) {}
        void run(auto& view, const auto&) const {
            view.state().for_each([&](std::uint32_t, auto& tie) {
                const auto a = view.slot(tie.first), b = view.slot(tie.second);
                const auto wa = view.template get<InverseMass>(a), wb = view.template get<InverseMass>(b);
                const auto xa = view.template get<Position>(a), xb = view.template get<Position>(b);
                const auto apart = norm(xb - xa);
                if (!(apart > tie.length) || !((wa + wb).value() > 0)) return;
                const auto way = ((apart - tie.length) / (apart * (wa + wb))) * (xb - xa);
                view.template set<Position>(a, xa + wa * way);
                view.template set<Position>(b, xb - wb * way);
                ++tie.used;
            });
        }
    };
    template <class S> using systems = Types<Pull<S>>;
};
//! [tie]

/// Hangs on no body.
struct Lamp {
    using element = Lamp;
    double strength = 1;
};
struct LampRow {
    double strength = 1;
    std::vector<double> flicker{};
    static void fields(auto& self, auto&& field) {
        field("strength", self.strength);
        field("flicker", self.flicker);
    }
    static LampRow from(const auto& asked, const Lamp& lamp) {
        if (!(lamp.strength >= 0)) refuse_value(asked.where, "strength", lamp.strength, "it is not negative");
        return {lamp.strength, {lamp.strength / 2, lamp.strength}};
    }
};
struct Lamps {
    using role = roles::System;
    using Element = Lamp;
    static constexpr std::string_view name = "Lamps";
    template <class S> using State = ElementTable<S, Lamp, LampRow>;
};

/// A row that owns memory, and of which the n-th copy fails.
struct Fragile {
    using element = Fragile;
};
struct FragileRow {
    static inline int copies_left = -1; // -1: as many as are wanted
    std::vector<double> numbers = {1, 2, 3};
    FragileRow() = default;
    FragileRow(const FragileRow& other) : numbers(other.numbers) {
        if (copies_left == 0) throw std::runtime_error("no more copies");
        if (copies_left > 0) --copies_left;
    }
    FragileRow(FragileRow&&) noexcept = default;
    FragileRow& operator=(const FragileRow& other) { return *this = FragileRow(other); }
    FragileRow& operator=(FragileRow&&) noexcept = default;
    static void fields(auto& self, auto&& field) { field("numbers", self.numbers); }
    static FragileRow from(const auto&, const Fragile&) { return {}; }
};
struct Fragiles {
    using role = roles::System;
    using Element = Fragile;
    static constexpr std::string_view name = "Fragiles";
    template <class S> using State = ElementTable<S, Fragile, FragileRow>;
};

template <class I = SemiImplicitEuler> auto a_world() {
    return World{I{}, Gravity{}, Rest{}, Ties{}, Lamps{}, Keep<InverseMass>{}};
}
constexpr auto dt = 1.0 / 60 * second;

} // namespace

TEMPLATE_TEST_CASE("ties hold what hangs on them, and rows count what systems did", "[world][elements]",
                   SemiImplicitEuler, Verlet) {
    auto world = a_world<TestType>();
    const auto nail = world.add(fixed);
    const auto ball = world.add(position(metres(1, 0, 0)), mass(2.0 * kilogram));
    const auto tie = world.add(Tie{nail, ball, 1.0 * metre});
    for (int i = 0; i < 100; ++i) world.step(dt);
    CHECK(norm(world.position(ball)).value() <= 1 + 1e-12);
    CHECK(world.position(ball).value()[1] < -0.3);
    const auto& ties = world.template elements<Tie>();
    CHECK(ties.row(ties.id(tie, "here")).used > 50);
    CHECK(world.get(tie).first == nail);
    CHECK(world.get(tie).length.value() == 1.0);
    world.set(tie, Tie{nail, ball, 0.5 * metre});
    world.step(dt);
    CHECK(norm(world.position(ball)).value() <= 0.5 + 1e-12);
}

TEST_CASE("verbs on elements of one's own agree with a model of which bodies are tied", "[world][elements]") {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        auto world = a_world();
        std::vector<Handle> bodies;
        struct Known {
            ElementHandle<Tie> tie;
            Handle first, second;
            double length;
        };
        std::vector<Known> ties;
        std::vector<std::pair<ElementHandle<Lamp>, double>> lamps;
        for (int i = 0; i < 120; ++i) {
            const auto verb = random() % 8;
            const double number = 0.5 + double(random() % 1000) / 1000;
            CAPTURE(i, verb);
            if (verb <= 1 || bodies.size() < 3)
                bodies.push_back(
                    world.add(position(metres(double(bodies.size()), 0, number)), mass(number * kilogram)));
            else if (verb <= 3) {
                const auto a = bodies[random() % bodies.size()], b = bodies[random() % bodies.size()];
                if (a == b)
                    CHECK(refusal([&] {
                              world.add(Tie{a, b, number * metre});
                          }) == "a tie: its ends is one body; it holds two");
                else ties.push_back({world.add(Tie{a, b, number * metre}), a, b, number});
            } else if (verb == 4 && !ties.empty()) {
                const auto which = random() % ties.size();
                world.remove(ties[which].tie);
                CHECK_FALSE(world.contains(ties[which].tie));
                ties.erase(ties.begin() + std::ptrdiff_t(which));
            } else if (verb == 5) {
                const auto gone = bodies[random() % bodies.size()];
                world.remove(gone);
                std::erase(bodies, gone);
                std::erase_if(ties, [&](const Known& k) { return k.first == gone || k.second == gone; });
            } else if (verb == 6) lamps.emplace_back(world.add(Lamp{number}), number);
            else world.step(dt);

            auto copy = world;
            auto loaded = a_world();
            load_text(loaded, text_of(world));
            for (const auto* seen : {&world, &copy, &loaded}) {
                REQUIRE(seen->elements<Tie>().size() == ties.size());
                for (const auto& k : ties) {
                    REQUIRE(seen->contains(k.tie));
                    const auto tie = seen->get(k.tie);
                    REQUIRE((tie.first == k.first && tie.second == k.second && tie.length.value() == k.length));
                }
                for (const auto& [lamp, strength] : lamps) {
                    const auto& all = seen->elements<Lamp>();
                    REQUIRE(all.row(all.id(lamp, "here")).strength == strength);
                    REQUIRE(all.row(all.id(lamp, "here")).flicker.size() == 2);
                }
                REQUIRE(seen->hash() == world.hash());
            }
            for (auto* later : {&copy, &loaded}) later->step(dt);
            REQUIRE(copy.hash() == loaded.hash());
            if (!bodies.empty() && !ties.empty()) { // the next handle is the same in all of them
                const Tie next{ties[0].first, ties[0].second, 2.0 * metre};
                REQUIRE(copy.add(next) == loaded.add(next));
            }
        }
    }
}

TEST_CASE("a file with a row that cannot be is refused with its place, and the world is as it was",
          "[world][elements][save]") {
    auto world = a_world();
    const auto a = world.add(position(metres(0, 1, 0)), mass(1.0 * kilogram)), b = world.add(mass(1.0 * kilogram));
    world.add(Tie{a, b, 3.0 * metre});
    world.add(Lamp{0.25});
    const auto hash = world.hash();
    const auto text = text_of(world);
    const auto with = [&](std::string_view what, std::string_view instead) {
        auto changed = text;
        const auto at = changed.find(what);
        REQUIRE(at != std::string::npos);
        changed.replace(at, what.size(), instead);
        const auto said = refusal([&] { load_text(world, changed); });
        CHECK(world.hash() == hash);
        return said;
    };
    CHECK(with("\"first\": 0", "\"first\": 7") ==
          "load: elements.Ties.list[0].row.first is 7; expected the id of a body that is in the file");
    CHECK(with("\"first\": 0", "\"first\": -1") ==
          "load: elements.Ties.list[0].row.first is -1; expected a whole number from 0 to 4294967295");
    CHECK(with("\"second\": 1", "\"second\": 0") ==
          "load: elements.Ties.list[0].row: a tie: its ends is one body; it holds two");
    CHECK(with("\"length\": 3.0", "\"length\": -3.0").find("length is -3 m; it is greater than zero") !=
          std::string::npos);
    CHECK(with("\"strength\": 0.25", "\"strength\": \"much\"") ==
          "load: elements.Lamps.list[0].row.strength is \"much\"; expected a finite number");
    CHECK(with("\"flicker\"", "\"flame\"") ==
          "load: elements.Lamps.list[0].row: expected \"flicker\", but there is none");
}

TEST_CASE("a stale or foreign handle of an element is refused, and what is not acceptable changes nothing",
          "[world][elements]") {
    auto world = a_world();
    const auto a = world.add(mass(1.0 * kilogram)), b = world.add(position(metres(0, 0, 2)), mass(1.0 * kilogram));
    const auto tie = world.add(Tie{a, b});
    const auto hash = world.hash();
    CHECK(refusal([&] { world.add(Tie{a, Handle{9, 0}}); }).find("World::add") != std::string::npos);
    CHECK(refusal([&] { world.add(Tie{a, b, -1.0 * metre}); }).find("length is -1 m") != std::string::npos);
    CHECK(refusal([&] { world.set(tie, Tie{a, a}); }) == "a tie: its ends is one body; it holds two");
    CHECK(refusal([&] { world.add(Lamp{-1}); }).find("World::add: strength is -1") != std::string::npos);
    CHECK(world.hash() == hash);
    world.remove(b);
    CHECK_FALSE(world.contains(tie)); // it went with the body that it held
    CHECK_THROWS_AS(world.get(tie), std::out_of_range);
    CHECK_THROWS_AS(world.remove(tie), std::out_of_range);
}

TEST_CASE("no copy of a row is made that could fail when the world has been told of it", "[world][elements][V10]") {
    World world{SemiImplicitEuler{}, Fragiles{}};
    FragileRow::copies_left = 0;
    const auto first = world.add(Fragile{}); // grows, too
    for (int i = 0; i < 20; ++i) world.add(Fragile{});
    world.set(first, Fragile{});
    CHECK(world.elements<Fragile>().size() == 21);
    const auto hash = world.hash();
    CHECK_THROWS_AS([&] { auto copy = world; }(), std::runtime_error); // a copy of the world needs them
    CHECK(world.hash() == hash);
    FragileRow::copies_left = -1;
}

namespace {
/// Names bodies in a list of pairs, and one more or no body.
struct Net {
    using element = Net;
    std::vector<std::array<Handle, 2>> pairs;
    std::optional<Handle> owner;
};
template <class S> struct NetRow {
    std::vector<std::array<BodyId, 2>> pairs;
    BodyId owner;
    static void fields(auto& self, auto&& field) {
        field("pairs", self.pairs);
        field("owner", self.owner);
    }
    static NetRow from(const auto& asked, const Net& net) {
        NetRow row;
        for (const auto& [a, b] : net.pairs) row.pairs.push_back({asked.body(a), asked.body(b)});
        if (net.owner) row.owner = asked.body(*net.owner);
        return row;
    }
};
struct Nets {
    using role = roles::System;
    using Element = Net;
    static constexpr std::string_view name = "Nets";
    template <class S> using State = ElementTable<S, Net, NetRow<S>>;
};
} // namespace

TEST_CASE("a row follows bodies in lists of lists, and one that names no body waits for none",
          "[world][elements][named_by]") {
    World world{SemiImplicitEuler{}, Rest{}, Nets{}};
    std::vector<Handle> bodies;
    for (int i = 0; i < 6; ++i) bodies.push_back(world.add(position(metres(i, 0, 0))));
    const auto of_pairs = world.add(Net{{{bodies[0], bodies[1]}, {bodies[2], bodies[3]}}, std::nullopt});
    const auto owned = world.add(Net{{}, bodies[4]});
    const auto of_nobody = world.add(Net{});
    world.step(0.1 * second);
    std::stringstream file;
    save(world, file);
    World loaded{SemiImplicitEuler{}, Rest{}, Nets{}};
    load(loaded, file);
    CHECK(loaded.hash() == world.hash());
    for (auto* one : {&world, &loaded}) {
        one->remove(bodies[5]);
        CHECK(one->elements<Net>().size() == 3);
        one->remove(bodies[3]);
        CHECK(!one->contains(of_pairs));
        one->remove(bodies[4]);
        CHECK(!one->contains(owned));
        CHECK(one->contains(of_nobody));
        one->step(0.1 * second);
    }
    CHECK(loaded.hash() == world.hash());
}
