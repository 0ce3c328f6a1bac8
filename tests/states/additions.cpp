// SPDX-License-Identifier: BSL-1.0
// Transitions that are added to a machine that runs: as if they had always been there, and nothing else is another.

#include <ansatz/states/additions.hpp>
#include <ansatz/states/interpreted.hpp>
#include <ansatz/states/save.hpp>

#include "tests/rounds.hpp"
#include "tests/states/oracle.hpp"

#include <random>
#include <sstream>

using namespace states_tests;

namespace {

using Living = Machine<InFile<Bits>, Interpreted, Everything>;

/// What the names A to F stand for.
Bindings<Bits> six() {
    Bindings<Bits> names;
    for (unsigned k = 0; k < 6; ++k)
        names.guard(std::string(1, char('A' + k)), [k](const Bits& b) { return (b.bits >> k & 1) != 0; });
    names.action("set F", [](Bits& b) { b.bits |= 32; });
    return names;
}
/// p, q, and g with u, v (x, y), the final state w and a history.
Outline little(bool deep) {
    Outline o;
    o.origin = "little";
    const auto add = [&](const char* name, std::size_t parent, Kind kind = Kind::state) {
        Outline::State s;
        s.name = name, s.kind = kind, s.parent = parent;
        o.states.push_back(s);
    };
    add("", 0), add("p", 0), add("q", 0), add("g", 0), add("u", 3), add("v", 3), add("x", 5), add("y", 5);
    add("w", 3, Kind::final), add("h", 3, deep ? Kind::deep_history : Kind::shallow_history);
    o.states[9].initial = {"u"};
    return o;
}
Outline::Transition any(std::mt19937& random) {
    Outline::Transition t;
    t.source = random() % 8;
    static const std::array<const char*, 9> events{"a", "b", "c", "a b", "b.*", "*", "c.d", "done.state.g", ""};
    static const std::array<const char*, 9> targets{"p", "q", "g", "u", "v", "x", "y", "w", "h"};
    t.events = events[random() % events.size()];
    if (random() % 2 == 0 || t.events.empty()) t.guard = std::string(1, char('A' + random() % 6));
    if (random() % 8 != 0) t.targets = {targets[random() % targets.size()]};
    t.internal = random() % 4 == 0;
    return t;
}
template <class M> std::string saved(const M& machine) {
    std::ostringstream out;
    save(machine, out);
    return out.str();
}
/// Puts a transition where `add` must put it.
bool put(Outline& o, const Outline::Transition& t, Among among, std::size_t& at) {
    auto& all = o.transitions;
    at = 0;
    while (at < all.size() && (all[at].source < t.source || (among == Among::last && all[at].source == t.source))) ++at;
    bool taken_before = false; // by one that always holds, and takes all that it takes
    for (std::size_t i = 0; i < at; ++i)
        if (all[i].source == t.source && (all[i].guard.empty() || all[i].guard == t.guard) &&
            all[i].events.empty() == t.events.empty()) {
            bool covers = true;
            for (const char* one : {"a", "b", "c", "b.x", "c.d", "done.state.g", "other"})
                covers = covers && (!Oracle::takes(t.events, one) || Oracle::takes(all[i].events, one));
            taken_before = taken_before || covers;
        }
    if (!taken_before) all.insert(all.begin() + std::ptrdiff_t(at), t);
    return !taken_before;
}

} // namespace

