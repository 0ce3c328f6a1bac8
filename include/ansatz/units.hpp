// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Quantities with units: everything of this module but printing to streams, which is
/// <ansatz/units/print.hpp>.

#include <ansatz/units/angle.hpp>
#include <ansatz/units/arithmetic.hpp>
#include <ansatz/units/describe.hpp>
#include <ansatz/units/function.hpp>
#include <ansatz/units/parameter.hpp>
#include <ansatz/units/quantity.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/units/symbol.hpp>
#include <ansatz/units/unit.hpp>
#include <ansatz/units/vector.hpp>
#include <ansatz/units/zero.hpp>
