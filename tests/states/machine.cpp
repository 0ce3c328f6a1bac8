// SPDX-License-Identifier: BSL-1.0
// What a machine does, in every representation: entry and exit order, hierarchy, histories, raised events, options,
// value.
// Runs long with the sanitizers.

#include <ansatz/states/bindings.hpp>
#include <ansatz/states/chart_build.hpp>
#include <ansatz/states/core.hpp>
#include <ansatz/states/describe.hpp>
#include <ansatz/states/dot.hpp>
#include <ansatz/states/ids.hpp>
#include <ansatz/states/interpreted_machine.hpp>
#include <ansatz/states/interpreted_moves.hpp>
#include <ansatz/states/machine.hpp>
#include <ansatz/states/model.hpp>
#include <ansatz/states/options.hpp>
#include <ansatz/states/outline.hpp>
#include <ansatz/states/queue.hpp>
#include <ansatz/states/regions.hpp>
#include <ansatz/states/reload.hpp>
#include <ansatz/states/scxml_write.hpp>
#include <ansatz/states/static_machine.hpp>

#include "tests/operator_new.hpp"
#include "tests/states/support.hpp"

using namespace states_tests;

namespace {
std::size_t allocations = 0;
[[maybe_unused]] const bool counted = [] {
    ansatz::test::before_allocation = [](std::size_t) noexcept { return ++allocations > 0; };
    return true;
}();
} // namespace

namespace {

struct Log {
    std::string did{};
    bool armed = true;
    void say(const char* what) { did += (did.empty() ? "" : " ") + std::string(what); }
    std::string since() { return std::exchange(did, {}); }
};
constexpr auto says(const char* what) {
    return [what](Log& l) { l.say(what); };
}

struct Patrol {
    int updates = 0, visits = 0;
    void enter(Log& l) { ++visits, l.say("enter"); }
    void update(Log&, Quantity<unit::Time> dt) { updates += dt.value() > 0; }
    void exit(Log& l) { l.say("exit"); }
};

struct Npc {
    using Context = Log;
    static constexpr auto machine = states::machine(
        state("calm", on_entry("hi", says("calm+")), on_exit("bye", says("calm-")),
              transition(on("alarm"), then("go", says("go")), to("combat")), transition(on("self"), to("calm")),
              state("idle", behaves<Patrol>("Patrol"), on_exit(says("idle-")), transition(on("walk"), to("patrol")),
                    transition(on("seen"), when([](const Log&, const Patrol& p) { return p.updates > 2; }),
                               to("combat"))),
              state("patrol", on_entry(says("patrol+")), transition(on("walk"), to("idle")),
                    transition(on("inside"), to("calm"), internal())),
              shallow_history("last", to("idle"))),
        state("combat", on_entry(says("combat+")), transition(on("flee"), to("last")),
              transition(on("done.state.combat"), then(says("won")), to("calm")),
              transition(on("stay"), then(says("stay"))), transition(on("outer"), to("deeper")),
              state("aim", each_update(says("aim")),
                    transition(when("armed", [](const Log& l) { return l.armed; }), to("shoot"))),
              state("shoot", on_entry(raise("loaded")), on_entry(says("shoot+")),
                    transition(on("loaded"), then(says("fire")), to("won")), state("deeper")),
              final_state("won")),
        final_state("dead"));
};

template <class R> using Seen = Machine<Npc, R, Everything>;

} // namespace

TEST_CASE("states are left from the inside, entered from the outside; the action is between", "[states]") {
    each_representation([]<class R>() {
        Log log;
        Seen<R> m;
        CHECK_FALSE(m.started());
        CHECK(m.active_names().empty());
        m.start(log);
        CHECK(log.since() == "calm+ enter");
        CHECK(text_since(m) == "+calm +idle");
        CHECK(m.active_name() == "idle");
        CHECK((m.is_in("calm") && m.is_in("idle") && !m.is_in("patrol") && !m.is_in("combat")));
        CHECK(m.active_names() == std::vector<std::string>{"calm", "idle"});
        CHECK(m.handle(log, "alarm")); // of the parent, while the child is active
        CHECK(log.since() == "exit idle- calm- go combat+");
        CHECK(text_since(m) == "-idle -calm *0 +combat +aim");
        // A transition without a target leaves nothing and enters nothing.
        CHECK(m.handle(log, "stay"));
        CHECK(log.since() == "stay");
        CHECK_FALSE(m.handle(log, "walk"));
        CHECK(m.is_in("aim"));
    });
}

