// expect: a policy reads a table without saying so; add it to its `using sees = Types<...>;`
// SPDX-License-Identifier: BSL-1.0
// What an observer reads, it declares.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Drawing {
    using role = roles::Observer;
#ifndef ANSATZ_MISTAKE
    using sees = Types<Springs<>>;
#endif
    void observe(const auto& view) { drawn = view.template table<Springs<>>().size(); }
    std::size_t drawn = 0;
};

int main() {
    World world{SemiImplicitEuler{}, Springs<>{}, Drawing{}};
    world.step(0.1 * second);
}
