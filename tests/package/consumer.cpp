// SPDX-License-Identifier: BSL-1.0
// A user's first program. It is built from outside, in each of the three ways there are.
#include <ansatz/world.hpp>

#include <iostream>

using namespace ansatz;

int main() {
    World pool{SemiImplicitEuler{}, Gravity{}, Drag{0.05 / second}};
    const auto ball = pool.add(position(metres(0, 10, 0)));
    for (int i = 0; i < 60; ++i) pool.step(1.0 / 60 * second);
    std::cout << pool.position(ball) << '\n';
    const auto height = y(pool.position(ball));
    return height > 5.0 * metre && height < 5.2 * metre ? 0 : 1;
}