TEST_CASE("a child fires its parent's self transition: child exit, parent exit, parent entry", "[states]") {
    each_representation([]<class R>() {
        Log log;
        Seen<R> m;
        m.start(log);
        m.handle(log, "walk");
        log.since(), text_since(m);
        m.handle(log, "self");
        CHECK(log.since() == "calm- calm+ enter");
        CHECK(text_since(m) == "-patrol -calm *1 +calm +idle");
        // An internal transition to its own state leaves that state too (SCXML 3.13), one into itself does not.
        m.handle(log, "walk");
        log.since(), text_since(m);
        m.handle(log, "inside");
        CHECK(text_since(m) == "-patrol -calm *5 +calm +idle");
    });
}

TEST_CASE(
    "conditions of every active ancestor, inner first, one an update; a raised event is handled before it returns",
    "[states]") {
    each_representation([]<class R>() {
        Log log;
        Seen<R> m;
        m.start(log);
        log.armed = false;
        m.handle(log, "alarm");
        log.since();
        CHECK_FALSE(m.update(log, frame));
        CHECK(log.since() == "aim");
        log.armed = true;
        text_since(m);
        CHECK(m.update(log, frame)); // aim, shoot, won, done.state.combat, calm: all of it
        CHECK(log.since() == "shoot+ fire won calm+ enter");
        CHECK(text_since(m) == "-aim *10 +shoot +deeper -deeper -shoot *11 +won -won -combat *7 +calm +idle");
        CHECK(m.is_in("idle"));
    });
}

TEST_CASE("a history returns to where its parent was, and a state keeps its data", "[states]") {
    each_representation([]<class R>() {
        Log log;
        log.armed = false;
        Seen<R> m;
        m.start(log);
        m.handle(log, "alarm");
        m.handle(log, "flee"); // the first time it knows idle from the exit
        CHECK(m.is_in("idle"));
        m.handle(log, "walk");
        m.handle(log, "alarm");
        m.handle(log, "flee");
        CHECK(m.is_in("patrol"));
        m.handle(log, "walk");
        for (int i = 0; i < 3; ++i) m.update(log, frame);
        const auto& patrol = m.template own<Patrol>(m.state("idle"));
        CHECK(patrol.visits == 3);
        CHECK(patrol.updates == 3);
        CHECK_THROWS(m.template own<Patrol>(m.state("patrol")));

        auto copy = m;                // a snapshot
        CHECK(m.handle(log, "seen")); // the guard reads the state's own data
        CHECK(m.is_in("combat"));
        CHECK(copy.is_in("idle"));
        m = copy;
        CHECK(m.is_in("idle"));
        CHECK(m.handle(log, "walk"));
        CHECK(m.is_in("patrol"));
        CHECK(copy.template own<Patrol>(copy.state("idle")).updates == 3);
        m.start(log); // anew: histories are forgotten
        m.handle(log, "alarm");
        CHECK(m.is_in("aim"));
    });
}

namespace {

struct Reentrant {
    std::function<bool()> call;
    int entered = 0;
};
struct Calls {
    using Context = Reentrant;
    static constexpr auto machine = states::machine(
        state("a", transition(on("go"), to("b"))),
        state("b", on_entry([](Reentrant& r) {
                  ++r.entered;
                  r.call();
              }),
              transition(on("go"), to("c")), transition(on("throw"), then([](Reentrant&) { throw 5; }), to("a"))),
        state("c"));
};
struct Forever {
    using Context = Log;
    static constexpr auto machine = states::machine(state("a", on_entry(raise("x")), transition(on("x"), to("b"))),
                                                    state("b", on_entry(raise("x")), transition(on("x"), to("a")),
                                                          transition(on("many"), then([](Log&, EventQueue& q) {
                                                                         for (int i = 0; i < 20; ++i)
                                                                             q.raise(EventId(1));
                                                                     }))));
};
struct Flat {
    using Context = Log;
    static constexpr auto machine =
        states::machine(state("a", transition(on("e"), to("b"))),
                        state("b", transition(on("e"), to("a")),
                              transition(on("armed"), when([](const Log& l) { return l.armed; }), to("a"))));
};

} // namespace

