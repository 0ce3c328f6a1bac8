// SPDX-License-Identifier: BSL-1.0
// Reading machines from files: the conformance scripts, writing and reading back, bad files, reloading, noise as input.
// Runs long with the sanitizers.

#include <ansatz/states/scxml.hpp>
#include <ansatz/states/scxml_elements.hpp>

#include "tests/project.hpp"
#include "tests/states/support.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>

using namespace states_tests;
namespace fs = std::filesystem;

namespace {

struct World_ {
    std::vector<std::string> did;
    bool yes = true;
};
using Names = Bindings<World_>;
Names names() {
    Names n;
    n.guard("yes", [](const World_& w) { return w.yes; });
    n.guard("no", [](const World_& w) { return !w.yes; });
    for (const char* name : {"one", "two", "three"}) n.action(name, [name](World_& w) { w.did.emplace_back(name); });
    n.log([](World_& w, std::string_view text) { w.did.push_back("log " + std::string(text)); });
    return n;
}
std::string in(const std::string& body, const std::string& attributes = "") {
    return "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\"" + attributes + ">\n" + body +
           "\n</scxml>";
}
std::string refused(const std::string& text) {
    return refusal([&] { parse_scxml(text, "guard.scxml", names()); });
}

fs::path data() {
    if (const char* set = std::getenv("ANSATZ_DATA")) return fs::path(set) / "scxml";
    return fs::path(project_folder()) / "../shared/data/scxml";
}
std::set<std::string> configuration(const auto& machine) {
    std::set<std::string> found;
    for (const auto leaf : machine.leaves()) found.emplace(machine.name(leaf));
    return found;
}

} // namespace

TEST_CASE("all conformance scripts of the SCION framework run as their scripts say", "[states]") {
    if (!fs::exists(data())) SKIP("no data: the scripts are not in this checkout");
    // What the subset leaves out, by name: nothing of these. All 59 need no more than states, parallel regions,
    // histories, raised events and the matching of names.
    const std::set<std::string> left_out;
    std::size_t ran = 0;
    for (const auto& entry : fs::recursive_directory_iterator(data())) {
        if (entry.path().extension() != ".scxml" || left_out.count(entry.path().stem().string())) continue;
        INFO(entry.path().string());
        auto script = entry.path();
        const auto json = nlohmann::json::parse(std::ifstream(script.replace_extension(".json")));
        const auto chart = read_scxml(entry.path().string(), names());
        World_ world;
        Machine<InFile<World_>, Interpreted> machine{chart};
        machine.start(world);
        CHECK(configuration(machine) == json.at("initialConfiguration").get<std::set<std::string>>());
        std::size_t step = 0;
        for (const auto& event : json.at("events")) {
            INFO("event " << step++);
            machine.handle(world, event.at("event").at("name").get<std::string>());
            CHECK(configuration(machine) == event.at("nextConfiguration").get<std::set<std::string>>());
        }
        CHECK(parse_outline(write_scxml(chart->outline()), "written") == chart->outline());
        ++ran;
    }
    CHECK(ran == 59);
}

TEST_CASE("every element of the subset is read, bound and done in order", "[states]") {
    const std::string text = R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- a guard -->
<s:scxml xmlns:s="http://www.w3.org/2005/07/scxml" xmlns:qt="http://www.qt.io" xmlns:a="urn:ansatz:states" name="guard" initial="on" version="1.0" datamodel="null">
  <qt:editorinfo geometry="1;2"/>
  <s:state id="on" qt:colour="red">
    <s:initial><s:transition target="b"><s:log label="begin" expr="b"/></s:transition></s:initial>
    <s:onentry><s:script>one</s:script></s:onentry>
    <s:onexit><s:script> two </s:script></s:onexit>
    <a:onupdate><s:script>three</s:script></a:onupdate>
    <s:transition event="stop off.*" cond="yes" target="end"><s:raise event="x"/></s:transition>
    <s:transition event="stay" type="internal" target="c"/>
    <s:state id="b"/>
    <s:state id="c"/>
  </s:state>
  <s:final id="end"/>
</s:scxml>)";
    const auto chart = parse_scxml(text, "guard.scxml", names());
    CHECK(chart->outline().name == "guard");
    CHECK(parse_outline(write_scxml(chart->outline()), "written") == chart->outline());
    World_ world;
    Machine<InFile<World_>, Interpreted, Everything> machine{chart, Everything{}};
    machine.start(world);
    CHECK(text_since(machine) == "+on +b");
    CHECK(world.did == std::vector<std::string>{"one", "log begin: b"});
    machine.update(world, frame);
    CHECK(world.did.back() == "three");
    machine.handle(world, "stay");
    CHECK(text_since(machine) == "-b *1 +c");
    world.yes = false;
    CHECK_FALSE(machine.handle(world, "off.now"));
    world.yes = true;
    machine.get<Everything>().all.clear();
    CHECK(machine.handle(world, "off.now"));
    CHECK(text_since(machine) == "-c -on *0 +end ?3");
    CHECK(world.did.back() == "two");
    CHECK(machine.done());
}

