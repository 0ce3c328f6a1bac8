// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 4, soft bodies: solvers that hold constraints on positions.

#include <ansatz/soft_bodies/constraint.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/module.hpp>
#include <ansatz/soft_bodies/roles.hpp>
#include <ansatz/soft_bodies/vertex_block_descent.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
