// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 1, motion: integrators, gravity, drag, rest, Newton's laws, SUVAT, energy and momentum.

#include <ansatz/motion/applied_forces.hpp>
#include <ansatz/motion/attraction.hpp>
#include <ansatz/motion/check.hpp>
#include <ansatz/motion/concepts.hpp>
#include <ansatz/motion/coupled_system.hpp>
#include <ansatz/motion/coupling.hpp>
#include <ansatz/motion/decay.hpp>
#include <ansatz/motion/door.hpp>
#include <ansatz/motion/drag.hpp>
#include <ansatz/motion/energy.hpp>
#include <ansatz/motion/events.hpp>
#include <ansatz/motion/facts.hpp>
#include <ansatz/motion/frame_drag.hpp>
#include <ansatz/motion/gravity.hpp>
#include <ansatz/motion/integration.hpp>
#include <ansatz/motion/integrators/compensated.hpp>
#include <ansatz/motion/integrators/explicit_euler.hpp>
#include <ansatz/motion/integrators/implicit_euler.hpp>
#include <ansatz/motion/integrators/runge_kutta4.hpp>
#include <ansatz/motion/integrators/semi_implicit_euler.hpp>
#include <ansatz/motion/integrators/velocity_verlet.hpp>
#include <ansatz/motion/integrators/verlet.hpp>
#include <ansatz/motion/interpolation.hpp>
#include <ansatz/motion/islands.hpp>
#include <ansatz/motion/laws.hpp>
#include <ansatz/motion/module.hpp>
#include <ansatz/motion/momentum.hpp>
#include <ansatz/motion/newton.hpp>
#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/motion/present.hpp>
#include <ansatz/motion/quadratic_drag.hpp>
#include <ansatz/motion/resolved_radius.hpp>
#include <ansatz/motion/rest.hpp>
#include <ansatz/motion/rest_step.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/motion/sleep.hpp>
#include <ansatz/motion/smallest_step.hpp>
#include <ansatz/motion/state.hpp>
#include <ansatz/motion/step.hpp>
#include <ansatz/motion/stop_below.hpp>
#include <ansatz/motion/suvat.hpp>
#include <ansatz/motion/world_radius.hpp>
