// SPDX-License-Identifier: BSL-1.0
// Plans that last: what failed is remembered by a rule, and a plan that is being performed is saved and goes on.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/goap/memory.hpp>
#include <ansatz/paths/goap/save.hpp>
#include <ansatz/states/save.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace ansatz;
using Catch::Matchers::ContainsSubstring;
using paths::Outcome;
using test::refusal;

namespace {

using Domain = goap::Domain<>;
using Planner = goap::Planner<Domain>;
using Runner = goap::Runner<Planner, goap::Remembers>;
constexpr std::size_t facts = 6;

Domain random_domain(std::mt19937& random) {
    Domain domain;
    std::vector<goap::Fact> fact;
    for (std::size_t f = 0; f < facts; ++f) fact.push_back(domain.fact("fact " + std::to_string(f)));
    for (int a = 0; a < 10; ++a) {
        const std::size_t needed = random() % facts, made = random() % facts, undone = random() % facts;
        const bool needs = random() % 3 != 0, makes = random() % 4 != 0, both = undone != made && random() % 3 == 0;
        const double cost = double(1 + random() % 5);
        auto action = domain.action("action " + std::to_string(a), cost);
        action.needs(needs ? fact[needed] : !fact[needed]).makes(makes ? fact[made] : !fact[made]);
        if (both) action.makes(!fact[undone]);
    }
    return domain;
}

/// The rule of memory.hpp and the cheapest plan, written once more: a map, and all states until nothing gets cheaper.
struct Model {
    struct Known {
        int failures = 0;
        double pause = 0, until = 0;
    };
    int attempts;
    double pause, longest, now = 0;
    std::map<goap::Action, Known> known{};

    bool out(goap::Action a) const { return known.count(a) > 0 && now < known.at(a).until; }
    void failed(goap::Action a) {
        auto& k = known[a];
        if (++k.failures < attempts) return;
        k.pause = k.pause > 0 ? std::min(2 * k.pause, longest) : pause;
        k.until = now + k.pause;
    }
    double best(const Domain& domain, goap::State<> from, const goap::Condition<>& goal) const {
        constexpr double inf = std::numeric_limits<double>::infinity();
        std::vector<double> cost(std::size_t(1) << facts, inf);
        cost[from.bits[0]] = 0;
        for (bool better = true; better;) {
            better = false;
            for (std::size_t s = 0; s < cost.size(); ++s)
                for (goap::Action a = 0; a < domain.actions() && cost[s] < inf; ++a) {
                    const auto& rule = domain.rules()[a];
                    const goap::State<> here{{s}};
                    if (out(a) || !rule.needs.holds_in(here)) continue;
                    double& there = cost[rule.after(here).bits[0]];
                    if (cost[s] + rule.cost < there) there = cost[s] + rule.cost, better = true;
                }
        }
        double least = inf;
        for (std::size_t s = 0; s < cost.size(); ++s)
            if (goal.holds_in(goap::State<>{{s}})) least = std::min(least, cost[s]);
        return least;
    }
};
double cost_of(const Domain& domain, std::span<const goap::Action> actions) {
    double sum = 0;
    for (const auto a : actions) sum += domain.rules()[a].cost;
    return sum;
}
struct Nobody {
    void begin(goap::Action) {}
    goap::Progress tick(goap::Action) { return goap::Progress::failed; }
};
template <class R> std::string saved(const R& runner, const goap::Performance& performance = {}) {
    std::ostringstream out;
    goap::save(runner, performance, out);
    return out.str();
}
template <class R> void load_text(R& runner, const std::string& text) {
    std::istringstream in(text);
    goap::Performance performance;
    Nobody nobody;
    goap::load(runner, performance, nobody, in, "plan.json");
}

} // namespace

