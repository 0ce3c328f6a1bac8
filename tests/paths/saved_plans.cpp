// SPDX-License-Identifier: BSL-1.0
// A plan that is being performed is saved, loaded, goes on, and is refused where it does not fit.

#include <ansatz/paths/goap/save.hpp>

#include "tests/catch.hpp"
#include "tests/paths/lasting_plans.hpp"
#include "tests/refusal.hpp"
#include "tests/scratch.hpp"

#include <ansatz/states/save.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace lasting_plans_tests;
using Catch::Matchers::ContainsSubstring;
using test::refusal;

namespace {

/// Tea, by a machine: what takes time, and what may fail in the midst of it.
struct Kitchen {
    Domain domain;
    goap::Fact water = domain.fact("has water"), hot = domain.fact("water is hot"), tea = domain.fact("has tea");
    goap::Action fetch = domain.action("fetch", 2).makes(water, !hot);
    goap::Action boil = domain.action("boil", 3).needs(water).makes(hot);
    goap::Action brew = domain.action("brew", 1).needs(hot).makes(tea, !water, !hot);
};
struct Cook {
    const Kitchen* kitchen;
    goap::State<> now;
    unsigned chance = 1u << 31; // of this cook alone, so that a copy has the same luck
    std::string diary{};
    void does(goap::Action a) { now = kitchen->domain.rules()[a].after(now); }
};
constexpr auto at_work(const char* name, goap::Action Kitchen::*action) {
    return states::state(
        name, states::on_entry([name](Cook& c) { c.diary += std::string(name) + " "; }),
        states::each_update([](Cook& c) { c.chance = c.chance * 1664525u + 1013904223u; }),
        states::transition(states::when([](const Cook& c) { return c.chance >> 27 == 0; }), states::to("hurt")),
        states::transition(states::when(states::after(0.5 * second)),
                           states::then([action](Cook& c) { c.does(c.kitchen->*action); }), states::to("done")));
}
struct Hands {
    using Context = Cook;
    static constexpr auto machine = states::machine(
        states::transition(states::on("fetch"), states::to("fetch")),
        states::transition(states::on("boil"), states::to("boil")),
        states::transition(states::on("brew"), states::to("brew")), states::state("done"),
        at_work("fetch", &Kitchen::fetch), at_work("boil", &Kitchen::boil), at_work("brew", &Kitchen::brew),
        states::state("hurt", states::on_entry([](Cook& c) { c.diary += "hurt "; })));
};
/// Everything that performs, and can be saved.
struct Kettle {
    const Kitchen& kitchen;
    Cook cook{&kitchen, {}};
    Machine<Hands> machine;
    Planner planner{kitchen.domain};
    Runner runner{planner, goap::Remembers{2, 1.0 * second, 4.0 * second}};
    goap::Performance performance;
    goap::ByMachine<Machine<Hands>> crew{machine, cook, kitchen.domain, 0.125 * second};

    explicit Kettle(const Kitchen& k) : kitchen(k) {
        machine.start(cook);
        runner.go(cook.now, kitchen.domain.condition({kitchen.tea}));
    }
    void tick() {
        goap::perform(
            runner, crew, performance, [&] { return cook.now; }, 0.125 * second);
        if (runner.reached()) cook.now = {}, cook.diary += "tea ";
    }
};

} // namespace

TEST_CASE("a plan that was saved in the midst of an action goes on", "[goap]") {
    const Kitchen kitchen;
    std::mt19937 random(9);
    int in_the_midst = 0, left_out = 0, teas = 0;
    for (int round = 0; round < 200; ++round) {
        Kettle one{kitchen};
        one.cook.chance = unsigned(random());
        for (auto n = random() % 60; n > 0; --n) one.tick();
        std::stringstream plan, body;
        goap::save(one.runner, one.performance, plan);
        save(one.machine, body);
        in_the_midst += one.performance.begun.has_value();
        left_out += !one.runner.left_out().empty();

        Kettle two{kitchen};
        two.cook = one.cook;
        load(two.machine, body);
        goap::load(two.runner, two.performance, two.crew, plan);
        REQUIRE(saved(two.runner, two.performance) == saved(one.runner, one.performance));
        for (int tick = 0; tick < 80; ++tick) {
            one.tick(), two.tick();
            REQUIRE(two.cook.diary == one.cook.diary);
            REQUIRE(two.performance.begun == one.performance.begun);
        }
        REQUIRE(saved(two.runner, two.performance) == saved(one.runner, one.performance)); // not even asked more often
        teas += one.cook.diary.find("tea") != std::string::npos;
    }
    CHECK(in_the_midst > 80);
    CHECK(left_out > 10);
    CHECK(teas > 100);
}

