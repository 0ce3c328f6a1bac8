// SPDX-License-Identifier: BSL-1.0
// A plan of chapter 6 that runs through a state machine of chapter 5 (notes 6.2, 5).

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/goap/by_machine.hpp>
#include <ansatz/states/machine.hpp>

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

using namespace ansatz;
using namespace ansatz::states;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A fire, of wood that is felled or of sticks that are gathered.
struct Camp {
    goap::Domain<> domain;
    goap::Fact lies = domain.fact("an axe lies there"), axe = domain.fact("has axe"), wood = domain.fact("has wood"),
               fire = domain.fact("fire burns");
    goap::Action take = domain.action("take axe", 1).needs(lies).makes(axe, !lies);
    goap::Action fell = domain.action("fell tree", 3).needs(axe).makes(wood);
    goap::Action gather = domain.action("gather sticks", 9).makes(wood);
    goap::Action light = domain.action("light fire", 1).needs(wood).makes(fire, !wood);
};

struct Man {
    const Camp* camp;
    goap::State<> now;
    int blows = 0, felled = 0;
    bool slips = false, rain = false;
    void does(goap::Action a) { now = camp->domain.rules()[a].after(now); }
};

struct Woodcutter {
    using Context = Man;
    static constexpr auto machine = states::machine(
        transition(on("take_axe"), to("take axe")), transition(on("fell_tree"), to("fell tree")),
        transition(on("gather_sticks"), to("gather sticks")),
        transition(on("light_fire"), when("dry", [](const Man& m) { return !m.rain; }), to("light fire")),
        state("idle"),
        state("take axe", on_entry([](Man& m) { m.does(m.camp->take); }), transition(to("done"))), // over at once
        state("fell tree", on_entry([](Man& m) { m.blows = 0; }), each_update([](Man& m) { ++m.blows; }),
              transition(when("slips", [](const Man& m) { return m.slips && m.blows == 2; }),
                         then([](Man& m) { m.slips = false; }), to("hurt")),
              transition(when("falls", [](const Man& m) { return m.blows == 3; }),
                         then([](Man& m) { m.does(m.camp->fell), ++m.felled; }), to("done"))),
        state("gather sticks",
              transition(when(after(2.0 * second)), then([](Man& m) { m.does(m.camp->gather); }), to("done"))),
        state("light fire", state("strike", transition(when("sparks", [](const Man&) { return true; }), to("blow"))),
              state("blow", transition(when("burns", [](const Man&) { return true; }),
                                       then([](Man& m) { m.does(m.camp->light); }), to("done")))),
        state("done"), state("hurt"));
};

template <class Representation> struct Evening {
    Camp camp;
    Man man{&camp, camp.domain.state({camp.lies})};
    Machine<Woodcutter, Representation, Recorded<64>> machine;
    goap::Planner<goap::Domain<>> planner{camp.domain};
    goap::Runner<goap::Planner<goap::Domain<>>> runner{planner};
    goap::Performance performance;
    int ticks = 0; // of the machine
    Evening() {
        machine.start(man);
        runner.go(man.now, camp.domain.condition({camp.fire}));
    }
    goap::ByMachine<decltype(machine)> crew{machine, man, camp.domain, 0.5 * second};
    bool tick() {
        ++ticks;
        return goap::perform(runner, crew, performance, [&] { return man.now; });
    }
    void to_the_end() {
        while (ticks < 50 && tick()) {
        }
    }
    /// The states that the machine entered, in order; the actions among them are the plan.
    std::string entered(bool only_actions = false) const {
        std::string text;
        const auto& trace = machine.template get<Recorded<64>>();
        for (std::size_t i = 0; i < trace.size(); ++i) {
            if (trace[i].what != Happening::What::entered) continue;
            const std::string name(machine.name(trace[i].state));
            bool action = false;
            for (goap::Action a = 0; a < camp.domain.actions(); ++a) action = action || camp.domain.name_of(a) == name;
            if (action || !only_actions) text += (text.empty() ? "" : ", ") + name;
        }
        return text;
    }
};

} // namespace

TEMPLATE_TEST_CASE("a plan runs through a machine, and the machine's trace is the plan", "[goap]", Switch,
                   Interpreted) {
    Evening<TestType> e;
    static_assert(goap::Performer<decltype(e.crew)>);
    CHECK(e.planner.why() == "take axe, fell tree, light fire");
    e.to_the_end();
    CHECK(e.runner.reached());
    CHECK(e.man.now == e.camp.domain.state({e.camp.axe, e.camp.fire})); // what the plan said
    CHECK(e.runner.plans() == 1);
    CHECK(e.entered(true) == e.planner.why());
    CHECK(e.entered() == "idle, take axe, done, fell tree, done, light fire, strike, blow, done");
    CHECK(e.ticks == 1 + 4 + 2); // at once; three blows and the look at what they did; two conditions
    CHECK_FALSE(e.tick());       // nothing more to do, and nothing is done
    CHECK(e.machine.active_name() == "done");
}

