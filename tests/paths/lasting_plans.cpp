// SPDX-License-Identifier: BSL-1.0
// Plans that last: what failed is remembered by a rule, and a plan that is being performed is saved and goes on.

#include "tests/paths/lasting_plans.hpp"
#include "tests/catch.hpp"
#include "tests/refusal.hpp"
#include "tests/rounds.hpp"

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/goap/memory.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace lasting_plans_tests;
using Catch::Matchers::ContainsSubstring;
using paths::Outcome;
using test::refusal;

namespace {

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

} // namespace

TEST_CASE("what failed is left out of plans for as long as the rule says", "[goap]") {
    std::mt19937 random(41);
    int tries = 0, none = 0, detours = 0, returns = 0, loads = 0, reached = 0;
    for (int world = 0; world < test::rounds(300); ++world) {
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
    CHECK(tries > test::at_least(2000));
    CHECK(none > test::at_least(1000));
    CHECK(detours > test::at_least(100));
    CHECK(returns > test::at_least(300));
    CHECK(loads > test::at_least(1000));
    CHECK(reached > test::at_least(300));
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
