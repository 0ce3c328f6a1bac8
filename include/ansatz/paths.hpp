// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Everything of the module `paths`: A* over Boost.Graph's graphs, grids, way points, heuristics, and planning with
/// goals (notes 6); bodies that walk are in ansatz/paths/walking.hpp. All of it lives in the namespace ansatz::paths,
/// goal oriented action planning in ansatz::goap.

#include <ansatz/paths/a_star.hpp>
#include <ansatz/paths/any_angle.hpp>
#include <ansatz/paths/boost_a_star.hpp>
#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/cluster_graph.hpp>
#include <ansatz/paths/clusters.hpp>
#include <ansatz/paths/conflict_based.hpp>
#include <ansatz/paths/cost.hpp>
#include <ansatz/paths/dimacs.hpp>
#include <ansatz/paths/flow_field.hpp>
#include <ansatz/paths/formation.hpp>
#include <ansatz/paths/gate_search.hpp>
#include <ansatz/paths/goals.hpp>
#include <ansatz/paths/goap.hpp>
#include <ansatz/paths/graph.hpp>
#include <ansatz/paths/grid/cell.hpp>
#include <ansatz/paths/grid/from_rows.hpp>
#include <ansatz/paths/grid/graph.hpp>
#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/grid/ground.hpp>
#include <ansatz/paths/grid/jump_points.hpp>
#include <ansatz/paths/grid/neighbours.hpp>
#include <ansatz/paths/heap.hpp>
#include <ansatz/paths/heuristics.hpp>
#include <ansatz/paths/implicit_graph.hpp>
#include <ansatz/paths/lazy_theta.hpp>
#include <ansatz/paths/moving_ai.hpp>
#include <ansatz/paths/nodes.hpp>
#include <ansatz/paths/outcome.hpp>
#include <ansatz/paths/own_loop.hpp>
#include <ansatz/paths/plans.hpp>
#include <ansatz/paths/prioritised.hpp>
#include <ansatz/paths/property_maps.hpp>
#include <ansatz/paths/reopening.hpp>
#include <ansatz/paths/reservations.hpp>
#include <ansatz/paths/roles.hpp>
#include <ansatz/paths/route.hpp>
#include <ansatz/paths/search.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/paths/successors.hpp>
#include <ansatz/paths/true_costs.hpp>
#include <ansatz/paths/visitor.hpp>
#include <ansatz/paths/walking/clearance.hpp>
#include <ansatz/paths/walking/steering.hpp>
#include <ansatz/paths/walking/way.hpp>
#include <ansatz/paths/walking/way_point.hpp>
#include <ansatz/paths/waypoints.hpp>
#include <ansatz/paths/windowed.hpp>