TEMPLATE_TEST_CASE("an action that fails in the machine is planned anew", "[goap]", Switch, Interpreted) {
    Evening<TestType> e;
    e.man.slips = true;
    for (int i = 0; i < 4; ++i) REQUIRE(e.tick()); // the axe, two blows, and the slip
    CHECK(e.machine.active_name() == "hurt");
    CHECK(e.runner.plans() == 2);
    CHECK_FALSE(e.man.now.has(e.camp.wood.number));
    e.to_the_end();
    CHECK(e.runner.reached());
    CHECK(e.runner.plans() == 2);
    CHECK(e.entered() == "idle, take axe, done, fell tree, hurt, fell tree, done, light fire, strike, blow, done");
    CHECK(e.man.felled == 1);
}

TEMPLATE_TEST_CASE("a world that breaks the plan takes the machine out of its action", "[goap]", Switch, Interpreted) {
    Evening<TestType> e;
    for (int i = 0; i < 3; ++i) REQUIRE(e.tick());
    CHECK(e.machine.active_name() == "fell tree");
    CHECK(e.man.blows == 2);
    e.man.now.set(e.camp.axe.number, false); // a thief
    REQUIRE(e.tick());
    CHECK(e.runner.plans() == 2);
    CHECK(e.planner.why() == "gather sticks, light fire");
    CHECK(e.machine.active_name() == "gather sticks");
    e.to_the_end();
    CHECK(e.runner.reached());
    CHECK(e.entered() == "idle, take axe, done, fell tree, gather sticks, done, light fire, strike, blow, done");
    CHECK(e.man.blows == 2);
    CHECK(e.man.felled == 0);
    CHECK(e.ticks == 3 + 4 + 2); // 2 s of gathering are four ticks of 0.5 s: the machine's clock runs
}

TEMPLATE_TEST_CASE("what the machine refuses has failed, though it still stands in done", "[goap]", Switch,
                   Interpreted) {
    Evening<TestType> e;
    for (int i = 0; i < 5; ++i) REQUIRE(e.tick());
    CHECK(e.runner.action() == e.camp.light);
    CHECK(e.machine.active_name() == "done");
    e.man.rain = true;
    for (int i = 0; i < 3; ++i) REQUIRE(e.tick());
    CHECK(e.runner.plans() == 4);                // each refusal is planned anew
    CHECK(e.machine.time() == 8 * 0.5 * second); // and the machine goes on
    CHECK_FALSE(e.machine.is_in("light fire"));
    e.crew.begin(e.camp.light); // asked itself: the runner would plan anew either way, since nothing burns
    CHECK(e.crew.tick(e.camp.light) == goap::Progress::failed);
    e.man.rain = false;
    e.to_the_end();
    CHECK(e.runner.reached());
    CHECK(e.ticks == 5 + 3 + 2);
    CHECK(e.entered(true) == "take axe, fell tree, light fire");
}

TEST_CASE("a machine that does not know the actions is refused", "[goap]") {
    Evening<Switch> e;
    using Crew = goap::ByMachine<decltype(e.machine)>;
    auto made = [&](const goap::Domain<>& domain, Quantity<unit::Time> dt, std::string_view done) {
        return test::refusal([&] { Crew(e.machine, e.man, domain, dt, done); });
    };
    goap::Domain<> other;
    other.action("take axe");
    CHECK_NOTHROW(Crew(e.machine, e.man, other, 0.5 * second, "hurt")); // another state may mean that it is done
    CHECK_THAT(made(other, 0.5 * second, "finished"), ContainsSubstring("\"finished\" is no state of the machine"));
    for (const double bad : {-0.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        CHECK_THAT(made(other, bad * second, "done"), ContainsSubstring("dt is " + describe(bad * second)));
    goap::Domain<> more = other;
    more.action("sing");
    CHECK_THAT(made(more, 0.5 * second, "done"),
               ContainsSubstring("the action \"sing\" is no state of the machine; add state(\"sing\", ...)"));
    other.action("hurt");
    CHECK_THAT(made(other, 0.5 * second, "done"),
               ContainsSubstring(
                   "the event \"hurt\" is not mentioned by the machine; add transition(on(\"hurt\"), to(\"hurt\"))"));
    CHECK_THAT(test::refusal([&] { e.crew.begin(4); }),
               ContainsSubstring("the action is 4; the domain had 4 when this was made"));
    CHECK_THAT(test::refusal([&] { e.crew.tick(4); }), ContainsSubstring("the action is 4"));
    CHECK(e.machine.active_name() == "idle"); // nothing half-changed
}
