// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Chapter 5, choice and states: finite state machines, described once, in four representations; guards that see
/// crossings, bands and times; writing, drawing and checking them. Reading them from a file needs pugixml and is
/// states/scxml.hpp; saving where they are needs nlohmann-json and is states/save.hpp.

#include <ansatz/states/check.hpp>
#include <ansatz/states/dot.hpp>
#include <ansatz/states/machine.hpp>
#include <ansatz/states/oscillation.hpp>
#include <ansatz/states/overlap.hpp>
#include <ansatz/states/scxml_write.hpp>
