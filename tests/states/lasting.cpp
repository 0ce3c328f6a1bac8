// SPDX-License-Identifier: BSL-1.0
// Machines that last: begun in any state, saved and loaded in the middle of anything, asked for how long they have been
// somewhere; and the condition In('x') between parallel states.

#include <ansatz/states/archive.hpp>
#include <ansatz/states/lasting.hpp>
#include <ansatz/states/machine_archive.hpp>
#include <ansatz/states/names.hpp>
#include <ansatz/states/save.hpp>
#include <ansatz/states/scxml.hpp>

#include "tests/states/support.hpp"

#include <array>
#include <map>
#include <random>
#include <sstream>

using namespace states_tests;
using namespace ansatz;
using namespace ansatz::test;

namespace {

/// What a machine's guards read and its actions change.
struct Npc {
    double fear = 0; // m, for a unit
    int steps = 0;
    Quantity<unit::Length> height() const { return fear * metre; }
};
enum class Mood : std::uint8_t { calm, angry };
/// The data of a state.
struct Patrol {
    int corner = 0;
    float tired = 0;
    Mood mood = Mood::calm;
    std::uint64_t seed = 0; // all bits of it
    std::array<std::uint16_t, 2> seen{};
    std::string word = "none";
    Quantity<unit::Time> walked{};
    void enter(Npc&) { word += corner % 2 != 0 ? "!" : "?", word.resize(std::min<std::size_t>(word.size(), 9)); }
    void update(Npc& npc, Quantity<unit::Time> dt) {
        corner += npc.steps, tired += 0.1f, walked += dt, ++seen[std::size_t(corner) % 2];
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        mood = corner % 3 == 0 ? Mood::angry : Mood::calm;
    }
    static void fields(auto& self, auto&& field) {
        field("corner", self.corner);
        field("tired", self.tired);
        field("mood", self.mood);
        field("seed", self.seed);
        field("seen", self.seen);
        field("word", self.word);
        field("walked", self.walked);
    }
};
constexpr auto height = states::value("height", &Npc::height);
/// A bit of everything that remembers.
struct Nerves {
    using Context = Npc;
    static constexpr auto machine = states::machine(
        states::state(
            "calm", states::transition(states::on("alarm"), states::to("guarding")),
            states::transition(states::when(states::rises_through(height, 2.0 * metre)), states::to("flees"))),
        states::state("guarding", states::transition(states::on("rest"), states::to("calm")),
                      states::state("patrol", states::behaves<Patrol>(),
                                    states::transition(states::on("noise"), states::to("looks"))),
                      states::state("looks",
                                    states::transition(states::when(states::after(0.5 * second)), states::to("patrol")),
                                    states::state("left", states::transition(states::on("turn"), states::to("right"))),
                                    states::state("right", states::on_exit([](Npc& npc) { ++npc.steps; }))),
                      states::shallow_history("where", states::to("patrol")),
                      states::deep_history("exactly", states::to("patrol"))),
        states::state(
            "flees",
            states::transition(states::when(states::held_for(
                                   states::falls_through(height, 1.0 * metre) || (height < 1.0 * metre), 0.3 * second)),
                               states::to("where")),
            states::transition(states::on("alarm"), states::to("exactly"))));
};

template <class M> std::string saved(const M& machine) {
    std::ostringstream out;
    save(machine, out);
    return out.str();
}
template <class M> void load_text(M& machine, const std::string& text) {
    std::istringstream in(text);
    load(machine, in);
}
const std::array<const char*, 6> events{"alarm", "rest", "noise", "turn", "other", "noise"};

/// Events, updates and a fear that wanders, all at random.
template <class M> void live(M& machine, Npc& npc, std::mt19937& random, int n) {
    for (int i = 0; i < n; ++i) {
        npc.fear += std::uniform_real_distribution<double>(-1, 1)(random) + (1.5 - npc.fear) * 0.2;
        if (random() % 3 == 0) machine.handle(npc, events[random() % events.size()]);
        else machine.update(npc, double(random() % 100) / 400 * second);
    }
}

} // namespace

