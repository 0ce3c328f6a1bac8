// SPDX-License-Identifier: BSL-1.0
// A broadphase finds pairs of boxes that may touch.

#include <algorithm>
#include <ansatz/collision.hpp>
#include <ansatz/world.hpp>
#include <vector>

using namespace ansatz;

//! [model]
/// Boxes by their lower corners along the first axis: as far as one reaches, it is compared with those behind it.
struct Sorted {
    using role = roles::Broadphase;

    template <class S> struct In {
        std::vector<std::size_t> order;
        explicit In(const Sorted&) {}
        void find(const Boxes<S>& boxes, auto&& found) {
            order.resize(boxes.size());
            for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
            const auto* lower = boxes.lower(0);
            std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return lower[i] < lower[j]; });
            for (std::size_t n = 0; n < order.size(); ++n)
                for (std::size_t m = n + 1; m < order.size() && lower[order[m]] <= boxes.upper(0)[order[n]]; ++m)
                    if (boxes.touch(order[n], order[m])) found(order[n], order[m]);
        }
    };
};
//! [model]

int main() {
    const auto fall = [](auto broadphase) {
        World world{SemiImplicitEuler{}, Gravity{}, broadphase, Narrowphase<Sphere, Plane>{}, SoftSubsteps{}};
        world.add(Plane::ground(), fixed);
        for (int i = 0; i < 30; ++i)
            world.add(Sphere{0.5 * metre}, position(metres(0.7 * (i % 5), 1 + i, 0.1 * i)), mass(1.0 * kilogram));
        for (int i = 0; i < 200; ++i) world.step(1.0 / 60 * second);
        return world.hash();
    };
    return fall(Sorted{}) == fall(AllPairs{}) ? 0 : 1; // to the bit: which pairs, not in which order, is its job
}
