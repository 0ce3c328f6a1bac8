// SPDX-License-Identifier: BSL-1.0
// Bodies that stand still: which of them are near to one that moves, after whatever was done to them; and worlds in
// which most do, which go on as a copy does that has tested no body yet.

#include "tests/collision/support.hpp"
#include "tests/dice.hpp"

#include <ansatz/collision/response/soft_substeps.hpp>
#include <ansatz/collision/still_boxes.hpp>
#include <ansatz/world/save.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

using namespace collision_tests;
using ansatz::test::Dice;

namespace {

/// Boxes of bodies that come, go, stand still and move, and a plain list of them.
template <class S> class Crowd {
public:
    using Scalar = typename S::Scalar;
    using Corner = typename S::Position;
    static constexpr std::size_t dimension = std::size_t(S::dimension);

    Crowd(std::uint64_t seed, double scale, double far) : dice_(seed), scale_(scale), far_(far) {}
    Dice& dice() { return dice_; }

    void add() {
        const auto body = bodies_.push_back();
        for (auto& lane : places_) lane.push_back(coordinate());
        if (half_.size() <= body.id) half_.resize(body.id + 1);
        half_[body.id] = size();
        move(Bodies::Slot(bodies_.size() - 1), any_motion());
    }
    void change() { // one of what may happen between two steps, or within one
        if (bodies_.size() == 0) return add();
        const auto slot = Bodies::Slot(dice_.below(bodies_.size()));
        switch (dice_.below(6)) {
        case 0: return add();
        case 1: return move(slot, any_motion());
        case 2: places_[dice_.below(dimension)][slot] = coordinate(); return bodies_.note_change(slot);
        case 3:
            still_.forget(bodies_.id(slot));
            bodies_.erase(slot, swap());
            for (auto& lane : places_) lane.pop_back();
            return;
        case 4: // another of the same id, in the same place, but of another size
            still_.forget(bodies_.id(slot));
            half_[bodies_.id(slot)] = size();
            return;
        default: // all of them are others
            if (!dice_.one_in(20)) return;
            for (auto& half : half_) half = size();
            ++world_;
        }
    }
    void follow() {
        typename StillBoxes<S>::Places places;
        for (std::size_t k = 0; k < dimension; ++k) places[k] = places_[k].data();
        still_.follow(bodies_, world_, places,
                      [&](std::size_t slot, Corner& lower, Corner& upper) { return box(slot, lower, upper); });
        still_.begin_asking();
    }
    /// What is near to a box of any size: by what is tested, and by testing every body.
    std::pair<std::vector<std::uint32_t>, std::set<std::uint32_t>> near() {
        typename StillBoxes<S>::Raw lower, upper;
        for (int k = 0; k < S::dimension; ++k) {
            const Scalar middle = coordinate(), half = dice_.one_in(30) ? Scalar(1e4 * scale_) : size();
            lower[k] = middle - half;
            upper[k] = middle + half;
        }
        std::pair<std::vector<std::uint32_t>, std::set<std::uint32_t>> found;
        still_.each_near(lower, upper,
                         [&](std::uint32_t id, const Corner&, const Corner&) { found.first.push_back(id); });
        for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
            const auto motion = bodies_.motion(slot);
            Corner low, high;
            if ((motion != Motion::resting && motion != Motion::fixed) || !box(slot, low, high)) continue;
            bool touches = true;
            for (int k = 0; k < S::dimension; ++k)
                touches = touches && low.value()[k] <= upper[k] && lower[k] <= high.value()[k];
            if (touches) found.second.insert(bodies_.id(slot));
        }
        return found;
    }

private:
    auto swap() {
        return [this](std::size_t i, std::size_t j) {
            for (auto& lane : places_) std::swap(lane[i], lane[j]);
        };
    }
    void move(Bodies::Slot slot, Motion to) { bodies_.move(slot, to, swap()); }
    Motion any_motion() { return Motion(dice_.below(4)); }
    /// On a lattice now and then, so that faces touch.
    Scalar coordinate() {
        const double x = dice_.number(-10, 10);
        return Scalar((dice_.one_in(2) ? std::round(x) : x) * scale_ + far_);
    }
    /// Mostly about one, sometimes nothing, tiny, or larger than the place.
    Scalar size() {
        const auto kind = dice_.below(12);
        if (kind == 0) return Scalar(0);
        if (kind == 1) return Scalar(1e-3 * scale_);
        if (kind == 2) return Scalar(40 * scale_);
        if (kind == 3) return Scalar(1e30); // beyond all grids but the last
        return Scalar((dice_.one_in(2) ? 0.5 : dice_.number(0.1, 2)) * scale_);
    }
    bool box(std::size_t slot, Corner& lower, Corner& upper) const {
        const auto id = bodies_.id(slot);
        if (id % 7 == 0) return false; // a plane, or a sensor without a shape
        typename StillBoxes<S>::Raw low, high;
        for (int k = 0; k < S::dimension; ++k) {
            low[k] = places_[std::size_t(k)][slot] - half_[id];
            high[k] = places_[std::size_t(k)][slot] + half_[id];
        }
        lower = Corner::from_value(low);
        upper = Corner::from_value(high);
        return true;
    }

