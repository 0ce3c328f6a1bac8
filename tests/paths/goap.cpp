// SPDX-License-Identifier: BSL-1.0
// Goal oriented action planning (notes 6.2).

#include "tests/paths/support.hpp"

#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/goap/explain.hpp>
#include <ansatz/paths/goap/heuristics.hpp>
#include <ansatz/paths/goap/perform.hpp>
#include <ansatz/paths/goap/planner.hpp>
#include <ansatz/paths/goap/runner.hpp>
#include <ansatz/paths/goap/state.hpp>
#include <ansatz/paths/goap/state_graph.hpp>

#include <boost/graph/graph_concepts.hpp>

#include <array>
#include <cmath>
#include <limits>

using namespace paths_tests;
using goap::Fact;

namespace {

BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<goap::StateGraph<>>));
static_assert(SearchGraph<goap::StateGraph<2>>);

/// Felling a tree, with an axe that can be bought or found.
struct Wood {
    goap::Domain<> domain;
    Fact axe = domain.fact("has axe"), money = domain.fact("has money"), wood = domain.fact("has wood"),
         fire = domain.fact("fire burns"), sticks = domain.fact("has sticks");
    goap::Action work = domain.action("work", 4).makes(money);
    goap::Action buy = domain.action("buy axe", 1).needs(money).makes(axe, !money);
    goap::Action fell = domain.action("fell tree", 2).needs(axe).makes(wood);
    goap::Action gather = domain.action("gather sticks", 9).makes(sticks);
    goap::Action burn = domain.action("burn wood", 1).needs(wood).makes(fire, !wood);
    goap::Action burn_sticks = domain.action("burn sticks", 1).needs(sticks).makes(fire, !sticks);
};

/// Two rooms, a robot with two hands, balls to be carried over.
template <std::size_t Words> struct Gripper {
    goap::Domain<Words> domain;
    goap::State<Words> start;
    goap::Condition<Words> goal;
    explicit Gripper(int balls) {
        auto n = [](const std::string& word, int ball, const char* more = "") {
            return word + std::to_string(ball) + more;
        };
        const Fact here = domain.fact("robot in the first room");
        domain.action("go over").needs(here).makes(!here);
        domain.action("go back").needs(!here).makes(here);
        start = domain.state({here});
        for (const char* hand : {" left", " right"}) {
            const Fact free = domain.fact(std::string("free") + hand);
            start.set(free.number, true);
            for (int b = 0; b < balls; ++b) {
                const Fact first = domain.fact(n("first room ", b)), second = domain.fact(n("second room ", b)),
                           held = domain.fact(n("held ", b, hand));
                domain.action(n("pick first ", b, hand)).needs(here, first, free).makes(held, !first, !free);
                domain.action(n("pick second ", b, hand)).needs(!here, second, free).makes(held, !second, !free);
                domain.action(n("drop first ", b, hand)).needs(here, held).makes(first, free, !held);
                domain.action(n("drop second ", b, hand)).needs(!here, held).makes(second, free, !held);
                start.set(first.number, true);
                goal.care.set(second.number, true);
                goal.value.set(second.number, true);
            }
        }
    }
};

/// Blocks in towers; a tower is written from its top.
struct Blocks {
    goap::Domain<2> domain;
    std::string names;
    Fact on(char a, char b) { return domain.fact(std::string("on ") + a + b); }
    Fact table(char a) { return domain.fact(std::string("table ") + a); }
    Fact clear(char a) { return domain.fact(std::string("clear ") + a); }
    Fact held(char a) { return domain.fact(std::string("held ") + a); }
    explicit Blocks(std::string blocks) : names(std::move(blocks)) {
        const Fact empty = domain.fact("hand empty");
        for (const char a : names) {
            domain.action(std::string("pick up ") + a)
                .needs(clear(a), table(a), empty)
                .makes(held(a), !clear(a), !table(a), !empty);
            domain.action(std::string("put down ") + a).needs(held(a)).makes(clear(a), table(a), empty, !held(a));
            for (const char b : names) {
                if (a == b) continue;
                domain.action(std::string("stack ") + a + b)
                    .needs(held(a), clear(b))
                    .makes(on(a, b), clear(a), empty, !held(a), !clear(b));
                domain.action(std::string("unstack ") + a + b)
                    .needs(on(a, b), clear(a), empty)
                    .makes(held(a), clear(b), !on(a, b), !clear(a), !empty);
            }
        }
    }
    goap::State<2> towers(const std::vector<std::string>& all) {
        goap::State<2> s;
        s.set(domain.fact("hand empty").number, true);
        for (const auto& tower : all) {
            s.set(clear(tower.front()).number, true);
            s.set(table(tower.back()).number, true);
            for (std::size_t i = 0; i + 1 < tower.size(); ++i) s.set(on(tower[i], tower[i + 1]).number, true);
        }
        return s;
    }
    double best(const std::vector<std::string>& from, const std::string& to) {
        goap::Condition<2> goal;
        for (std::size_t i = 0; i + 1 < to.size(); ++i) goal.care.set(on(to[i], to[i + 1]).number, true);
        goal.value = goal.care;
        goap::Planner planner{domain};
        return planner.plan(towers(from), goal) == Outcome::found ? planner.cost() : -1;
    }
};