TEST_CASE("a machine that was saved goes on as it would have", "[states]") {
    each_representation([]<class R>() {
        using M = Machine<Nerves, R, Everything>;
        std::mt19937 random(3);
        std::map<std::string, int> where;
        int above = 0; // of the seeds, what no signed number holds
        for (int round = 0; round < 150; ++round) {
            Npc npc;
            M machine;
            machine.start(npc, std::array{"calm", "patrol", "left", "right", "flees"}[std::size_t(round) % 5]);
            live(machine, npc, random, int(random() % 60));
            ++where[std::string(machine.active_name())];
            M loaded;
            load_text(loaded, saved(machine));
            CHECK(saved(loaded) == saved(machine));
            CHECK(loaded.active() == machine.active());
            text_since(machine);
            std::mt19937 again = random;
            Npc other = npc;
            live(machine, npc, random, 60);
            live(loaded, other, again, 60);
            REQUIRE(text(loaded) == text(machine));
            REQUIRE(loaded.template get<Everything>().all.size() == machine.template get<Everything>().all.size());
            for (std::size_t i = 0; i < loaded.template get<Everything>().all.size(); ++i)
                REQUIRE(loaded.template get<Everything>().all[i].time ==
                        machine.template get<Everything>().all[i].time);
            CHECK(other.steps == npc.steps);
            CHECK(saved(loaded) == saved(machine));
            const auto patrol = machine.state("patrol");
            CHECK(loaded.template own<Patrol>(patrol).word == machine.template own<Patrol>(patrol).word);
            CHECK(loaded.template own<Patrol>(patrol).seed == machine.template own<Patrol>(patrol).seed);
            above += machine.template own<Patrol>(patrol).seed >> 63 != 0;
        }
        CHECK(above > 0);
        CHECK(where.size() == 5); // it was saved in all of them
        M idle, other;
        load_text(other, saved(idle));
        CHECK(!other.started());
    });
}

TEST_CASE("a machine begins in any state, from the outside inwards", "[states]") {
    each_representation([]<class R>() {
        Npc npc;
        Machine<Nerves, R, Everything> machine;
        machine.start(npc, "looks");
        CHECK(text_since(machine) == "+guarding +looks +left");
        machine.start(npc, "right");
        CHECK(text_since(machine) == "+guarding +looks +right");
        CHECK(machine.handle(npc, "rest"));
        CHECK(text_since(machine).starts_with("-right -looks -guarding"));
        machine.start(npc, machine.state("guarding"));
        CHECK(text_since(machine) == "+guarding +patrol");
        machine.start(npc, "flees");
        text_since(machine);
        const auto before = saved(machine);
        CHECK_THAT(refusal([&] { machine.start(npc, "where"); }),
                   ContainsSubstring("Machine::start: \"where\" is a history; it can begin in a state"));
        CHECK_THAT(refusal([&] { machine.start(npc, StateId::root); }), ContainsSubstring("names no state inside"));
        CHECK_THAT(refusal([&] { machine.start(npc, StateId(99)); }),
                   ContainsSubstring("the number 99 names no state"));
        CHECK_THAT(refusal([&] { machine.start(npc, "nowhere"); }), ContainsSubstring("there is no state \"nowhere\""));
        CHECK(saved(machine) == before);
        CHECK(machine.handle(npc, "alarm")); // to the history, which remembers nothing yet
        CHECK(machine.is_in("patrol"));
    });
}

TEST_CASE("the time in a state is the sum of the updates since it was entered", "[states]") {
    each_representation([]<class R>() {
        Npc npc;
        Machine<Nerves, R, Everything> machine;
        machine.start(npc);
        std::mt19937 random(9);
        std::map<std::string, double> entered; // by the trace
        double now = 0;
        for (int i = 0; i < 600; ++i) {
            const double dt = double(random() % 8) / 16; // exact
            npc.fear = double(random() % 40) / 10;
            if (i % 3 == 0) machine.handle(npc, events[random() % events.size()]);
            else machine.update(npc, dt * second), now += dt;
            for (const auto& h : machine.template get<Everything>().all)
                if (h.what == Happening::What::entered) entered[std::string(machine.name(h.state))] = h.time.value();
            text_since(machine);
            for (const char* name : {"calm", "guarding", "patrol", "looks", "left", "right", "flees"})
                REQUIRE(machine.time_in(name).value() == (machine.is_in(name) ? now - entered[name] : 0));
        }
        CHECK(entered.size() == 7);
    });
}