    Dice dice_;
    double scale_, far_;
    Bodies bodies_;
    std::array<std::vector<Scalar>, dimension> places_; // by slot
    std::vector<Scalar> half_;                          // by id
    std::uint64_t world_ = 0;
    StillBoxes<S> still_;
};

} // namespace

TEMPLATE_TEST_CASE("what stands still is found where it is near, whatever was done before", "[collision][rest]",
                   (Space<float, 3>), (Space<double, 3>), (Space<float, 2>), (Space<double, 2>)) {
    for (const double scale : {1.0, 1e-7, 1e6})
        for (const double far : {0.0, 1e5}) {
            Crowd<TestType> crowd(std::uint64_t(1 + 1000 * scale + far), scale, far * scale);
            std::size_t near = 0;
            for (int round = 0; round < 300; ++round) {
                for (auto changes = crowd.dice().below(round < 50 ? 12 : 5); changes-- > 0;) crowd.change();
                if (round < 50)
                    for (int i = 0; i < 3; ++i) crowd.add();
                crowd.follow();
                std::set<std::uint32_t> told; // no body is told of twice, however many ask
                for (int query = 0; query < 6; ++query) {
                    const auto [tested, all] = crowd.near();
                    std::set<std::uint32_t> missing = all;
                    bool new_ones = true, right = true;
                    for (const auto id : tested) {
                        new_ones = told.insert(id).second && new_ones;
                        right = right && all.contains(id);
                    }
                    for (const auto id : told) missing.erase(id);
                    near += tested.size();
                    REQUIRE((new_ones && right && missing.empty()));
                }
            }
            CHECK(near > 1000);
        }
}

namespace {

/// A hall of fixed balls, a heap that falls asleep among them, and a few that roll through it.
template <class... P> auto hall(int rolling, const P&... policies) {
    World world{policies...};
    Dice dice(3);
    world.add(Plane::ground(), fixed);
    for (int i = 0; i < 150; ++i)
        world.add(Sphere{(0.2 + 0.1 * (i % 4)) * metre}, position(metres(1.3 * (i % 15) - 10, 0.4, 1.3 * (i / 15) - 6)),
                  fixed);
    for (int i = 0; i < 40; ++i)
        world.add(Sphere{0.3 * metre}, position(metres(20 + 0.7 * (i % 8), 0.3 + 0.59 * (i / 24), 0.7 * (i / 8 % 3))),
                  mass(1.0 * kilogram));
    for (int i = 0; i < rolling; ++i) {
        const double x = dice.number(-12, 10), z = dice.number(-8, 8), u = dice.number(-5, 5), w = dice.number(-5, 5);
        world.add(Sphere{0.25 * metre}, position(metres(x, 2, z)), velocity(metres_per_second(u, 0, w)),
                  mass(1.0 * kilogram));
    }
    return world;
}
/// Whatever may happen to those that stand still.
template <class World_> void meddle(World_& world, Dice& dice) {
    const auto bodies = world.handles();
    const auto body = bodies[dice.below(bodies.size())];
    const double x = dice.number(-12, 24), z = dice.number(-8, 8), r = dice.number(0.1, 0.6);
    switch (dice.below(5)) {
    case 0: world.set_position(body, metres(x, 0.5, z)); return;
    case 1:
        if (world.motion(body) == Motion::fixed && world.position(body).value()[1] == 0) return; // the ground
        {
            const auto place = world.position(body);
            const bool was_fixed = world.motion(body) == Motion::fixed;
            world.remove(body);
            if (was_fixed) world.add(Sphere{r * metre}, position(place), fixed); // it takes the id
            else world.add(Sphere{r * metre}, position(place), mass(1.0 * kilogram));
        }
        return;
    case 2: world.add(Sphere{r * metre}, position(metres(x, 0.7, z)), fixed); return;
    case 3: world.add(Sphere{r * metre}, position(metres(x, 3, z)), mass(1.0 * kilogram)); return;
    default: world.wake(body); return;
    }
}
template <class World_> void goes_on_as_a_copy_does(World_ world) {
    Dice dice(9);
    auto another = world; // of the same ids and places, and other shapes
    for (int i = 0; i < 30; ++i) meddle(another, dice);
    std::size_t asleep = 0, met = 0;
    for (int step = 0; step < 500; ++step) {
        if (step > 200 && dice.one_in(4)) meddle(world, dice);
        if (step == 350) world = another;
        auto copy = world; // it has seen no body
        world.step(1.0 / 60 * second);
        copy.step(1.0 / 60 * second);
        REQUIRE(world.hash() == copy.hash());
        asleep = std::max(asleep, world.count(Motion::resting));
        for (const auto& contact : world.contacts()) met += world.motion(contact.first) == Motion::fixed;
    }
    CHECK(asleep > 20);
    CHECK(met > 1000);
    std::stringstream file;
    save(world, file);
    auto loaded = world;
    load(loaded, file);
    world.step(1.0 / 60 * second);
    loaded.step(1.0 / 60 * second);
    CHECK(loaded.hash() == world.hash());
}

} // namespace

