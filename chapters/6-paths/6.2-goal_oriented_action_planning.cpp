// SPDX-License-Identifier: BSL-1.0
// 6.2 Goal oriented action planning: tea in the woods, a tree to be felled, and an axe that is taken

// "Each possible state is a node on a graph and state changes are edges", say the notes, each with a cost, and "the
// optimal series of state changes can be determined by performing A*". A state is which facts hold, one bit each. A
// node's edges are the actions that are possible in it; nobody draws that graph, it is made while A* expands it. And
// "the way states are encoded allows a similarity comparison": h is made of the number of the goal's facts that are
// still wrong.
//
// The number itself would be an overestimate as soon as an action sets more than one fact, or costs less than one.

#include "claims.hpp"
#include "plot.hpp"
#include "say.hpp"

#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/states/machine.hpp>

#include <iostream>
#include <string>
#include <vector>

using namespace ansatz;

namespace {

//! [machine]
/// Who makes a fire: what he sees of the world, and how the felling goes.
struct Woodcutter {
    const goap::Domain<>* camp;
    goap::State<> sees;
    int blows = 0;
};

/// Each action is a state, with an event that leads there from wherever he is.
struct Felling {
    using Context = Woodcutter;
    static constexpr auto does = [](goap::Action a) {
        return [a](Woodcutter& w) { w.sees = w.camp->rules()[a].after(w.sees); };
    };
    static constexpr auto machine = states::machine(
        states::transition(states::on("fell_the_tree"), states::to("fell the tree")),
        states::transition(states::on("gather_branches"), states::to("gather branches")),
        states::transition(states::on("light_a_fire"), states::to("light a fire")), states::state("stand about"),
        states::state("fell the tree", states::each_update([](Woodcutter& w) { ++w.blows; }),
                      states::transition(states::when([](const Woodcutter& w) { return w.blows == 5; }),
                                         states::then(does(0)), states::to("done"))),
        states::state("gather branches", states::transition(states::when(states::after(3.0 * second)),
                                                            states::then(does(1)), states::to("done"))),
        states::state("light a fire", states::on_entry(does(2)), states::transition(states::to("done"))),
        states::state("done"));
};
//! [machine]

/// The same thief, and a plan that runs through a machine of chapter 5.
void by_machine(workbook::Claims& claim) {
    goap::Domain<> camp;
    const auto axe = camp.fact("has the axe"), wood = camp.fact("has wood"), fire = camp.fact("a fire burns");
    camp.action("fell the tree", 4).needs(axe).makes(wood);
    camp.action("gather branches", 9).makes(wood);
    camp.action("light a fire", 1).needs(wood).makes(fire, !wood);

    //! [perform]
    Woodcutter man{&camp, camp.state({axe})};
    Machine<Felling, Switch, Recorded<>> machine;
    machine.start(man);
    goap::ByMachine crew{machine, man, camp, 1.0 * second}; // a tick is an update of 1 s
    goap::Planner planner{camp};
    goap::Runner runner{planner};
    goap::Performance performance;
    runner.go(man.sees, camp.condition({fire}));
    for (int tick = 1; goap::perform(runner, crew, performance, [&] { return man.sees; }); ++tick)
        if (tick == 3) man.sees.set(axe.number, false); // the thief, after three blows
    //! [perform]

    std::string entered;
    const auto& trace = machine.get<Recorded<>>();
    for (std::size_t i = 0; i < trace.size(); ++i)
        if (trace[i].what == Happening::What::entered)
            entered += (entered.empty() ? "" : ", ") + std::string(machine.name(trace[i].state));
    workbook::say() << "Carried out by a machine: " << entered << '\n';
    claim("the thief takes the machine out of its state, after three blows; the new plan leads it on",
          runner.reached() && runner.plans() == 2 && man.blows == 3 &&
              entered == "stand about, fell the tree, gather branches, done, light a fire, done");
}

} // namespace

