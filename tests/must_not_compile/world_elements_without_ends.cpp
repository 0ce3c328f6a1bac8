// expect: a force between bodies that has element_count, and whose elements the world cannot ask; write
// SPDX-License-Identifier: BSL-1.0
// A force that could be divided over threads but for a verb: it would be summed by one thread, and nobody would know.

#include <ansatz/world.hpp>

#include <array>

using namespace ansatz;

struct InOnePart {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(0, count); }
};
struct Magnet {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Magnet&) {}
        void couple(auto&, const auto&) const {}
        std::size_t element_count(const auto& view) const { return view.size() / 2; }
        std::array<std::size_t, 2> ends(const auto&, std::size_t k) const { return {2 * k, 2 * k + 1}; }
#ifdef ANSATZ_MISTAKE
        typename S::Force forces(const auto&, std::size_t, const auto&) const { return {}; }
#else
        std::array<typename S::Force, 2> forces(const auto&, std::size_t, const auto&) const { return {}; }
#endif
    };
};

int main() {
    World world{SemiImplicitEuler{}, Magnet{}, InOnePart{}};
    world.add(mass(2.0 * kilogram));
    world.step(0.1 * second);
}