TEST_CASE(
    "handle within an action waits; an action that throws leaves a machine that works; endless events are stopped",
    "[states]") {
    each_representation([]<class R>() {
        Reentrant context;
        Machine<Calls, R> m;
        bool waits = false;
        context.call = [&] {
            waits = m.handle(context, "go");
            CHECK_THROWS(m.update(context, frame));
            return waits;
        };
        m.start(context);
        m.handle(context, "go");
        CHECK(waits);
        CHECK(m.is_in("c")); // through b, whose entry was complete before
        CHECK(context.entered == 1);
        context.call = [] { return true; };
        m.start(context);
        m.handle(context, "go");
        CHECK_THROWS_AS(m.handle(context, "throw"), int);
        m.start(context);
        CHECK(m.handle(context, "go"));
        CHECK(m.is_in("b"));

        Log log;
        Machine<Forever, R> f;
        f.start(log);
        CHECK(f.stuck());
        CHECK(f.dropped_events() == 0);
    });
}

namespace {

struct Circle {
    using Context = Log;
    static constexpr auto machine = states::machine(state("a", transition(on("x"), then(raise("y")), to("b"))),
                                                    state("b", transition(on("y"), then(raise("x")), to("a"))));
};

} // namespace

TEST_CASE("start is anew: no event of before, not stuck; not from an action; what is no state has no name",
          "[states]") {
    each_representation([]<class R>() {
        Reentrant context;
        Machine<Calls, R> m;
        m.start(context);
        context.call = [&]() -> bool {
            m.handle(context, "go");
            throw 5;
        }; // one waits, and then
        CHECK_THROWS_AS(m.handle(context, "go"), int);
        std::string said;
        context.call = [&] {
            said = refusal([&] { m.start(context); });
            return true;
        };
        m.start(context);
        CHECK(m.is_in("a"));
        CHECK(m.handle(context, "go"));
        CHECK_THAT(said, ContainsSubstring("Machine::start: called from an action"));
        CHECK(m.is_in("b"));
        CHECK(m.name(StateId::none).empty());
        CHECK(m.name(StateId(99)).empty());
        CHECK(m.name(EventId::none) == "*");

        Log log;
        Machine<Circle, R> circle;
        circle.start(log);
        circle.handle(log, "x");
        CHECK(circle.stuck());
        circle.start(log);
        CHECK_FALSE(circle.stuck());
    });
}

TEST_CASE("before start nothing is handled; an update's time is a time", "[states]") {
    each_representation([]<class R>() {
        Log log;
        Machine<Flat, R> m;
        CHECK_THAT(refusal([&] { m.handle(log, "e"); }), ContainsSubstring("call start(context)"));
        CHECK_THAT(refusal([&] { m.update(log, frame); }), ContainsSubstring("call start(context)"));
        m.start(log);
        CHECK_THAT(refusal([&] { m.update(log, -frame); }), ContainsSubstring("dt is -0.01666"));
        CHECK_THAT(refusal([&] { m.update(log, double(NAN) * second); }), ContainsSubstring("dt is nan s"));
        CHECK_THAT(refusal([&] { m.state("nowhere"); }), ContainsSubstring("no state \"nowhere\""));
        CHECK(m.handle(log, event<Flat>("e")));
        CHECK(m.is_in("b"));
        CHECK_FALSE(m.handle(log, EventId(999)));
        CHECK_FALSE(m.handle(log, EventId::none));
    });
}

