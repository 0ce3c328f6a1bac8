// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// More than one core, more than one machine: `Threads` for the loops of one world, `ensemble` for many runs.
///
/// It needs oneTBB. `OnRanks` needs MPI and Boost.MPI, and is a header of its own: `ansatz/execution/on_ranks.hpp`.

#include <ansatz/execution/ensemble.hpp>
#include <ansatz/execution/on_threads.hpp>
#include <ansatz/execution/threads.hpp>
