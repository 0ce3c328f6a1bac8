// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What even units need: everything of this module.

#include <ansatz/core/compiler_flags.hpp>
#include <ansatz/core/error.hpp>
