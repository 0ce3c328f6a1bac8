// SPDX-License-Identifier: BSL-1.0

// Momentum, notes 1.4. Two laws fix a collision along a line: momentum is conserved, and the bodies separate with e
// times the speed at which they met. Both are tested for random pairs; everything else is a symmetry or a limit.

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <ansatz/motion/momentum.hpp>
#include <ansatz/motion/suvat.hpp>
#include <ansatz/units/print.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace ansatz;
using namespace ansatz::mechanics;
using ansatz::test::refusal;

namespace {

/// Seeded numbers, the same everywhere.
class Numbers {
public:
    double between(double from, double to) { return from + (to - from) * double(engine_() >> 11) * 0x1p-53; }
    double decades(double n) { return std::pow(10.0, between(-n, n)); }

private:
    std::mt19937_64 engine_{4711};
};

/// Two bodies with masses up to 1e9 apart.
template <class S> std::array<PointMass<S>, 2> pair_along_a_line(Numbers& numbers) {
    auto body = [&] {
        return PointMass<S>{Quantity<unit::Mass, S>::from_value(S(numbers.decades(4.5))),
                            Quantity<unit::Velocity, S>::from_value(S(numbers.between(-20, 20)))};
    };
    return {body(), body()};
}

PointMass<double, Vector<double, 3>> body_in_space(Numbers& numbers) {
    return {numbers.decades(4.5) * kilogram,
            metres_per_second(numbers.between(-20, 20), numbers.between(-20, 20), numbers.between(-20, 20))};
}

} // namespace

TEST_CASE("Momentum: p = m v, and an impulse is its change", "[motion][momentum]") {
    CHECK(momentum(2 * kilogram, 3 * metre_per_second) == 6 * kilogram_metre_per_second);
    CHECK(in(momentum(2 * kilogram, metres_per_second(1, -2, 3)), newton_second) == Eigen::Vector3d(2, -4, 6));
    CHECK(kinetic_energy(2 * kilogram, 3 * metre_per_second) == 9 * joule);
    CHECK(kinetic_energy(2 * kilogram, metres_per_second(1, -2, 3)) == 14 * joule);
    CHECK(in(impulse(newtons(0, 5, 0), 0.1 * second), newton_second) == Eigen::Vector3d(0, 0.5, 0));
    // A constant force through a time, by SUVAT: u = 1 m/s, a = F / m = 2.5 m/s^2, t = 4 s.
    const auto m = 2 * kilogram;
    const auto push = 5 * newton;
    const auto ride = suvat::solve(suvat::initial_velocity(1 * metre_per_second),
                                   suvat::acceleration(acceleration(push, m)), suvat::time(4.0 * second))
                          .front();
    CHECK(momentum(m, ride.v) - momentum(m, ride.u) == impulse(push, ride.t));
    // and through a way: the work of the force is the change of the kinetic energy.
    CHECK(kinetic_energy(m, ride.v) - kinetic_energy(m, ride.u) == push * ride.s);
}

TEST_CASE("Momentum: kinetic energy is that of the centre of mass and that of the motion about it",
          "[motion][momentum]") {
    Numbers numbers;
    for (int i = 0; i < 200; ++i) {
        std::vector<PointMass<double, Vector<double, 3>>> bodies;
        for (int k = 0; k < 5; ++k) bodies.push_back(body_in_space(numbers));
        const auto centre = centre_of_mass_velocity(bodies);
        auto all = 0 * kilogram;
        auto total = 0 * joule, about = 0 * joule;
        std::vector<PointMass<double, Vector<double, 3>>> seen_from_centre;
        for (const auto& body : bodies) {
            all += body.mass;
            total += kinetic_energy(body.mass, body.velocity);
            about += kinetic_energy(body.mass, body.velocity - centre);
            seen_from_centre.push_back({body.mass, body.velocity - centre});
        }
        CHECK(in(kinetic_energy(all, centre) + about, joule) == Catch::Approx(in(total, joule)).epsilon(1e-13));
        // Seen from the centre of mass there is no momentum.
        CHECK(norm(total_momentum(seen_from_centre)) <= 1e-14 * (all * 40 * metre_per_second));
    }
}

