// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Goal oriented action planning (notes 6.2): facts and actions, the graph that they span, a planner that searches it
/// by the same A*, a runner that carries the plan out and plans anew when the world breaks it. Saving a plan that is
/// being performed needs nlohmann-json and is goap/save.hpp. Namespace ansatz::goap.

#include <ansatz/paths/goap/by_machine.hpp>
#include <ansatz/paths/goap/domain.hpp>
#include <ansatz/paths/goap/explain.hpp>
#include <ansatz/paths/goap/heuristics.hpp>
#include <ansatz/paths/goap/memory.hpp>
#include <ansatz/paths/goap/perform.hpp>
#include <ansatz/paths/goap/planner.hpp>
#include <ansatz/paths/goap/runner.hpp>
#include <ansatz/paths/goap/state.hpp>
#include <ansatz/paths/goap/state_graph.hpp>