TEST_CASE("a machine that is added to is the one whose file has it all", "[states]") {
    std::mt19937 random(19);
    const auto names = six();
    int added = 0, refused = 0, removed = 0, loaded = 0, taken = 0;
    for (int round = 0; round < test::rounds(300); ++round) {
        Outline all = little(round % 2 == 0);
        for (int k = 0; k < 3; ++k) {
            std::size_t at = 0;
            put(all, any(random), Among::last, at);
        }
        const auto chart = make_chart(all, names);
        Bits bits;
        Living machine{chart, {}}, beside{chart, {}}; // the latter is left alone
        Oracle oracle{all, bits};
        machine.start(bits), oracle.start();
        for (int i = 0; i < 150; ++i) {
            bits.bits = unsigned(random()) & 63;
            switch (random() % 8) {
            case 0: {
                const auto t = any(random);
                const auto among = random() % 2 == 0 ? Among::last : Among::first;
                const auto before = saved(machine);
                std::size_t at = 0;
                if (put(all, t, among, at)) {
                    REQUIRE(index(machine.add(bits, all.states[t.source].name, t, names, among)) == at);
                    ++added;
                    if (t.events.empty() && t.guard.empty()) oracle.settle();
                } else {
                    REQUIRE_THAT(refusal([&] { machine.add(bits, all.states[t.source].name, t, names, among); }),
                                 ContainsSubstring("would never be taken: an earlier one with"));
                    REQUIRE(saved(machine) == before);
                    ++refused;
                }
                break;
            }
            case 1: {
                const auto mine = machine.added();
                if (mine.empty() || random() % 2 == 0) break;
                const auto one = mine[random() % mine.size()];
                machine.remove(one);
                all.transitions.erase(all.transitions.begin() + std::ptrdiff_t(index(one)));
                ++removed;
                break;
            }
            case 2: {
                if (random() % 4 != 0) break;
                Living other{chart, {}};
                other.get<Everything>() = machine.get<Everything>();
                std::istringstream in(saved(machine));
                load(other, in, names);
                REQUIRE(saved(other) == saved(machine));
                REQUIRE(other.added() == machine.added());
                machine = other;
                ++loaded;
                break;
            }
            case 3: machine.update(bits), oracle.update(); break;
            default: {
                const char* event = inputs[random() % 8];
                machine.handle(bits, event), oracle.handle(event);
            }
            }
            REQUIRE(machine.active_name() == all.states[oracle.path.back()].name);
        }
        REQUIRE(machine.outline() == all);
        REQUIRE(without_numbers(text(machine)) == oracle.trace);
        taken += int(std::count(oracle.trace.begin(), oracle.trace.end(), '*'));
        REQUIRE(beside.chart().outline().transitions.size() == chart->outline().transitions.size());
        REQUIRE(beside.added().empty());
    }
    CHECK(added > test::at_least(2000));
    CHECK(refused > test::at_least(200));
    CHECK(removed > test::at_least(300));
    CHECK(loaded > test::at_least(300));
    CHECK(taken > test::at_least(5000));
}

namespace {

struct Npc {
    double fear = 0; // m, for a unit
    int shouts = 0;
    Quantity<unit::Length> height() const { return fear * metre; }
};
struct Walk {
    int legs = 0;
    void update(Npc&) { ++legs; }
    static void fields(auto& self, auto&& field) { field("legs", self.legs); }
};
constexpr auto height = states::value("height", &Npc::height);
struct Post {
    using Context = Npc;
    static constexpr auto machine =
        states::machine(state("watch", behaves<Walk>("Walk"), transition(on("noise"), to("search")),
                              transition(when(rises_through(height, 2.0 * metre)), to("flee"))),
                        state("search", transition(when(after(5.0 * second)), to("watch")),
                              shallow_history("last", to("shed")), state("shed"), state("yard"), final_state("found")),
                        state("flee"));
};
using Guard = Machine<Post, Interpreted>;
void shout(Npc& npc) { ++npc.shouts; }

} // namespace

TEST_CASE("what runs goes on when a transition is added", "[states]") {
    Npc npc;
    Guard guard, beside;
    const EventId noise = guard.event("noise");
    guard.start(npc), beside.start(npc);
    npc.fear = 1.5;
    guard.update(npc, frame), beside.update(npc, frame);
    npc.fear = 2.5; // in the midst of rising through 2 m

    guard.add(npc, "watch", transition(on("bell dawn"), then("shout", shout), to("search")), Among::first);
    guard.add(npc, "search", transition(when("bored", after(1.0 * second)), then(shout), then(shout), to("flee")));
    CHECK(guard.event("noise") == noise); // who keeps numbers of events may go on
    CHECK(guard.own<Walk>(guard.state("watch")).legs == 1);
    CHECK(guard.time_in("watch") == beside.time_in("watch"));
    REQUIRE(guard.outline().transitions.size() == 5);
    CHECK(guard.outline().transitions[0].events == "bell dawn");
    CHECK(guard.outline().transitions[0].content.at(0).name == "shout");
    CHECK(guard.outline().transitions[4].guard == "bored");
    CHECK(guard.added() == std::vector<TransitionId>{TransitionId(0), TransitionId(4)});
    Guard copy = guard;
    CHECK(guard.update(npc, frame)); // it remembers that he was lower
    CHECK(guard.is_in("flee"));
    CHECK(beside.update(npc, frame));

    CHECK(copy.handle(npc, noise));
    CHECK(copy.is_in("shed"));
    for (int i = 0; i < 3; ++i) CHECK(!copy.update(npc, 0.25 * second));
    CHECK(copy.update(npc, 0.25 * second)); // 1 s and not 5 s
    CHECK(copy.is_in("flee"));
    CHECK(npc.shouts == 2);

    // A crossing that is added begins now: where one is, nothing is crossed.
    Guard late;
    npc.fear = 3;
    late.start(npc);
    late.add(npc, "watch", transition(when(falls_through(height, 2.0 * metre)), to("search")));
    CHECK(!late.update(npc, frame));
    npc.fear = 1;
    CHECK(late.update(npc, frame));
    CHECK(late.is_in("search"));

    // Of the machine itself: from wherever it is; with the data of a state; at once where there is nothing to wait for.
    late.add(npc, "", transition(on("home"), to("watch")));
    CHECK(late.handle(npc, "home"));
    late.add<Walk>(npc, "watch",
                   transition(when([](const Npc&, const Walk& own) { return own.legs > 3; }), to("yard")));
    for (int i = 0; i < 6 && late.is_in("watch"); ++i) late.update(npc, frame);
    CHECK(late.is_in("yard"));
    CHECK(late.own<Walk>(late.state("watch")).legs == 4);
    late.add(npc, late.state("yard"), transition(to("flee"), then(raise("home"))));
    CHECK(late.is_in("watch"));
}