TEST_CASE("a world in which most stand still goes on as a copy that has tested no body", "[collision][rest]") {
    SECTION("soft substeps") {
        goes_on_as_a_copy_does(hall(12, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{},
                                    SoftSubsteps<>{}, Rest{}));
    }
    SECTION("impulses, by another broadphase") {
        goes_on_as_a_copy_does(hall(12, SemiImplicitEuler{}, Gravity{}, SortAndSweep{}, Narrowphase<Sphere, Plane>{},
                                    Impulse{}, Projection{}, Rest{}));
    }
    SECTION("where now and then nobody moves at all") {
        World world = hall(0, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{},
                           SoftSubsteps<>{}, Rest{});
        Dice dice(6);
        int still = 0;
        for (int step = 0; step < 2500; ++step) {
            if (step > 200 && dice.one_in(150)) world.wake(world.handles()[160 + dice.below(20)]);
            if (step > 200 && dice.one_in(300)) world.remove(world.handles()[160 + dice.below(20)]);
            if (step > 200 && dice.one_in(300)) world.set_position(world.handles()[40], metres(20, 5 - 0.01 * step, 0));
            auto copy = world;
            world.step(1.0 / 60 * second);
            copy.step(1.0 / 60 * second);
            REQUIRE(world.hash() == copy.hash());
            REQUIRE(world.contacts().size() == copy.contacts().size());
            still += world.count(Motion::awake) == 0;
        }
        CHECK(still > 500);
        CHECK(still < 2300);
    }
    SECTION("nobody rests") {
        World world = hall(12, Verlet{}, Gravity{}, AllPairs{}, Narrowphase<Sphere, Plane>{}, Impulse{}, Projection{});
        Dice dice(4);
        for (int step = 0; step < 200; ++step) {
            auto copy = world;
            world.step(1.0 / 60 * second);
            copy.step(1.0 / 60 * second);
            REQUIRE(world.hash() == copy.hash());
        }
    }
}

namespace {
template <class World_> double radius_of(const World_& world, Handle body) {
    double radius = 0;
    world.visit_shape(body, [&](const auto& shape) {
        if constexpr (requires { shape.radius; }) radius = shape.radius.value();
    });
    return radius;
}
} // namespace

