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

/// The same, which says that it has three threads.
struct LastOfThree : LastFirst {
    int threads() const { return 3; }
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

namespace {

/// A force on the last body only, as long as the first is to the right of where it began; on none before.
struct Late {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class S> struct In {
        explicit In(const Late&) {}
        void couple(auto& view, const auto& context) const {
            if (ends(view, 0)[0] < view.size()) view.add_force(ends(view, 0)[0], forces(view, 0, context)[0]);
        }
        std::size_t element_count(const auto&) const { return 1; }
        std::array<std::size_t, 1> ends(const auto& view, std::size_t) const {
            return {view.template get<Position>(0).value()[0] > 0 ? view.size() - 1 : view.size()};
        }
        std::array<typename S::Force, 1> forces(const auto&, std::size_t, const auto&) const {
            return {S::Force::from_value({3, 5})};
        }
    };
};

/// A square sheet, with springs along its edges, across its cells, to points and between bodies far from each other.
template <class... P> auto sheet(int row, bool backwards, const P&... policies) {
    World world{Space<float, 2>{}, SemiImplicitEuler{}, Springs{}, Straight{}, Late{}, policies...};
    std::minstd_rand random(3);
    std::vector<Handle> bodies;
    for (int i = 0; i < row * row; ++i)
        bodies.push_back(world.add(position(metres(0.1 * (i % row) + 0.001 * (i % 7), 0.1 * (i / row))),
                                   mass((1 + i % 3) * kilogram)));
    const auto n = bodies.size(), width = std::size_t(row);
    const auto join = [&](std::size_t a, std::size_t b) {
        const auto stiff = double(1 + a % 5) * newton_per_metre;
        world.add(Spring{bodies[a], bodies[b % n == a ? (b + 1) % n : b % n], stiff, 0.1 * newton_second_per_metre});
    };
    for (std::size_t k = 0; k + width + 1 < n; ++k) {
        const auto i = backwards ? n - width - 2 - k : k;
        join(i, i + 1);
        join(i, i + width);
        join(i + width + 1, i);
        if (i % 50 == 0) join(i, random());
        if (i % 70 == 0)
            world.add(Spring{metres(0, 1), bodies[i], 2.0 * newton_per_metre, 0.0 * newton_second_per_metre});
    }
    return world;
}

/// What becomes of it, while bodies and springs go and come, so that others take their slots; once it is assigned
/// another sheet of as many.
template <class... P> std::vector<std::uint64_t> history_of_a_sheet(int row, const P&... policies) {
    auto world = sheet(row, false, policies...);
    std::minstd_rand random(3);
    std::vector<std::uint64_t> hashes;
    const auto step = [&] {
        world.step(0.02 * second);
        hashes.push_back(world.hash());
    };
    step();
    world = sheet(row, true, policies...);
    for (int i = 0; i < 20; ++i) {
        step();
        const auto bodies = world.handles();
        if (i % 4 == 1) world.remove(bodies[random() % bodies.size()]);
        if (i % 4 == 2) {
            const auto springs = world.template elements<Spring>().handles();
            world.remove(springs[random() % springs.size()]);
            world.add(Spring{bodies.back(), bodies[random() % (bodies.size() - 1)], 3.0 * newton_per_metre,
                             0.1 * newton_second_per_metre});
        }
        if (i % 4 == 3) {
            world.remove(bodies[0]);
            world.add(position(metres(1, 1)), mass(1.0 * kilogram));
        }
    }
    CHECK(world.status().ok());
    return hashes;
}

} // namespace

TEST_CASE("Forces summed by several shares of the bodies are those of one loop", "[gathering]") {
    const int row = GENERATE(30, 50, 110); // one share, two and four; for three threads three
    CAPTURE(row);
    const auto serial = history_of_a_sheet(row);
    CHECK(history_of_a_sheet(row, LastFirst{1}) == serial);
    CHECK(history_of_a_sheet(row, LastFirst{1000}) == serial);
    CHECK(history_of_a_sheet(row, LastOfThree{}) == serial);
}
