// expect: a policy sees a table that this world does not have; add the policy that keeps it
// SPDX-License-Identifier: BSL-1.0
// The springs that an observer draws are those of a world with springs.

#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

using namespace ansatz;

struct Drawing {
    using role = roles::Observer;
    using sees = Types<Springs<>>;
    void observe(const auto& view) { drawn = view.template table<Springs<>>().size(); }
    std::size_t drawn = 0;
};

int main() {
#ifdef ANSATZ_MISTAKE
    World world{SemiImplicitEuler{}, Drawing{}};
#else
    World world{SemiImplicitEuler{}, Springs<>{}, Drawing{}};
#endif
    world.step(0.1 * second);
}