TEST_CASE("a saved plan that does not fit is refused, and the runner is as it was", "[goap]") {
    const Kitchen kitchen;
    Kettle one{kitchen};
    one.tick(), one.tick();
    const auto good = saved(one.runner, one.performance);
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        REQUIRE(text.find(what) != std::string::npos);
        text.replace(text.find(what), what.size(), instead);
        const auto said = refusal([&] { load_text(one.runner, text); });
        CHECK(saved(one.runner, one.performance) == good);
        return said;
    };
    CHECK_THAT(with("{", "["), ContainsSubstring("plan.json: it is no JSON; expected a plan that was saved"));
    CHECK_THAT(
        with("\"plan\": 1", "\"plan\": 2"),
        ContainsSubstring("plan.json: plan is 2; expected 1, the version of the format that this library reads"));
    CHECK_THAT(
        with("\"has tea\"\n", "\"has cake\"\n"),
        ContainsSubstring("plan.json: the domain has changed: fact 2 is \"has tea\", and was \"has cake\" when"));
    CHECK_THAT(with("\"name\": \"boil\"", "\"name\": \"cook\""),
               ContainsSubstring("the domain has changed: action 1 is \"boil\", and was \"cook\""));
    CHECK_THAT(
        with("\"cost\": 3.0", "\"cost\": 4.0"),
        ContainsSubstring("the domain has changed: what \"boil\" costs is 3.0, and was 4.0 when the plan was saved"));
    CHECK_THAT(with("\"needs\": {\n     \"has water\": true", "\"needs\": {\n     \"has water\": false"),
               ContainsSubstring("what \"boil\" needs is {\"has water\":true}, and was {\"has water\":false}"));
    CHECK_THAT(with("\"begun\": \"fetch\"", "\"begun\": \"fly\""),
               ContainsSubstring("begun is \"fly\"; expected the name of an action of the domain"));
    CHECK_THAT(with("\"done\": 0", "\"done\": 4"), ContainsSubstring("done is 4; expected a whole number from 0 to 3"));
    CHECK_THAT(with("\"outcome\": \"found\"", "\"outcome\": \"lost\""),
               ContainsSubstring("outcome is \"lost\"; expected one of \"not begun\", \"found\""));
    CHECK_THAT(with("\"outcome\": \"found\"", "\"outcome\": \"no path\""), ContainsSubstring("nothing is to be done"));
    CHECK_THAT(with("\"answer\": \"found\"", "\"answer\": \"no path\""), ContainsSubstring("since there is a plan"));
    CHECK_THAT(with("\"actions\": [\n  \"fetch\",\n  \"boil\"", "\"actions\": [\n  \"boil\",\n  \"fetch\""),
               ContainsSubstring("expected actions that can be done one after the other; \"boil\" cannot"));
    CHECK_THAT(with("\"goal\": {\n  \"has tea\"", "\"goal\": {\n  \"has water\""),
               ContainsSubstring("expected actions that lead to the goal"));
    CHECK_THAT(with("\"goal\": {\n  \"has tea\"", "\"goal\": {\n  \"has cake\""),
               ContainsSubstring("\"has cake\" is none"));
    CHECK_THAT(with("\"memory\"", "\"amnesia\""), ContainsSubstring("expected \"memory\", but there is none"));
    CHECK_THAT(with("\"time\": 0.25", "\"time\": -1"), ContainsSubstring("expected a time that is not negative"));

    goap::Runner<Planner> forgetful{one.planner};
    CHECK_THAT(refusal([&] { load_text(forgetful, good); }), ContainsSubstring("a runner that remembers what failed"));
    // A domain with an action more is another.
    Kitchen other;
    other.domain.action("buy tea", 9).makes(other.tea);
    Planner planner{other.domain};
    Runner two{planner, goap::Remembers{}};
    CHECK_THAT(refusal([&] { load_text(two, good); }),
               ContainsSubstring("the domain has changed: action 3 is \"buy tea\", and was \"none\" when"));
    CHECK_THAT(refusal([&] {
                   goap::Performance p;
                   Nobody nobody;
                   goap::load(one.runner, p, nobody, std::string("/no/such/file"));
               }),
               ContainsSubstring("goap::load: /no/such/file cannot be opened"));
}

