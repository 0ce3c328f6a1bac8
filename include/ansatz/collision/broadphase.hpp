// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 2.1.1: every broadphase, the boxes that they work on, and `find_pairs`.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/broadphase/all_pairs.hpp>
#include <ansatz/collision/broadphase/binary_split.hpp>
#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/box_table.hpp>
#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/coherent.hpp>
#include <ansatz/collision/broadphase/inside.hpp>
#include <ansatz/collision/broadphase/kept_pairs.hpp>
#include <ansatz/collision/broadphase/lot.hpp>
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/collision/broadphase/recursion.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid.hpp>
#include <ansatz/collision/broadphase/uniform_grid_level.hpp>
