// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `World`: the composition root (declaration.hpp), with its members: the door for bodies and policies, the door for
/// elements, and what keeps it whole when a verb fails.

#include <ansatz/world/declaration.hpp>
#include <ansatz/world/door.hpp>
#include <ansatz/world/element_door.hpp>
#include <ansatz/world/whole.hpp>
