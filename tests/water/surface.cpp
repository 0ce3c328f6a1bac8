// SPDX-License-Identifier: BSL-1.0
// A body of water as a value: its copies, its level between columns, and what it refuses.

#include <ansatz/water/clamped_columns.hpp>
#include <ansatz/water/pipes.hpp>
#include <ansatz/water/pool.hpp>
#include <ansatz/water/shallow_water.hpp>
#include <ansatz/water/surface.hpp>
#include <ansatz/water/water_columns.hpp>

#include "tests/water/support.hpp"

using namespace water_tests;

namespace {

/// A policy of one's own that keeps as much as it likes: nothing moves.
struct ManyLanes {
    static constexpr std::string_view name = "ManyLanes";
    static constexpr bool has_bed = false;
    void check() const {}
    static void fields(auto&, auto&&) {}
    template <class Scalar> struct State {
        std::vector<Scalar> height;
        std::array<std::vector<Scalar>, 20> lanes;
        std::array<double, 20> numbers{};
        static void fields(auto& self, auto&& field) {
            field("height", self.height);
            for (auto& lane : self.lanes) field("lane", lane);
            for (auto& number : self.numbers) field("number", number);
        }
    };
    template <class Scalar> struct In {
        In(const ManyLanes&, const ColumnGrid&, Length) {}
        void prepare(State<Scalar>& state, Length) const {
            for (auto& lane : state.lanes) lane.assign(state.height.size(), Scalar(0));
        }
        Quantity<unit::Time> longest_step(const State<Scalar>&) const { return 1.0 * second; }
        void advance(State<Scalar>&, Quantity<unit::Time>) const {}
    };
};

} // namespace

TEST_CASE("a policy keeps any number of lanes and numbers", "[water]") {
    const ColumnGrid grid(3, 3, 1.0 * metre);
    auto state = Surface(ManyLanes{}, grid, 1.0 * metre).state();
    for (std::size_t k = 0; k < 20; ++k) {
        state.lanes[k].assign(9, 0.5 * double(k));
        state.numbers[k] = 0.25 * double(k);
    }
    const Surface wide(ManyLanes{}, grid, 1.0 * metre, state);
    CHECK(wide.state().lanes == state.lanes);
    CHECK(wide.state().numbers == state.numbers);
    const Surface<ManyLanes, float> narrow(ManyLanes{}, grid, 1.0 * metre, state);
    CHECK(narrow.state().lanes[19] == std::vector<float>(9, 9.5f));
    CHECK(narrow.state().numbers == state.numbers);
    auto row = detail::PoolRow<ManyLanes, double>::from(0, Pool<ManyLanes>{wide});
    CHECK_NOTHROW(row.check());
    detail::SurfaceLanes::of(*row.surface).lanes[19].pop_back();
    CHECK(refusal([&] { row.check(); }) == "Pool: the number of lane is 8; there is one for each of the 9 columns");
}

TEST_CASE("a copy of water is a snapshot, and goes on bit for bit", "[water]") {
    Surface water(WaterColumns{.wave_speed = 2.0 * mps, .damping = 0.1 / second}, unequal(6, 5), 1.0 * metre);
    set_heights(water, [](double x, double z) { return 1 + 0.2 * std::sin(x + 2 * z); });
    for (int n = 0; n < 20; ++n) water.step(0.1 * second);
    auto copy = water;
    for (int n = 0; n < 20; ++n) water.step(0.1 * second);
    CHECK_FALSE(copy.state() == water.state());
    for (int n = 0; n < 20; ++n) copy.step(0.1 * second);
    CHECK(copy.state() == water.state());
}

