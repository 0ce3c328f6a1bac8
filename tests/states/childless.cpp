// SPDX-License-Identifier: BSL-1.0
// A compound state without an active child: refused, or allowed by the option AllowChildless, in every representation.

#include <ansatz/states/machine.hpp>
#include <ansatz/states/options.hpp>
#include <ansatz/states/save.hpp>
#include <ansatz/states/scxml.hpp>
#include <ansatz/states/scxml_write.hpp>

#include "tests/states/oracle.hpp"

#include <random>
#include <sstream>

using namespace states_tests;

namespace {

struct Bit {
    unsigned k;
    constexpr bool operator()(const Bits& b) const { return (b.bits >> k & 1) != 0; }
};
/// A guard on duty, who is at the gate or in the yard or in neither, and there at the wall or nowhere in particular.
template <bool Deep> struct Duty {
    using Context = Bits;
    static constexpr auto history() {
        if constexpr (Deep) return deep_history("last", to("gate"));
        else return shallow_history("last", to("gate"));
    }
    static constexpr auto machine = states::machine(
        state("asleep", transition(on("a"), to("on duty")), transition(on("b"), to("last")),
              transition(when("A", Bit{0}), to("wall")), transition(on("z"), to("yard"))),
        state("on duty", no_initial(), transition(on("c"), to("asleep")), transition(on("b"), to("gate"), internal()),
              transition(on("ab"), to("yard")), transition(when("B", Bit{1}), to("on duty")), history(),
              state("gate", transition(on("a"), to("yard")), transition(when("C", Bit{2}), to("on duty"))),
              state("yard", no_initial(), transition(on("c.d"), to("wall")),
                    transition(on("z"), to("yard"), internal()),
                    state("wall", transition(on("a"), to("yard")), transition(on("b.x"), to("last"))))));
};
/// The same, with another part beside it.
const char* const beside =
    R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" xmlns:ansatz="urn:ansatz:states" version="1.0">
  <state id="asleep"><transition event="a" target="all"/><transition event="b" target="last"/></state>
  <parallel id="all">
    <transition event="c" target="asleep"/>
    <state id="duty" ansatz:initial="none">
      <transition event="z" target="gate"/>
      <history id="last" type="deep"><transition target="gate"/></history>
      <state id="gate"><transition event="a" target="duty"/></state>
    </state>
    <state id="hungry"><state id="no"><transition event="ab" target="yes"/></state>
                       <state id="yes"><transition event="ab" target="no"/></state></state>
  </parallel>
</scxml>)xml";

template <class M> std::string saved(const M& machine) {
    std::ostringstream out;
    save(machine, out);
    return out.str();
}
template <class M> void load_text(M& machine, const std::string& text) {
    std::istringstream in(text);
    load(machine, in);
}
using FromFile = Machine<InFile<Bits>, Interpreted, AllowChildless, Everything>;

template <class D, class R> void live(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto outline = outline_of<D>();
    int alone = 0, loads = 0;
    for (int round = 0; round < 40; ++round) {
        Bits bits;
        Machine<D, R, AllowChildless, Everything> machine;
        Oracle oracle{outline, bits};
        machine.start(bits), oracle.start();
        for (int i = 0; i < 100; ++i) {
            bits.bits = unsigned(random());
            if (random() % 4 == 0) machine.update(bits), oracle.update();
            else {
                const char* event = inputs[random() % 8];
                machine.handle(bits, event), oracle.handle(event);
            }
            REQUIRE(machine.active_name() == outline.states[oracle.path.back()].name);
            alone += machine.active_name() == "on duty" || machine.active_name() == "yard";
            if (random() % 16 == 0) {
                Machine<D, R, AllowChildless, Everything> other;
                other.template get<Everything>() = machine.template get<Everything>();
                load_text(other, saved(machine));
                REQUIRE(saved(other) == saved(machine));
                machine = other;
                ++loads;
            }
        }
        REQUIRE(without_numbers(text(machine)) == oracle.trace);
    }
    CHECK(alone > 500);
    CHECK(loads > 100);
}

} // namespace

TEST_CASE("a compound state may be active alone, and is left and remembered like any other", "[states]") {
    each_representation([]<class R>() {
        live<Duty<false>, R>(5);
        live<Duty<true>, R>(6);
    });
}

