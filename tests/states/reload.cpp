// SPDX-License-Identifier: BSL-1.0
// What a machine from a file keeps when it goes on in another chart, is assigned another machine, or throws.

#include <ansatz/states/machine.hpp>
#include <ansatz/states/reload.hpp>
#include <ansatz/states/save.hpp>

#include "tests/states/support.hpp"

#include <sstream>
#include <string>
#include <vector>

using namespace states_tests;

namespace {
struct Npc {
    bool fails = false;
    int entered = 0;
};
using FromFile = Machine<InFile<Npc>, Interpreted>;
using states::Kind;

Outline::State one(const char* name, std::size_t parent = 0, Kind kind = Kind::state) {
    Outline::State s;
    s.name = name;
    s.parent = parent;
    s.kind = kind;
    return s;
}
Outline::Transition go(std::size_t from, const char* event, const char* to) {
    Outline::Transition t;
    t.source = from;
    t.events = event;
    t.targets = {to};
    return t;
}
/// An action that counts, or fails.
Bindings<Npc> greeting() {
    Bindings<Npc> names;
    names.action("hello", [](Npc& n) {
        if (n.fails) throw 5;
        ++n.entered;
    });
    return names;
}
/// Work of two kinds, each in two steps, a break, and back to where the work was.
Outline work(Kind history, bool parallel) {
    Outline o;
    o.states = {one(""),         one("work"),   one("plan", 1), one("rough", 2),          one("fine", 2),
                one("build", 1), one("lay", 5), one("join", 5), one("where", 1, history), one("break")};
    o.states[8].initial = {"plan"};
    o.transitions = {go(1, "rest", "break"), go(1, "step", "join"), go(9, "back", "where")};
    if (parallel) {
        for (const char* name : {"both", "left", "right"})
            o.states.push_back(
                one(name, o.states.size() > 10 ? 10 : 0, o.states.size() > 10 ? Kind::state : Kind::parallel));
        o.transitions.push_back(go(9, "two", "both"));
    }
    return o;
}
} // namespace

TEST_CASE("histories stay with their states when a machine goes on in another chart, with parallel states or without",
          "[states]") {
    for (const Kind history : {Kind::shallow_history, Kind::deep_history})
        for (const bool before : {false, true})
            for (const bool after : {false, true}) {
                INFO("deep " << (history == Kind::deep_history) << ", parallel before " << before << ", after "
                             << after);
                const auto begun = [&](const Outline& next) {
                    Npc npc;
                    FromFile machine{make_chart<Npc>(work(history, before), {})};
                    machine.start(npc);
                    for (const char* event : {"step", "rest"}) machine.handle(npc, event);
                    machine.reload(npc, make_chart<Npc>(next, {}));
                    machine.handle(npc, "back");
                    return std::string(machine.active_name());
                };
                CHECK(begun(work(history, after)) == (history == Kind::deep_history ? "join" : "lay"));
                // A state that is gone is not remembered, nor one that is a child of another: the chart's own
                // beginning.
                auto other = work(history, after);
                other.states[7].name = "glue";
                other.transitions[1].targets = {"glue"};
                if (history == Kind::shallow_history) {
                    other.states[5].parent = 2; // a step of planning now
                    CHECK(begun(other) == "rough");
                } else CHECK(begun(other) == "rough");
                // Another kind of history remembers nothing of this one.
                CHECK(begun(work(history == Kind::deep_history ? Kind::shallow_history : Kind::deep_history, after)) ==
                      "rough");
            }
}

TEST_CASE("a history whose states cannot be active together any more remembers nothing", "[states]") {
    // Two parts beside each other, which are alternatives in the next chart; and another parallel state, or none.
    const auto chart = [](Kind kind, bool other) {
        Outline o;
        o.states = {
            one(""),        one("work"),     one("parts", 1, kind), one("left", 2), one("idle", 3),
            one("busy", 3), one("right", 2), one("off", 6),         one("on", 6),   one("where", 1, Kind::deep_history),
            one("break")};
        o.states[9].initial = {"parts"};
        o.transitions = {go(1, "rest", "break"), go(10, "back", "where"), go(4, "left", "busy"), go(7, "right", "on")};
        if (other) {
            o.states.push_back(one("both", 0, Kind::parallel));
            o.states.push_back(one("this", 11));
            o.states.push_back(one("that", 11));
            o.transitions.push_back(go(10, "two", "both"));
        }
        return o;
    };
    const auto begun = [&](const Outline& before, const Outline& after) {
        Npc npc;
        FromFile machine{make_chart<Npc>(before, {})};
        machine.start(npc);
        for (const char* event : {"left", "right", "rest"}) machine.handle(npc, event);
        machine.reload(npc, make_chart<Npc>(after, {}));
        machine.handle(npc, "back");
        std::string in;
        for (const char* name : {"left", "right", "idle", "busy", "off", "on"})
            if (machine.is_in(name)) in += std::string(in.empty() ? "" : " ") + name;
        return in;
    };
    CHECK(begun(chart(Kind::parallel, false), chart(Kind::parallel, false)) == "left right busy on");
    CHECK(begun(chart(Kind::parallel, false), chart(Kind::state, true)) == "left idle");
    // Where one is remembered at most, it is the first.
    CHECK(begun(chart(Kind::parallel, false), chart(Kind::state, false)) == "left busy");
}

