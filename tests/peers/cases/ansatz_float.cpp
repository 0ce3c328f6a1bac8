// SPDX-License-Identifier: BSL-1.0
// Ansatz in float.

#include "tests/peers/cases/ansatz.hpp"

peers::Contestant peers::ansatz_float() { return our_contestant<float>(); }
