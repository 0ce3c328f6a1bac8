// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Everything of the module `collision`: shapes, broadphases, the narrowphase, responses and filters (notes 2).

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/broadphase.hpp>
#include <ansatz/collision/broadphase/all_pairs.hpp>
#include <ansatz/collision/broadphase/binary_split.hpp>
#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/inside.hpp>
#include <ansatz/collision/broadphase/lot.hpp>
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/collision/broadphase/recursion.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid.hpp>
#include <ansatz/collision/broadphase/uniform_grid_level.hpp>
#include <ansatz/collision/check.hpp>
#include <ansatz/collision/collisions.hpp>
#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/contact_order.hpp>
#include <ansatz/collision/filter/layers.hpp>
#include <ansatz/collision/islands.hpp>
#include <ansatz/collision/narrowphase/box_box.hpp>
#include <ansatz/collision/narrowphase/box_plane.hpp>
#include <ansatz/collision/narrowphase/first_touch.hpp>
#include <ansatz/collision/narrowphase/narrowphase.hpp>
#include <ansatz/collision/narrowphase/pairs.hpp>
#include <ansatz/collision/narrowphase/sphere_box.hpp>
#include <ansatz/collision/narrowphase/sphere_plane.hpp>
#include <ansatz/collision/narrowphase/sphere_sphere.hpp>
#include <ansatz/collision/narrowphase/swept.hpp>
#include <ansatz/collision/plane.hpp>
#include <ansatz/collision/queries.hpp>
#include <ansatz/collision/queries_in_world.hpp>
#include <ansatz/collision/response/impulse.hpp>
#include <ansatz/collision/response/penalty.hpp>
#include <ansatz/collision/response/projection.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/collision/restitution.hpp>
#include <ansatz/collision/shapes.hpp>
#include <ansatz/collision/sphere.hpp>
#include <ansatz/collision/swept_collisions.hpp>
