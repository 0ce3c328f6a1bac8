// SPDX-License-Identifier: BSL-1.0
// Files of machines: a save that fails leaves the last good one, and what cannot be is refused when it is read.

#include <ansatz/states/save.hpp>
#include <ansatz/states/scxml.hpp>

#include "tests/scratch.hpp"
#include "tests/states/support.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

using namespace states_tests;
namespace fs = std::filesystem;

namespace {

/// Saves itself from within an action.
struct Selfish {
    using Context = std::function<void()>;
    static constexpr auto machine = states::machine(
        states::state("a", states::transition(states::on("x"), states::then([](std::function<void()>& f) { f(); }))));
};
/// A name in Latin-1.
struct Foreign {
    using Context = int;
    static constexpr auto machine = states::machine(states::state("a"), states::state("a\xFF"));
};
/// What it remembers is a text of the program.
struct Talker {
    using Context = int;
    struct Word {
        std::string word = "w\xFF";
        static void fields(auto& self, auto&& field) { field("word", self.word); }
    };
    static constexpr auto machine = states::machine(states::state("a", states::behaves<Word>()));
};

/// A file of this process alone, which holds the last good state and goes with the test.
struct LastGood {
    std::string path;
    explicit LastGood(const std::string& name) : path(ansatz::test::scratch_path(name).string()) {
        std::ofstream(path) << "good";
    }
    ~LastGood() { fs::remove(path); }
    LastGood(const LastGood&) = delete;
    std::string text() const {
        std::ostringstream out;
        out << std::ifstream(path).rdbuf();
        return out.str();
    }
};

template <class M> std::string saved(const M& machine) {
    std::ostringstream out;
    save(machine, out);
    return out.str();
}
template <class M> void load_text(M& machine, const std::string& text) {
    std::istringstream in(text);
    load(machine, in, "machine.json");
}

} // namespace

TEST_CASE("a save of a machine that is refused leaves the file as it was", "[states]") {
    const LastGood file("selfish");
    each_representation([&]<class R>() {
        Machine<Selfish, R> self;
        std::string said;
        std::function<void()> act = [&] { said = refusal([&] { save(self, file.path); }); };
        self.start(act);
        self.handle(act, "x");
        CHECK_THAT(said, ContainsSubstring("save: called from an action of the machine"));
        CHECK(file.text() == "good");
    });
    struct Silent {
        int n = 0;
    };
    Bindings<int> names;
    names.behaviour<Silent>("silent");
    Outline outline;
    outline.states.resize(2);
    outline.states[1].name = "s", outline.states[1].behaviour = "silent";
    Machine<InFile<int>, Interpreted> silent{make_chart(outline, names)};
    int n = 0;
    silent.start(n);
    CHECK_THAT(refusal([&] { save(silent, file.path); }), ContainsSubstring("the class of the state \"s\" holds"));
    CHECK(file.text() == "good");

    Machine<Selfish, Switch> self, other;
    std::function<void()> nothing = [] {};
    self.start(nothing);
    save(self, file.path);
    CHECK(file.text() == saved(self));
    load(other, file.path);
    CHECK(other.started());
}

namespace {
struct Seen {
    std::vector<bool> rooms{true, false, true};
    std::array<bool, 2> doors{true, false};
    static void fields(auto& self, auto&& field) {
        field("rooms", self.rooms);
        field("doors", self.doors);
    }
    void update(std::vector<bool>& next) {
        if (!next.empty()) rooms = next;
    }
};
struct Explorer {
    using Context = std::vector<bool>;
    static constexpr auto machine = states::machine(state("explores", behaves<Seen>("Seen")));
};
} // namespace

TEST_CASE("a list of bools is saved as any other", "[states]") {
    each_representation([]<class R>() {
        Machine<Explorer, R> machine, other;
        std::vector<bool> next{false, true, true, false, true};
        machine.start(next);
        machine.update(next);
        load_text(other, saved(machine));
        const auto& seen = other.template own<Seen>(other.state("explores"));
        CHECK(seen.rooms == next);
        CHECK(seen.doors == std::array{true, false});
        CHECK(saved(other) == saved(machine));
        auto text = saved(machine);
        text.replace(text.find("\"1\": true"), 9, "\"1\": 1");
        CHECK_THAT(refusal([&] { load_text(other, text); }), ContainsSubstring("machine.json"));
        CHECK(saved(other) == saved(machine));
    });
}

TEST_CASE("a full disk is noticed when a machine is saved", "[states]") {
    if (!fs::exists("/dev/full")) return;
    Machine<Selfish, Switch> machine;
    CHECK_THAT(refusal([&] { save(machine, std::string("/dev/full")); }),
               ContainsSubstring("save: /dev/full could not be written to the end"));
    CHECK_THAT(refusal([&] { save(machine, std::string("/no/such/folder/file")); }),
               ContainsSubstring("save: /no/such/folder/file cannot be opened for writing"));
}

TEST_CASE("a directory is no file of a machine", "[states]") {
    const std::string folder = fs::temp_directory_path().string();
    Machine<Selfish, Switch> machine;
    CHECK_THAT(refusal([&] { load(machine, folder); }), ContainsSubstring(folder + " cannot be read; is it a file?"));
    CHECK(!machine.started());
}

