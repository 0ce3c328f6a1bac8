// SPDX-License-Identifier: BSL-1.0
// A hill of balls in numbers of 50 digits, by several responses, beside the same in double: see big_numbers.sh.

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

using namespace ansatz;
namespace mp = boost::multiprecision;

namespace {

/// Where the balls are after a fifth of a second, in which they fall on the ground, slide and meet, m.
template <class Scalar, class... Response> std::vector<double> played(Response... response) {
    World world{Space<Scalar, 2>{}, SemiImplicitEuler{},          Gravity{},
                SortAndSweep{},     Narrowphase<Sphere, Plane>{}, response...};
    world.add(Plane::ground(), fixed);
    std::vector<Handle> balls;
    for (const auto& [x, y] : {std::pair(-0.47, 0.52), std::pair(0.58, 0.61), std::pair(0.0625, 1.55)})
        balls.push_back(world.add(Sphere{0.5 * metre}, position(metres(x, y)), velocity(metres_per_second(1 - x, -1)),
                                  mass((1 + y) * kilogram)));
    std::size_t met = 0;
    for (int n = 0; n < 12; ++n) {
        world.step(1.0 / 60 * second);
        met += world.contacts().size();
    }
    if (met < 5) std::cout << "they hardly meet, which shows nothing\n", std::exit(1);
    std::vector<double> all;
    for (const auto ball : balls)
        for (int k = 0; k < 2; ++k) all.push_back(double(world.position(ball).value()[k]));
    return all;
}

template <class... Response> int compare(const char* name, Response... response) {
    using Fifty = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
    const auto twice = played<double>(response...), fifty = played<Fifty>(response...);
    double apart = 0;
    for (std::size_t n = 0; n < twice.size(); ++n) {
        const double by = std::abs(twice[n] - fifty[n]);
        apart = by <= apart ? apart : by; // a NaN stays
    }
    const bool same = apart <= 1e-12 && apart > 0; // m; the last digits of double are not those of 50
    std::cout << name << ": " << apart << " m apart from double" << (same ? "\n" : ", which is wrong\n");
    return same ? 0 : 1;
}

} // namespace

int main() {
    return compare("Impulse, Projection", Impulse<Friction>{}, Projection{}) + compare("Penalty", Penalty{}) +
           compare("SoftSubsteps<Friction>", SoftSubsteps<Friction>{}) +
           compare("SoftSubsteps<Friction, Coloured>", SoftSubsteps<Friction, Coloured>{});
}