TEST_CASE("Momentum: an empty list has none, and no centre of mass", "[motion][momentum]") {
    const std::vector<PointMass<double>> none;
    CHECK(total_momentum(none) == 0 * kilogram_metre_per_second);
    CHECK(refusal([&] { centre_of_mass_velocity(none); }) ==
          "mechanics::centre_of_mass_velocity: the sum of the masses is 0 kg; it must be finite and greater than zero");
}

// Measured, in epsilon: momentum 0.44 of the sum of m (|u| + |v|), the speed of separation 3.2 of |u1| + |u2|,
// energy 2.5 of the sum of all energies; alike in double and float. Bounds 1, 4 and 4.
TEMPLATE_TEST_CASE("Momentum: conserved at every restitution, with masses a milliard apart", "[motion][momentum]",
                   double, float) {
    using S = TestType;
    Numbers numbers;
    const double epsilon = double(std::numeric_limits<S>::epsilon());
    double worst_momentum = 0, largest_ratio = 1;
    for (int i = 0; i < 2000; ++i) {
        const auto before = pair_along_a_line<S>(numbers);
        const S e = i % 4 == 0 ? S(i / 4 % 2) : S(numbers.between(0, 1)); // a quarter of them at 0 or 1 exactly
        const auto [one, other] = collide(before[0], before[1], e);
        const std::array after{one, other};
        CAPTURE(i, e, before[0].mass, before[0].velocity, before[1].mass, before[1].velocity);

        const auto wide = [](auto q) { return scalar_cast<double>(q); };
        auto momentum_scale = 0.0 * newton_second;
        auto energy_before = 0.0 * joule, energy_after = 0.0 * joule, change = 0.0 * joule;
        auto p = 0.0 * newton_second;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto m = wide(before[k].mass);
            const auto u = wide(before[k].velocity), v = wide(after[k].velocity);
            CHECK(after[k].mass == before[k].mass);
            p += m * (v - u);
            momentum_scale += m * (abs(u) + abs(v));
            energy_before += kinetic_energy(m, u);
            energy_after += kinetic_energy(m, v);
            change += 0.5 * m * (v - u) * (v + u);
        }
        const double momentum_error = in(abs(p) / momentum_scale, unit::Dimensionless{}) / epsilon;
        const auto met = wide(before[0].velocity) - wide(before[1].velocity),
                   separated = wide(one.velocity) - wide(other.velocity);
        const auto speed_scale = abs(wide(before[0].velocity)) + abs(wide(before[1].velocity));
        const double speed_error = in(abs(separated + double(e) * met) / speed_scale, unit::Dimensionless{}) / epsilon;
        const double energy_error =
            in(abs(change + wide(energy_lost(before[0], before[1], e))) / (energy_before + energy_after),
               unit::Dimensionless{}) /
            epsilon;
        CHECK(momentum_error <= 1);
        CHECK(speed_error <= 4);
        CHECK(energy_error <= 4);
        CHECK(energy_lost(before[0], before[1], e).value() >= S(0));
        worst_momentum = std::max(worst_momentum, momentum_error);
        largest_ratio = std::max(largest_ratio, double(before[0].mass.value() / before[1].mass.value()));
    }
    CHECK(largest_ratio > 1e8);
    CHECK(worst_momentum > 0); // exactly zero would mean that the reference is the thing itself
}