int main() {
    workbook::Claims claim;

    //! [domain]
    goap::Domain<> woods;
    const auto axe_lies_there = woods.fact("an axe lies there"), axe = woods.fact("has the axe"),
               felled = woods.fact("the tree is felled"), wood = woods.fact("has wood"),
               fire = woods.fact("a fire burns"), water = woods.fact("has water"), hot = woods.fact("the water is hot"),
               tea = woods.fact("has tea");

    woods.action("take the axe", 1).needs(axe_lies_there).makes(axe, !axe_lies_there);
    woods.action("fell the tree", 4).needs(axe, !felled).makes(felled);
    woods.action("chop wood", 1).needs(axe, felled).makes(wood);
    woods.action("gather branches", 9).makes(wood);
    woods.action("light a fire", 1).needs(wood).makes(fire, !wood);
    woods.action("fetch water", 2).makes(water, !hot);
    woods.action("boil it", 3).needs(fire, water).makes(hot);
    woods.action("brew", 1).needs(hot).makes(tea, !water, !hot);
    //! [domain]

    //! [plan]
    auto now = woods.state({axe_lies_there});
    const auto goal = woods.condition({tea, fire}); // and it shall be warm
    goap::Planner planner{woods};
    planner.plan(now, goal);
    //! [plan]
    const double cost = planner.cost();
    workbook::say() << "The plan, for " << cost << ": " << planner.why() << '\n';
    std::vector<double> step, g, f;
    bool never_too_much = true;
    for (std::size_t i = 0; i < planner.states().size(); ++i) {
        const auto& node = *planner.search().node(planner.states()[i]);
        workbook::say() << "  g " << node.g << ", h " << node.h << "  " << woods.words(planner.states()[i]) << '\n';
        never_too_much = never_too_much && node.h <= planner.cost() - node.g + 1e-12;
        step.push_back(double(i)), g.push_back(node.g), f.push_back(node.f());
    }
    std::cout << planner.expanded() << " states expanded, of " << (1 << woods.facts()) << '\n';
    goap::Planner dijkstra{woods, paths::ZeroHeuristic{}};
    dijkstra.plan(now, goal);
    claim("it is the cheapest there is: a search without an estimate finds none that is cheaper",
          planner.cost() == 13 && dijkstra.cost() == planner.cost());
    claim("h was nowhere more than what the rest of the plan costs", never_too_much);
    claim("the tree is felled though nobody asked for it", planner.states().back().has(felled.number));

    // The plan is carried out, and somebody takes the axe.
    std::cout << "Carried out:\n";
    //! [run]
    goap::Runner runner{planner};
    runner.go(now, goal);
    while (const auto action = runner.action()) {
        now = woods.rules()[*action].after(now); // what a game does here takes time, and may fail
        std::cout << "  " << woods.name_of(*action) << '\n';
        if (woods.name_of(*action) == "take the axe") {
            now.set(axe.number, false); // a thief
            std::cout << "  the axe is taken\n";
        }
        runner.done(now); // on to the next action; plans anew if what is left can no longer be done
    }
    //! [run]
    claim("it planned a second time, gathered branches, and there is tea",
          runner.plans() == 2 && runner.reached() && now.has(tea.number) && !now.has(felled.number));

    // So is it when the actions take time, and are states of a machine.
    by_machine(claim);

    // What does not touch the plan is no reason to plan.
    //! [untouched]
    auto later = woods.state({water, fire});
    runner.go(later, goal);
    later.set(axe_lies_there.number, true); // somebody brings the axe back, while the water is on the fire
    const bool planned = runner.look(later);
    //! [untouched]
    claim("an axe that comes back while the water boils is no reason to plan", !planned && runner.plans() == 1);

    // And when there is no plan at all?
    //! [why]
    goap::Domain<> desert;
    const auto cup = desert.fact("has tea"), boiling = desert.fact("the water is hot"),
               spring = desert.fact("there is a spring");
    desert.action("boil", 3).needs(spring).makes(boiling);
    desert.action("brew", 1).needs(boiling).makes(cup);
    goap::Planner hopeless{desert};
    hopeless.plan(desert.state({}), desert.condition({cup}));
    workbook::say() << hopeless.why() << '\n';
    //! [why]
    claim("it says what is missing", hopeless.outcome() == goap::Outcome::no_path);

    // The number of wrong facts as an estimate.
    //! [greedy]
    goap::Domain<> trap;
    const auto a = trap.fact("a"), b = trap.fact("b"), c = trap.fact("c"), d = trap.fact("d"), e = trap.fact("e"),
               f6 = trap.fact("f");
    trap.action("set a", 2).makes(a);
    trap.action("set a and b", 1).makes(a, b);
    trap.action("all, if a and not b", 1).needs(a, !b).makes(a, b, c, d, e, f6);
    trap.action("all, if a and b", 5).needs(a, b).makes(a, b, c, d, e, f6);
    const auto all = trap.condition({a, b, c, d, e, f6});

    goap::Planner careful{trap};
    goap::Planner greedy{trap, goap::Greedy{}};
    careful.plan(trap.state({}), all);
    greedy.plan(trap.state({}), all);
    //! [greedy]
    std::cout << "h = number of wrong facts: " << greedy.why() << ", for " << greedy.cost() << '\n'
              << "h = that times the least cost of a fact: " << careful.why() << ", for " << careful.cost() << '\n';
    claim("the number of wrong facts overestimates, and finds a plan of twice the cost",
          greedy.cost() == 6 && careful.cost() == 3);

    workbook::Plot plot("6.2", "Along the plan for tea: what it has cost, and what A* thinks it will cost");
    plot.x("actions done").y("cost").linked_points("g, the cost so far", step, g).linked_points("f = g + h", step, f);
    plot.horizontal(cost, "what the plan costs").write();
    return claim.result();
}
