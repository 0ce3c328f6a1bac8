// SPDX-License-Identifier: BSL-1.0
// The tests of the exercise on the stable step of a net (notes 4).

#include "tools/exercises/expect.hpp"

#include <ansatz/world.hpp>

#include <cmath>

using namespace ansatz;
using namespace ansatz::workbook;

namespace {

const double pi = std::acos(-1.0);
const auto per_square_second = hertz * hertz;

struct Known {
    std::string name;
    exercise::Net net;
    double bound, largest; // 1/s^2
};
Known pair(double first, double second, double k) {
    std::ostringstream text;
    text << "two bodies of " << 1 / first << " kg and " << 1 / second << " kg on a spring of " << k << " N/m";
    return {text.str(),
            {{first / kilogram, second / kilogram}, {{0, 1, k * newton_per_metre}}},
            k * (first + second),
            k * (first + second)};
}
/// Bodies in a row, of 1/w kg each; held at both ends, or free.
Known chain(std::size_t count, bool held, double w, double k) {
    Known known;
    std::ostringstream text;
    text << count << " bodies of " << 1 / w << " kg in a row, " << (held ? "held at both ends" : "free")
         << ", springs of " << k << " N/m";
    known.name = text.str();
    if (held) known.net.weights.push_back(0.0 / kilogram);
    for (std::size_t i = 0; i < count; ++i) known.net.weights.push_back(w / kilogram);
    if (held) known.net.weights.push_back(0.0 / kilogram);
    for (std::size_t i = 0; i + 1 < known.net.weights.size(); ++i)
        known.net.springs.push_back({i, i + 1, k * newton_per_metre});
    const double n = double(count);
    known.largest = k * w * (held ? 2 + 2 * std::cos(pi / (n + 1)) : 2 - 2 * std::cos(pi * (n - 1) / n));
    known.bound = 4 * k * w;
    return known;
}
/// One body in the middle, and others that hang on it.
Known star(std::size_t count, double w, double k) {
    Known known;
    known.name = "a body with " + std::to_string(count) + " others around it, all alike, each on a spring";
    known.net.weights.assign(count + 1, w / kilogram);
    for (std::size_t i = 1; i <= count; ++i) known.net.springs.push_back({0, i, k * newton_per_metre});
    known.largest = known.bound = k * w * double(count + 1);
    return known;
}
std::vector<Known> nets() {
    return {pair(2, 0.5, 30),        pair(0, 4, 700),        chain(5, true, 3, 200),
            chain(6, true, 0.5, 90), chain(4, false, 2, 50), star(4, 1.5, 80)};
}
/// A row of unequal bodies and springs, of which the bound is known and the rest is not.
Known uneven() {
    Known known;
    known.name = "three unequal bodies in a row";
    known.net = {{2.0 / kilogram, 0.25 / kilogram, 5.0 / kilogram},
                 {{0, 1, 100.0 * newton_per_metre}, {1, 2, 40.0 * newton_per_metre}}};
    known.bound = std::max(100 * 2 + 140 * 0.25, 140 * 0.25 + 40 * 5);
    // The root of the square that is left when the free motion is taken out of the characteristic polynomial.
    const double a = 100 * 2, b = 100 * 0.25, c = 40 * 0.25, d = 40 * 5;
    const double sum = a + b + c + d, product = a * c + a * d + b * d;
    known.largest = (sum + std::sqrt(sum * sum - 4 * product)) / 2;
    return known;
}
/// How much semi-implicit Euler grows in 5000 steps, from a displacement of 1.
double growth(double omega_squared, double dt) {
    double x = 1, v = 0, most = 1;
    for (int n = 0; n < 5000 && most < 1e9; ++n) {
        v -= dt * omega_squared * x;
        x += dt * v;
        most = std::max(most, std::abs(x));
    }
    return most;
}
const double stiffnesses[] = {4, 900, 2.5e5}; // 1/s^2

} // namespace

TEST_CASE("each spring feels all springs at its two ends", "[task-1][bound]") {
    auto all = nets();
    all.push_back(uneven());
    for (const auto& known : all)
        expect_near(known.name + ": the bound", exercise::bound(known.net), known.bound * per_square_second,
                    1e-9 * known.bound * per_square_second,
                    "Of each mass a spring has the share k over the sum of all k at that body, so that its omega^2 is "
                    "the sum of the sums over the masses. The largest counts.");
}

TEST_CASE("the bound is one", "[task-1][certain]") {
    auto all = nets();
    all.push_back(uneven());
    for (const auto& known : all) {
        const auto mine = exercise::bound(known.net);
        std::ostringstream text;
        text << known.name << "\n    yours       " << mine << "\n    it swings   " << known.largest * per_square_second
             << "\nNo way to swing may be faster than the bound, or the step that follows from it explodes.";
        expect(is_finite(mine) && mine >= (1 - 1e-9) * known.largest * per_square_second, text.str());
    }
}

TEST_CASE("rows, stars and pairs swing as their closed forms say", "[task-2][closed-forms]") {
    for (const auto& known : nets())
        expect_near(
            known.name + ": the largest omega^2", exercise::measured(known.net), known.largest * per_square_second,
            1e-6 * known.largest * per_square_second,
            "In the fastest way to swing neighbours go against each other. Begin with something that has a part "
            "of it, and turn often.");
}

TEST_CASE("unequal bodies, too", "[task-2][unequal]") {
    const auto known = uneven();
    expect_near(known.name + ": the largest omega^2", exercise::measured(known.net), known.largest * per_square_second,
                1e-6 * known.largest * per_square_second,
                "The force of a spring is the same at both ends; what it does to each is by its own 1/m.");
}

TEST_CASE("a hair shorter, it stays", "[task-3][stays]") {
    for (const double each : stiffnesses) {
        const auto dt = exercise::longest_step(each * per_square_second);
        std::ostringstream text;
        text << "omega^2 = " << each << " /s^2\n    yours  " << dt << "\nWith 0.999 of that it grows without end.";
        expect(is_finite(dt) && dt > 0.0 * second && growth(each, 0.999 * dt.value()) < 1000, text.str());
    }
}

TEST_CASE("a hair longer, it explodes", "[task-3][explodes]") {
    for (const double each : stiffnesses) {
        const auto dt = exercise::longest_step(each * per_square_second);
        std::ostringstream text;
        text << "omega^2 = " << each << " /s^2\n    yours  " << dt
             << "\nIt is stable, but not the longest: with 1.001 of it nothing grows yet.";
        expect(is_finite(dt) && growth(each, 1.001 * dt.value()) > 1e6, text.str());
    }
}

std::vector<double> probe(int task) {
    std::vector<double> numbers;
    if (task == 3)
        for (const double each : stiffnesses)
            numbers.push_back(exercise::longest_step(each * per_square_second).value());
    else {
        auto all = nets();
        all.push_back(uneven());
        for (const auto& known : all)
            numbers.push_back(task == 1 ? exercise::bound(known.net).value() : exercise::measured(known.net).value());
    }
    return numbers;
}
