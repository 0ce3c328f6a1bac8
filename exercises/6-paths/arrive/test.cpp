// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on arriving (notes 6.3.8).

#include "tools/exercises/expect.hpp"

#include <ansatz/units/print.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

constexpr auto acceleration = 3.0 * metre / second / second;
constexpr auto dt = 0.25 * second; // so that a dt is 0.75 m/s, and a dt dt 0.1875 m
using Vec = VectorQuantity<unit::Velocity, 2>;

struct Asked {
    Vec velocity, wanted;
};
const std::vector<Asked>& within_reach() {
    static const std::vector<Asked> all = {{metres_per_second(2, 1), metres_per_second(2.3, 1.4)},
                                           {metres_per_second(-1, 0.5), metres_per_second(-1, 0.5)},
                                           {metres_per_second(0.2, 0.1), metres_per_second(0, 0)}};
    return all;
}
const std::vector<Asked>& out_of_reach() {
    static const std::vector<Asked> all = {{metres_per_second(2, 1), metres_per_second(-2, 4)},
                                           {metres_per_second(0, 0), metres_per_second(3, 4)},
                                           {metres_per_second(5, -2), metres_per_second(0, 0)},
                                           {metres_per_second(1, 1), metres_per_second(0.5, 0.3)}};
    return all;
}
Vec yours(const Asked& a) { return exercise::steered(a.velocity, a.wanted, acceleration, dt); }
std::string said(const Asked& a) {
    std::ostringstream text;
    text << "the velocity is (" << a.velocity.value()[0] << ", " << a.velocity.value()[1] << ") m/s, wanted is ("
         << a.wanted.value()[0] << ", " << a.wanted.value()[1] << ") m/s, and a step changes it by 0.75 m/s at most";
    return text.str();
}
void expect_speed(double distance, double right, const std::string& why) {
    std::ostringstream text;
    text << "the speed of the next step, " << distance << " m before the place, with 3 m/s^2 and steps of 0.25 s";
    expect_near(text.str(), exercise::arrival_speed(distance * metre, acceleration, dt), right * metre / second,
                1e-12 * metre / second, why);
}

} // namespace

TEST_CASE("what can be had in one step is taken", "[task-1][reach]") {
    for (const auto& a : within_reach())
        expect_near(said(a), yours(a), a.wanted, 1e-14 * metre / second, "It is nearer than acceleration times dt.");
}

TEST_CASE("else the velocity changes by the acceleration times the step", "[task-1][size]") {
    for (const auto& a : out_of_reach())
        expect_near(said(a) + ": by how much it changes", norm(yours(a) - a.velocity), 0.75 * metre / second,
                    1e-12 * metre / second, "More the acceleration does not give, in whatever direction.");
}

TEST_CASE("and it changes straight towards the wanted one", "[task-1][direction]") {
    for (const auto& a : out_of_reach()) {
        const Vec right = a.velocity + (0.75 / norm(a.wanted - a.velocity).value()) * (a.wanted - a.velocity);
        expect_near(said(a), yours(a), right, 1e-12 * metre / second,
                    "The change has the direction of wanted - velocity.");
    }
}

TEST_CASE("the last step is what is left of the way", "[task-2][last]") {
    for (const double d : {0.0, 0.01, 0.1, 0.18})
        expect_speed(d, d / 0.25, "Within a dt dt, 0.1875 m, one step leads there, and the next one can stop.");
}

TEST_CASE("where braking ends with whole steps the speed is a multiple of a dt", "[task-2][multiples]") {
    for (const double m : {1, 2, 3, 7})
        expect_speed(0.1875 * m * (m + 1) / 2, 0.75 * m,
                     "m a dt, then (m - 1) a dt, and so on: together a dt dt m (m + 1) / 2.");
}

TEST_CASE("between those braking uses up the distance, too", "[task-2][between]") {
    for (const double d : {0.3, 0.5, 1.0, 2.75, 13.0}) {
        const double u = exercise::arrival_speed(d * metre, acceleration, dt).value();
        double way = 0;
        for (double v = u; v > 0 && way < 100; v -= 0.75) way += v * 0.25;
        std::ostringstream text;
        text << "how far one comes from " << d << " m before the place, braking by 0.75 m/s in each step";
        expect_near(text.str(), way * metre, d * metre, 1e-12 * metre, "It is to be the distance.");
    }
}

TEST_CASE("whoever walks like that stands on the place", "[task-2][stands]") {
    double x = 0, farthest = 0;
    Vec v = metres_per_second(0, 0);
    for (int i = 0; i < 80; ++i) {
        const double left = 7.3 - x;
        const double speed = std::min(2.0, exercise::arrival_speed(std::abs(left) * metre, acceleration, dt).value());
        v = exercise::steered(v, metres_per_second(left < 0 ? -speed : speed, 0), acceleration, dt);
        x += v.value()[0] * 0.25;
        farthest = std::max(farthest, x);
    }
    expect_near("how far it came in those 20 s, on the way to 7.3 m with 2 m/s at most", farthest * metre, 7.3 * metre,
                1e-9 * metre, "Who asks for the speed before each step, and keeps to it, shoots past by nothing.");
    expect_near("the place after 20 s, on the way to 7.3 m with 2 m/s at most", x * metre, 7.3 * metre, 1e-9 * metre,
                "Nobody shoots past who asks for the speed before each step.");
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 1)
        for (const auto& all : {within_reach(), out_of_reach()})
            for (const auto& a : all) {
                const Vec v = yours(a);
                numbers.push_back(v.value()[0]), numbers.push_back(v.value()[1]);
            }
    else
        for (const double d : {0.1, 0.3, 1.0, 2.75, 13.0, 40.0})
            numbers.push_back(exercise::arrival_speed(d * metre, acceleration, 0.3 * second).value());
    return numbers;
}