TEST_CASE("Momentum: a collision is the same seen from a moving train", "[motion][momentum]") {
    Numbers numbers;
    for (int i = 0; i < 1000; ++i) {
        const auto a = body_in_space(numbers), b = body_in_space(numbers);
        const auto train =
            metres_per_second(numbers.between(-50, 50), numbers.between(-50, 50), numbers.between(-50, 50));
        const double e = numbers.between(0, 1);
        const auto here = collide(a, b, e);
        const auto there = collide(PointMass{a.mass, a.velocity + train}, PointMass{b.mass, b.velocity + train}, e);
        CHECK(norm(there.first.velocity - train - here.first.velocity) <= 1e-13 * metre_per_second);
        CHECK(norm(there.second.velocity - train - here.second.velocity) <= 1e-13 * metre_per_second);
        // What is lost does not depend on the frame of reference; the energies themselves do.
        CHECK(in(energy_lost(PointMass{a.mass, a.velocity + train}, PointMass{b.mass, b.velocity + train}, e), joule) ==
              Catch::Approx(in(energy_lost(a, b, e), joule)).epsilon(1e-12));
    }
}

TEST_CASE("Momentum: bodies that move together are not touched", "[motion][momentum]") {
    // The sum of the velocities in place of the difference (notes 2.2.1) would give these two an impulse, and 150 J.
    const auto [a, b] =
        collide(PointMass{2 * kilogram, 5 * metre_per_second}, PointMass{3 * kilogram, 5 * metre_per_second}, 1);
    CHECK(a.velocity == 5 * metre_per_second);
    CHECK(b.velocity == 5 * metre_per_second);
    CHECK(energy_lost(a, b, 0) == 0 * joule);
}

TEST_CASE("Momentum: which of them is called the first, and from which side one counts, changes no bit",
          "[motion][momentum]") {
    Numbers numbers;
    for (int i = 0; i < 500; ++i) {
        const auto [a, b] = pair_along_a_line<double>(numbers);
        const double e = numbers.between(0, 1);
        const auto straight = collide(a, b, e), swapped = collide(b, a, e);
        CHECK(
            (straight.first.velocity == swapped.second.velocity && straight.second.velocity == swapped.first.velocity));
        const auto mirrored = collide(PointMass{a.mass, -a.velocity}, PointMass{b.mass, -b.velocity}, e);
        CHECK((straight.first.velocity == -mirrored.first.velocity &&
               straight.second.velocity == -mirrored.second.velocity));
    }
}

TEST_CASE("Momentum: the two ends of restitution", "[motion][momentum]") {
    const PointMass cart{2 * kilogram, 3 * metre_per_second}, other{1 * kilogram, -3 * metre_per_second};
    const auto stuck = collide(cart, other, 0);
    CHECK(stuck.first.velocity == 1 * metre_per_second); // the velocity of the centre of mass, for both
    CHECK(stuck.second.velocity == 1 * metre_per_second);
    CHECK(stuck.first.velocity == centre_of_mass_velocity(std::array{cart, other}));
    CHECK(energy_lost(cart, other, 0) ==
          12 * joule); // of 13.5 J; momentum, 3 kg m/s before and after, is not dissipated
    const auto bounced = collide(cart, other, 1);
    CHECK(bounced.first.velocity == -1 * metre_per_second);
    CHECK(bounced.second.velocity == 5 * metre_per_second);
    CHECK(energy_lost(cart, other, 1) == 0 * joule);
    // Equal masses exchange their velocities.
    const auto exchanged =
        collide(PointMass{2 * kilogram, 3 * metre_per_second}, PointMass{2 * kilogram, -1 * metre_per_second}, 1);
    CHECK(exchanged.first.velocity == -1 * metre_per_second);
    CHECK(exchanged.second.velocity == 3 * metre_per_second);
}

TEST_CASE("Momentum: against a very heavy body a ball bounces as from a wall", "[motion][momentum]") {
    const PointMass ball{0.1 * kilogram, 7 * metre_per_second}, wall{1e300 * kilogram, 0 * metre_per_second};
    const auto [after, still] = collide(ball, wall, 0.5);
    CHECK(in(after.velocity, metre_per_second) == Catch::Approx(-3.5).epsilon(1e-15));
    CHECK(still.velocity < 1e-299 * metre_per_second);
    CHECK(reduced_mass(ball.mass, wall.mass) == ball.mass);
    CHECK(in(reduced_mass(1e300 * kilogram, 1e300 * kilogram), kilogram) == 5e299); // the product would be infinite
    CHECK(in(reduced_mass(3 * kilogram, 6 * kilogram), kilogram) == Catch::Approx(2).epsilon(1e-15));
}