TEST_CASE("a bad file is refused with its path, line and name", "[states]") {
    const auto line2 = [](const std::string& body) { return refused(in(body)); };
    CHECK_THAT(
        line2("<state id=\"a\"><transition event=\"e\" target=\"nowhere\"/></state>"),
        ContainsSubstring("guard.scxml:2: the transition of \"a\" names the state \"nowhere\", which is not there"));
    CHECK_THAT(line2("<state id=\"a\"/>\n<state id=\"a\"/>"),
               ContainsSubstring("guard.scxml:3: the id \"a\" is taken already, by the state of line 2"));
    CHECK_THAT(
        line2("<state id=\"a\"><transition cond=\"maybe\" target=\"a\"/></state>"),
        ContainsSubstring(
            "guard.scxml:2: the transition of \"a\" has the guard \"maybe\", which is not bound; bound are: no, yes"));
    CHECK_THAT(line2("<state id=\"a\"><onentry><script>four</script></onentry></state>"),
               ContainsSubstring("guard.scxml:2: the action \"four\" is not bound; bound are: one, three, two"));
    CHECK_THAT(line2("<state id=\"a\"><onentry>\n<script>one<!-- and -->two</script></onentry></state>"),
               ContainsSubstring("guard.scxml:3: <script> holds the name of one action"));
    CHECK_THAT(line2("<state id=\"a\"><onentry><script>one<b/></script></onentry></state>"),
               ContainsSubstring("guard.scxml:2: <script> holds the name of one action"));
    CHECK_THAT(refused("<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>\n" + in("<state id=\"caf\xe9\"/>")),
               ContainsSubstring("guard.scxml:1: the encoding is \"ISO-8859-1\"; save the file as UTF-8"));
    CHECK_NOTHROW(parse_scxml("\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n" +
                                  in("<state id=\"a\"><onentry><script><!-- what -->one</script></onentry></state>"),
                              "f", names()));
    CHECK_NOTHROW(parse_scxml("<?xml version=\"1.0\"?>" + in("<state id=\"a\"/>"), "f", names()));
    CHECK_THAT(line2("<state id=\"a\" initial=\"b\"><state id=\"c\"/></state>"),
               ContainsSubstring("guard.scxml:2: the state \"a\" names the state \"b\""));
    CHECK_THAT(line2("<state id=\"a\" initial=\"b\"><state id=\"c\"/></state><state id=\"b\"/>"),
               ContainsSubstring("begins in \"b\", which is not inside it"));
    CHECK_THAT(line2("<state id=\"a\">\n<transition event=\"e\" traget=\"a\"/></state>"),
               ContainsSubstring("guard.scxml:3: <transition> has the attribute \"traget\""));
    CHECK_THAT(line2("<state id=\"a\"><invoke/></state>"),
               ContainsSubstring("guard.scxml:2: <invoke> is not in the subset"));
    CHECK_THAT(line2("<state id=\"a\"><stat id=\"b\"/></state>"), ContainsSubstring("<stat> cannot stand in <state>"));
    CHECK_THAT(line2("<state/>"), ContainsSubstring("guard.scxml:2: <state> has no id"));
    // What could not be written and read back: names with blanks, and bytes of no character.
    for (const char* id : {" ", " x", "on guard", "x&#9;"})
        CHECK_THAT(line2("<state id='" + std::string(id) + "'/>"),
                   ContainsSubstring("with a blank in it; no target could name it"));
    CHECK_THAT(line2("<state id='\xff'/>"), ContainsSubstring("whose byte 0 is of no character of XML"));
    CHECK_THAT(line2("<state id='x\x01'/>"), ContainsSubstring("whose byte 1 is of no character of XML"));
    CHECK_THAT(line2("<state id='x'><onentry><script>a\001b</script></onentry></state>"),
               ContainsSubstring("the action is \"a?b\", whose byte 1 is of no character of XML"));
    CHECK_THAT(line2("<state id=\"a\">walk</state>"), ContainsSubstring("text stands in <state>: \"walk\""));
    CHECK_THAT(line2("<state id=\"a\"><transition/></state>"), ContainsSubstring("it would happen for ever"));
    CHECK_THAT(line2("<state id=\"a\"><history id=\"h\"/><state id=\"b\"/></state>"),
               ContainsSubstring("holds one <transition"));
    CHECK_THAT(line2("<state id=\"a\"><history id=\"h\" type=\"wide\"><transition target=\"b\"/></history><state "
                     "id=\"b\"/></state>"),
               ContainsSubstring("shallow or deep, not \"wide\""));
    CHECK_THAT(line2("<final id=\"a\"><transition event=\"e\" target=\"a\"/></final>"),
               ContainsSubstring("<transition> cannot stand in <final>"));
    CHECK_THAT(line2("<state id=\"a\"><transition event=\"e\" target=\"a b\"/></state><state id=\"b\"/>"),
               ContainsSubstring("never active together"));
    CHECK_THAT(line2("<state id=\"a\" id=\"b\"/>"), ContainsSubstring("guard.scxml:2: "));
    CHECK_THAT(line2("<state id=\"a\"><x:y/></state>"), ContainsSubstring("prefix of \"x:y\" is not declared"));
    CHECK_THAT(line2(""), ContainsSubstring("the machine has no states"));
    CHECK_THAT(refused("<scxml>\n<state id=\"a\">\n</scxml>"),
               ContainsSubstring("guard.scxml:3: it is no well-formed XML"));
    CHECK_THAT(refused(""), ContainsSubstring("guard.scxml:1: "));
    CHECK_THAT(refused("<html/>"), ContainsSubstring("the root is <html>; a machine begins with <scxml>"));
    CHECK_THAT(refused(in("<state id=\"a\"/>") + "<scxml/>"), ContainsSubstring("a second root element"));
    CHECK_THAT(refused("<scxml xmlns=\"http://example.org\"><state id=\"a\"/></scxml>"),
               ContainsSubstring("that of SCXML is"));
    CHECK_THAT(refused(std::string("<scxml>\n\0</scxml>", 17)),
               ContainsSubstring("guard.scxml:2: a byte with the value 0"));
    CHECK_THAT(refusal([] { read_scxml("/no/such/file.scxml", names()); }),
               ContainsSubstring("/no/such/file.scxml: the file cannot be opened"));
    CHECK_THAT(refusal([] { read_scxml("/", names()); }), ContainsSubstring("/: "));
    const auto alone = in("<state id=\"a\"/>\n<state id=\"island\"/>");
    CHECK_NOTHROW(parse_scxml(alone, "f", names()));
    CHECK_THAT(refusal([&] { parse_scxml(alone, "f", names(), ReadOptions{.refuse_unreachable = true}); }),
               ContainsSubstring("f:3: the state \"island\" is unreachable"));
}

