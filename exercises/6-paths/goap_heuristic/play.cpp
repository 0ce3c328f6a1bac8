// SPDX-License-Identifier: BSL-1.0
// A workshop planned with your estimate, beside the library's two.

#include "play.hpp"
#include "subject.hpp"

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/heuristics.hpp>

#include <memory>

using namespace ansatz;

/// Your estimate as a policy of the planner: bound to a goal, then asked about states.
struct Yours {
    using role = paths::roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph& g, const paths::GoalOf<Graph>& goal) const {
        std::vector<exercise::Action> actions;
        for (const auto& rule : g.domain().rules())
            actions.push_back({rule.makes.value.bits[0], rule.makes.care.bits[0], rule.cost});
        const exercise::Goal wanted{goal.value.bits[0], goal.care.bits[0]};
        return
            [actions, wanted](const goap::State<>& s) { return Cost(exercise::estimate(s.bits[0], wanted, actions)); };
    }
};

/// Three chairs, each to be made and painted, or to be bought as it should be.
struct Workshop {
    goap::Domain<> domain;
    goap::Condition<> goal;
    Workshop() {
        const auto tools = domain.fact("tools"), wood = domain.fact("wood"), clean = domain.fact("clean");
        want(clean);
        domain.action("fetch tools", 2).makes(tools);
        domain.action("fetch wood", 3).makes(wood, !clean);
        domain.action("clean", 0.5).makes(clean);
        for (int i = 0; i < 3; ++i) {
            const std::string n = " " + std::to_string(i);
            const auto seat = domain.fact("seat" + n), legs = domain.fact("legs" + n), chair = domain.fact("chair" + n),
                       painted = domain.fact("painted" + n);
            want(chair), want(painted);
            domain.action("saw a seat" + n, 0.5).needs(tools, wood).makes(seat, !clean);
            domain.action("turn legs" + n, 1).needs(tools, wood).makes(legs, !clean);
            domain.action("join" + n, 0.5).needs(seat, legs).makes(chair, !seat, !legs);
            domain.action("paint" + n, 0.5).needs(chair).makes(painted, !clean);
            domain.action("buy" + n, 4 + 0.5 * i).makes(chair, painted);
        }
    }
    void want(goap::Fact fact) { goal.care.set(fact.number, true), goal.value.set(fact.number, true); }
};
const Workshop& workshop() {
    static const Workshop shop;
    return shop;
}

template <class... Heuristic> void show(const char* who, workbook::Play& table, Heuristic... heuristic) {
    using Planner = goap::Planner<goap::Domain<>, Heuristic...>;
    auto planner = std::make_shared<Planner>(workshop().domain, heuristic...);
    const goap::State<> start{};
    const auto goal = workshop().goal;
    planner->plan(start, goal);
    table.row(who, {planner->cost(), double(planner->expanded())}, 1,
              [planner, start, goal] { planner->plan(start, goal); });
}

int main() {
    workbook::Play table("Three painted chairs, and a clean shop.", {"the plan costs", "states expanded"});
    table.timed("ns a plan");
    show("yours", table, Yours{});
    show("Careful", table);
    show("Greedy", table, goap::Greedy{});
    show("none", table, paths::ZeroHeuristic{});
    return table.print();
}
