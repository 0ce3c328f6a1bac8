// SPDX-License-Identifier: BSL-1.0
// How much of a shape is under water: against thin slices, and between its limits.

#include <ansatz/water/submerged.hpp>

#include "tests/catch.hpp"
#include "tests/refusal.hpp"

#include <limits>
#include <random>
#include <vector>

using namespace ansatz;
using namespace ansatz::test;
using Catch::Approx;

namespace {

constexpr double pi = std::numbers::pi;

/// Volume and moment of what lies below `d`, from slices whose area is given, by Gauss' rule of two points in each.
template <class Area> std::pair<double, double> slices(double height, double depth, const Area& area) {
    const double d = std::min(height, std::max(0.0, depth));
    const int n = 20000;
    double volume = 0, moment = 0;
    for (int i = 0; i < n; ++i)
        for (const double at : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
            const double y = d * (i + at) / n, part = area(y) * d / n / 2;
            volume += part;
            moment += part * y;
        }
    return {volume, volume > 0 ? moment / volume : 0.0};
}

} // namespace

TEST_CASE("a sphere, a box and a disc are what their slices sum to", "[water]") {
    const double r = 0.7;
    for (const double d : {-0.3, 0.0, 1e-3, 0.1, 0.4, 0.7, 1.0, 1.39, 1.4, 2.0}) {
        CAPTURE(d);
        const auto [v, c] = slices(2 * r, d, [&](double y) { return pi * y * (2 * r - y); });
        const auto sphere = submerged(Sphere{r * metre}, d * metre);
        CHECK(sphere.volume.value() == Approx(v).margin(1e-15).epsilon(1e-10));
        if (d > 0) CHECK(sphere.centre.value() == Approx(c).epsilon(1e-8));
        const auto [w, b] = slices(1.2, d, [](double) { return 0.8 * 2.0; });
        const auto box = submerged(Box{metres(0.4, 0.6, 1.0)}, d * metre);
        CHECK(box.volume.value() == Approx(w).margin(1e-15).epsilon(1e-12));
        CHECK(box.centre.value() == Approx(b).margin(1e-15).epsilon(1e-12));
        const auto [a, m] = slices(2 * r, d, [&](double y) { return 2 * std::sqrt(y * (2 * r - y)) * 3.0; });
        const auto disc = detail::sunk_disc(r, 3.0, d);
        CHECK(disc.volume == Approx(a).margin(1e-12).epsilon(1e-5));
        if (d > 0.05) CHECK(disc.centre == Approx(m).epsilon(1e-5));
    }
}
TEMPLATE_TEST_CASE("a disc that hardly touches the water is a little under it, and there", "[water]", float, double) {
    using Scalar = TestType;
    const double r = double(Scalar(0.7));
    // Segment less triangle loses 1 / x^2 of the digits, and five terms of the series leave x^5: at worst they are
    // equal.
    const double known = 4 * std::pow(std::numeric_limits<Scalar>::epsilon(), 0.6);
    for (double d = 2 * r; d > 1e-13; d *= 0.6) {
        const Scalar depth(d), radius(r);
        CAPTURE(depth);
        // By the angle: y = 2 r sin^2. There are no roots then, and slices of it are as exact as one likes.
        const double x = std::min(1.0, double(depth) / (2 * r)), angle = std::asin(std::sqrt(x));
        const auto sine = [](double a, int n) { return std::pow(std::sin(a), n) * std::cos(a) * std::cos(a); };
        const double area = 16 * r * r * slices(2, angle, [&](double a) { return sine(a, 2); }).first,
                     moment = 32 * r * r * r * slices(2, angle, [&](double a) { return sine(a, 4); }).first;
        const auto disc = detail::sunk_disc(radius, Scalar(3), depth);
        REQUIRE(double(disc.volume) == Approx(3 * area).epsilon(known));
        REQUIRE(double(disc.centre) == Approx(moment / area).epsilon(known));
    }
}
TEST_CASE("the area at the water line is how the volume grows", "[water]") {
    const double step = 1e-6;
    for (const double d : {0.05, 0.3, 0.5, 0.9}) {
        CAPTURE(d);
        auto grows = [&](auto&& volume) { return (volume(d + step) - volume(d - step)) / (2 * step); };
        const Sphere ball{0.5 * metre};
        const Box box{metres(0.3, 0.6, 0.2)};
        CHECK(submerged(ball, d * metre).waterline.value() ==
              Approx(grows([&](double at) { return submerged(ball, at * metre).volume.value(); })).epsilon(1e-7));
        CHECK(submerged(box, d * metre).waterline.value() ==
              Approx(grows([&](double at) { return submerged(box, at * metre).volume.value(); })).epsilon(1e-7));
        CHECK(detail::sunk_disc(0.5, 2.0, d).waterline ==
              Approx(grows([](double at) { return detail::sunk_disc(0.5, 2.0, at).volume; })).epsilon(1e-6));
    }
}
TEST_CASE("all of it is under water, or nothing, exactly", "[water]") {
    const Sphere ball{0.5 * metre};
    CHECK(submerged(ball, 1.0 * metre).volume.value() == Approx(4.0 / 3 * pi * 0.125).epsilon(1e-15));
    CHECK(submerged(ball, 9.0 * metre).centre.value() == 0.5);
    CHECK(submerged(ball, 9.0 * metre).waterline == 0.0 * square_metre);
    CHECK(submerged(ball, -1.0 * metre).volume == 0.0 * cubic_metre);
    // Rotation is no part of this version: the box of a known set of tests, upright, is 1152 in all and 576 by half.
    const Box box{metres(4, 6, 6)};
    CHECK(submerged(box, 12.0 * metre).volume == 1152.0 * cubic_metre);
    CHECK(submerged(box, 6.0 * metre).volume == 576.0 * cubic_metre);
    CHECK(submerged(box, 6.0 * metre).centre == 3.0 * metre);
}
TEST_CASE("scales: lengths by a factor, volumes by its cube", "[water]") {
    for (const double s : {1e-3, 1e3}) {
        const auto one = submerged(Sphere{0.5 * metre}, 0.3 * metre);
        const auto other = submerged(Sphere{0.5 * s * metre}, 0.3 * s * metre);
        CHECK((other.volume / one.volume) == Approx(s * s * s).epsilon(1e-13));
        CHECK((other.centre / one.centre) == Approx(s).epsilon(1e-13));
    }
}
TEST_CASE("what has no size, or no depth, is refused", "[water]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal([] { submerged(Sphere{0.0 * metre}, 1.0 * metre); }).find("radius is 0") != std::string::npos);
    CHECK(refusal([] { submerged(Box{metres(1, 0, 1)}, 1.0 * metre); }).find("half") != std::string::npos);
    CHECK(refusal([&] { submerged(Sphere{1.0 * metre}, nan * metre); }).find("depth") != std::string::npos);
    CHECK(refusal([&] { submerged(Box{metres(1, 1, 1)}, nan * metre); }).find("depth") != std::string::npos);
}
namespace {
/// The volume of a box under a plane by inclusion and exclusion of its corners (R. Scardovelli, S. Zaleski, 2000), for
/// a normal without a zero, and the centroid by the same of the next power.
std::pair<double, Vector<double, 3>> by_corners(const Vector<double, 3>& half, Vector<double, 3> n, double d) {
    n /= n.norm();
    const double product = std::abs(n[0] * n[1] * n[2]);
    double volume = 0;
    Vector<double, 3> moment(0, 0, 0);
    for (int corner = 0; corner < 8; ++corner) {
        Vector<double, 3> at, inwards;
        double sign = 1;
        for (int k = 0; k < 3; ++k) {
            const bool far = (corner >> k & 1) != 0; // the lowest corner is none of them far
            inwards[k] = n[k] > 0 ? 1 : -1;
            at[k] = (far ? 1 : -1) * inwards[k] * half[k];
            sign *= far ? -1 : 1;
        }
        const double depth = std::max(0.0, d - n.dot(at)), cone = sign * depth * depth * depth / (6 * product);
        volume += cone;
        for (int k = 0; k < 3; ++k) moment[k] += cone * (at[k] + inwards[k] * depth / std::abs(n[k]) / 4);
    }
    return {volume, moment / volume};
}
} // namespace