TEMPLATE_TEST_CASE("the level goes through the centres, is linear between them and level beside walls", "[water]",
                   float, double) {
    const auto grid = unequal(6, 5).at(4.0 * metre, -2.0 * metre);
    Surface<WaterColumns, TestType> water({2.0 * mps}, grid, 3.0 * metre);
    set_heights(water, [](double x, double z) { return 3 + 0.1 * x - 0.2 * z; });
    const double near = 32 * std::numeric_limits<TestType>::epsilon();
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(double(water.level(grid.centre_x(i), grid.centre_z(2)).value()) ==
              Approx(double(water.height(i, 2).value())).epsilon(near));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(grid.centre_x(0).value(), grid.centre_x(5).value()),
        z(grid.centre_z(0).value(), grid.centre_z(4).value());
    const Vector<double, 3> up = Vector<double, 3>(-0.1, 1, 0.2).normalized();
    for (int n = 0; n < 300; ++n) {
        const double at_x = x(random), at_z = z(random);
        CHECK(double(water.level(at_x * metre, at_z * metre).value()) ==
              Approx(3 + 0.1 * at_x - 0.2 * at_z).epsilon(near));
        CHECK((water.normal(at_x * metre, at_z * metre).template cast<double>() - up).norm() < 50 * near);
    }
    CHECK(water.level(grid.begin_x(), grid.begin_z()) == water.height(0, 0));
    CHECK(water.level(grid.end_x(), grid.end_z()) == water.height(5, 4));
    CHECK(water.normal(grid.begin_x(), grid.begin_z()) == Vector<TestType, 3>(0, 1, 0));
}

TEST_CASE("its map of heights is its surface; where there are no columns there is no water", "[water]") {
    Surface water(WaterColumns{mps}, ColumnGrid(5, 4, 0.5 * metre, 2.0 * metre).at(1.0 * metre, 1.0 * metre),
                  1.0 * metre);
    set_heights(water, [](double x, double z) { return 1 + 0.3 * std::sin(2 * x) * std::cos(z); });
    const auto map = water.height_map();
    for (const double x : {1.3, 2.0, 3.2})
        for (const double z : {2.0, 5.5, 7.9})
            CHECK(map.height(x * metre, z * metre).value() ==
                  Approx(water.level(x * metre, z * metre).value()).epsilon(1e-13));
    CHECK_FALSE(water.covers(0.5 * metre, 2.0 * metre));
    CHECK(sentence<std::out_of_range>([&] { (void)water.level(0.5 * metre, 2.0 * metre); }) ==
          "Surface::level: (x, z) is (0.5 m, 2 m); the columns cover x from 1 m to 3.5 m and z from 1 m to 9 m");
}

TEST_CASE("what water cannot be is refused, and nothing is changed", "[water]") {
    const ColumnGrid grid(3, 3, 1.0 * metre);
    Surface water(WaterColumns{mps}, grid, 1.0 * metre);
    const auto before = water.state();
    CHECK(refusal([&] { water.set_height(1, 2, -0.5 * metre); }) ==
          "Surface::set_height: the height at column (1, 2) is -0.5 m; it must be finite and not negative");
    CHECK(refusal([&] { water.set_height(0, 0, not_a_number * metre); }) ==
          "Surface::set_height: the height at column (0, 0) is nan m; it must be finite and not negative");
    std::vector<double> heights(9, 2.0);
    heights[8] = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] { water.set_heights(heights); }) ==
          "Surface::set_heights: the height at column (2, 2) is inf m; it must be finite and not negative");
    heights.pop_back();
    CHECK(refusal([&] { water.set_heights(heights); }) ==
          "Surface::set_heights: the number of heights is 8; there is one for each of the 9 columns");
    CHECK(sentence<std::out_of_range>([&] { (void)water.height(3, 0); }) ==
          "Surface: a column is (3, 0); there are 3 x 3, counted from 0");
    for (const double dt : {0.0, -1.0, not_a_number})
        CHECK(refusal([&] { water.step(dt * second); }).find("Surface::step: dt is ") == 0);
    CHECK(water.state() == before);
    CHECK(refusal([&] { Surface(WaterColumns{mps}, grid, -1.0 * metre); }) ==
          "Surface: level is -1 m; it must be finite and not negative");
    CHECK(refusal([&] { Surface(WaterColumns{0.0 * mps}, grid, 1.0 * metre); }) ==
          "WaterColumns: wave_speed is 0 m/s; it must be finite and greater than zero");
    CHECK(refusal([&] {
              Surface(WaterColumns{mps, -1.0 / second}, grid, 1.0 * metre);
          }) == "WaterColumns: damping is -1 1/s; it must be finite and not negative");
    CHECK(refusal([&] { Surface<WaterColumns, float>(WaterColumns{mps}, grid, 1e300 * metre); }) ==
          "Surface: level, in its scalar, is inf m; it must be finite");
    const std::vector<float> deep(9, -3e38f);
    CHECK(refusal([&] {
              Surface(Pipes{}, grid, std::span<const float>(deep), 3e38 * metre);
          }).find("the height of the water over it") != std::string::npos);
    CHECK(refusal([&] {
              (void)Surface(WaterColumns{mps}, unequal(3, 3), 1.0 * metre).height_map();
          }).find("unequal footprints") != std::string::npos);
}