TEST_CASE("a machine that is assigned another goes on as that does, whatever chart it had", "[states]") {
    Npc npc;
    Outline plain;
    plain.states = {one(""), one("a"), one("b")};
    plain.transitions = {go(1, "go", "b")};
    Outline further = plain; // from b at once to c
    further.states.push_back(one("c"));
    further.transitions.push_back(go(2, "", "c"));
    const auto begun = [&](const Outline& outline) {
        FromFile machine{make_chart<Npc>(outline, {})};
        machine.start(npc);
        return machine;
    };
    for (const auto& [from, end] : {std::pair(&further, "c"), std::pair(&plain, "b")})
        for (const auto* had : {&plain, &further}) {
            const FromFile original = begun(*from);
            FromFile assigned = begun(*had), copied = original;
            assigned = original;
            for (FromFile* machine : {&assigned, &copied}) {
                machine->handle(npc, "go");
                CHECK(machine->active_name() == end);
            }
        }
    // A snapshot, another chart, and back.
    FromFile machine = begun(further);
    const FromFile snapshot = machine;
    machine.reload(npc, make_chart<Npc>(plain, {}));
    machine = snapshot;
    machine.handle(npc, "go");
    CHECK(machine.active_name() == "c");
}

TEST_CASE("an action that throws leaves the machine where it was, with parallel states as without", "[states]") {
    for (const bool parallel : {false, true}) {
        INFO("parallel " << parallel);
        Outline o;
        o.states = {one(""), one("a"), one("b")};
        o.states[2].entry.push_back({Outline::Content::What::action, "hello", 0});
        o.transitions = {go(1, "go", "b"), go(2, "back", "a")};
        if (parallel) {
            o.states.push_back(one("both", 0, Kind::parallel));
            o.states.push_back(one("left", 3));
            o.states.push_back(one("right", 3));
            o.transitions.push_back(go(2, "two", "both"));
        }
        const auto names = greeting();
        Npc npc{.fails = true};
        FromFile machine{make_chart<Npc>(o, names)};
        machine.start(npc);
        CHECK_THROWS_AS(machine.handle(npc, "go"), int);
        CHECK(machine.active_name() == "a");
        CHECK(machine.is_in("a"));
        CHECK_FALSE(machine.is_in("b"));
        npc.fails = false;
        machine.handle(npc, "go");
        CHECK(machine.active_name() == "b");
        CHECK(npc.entered == 1);
        machine.handle(npc, "back");
        CHECK(machine.is_in("a"));
        CHECK_FALSE(machine.is_in("b"));
    }
}

TEST_CASE("a machine whose first entry throws has not started, with parallel states as without", "[states]") {
    for (const bool parallel : {false, true}) {
        INFO("parallel " << parallel);
        Outline o;
        o.states = {one(""), one("both", 0, parallel ? Kind::parallel : Kind::state), one("left", 1), one("right", 1)};
        o.states[parallel ? 3 : 2].entry.push_back({Outline::Content::What::action, "hello", 0});
        const auto names = greeting();
        Npc npc{.fails = true};
        FromFile machine{make_chart<Npc>(o, names)};
        CHECK_THROWS_AS(machine.start(npc), int);
        for (const char* name : {"both", "left", "right"}) CHECK_FALSE(machine.is_in(name));
        const auto saved = [](const FromFile& m) {
            std::ostringstream out;
            save(m, out);
            return out.str();
        };
        CHECK(saved(machine) == saved(FromFile{make_chart<Npc>(o, names)}));
        npc.fails = false;
        machine.start(npc);
        CHECK(machine.is_in("left"));
        CHECK(machine.is_in("right") == parallel);
        CHECK(npc.entered == 1);
    }
}

namespace {
struct Startles {
    using Context = Npc;
    static constexpr auto machine = states::machine(state("a", on_entry([](Npc& n) {
                                                              ++n.entered;
                                                              if (n.fails) throw 5;
                                                          }),
                                                          transition(on("go"), to("b"))),
                                                    state("b", transition(on("back"), to("a"))));
};
} // namespace

TEST_CASE("a machine that is started anew and whose entry throws is in no state, in every representation", "[states]") {
    each_representation([]<class R>() {
        Npc npc;
        Machine<Startles, R> machine;
        machine.start(npc);
        machine.handle(npc, "go");
        npc.fails = true;
        CHECK_THROWS_AS(machine.start(npc), int);
        CHECK_FALSE(machine.started());
        CHECK(machine.active_names().empty());
        CHECK_THAT(refusal([&] { machine.handle(npc, "back"); }), ContainsSubstring("call start(context)"));
        const auto copy = machine;
        CHECK_FALSE(copy.started());
        npc.fails = false;
        machine.start(npc);
        CHECK(machine.active_name() == "a");
        CHECK(npc.entered == 3);
    });
}
