// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Every heuristic: what they have in common, and the headers of each.
///
/// A heuristic is a policy that, bound to a graph and a goal, estimates the cost from a node to the goal: the notes' h
/// (6.1). It **must** not be more than the true cost, else the path that is found may be worse than the best. The
/// nearer it is to the true cost, the fewer nodes are expanded (6.3).
///
/// One of your own has `using role = roles::Heuristic` and
/// `template <class Cost, class Graph> auto bind(const Graph&, const GoalOf<Graph>&) const`, which answers with a
/// function of a vertex. For one that needs no more than vertex and goal, `By{function}` is shorter.

#include <ansatz/paths/heuristics/by.hpp>
#include <ansatz/paths/heuristics/checked.hpp>
#include <ansatz/paths/heuristics/euclid.hpp>
#include <ansatz/paths/heuristics/grid_metrics.hpp>
#include <ansatz/paths/heuristics/landmarks.hpp>
#include <ansatz/paths/heuristics/maximum.hpp>
#include <ansatz/paths/heuristics/unscaled.hpp>
#include <ansatz/paths/heuristics/weighted.hpp>
#include <ansatz/paths/heuristics/zero.hpp>