TEST_CASE("what cannot be added is refused, and the machine is as it was", "[states]") {
    Npc npc;
    Guard guard;
    guard.start(npc);
    guard.add(npc, "watch", transition(on("x"), to("search")));
    const auto before = saved(guard);
    const auto refused = [&](auto&& f) {
        const auto said = refusal(f);
        CHECK(saved(guard) == before);
        return said;
    };
    CHECK_THAT(refused([&] { guard.add(npc, "wach", transition(on("y"), to("search"))); }),
               ContainsSubstring("there is no state \"wach\""));
    CHECK_THAT(refused([&] { guard.add(npc, StateId(99), transition(on("y"), to("search"))); }),
               ContainsSubstring("Machine::add: the number 99 names no state"));
    CHECK_THAT(refused([&] { guard.add(npc, "watch", transition(on("y"), to("serch"))); }),
               ContainsSubstring("Machine::add: the transition of \"watch\" names the state \"serch\", which is not"));
    CHECK_THAT(refused([&] { guard.add(npc, "found", transition(on("y"), to("watch"))); }),
               ContainsSubstring("\"found\" is final or a history"));
    CHECK_THAT(refused([&] { guard.add(npc, "last", transition(on("y"), to("watch"))); }),
               ContainsSubstring("\"last\" is final or a history"));
    CHECK_THAT(
        refused([&] {
            guard.add(npc, "watch", transition(on("x"), when("sees", [](const Npc&) { return true; }), to("flee")));
        }),
        ContainsSubstring("Machine::add: the transition of \"watch\" would never be taken: an earlier one without "
                          "a guard is taken before it; add it as Among::first"));
    CHECK_THAT(refused([&] { guard.add(npc, "watch", transition(then(shout))); }),
               ContainsSubstring("it would happen for ever"));
    CHECK_THAT(refused([&] {
                   guard.add<Walk>(
                       npc, "flee",
                       transition(when("far", [](const Npc&, const Walk& w) { return w.legs > 1; }), to("watch")));
               }),
               ContainsSubstring("the guard \"far\", which reads the class of another state"));
    Outline::Transition data;
    data.events = "y", data.guard = "brave", data.targets = {"watch"};
    CHECK_THAT(refused([&] { guard.add(npc, "flee", data, Bindings<Npc>{}); }),
               ContainsSubstring("the guard \"brave\", which is not bound; bound are:"));
    data.guard = "In('cellar')";
    CHECK_THAT(refused([&] { guard.add(npc, "flee", data, Bindings<Npc>{}); }), ContainsSubstring("\"cellar\""));
    CHECK_THAT(refused([&] { guard.remove(TransitionId(0)); }),
               ContainsSubstring("the transition 0 of \"watch\" stands in the description of the machine; only one"));
    CHECK_THAT(refused([&] { guard.remove(TransitionId(77)); }), ContainsSubstring("the transition 77 is not there"));

    std::string said, also;
    guard.add(npc, "flee", transition(on("stop"), then([&](Npc& n) {
                                          said =
                                              refusal([&] { guard.add(n, "flee", transition(on("y"), to("watch"))); });
                                          also = refusal([&] { guard.remove(TransitionId(2)); });
                                      })));
    guard.start(npc, "flee");
    CHECK(guard.handle(npc, "stop"));
    CHECK_THAT(said, ContainsSubstring("Machine::add: called from an action of the same machine; call it between"));
    CHECK_THAT(also, ContainsSubstring("Machine::remove: called from an action"));
}

