// SPDX-License-Identifier: BSL-1.0

// The harness as a chapter uses it: cases in, rows, table, JSON and pictures out.

#include "tests/catch.hpp"
#include "tests/scratch.hpp"

#include "tools/costs.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

using namespace ansatz::workbook;

namespace {

struct Folder {
    std::filesystem::path path = ansatz::test::scratch_path("costs");
    ~Folder() { std::filesystem::remove_all(path); }
};

// Work that takes a time in proportion to `loops` and that no compiler can foresee.
double spin(int loops) {
    double x = 0.5;
    for (int i = 0; i < loops; ++i) x = 3.9 * x * (1 - x);
    return x;
}

const Axis integrator{
    .name = "integrator", .error_norm = "max |x - exact| (m)", .work_unit = "steps", .time_unit = "ns per step"};

// A made-up second-order method on a ladder whose coarsest step diverges.
void add_ladder(Costs& costs) {
    for (int i = 0; i < 6; ++i) {
        const double dt = 0.4 / std::pow(2.0, i);
        const int steps = 4 << i;
        costs.add(integrator,
                  {.choice = "Second",
                   .problem = "made up",
                   .parameter = {"dt", dt},
                   .n = 1,
                   .known_order = 2.0,
                   .error_run = [=] { return Outcome{.error = dt * dt, .work = steps, .diverged = i == 0}; },
                   .timed_run = [=] { return spin(100 * steps); },
                   .per = steps});
    }
}

CostsOptions quick() {
    CostsOptions options;
    options.plan.repeats = 3;
    options.plan.sample_seconds = 0.0005;
    options.plan.show_progress = false;
    return options;
}

} // namespace

TEST_CASE("cases become rows in their order, with errors, orders and times per unit", "[costs]") {
    Costs costs{"made_up", {}};
    add_ladder(costs);
    const Rows rows = costs.measure(quick());
    REQUIRE(rows.size() == 6);
    CHECK(rows[0].diverged);
    CHECK_FALSE(rows[0].error);
    CHECK_FALSE(rows[0].order);
    CHECK(rows[0].time); // it diverges, and still takes its time
    for (std::size_t i = 1; i < rows.size(); ++i) {
        REQUIRE(rows[i].order);
        CHECK(std::abs(*rows[i].order - 2) < 1e-9);
        REQUIRE(rows[i].time);
        REQUIRE(rows[i].spread);
        CHECK(*rows[i].spread >= 0);
        CHECK(rows[i].time_unit == "ns per step");
        // One step is a hundred loops of four operations that wait for each other: not 10 ns, not 100 us.
        CHECK(*rows[i].time > 10);
        CHECK(*rows[i].time < 1e5);
    }
}

TEST_CASE("an error that is not a number is a diverged row, though nobody said so", "[costs]") {
    Costs costs{"made_up", {}};
    costs.add(integrator, {.choice = "Bad",
                           .error_run = [] { return Outcome{.error = std::numeric_limits<double>::quiet_NaN()}; }});
    CostsOptions options = quick();
    options.untimed = true;
    const Rows rows = costs.measure(options);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].diverged);
    CHECK_FALSE(rows[0].time);
}

TEST_CASE("an axis without order gets none, however regular its numbers look", "[costs]") {
    const Axis bytes{.name = "scalar", .work_unit = "bytes per body", .has_order = false};
    Costs costs{"made_up", {}};
    for (int i = 0; i < 5; ++i)
        costs.add(bytes, {.choice = "float",
                          .parameter = {"n", std::pow(2.0, -i)},
                          .known_order = std::nullopt,
                          .error_run = [=] { return Outcome{.error = std::pow(2.0, -i), .work = 24}; }});
    CostsOptions options = quick();
    options.untimed = true;
    for (const Row& row : costs.measure(options)) CHECK_FALSE(row.order);
}

