// SPDX-License-Identifier: BSL-1.0
// Lanes, rows and the one loop, used by themselves as an entity system would.

#include <ansatz/world/lanes.hpp>
#include <ansatz/world/row.hpp>

#include "tests/catch.hpp"
#include "tests/world/worlds.hpp"

#include <array>
#include <cstdint>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;

namespace {
using S = Space<float, 2>;
using List = Columns<Position, Heat, Velocity>;

/// Falls for a step and warms up by what it had before; writes position and heat only.
struct Fall {
    template <class R> void operator()(R& row, std::size_t index) const {
        row.template get<Position>() += row.template get<Velocity>() * S::Time::from_value(0.5f);
        row.template get<Heat>() += S::Energy::from_value(float(index));
        row.template get<Velocity>() =
            S::zero_vector<unit::Velocity>();                    // not among what is written: must not reach its lane
        row.template get<Home>() = row.template get<Position>(); // a local of the row
    }
};
} // namespace

TEST_CASE("for_lanes loads what is listed, calls, and stores only what is written, on anybody's lanes",
          "[world][lanes]") {
    std::vector<float> x(7, 1.0f), y(7, 2.0f), heat(7, 10.0f), vx(7, 4.0f), vy(7, -4.0f);
    const std::array<float*, 5> lanes{x.data(), y.data(), heat.data(), vx.data(), vy.data()};
    for_lanes<S, List, Columns<Position, Heat>, Columns<Home>>(lanes, 2, 5, Fall{});
    for (std::size_t i = 0; i < 7; ++i) {
        const bool inside = i >= 2 && i < 5;
        CHECK(x[i] == (inside ? 3.0f : 1.0f));
        CHECK(y[i] == (inside ? 0.0f : 2.0f));
        CHECK(heat[i] == (inside ? 10.0f + float(i) : 10.0f));
        CHECK(vx[i] == 4.0f);
        CHECK(vy[i] == -4.0f);
    }
    for_lanes<S, List, Columns<Position, Heat>, Columns<Home>>(lanes, 3, 3, Fall{}); // an empty range
    CHECK(x[3] == 3.0f);
}

TEMPLATE_TEST_CASE("lanes keep their bodies while they grow, shrink, swap and are copied", "[world][lanes]", float,
                   double) {
    using Sp = Space<TestType, 3>;
    Lanes<Sp, List> lanes;
    CHECK(lanes.width == 7);
    CHECK(lanes.bytes_per_body == 7 * sizeof(TestType));
    const int n = 3000; // through several growths, and past a page
    auto put = [&](std::size_t i, int number) {
        lanes.template set<Heat>(i, Quantity<unit::Energy, TestType>::from_value(TestType(number)));
        lanes.template set<Velocity>(i, scalar_cast<TestType>(metres_per_second(number, -number, 2 * number)));
    };
    auto is = [](const auto& in, std::size_t i, int number) {
        return in.template get<Heat>(i).value() == TestType(number) &&
               in.template get<Velocity>(i) == scalar_cast<TestType>(metres_per_second(number, -number, 2 * number)) &&
               in.template get<Position>(i) == scalar_cast<TestType>(metres(0, 0, 0));
    };
    for (int i = 0; i < n; ++i) {
        lanes.push_back();
        REQUIRE(is(lanes, std::size_t(i), 0)); // a new body is zero in every column, also where another was removed
        put(std::size_t(i), i);
        if (i % 3 == 2) {
            lanes.pop_back();
            lanes.push_back();
            REQUIRE(is(lanes, std::size_t(i), 0));
            put(std::size_t(i), i);
        }
    }
    CHECK(lanes.size() == std::size_t(n));
    lanes.swap(5, 2999);
    lanes.swap(7, 7);
    CHECK(is(lanes, 5, 2999));
    CHECK(is(lanes, 2999, 5));
    CHECK(is(lanes, 7, 7));
    const auto copy = lanes;
    put(5, -1);
    CHECK(is(copy, 5, 2999));
    Lanes<Sp, List> small;
    small.push_back();
    small = copy; // grows
    CHECK(is(small, 1234, 1234));
    const auto* const block = small.lane_at(0);
    small = copy; // fits: stays where it is
    CHECK(small.lane_at(0) == block);
    auto moved = std::move(small);
    CHECK(is(moved, 1234, 1234));
    CHECK(moved.size() == std::size_t(n));
    moved.clear();
    CHECK(moved.size() == 0);
}

TEST_CASE("lanes begin on cache lines and do not overlap", "[world][lanes]") {
    Lanes<Space<float, 3>, List> lanes;
    for (const std::size_t n : {1u, 100u, 1000u, 1024u, 5000u}) {
        lanes.reserve(n);
        for (std::size_t k = 0; k < lanes.width; ++k)
            CHECK(reinterpret_cast<std::uintptr_t>(lanes.lane_at(k)) % 64 == 0);
        CHECK(lanes.lane_at(1) - lanes.lane_at(0) >= std::ptrdiff_t(n));
        CHECK(lanes.lane<Velocity>(1) == lanes.lane_at(5));
        const auto pointers = lanes.pointers(Columns<Velocity, Position>{});
        const std::size_t expected[] = {4, 5, 6, 0, 1, 2};
        for (std::size_t k = 0; k < 6; ++k) CHECK(pointers[k] == lanes.lane_at(expected[k]));
    }
}

// ---------------------------------------------------------------- row.hpp, columns.hpp
static_assert(detail::lane_count(List{}, 2) == 5 && detail::lane_count(List{}, 3) == 7 &&
              detail::lane_count(Columns<>{}, 3) == 0);
static_assert(detail::offset_in<Position>(List{}, 3) == 0 && detail::offset_in<Heat>(List{}, 3) == 3 &&
              detail::offset_in<Velocity>(List{}, 2) == 3);
static_assert(std::same_as<decltype(std::declval<Row<S, List>&>().get<Heat>()), Quantity<unit::Energy, float>&>);
static_assert(std::same_as<decltype(std::declval<const Row<S, List>&>().get<Position>()), const S::Position&>);
