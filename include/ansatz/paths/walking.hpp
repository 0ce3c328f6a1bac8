// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Bodies of a World that follow paths: steering, ways with a trapezoidal speed and cut corners, the policy `Walkers`,
/// and `Traveller`, which goes to a tile of a grid and searches again when it must (notes 6.3).
// not in the umbrella: it brings a World along, and a search needs none

#include <ansatz/paths/walking/clearance.hpp>
#include <ansatz/paths/walking/steering.hpp>
#include <ansatz/paths/walking/traveller.hpp>
#include <ansatz/paths/walking/walk.hpp>
#include <ansatz/paths/walking/walkers.hpp>
#include <ansatz/paths/walking/way.hpp>
#include <ansatz/paths/walking/way_point.hpp>
