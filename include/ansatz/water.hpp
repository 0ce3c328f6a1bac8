// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 7, water: height maps and their files, columns of water and what moves them, sums of waves, which need no
/// world; and pools of a world.

#include <ansatz/units/print.hpp>
#include <ansatz/water/bodies_in_water.hpp>
#include <ansatz/water/buoyancy.hpp>
#include <ansatz/water/clamped_columns.hpp>
#include <ansatz/water/column_grid.hpp>
#include <ansatz/water/dispersion.hpp>
#include <ansatz/water/floating.hpp>
#include <ansatz/water/foam.hpp>
#include <ansatz/water/gerstner_waves.hpp>
#include <ansatz/water/height_files.hpp>
#include <ansatz/water/height_map.hpp>
#include <ansatz/water/module.hpp>
#include <ansatz/water/pipes.hpp>
#include <ansatz/water/pool.hpp>
#include <ansatz/water/pools.hpp>
#include <ansatz/water/ring.hpp>
#include <ansatz/water/ripples.hpp>
#include <ansatz/water/roles.hpp>
#include <ansatz/water/second_order_shallow_water.hpp>
#include <ansatz/water/shallow_water.hpp>
#include <ansatz/water/soft_surface.hpp>
#include <ansatz/water/submerged.hpp>
#include <ansatz/water/surface.hpp>
#include <ansatz/water/surface_contacts.hpp>
#include <ansatz/water/water_columns.hpp>
#include <ansatz/water/waves.hpp>