TEST_CASE("a run longer than the limit is run once and has no spread", "[costs]") {
    int runs = 0;
    TimingPlan plan;
    plan.once_above_seconds = 1e-7;
    plan.show_progress = false;
    const auto timings = time_runs({Timed{[&] {
                                        ++runs;
                                        return spin(200000);
                                    }},
                                    Timed{}},
                                   plan);
    REQUIRE(timings.size() == 2);
    CHECK(runs == 1);
    CHECK(timings[0].nanoseconds);
    CHECK_FALSE(timings[0].spread);
    CHECK_FALSE(timings[1].nanoseconds); // nothing to time
}

TEST_CASE("twice the work takes about twice the time", "[costs]") {
    TimingPlan plan;
    plan.repeats = 5;
    plan.sample_seconds = 0.002;
    plan.show_progress = false;
    const auto timings = time_runs({Timed{[] { return spin(2000); }}, Timed{[] { return spin(4000); }}}, plan);
    REQUIRE(timings[0].nanoseconds);
    REQUIRE(timings[1].nanoseconds);
    const double ratio = *timings[1].nanoseconds / *timings[0].nanoseconds;
    CHECK(ratio > 1.5); // a busy machine may bend it, not to one
    CHECK(ratio < 3);
}

TEST_CASE("the minimum is kept and the spread is that of the median", "[costs]") {
    const Timing timing = summarise({12, 10, 11, 50, 10.5});
    CHECK(*timing.nanoseconds == 10);
    CHECK(std::abs(*timing.spread - 0.1) < 1e-12);
    CHECK_FALSE(summarise({7.0}).spread);
    CHECK_FALSE(summarise({}).nanoseconds);
}

TEST_CASE("the program writes its table, and says in its exit code whether orders hold", "[costs]") {
    Folder folder;
    std::ostringstream out;
    Costs good{"made_up", {"--untimed", "--check", "--out", folder.path.string()}};
    add_ladder(good);
    CHECK(good.run(out) == 0);
    CHECK(out.str().find("diverged") != std::string::npos);
    std::ifstream in{folder.path / "made_up.json"};
    const Json json = Json::parse(in);
    CHECK(json["rows"].size() == 6);
    CHECK(json["machine"]["repeats"] == 0);

    Costs bad{"made_up", {"--untimed", "--check", "--out", folder.path.string()}};
    for (int i = 0; i < 5; ++i) {
        const double dt = std::pow(0.5, i);
        bad.add(integrator, {.choice = "First", .parameter = {"dt", dt}, .known_order = 2.0, .error_run = [=] {
                                 return Outcome{.error = dt};
                             }});
    }
    CHECK(bad.run(out) == 1);
}

TEST_CASE("a summary sees all rows as they were measured, and the folder for its pictures", "[costs]") {
    Folder folder;
    std::ostringstream out;
    Costs costs{"made_up", {"--untimed", "--out", folder.path.string()}};
    add_ladder(costs);
    std::size_t rows = 0;
    costs.add_summary([&](std::ostream& to, const Rows& all, const std::filesystem::path& where) {
        rows = all.size();
        CHECK(all[0].diverged);
        CHECK(std::abs(*all[1].error - 0.04) < 1e-12);
        CHECK(where == folder.path);
        to << "the summary\n";
    });
    costs.add_below([](std::ostream& to) { to << "and what is below\n"; });
    CHECK(costs.run(out) == 0);
    CHECK(rows == 6);
    CHECK(out.str().find("the summary\nand what is below\n") != std::string::npos);
    CHECK(out.str().find("the summary") > out.str().find("made_up.json"));
}

TEST_CASE("options are read, and what is not understood is refused with the list", "[costs]") {
    CHECK(CostsOptions::parse({"--quick"}).plan.repeats == 3);
    CHECK(CostsOptions::parse({}).plan.repeats == 15);
    CHECK(CostsOptions::parse({"--repeats", "7"}).plan.repeats == 7);
    CHECK_THROWS_AS(CostsOptions::parse({"--repeats"}), std::invalid_argument);
    CHECK_THROWS_AS(CostsOptions::parse({"--repeats", "none"}), std::invalid_argument);
    CHECK_THROWS_AS(CostsOptions::parse({"--qiuck"}), std::invalid_argument);

    Costs costs{"made_up", {}};
    CHECK_THROWS_AS(costs.add(integrator, {.choice = "X", .per = 0.0}), std::invalid_argument);
}