namespace {

const char* const doors = R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0">
  <parallel id="ship">
    <state id="lock">
      <state id="shut"><transition event="open" cond="In('docked')" target="ajar"/></state>
      <state id="ajar"><transition event="shut" target="shut"/>
                       <transition event="vent" cond="!In( &quot;docked&quot; )" target="broken"/></state>
      <final id="broken"/>
    </state>
    <state id="place">
      <state id="flying"><transition event="dock" target="docked"/></state>
      <state id="docked"><transition event="undock" cond=" ! In('ajar')" target="flying"/>
                         <transition event="force" target="flying"/>
        <state id="clamped"/><state id="loose"/><history id="last" type="deep"><transition target="clamped"/></history></state>
    </state>
  </parallel>
</scxml>)xml";

SharedChart<Npc> chart(const std::string& text) { return parse_scxml<Npc>(text, "ship.scxml", Bindings<Npc>{}); }
using Ship = Machine<InFile<Npc>, Interpreted, Everything>;

} // namespace

TEST_CASE("In('x') holds while the machine is in x", "[states]") {
    Npc npc;
    Ship ship{chart(doors), {}};
    ship.start(npc);
    CHECK(!ship.handle(npc, "open"));
    CHECK(ship.handle(npc, "dock"));
    CHECK(ship.handle(npc, "open"));
    CHECK(ship.is_in("ajar"));
    CHECK(!ship.handle(npc, "undock"));
    CHECK(!ship.handle(npc, "vent"));
    CHECK(ship.handle(npc, "force"));
    CHECK(ship.handle(npc, "vent"));
    CHECK(ship.is_in("broken"));

    const auto with = [&](const std::string& condition) {
        std::string text = doors;
        text.replace(text.find("In('docked')"), 12, condition);
        return refusal([&] { chart(text); });
    };
    CHECK_THAT(with("In('nowhere')"), ContainsSubstring("ship.scxml") && ContainsSubstring("\"nowhere\""));
    CHECK_THAT(with("In('last')"), ContainsSubstring("nobody can be in a history"));
    for (const char* no : {"In(docked)", "In('docked'", "In('docked') x", "in('docked')", "In 'docked'"})
        CHECK_THAT(with(no), ContainsSubstring("which is not bound"));

    // A function of that name comes first.
    Bindings<Npc> own;
    own.guard("In('docked')", [](const Npc&) { return true; });
    Ship mine{parse_scxml<Npc>(doors, "ship.scxml", own), {}};
    mine.start(npc);
    CHECK(mine.handle(npc, "open"));
}

TEST_CASE("parallel machines begin in a named state and are saved and loaded, too", "[states]") {
    Npc npc;
    const auto c = chart(doors);
    Ship ship{c, {}};
    ship.start(npc, "loose");
    CHECK(ship.active_names() == std::vector<std::string>{"ship", "lock", "shut", "place", "docked", "loose"});
    std::mt19937 random(12);
    const std::array<const char*, 6> orders{"open", "shut", "vent", "dock", "undock", "force"};
    for (int round = 0; round < 100; ++round) {
        ship.start(npc, std::array{"loose", "ajar", "ship", "flying"}[random() % 4]);
        for (auto n = random() % 12; n > 0; --n) ship.handle(npc, orders[random() % 6]);
        Ship loaded{c, {}};
        load_text(loaded, saved(ship));
        REQUIRE(loaded.active_names() == ship.active_names());
        text_since(ship);
        for (int i = 0; i < 12; ++i) {
            const char* order = orders[random() % 6];
            CHECK(ship.handle(npc, order) == loaded.handle(npc, order));
        }
        CHECK(text(loaded) == text(ship));
        CHECK(saved(loaded) == saved(ship));
    }
}

namespace {

/// The same as Nerves, but for one guard.
struct Changed {
    using Context = Npc;
    static constexpr auto machine = states::machine(
        states::state("a", states::transition(states::when(states::after(1.0 * second)), states::to("b"))),
        states::state("b", states::transition(states::on("x"), states::to("a"))));
};
struct Slower {
    using Context = Npc;
    static constexpr auto machine = states::machine(
        states::state("a", states::transition(states::when(states::after(2.0 * second)), states::to("b"))),
        states::state("b", states::transition(states::on("x"), states::to("a"))));
};
/// Saves itself from within an action.
struct Selfish {
    using Context = std::function<void()>;
    static constexpr auto machine = states::machine(
        states::state("a", states::transition(states::on("x"), states::then([](std::function<void()>& f) { f(); }))));
};

} // namespace