/// The cheapest cost by trying everything: costs of all states, until nothing gets cheaper.
double brute_force(const goap::Domain<>& domain, const goap::State<>& start, const goap::Condition<>& goal) {
    const std::size_t n = std::size_t(1) << domain.facts();
    std::vector<double> cost(n, std::numeric_limits<double>::infinity());
    cost[start.bits[0]] = 0;
    for (bool more = true; more;) {
        more = false;
        for (std::size_t s = 0; s < n; ++s)
            for (const auto& rule : domain.rules()) {
                const goap::State<> state{{s}};
                if (cost[s] == std::numeric_limits<double>::infinity() || !rule.needs.holds_in(state)) continue;
                auto& to = cost[rule.after(state).bits[0]];
                if (cost[s] + rule.cost < to) to = cost[s] + rule.cost, more = true;
            }
    }
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < n; ++s)
        if (goal.holds_in(goap::State<>{{s}})) best = std::min(best, cost[s]);
    return best;
}

struct Random {
    goap::Domain<> domain;
    goap::State<> start;
    goap::Condition<> goal;
    explicit Random(std::mt19937& random) {
        const std::size_t n = 2 + random() % 6;
        for (std::size_t i = 0; i < n; ++i) domain.fact("f" + std::to_string(i));
        for (std::size_t a = 0, actions = 1 + random() % 14; a < actions; ++a) {
            auto building = domain.action("a" + std::to_string(a), random() % 6 == 0 ? 0.0 : double(random() % 40) / 8);
            for (std::size_t i = 0; i < n; ++i) {
                if (random() % 3 == 0) building.needs(Fact{i, random() % 2 == 0});
                if (random() % 3 == 0) building.makes(Fact{i, random() % 2 == 0});
            }
        }
        start.bits[0] = random() % (1u << n);
        goal.care.bits[0] = random() % (1u << n);
        goal.value.bits[0] = random() & goal.care.bits[0];
    }
};

} // namespace

TEST_CASE("the trap for the usual heuristic: the best plan costs 3, not 6", "[goap]") {
    goap::Domain<> domain;
    const Fact a = domain.fact("a"), b = domain.fact("b"), c = domain.fact("c"), d = domain.fact("d"),
               e = domain.fact("e"), f = domain.fact("f");
    domain.action("set a", 2).makes(a);
    domain.action("set a and b", 1).makes(a, b);
    domain.action("optimal", 1).needs(a, !b).makes(a, b, c, d, e, f);
    domain.action("trap", 5).needs(a, b).makes(a, b, c, d, e, f);
    const auto goal = domain.condition({a, b, c, d, e, f});
    goap::Planner careful{domain};
    CHECK(careful.plan(domain.state({}), goal) == Outcome::found);
    CHECK(careful.cost() == 3);
    CHECK(careful.why() == "set a, optimal");
    goap::Planner greedy{domain, goap::Greedy{}};
    CHECK(greedy.plan(domain.state({}), goal) == Outcome::found);
    CHECK(greedy.cost() == 6);
}

TEST_CASE("known optima: the gripper and the blocks", "[goap]") {
    const int best[] = {11, 17};
    for (int k = 0; k < 2; ++k) {
        const Gripper<1> g(4 + 2 * k);
        goap::Planner planner{g.domain};
        REQUIRE(planner.plan(g.start, g.goal) == Outcome::found);
        CHECK(planner.cost() == best[k]);
        CHECK(planner.actions().size() == std::size_t(best[k]));
    }
    Blocks four("ABCD");
    CHECK(four.best({"A", "B", "C", "D"}, "DCBA") == 6);
    CHECK(four.best({"BCAD"}, "DCAB") == 10);
    CHECK(four.best({"DCBA"}, "DCBA") == 0);
    CHECK(four.best({"ABCD"}, "DCBA") ==
          8); // each is lifted once, three of them onto another, the first onto the table
}

