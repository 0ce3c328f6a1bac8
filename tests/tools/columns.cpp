// SPDX-License-Identifier: BSL-1.0
// The tables of the course's programs: straight, however long what stands in them is.

#include "tools/columns.hpp"
#include "tests/catch.hpp"

#include <ansatz/units.hpp>
#include <ansatz/units/print.hpp>

#include <iomanip>
#include <sstream>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

std::string text_of(const Columns& table) {
    std::ostringstream text;
    text << table;
    return text.str();
}

} // namespace

TEST_CASE("a column is as wide as what stands in it, with its unit", "[tools]") {
    CHECK(text_of(Columns({"c", "limit of the step", "beyond"})
                      .row(0.0, 0.2 * second, "stays")
                      .row(20000, 0.00997512 * second, "explodes")
                      .row(-2, 12.5 * second, "")) == "      c   limit of the step   beyond\n"
                                                      "      0               0.2 s   stays\n"
                                                      "  20000        0.00997512 s   explodes\n"
                                                      "     -2              12.5 s\n");
}

TEST_CASE("text stands left, and one word among numbers makes text of them", "[tools]") {
    CHECK(text_of(Columns({"é", "n"}).row("ab", 1).row("abc", "none")) == "  é     n\n"
                                                                          "  ab    1\n"
                                                                          "  abc   none\n");
    CHECK(text_of(Columns({"alone"})) == "  alone\n");
}

TEST_CASE("what is printed is what the standard output would show", "[tools]") {
    CHECK(printed(0.5, " mm of ", 3) == "0.5 mm of 3");
    CHECK(printed(std::fixed, std::setprecision(1), 20.0) == "20.0");
    CHECK(printed(20.0) == "20"); // a manipulator holds for one of them
}
