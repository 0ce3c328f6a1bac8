// expect: an execution whose execute the world cannot call; write `void execute(std::size_t count, std::size_t
// SPDX-License-Identifier: BSL-1.0
// An execution that asks its loop for one row at a time.

#include <ansatz/world.hpp>

#include <functional>

using namespace ansatz;

struct Rows {
    using role = roles::Execution;
#ifdef ANSATZ_MISTAKE
    void execute(std::size_t count, std::size_t, const std::function<void(std::size_t)>& loop) const {
        for (std::size_t i = 0; i < count; ++i) loop(i);
    }
#else
    void execute(std::size_t count, std::size_t, const std::function<void(std::size_t, std::size_t)>& loop) const {
        for (std::size_t i = 0; i < count; ++i) loop(i, i + 1);
    }
#endif
};

int main() {
    World world{SemiImplicitEuler{}, Rows{}};
    world.step(0.1 * second);
}