TEST_CASE("what failed is left out of plans for as long as the rule says", "[goap]") {
    std::mt19937 random(41);
    int tries = 0, none = 0, detours = 0, returns = 0, loads = 0, reached = 0;
    for (int world = 0; world < 300; ++world) {
        const Domain domain = random_domain(random);
        const int attempts = 1 + int(random() % 3);
        Model model{attempts, 2, world % 5 == 0 ? 2.0 : 16.0};
        Planner planner{domain};
        Runner runner{planner, goap::Remembers{std::size_t(attempts), 2.0 * second, model.longest * second}};
        std::vector<char> broken(domain.actions(), 0);
        for (auto& b : broken) b = char(random() % 3 == 0);
        goap::State<> now{{random() % 64}};
        const auto some = random() % 64, others = random() % 64; // drawn in one order by every compiler
        goap::Condition<> goal{goap::State<>{{random() % 64}}, goap::State<>{{some & others}}};
        goal.value = goal.value & goal.care;
        runner.go(now, goal);
        for (int i = 0; i < 150; ++i) {
            const std::size_t searches = runner.searches();
            switch (random() % 9) {
            case 0: now.set(random() % facts, i % 2 == 0); break;
            case 1:
            case 2: {
                const double dt = double(random() % 16) / 8; // exact
                const auto before = runner.left_out().size();
                runner.pass(dt * second), model.now += dt;
                returns += runner.left_out().size() < before;
                break;
            }
            case 3: broken[random() % broken.size()] ^= 1; break;
            case 4:
                if (random() % 4 == 0) {
                    const goap::Action a = random() % domain.actions();
                    runner.forgive(a), model.known.erase(a);
                } else if (random() % 12 == 0) runner.forgive(), model.known.clear();
                break;
            case 5: {
                Runner other{planner, goap::Remembers{std::size_t(attempts), 2.0 * second, model.longest * second}};
                load_text(other, saved(runner));
                REQUIRE(saved(other) == saved(runner));
                REQUIRE(other.action() == runner.action());
                runner = other;
                ++loads;
                break;
            }
            default: {
                runner.look(now);
                if (!runner.action()) break;
                const auto a = *runner.action();
                ++tries;
                if (broken[a]) runner.failed(now), model.failed(a);
                else {
                    now = domain.rules()[a].after(now);
                    runner.done(now), model.known.erase(a);
                }
            }
            }
            runner.look(now);
            std::vector<goap::Action> out;
            for (goap::Action a = 0; a < domain.actions(); ++a) {
                if (model.out(a)) out.push_back(a);
                REQUIRE(runner.failures(a) == std::uint64_t(model.known.count(a) ? model.known[a].failures : 0));
            }
            REQUIRE(std::vector<goap::Action>(runner.left_out().begin(), runner.left_out().end()) == out);
            if (goal.holds_in(now)) {
                REQUIRE(runner.reached());
                ++reached;
                now = goap::State<>{{random() % 64}};
                runner.look(now);
            }
            if (goal.holds_in(now)) continue;
            const double best = model.best(domain, now, goal);
            if (runner.outcome() == Outcome::found) {
                REQUIRE(runner.holds_in(now));
                for (const auto a : runner.ahead()) REQUIRE(!model.out(a));
                REQUIRE(cost_of(domain, runner.ahead()) >= best);
                if (runner.searches() > searches) {
                    REQUIRE(cost_of(domain, runner.ahead()) == best);
                    Model fresh = model;
                    fresh.known.clear();
                    detours += best > fresh.best(domain, now, goal);
                }
            } else {
                REQUIRE(std::isinf(best)); // there is nothing to do, and that is known without asking again
                REQUIRE(runner.outcome() == (out.empty() ? Outcome::no_path : Outcome::gave_up));
                REQUIRE(!runner.action());
                ++none;
            }
        }
    }
    CHECK(tries > 2000);
    CHECK(none > 1000);
    CHECK(detours > 100);
    CHECK(returns > 300);
    CHECK(loads > 1000);
    CHECK(reached > 300);
}

TEST_CASE("what always fails is tried by the clock, at every rate, and what else there is is done", "[goap]") {
    Domain domain;
    const auto inside = domain.fact("inside");
    const auto door = goap::Action(domain.action("open door", 1).makes(inside));
    struct Hands {
        goap::Action stuck;
        int tries = 0, done = 0;
        void begin(goap::Action a) { tries += a == stuck; }
        goap::Progress tick(goap::Action a) {
            if (a == stuck) return goap::Progress::failed;
            ++done;
            return goap::Progress::done;
        }
    };
    Planner planner{domain};
    goap::State<> now;
    const auto state_of = [&] { return now; };
    for (const int rate : {32, 64, 256}) {
        Hands hands{door};
        goap::Performance performance;
        goap::Runner runner{planner, goap::Remembers{3, 1.0 * second, 8.0 * second}};
        runner.go(now, domain.condition({inside}));
        for (int tick = 0; tick < 60 * rate; ++tick)
            goap::perform(runner, hands, performance, state_of, 1.0 / rate * second);
        CHECK(hands.tries == 3 + 9); // and after 1, 3, 7, 15, 23, 31, 39, 47, 55 s
        CHECK(runner.outcome() == Outcome::gave_up);
        CHECK(runner.searches() == 1 + 2 * 9 + 1); // with the door, without it, and so on
        CHECK(planner.why() == "there is no plan without what is left out: \"open door\"");
        runner.forgive(door);
        CHECK(runner.look(now));
        CHECK(runner.action() == door);
    }
    domain.action("break window", 5).makes(inside);
    Hands hands{door};
    goap::Performance performance;
    goap::Runner runner{planner, goap::Remembers{.pause = std::numeric_limits<double>::infinity() * second,
                                                 .longest = std::numeric_limits<double>::infinity() * second}};
    runner.go(now, domain.condition({inside}));
    for (int tick = 0; tick < 10; ++tick) goap::perform(runner, hands, performance, state_of, 100.0 * second);
    CHECK(hands.tries == 1);
    CHECK(hands.done == 9); // nobody has told the state of the world; he goes on breaking windows
    Runner again{planner, goap::Remembers{}};
    load_text(again, saved(runner)); // an endless pause, too
    CHECK(saved(again) == saved(runner));

    static_assert(sizeof(goap::Runner<Planner>) < sizeof(Runner));
    CHECK_THAT(refusal([&] { goap::Runner(planner, goap::Remembers{.attempts = 0}); }),
               ContainsSubstring("goap::Remembers: attempts is 0; an action is tried once at least"));
    CHECK_THAT(refusal([&] { goap::Runner(planner, goap::Remembers{.pause = 0.0 * second}); }),
               ContainsSubstring("goap::Remembers: pause is 0 s; it must be positive"));
    CHECK_THAT(refusal([&] { goap::Runner(planner, goap::Remembers{.longest = 1.0 * second}); }),
               ContainsSubstring("longest is 1 s; it must be at least the pause, 10 s"));
    const auto before = saved(runner);
    for (const double dt : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THAT(refusal([&] { runner.pass(dt * second); }),
                   ContainsSubstring("the time that has gone by is finite and not negative"));
    CHECK(saved(runner) == before);
}

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