TEST_CASE("tricks with entities, depth and size end in a sentence, soon", "[states]") {
    std::string laughs = "<!DOCTYPE scxml [<!ENTITY a \"ha\">";
    for (char c = 'b'; c <= 'z'; ++c)
        laughs += std::string("<!ENTITY ") + c + " \"&" + char(c - 1) + ";&" + char(c - 1) + ";\">";
    CHECK_THAT(refused(laughs + "]>\n<scxml><state id=\"&z;\"/></scxml>"), ContainsSubstring("a document type"));
    CHECK_THAT(refused("<!DOCTYPE s [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><scxml><state id=\"&x;\"/></scxml>"),
               ContainsSubstring("a document type"));
    CHECK(parse_outline("<scxml><state id=\"&x;\"/></scxml>", "f").states[1].name ==
          "&x;"); // nobody declares it: four letters

    std::string deep;
    for (int i = 0; i < 1000000; ++i) deep += "<state id=\"s" + std::to_string(i) + "\">";
    for (int i = 0; i < 1000000; ++i) deep += "</state>";
    CHECK_THAT(refused(in(deep)),
               ContainsSubstring(deep.size() > (16u << 20) ? "longer than 16 MB" : "nested more than 256 deep"));
    std::string shorter;
    for (int i = 0; i < 500000; ++i) shorter += "<state id=\"s\">";
    for (int i = 0; i < 500000; ++i) shorter += "</state>";
    CHECK_THAT(refused(in(shorter)), ContainsSubstring("nested more than 256 deep"));
    CHECK_THAT(refused(in(std::string(100u << 20, ' '))), ContainsSubstring("guard.scxml: it is longer than 16 MB"));
    CHECK_THAT(refused(in("<state id=\"" + std::string(1u << 20, 'x') + "\"><transition event=\"e\" target=\"" +
                          std::string(1u << 20, 'y') + "\"/></state>"))
                   .substr(0, 500),
               ContainsSubstring("..."));

    std::string many; // states and events whose product is too much for a table
    for (int i = 0; i < 20000; ++i)
        many += "<state id=\"s" + std::to_string(i) + "\"><transition event=\"e" + std::to_string(i) +
                "\" target=\"s0\"/></state>";
    CHECK_THAT(refused(in(many)), ContainsSubstring("20001 states and 20001 events"));

    // Transitions of which each state takes the first, but all of which stand around all of them.
    std::string wide, around, closed;
    for (int i = 0; i < 1000; ++i)
        wide += "<state id=\"s" + std::to_string(i) + "\"><transition event=\"e" + std::to_string(i) + "\"/></state>";
    for (int i = 0; i < 200; ++i) {
        around += "<state id=\"around" + std::to_string(i) + "\">";
        for (int k = 0; k < 20; ++k) around += "<transition event=\"*\"/>";
        closed += "</state>";
    }
    CHECK_THAT(refused(in(around + wide + closed)), ContainsSubstring("more than 16777216 candidates"));
}

