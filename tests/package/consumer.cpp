// SPDX-License-Identifier: BSL-1.0
#include <ansatz/units.hpp>

int main() {}
