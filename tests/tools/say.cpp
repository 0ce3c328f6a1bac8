// SPDX-License-Identifier: BSL-1.0
// Sentences of the course's programs: wrapped at words, and nowhere between a number and its unit.

#include "tools/say.hpp"
#include "tests/catch.hpp"
#include "tools/claims.hpp"

#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

using namespace ansatz::workbook;

namespace {

/// What is written to std::cout while it is there; the format is as before afterwards.
class Heard {
public:
    Heard() : before_(std::cout.rdbuf(text_.rdbuf())), format_(nullptr) { format_.copyfmt(std::cout); }
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;
    ~Heard() {
        std::cout.copyfmt(format_);
        std::cout.rdbuf(before_);
    }
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
    std::streambuf* before_;
    std::ios format_;
};

const std::string seventy(70, 'x');

} // namespace

TEST_CASE("what fits into a line is left as it is, blanks too", "[tools]") {
    const std::string four = std::string(75, 'x') + " four"; // 80
    for (const std::string& text :
         {std::string(), std::string("\n"), std::string("a  b \n\n  c\n"), four, std::string(200, ' ')})
        CHECK(wrapped(text) == text);
    const std::string bytes = std::string(75, 'x') + " foué"; // characters are counted, and not these
    CHECK(wrapped(bytes) == bytes);
}

TEST_CASE("a line that is too wide ends at a word, and what is left is indented", "[tools]") {
    CHECK(wrapped(seventy + " nine and nine") == seventy + " nine and\n    nine");
    CHECK(wrapped("  " + seventy + " nine and nine\nshort\n", 2) == "  " + seventy + " nine\n    and nine\nshort\n");
    CHECK(wrapped(seventy + seventy) == seventy + seventy); // a word that has no end
    CHECK(wrapped(seventy + " " + seventy + " " + seventy, 0) == seventy + "\n" + seventy + "\n" + seventy);
}

TEST_CASE("no line ends between a number and its unit, within a vector or beside an operator", "[tools]") {
    CHECK(wrapped(seventy + " by 0.25 m/s") == seventy + " by\n    0.25 m/s");
    CHECK(wrapped(seventy + " at (1, 2, 3) m") == seventy + " at\n    (1, 2, 3) m");
    CHECK(wrapped(seventy + " then e = 5") == seventy + " then\n    e = 5");
    CHECK(wrapped(seventy + " 1, 2, 3, 4, 5") == seventy + " 1, 2, 3,\n    4, 5"); // a list is no vector
    CHECK(wrapped(seventy + " (1, 2) (3, 4)") == seventy + " (1, 2)\n    (3, 4)");
}

TEST_CASE("what is said looks as on the standard output, and its manipulators stay", "[tools]") {
    const Heard heard;
    std::cout << std::fixed << std::setprecision(2);
    say() << seventy << " after " << 1.5 << " s\n" << std::setprecision(1);
    std::cout << 1.5 << '\n';
    CHECK(heard.text() == seventy + " after\n    1.50 s\n1.5\n");
}

TEST_CASE("a claim goes on below its first word", "[tools]") {
    const Heard heard;
    Claims claim;
    claim(seventy + " it is", true);
    claim("short", false);
    CHECK(heard.text() == "  [holds] " + seventy + "\n          it is\n  [FAILS] short\n");
    CHECK(claim.result() == 1);
}