TEST_CASE("where most stand still, contacts of bodies that are awake are those of all pairs", "[collision][rest]") {
    // Impulses alone move no body behind the search, so that the places after a step are those that were tested.
    World world = hall(12, SemiImplicitEuler{}, Gravity{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, Impulse{},
                       Rest{1.0 * metre_per_second, 0.1 * second, 20.0 * metre_per_second_squared});
    Dice dice(8);
    std::size_t touching = 0, asleep = 0;
    for (int step = 0; step < 400; ++step) {
        if (dice.one_in(3)) meddle(world, dice);
        std::set<std::uint32_t> awake; // before the step and behind it: no matter what wakes or falls asleep meanwhile
        for (const auto body : world.handles())
            if (world.motion(body) == Motion::awake) awake.insert(body.id);
        world.step(1.0 / 60 * second);
        const auto bodies = world.handles();
        for (const auto body : bodies)
            if (world.motion(body) != Motion::awake) awake.erase(body.id);
        std::set<std::pair<std::uint32_t, std::uint32_t>> expected, found;
        for (const auto a : bodies)
            for (const auto b : bodies) {
                if (!(a.id < b.id) || (!awake.contains(a.id) && !awake.contains(b.id))) continue;
                if (a.id == 0) { // the ground
                    if (world.position(b).value()[1] < radius_of(world, b)) expected.insert({a.id, b.id});
                    continue;
                }
                const double apart = norm(world.position(a) - world.position(b)).value();
                if (apart < radius_of(world, a) + radius_of(world, b)) expected.insert({a.id, b.id});
            }
        for (const auto& contact : world.contacts())
            if (awake.contains(contact.first.id) || awake.contains(contact.second.id))
                found.insert({contact.first.id, contact.second.id});
        REQUIRE(found == expected);
        touching += found.size();
        asleep = std::max(asleep, world.count(Motion::resting));
    }
    CHECK(touching > 1000);
    CHECK(asleep > 10);
}

TEST_CASE("a world that is assigned has its own shapes, where the bodies of both are in the same places",
          "[collision][rest]") {
    const auto level = [](double radius) {
        World world{SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, Impulse{}};
        for (int i = 0; i < 100; ++i) world.add(Sphere{radius * metre}, position(metres(2 * i, 0, 0)), fixed);
        world.add(Sphere{0.5 * metre}, position(metres(60, 1, 0)), mass(1.0 * kilogram));
        return world;
    };
    auto world = level(0.2);
    const auto wide = level(0.6);
    world.step(0.01 * second);
    REQUIRE(world.contacts().empty());
    world = wide;
    world.step(0.01 * second);
    CHECK(world.contacts().size() == 1);
    world = level(0.2); // moved
    world.step(0.01 * second);
    CHECK(world.contacts().empty());
}

TEST_CASE("a plane that moves meets those that stand still", "[collision][rest]") {
    World world{SemiImplicitEuler{}, UniformGrid{}, Narrowphase<Sphere, Plane>{}, Impulse{}, Rest{}};
    world.add(Plane::ground(), velocity(metres_per_second(0, 1, 0)), moving);
    for (int i = 0; i < 100; ++i)
        world.add(Sphere{0.5 * metre}, position(metres(2 * i, 1, 0)), mass(1.0 * kilogram), resting);
    std::size_t most = 0;
    for (int i = 0; i < 50; ++i) {
        world.step(0.02 * second);
        most = std::max(most, world.contacts().size());
    }
    CHECK(most == 100);
    CHECK(world.count(Motion::resting) == 0);
}

namespace {
/// Lifts the body of id 0 by 3.1 m in each step.
struct Lift_ {
    using role = roles::System;
    static constexpr std::string_view name = "Lift_";
    template <class S> struct Raise {
        using writes = Columns<Position>;
        static constexpr Phase phase = phases::begin;
        static constexpr std::string_view name = "lift";
        explicit Raise(const Lift_&) {}
        void run(auto& view, const auto&) const {
            const auto slot = view.slot_of_id(0);
            view.template set<Position>(slot, view.template get<Position>(slot) + metres(0, 3.1, 0));
        }
    };
    template <class S> using systems = Types<Raise<S>>;
};
} // namespace

TEST_CASE("a fixed body that a system puts somewhere else is met there", "[collision][rest]") {
    auto world = world_of(SemiImplicitEuler{}, Rest{}, SoftSubsteps<>{}, Lift_{});
    using S = Space<>;
    for (int i = 0; i < 100; ++i) world.add(Box{metres(0.4, 0.4, 0.4)}, at<S>(i, 0), fixed);
    const auto ball =
        world.add(Sphere{0.5 * metre}, at<S>(0, 10), velocity(metres_per_second(0.2, 0, 0)), mass(1.0 * kilogram));
    run(world, 2, 1.0 / 60);
    CHECK(world.contacts().empty());
    run(world, 1, 1.0 / 60);
    REQUIRE(world.contacts().size() == 1);
    CHECK(world.contacts()[0].second == ball);
}