TEST_CASE("a saved machine that does not fit is refused, and the machine is as it was", "[states]") {
    each_representation([]<class R>() {
        Npc npc;
        Machine<Nerves, R, Everything> machine;
        machine.start(npc);
        std::mt19937 random(5);
        live(machine, npc, random, 40);
        machine.start(npc, "right");
        machine.update(npc, 0.25 * second);
        const std::string good = saved(machine);
        Machine<Nerves, R, Everything> other;
        other.start(npc, "flees");
        const auto before = saved(other);
        const auto with = [&](const std::string& what, const std::string& instead) {
            std::string text = good;
            REQUIRE(text.find(what) != std::string::npos);
            text.replace(text.find(what), what.size(), instead);
            const auto said = refusal([&] { load_text(other, text); });
            CHECK(saved(other) == before);
            return said;
        };
        CHECK_THAT(with("\"machine\": 1", "\"machine\": 2"),
                   ContainsSubstring("machine is 2; expected 1, the version of the format that this library reads"));
        CHECK_THAT(with("\"active\": \"right\"", "\"active\": \"guarding\""),
                   ContainsSubstring("active is \"guarding\"; expected the name of a state without others in it"));
        CHECK_THAT(with("\"active\": \"right\"", "\"active\": \"where\""), ContainsSubstring("active is \"where\""));
        CHECK_THAT(with("\"active\": \"right\"", "\"actve\": \"right\""),
                   ContainsSubstring("expected \"active\", but there is none"));
        CHECK_THAT(
            with("\"exactly\": \"", "\"exactly\": \"calm\", \"x\": \""),
            ContainsSubstring("exactly is \"calm\"; expected the name of a state that this history can remember"));
        CHECK_THAT(with("\"corner\": ", "\"corner\": 99999999999"), ContainsSubstring("classes.patrol.corner is"));
        CHECK_THAT(with("\"seed\": ", "\"seed\": -1, \"s\": "),
                   ContainsSubstring("classes.patrol.seed is -1; expected a whole number"));
        CHECK_THAT(with("\"time\": ", "\"time\": true, \"t\": "), ContainsSubstring("time is true; expected a finite"));
        CHECK_THAT(with("{", "["), ContainsSubstring("it is no JSON; expected a machine that was saved"));
        CHECK_THAT(with("\"patrol\"", "\"watch\""),
                   ContainsSubstring("the description of the machine has changed: state 3 is \"patrol\", and was "
                                     "\"watch\" when the file was saved"));
        using Other = Machine<Nerves, std::conditional_t<std::is_same_v<R, Switch>, Table, Switch>, Everything>;
        Other another;
        CHECK_THAT(refusal([&] { load_text(another, good); }),
                   ContainsSubstring("the representation of the machine that is loaded"));

        Machine<Changed, R> one;
        Machine<Slower, R> two;
        one.start(npc);
        CHECK_THAT(
            refusal([&] { load_text(two, saved(one)); }),
            ContainsSubstring("its states have the same names, and their parts, transitions, guards or actions"));
        CHECK(!two.started());

        Machine<Selfish, R> self;
        std::string said;
        std::function<void()> act = [&] { said = refusal([&] { saved(self); }); };
        self.start(act);
        self.handle(act, "x");
        CHECK_THAT(said, ContainsSubstring("save: called from an action of the machine"));
        act = [&] { said = refusal([&] { load_text(self, "{}"); }); };
        self.handle(act, "x");
        CHECK_THAT(said, ContainsSubstring("load: called from an action of the machine"));
    });

    Npc npc;
    Ship ship{chart(doors), {}};
    ship.start(npc, "loose");
    const auto good = saved(ship);
    std::string text = good;
    text.replace(text.find("\"loose\"", text.find("\"active\"")), 7, "\"flying\"");
    CHECK_THAT(refusal([&] { load_text(ship, text); }),
               ContainsSubstring("active") &&
                   ContainsSubstring("expected states that can be active together; \"place\" has "
                                     "2 active parts and needs 1"));
    CHECK(saved(ship) == good);

    // A class that does not say what it holds.
    struct Silent {
        int n = 0;
    };
    Bindings<Npc> names;
    names.behaviour<Silent>("silent");
    Outline outline;
    outline.states.resize(2);
    outline.states[1].name = "s", outline.states[1].behaviour = "silent";
    Machine<InFile<Npc>, Interpreted> silent{make_chart(outline, names)};
    silent.start(npc);
    CHECK_THAT(
        refusal([&] { saved(silent); }),
        ContainsSubstring("the class of the state \"s\" holds something of which it is not known what it consists"));
    CHECK_THAT(refusal([&] { load(ship, std::string("/no/such/file")); }),
               ContainsSubstring("/no/such/file cannot be opened"));
}
