// SPDX-License-Identifier: BSL-1.0
// A value in a file: what is read, and how a refusal names its place.

#include <ansatz/world/file_value.hpp>

#include "tests/catch.hpp"

#include <cmath>

using namespace ansatz;
using ansatz::detail::FileValue;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("a value in a file is read by its place, and a refusal names it", "[world][save]") {
    const auto json =
        detail::Json::parse(R"({"a": {"list": [1, 2.5, "x"]}, "yes": true, "huge": 1e300, "deep": [[[[[[1]]]]]]})");
    const FileValue file{json, "saved", true};
    CHECK(file.at("a").at("list").at(std::size_t(0)).whole(9) == 1);
    CHECK(file.at("a").at("list").at(std::size_t(1)).number<double>() == 2.5);
    CHECK(file.at("yes").yes());
    CHECK(file.at("a").at("list").size("numbers") == 3);
    CHECK_THROWS_WITH(file.at("b"), ContainsSubstring("saved: expected \"b\", but there is none"));
    CHECK_THROWS_WITH(file.at("a").at("list").at(std::size_t(2)).number<double>(),
                      ContainsSubstring("saved: a.list[2] is \"x\"; expected a finite number"));
    CHECK_THROWS_WITH(file.at("a").at("list").at(std::size_t(0)).whole(0),
                      ContainsSubstring("saved: a.list[0] is 1; expected a whole number from 0 to 0"));
    CHECK_THROWS_WITH(file.at("a").at("list").size_is(2, "numbers"), ContainsSubstring("expected a list of 2 numbers"));
    CHECK_THROWS_WITH(file.at("huge").number<float>(), ContainsSubstring("that the world's scalar can hold"));
    CHECK_THROWS_WITH(file.at("deep").yes(),
                      ContainsSubstring("saved: deep is a list; expected true or false")); // named, not shown
    CHECK(detail::number_to_file(1.5) == 1.5);
    CHECK(detail::number_to_file(-INFINITY) == "-inf");
}
