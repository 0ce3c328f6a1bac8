// SPDX-License-Identifier: BSL-1.0
// Forces that bodies gather, beside the same forces added up by one loop over the elements: the same bits, whatever is
// added, removed, moved to another slot, copied or assigned in between.

#include <ansatz/motion/gathering.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>

#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace ansatz;

namespace {

/// Range by range on this thread, the last one first: what depends on the order of the ranges differs.
struct LastFirst {
    using role = roles::Execution;
    std::size_t lines = 1; ///< in a part
    void execute(std::size_t count, std::size_t, const auto& loop) const {
        for (std::size_t part = (count + lines - 1) / lines; part-- > 0;)
            loop(part * lines, std::min(count, (part + 1) * lines));
    }
};

/// A force on three bodies at a time that follow each other by id: the middle one is pulled to where the others are.
struct Straight {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    Parameter<unit::Stiffness> stiffness = 7.0 * newton_per_metre;
    template <class S> struct In {
        typename S::template ScalarOf<unit::Stiffness> k;
        explicit In(const Straight& straight) : k(S::convert(straight.stiffness)) {}
        void couple(auto& view, const auto& context) const {
            for (std::size_t i = 0; i < element_count(view); ++i)
                for (std::size_t j = 0; j < 3; ++j) view.add_force(ends(view, i)[j], forces(view, i, context)[j]);
        }
        std::size_t element_count(const auto& view) const { return view.size() < 3 ? 0 : view.size() - 2; }
        std::array<std::size_t, 3> ends(const auto&, std::size_t i) const { return {i + 1, i, i + 2}; }
        std::array<typename S::Force, 3> forces(const auto& view, std::size_t i, const auto&) const {
            const auto to = [&](std::size_t j) {
                return typename S::Position(view.template get<Position>(j) - view.template get<Position>(i + 1));
            };
            const typename S::Force before = k * to(i), after = k * to(i + 2);
            return {before + after, -before, -after};
        }
    };
};

static_assert(GatheredCouplingIn<Springs<>, Space<>> && GatheredCouplingIn<Straight, Space<>>);
static_assert(GatheredCouplingIn<Ropes<Undamped, Breaking>, Space<float, 2>> &&
              !GatheredCouplingIn<Attraction, Space<>>);

template <class World_> void at_random(World_& world, std::minstd_rand& random, int what) {
    const auto bodies = world.handles();
    const auto any = [&](std::size_t n) { return std::size_t(random() % n); };
    const auto number = [&] { return double(random() % 1000) / 500 - 1; };
    const auto stiff = (5 + number()) * newton_per_metre;
    const auto damped = 0.2 * newton_second_per_metre;
    if (what < 4 || bodies.size() < 3) {
        world.add(position(metres(10 * number(), 10 * number())), mass((1.5 + number()) * kilogram));
    } else if (what < 10) {
        const auto a = any(bodies.size()), b = (a + 1 + any(bodies.size() - 1)) % bodies.size();
        world.add(Spring{bodies[a], bodies[b], stiff, damped});
    } else if (what < 12) {
        world.add(Spring{metres(number(), number()), bodies[any(bodies.size())], stiff, damped});
    } else if (what < 14) {
        world.add(Rope{bodies[0], bodies[1 + any(bodies.size() - 1)], stiff, damped, 1.0 * metre});
    } else if (what < 15) {
        world.remove(bodies[any(bodies.size())]);
    } else if (what < 17) {
        const auto springs = world.template elements<Spring>().handles();
        if (!springs.empty()) world.remove(springs[any(springs.size())]);
    }
}

/// The same history with another execution, or none; two worlds that are assigned to each other now and then.
template <class... P> std::vector<std::uint64_t> history(unsigned seed, const P&... policies) {
    std::minstd_rand random(seed);
    World world{policies...};
    auto other = world;
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 400; ++i) {
        const int what = int(random() % 20);
        if (what == 19) world = other;
        else if (what == 18) std::swap(world, other);
        else at_random(world, random, what);
        if (random() % 3 == 0) world.step(0.02 * second);
        if (random() % 9 == 0) other.step(0.02 * second);
        hashes.push_back(world.hash());
    }
    CHECK(world.status().ok());
    return hashes;
}

} // namespace

TEST_CASE("Gathered forces are those of the loop over all elements, whatever happens to them", "[gathering]") {
    const unsigned seed = GENERATE(1, 2, 3, 4);
    const std::size_t lines = GENERATE(1, 2, 1000);
    CAPTURE(seed, lines);
    const auto serial =
        history(seed, Space<float, 2>{}, SemiImplicitEuler{}, Springs{}, Ropes{}, Straight{}, Attraction{});
    const auto divided = history(seed, Space<float, 2>{}, SemiImplicitEuler{}, Springs{}, Ropes{}, Straight{},
                                 Attraction{}, LastFirst{lines});
    CHECK(divided == serial);
}
