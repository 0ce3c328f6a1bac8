// SPDX-License-Identifier: BSL-1.0
#include <ansatz/world.hpp>
#include <iostream>
using namespace ansatz;
int main() {
    World world{SemiImplicitEuler{}, Gravity{}, Drag{0.05 / second}};
    const auto ball = world.add(position(metres(0, 10, 0)));
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60 * second);
    std::cout << world.position(ball) << '\n';
}
