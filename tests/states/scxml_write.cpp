// SPDX-License-Identifier: BSL-1.0
// What is written as a file reads back as the same machine, whatever its names are, or is refused with a sentence.

#include <ansatz/states/scxml.hpp>
#include <ansatz/states/scxml_write.hpp>

#include "tests/states/support.hpp"

#include <array>
#include <random>
#include <string>
#include <vector>

using namespace states_tests;

namespace {

using Content = Outline::Content;
using What = Content::What;

Outline::State node(std::string name, std::size_t parent = 0) {
    Outline::State s;
    s.name = std::move(name), s.parent = parent;
    return s;
}
Outline::Transition arrow(std::size_t source, std::string events, std::string target) {
    Outline::Transition t;
    t.source = source, t.events = std::move(events);
    if (!target.empty()) t.targets = {std::move(target)};
    return t;
}
/// Two states, and an event that leads from one to the other.
Outline two(const std::string& one = "a", const std::string& other = "b", const std::string& event = "go") {
    Outline m;
    m.states = {Outline::State{}, node(one), node(other)};
    m.transitions = {arrow(1, event, other)};
    return m;
}
void require_the_same(const Outline& m) {
    const auto text = write_scxml(m);
    INFO(text);
    REQUIRE(parse_outline(text, "again") == m);
}
std::string refused(const Outline& m) {
    return refusal([&] { write_scxml(m); });
}

} // namespace

TEST_CASE("names with quotes, ampersands and letters of the world are written and read back", "[states]") {
    for (const std::string name :
         {"it's",     "\"quoted\"",   "a&b",      "&amp;", "<a>",       "]]>",   "<!--", "--",   "&#10;",
          "%20",      "a.b",          "*",        "=",     "wait_here", "größe", "Ω",    "歩く", "\xf0\x9f\x9a\xb6",
          "\xc2\xa0", "\xef\xbf\xbd", "\xc2\x85", "\x7f"}) {
        INFO(name);
        auto m = two(name, "b", name);
        m.name = name;
        m.states[1].entry = {Content{What::action, name, 0}, Content{What::raise, name, 0},
                             Content{What::log, name, 0}};
        m.states[1].behaviour = name;
        m.states[0].initial = {name};
        m.transitions[0].guard = name;
        m.transitions.push_back(arrow(2, "", name));
        require_the_same(m);
    }
}

TEST_CASE("texts that are no list keep their blanks and lines", "[states]") {
    auto m = two();
    m.name = " a  machine\tof\nlines\r ";
    m.transitions[0].guard = " In( 'a' ) \n";
    m.states[1].behaviour = "Patrol <Npc>";
    m.states[1].exit = {Content{What::action, "walk to  the\ndoor", 0}, Content{What::log, "  said: \"& so on\"\n", 0},
                        Content{What::log, "", 0}};
    require_the_same(m);
}

TEST_CASE("a name with a blank in it is refused, for a file lists names with blanks between them", "[states]") {
    CHECK(refused(two("wait here")) == "write_scxml: the name of a state is \"wait here\", with a blank in it; a file "
                                       "lists names with blanks between them: write e.g. \"wait_here\"");
    CHECK(refused(two("a", "\tb")) == "write_scxml: the name of a state is \"?b\", with a blank in it; a file lists "
                                      "names with blanks between them: write e.g. \"_b\"");
    for (const std::string blank : {" ", "\t", "\n", "\r", "a ", " a", "a\nb"}) {
        CHECK_THAT(refused(two(blank)), ContainsSubstring("the name of a state is"));
        CHECK_THAT(refused(two("a", blank)), ContainsSubstring("with a blank in it"));
    }
    CHECK_THAT(refused(two("")), ContainsSubstring("the name of a state is empty"));

    auto m = two();
    m.transitions[0].targets = {"a", "b c"};
    CHECK_THAT(refused(m), ContainsSubstring("a target of a transition of \"a\" is \"b c\""));
    m = two();
    m.states[1].initial = {"b c"};
    CHECK_THAT(refused(m), ContainsSubstring("an initial state of the state \"a\" is \"b c\""));
    m = two();
    m.states[2].each = {Content{What::raise, "two events", 0}};
    CHECK_THAT(refused(m),
               ContainsSubstring("an event that is raised by an action of the state \"b\" is \"two events\""));
    m = two();
    m.states[2].each = {Content{What::action, "look ", 0}};
    CHECK_THAT(refused(m), ContainsSubstring("the name of an action of the state \"b\" is \"look \""));
    m.states[2].each = {Content{What::action, "", 0}};
    CHECK_THAT(refused(m), ContainsSubstring("the name of an action of the state \"b\" is \"\""));
    CHECK_THAT(refused(two("a", "b", " \t")), ContainsSubstring("the event of a transition of \"a\" is blank"));
}

TEST_CASE("several events are one list, however they were separated", "[states]") {
    const auto read = parse_outline(write_scxml(two("a", "b", "  alarm\t noise  ")), "again");
    CHECK(read.transitions[0].events == "alarm noise");
    CHECK(read == two("a", "b", "alarm noise"));
}

TEST_CASE("what no XML can hold is refused with its byte", "[states]") {
    CHECK(refused(two("a\x01")) == "write_scxml: the name of a state is \"a?\", whose byte 1, of the value 1, no XML "
                                   "of UTF-8 can hold");
    CHECK_THAT(refused(two(std::string("a\0b", 3))), ContainsSubstring("whose byte 1, of the value 0,"));
    for (const char* bad : {"\x1b[31m", "\x80", "\xff", "\xc3", "\xc0\xaf", "\xe2\x82", "\xed\xa0\x80",
                            "\xf4\x90\x80\x80", "\xef\xbf\xbe", "\xf8\x88\x80\x80\x80"}) {
        auto m = two();
        m.transitions[0].guard = bad;
        CHECK_THAT(refused(m), ContainsSubstring("the guard of a transition of \"a\" is") &&
                                   ContainsSubstring("no XML of UTF-8 can hold"));
    }
}

