// SPDX-License-Identifier: BSL-1.0

// SUVAT, notes 1.5: what cannot be, what is nothing at all, and what is taken.

#include "tests/motion/suvat.hpp"

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <cmath>
#include <string>
#include <type_traits>

using namespace ansatz;
using ansatz::test::Five;
using ansatz::test::refusal;
using ansatz::test::solve;

TEST_CASE("SUVAT: what cannot be is refused with the values and the reason", "[motion][suvat]") {
    auto sentence = [](const std::string& knowns, const Five<double>& m) { return refusal([&] { solve(knowns, m); }); };
    CHECK(sentence("sua", {20, 5, 0, -9.81, 0}) == "suvat::solve: displacement 20 m, initial velocity 5 m/s, "
                                                   "acceleration -9.81 m/s^2: it is out of reach: the motion turns "
                                                   "round before it, because u^2 + 2 a s is negative");
    CHECK(sentence("sva", {20, 0, 5, 9.81, 0}) == "suvat::solve: displacement 20 m, final velocity 5 m/s, acceleration "
                                                  "9.81 m/s^2: it is out of reach: no motion ends so, "
                                                  "because v^2 - 2 a s is negative");
    CHECK(sentence("uva", {0, 1, 2, 0, 0}) ==
          "suvat::solve: initial velocity 1 m/s, final velocity 2 m/s, acceleration 0 m/s^2: they "
          "contradict each other: without acceleration the velocity stays");
    CHECK(sentence("uva", {0, 2, 2, 0, 0}) ==
          "suvat::solve: initial velocity 2 m/s, final velocity 2 m/s, acceleration 0 m/s^2: nothing "
          "changes, so any time would do; give the time");
    CHECK(sentence("suv", {3, 2, -2, 0, 0}).find("the mean velocity is 0 m/s") != std::string::npos);
    CHECK(sentence("suv", {0, 2, -2, 0, 0}).find("back where it was after any time") != std::string::npos);
    CHECK(sentence("suv", {0, 2, 3, 0, 0}).find("in no time the velocity does not change") != std::string::npos);
    CHECK(sentence("suv", {0, 2, 2, 0, 0}).find("any acceleration would do") != std::string::npos);
    CHECK(sentence("sua", {3, 0, 0, 0, 0}).find("a body at rest stays where it is") != std::string::npos);
    CHECK(sentence("sua", {0, 0, 0, 0, 0}).find("any time would do") != std::string::npos);
    CHECK(sentence("sva", {3, 0, 0, 0, 0}).find("a body at rest stays where it is") != std::string::npos);
    for (const auto* knowns : {"sut", "svt", "sat"}) {
        CHECK(sentence(knowns, {3, 2, 2, 1, 0}).find("in no time there is no displacement") != std::string::npos);
        CHECK(sentence(knowns, {0, 2, 2, 1, 0}).find("would do; give another quantity") != std::string::npos);
    }
    CHECK(sentence("uvt", {0, 2, 3, 0, 0}).find("in no time the velocity does not change") != std::string::npos);
    CHECK(sentence("uvt", {0, 2, 2, 0, 0}).find("any acceleration would do") != std::string::npos);
    CHECK(sentence("uva", {0, 0, 1e300, 1e-300, 0}).find("a value that the scalar cannot hold") != std::string::npos);
    CHECK(sentence("uat", {0, std::nan(""), 0, 1, 1}) ==
          "suvat::solve: initial velocity is nan m/s; it must be finite");
    CHECK(sentence("uat", {0, 1, 0, 1, HUGE_VAL}) == "suvat::solve: time is inf s; it must be finite");
}

TEST_CASE("SUVAT: no time at all is a motion when the velocity is asked for", "[motion][suvat]") {
    const auto now = solve<double>("uat", {0, 3, 0, 2, 0});
    CHECK(now.front().s == 0 * metre);
    CHECK(now.front().v == 3 * metre_per_second);
    CHECK(solve<double>("uva", {0, 3, 3, 2, 0}).front().t == 0 * second);
}

TEST_CASE("SUVAT: parameters and the world's own quantities are taken", "[motion][suvat]") {
    const Parameter<unit::Acceleration> g = -10 * metre_per_second_squared;
    const auto fall = suvat::solve(suvat::initial_velocity(0 * metre_per_second), suvat::acceleration(g),
                                   suvat::time(scalar_cast<double>(1.f * second)));
    CHECK(fall.front().s == -5 * metre);
    static_assert(std::is_same_v<decltype(fall.front().v), Quantity<unit::Velocity>>);
}