TEST_CASE("the cheapest plan of random domains, as by trying everything; greedy plans lead there too", "[goap]") {
    std::mt19937 random(21);
    int found = 0, dearer = 0;
    for (int k = 0; k < 1000; ++k) {
        const Random r(random);
        const double best = brute_force(r.domain, r.start, r.goal);
        goap::Planner planner{r.domain};
        goap::Planner greedy{r.domain, goap::Greedy{}};
        goap::Planner by_buckets{r.domain, goap::Careful{}, Buckets{0.5}};
        INFO("domain " << k);
        REQUIRE((planner.plan(r.start, r.goal) == Outcome::found) == (best < 1e300));
        REQUIRE(greedy.plan(r.start, r.goal) == planner.outcome());
        REQUIRE(by_buckets.plan(r.start, r.goal) == planner.outcome());
        if (!(best < 1e300)) {
            CHECK(planner.actions().empty());
            CHECK_THAT(planner.why(), ContainsSubstring("there is no plan: "));
            continue;
        }
        ++found;
        REQUIRE(planner.cost() == best); // eighths: exact
        REQUIRE(by_buckets.cost() == best);
        dearer += greedy.cost() > best;
        auto check = [&](const auto& p) {
            goap::State<> s = r.start;
            double cost = 0;
            for (const auto a : p.actions()) {
                REQUIRE(r.domain.rules()[a].needs.holds_in(s));
                s = r.domain.rules()[a].after(s);
                cost += r.domain.rules()[a].cost;
            }
            REQUIRE(r.goal.holds_in(s));
            REQUIRE(cost == p.cost());
        };
        check(planner), check(greedy), check(by_buckets);
        // In slices the plan is the same.
        planner.begin(r.start, r.goal);
        while (planner.advance(1) == Outcome::running) {
        }
        REQUIRE(planner.cost() == best);
    }
    CHECK(found > 300);
    CHECK(found < 900);
    CHECK(dearer > 0);
}

TEST_CASE("a plan goes on when it still holds, is made anew when the world breaks it, and ends when the goal is there",
          "[goap]") {
    Wood w;
    goap::Planner planner{w.domain};
    goap::Runner runner{planner};
    auto now = w.domain.state({});
    const auto fire = w.domain.condition({w.fire});
    REQUIRE(runner.go(now, fire) == Outcome::found);
    CHECK(planner.why() == "work, buy axe, fell tree, burn wood");
    CHECK(runner.action() == w.work);
    now.set(w.money.number, true);
    runner.done(now);
    CHECK(runner.action() == w.buy);
    now.set(w.sticks.number, true); // somebody left sticks: a cheaper plan is possible, ours still holds
    CHECK_FALSE(runner.look(now));
    now.set(w.sticks.number, false);
    now.set(w.money.number, false), now.set(w.axe.number, true);
    runner.done(now);
    CHECK(runner.plans() == 1);
    CHECK(runner.action() == w.fell);
    now.set(w.axe.number, false); // the axe is taken
    CHECK(runner.look(now));
    CHECK(runner.plans() == 2);
    CHECK(runner.action() == w.work);
    now.set(w.axe.number, true); // and given back: to work would still lead there
    CHECK_FALSE(runner.look(now));
    runner.failed(now);
    CHECK(runner.action() == w.fell);
    now.set(w.fire.number, true); // lightning
    CHECK_FALSE(runner.look(now));
    CHECK(runner.reached());
    CHECK_FALSE(runner.action());
}

TEST_CASE("a performer carries a plan out, tick by tick", "[goap]") {
    Wood w;
    goap::Planner planner{w.domain};
    goap::Runner runner{planner};
    auto now = w.domain.state({});
    struct Worker {
        const Wood* wood;
        goap::State<>* now;
        int left = 0, begun = 0;
        void begin(goap::Action) { left = 3, ++begun; }
        goap::Progress tick(goap::Action a) {
            if (--left > 0) return goap::Progress::going;
            if (a == wood->fell && begun == 3) return goap::Progress::failed; // the first blow goes amiss
            *now = wood->domain.rules()[a].after(*now);
            return goap::Progress::done;
        }
    } worker{&w, &now};
    static_assert(goap::Performer<Worker>);
    runner.go(now, w.domain.condition({w.fire}));
    goap::Performance performance;
    int ticks = 0;
    while (goap::perform(runner, worker, performance, [&] { return now; })) ++ticks;
    CHECK(runner.reached());
    CHECK(now.has(w.fire.number));
    CHECK(worker.begun == 5); // four actions, one of them twice
    CHECK(ticks == 14);
    CHECK(runner.plans() == 2);
}

