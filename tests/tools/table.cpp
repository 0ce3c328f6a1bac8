// SPDX-License-Identifier: BSL-1.0

// The cost table in the terminal, and its numbers.

#include "tests/catch.hpp"

#include "tools/costs/table.hpp"

#include <sstream>
#include <string>
#include <vector>

using namespace ansatz::workbook;

namespace {

Rows sample() {
    Row r;
    r.axis = "integrator";
    r.choice = "ExplicitEuler";
    r.problem = "oscillator";
    r.parameter = {"dt", 3.2};
    r.error_norm = "max |x - exact| (m)";
    r.work = 12800;
    r.work_unit = "force evaluations";
    r.time = 12.34;
    r.time_unit = "ns per simulated second per body";
    r.spread = 0.012;
    r.known_order = 1.0;
    r.diverged = true;
    Row stable = r;
    stable.parameter = {"dt", 0.1};
    stable.diverged = false;
    stable.error = 0.00123;
    stable.spread = 0.071;
    stable.order = 1.31;
    return {r, stable};
}

std::string printed(const Rows& rows) {
    std::ostringstream out;
    print_table(out, rows);
    return out.str();
}

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("counts are grouped by thousands, times carry three digits", "[costs][table]") {
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1 000");
    CHECK(grouped(-123456) == "-123 456");
    CHECK(grouped(12345678) == "12 345 678");

    CHECK(time_text(0) == "0");
    CHECK(time_text(0.01234) == "0.0123");
    CHECK(time_text(1.234) == "1.23");
    CHECK(time_text(99.94) == "99.9");
    CHECK(time_text(999.96) == "1 000");
    CHECK(time_text(12345) == "12 300");
    CHECK(time_text(1.23456e-7) == "1.23e-07");
}

TEST_CASE("a diverged row stays in the table and says so", "[costs][table]") {
    const auto text = lines(printed(sample()));
    int diverged = 0;
    for (const auto& line : text) diverged += contains(line, "diverged");
    CHECK(diverged == 1);
    REQUIRE(text.size() > 5);
    CHECK(contains(text[4], "dt = 3.2"));
    CHECK(contains(text[4], "diverged"));
    CHECK(contains(text[4], "12 800")); // what is known of it is printed
}

TEST_CASE("the head names axis, problem, norm and units once", "[costs][table]") {
    const auto text = lines(printed(sample()));
    REQUIRE(text.size() > 3);
    CHECK(text[0] == "integrator: oscillator");
    CHECK(text[1] == "  error: max |x - exact| (m)");
    CHECK(text[2] == "  time: ns per simulated second per body");
    CHECK(contains(text[3], "force evaluations"));
}

TEST_CASE("a wide spread and an order that is off are marked, and the marks explained", "[costs][table]") {
    const std::string text = printed(sample());
    CHECK(contains(text, "7.1 % !"));
    CHECK(contains(text, "1.31 !"));
    CHECK(contains(text, "! beside a spread"));
    CHECK(contains(text, "! beside an order"));

    Rows calm = sample();
    calm[1].spread = 0.01;
    calm[1].order = 1.01;
    CHECK_FALSE(contains(printed(calm), "!"));
}

TEST_CASE("numbers stand under each other", "[costs][table]") {
    Rows rows = sample();
    rows[1].work = 7;
    const auto text = lines(printed(rows));
    REQUIRE(text.size() > 5);
    const auto end_of_work = text[3].find("force evaluations") + std::string{"force evaluations"}.size();
    CHECK(text[4].substr(end_of_work - 6, 6) == "12 800");
    CHECK(text[5].substr(end_of_work - 2, 2) == " 7");
}

TEST_CASE("a column in which nothing stands is not printed", "[costs][table]") {
    Row r;
    r.axis = "scalar";
    r.choice = "float";
    r.work = 24;
    r.work_unit = "bytes per body";
    const std::string text = printed({r});
    CHECK(contains(text, "bytes per body"));
    for (const char* absent : {"error", "time", "spread", "order", "known", "parameter"})
        CHECK_FALSE(contains(text, absent));
}
