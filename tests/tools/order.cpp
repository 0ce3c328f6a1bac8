// SPDX-License-Identifier: BSL-1.0

// The fit of an order of convergence, on ladders whose order is known because we made them.

#include "tests/catch.hpp"

#include "tools/costs/order.hpp"

#include <cmath>
#include <vector>

using namespace ansatz::workbook;

namespace {

// error = factor * step^order + floor, for steps that halve from `coarsest`.
std::vector<Rung> ladder(int rungs, double order, double floor = 0, double coarsest = 0.1) {
    std::vector<Rung> rows;
    for (int i = 0; i < rungs; ++i) {
        const double step = coarsest / std::pow(2.0, i);
        rows.push_back({step, 3.0 * std::pow(step, order) + floor});
    }
    return rows;
}

Row row(const std::string& choice, double step, Number error, bool diverged = false) {
    Row r;
    r.axis = "integrator";
    r.choice = choice;
    r.problem = "made up";
    r.parameter = {"dt", step};
    r.error = error;
    r.diverged = diverged;
    return r;
}

} // namespace

TEST_CASE("an exact power law is fitted to rounding, over the whole ladder", "[costs][order]") {
    for (const double order : {0.5, 1.0, 2.0, 4.0}) {
        const auto fit = fit_order(ladder(7, order));
        REQUIRE(fit);
        CHECK(std::abs(fit->order - order) < 1e-12);
        CHECK(fit->first == 0);
        CHECK(fit->last == 6);
    }
}

TEST_CASE("three halvings, four points, are the least that shows an order", "[costs][order]") {
    CHECK(fit_order(ladder(4, 2)));
    CHECK_FALSE(fit_order(ladder(3, 2)));
    CHECK_FALSE(fit_order(ladder(1, 2)));
    CHECK_FALSE(fit_order({}));
}

TEST_CASE("noise within the tolerance is averaged, noise beyond it shows no order", "[costs][order]") {
    auto quiet = ladder(8, 2), loud = ladder(8, 2);
    for (std::size_t i = 0; i < quiet.size(); ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;
        *quiet[i].error *= 1 + 0.01 * sign; // slopes off by log2(1.01/0.99) = 0.029, to either side
        *loud[i].error *= 1 + 0.1 * sign;   // by 0.29
    }
    const auto fit = fit_order(quiet);
    REQUIRE(fit);
    CHECK(std::abs(fit->order - 2) < 0.02);
    CHECK_FALSE(fit_order(loud));
}

TEST_CASE("a floor of rounding is no order: the fit ends above it", "[costs][order]") {
    const auto rungs = ladder(14, 4, 1e-13); // the power law meets the floor near the tenth halving
    const auto fit = fit_order(rungs);
    REQUIRE(fit);
    CHECK(std::abs(fit->order - 4) < order_tolerance);
    CHECK(fit->last < 11);
    // A floor and nothing else: an error that does not fall has no order at all.
    CHECK_FALSE(fit_order(ladder(8, 4, 1.0)));
}

TEST_CASE("the finest place that agrees counts, not the longest", "[costs][order]") {
    // Order two while the second-order part dominates, order one where it matters.
    std::vector<Rung> rungs;
    for (int i = 0; i < 22; ++i) {
        const double step = std::pow(2.0, -i);
        rungs.push_back({step, 100 * step * step + 0.02 * step});
    }
    const auto fit = fit_order(rungs);
    REQUIRE(fit);
    CHECK(std::abs(fit->order - 1) < order_tolerance);
    CHECK(fit->last == rungs.size() - 1);
}

TEST_CASE("no slope leads across a diverged point, a missing error or an error of zero", "[costs][order]") {
    auto rungs = ladder(9, 2);
    rungs[4].error = {};
    const auto fit = fit_order(rungs); // four points are left on either side: the finer ones count
    REQUIRE(fit);
    CHECK(fit->first == 5);
    CHECK(std::abs(fit->order - 2) < 1e-12);

    auto zero = ladder(6, 2);
    zero[3].error = 0.0;
    CHECK_FALSE(fit_order(zero));
}

TEST_CASE("orders are written into the rows that show them, in whatever order the rows stand", "[costs][order]") {
    Rows rows;
    for (const double step : {0.0125, 0.1, 0.025, 0.05}) {
        rows.push_back(row("Second", step, step * step));
        rows.push_back(row("First", step, step));
    }
    rows.push_back(row("Second", 3.2, {}, true)); // diverged: has no order, and stays
    rows.push_back(row("Lonely", 0.1, 1.0));
    fit_orders(rows, "integrator");
    for (const Row& r : rows) {
        INFO(r.choice << ", dt = " << *r.parameter.value);
        if (r.diverged || r.choice == "Lonely") CHECK_FALSE(r.order);
        else {
            REQUIRE(r.order);
            CHECK(std::abs(*r.order - (r.choice == "Second" ? 2 : 1)) < 1e-12);
        }
    }
}

TEST_CASE("an order is off when it is more than a tenth from the known one", "[costs][order]") {
    Row r = row("Second", 0.1, 1.0);
    CHECK_FALSE(order_is_off(r)); // nothing fitted, nothing known
    r.order = 1.95;
    CHECK_FALSE(order_is_off(r));
    r.known_order = 2.0;
    CHECK_FALSE(order_is_off(r));
    r.order = 1.85;
    CHECK(order_is_off(r));
}