TEST_CASE("a machine to which something was added is saved, and loaded where that can be bound", "[states]") {
    Npc npc;
    Guard guard;
    guard.start(npc);
    const auto brave = [](const Npc& n) { return n.fear < 1; };
    const auto add = [&](Guard& to_it) {
        to_it.add(npc, "flee",
                  transition(on("rally"), when("brave", asked("brave", brave) && falls_through(height, 1.0 * metre)),
                             then("shout", shout), to("last")),
                  Among::first);
        to_it.add(npc, "flee", transition(on("rally"), to("watch")));
    };
    add(guard);
    guard.handle(npc, "noise");
    guard.handle(npc, "nothing");
    npc.fear = 3;
    guard.start(npc, "flee");
    npc.fear = 0.5;
    guard.update(npc, frame);
    const auto file = saved(guard);
    const auto read = [&](Guard& into, const std::string& text) {
        std::istringstream in(text);
        load(into, in, "guard.json");
    };
    const auto read_with = [&](Guard& into, const Bindings<Npc>& names, const std::string& text) {
        std::istringstream in(text);
        load(into, in, names, "guard.json");
    };
    // Into one that has the same, and goes on the same.
    Guard same;
    add(same);
    read(same, file);
    CHECK(saved(same) == file);
    CHECK(same.handle(npc, "rally"));
    CHECK(same.is_in("shed")); // the guard's memory of the fall came with the file
    // Into one that has other things: afterwards it has those of the file.
    Guard other;
    other.add(npc, "watch", transition(on("x"), to("flee")));
    add(other);
    read(other, file);
    CHECK(saved(other) == file);
    CHECK(!other.handle(npc, "x"));
    // Into one that has nothing: by Bindings.
    Bindings<Npc> names;
    names.guard("brave", asked("brave", brave) && falls_through(height, 1.0 * metre)).action("shout", shout);
    Guard bare;
    const auto untouched = saved(bare);
    CHECK_THAT(
        refusal([&] { read(bare, file); }),
        ContainsSubstring("guard.json: a transition of \"flee\" on \"rally\" with the guard \"brave\" was added to "
                          "the machine before it was saved; add it to this one too, or give load the Bindings"));
    CHECK_THAT(refusal([&] { read_with(bare, Bindings<Npc>{}, file); }),
               ContainsSubstring("guard.json: the action \"shout\" is not bound; bound are: none is bound"));
    CHECK(saved(bare) == untouched);
    read_with(bare, names, file);
    CHECK(saved(bare) == file);
    const int shouts = npc.shouts;
    CHECK(bare.handle(npc, "rally"));
    CHECK(npc.shouts == shouts + 1);
    // A file of a machine without anything added takes away what was added.
    read(bare, untouched);
    CHECK(bare.added().empty());
    CHECK(saved(bare) == untouched);

    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = file;
        REQUIRE(text.find(what) != std::string::npos);
        text.replace(text.find(what), what.size(), instead);
        const auto was = saved(same);
        const auto said = refusal([&] { read_with(same, names, text); });
        CHECK(saved(same) == was);
        return said;
    };
    CHECK_THAT(with("\"state\": \"flee\"", "\"state\": \"fly\""),
               ContainsSubstring("added[0].state is \"fly\"; expected the name of a state of the machine"));
    CHECK_THAT(with("\"place\": 1", "\"place\": 9"), ContainsSubstring("added[1].place is 9; expected a whole number"));
    CHECK_THAT(with("\"targets\": [\n    \"last\"", "\"targets\": [7"),
               ContainsSubstring("added[0].targets[0] is 7; expected a text"));
    CHECK_THAT(with("\"internal\": false", "\"internal\": 0"), ContainsSubstring("expected true or false"));
    CHECK_THAT(with("\"added\": [", "\"added\": 3, \"was\": ["), ContainsSubstring("expected a list of transitions"));
    CHECK_THAT(with("\"shout\"", "\"sing\""), ContainsSubstring("the action \"sing\" is not bound"));
}