TEST_CASE("a reference is a character of XML, or is refused", "[states]") {
    const auto name = [](const std::string& id) {
        return parse_outline("<scxml><state id=\"" + id + "\"/></scxml>", "f").states[1].name;
    };
    CHECK(name("&#65;&#x42;&#x1F600;") == "AB\xf0\x9f\x98\x80");
    for (const std::string bad : {"&#0;", "&#x0;", "&#1;", "&#xD800;", "&#xFFFE;", "&#x110000;", "&#4294967361;",
                                  "&#18446744073709551681;", "&#;", "&#x;", "&#-65;", "&#X41;", "&#65"}) {
        CAPTURE(bad);
        CHECK_THAT(refused("<scxml>\n<state id=\"a" + bad + "\"/></scxml>"),
                   ContainsSubstring("guard.scxml:2: the reference \"" +
                                     bad.substr(0, std::min<std::size_t>(20, bad.find(';')))));
    }
    // Within these it is only text.
    CHECK(parse_outline("<?a &#0; ?><scxml><!-- &#0; --><state id=\"a\"/><!--&#0;--></scxml>", "f").states[1].name ==
          "a");
}

TEST_CASE("a refused file changes nothing, and a good one is taken over between updates", "[states]") {
    const auto first = parse_scxml(
        in("<state id=\"a\"><transition event=\"go\" target=\"b\"/></state><state "
           "id=\"b\"><onentry><script>one</script></onentry><transition event=\"go\" target=\"a\"/></state>"),
        "f", names());
    World_ world;
    Machine<InFile<World_>, Interpreted, Everything> machine{first, Everything{}};
    machine.start(world);
    machine.handle(world, "go");
    CHECK(machine.active_name() == "b");
    CHECK_THROWS(machine.reload(
        world, parse_scxml(in("<state id=\"b\"><transition event=\"go\" target=\"x\"/></state>"), "f", names())));
    CHECK(machine.active_name() == "b");
    CHECK(&machine.chart() == first.get());

    world.did.clear();
    machine.get<Everything>().all.clear();
    SECTION("the state is there: nothing is left, nothing is entered") {
        CHECK(machine.reload(
                  world,
                  parse_scxml(in("<state id=\"c\"/><state id=\"b\"><onentry><script>two</script></onentry><transition "
                                 "event=\"go\" target=\"c\"/></state>"),
                              "f", names())) == Reloaded::same_states);
        CHECK(world.did.empty());
        CHECK(text_since(machine).empty());
        machine.handle(world, "go");
        CHECK(machine.active_name() == "c");
    }
    SECTION("the state is gone: the machine begins anew") {
        CHECK(machine.reload(world, parse_scxml(in("<state id=\"x\"><onentry><script>two</script></onentry></state>"),
                                                "f", names())) == Reloaded::other_states);
        CHECK(machine.active_name() == "x");
        CHECK(world.did == std::vector<std::string>{"two"});
    }
    SECTION("the state has states now: its initial one is entered") {
        CHECK(
            machine.reload(
                world, parse_scxml(in("<state id=\"x\"/><state id=\"b\"><state id=\"b1\"/><state id=\"b2\"/></state>"),
                                   "f", names())) == Reloaded::other_states);
        CHECK(machine.active_name() == "b1");
        CHECK(text_since(machine) == "+b1");
    }
    SECTION("into parallel states and back") {
        CHECK(machine.reload(world, parse_scxml(in("<parallel id=\"p\"><state id=\"q\"><state id=\"q1\"/><state "
                                                   "id=\"b\"/></state><state id=\"r\"/></parallel>"),
                                                "f", names())) == Reloaded::other_states);
        CHECK(configuration(machine) == std::set<std::string>{"b", "r"});
        CHECK(machine.reload(world, first) == Reloaded::other_states);
        CHECK(machine.active_name() == "b");
    }
    SECTION("an action cannot") {
        auto n = names();
        SharedChart<World_> other = first;
        std::string said;
        n.action("reload", [&](World_& w) { said = refusal([&] { machine.reload(w, other); }); });
        machine.reload(
            world,
            parse_scxml(in("<state id=\"b\"><transition event=\"go\"><script>reload</script></transition></state>"),
                        "f", n));
        machine.handle(world, "go");
        CHECK_THAT(said, ContainsSubstring("from an action"));
    }
}

