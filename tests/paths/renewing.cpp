// SPDX-License-Identifier: BSL-1.0
// What is under way is kept where nothing has changed: a route that is checked every frame, an action that a new plan
// begins with as well, a plan that nobody can carry out.

#include "tests/paths/support.hpp"

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/route.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace renewing {

using namespace paths_tests;

/// A graph of streets that counts how often it is read.
/// \tparam Tells whether it also says when something became cheaper
template <bool Tells> struct Net {
    struct Street {
        std::size_t from = 0, to = 0;
        double cost = 1;
        friend bool operator==(const Street& a, const Street& b) { return a.from == b.from && a.to == b.to; }
    };
    std::vector<std::vector<Street>> streets;
    std::size_t changes = 0, cheaper = 0;
    mutable std::size_t reads = 0;

    explicit Net(std::size_t n) : streets(n) {}
    std::size_t version() const { return changes; }
    std::size_t cheaper_version() const
        requires Tells
    {
        return cheaper;
    }
    void set(Street& street, double cost) {
        if (cost == street.cost) return;
        ++changes, cheaper += cost < street.cost;
        street.cost = cost;
    }
};
template <bool T> auto out_edges(std::size_t v, const Net<T>& g) {
    ++g.reads;
    return std::pair(g.streets[v].begin(), g.streets[v].end());
}
template <bool T> std::size_t target(const typename Net<T>::Street& s, const Net<T>&) { return s.to; }
template <bool T> std::size_t num_vertices(const Net<T>& g) { return g.streets.size(); }
template <bool T> boost::typed_identity_property_map<std::size_t> get(boost::vertex_index_t, const Net<T>&) {
    return {};
}
struct Costs {};
template <class Street> double get(Costs, const Street& s) { return s.cost; }
template <bool T> Costs get(boost::edge_weight_t, const Net<T>&) { return {}; }

/// Who writes down what he is told, and goes on, ends or fails by chance.
struct Clerk {
    std::mt19937* random;
    const goap::Domain<>* domain;
    goap::State<>* now;
    std::optional<goap::Action> at_work; // begun, and not ended
    int begun = 0, kept = 0, faults = 0;
    void begin(goap::Action a) {
        faults += at_work == a; // again, in the midst of it
        at_work = a, ++begun;
    }
    goap::Progress tick(goap::Action a) {
        faults += at_work != a; // never begun
        const unsigned chance = (*random)() % 8;
        if (chance < 5) return ++kept, goap::Progress::going;
        at_work.reset();
        if (chance == 5) return goap::Progress::failed;
        *now = domain->rules()[a].after(*now);
        return goap::Progress::done;
    }
};

} // namespace renewing

namespace boost {
template <bool T> struct graph_traits<renewing::Net<T>> {
    using vertex_descriptor = std::size_t;
    using edge_descriptor = typename renewing::Net<T>::Street;
    using out_edge_iterator = typename std::vector<edge_descriptor>::const_iterator;
    using directed_category = directed_tag;
    using edge_parallel_category = allow_parallel_edge_tag;
    using traversal_category = incidence_graph_tag;
    using degree_size_type = std::size_t;
};
} // namespace boost

