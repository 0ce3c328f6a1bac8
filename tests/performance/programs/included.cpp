// SPDX-License-Identifier: BSL-1.0
#include <ansatz/world.hpp>
int main() {}