TEST_CASE("transitions of the machine itself are written, too; what else it does is refused", "[states]") {
    auto m = two();
    m.transitions.insert(m.transitions.begin(), arrow(0, "reset", "a"));
    m.transitions.front().content = {Content{What::action, "beep", 0}};
    require_the_same(m);
    CHECK_THAT(write_scxml(m), ContainsSubstring("<ansatz:transition event=\"reset\" target=\"a\">"));
    // Wherever it stands in the file, it comes before those of the states.
    const auto read =
        parse_outline("<scxml xmlns:ansatz=\"urn:ansatz:states\"><state id=\"a\"><transition event=\"go\" "
                      "target=\"a\"/></state><ansatz:transition event=\"reset\" target=\"a\"/></scxml>",
                      "text");
    REQUIRE(read.transitions.size() == 2);
    CHECK(read.transitions[0].source == 0);
    CHECK(read.transitions[1].source == 1);

    m.states[0].entry = {Content{What::action, "beep", 0}};
    CHECK_THAT(refused(m), ContainsSubstring("the machine itself does something"));
}

TEST_CASE("what a state of its kind cannot be is refused, and not written so that nothing can read it", "[states]") {
    const auto with = [](auto&& spoil) {
        Outline m = two("a", "b", "go");
        m.states.push_back(node("inside", 2));
        m.states.push_back(node("also", 2));
        spoil(m);
        return refused(m);
    };
    using Kind = states::Kind;
    CHECK(with([](Outline&) {}) == "nothing");
    CHECK_THAT(with([](Outline& m) { m.states[4].kind = Kind::deep_history; }),
               ContainsSubstring("the state \"also\" is a history that goes nowhere the first time; name its initial"));
    CHECK_THAT(with([](Outline& m) {
                   m.states[4].kind = Kind::shallow_history, m.states[4].initial = {"inside"};
                   m.states[4].exit = {Content{What::action, "beep", 0}};
               }),
               ContainsSubstring("is a history that does something"));
    CHECK_THAT(with([](Outline& m) { m.states[2].kind = Kind::parallel, m.states[2].initial = {"also"}; }),
               ContainsSubstring("the state \"b\" is parallel or final, and has an initial state; leave it out"));
    CHECK_THAT(with([](Outline& m) {
                   m.states[2].initial_content = {Content{What::action, "beep", 0}};
               }),
               ContainsSubstring("does something before its initial state, which has no name"));
    CHECK_THAT(with([](Outline& m) { m.states[2].kind = Kind::final; }),
               ContainsSubstring("the state \"inside\" is in \"b\", a final state or a history"));
    CHECK_THAT(with([](Outline& m) { m.states[1].kind = Kind::final; }),
               ContainsSubstring("a transition begins in \"a\", a final state or a history"));
    CHECK_THAT(with([](Outline& m) { m.states[2].kind = Kind::parallel, m.states[2].childless = true; }),
               ContainsSubstring("is no state that can be alone"));
    CHECK_THAT(with([](Outline& m) { m.states[0].childless = true; }), ContainsSubstring("the machine itself is"));
    CHECK_THAT(with([](Outline& m) { m.states[0].kind = Kind::parallel; }), ContainsSubstring("the machine itself is"));
}

TEST_CASE("machines with random names read back the same, or are refused", "[states]") {
    std::mt19937 random(19);
    const std::vector<std::string> pieces{"a",    "b",  " ", "\"",  "'", "&",    "<",    ">", "\n",
                                          "\t",   "\r", "ß", "]]>", "é", "\xff", "\x02", ";", "#",
                                          "&lt;", "歩", ".", "*",   "!", "In('", "--"};
    auto name = [&] {
        std::string text;
        for (std::size_t n = random() % 4; n > 0; --n) text += pieces[random() % pieces.size()];
        return text;
    };
    std::array<int, 2> seen{};
    for (int i = 0; i < 20000; ++i) {
        // Most are of one letter, so that not nearly all are refused.
        auto some = [&](const char* else_) { return random() % 8 == 0 ? name() : std::string(else_); };
        Outline m = two(some("a"), some("b"), some("go"));
        m.name = some("m");
        m.states[1].behaviour = some("");
        m.states[1].entry = {Content{What(random() % 3), some("do"), 0}};
        m.states.push_back(node(some("c"), 2));
        m.transitions[0].guard = some("");
        m.transitions[0].content = {Content{What(random() % 3), some("do"), 0}};
        m.transitions.push_back(arrow(2, some("on"), some("")));
        std::string text;
        const auto sentence = refusal([&] { text = write_scxml(m); });
        const bool written = sentence == "nothing";
        ++seen[written ? 0 : 1];
        if (!written) {
            REQUIRE_THAT(sentence, ContainsSubstring("write_scxml: "));
            continue;
        }
        for (auto& t : m.transitions) { // several events are one list
            std::string list;
            for (const auto& one : states::detail::words(t.events)) list += (list.empty() ? "" : " ") + one;
            t.events = list;
        }
        INFO(text);
        REQUIRE(parse_outline(text, "again") == m);
    }
    CHECK(seen[0] > 2000);
    CHECK(seen[1] > 2000);
}
