// SPDX-License-Identifier: BSL-1.0
// The open lists by themselves, beside a plain list that is searched through.

#include <ansatz/paths/buckets.hpp>
#include <ansatz/paths/heap.hpp>

#include "tests/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

using namespace ansatz::paths;

namespace {

struct NoGraph {};

/// f and h anywhere in the number, or few of them, so that many are equal.
template <class Cost> std::pair<Cost, Cost> random_entry(std::mt19937& random, bool few) {
    const auto any = [&] {
        const std::uint64_t bits = std::uint64_t(random()) << 32 | random();
        if (few) return Cost(bits % 7);
        if constexpr (std::is_integral_v<Cost>)
            return Cost(bits & std::uint64_t(std::numeric_limits<Cost>::max())); // none is negative
        else return Cost(bits) * Cost(1e-9);
    };
    const Cost f = any(), h = any();
    return {f, h};
}

} // namespace

TEMPLATE_TEST_CASE("a heap hands out the least f, and of equal ones the least h", "[paths]", std::uint8_t,
                   std::uint16_t, std::uint32_t, std::uint64_t, std::int16_t, int, std::int64_t, float, double) {
    using Cost = TestType;
    std::mt19937 random(1);
    typename Heap::In<Cost, int> heap{Heap{}};
    for (const bool few : {false, true})
        for (const std::size_t longest : {3u, 60u, 800u}) { // short lists of fractions are searched another way
            heap.begin(NoGraph{});
            CHECK(heap.empty());
            std::vector<std::pair<Cost, Cost>> given; // of each vertex
            std::vector<int> model;                   // the vertices that are in
            std::size_t wrong = 0;
            for (int turn = 0; turn < 6000; ++turn) {
                const bool grows = turn / 1000 % 2 == 0;
                if (model.empty() || (model.size() < longest && random() % 8 < (grows ? 6u : 2u))) {
                    given.push_back(random_entry<Cost>(random, few));
                    const auto [f, h] = given.back();
                    model.push_back(int(given.size()) - 1);
                    heap.push(f, h, model.back());
                    continue;
                }
                const auto less = [&](int a, int b) { return given[std::size_t(a)] < given[std::size_t(b)]; };
                const auto least = *std::min_element(model.begin(), model.end(), less);
                wrong += !(heap.least_f() == given[std::size_t(least)].first);
                const int next = *heap.peek(), popped = heap.pop();
                wrong += next != popped;
                wrong += given[std::size_t(popped)] != given[std::size_t(least)];
                const auto at = std::find(model.begin(), model.end(), popped);
                REQUIRE(at != model.end());
                model.erase(at);
            }
            CHECK(wrong == 0);
            std::vector<int> left;
            heap.each([&](int v) { left.push_back(v); });
            std::sort(left.begin(), left.end()), std::sort(model.begin(), model.end());
            CHECK(left == model);
        }
}

TEMPLATE_TEST_CASE("buckets hand out the least f but for a bucket's width, up to the end of the number", "[paths]",
                   std::uint8_t, std::uint32_t, std::uint64_t, int, std::int64_t, float, double) {
    using Cost = TestType;
    std::mt19937 random(2);
    const Cost most = std::is_integral_v<Cost> ? std::numeric_limits<Cost>::max() : Cost(1e30);
    for (const double width : {1.0, 16.0}) {
        typename Buckets::In<Cost, int> buckets{Buckets{width}};
        buckets.begin(NoGraph{});
        buckets.start(Cost(0), Cost(0), 0);
        for (const int n : {1, 2}) buckets.push(most, Cost(0), n); // at the very end, far behind the ring
        CHECK(buckets.pop() == 0);
        CHECK(buckets.pop() + buckets.pop() == 3);
        CHECK(buckets.empty());
        for (const Cost first : {Cost(0), Cost(most / 2), Cost(most - most / 64)}) {
            buckets.begin(NoGraph{});
            std::vector<Cost> given;
            std::vector<int> model;
            Cost base = first; // as in a search, no f is less than the one that came out last
            std::size_t wrong = 0;
            for (int turn = 0; turn < 3000; ++turn) {
                if (model.empty() || random() % 2 == 0) {
                    const Cost room = most - base;
                    const Cost more = std::is_integral_v<Cost> ? Cost(random() % 300) : Cost(random() % 4096) / 16;
                    given.push_back(base + (random() % 8 == 0 ? Cost(room / 2) : std::min(room, more)));
                    model.push_back(int(given.size()) - 1);
                    if (given.size() == 1) buckets.start(given.back(), Cost(0), 0);
                    else buckets.push(given.back(), Cost(0), model.back());
                    continue;
                }
                Cost least = most;
                for (const int v : model) least = std::min(least, given[std::size_t(v)]);
                wrong += buckets.least_f() > least;
                const int popped = buckets.pop();
                const auto at = std::find(model.begin(), model.end(), popped);
                REQUIRE(at != model.end());
                model.erase(at);
                const Cost f = given[std::size_t(popped)];
                const bool in_order = double(least) < 1e15 || sizeof(Cost) < 8; // beyond, all share the last bucket
                if (in_order && std::is_integral_v<Cost>) wrong += double(f) - double(least) >= width;
                base = std::max(base, least);
            }
            CHECK(wrong == 0);
            while (!model.empty()) {
                const auto at = std::find(model.begin(), model.end(), buckets.pop());
                REQUIRE(at != model.end());
                model.erase(at);
            }
            CHECK(buckets.empty());
        }
    }
}