TEST_CASE("why there is no plan", "[goap]") {
    goap::Domain<> tea;
    const Fact cup = tea.fact("has tea"), hot = tea.fact("water is hot"), water = tea.fact("has water"),
               cold = tea.fact("stove is cold");
    tea.action("brew", 1).needs(hot, water).makes(cup);
    tea.action("boil", 1).needs(water).makes(hot);
    goap::Planner planner{tea};
    CHECK(planner.plan(tea.state({}), tea.condition({cup})) == Outcome::no_path);
    CHECK(planner.why() ==
          "there is no plan: the goal wants \"has tea\", for which \"brew\" needs \"water is hot\", for which \"boil\" "
          "needs \"has water\", and no action makes it so");
    CHECK(planner.plan(tea.state({cold}), tea.condition({!cold})) == Outcome::no_path);
    CHECK(planner.why() == "there is no plan: the goal wants not \"stove is cold\", and no action makes it so");
    goap::Domain<> door;
    const Fact open = door.fact("open"), locked = door.fact("locked");
    door.action("open", 1).needs(!locked).makes(open);
    door.action("lock", 1).makes(locked, !open);
    goap::Planner porter{door};
    CHECK(porter.plan(door.state({}), door.condition({open, locked})) == Outcome::no_path);
    CHECK_THAT(porter.why(), ContainsSubstring("every fact of the goal can be had, but not all at once; all 3 states"));
    goap::Domain<> ring;
    const Fact hen = ring.fact("hen"), egg = ring.fact("egg");
    ring.action("lay").needs(hen).makes(egg);
    ring.action("hatch").needs(egg).makes(hen);
    goap::Planner farmer{ring};
    CHECK(farmer.plan(ring.state({}), ring.condition({egg})) == Outcome::no_path);
    CHECK(farmer.why() == "there is no plan: the goal wants \"egg\", for which \"lay\" needs \"hen\", and what would "
                          "make it so needs it first");
    CHECK(farmer.plan(ring.state({egg}), ring.condition({egg})) == Outcome::found);
    CHECK(farmer.why() == "nothing needs to be done");
}

TEST_CASE("what a domain is given wrongly it refuses, and a budget ends a plan", "[goap]") {
    goap::Domain<> domain;
    const Fact a = domain.fact("a");
    CHECK(domain.fact("a") == a);
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        CHECK_THAT(test::refusal([&] { domain.action("x", bad); }),
                   ContainsSubstring("the cost of \"x\" is " + describe(bad)));
    CHECK(domain.actions() == 0);
    auto x = domain.action("x", 1);
    CHECK_THAT(test::refusal([&] { domain.action("x", 1); }), ContainsSubstring("\"x\" is there already"));
    CHECK_THAT(test::refusal([&] { x.needs(a, !a); }), ContainsSubstring("\"a\" is given both ways"));
    CHECK_THAT(test::refusal([&] { x.makes(a, Fact{9, true}); }), ContainsSubstring("the fact is 9"));
    CHECK(domain.rules()[x].needs == goap::Condition<>{}); // nor what stood before it
    CHECK(domain.rules()[x].makes == goap::Condition<>{});
    x.needs(!a).makes(a); // so that it can be said again, the right way
    CHECK_THAT(test::refusal([&] { domain.condition({a, !a}); }), ContainsSubstring("\"a\" is wanted both ways"));
    CHECK_THAT(test::refusal([&] { domain.set_cost(7, 1); }), ContainsSubstring("the action is 7"));
    CHECK_THAT(test::refusal([&] { domain.fact(""); }), ContainsSubstring("a fact has a name"));
    for (int i = 1; i < 64; ++i) domain.fact("f" + std::to_string(i));
    CHECK_THAT(test::refusal([&] { domain.fact("one more"); }),
               ContainsSubstring("there is room for 64; take Domain<2>"));
    goap::Domain<2> wide; // facts of the second word count
    for (int i = 0; i < 100; ++i) wide.fact("f" + std::to_string(i));
    wide.action("first").makes(wide.fact("f70"));
    wide.action("then").needs(wide.fact("f70")).makes(wide.fact("f99"));
    goap::Planner planner{wide};
    CHECK(planner.plan(wide.state({}), wide.condition({wide.fact("f99")})) == Outcome::found);
    CHECK(planner.actions().size() == 2);
    const Gripper<1> g(6);
    goap::Planner poor{g.domain};
    CHECK(poor.plan(g.start, g.goal, 20) == Outcome::gave_up);
    CHECK(poor.expanded() == 20);
}

TEST_CASE("an action that is learnt while one plans in slices does no harm", "[goap]") {
    goap::Domain<> domain;
    std::vector<Fact> steps;
    for (int i = 0; i < 20; ++i) steps.push_back(domain.fact("step " + std::to_string(i)));
    for (std::size_t i = 1; i < steps.size(); ++i)
        domain.action("to " + std::to_string(i), double(i)).needs(steps[i - 1]).makes(steps[i]);
    goap::Planner planner{domain};
    planner.begin(domain.state({steps[0]}), domain.condition({steps.back()}));
    for (int i = 0; planner.advance(1) == Outcome::running; ++i)
        domain.action("new " + std::to_string(i), 1e6).makes(steps.back());
    CHECK(planner.outcome() == Outcome::found);
    CHECK(planner.actions().size() == 19);
    CHECK(planner.cost() == 19 * 20 / 2);
}