TEST_CASE("a plan's file is written whole, or is as it was", "[goap]") {
    const Kitchen kitchen;
    Kettle one{kitchen};
    one.tick(), one.tick();
    const std::string path = ansatz::test::scratch_path("plan").string();
    const auto text = [&] {
        std::ostringstream out;
        out << std::ifstream(path).rdbuf();
        return out.str();
    };
    goap::save(one.runner, one.performance, path);
    const auto good = text();
    CHECK(good == saved(one.runner, one.performance));
    Domain foreign;
    const auto fact = foreign.fact("f\xFF");
    foreign.action("do").makes(fact);
    Planner planner{foreign};
    Runner runner{planner, goap::Remembers{}};
    CHECK_THAT(
        refusal([&] { goap::save(runner, goap::Performance{}, path); }),
        ContainsSubstring("goap::save: the name of the fact \"f\xEF\xBF\xBD\" is not UTF-8, and a file holds UTF-8"));
    CHECK_THAT(refusal([&] { saved(runner); }), ContainsSubstring("is not UTF-8"));
    CHECK(text() == good);
    CHECK_THAT(refusal([&] { load_text(runner, good); }),
               ContainsSubstring("fact 0 is \"f\xEF\xBF\xBD\", and was \"has water\" when"));
    Domain acts;
    acts.action("d\xFF").makes(acts.fact("f"));
    Planner actor{acts};
    CHECK_THAT(refusal([&] {
                   saved(Runner{actor, goap::Remembers{}});
               }),
               ContainsSubstring("the name of the action \"d\xEF\xBF\xBD\" is not UTF-8"));
    std::filesystem::remove(path);
}

TEST_CASE("a full disk is noticed when a plan is saved", "[goap]") {
    if (!std::filesystem::exists("/dev/full")) return;
    const Kitchen kitchen;
    Kettle one{kitchen};
    CHECK_THAT(refusal([&] { goap::save(one.runner, one.performance, std::string("/dev/full")); }),
               ContainsSubstring("save: /dev/full could not be written to the end"));
}

TEST_CASE("a directory is no file of a plan", "[goap]") {
    const Kitchen kitchen;
    Kettle one{kitchen};
    const std::string folder = std::filesystem::temp_directory_path().string();
    CHECK_THAT(refusal([&] { goap::load(one.runner, one.performance, one.crew, folder); }),
               ContainsSubstring(folder + " cannot be read; is it a file?"));
}

TEST_CASE("a deep value in a plan's domain is refused, and not followed down", "[goap]") {
    const Kitchen kitchen;
    Kettle one{kitchen};
    const auto good = saved(one.runner, one.performance);
    for (const std::string what : {"\"has tea\"\n", "3.0", "\"boil\""}) {
        const auto with = [&](std::size_t levels) {
            std::string text = good;
            text.replace(text.find(what), what.size(), std::string(levels, '[') + std::string(levels, ']'));
            return refusal([&] { load_text(one.runner, text); });
        };
        CHECK_THAT(with(60), ContainsSubstring("plan.json: the domain has changed: ") &&
                                 ContainsSubstring(", and was a list when the plan was saved"));
        CHECK_THAT(with(200000), ContainsSubstring("plan.json"));
    }
}