TEST_CASE("no text makes the reader fall over", "[states]") {
    // Grammar-aware noise: pieces of machines glued together, bytes changed, cut and doubled. ANSATZ_FUZZ_SECONDS says
    // how long.
    const char* set = std::getenv("ANSATZ_FUZZ_SECONDS");
    const double seconds = set != nullptr ? std::atof(set) : 2;
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<std::string> pieces = {
        "<state id=\"a\">",
        "</state>",
        "<state id=\"b\"/>",
        "<parallel id=\"p\">",
        "</parallel>",
        "<final id=\"f\"/>",
        "<transition event=\"e\" target=\"a\"/>",
        "<transition cond=\"yes\" target=\"b\"/>",
        "<transition target=\"h\"/>",
        "<history id=\"h\" type=\"deep\"><transition target=\"a\"/></history>",
        "<history id=\"k\"><transition target=\"b p\"/></history>",
        "<onentry><raise event=\"e\"/><script>one</script></onentry>",
        "<initial><transition target=\"b\"/></initial>",
        "<transition event=\"e.* done.state.a *\" target=\"a b\" type=\"internal\"><raise event=\"e.x\"/></transition>",
        "<state id=\"c\" initial=\"b\">",
        "<!--",
        "-->",
        "<![CDATA[",
        "]]>",
        "&amp;",
        "&#0;",
        "\"",
        "<",
        ">",
        "\xff\xfe"};
    std::mt19937_64 random(5);
    std::size_t tried = 0, accepted = 0;
    while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < seconds) {
        std::string body;
        std::vector<std::string> open;
        for (auto n = random() % 14; n-- > 0;) {
            body += pieces[random() % (random() % 8 ? pieces.size() - 10 : pieces.size())];
            if (body.ends_with("\">") && !body.ends_with("]>"))
                open.push_back(body.ends_with("\"p\">") ? "</parallel>" : "</state>");
            if (!open.empty() && body.ends_with(open.back())) open.pop_back();
        }
        for (; !open.empty() && random() % 8; open.pop_back()) body += open.back();
        std::string text = in(body);
        for (auto n = random() % 3; n-- > 0 && random() % 2;) {
            const auto at = random() % text.size();
            switch (random() % 3) {
            case 0: text[at] = char(random()); break;
            case 1: text.erase(at, 1 + random() % 9); break;
            default: text.insert(at, text.substr(random() % text.size(), random() % 60));
            }
            if (text.empty()) break;
        }
        ++tried;
        try {
            const auto chart = parse_scxml(text, "f", names());
            ++accepted;
            REQUIRE(parse_outline(write_scxml(chart->outline()), "w") == chart->outline());
            World_ world;
            Machine<InFile<World_>, Interpreted> machine{chart};
            machine.start(world);
            for (const char* e : {"e", "e.x", "z", "done.state.a", "e"}) {
                machine.handle(world, e);
                machine.update(world, frame);
                REQUIRE_FALSE(machine.leaves().empty());
                world.yes = !world.yes;
            }
            to_dot(chart->outline(), machine.active_names());
            check(chart->outline());
        } catch (const std::invalid_argument& e) {
            const std::string said = e.what();
            if (said.find("f:") != 0 || said.size() > 2000) FAIL(said << " of " << text);
        }
    }
    INFO(tried << " texts, " << accepted << " machines");
    CHECK(tried > 100);
    CHECK(accepted > tried / 1000);
}
