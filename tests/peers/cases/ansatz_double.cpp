// SPDX-License-Identifier: BSL-1.0
// Ansatz in double.

#include "tests/peers/cases/ansatz.hpp"

peers::Contestant peers::ansatz_double() { return our_contestant<double>(); }
