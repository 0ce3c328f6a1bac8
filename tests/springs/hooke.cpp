// SPDX-License-Identifier: BSL-1.0
// Hooke's law and the damped spring, as functions (notes 3).

#include <ansatz/springs/hooke.hpp>

#include "tests/springs/support.hpp"

using namespace spring_tests;

TEST_CASE("a spring's force is against its displacement, and damped against its velocity", "[springs]") {
    const auto k = 100.0 * N_per_m;
    const auto c = 2.0 * N_s_per_m;
    CHECK(springs::force(k, 0.25 * metre) == -25.0 * newton);
    CHECK(springs::force(k, metres(0.25, 0, -0.5)) == newtons(-25, 0, 50));
    CHECK(springs::force(k, -0.25 * metre, c, 3.0 * metre_per_second) == 19.0 * newton);
    CHECK(springs::energy(k, 0.5 * metre) == 12.5 * joule);
    CHECK(springs::energy(k, -0.5 * metre) == 12.5 * joule);
}

TEMPLATE_TEST_CASE("between two ends: along the axis, by the length beyond rest, what moves across is not damped",
                   "[springs]", float, double) {
    using T = TestType;
    using S2 = Space<T, 2>;
    const auto rest = S2::Length::from_value(T(2));
    const auto k = S2::template ScalarOf<unit::Stiffness>::from_value(T(10));
    const auto c = S2::template ScalarOf<unit::Damping>::from_value(T(4));
    const auto to = vector_in<S2, unit::Length>(3, 4); // 5 m, 3 m beyond rest
    const auto still = vector_in<S2, unit::Velocity>(0, 0);
    CHECK(springs::between(to, still, rest, k, c).value()[0] == Approx(18));
    CHECK(springs::between(to, still, rest, k, c).value()[1] == Approx(24));
    const auto along = vector_in<S2, unit::Velocity>(0.6, 0.8); // 1 m/s of lengthening
    const auto across = vector_in<S2, unit::Velocity>(-0.8, 0.6);
    CHECK(springs::between(to, along, rest, k, c).value()[0] == Approx(18 + 4 * 0.6));
    CHECK(springs::between(to, across, rest, k, c).value()[0] == Approx(18));
    // The second end feels the opposite: swapping the ends negates, to the bit.
    const auto there = springs::between(to, along, rest, k, c), back = springs::between(-to, -along, rest, k, c);
    CHECK((there.value() + back.value()).norm() == T(0));
    // It does not matter where and how fast the two move together, and a turned spring is a turned force.
    const auto turned =
        springs::between(vector_in<S2, unit::Length>(-4, 3), vector_in<S2, unit::Velocity>(-0.8, 0.6), rest, k, c);
    CHECK(turned.value()[0] == Approx(-there.value()[1]));
    CHECK(turned.value()[1] == Approx(there.value()[0]));
}

TEST_CASE("hard case S4: ends in one place have no axis and feel nothing, with any rest length", "[springs]") {
    for (const double rest : {0.0, 1.0})
        for (const double v : {0.0, 3.0}) {
            const auto f = springs::between(metres(0, 0, 0), metres_per_second(v, 0, 0), rest * metre, 100.0 * N_per_m,
                                            2.0 * N_s_per_m);
            CHECK(f == newtons(0, 0, 0));
        }
    // Next to it the force is that of the law: of rest length 0 it goes to nothing, of rest length 1 m it pushes with k
    // times 1 m.
    const auto near = metres(1e-9, 0, 0);
    CHECK(
        x(springs::between(near, metres_per_second(0, 0, 0), 0.0 * metre, 100.0 * N_per_m, 0.0 * N_s_per_m)).value() ==
        Approx(1e-7));
    CHECK(
        x(springs::between(near, metres_per_second(0, 0, 0), 1.0 * metre, 100.0 * N_per_m, 0.0 * N_s_per_m)).value() ==
        Approx(-100));
}

TEST_CASE("hard case S10: a rope is slack below its length and never pushes, however fast it shortens", "[springs]") {
    using springs::Acts;
    const auto rest = 1.0 * metre;
    const auto k = 100.0 * N_per_m;
    const auto c = 50.0 * N_s_per_m;
    CHECK(springs::tension<Acts::pulling>(0.9 * metre, rest, 5.0 * metre_per_second, k, c) == 0.0 * newton);
    CHECK(springs::tension<Acts::pulling>(1.1 * metre, rest, -1.0 * metre_per_second, k, c) == 0.0 * newton);
    CHECK(springs::tension<Acts::pulling>(1.1 * metre, rest, 0.0 * metre_per_second, k, c).value() == Approx(10));
    CHECK(springs::tension(0.9 * metre, rest, 0.0 * metre_per_second, k, c).value() == Approx(-10));
}

TEST_CASE("constants from frequency and damping ratio, and back", "[springs]") {
    const auto m = 3.0 * kilogram;
    for (const double f : {0.5, 2.0, 30.0})
        for (const double zeta : {0.0, 0.1, 1.0, 4.0}) {
            const auto k = springs::stiffness(f / second, m);
            const auto c = springs::damping(f / second, zeta, m);
            CHECK(in(springs::frequency(k, m), hertz) == Approx(f));
            CHECK(springs::damping_ratio(k, c, m) == Approx(zeta));
            CHECK(in(springs::angular_frequency(k, m), hertz) == Approx(2 * M_PI * f));
        }
    // Critical damping is 2 sqrt(k m), not sqrt(k m).
    CHECK(springs::critical_damping(100.0 * N_per_m, 4.0 * kilogram) == 40.0 * N_s_per_m);
    CHECK(springs::reduced_mass(1.0 * kilogram, 3.0 * kilogram) == 0.75 * kilogram);
    CHECK(springs::reduced_mass(1e-3 * kilogram, 1e9 * kilogram).value() == Approx(1e-3));
}

TEST_CASE("constants that cannot be are refused by name, value and unit", "[springs]") {
    using namespace Catch::Matchers;
    CHECK_THROWS_WITH(springs::stiffness(-1.0 / second, 1.0 * kilogram),
                      ContainsSubstring("springs::stiffness: frequency is -1 1/s"));
    CHECK_THROWS_WITH(springs::stiffness(1.0 / second, 0.0 * kilogram), ContainsSubstring("mass is 0 kg"));
    CHECK_THROWS_WITH(springs::damping(1.0 / second, -0.5, 1.0 * kilogram),
                      ContainsSubstring("springs::damping: ratio is -0.5"));
    CHECK_THROWS_WITH(springs::critical_damping(NAN * N_per_m, 1.0 * kilogram), ContainsSubstring("stiffness is nan"));
    CHECK_THROWS_WITH(springs::reduced_mass(1.0 * kilogram, double(INFINITY) * kilogram),
                      ContainsSubstring("second is inf kg"));
}
