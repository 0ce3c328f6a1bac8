// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The composition root and the policies to compose: this one header is enough for an engine.

#include <ansatz/motion.hpp>
#include <ansatz/units/print.hpp>
#include <ansatz/world/element_table.hpp>
#include <ansatz/world/fixed_step.hpp>
#include <ansatz/world/keep.hpp>
#include <ansatz/world/table_door.hpp>
#include <ansatz/world/world.hpp>