namespace renewing {

TEMPLATE_TEST_CASE_SIG("a route reads its path once for each change, and nothing else", "[paths]",
                       ((bool Tells), Tells), true, false) {
    std::mt19937 random(71);
    int kept = 0, renewed = 0, opened = 0;
    for (int k = 0; k < 100; ++k) {
        const std::size_t n = 12;
        Net<Tells> net(n);
        for (std::size_t e = 0; e < 2 * n; ++e) {
            const std::size_t from = random() % n, to = random() % n;
            if (std::none_of(net.streets[from].begin(), net.streets[from].end(),
                             [&](const auto& s) { return s.to == to; }))
                net.streets[from].push_back({from, to, double(1 + random() % 9)});
        }
        AStar search{net};
        Route route{search, k % 2 == 0 ? Replan::when_touched : Replan::also_when_cheaper};
        route.go(0, n - 1);
        std::vector<double> costs; // the model: of the steps ahead, when they were found
        auto cost_of = [&](std::size_t a, std::size_t b) {
            for (const auto& s : net.streets[a])
                if (s.to == b) return s.cost;
            return -1.0;
        };
        auto take = [&] {
            costs.clear();
            for (std::size_t i = 0; i + 1 < route.ahead().size(); ++i)
                costs.push_back(cost_of(route.ahead()[i], route.ahead()[i + 1]));
        };
        take();
        std::size_t changes = net.changes, cheaper = net.cheaper;
        for (int frame = 0; frame < 60; ++frame) {
            if (random() % 3 == 0) {
                auto& from = net.streets[random() % n];
                const std::size_t which = random(), weight = 1 + random() % 9;
                if (!from.empty()) net.set(from[which % from.size()], double(weight));
            }
            bool due = false; // by the table in route.hpp
            if (route.outcome() == Outcome::no_path) due = Tells ? net.cheaper != cheaper : net.changes != changes;
            else if (net.changes != changes) {
                for (std::size_t i = 0; i + 1 < route.ahead().size(); ++i)
                    due = due || cost_of(route.ahead()[i], route.ahead()[i + 1]) > costs[i];
                if (k % 2 == 1) due = due || (Tells ? net.cheaper != cheaper : true);
            }
            const bool opens = route.outcome() == Outcome::no_path;
            net.reads = 0;
            REQUIRE(route.needs_new_path() == due);
            const std::size_t reads = net.reads;
            REQUIRE(reads <= route.ahead().size());
            REQUIRE(route.renew() == due);
            if (!due) {
                REQUIRE(net.reads == reads); // known already
                kept += reads > 0;
            } else {
                take();
                cheaper = net.cheaper, changes = net.changes;
                renewed += 1, opened += opens;
            }
            net.reads = 0;
            for (int again = 0; again < 3; ++again) REQUIRE_FALSE(route.renew());
            REQUIRE(net.reads == 0); // nothing has changed since
            if (frame % 7 == 6 && route.outcome() == Outcome::found && !route.arrived()) {
                route.step();
                costs.erase(costs.begin());
            }
        }
    }
    CHECK(kept > 50);
    CHECK(renewed > 50);
    CHECK(opened > 50);
}

TEST_CASE("an action is begun once, also when a new plan begins with it", "[goap]") {
    std::mt19937 random(72);
    int kept = 0, begun = 0;
    for (int k = 0; k < 300; ++k) {
        goap::Domain<> domain;
        std::vector<goap::Fact> facts;
        for (int f = 0; f < 6; ++f) facts.push_back(domain.fact("fact " + std::to_string(f)));
        for (int a = 0; a < 12; ++a) {
            const std::size_t needed = random() % 6, made = (needed + 1 + random() % 5) % 6;
            const auto needs = facts[needed], makes = facts[made];
            const auto cost = 1 + random() % 5;
            const bool without = random() % 2 == 0, undoes = random() % 3 == 0; // drawn in one order by every compiler
            domain.action("action " + std::to_string(a), cost)
                .needs(without ? !needs : needs)
                .makes(undoes ? !makes : makes);
        }
        goap::Planner planner{domain};
        goap::Runner runner{planner};
        goap::State<> now;
        Clerk clerk{&random, &domain, &now, {}};
        goap::Performance performance;
        runner.go(now, domain.condition({facts[0], facts[1], facts[2]}));
        for (int tick = 0; tick < 400; ++tick) {
            if (random() % 3 == 0) { // the world goes on
                const std::size_t fact = random() % 6;
                now.set(fact, random() % 2 == 0);
            }
            const std::size_t plans = runner.plans();
            const auto before = clerk.at_work;
            const int begins = clerk.begun;
            const int ticked = clerk.kept;
            if (!goap::perform(runner, clerk, performance, [&] { return now; }))
                clerk.at_work.reset(); // there was nothing to do
            kept += runner.plans() > plans && clerk.kept > ticked && clerk.at_work == before && clerk.begun == begins;
        }
        REQUIRE(clerk.faults == 0);
        begun += clerk.begun;
    }
    CHECK(begun > 1000);
    CHECK(kept > 50); // a new plan, and the old action goes on
}

TEST_CASE("a planner is not asked again what it has answered, and who always fails is given up", "[goap]") {
    goap::Domain<> domain;
    const auto lit = domain.fact("lamp is lit"), oil = domain.fact("has oil"), noise = domain.fact("dog barks");
    const goap::Action light = domain.action("light lamp").makes(lit);
    struct Clumsy {
        int begun = 0;
        void begin(goap::Action) { ++begun; }
        goap::Progress tick(goap::Action) { return goap::Progress::failed; }
    } clumsy;
    goap::Planner planner{domain};
    goap::State<> now;
    const auto state_of = [&] { return now; };
    goap::Performance performance;

    goap::Runner stubborn{planner}; // tries for ever, but plans once
    stubborn.go(now, domain.condition({lit}));
    for (int tick = 0; tick < 100; ++tick) REQUIRE(goap::perform(stubborn, clumsy, performance, state_of));
    CHECK(clumsy.begun == 100);
    CHECK(stubborn.searches() == 1);
    domain.set_cost(light, 2); // another domain may have another answer
    REQUIRE(goap::perform(stubborn, clumsy, performance, state_of));
    CHECK(stubborn.searches() == 2);

    goap::Runner sensible{planner, 3};
    clumsy.begun = 0;
    sensible.go(now, domain.condition({lit}));
    int ticks = 0;
    while (ticks < 100 && goap::perform(sensible, clumsy, performance, state_of)) ++ticks;
    CHECK(clumsy.begun == 3);
    CHECK(sensible.outcome() == Outcome::gave_up);
    CHECK_FALSE(sensible.reached());
    for (int tick = 0; tick < 10; ++tick) CHECK_FALSE(goap::perform(sensible, clumsy, performance, state_of));
    CHECK(clumsy.begun == 3);
    now.set(noise.number, true); // the world has changed: perhaps it is possible now
    CHECK(goap::perform(sensible, clumsy, performance, state_of));
    CHECK(clumsy.begun == 4);
    CHECK_THAT(test::refusal([&] { goap::Runner(planner, 0); }), ContainsSubstring("attempts is 0"));

    goap::Runner hopeless{planner}; // there is no plan: asked once for each state of the world
    CHECK(hopeless.go(now, domain.condition({oil})) == Outcome::no_path);
    for (int frame = 0; frame < 10; ++frame) CHECK_FALSE(hopeless.look(now));
    CHECK(hopeless.searches() == 1);
    now.set(noise.number, false);
    CHECK(hopeless.look(now));
    CHECK_FALSE(hopeless.look(now));
    CHECK(hopeless.searches() == 2);
    now.set(oil.number, true); // by luck, and gone again: still no plan
    CHECK_FALSE(hopeless.look(now));
    CHECK(hopeless.reached());
    now.set(oil.number, false);
    hopeless.look(now);
    CHECK(hopeless.outcome() == Outcome::no_path);
    CHECK_FALSE(hopeless.reached());
    domain.action("buy oil").makes(oil);
    CHECK(hopeless.look(now));
    CHECK(hopeless.outcome() == Outcome::found);
}

} // namespace renewing
