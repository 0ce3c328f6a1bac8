// SPDX-License-Identifier: BSL-1.0
#pragma once

// The library's own answer to this exercise.
#include <ansatz/world.hpp>

namespace exercise {

using Body = ansatz::mechanics::PointMass<double, ansatz::Vector<double, 2>>;

using ansatz::mechanics::collide;
using ansatz::mechanics::energy_lost;

} // namespace exercise
