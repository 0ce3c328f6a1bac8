// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 4, soft bodies: meshes of triangles; cloth, ropes, balls and boxes that are built of bodies and springs;
/// what acts on surfaces beside springs; and solvers that hold all of it on positions.

#include <ansatz/soft_bodies/area.hpp>
#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/soft_bodies/closed_meshes.hpp>
#include <ansatz/soft_bodies/cloth.hpp>
#include <ansatz/soft_bodies/coloured_xpbd.hpp>
#include <ansatz/soft_bodies/constraint.hpp>
#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/enclosure.hpp>
#include <ansatz/soft_bodies/module.hpp>
#include <ansatz/soft_bodies/plan.hpp>
#include <ansatz/soft_bodies/pressure.hpp>
#include <ansatz/soft_bodies/roles.hpp>
#include <ansatz/soft_bodies/soft_ball.hpp>
#include <ansatz/soft_bodies/soft_box.hpp>
#include <ansatz/soft_bodies/soft_rope.hpp>
#include <ansatz/soft_bodies/spring_colours.hpp>
#include <ansatz/soft_bodies/strain_limit.hpp>
#include <ansatz/soft_bodies/tear.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/soft_bodies/tearing.hpp>
#include <ansatz/soft_bodies/triangle_mesh.hpp>
#include <ansatz/soft_bodies/unjoined.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