TEST_CASE("a box under a tilted surface: exact volume and centroid (hard case B8)", "[water]") {
    // A box of 1, 2, 3 m, scaled by 2, -3 and 4: it is its own mirror image, of 1152 m^3.
    const Box box{metres(2, 6, 12)};
    const Vector<double, 3> half(2, 6, 12);
    const auto all = submerged(box, {0, 1, 0}, 7.0 * metre);
    CHECK(all.volume.value() == Approx(1152).epsilon(1e-14));
    CHECK(all.centre.value().norm() < 1e-12);
    const auto lower = submerged(box, {0, 1, 0}, 0.0 * metre);
    CHECK(lower.volume.value() == Approx(576).epsilon(1e-14));
    CHECK(lower.centre.value().isApprox(Vector<double, 3>(0, -3, 0), 1e-14));
    CHECK(submerged(box, {0, -1, 0}, 0.0 * metre).centre.value().isApprox(Vector<double, 3>(0, 3, 0), 1e-14));
    CHECK(submerged(box, {0.3, 1, 0.2}, -9.0 * metre).volume.value() == Approx(0).margin(1e-12));
    // Along each axis and between each two, upwards and downwards, through the middle: half of it, and both halves
    // balance.
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                if (std::abs(x) + std::abs(y) + std::abs(z) == 0 || std::abs(x) + std::abs(y) + std::abs(z) == 3)
                    continue;
                const Vector<double, 3> n(x, y, z);
                const auto one = submerged(box, n, 0.0 * metre),
                           other = submerged(box, Vector<double, 3>(-n), 0.0 * metre);
                CHECK(one.volume.value() == Approx(576).epsilon(1e-12));
                CHECK((one.centre.value() + other.centre.value()).norm() < 1e-12);
                CHECK(n.dot(one.centre.value()) < 0);
            }
    std::mt19937 random(9);
    std::uniform_real_distribution<double> part(-1, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        Vector<double, 3> n(part(random), part(random), part(random));
        if (n.cwiseAbs().minCoeff() < 0.05) continue; // the formula of corners divides by it, and loses its digits
        const double d = 8 * part(random);
        const auto now = submerged(box, n, d * metre);
        const auto [volume, centre] = by_corners(half, n, d);
        if (volume < 1) continue;
        REQUIRE(now.volume.value() == Approx(volume).epsilon(1e-9));
        REQUIRE((now.centre.value() - centre).norm() < 1e-7);
        const auto above = submerged(box, Vector<double, 3>(-n), -d * metre); // what is not under is above
        REQUIRE(now.volume.value() + above.volume.value() == Approx(1152).epsilon(1e-12));
        REQUIRE((now.volume.value() * now.centre.value() + above.volume.value() * above.centre.value()).norm() < 1e-9);
    }
    // Level, it is the upright box's.
    const auto upright = submerged(box, 4.5 * metre);
    const auto level = submerged(box, {0, 3, 0}, -1.5 * metre);
    CHECK(level.volume.value() == Approx(upright.volume.value()).epsilon(1e-14));
    CHECK(level.centre.value()[1] + 6 == Approx(upright.centre.value()));
    auto said = [&](const Vector<double, 3>& n, double d) { return refusal([&] { submerged(box, n, d * metre); }); };
    CHECK(said({0, 0, 0}, 1).find("length of the normal is 0") != std::string::npos);
    CHECK(said({0, 1, 0}, std::numeric_limits<double>::quiet_NaN()).find("height is nan") != std::string::npos);
}

