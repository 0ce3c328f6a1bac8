// SPDX-License-Identifier: BSL-1.0
// Every broadphase tells the pairs that two loops find (HARD_CASES G1), whatever it was asked before.
// Runs long with the sanitizers.

#include "tests/collision/broadphase/scenes.hpp"

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/broadphase/all_pairs.hpp>
#include <ansatz/collision/broadphase/binary_split.hpp>
#include <ansatz/collision/broadphase/bounding_boxes.hpp>
#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/inside.hpp>
#include <ansatz/collision/broadphase/lot.hpp>
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/collision/broadphase/recursion.hpp>
#include <ansatz/collision/broadphase/sort_and_sweep.hpp>
#include <ansatz/collision/broadphase/uniform_grid.hpp>
#include <ansatz/collision/broadphase/uniform_grid_level.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <limits>

using namespace broadphase_tests;

namespace {

/// 1000 scenes by one and the same bound policy: what it kept of one scene must not show in the next.
template <class S> void thousand_scenes() {
    std::vector<Scene> scenes;
    std::vector<Boxes<S>> boxes;
    std::vector<Pairs> right;
    std::size_t pairs = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        scenes.push_back(seeded_scene(seed));
        boxes.push_back(boxes_of<S>(scenes.back()));
        right.push_back(oracle(boxes.back()));
        pairs += right.back().size();
    }
    CHECK(pairs > 100000); // or the scenes would say nothing
    each_policy([&](const char* name, const auto& policy) {
        typename std::remove_cvref_t<decltype(policy)>::template In<S> bound(policy);
        for (std::size_t n = 0; n < scenes.size(); ++n) {
            const std::string fault = fault_of(bound, boxes[n], right[n]);
            if (!fault.empty()) FAIL_CHECK(name << ", " << scenes[n].name << ": " << fault);
        }
    });
}

/// A test of a user's own for the bodies in a cell, which hands them out backwards.
struct Backwards : BoundingBoxes {
    template <class S> class In : public BoundingBoxes::In<S> {
    public:
        explicit In(const Backwards&) : BoundingBoxes::In<S>(BoundingBoxes{}) {}
        const std::uint32_t* order(const Boxes<S>& boxes) {
            order_.resize(boxes.size());
            for (std::size_t p = 0; p < order_.size(); ++p) order_[p] = std::uint32_t(order_.size() - 1 - p);
            return order_.data();
        }

    private:
        std::vector<std::uint32_t> order_;
    };
};

} // namespace

TEST_CASE("G1: in 1000 scenes every broadphase tells each touching pair once and no other, in space", "[broadphase]") {
    thousand_scenes<Space<double, 3>>();
    thousand_scenes<Space<float, 3>>();
}

TEST_CASE("G1: in 1000 scenes every broadphase tells each touching pair once and no other, in the plane",
          "[broadphase]") {
    thousand_scenes<Space<double, 2>>();
    thousand_scenes<Space<float, 2>>();
}

TEST_CASE("AllPairs reports every pair of which one moves, and tests no box", "[broadphase]") {
    Boxes<Space<>> boxes;
    boxes.resize(9); // all at the origin
    boxes.set_active(4);
    const auto pairs = find_pairs(AllPairs{}, boxes);
    CHECK(pairs.size() == 9 * 8 / 2 - 5 * 4 / 2);
    CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
    for (const auto& [i, j] : pairs) CHECK((i < j && i < 4));
}

TEST_CASE("two that do not move are never paired", "[broadphase]") {
    Scene scene{"all in one place", std::vector<PlainBox>(60, box_around({1, 2, 3}, 1)), 7};
    CHECK(oracle(boxes_of<Space<>>(scene)).size() == 7 * 6 / 2 + 7 * 53);
    CHECK(fault_of_any<Space<>>(scene).empty());
    scene.active = 0;
    CHECK(oracle(boxes_of<Space<>>(scene)).empty());
    CHECK(fault_of_any<Space<>>(scene).empty());
}

TEST_CASE("find_pairs is sorted, and refuses what is no box and what is no parameter", "[broadphase]") {
    auto scene = seeded_scene(4);
    auto boxes = boxes_of<Space<>>(scene);
    const auto pairs = find_pairs(UniformGrid{}, boxes);
    CHECK(std::is_sorted(pairs.begin(), pairs.end()));
    CHECK(pairs == oracle(boxes));
    using ansatz::test::refusal;
    CHECK(refusal([&] { find_pairs(UniformGrid{-1.0 * metre}, boxes); }) ==
          "UniformGrid: cell is -1 m; it must be finite and not negative");
    CHECK(refusal([&] {
              find_pairs(Octree<>{0, 3, {}}, boxes);
          }) == "Octree: threshold is 0; a cell holds at least 1 body");
    CHECK(refusal([&] { find_pairs(Octree<>{1, 65, {}}, boxes); }) == "Octree: depth is 65; it is 0 to 64 divisions");
    CHECK(refusal([&] {
              find_pairs(BinarySplit<>{-3, 3, {}}, boxes);
          }) == "BinarySplit: threshold is -3; a cell holds at least 1 body");
    CHECK(refusal([&] {
              find_pairs(BinarySplit<>{3, -1, {}}, boxes);
          }) == "BinarySplit: depth is -1; it is 0 to 64 divisions");
    boxes.set(3, metres(2, 0, 0), metres(1, 1, 1));
    CHECK(refusal([&] { find_pairs(Octree{}, boxes); }) ==
          "find_pairs: box 3 on axis 0 is 2 m to 1 m; both ends are finite, and the lower is not above the upper");
}

TEST_CASE("what tests a cell may be a user's own", "[broadphase]") {
    STATIC_REQUIRE(InsideIn<Backwards, Space<>>);
    STATIC_REQUIRE(!InsideIn<AllPairs, Space<>>);
    STATIC_REQUIRE(!BroadphaseIn<Space<>, Space<>>);
    const auto boxes = boxes_of<Space<>>(seeded_scene(9));
    CHECK(find_pairs(UniformGrid<Backwards>{}, boxes) == oracle(boxes));
    CHECK(find_pairs(Octree<Backwards>{}, boxes) == oracle(boxes));
    CHECK(find_pairs(BinarySplit<Backwards>{}, boxes) == oracle(boxes));
}