TEST_CASE("an event that nobody handles: ignored, counted, kept, refused", "[states]") {
    each_representation([]<class R>() {
        Log log;
        log.armed = false;
        Machine<Flat, R, CountUnhandled> counts;
        counts.start(log);
        for (int i = 0; i < 3; ++i) counts.handle(log, "armed"); // a has no such transition
        counts.handle(log, "e");
        counts.handle(log, "armed"); // b has one, whose guard does not hold
        counts.handle(log, "never heard of");
        CHECK(counts.template get<CountUnhandled>().count == 5);

        Machine<Flat, R, LogUnhandled<2>, Everything> keeps;
        keeps.start(log);
        keeps.update(log, 2.0 * second);
        keeps.handle(log, "armed");
        keeps.handle(log, "e");
        keeps.handle(log, "armed");
        keeps.handle(log, "other");
        const auto& kept = keeps.template get<LogUnhandled<2>>();
        CHECK(kept.count == 3);
        REQUIRE(kept.size() == 2);
        CHECK(keeps.name(kept[0].event) == "armed");
        CHECK(keeps.name(kept[0].state) == "b");
        CHECK(kept[0].time.value() == 2);
        CHECK(keeps.name(kept[1].event) == "*");

        Machine<Flat, R, RefuseUnhandled> refuses;
        refuses.start(log);
        CHECK_THAT(refusal([&] { refuses.handle(log, "armed"); }),
                   ContainsSubstring("nobody handles the event \"armed\" in the state \"a\""));
        CHECK(refuses.is_in("a"));
        CHECK(refuses.handle(log, "e"));

        Machine<Flat, R, Recorded<3>> records;
        records.start(log);
        records.handle(log, "e");
        const auto& seen = records.template get<Recorded<3>>();
        CHECK(seen.count == 4);
        CHECK(seen[0].what == Happening::What::exited);
        CHECK(seen[2].what == Happening::What::entered);
    });
}

TEST_CASE("no heap on the way of an event; no byte for what a machine does not do", "[states]") {
    each_representation([]<class R>() {
        Log log;
        Machine<Npc, R> m;
        m.start(log);
        log.armed = false;
        log.did.reserve(4096);
        const auto alarm = event<Npc>("alarm"), flee = event<Npc>("flee"), walk = event<Npc>("walk");
        for (int warm = 0; warm < 2; ++warm) {
            const auto before = allocations;
            for (int i = 0; i < 20; ++i) {
                m.handle(log, i % 2 ? flee : alarm);
                m.handle(log, walk);
                m.update(log, frame);
            }
            CHECK(allocations == before);
        }
    });
    CHECK(sizeof(Machine<Flat, Switch>) == 2);
    CHECK(sizeof(Machine<Flat, Table>) == 2);
    CHECK(std::is_trivially_copyable_v<Machine<Npc, Switch>>);
}

TEST_CASE("a machine as text and as a picture", "[states]") {
    Log log;
    Machine<Npc, Switch> m;
    m.start(log);
    const auto outline = outline_of<Npc>();
    const auto xml = write_scxml(outline);
    CHECK_THAT(xml, ContainsSubstring("<state id=\"idle\" ansatz:class=\"Patrol\">"));
    CHECK_THAT(xml, ContainsSubstring("<transition cond=\"armed\" target=\"shoot\"/>"));
    CHECK_THAT(xml, ContainsSubstring("<history id=\"last\" type=\"shallow\">"));
    CHECK_THAT(xml, ContainsSubstring("<script>patrol: entry 1</script>")); // what has no name says where it stands
    const auto dot = to_dot(outline, m.active_names());
    CHECK_THAT(dot, ContainsSubstring("\"idle\" [fillcolor=\"#0072b2\", color=\"#0072b2\", fontcolor=white];"));
    CHECK_THAT(dot, ContainsSubstring("subgraph \"cluster_calm\""));
    CHECK_THAT(dot, ContainsSubstring("\"dead\" [peripheries=2];"));
    CHECK_THAT(dot,
               ContainsSubstring("\" combat\" -> \" calm\" [label=\"done.state.combat\", ltail=\"cluster_combat\""));
    CHECK(std::count(dot.begin(), dot.end(), '{') == std::count(dot.begin(), dot.end(), '}'));
    CHECK_THAT(to_dot(make_chart(outline, bindings_of<Npc>())->outline()), !ContainsSubstring("fontcolor=white"));
}
