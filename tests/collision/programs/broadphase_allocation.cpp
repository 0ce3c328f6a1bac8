// SPDX-License-Identifier: BSL-1.0
// Every broadphase, warm, finds the pairs of bodies that move on. The script of this name says what it shows.
#include "tests/collision/broadphase/scenes.hpp"

#include "tests/operator_new.hpp"
#include <cstdio>
#include <cstdlib>

/// While this holds, an allocation ends the program.
static bool forbidden = false;
static bool allowed(std::size_t) noexcept {
    if (forbidden) std::puts("operator new was called"), std::exit(1);
    return true;
}

using namespace broadphase_tests;

/// \param swing m, how far they go to each side
/// \param later m, the same after some steps
template <class S> void steps_of_all(const char* space, double swing, double later) {
    each_policy([&](const char* name, const auto& policy) {
        typename std::remove_cvref_t<decltype(policy)>::template In<S> bound(policy);
        for (const std::uint64_t seed :
             {4u, 9u, 14u, 19u}) { // 400 bodies: uniform, clustered, in a column, of mixed radii
            const auto scene = seeded_scene(seed);
            auto boxes = boxes_of<S>(scene);
            std::size_t pairs = 0;
            for (int step = 0; step < 60; ++step) {
                for (std::size_t i = 0; i < scene.boxes.size(); ++i) { // each swings about its place
                    auto moved = scene.boxes[i];
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double by = (step < 25 ? swing : later) * std::sin(0.7 * step + double(i + k));
                        moved.lower[k] += by, moved.upper[k] += by;
                    }
                    Vector<typename S::Scalar, S::dimension> low, high;
                    for (int k = 0; k < S::dimension; ++k)
                        low[k] = typename S::Scalar(moved.lower[std::size_t(k)]),
                        high[k] = typename S::Scalar(moved.upper[std::size_t(k)]);
                    boxes.set(i, S::Position::from_value(low), S::Position::from_value(high));
                }
                forbidden = step >= 20;
                bound.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
                forbidden = false;
            }
            if (pairs == 0) std::puts("no pairs: the case has lost its point"), std::exit(1);
        }
        std::printf("%s, %s: nothing allocated\n", name, space);
    });
}

/// With room for all, a broadphase finds the pairs of ever more bodies, whatever it has found before.
template <class S> void more_and_more() {
    each_policy([&](const char* name, const auto& policy) {
        using Bound = typename std::remove_cvref_t<decltype(policy)>::template In<S>;
        const auto scene = seeded_scene(4);
        const auto all = boxes_of<S>(scene);
        Bound bound(policy);
        if constexpr (requires { bound.reserve(all.size()); }) bound.reserve(all.size());
        std::size_t pairs = 0;
        for (std::size_t n = all.size() / 2; n <= all.size(); ++n) {
            auto boxes = all;
            boxes.resize(n);
            boxes.set_active(n);
            forbidden = n > all.size() / 2 + 1;
            bound.find(boxes, [&](std::size_t, std::size_t) { ++pairs; });
            forbidden = false;
        }
        if (pairs == 0) std::puts("no pairs: the case has lost its point"), std::exit(1);
        std::printf("%s, more and more: nothing allocated\n", name);
    });
}

int main() {
    ansatz::test::before_allocation = allowed;
    more_and_more<Space<>>();
    steps_of_all<Space<>>("space", 0.2, 0.2);
    steps_of_all<Space<>>("space, slowly", 0.01, 0.01);     // Coherent keeps its pairs,
    steps_of_all<Space<>>("space, then slowly", 0.3, 0.01); // or does so when nothing may be allocated any more
    steps_of_all<Space<float, 2>>("plane", 0.2, 0.2);
    steps_of_all<Space<float, 2>>("plane, then slowly", 0.3, 0.01);
}
