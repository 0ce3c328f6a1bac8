// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Grid` (declaration.hpp), as the graph of Boost.Graph that it is (graph.hpp).

#include <ansatz/paths/grid/declaration.hpp>
#include <ansatz/paths/grid/graph.hpp>
