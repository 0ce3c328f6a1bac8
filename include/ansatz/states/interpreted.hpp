// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Interpreted`: the machine that walks a description (interpreted_machine.hpp), with how it takes transitions
/// (interpreted_moves.hpp) and how its description is replaced while it runs (reload.hpp).

#include <ansatz/states/interpreted_machine.hpp>
#include <ansatz/states/interpreted_moves.hpp>
#include <ansatz/states/reload.hpp>