TEST_CASE("beside other parts a compound state may be active alone, too", "[states]") {
    const auto chart = parse_scxml<Bits>(beside, "duty.scxml", Bindings<Bits>{});
    CHECK(parse_scxml<Bits>(write_scxml(chart->outline()), "again", Bindings<Bits>{})->outline() == chart->outline());
    Bits bits;
    FromFile guard{chart, {}, {}};
    guard.start(bits);
    const auto active = [&] {
        std::string all;
        for (const auto& name : guard.active_names()) all += (all.empty() ? "" : ", ") + name;
        return all;
    };
    CHECK(guard.handle(bits, "a"));
    CHECK(active() == "all, duty, hungry, no");
    CHECK(guard.leaves() == std::vector<StateId>{guard.state("duty"), guard.state("no")});
    CHECK(guard.handle(bits, "ab"));
    CHECK(guard.handle(bits, "c"));
    CHECK(guard.handle(bits, "b")); // he was on duty alone, and is again
    CHECK(active() == "all, duty, hungry, no");
    FromFile other{chart, {}, {}};
    load_text(other, saved(guard));
    CHECK(saved(other) == saved(guard));
    CHECK(guard.handle(bits, "z"));
    CHECK(active() == "all, duty, gate, hungry, no");
    CHECK(guard.leaves() == std::vector<StateId>{guard.state("gate"), guard.state("no")});
    load_text(other, saved(guard));
    CHECK(other.active_names() == guard.active_names());
    CHECK(other.leaves() == guard.leaves());
    CHECK(guard.handle(bits, "c"));
    CHECK(guard.handle(bits, "b"));
    CHECK(active() == "all, duty, gate, hungry, no");
    CHECK(guard.handle(bits, "a"));
    CHECK(active() == "all, duty, hungry, no");
    guard.handle(bits, "c");
    load_text(other, saved(guard)); // the history remembers that there was nobody in it
    CHECK(other.handle(bits, "b"));
    CHECK(!other.is_in("gate"));
    guard.start(bits, "duty");
    CHECK(active() == "all, duty, hungry, no");
    guard.start(bits, "gate");
    CHECK(active() == "all, duty, gate, hungry, no");
}

TEST_CASE("a machine with a childless state is refused where that is not allowed", "[states]") {
    const auto chart = parse_scxml<Bits>(beside, "duty.scxml", Bindings<Bits>{});
    using Strict = Machine<InFile<Bits>, Interpreted>;
    CHECK_THAT(
        refusal([&] { Strict{chart}; }),
        ContainsSubstring("duty.scxml:5: the state \"duty\" begins in none of the states in it; name one, or allow "
                          "that with the option AllowChildless"));
    std::string text = beside;
    text.replace(text.find(" ansatz:initial=\"none\""), 22, "");
    Bits bits;
    Strict strict{parse_scxml<Bits>(text, "duty.scxml", Bindings<Bits>{})};
    strict.start(bits);
    strict.handle(bits, "a");
    const auto before = saved(strict);
    CHECK_THAT(refusal([&] { strict.reload(bits, chart); }), ContainsSubstring("\"duty\" begins in none"));
    CHECK(saved(strict) == before);
    // One that allows it reads no file of one in which a state begins elsewhere.
    FromFile allowed{chart, {}, {}};
    CHECK_THAT(refusal([&] { load_text(allowed, before); }),
               ContainsSubstring("the description of the machine has changed"));

    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string wrong = beside;
        wrong.replace(wrong.find(what), what.size(), instead);
        return refusal([&] { parse_scxml<Bits>(wrong, "duty.scxml", Bindings<Bits>{}); });
    };
    CHECK_THAT(with("ansatz:initial=\"none\"", "ansatz:initial=\"gate\""),
               ContainsSubstring("duty.scxml:5: ansatz:initial is \"gate\"; it can be \"none\""));
    CHECK_THAT(with("ansatz:initial=\"none\"", "ansatz:initial=\"none\" initial=\"gate\""),
               ContainsSubstring("is to begin in none of the states in it, which is for a state with states inside"));
    CHECK_THAT(with("<state id=\"no\">", "<state id=\"no\" ansatz:initial=\"none\">"),
               ContainsSubstring("the state \"no\" is to begin in none of the states in it"));
}