TEST_CASE("a box that a tilted surface hardly touches is a little under water, and there", "[water]") {
    std::mt19937 random(10);
    std::normal_distribution<double> any;
    std::uniform_real_distribution<double> digits(0, 12);
    int corners = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Vector<double, 3> half(std::exp(any(random)), std::exp(any(random)), std::exp(any(random)));
        const Box box{VectorQuantity<unit::Length>::from_value(half)};
        const Vector<double, 3> n = Vector<double, 3>(any(random), any(random), any(random)).normalized(),
                                m = n.cwiseAbs();
        const double reach = m.dot(half), depth = reach * std::pow(10, -digits(random)), d = depth - reach;
        CAPTURE(trial, depth / reach);
        const auto now = submerged(box, n, d * metre), above = submerged(box, Vector<double, 3>(-n), -d * metre);
        REQUIRE(now.volume >= 0.0 * cubic_metre);
        REQUIRE(now.volume.value() + above.volume.value() == Approx(8 * half.prod()).epsilon(1e-12));
        REQUIRE((now.centre.value().cwiseAbs().array() <= half.array()).all());
        if (depth > (2 * m.cwiseProduct(half)).minCoeff()) continue;
        ++corners; // one corner is under: a pyramid. A height is known to the rounding of the reach.
        const double known = 50 * std::numeric_limits<double>::epsilon() * reach / depth;
        const Vector<double, 3> corner = (n.array() > 0).select(-half, half),
                                inwards = (n.array() > 0).select(Vector<double, 3>::Ones(), -Vector<double, 3>::Ones());
        const Vector<double, 3> sides = depth * m.cwiseInverse();
        REQUIRE(now.volume.value() == Approx(sides.prod() / 6).epsilon(known));
        const Vector<double, 3> expected = corner + inwards.cwiseProduct(sides) / 4;
        REQUIRE((now.centre.value() - expected).cwiseQuotient(sides).norm() < 4 * known);
    }
    CHECK(corners > 10000);
}

TEST_CASE("the normal of a tilted surface is of any length", "[water]") {
    const Box box{metres(1, 2, 3)};
    const auto one = submerged(box, {1, 2, -1}, 0.5 * metre);
    for (const double length : {1e-310, 1e-200, 1e-3, 1e200, 1e307}) {
        const auto other = submerged(box, Vector<double, 3>(length, 2 * length, -length), 0.5 * metre);
        CHECK(other.volume.value() == Approx(one.volume.value()).epsilon(1e-12));
        CHECK((other.centre.value() - one.centre.value()).norm() < 1e-12);
    }
    const double beyond = std::numeric_limits<double>::infinity();
    CHECK(refusal([&] {
              submerged(box, {beyond, 0, 0}, 0.0 * metre);
          }).find("length of the normal") != std::string::npos);
}
