// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What planning estimates with: `Careful`, which never is too much, and `Greedy`, which is faster and may miss the
/// best plan. <!-- costs: paths planner/*: Greedy < 0.5 Careful -->
///
/// Both count the facts of the goal that are not yet as they should be (the notes' similarity of states). `Greedy`
/// takes that number for the cost. It is too much as soon as one action satisfies several facts, or costs less than
/// one; the usual GOAP libraries do this and then return dearer plans. `Careful` multiplies it by the least that any
/// action asks for one fact of this goal:
/// \f[ h = u \cdot \min_a \frac{c_a}{n_a} \f]
/// with u the unmet facts, c_a the cost of an action and n_a how many facts of the goal it can satisfy. An action
/// satisfies at most n_a and so lowers h by at most its cost: h is admissible and consistent.

#include <ansatz/paths/goap/state_graph.hpp>
#include <ansatz/paths/graph.hpp>

#include <cstddef>

namespace ansatz::goap {

/// Never too much: plans are the cheapest there are (the default).
struct Careful {
    using role = paths::roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph& g, const paths::GoalOf<Graph>& goal) const {
        double cost = 0; // of the action that asks least for one fact of the goal, and how many it satisfies
        int most = 0;
        for (const auto& rule : g.domain().rules()) {
            // Those of the goal's facts that it makes as they should be.
            const int meets = (rule.makes.care & goal.care & ~(rule.makes.value ^ goal.value)).count();
            if (meets > 0 && (most == 0 || rule.cost * most < cost * meets)) cost = rule.cost, most = meets;
        }
        const double least = most == 0 ? 0 : cost / most; // 0: no action satisfies any
        // A little less: the sum of rounded costs may be below the product.
        return [goal, each = least * (1 - 1e-15)](const auto& s) { return Cost(goal.unmet_in(s).count() * each); };
    }
};

/// The number of unmet facts, whatever the actions cost: fewer states are expanded, the plan may be dearer than need
/// be.
struct Greedy {
    using role = paths::roles::Heuristic;
    template <class Cost, class Graph> auto bind(const Graph&, const paths::GoalOf<Graph>& goal) const {
        return [goal](const auto& s) { return Cost(goal.unmet_in(s).count()); };
    }
};

} // namespace ansatz::goap