TEST_CASE("Momentum: a high-precision scalar keeps its digits", "[motion][momentum]") {
    using Fifty =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
    const PointMass a{Fifty(3) * kilogram, Fifty(1) * metre_per_second},
        b{Fifty(7) * kilogram, Fifty(-1) * metre_per_second};
    const auto [after_a, after_b] = collide(a, b, Fifty("0.3"));
    const auto p = momentum(after_a.mass, after_a.velocity) + momentum(after_b.mass, after_b.velocity);
    CHECK(abs(in(p, newton_second) + 4) < Fifty("1e-48"));
    CHECK(abs(in(energy_lost(a, b, Fifty("0.3")), joule) - Fifty("3.822")) <
          Fifty("1e-48")); // 2.1 kg / 2 * 0.91 * 4 m^2/s^2
    const auto energy = kinetic_energy(a.mass, a.velocity);
    CHECK(energy == Fifty("1.5") * joule);
}

TEST_CASE("Momentum: what cannot be a collision is refused with its value", "[motion][momentum]") {
    const PointMass cart{2 * kilogram, 3 * metre_per_second}, other{1 * kilogram, -3 * metre_per_second};
    CHECK(refusal([&] { collide(cart, other, 1.5); }) ==
          "mechanics::collide: restitution is 1.5; it is from 0 (the bodies stay together) to 1 (no energy is lost)");
    CHECK(refusal([&] { collide(cart, other, -0.1); }).find("restitution is -0.1") != std::string::npos);
    CHECK(refusal([&] { collide(cart, other, std::nan("")); }).find("restitution is nan") != std::string::npos);
    CHECK(refusal([&] { energy_lost(cart, other, 2); }).find("restitution is 2") != std::string::npos);
    CHECK(refusal([&] {
              collide(PointMass{0 * kilogram, 3 * metre_per_second}, other, 1);
          }) == "mechanics::collide: mass is 0 kg; it must be finite and greater than zero");
    CHECK(refusal([&] {
              collide(cart, PointMass{-1 * kilogram, 3 * metre_per_second}, 1);
          }) == "mechanics::collide: mass is -1 kg; it must be finite and greater than zero");
    CHECK(refusal([&] {
              collide(cart, PointMass{1 * kilogram, HUGE_VAL * metre_per_second}, 1);
          }) == "mechanics::collide: velocity is inf m/s; it must be finite");
    CHECK(refusal([&] { momentum(-1 * kilogram, 3 * metre_per_second); }) ==
          "mechanics::momentum: mass is -1 kg; it must be finite and greater than zero");
    CHECK(refusal([&] { kinetic_energy(0 * kilogram, 3 * metre_per_second); }).find("mass is 0 kg") !=
          std::string::npos);
    CHECK(refusal([&] { reduced_mass(0 * kilogram, 3 * kilogram); }).find("mass is 0 kg") != std::string::npos);
}

TEST_CASE("a collision of masses at the ends of what a double can hold keeps its digits", "[motion][momentum]") {
    for (const double m : {1e307, 1.0, 1e-307}) {
        const auto [a, b] = mechanics::collide(mechanics::PointMass{m * kilogram, 100.0 * metre_per_second},
                                               mechanics::PointMass{m * kilogram, -100.0 * metre_per_second}, 0.5);
        CAPTURE(m);
        CHECK(a.velocity.value() == Catch::Approx(-50).epsilon(1e-14));
        CHECK(b.velocity.value() == Catch::Approx(50).epsilon(1e-14));
    }
}
