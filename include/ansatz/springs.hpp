// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 3, springs: Hooke's law, springs and ropes between bodies, the stable step; with the solver that
/// ImplicitEuler needs where springs couple bodies.

#include <ansatz/motion/integrators/conjugate_gradient.hpp>
#include <ansatz/springs/constraint.hpp>
#include <ansatz/springs/hooke.hpp>
#include <ansatz/springs/measured_stiffness.hpp>
#include <ansatz/springs/network.hpp>
#include <ansatz/springs/spring.hpp>
#include <ansatz/springs/springs.hpp>
#include <ansatz/springs/stable_step.hpp>
#include <ansatz/springs/step_limit.hpp>