TEST_CASE("a machine's texts that are no UTF-8 are refused, and the file is as it was", "[states]") {
    const LastGood file("foreign");
    each_representation([&]<class R>() {
        Machine<Foreign, R> machine;
        CHECK_THAT(refusal([&] { save(machine, file.path); }),
                   ContainsSubstring("save: the name of the state \"a\xEF\xBF\xBD\" is not UTF-8, and a file holds "
                                     "UTF-8 text"));
        CHECK_THAT(refusal([&] { saved(machine); }), ContainsSubstring("is not UTF-8"));
        Machine<Talker, R> talker;
        CHECK_THAT(refusal([&] { save(talker, file.path); }),
                   ContainsSubstring("save: a text that the machine remembers is not UTF-8"));
        CHECK(file.text() == "good");
    });
}

TEST_CASE("a deep value for the name of a state is refused, and not followed down", "[states]") {
    Machine<Selfish, Switch> machine;
    const auto with = [&](std::size_t levels) {
        auto text = saved(machine);
        text.replace(text.find("\"a\""), 3, std::string(levels, '[') + std::string(levels, ']'));
        return refusal([&] { load_text(machine, text); });
    };
    CHECK_THAT(with(60), ContainsSubstring("machine.json: states[1] is a list; expected the name of a state"));
    CHECK_THAT(with(200000), ContainsSubstring("machine.json"));
}

namespace {

const char* const regions = R"xml(<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0"
    xmlns:ansatz="urn:ansatz:states">
  <parallel id="p">
    <state id="u">
      <history id="H"><transition target="a"/></history>
      <history id="D" type="deep"><transition target="a"/></history>
      <state id="a"><state id="a1"/><state id="a2"/></state>
      <state id="b"/>
      <transition event="out" target="z"/>
    </state>
    <state id="w" ansatz:initial="none">
      <history id="W"><transition target="w1"/></history>
      <state id="w1"/>
    </state>
  </parallel>
  <state id="z"><transition event="back" target="H"/></state>
</scxml>)xml";
using Regional = Machine<InFile<int>, Interpreted, AllowChildless>;
/// Started, and outside of its regions, which its histories remember.
Regional left_its_regions(int& n) {
    Regional machine{parse_scxml<int>(regions, "regions.scxml", Bindings<int>{}), AllowChildless{}};
    machine.start(n);
    machine.handle(n, "out");
    return machine;
}

} // namespace

TEST_CASE("a loaded history of parallel states names what can be active together", "[states]") {
    int n = 0;
    auto machine = left_its_regions(n);
    const auto good = saved(machine);
    load_text(machine, good);
    CHECK(saved(machine) == good);
    const auto with = [&](const char* history, std::vector<std::string> names) {
        auto file = nlohmann::ordered_json::parse(good);
        auto& kept = file["histories"][history] = {{"count", names.size()}};
        for (std::size_t i = 0; i < names.size(); ++i) kept[std::to_string(i)] = names[i];
        const auto said = refusal([&] { load_text(machine, file.dump()); });
        if (said != "nothing") CHECK(saved(machine) == good);
        return said;
    };
    CHECK_THAT(with("H", {"a", "b"}), ContainsSubstring("machine.json: histories.H is") &&
                                          ContainsSubstring("expected names of states that can be active together"));
    CHECK_THAT(with("D", {"a1", "a2"}), ContainsSubstring("histories.D is") && ContainsSubstring("together"));
    CHECK_THAT(with("D", {"a1", "b"}), ContainsSubstring("histories.D is") && ContainsSubstring("together"));
    const auto other = ContainsSubstring("expected names of states that this history can remember");
    CHECK_THAT(with("H", {"a1"}), ContainsSubstring("histories.H is") && other);      // a grandchild, of a shallow one
    CHECK_THAT(with("D", {"a"}), ContainsSubstring("histories.D is") && other);       // not innermost, of a deep one
    CHECK_THAT(with("W", {"w", "w1"}), ContainsSubstring("histories.W is") && other); // alone, and not
    CHECK(with("W", {"w"}) == "nothing");
    CHECK(with("W", {"w1"}) == "nothing");
    CHECK(with("D", {"a2"}) == "nothing");
    CHECK(with("H", {"b"}) == "nothing");
    CHECK(machine.handle(n, "back"));
    CHECK(machine.is_in("b"));
}

TEST_CASE("a list in a file is as long as the file has entries, whatever its count", "[states]") {
    int n = 0;
    auto machine = left_its_regions(n);
    const auto good = saved(machine);
    auto file = nlohmann::ordered_json::parse(good);
    const std::size_t entries = file["histories"]["H"].size() - 1; // beside the count
    REQUIRE(file["histories"]["H"]["count"] == entries);
    for (const std::uint64_t count : {std::uint64_t(entries + 1), std::uint64_t(1) << 24, ~std::uint64_t(0)}) {
        file["histories"]["H"]["count"] = count;
        CHECK_THAT(refusal([&] { load_text(machine, file.dump()); }),
                   ContainsSubstring("machine.json: histories.H.count is " + std::to_string(count)) &&
                       ContainsSubstring("expected a whole number from 0 to " + std::to_string(entries)));
        CHECK(saved(machine) == good);
    }
}