TEST_CASE("it goes on from no state that water cannot have", "[water]") {
    const ColumnGrid grid(4, 3, 1.0 * metre);
    const auto bad = [&]<class Policy>(const Policy& policy, auto&& spoil) {
        auto state = Surface(policy, grid, 1.0 * metre).state();
        spoil(state);
        return refusal([&] { Surface(policy, grid, 1.0 * metre, state); });
    };
    CHECK(bad(WaterColumns{mps}, [](auto& s) { s.height[5] = not_a_number; }) ==
          "Surface: height at column (1, 1) is nan; it must be finite, in the scalar of this water");
    CHECK(bad(WaterColumns{mps}, [](auto& s) { s.rate[0] = HUGE_VAL; }).find("rate at column (0, 0) is inf") !=
          std::string::npos);
    CHECK(bad(Pipes{}, [](auto& s) { s.height[11] = -1; }) ==
          "Surface: the height at column (3, 2) is -1 m; it must be finite and not negative");
    CHECK(bad(Pipes{}, [](auto& s) { s.flow_z[2] = not_a_number; }).find("flow_z") != std::string::npos);
    CHECK(bad(ClampedColumns{{mps}, {0.5 * metre, 2.0 * metre}}, [](auto& s) { s.cut_off = not_a_number; }) ==
          "Surface: cut_off is nan; it must be finite");
    // Columns that pull at each other know no ground: such a state is one of theirs.
    CHECK(bad(WaterColumns{mps}, [](auto& s) { s.height[5] = -1; }) == "nothing");
    auto high = Surface(WaterColumns{mps}, grid, 1.0 * metre).state();
    high.height[0] = 1e300;
    CHECK(refusal([&] {
              Surface<WaterColumns, float>(WaterColumns{mps}, grid, 1.0 * metre, high);
          }).find("is inf; it must be finite, in the scalar of this water") != std::string::npos);
}

TEST_CASE("it goes on from the state of no other policy", "[water]") {
    const ColumnGrid grid(4, 3, 1.0 * metre);
    const WaterColumns columns{mps};
    const auto from = [&](const auto& state, const auto& to) {
        return refusal([&] { Surface(to, grid, 1.0 * metre, state); });
    };
    const auto rates = Surface(columns, grid, 1.0 * metre).state();
    const auto flows = Surface(Pipes{}, grid, 1.0 * metre).state();
    const auto momenta = Surface(ShallowWater{}, grid, 1.0 * metre).state();
    CHECK(from(rates, Pipes{}) == "Surface: lane 1 of the state is rate; a state of Pipes has bed there; give it one "
                                  "of its own, or begin anew and set_heights");
    CHECK(from(flows, columns).find("lane 1 of the state is bed; a state of WaterColumns has rate there") !=
          std::string::npos);
    CHECK(from(momenta, Pipes{}).find("lane 2 of the state is momentum_x; a state of Pipes has flow_x there") !=
          std::string::npos); // as many lanes, of another meaning
    CHECK(from(flows, ShallowWater{}).find("lane 2 of the state is flow_x") != std::string::npos);
    CHECK(from(rates, ClampedColumns{columns, {0.5 * metre, 2.0 * metre}})
              .find("number 1 of the state is missing; a state of ClampedColumns has cut_off there") !=
          std::string::npos);
    // What has all that is kept may have more.
    CHECK(from(Surface(ClampedColumns{columns, {0.5 * metre, 2.0 * metre}}, grid, 1.0 * metre).state(), columns) ==
          "nothing");
}

TEST_CASE("no step makes numbers of dry ground that are none", "[water]") {
    Surface<Pipes, float> dry(Pipes{}, ColumnGrid(3, 3, 1.0 * metre), 0.0 * metre);
    CHECK(std::isinf(dry.longest_step().value()));
    CHECK(refusal([&] { dry.step(1e39 * second); }) == "Surface::step: dt, in its scalar, is inf s; it must be finite");
    dry.step(1e30 * second);
    for (const float h : dry.heights()) CHECK(h == 0);
}
