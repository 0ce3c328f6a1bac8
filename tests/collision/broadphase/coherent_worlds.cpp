// SPDX-License-Identifier: BSL-1.0
// Coherent in a world: the same bits as with any other broadphase.
// Compiles like 25 kB: it has four worlds.

#include <ansatz/world.hpp> // first: no name of it may hide what a broadphase calls

#include "tests/collision/broadphase/scenes.hpp"
#include "tests/collision/support.hpp"

#include <ansatz/collision/broadphase/binary_split.hpp>
#include <ansatz/collision/broadphase/coherent.hpp>
#include <ansatz/collision/broadphase/octree.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world/save.hpp>
#include <ansatz/world/save_parameters.hpp>

#include "tests/catch.hpp"

#include <sstream>

using namespace ansatz;
using broadphase_tests::Random;

namespace {

/// Coherent, which counts in how many searches of a world it kept pairs.
struct Counted : Coherent<> {
    static constexpr std::string_view name = "Counted";
    static inline int searches = 0, kept = 0;
    template <class S> struct In : Coherent<>::In<S> {
        explicit In(const Counted& counted) : Coherent<>::In<S>(counted) {}
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            Coherent<>::In<S>::find(boxes, found);
            ++searches, kept += this->keeps();
        }
    };
};

/// Balls that fall into a heap, of which some fall asleep.
template <class World_> World_ heap(World_ world) {
    Random random(11);
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 150; ++i) {
        const double x = random.uniform(-2, 2), y = random.uniform(0.5, 12), z = random.uniform(-2, 2);
        world.add(Sphere{0.4 * metre}, position(metres(x, y, z)), mass(1.0 * kilogram));
    }
    return world;
}
template <class Broadphase> auto with(const Broadphase& broadphase) {
    return heap(
        World{SemiImplicitEuler{}, Gravity{}, Rest{}, broadphase, Narrowphase<Sphere, Plane>{}, SoftSubsteps<>{}});
}
template <class Broadphase> auto in_pieces(const Broadphase& broadphase) {
    return heap(
        World{SemiImplicitEuler{}, Gravity{}, broadphase, Narrowphase<Sphere, Plane>{}, Impulse<>{}, Projection{}});
}

} // namespace

TEST_CASE("a world has the same bits with Coherent and without, copied and loaded", "[broadphase][coherent]") {
    auto beside = [](auto plain, auto kept) {
        const auto other = kept;
        std::size_t contacts = 0;
        for (int i = 0; i < 400; ++i) {
            plain.step(1.0 / 60 * second);
            kept.step(1.0 / 60 * second);
            REQUIRE(plain.hash() == kept.hash());
            contacts += kept.contacts().size();
            if (i % 90 == 45) { // its memory of pairs stays behind
                const auto copy = kept;
                std::stringstream file;
                save(copy, file);
                auto loaded = other;
                load(loaded, file);
                kept = loaded;
                REQUIRE(plain.hash() == kept.hash());
            }
        }
        CHECK(contacts > 10000);
    };
    beside(with(UniformGrid{}), with(Coherent{UniformGrid{1.5 * metre}}));
    beside(with(Octree{}), with(Counted{}));
    CHECK(Counted::kept > Counted::searches * 3 / 4);
    Counted::kept = Counted::searches = 0;
    beside(in_pieces(SortAndSweep{}), in_pieces(Counted{}));
    CHECK(Counted::kept > Counted::searches * 3 / 4);
    beside(in_pieces(AllPairs{}), in_pieces(Coherent<SortAndSweep>{}));
}

TEST_CASE("every broadphase tells whoever asks, also one that asks for Coherent, behind <ansatz/world.hpp>",
          "[broadphase][coherent]") {
    Boxes<Space<>> boxes;
    for (const double x : {0.0, 0.5, 3.0}) boxes.push_back(metres(x, 0, 0), metres(x + 1, 1, 1));
    boxes.set_active(boxes.size());
    auto told = [&]<class Broadphase>(const Broadphase& broadphase) {
        typename Broadphase::template In<Space<>> finder(broadphase);
        std::size_t pairs = 0;
        finder.find(boxes, [&](std::size_t i, std::size_t j) { pairs += std::size_t(i == 0 && j == 1); });
        return pairs;
    };
    CHECK(told(UniformGrid{}) == 1);
    CHECK(told(SortAndSweep{}) == 1);
    CHECK(told(Octree{}) == 1);
    CHECK(told(BinarySplit{}) == 1);
    CHECK(told(Coherent{Octree{}}) == 1);
    CHECK(told(Coherent{BinarySplit{}}) == 1);
}
