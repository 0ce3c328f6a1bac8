// SPDX-License-Identifier: BSL-1.0
// Which boxes a shape without a box is held against: a plane tells which it misses, and may leave out none that
// touches.

#include "tests/catch.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/collision/unbounded.hpp>
#include <ansatz/world.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace ansatz;

namespace {

template <class S> using Raw = Vector<typename S::Scalar, S::dimension>;

/// What is asked of a shape that tells nothing.
struct Anywhere {};

template <class S> std::vector<std::size_t> near(const Boxes<S>& boxes, const auto* shape, const Raw<S>& x) {
    std::vector<std::size_t> found;
    detail::each_box_near(boxes, boxes.size(), shape, S::Position::from_value(x),
                          [&](std::size_t i) { found.push_back(i); });
    return found;
}

/// Spheres that nearly touch planes of any direction, or are far from them, at this distance from the origin.
template <class S> void check_spheres(double far) {
    using Scalar = typename S::Scalar;
    std::mt19937 numbers(7);
    std::uniform_real_distribution<double> any(-1, 1);
    const auto vector = [&] {
        Raw<S> v;
        for (int k = 0; k < S::dimension; ++k) v[k] = Scalar(any(numbers));
        return v;
    };
    int met = 0, missed = 0;
    for (int n = 0; n < 400; ++n) {
        Eigen::Vector3d up = Eigen::Vector3d::Zero();
        for (int k = 0; k < S::dimension; ++k) up[k] = n % 3 == 0 && k != n % S::dimension ? 0 : any(numbers);
        if (up.norm() < 1e-3) continue;
        const typename Plane::In<S> plane(Plane{up, any(numbers) * metre});
        const Raw<S> at = Scalar(far) * vector();
        Boxes<S> boxes;
        std::vector<Raw<S>> centres;
        std::vector<Sphere::In<S>> balls;
        for (int b = 0; b < 200; ++b) {
            const Sphere::In<S> ball(Sphere{(0.1 + std::abs(any(numbers))) * metre});
            const double ulps = 64 * double(std::numeric_limits<Scalar>::epsilon()) * (1 + far) * any(numbers);
            const double apart = b % 2 == 0 ? ulps : any(numbers); // half of them touch, or do not, by rounding
            const Raw<S> beside = Scalar(far) * vector();
            const Scalar height = plane.height(S::Position::from_value(beside), S::Position::from_value(at)).value();
            const Raw<S> centre = beside + (ball.radius.value() + Scalar(apart) - height) * plane.normal;
            typename S::Position lower, upper;
            ball.bounds(S::Position::from_value(centre), lower, upper);
            boxes.push_back(lower, upper);
            centres.push_back(centre);
            balls.push_back(ball);
        }
        const auto found = near<S>(boxes, &plane, at);
        REQUIRE(std::is_sorted(found.begin(), found.end()));
        for (std::size_t b = 0; b < balls.size(); ++b) {
            Touch<S> touch;
            const bool touches =
                collide<S>(balls[b], S::Position::from_value(centres[b]), plane, S::Position::from_value(at), touch);
            const bool is_near = std::binary_search(found.begin(), found.end(), b);
            if (touches) REQUIRE(is_near);
            ++(is_near ? met : missed);
        }
        CHECK(near<S>(boxes, static_cast<const Plane::In<S>*>(nullptr), at).size() == balls.size());
    }
    // Of those that do not touch most are spared, but far out in float, where all is rounding.
    if (far * double(std::numeric_limits<Scalar>::epsilon()) < 1e-4) CHECK(missed > met / 8);
    CHECK(met > 0);
}

} // namespace

TEST_CASE("A plane is held against every box whose body touches it, however rounding falls", "[collision]") {
    for (const double far : {0.0, 1.0, 1e3, 1e6}) {
        INFO("at " << far << " m");
        check_spheres<Space<double, 3>>(far);
        check_spheres<Space<double, 2>>(far);
        check_spheres<Space<float, 3>>(far);
        check_spheres<Space<float, 2>>(far);
    }
}

TEST_CASE("A plane misses what is above it, and nothing that is below, on it, or no number", "[collision]") {
    using S = Space<double, 2>;
    const Plane::In<S> slope(Plane{Eigen::Vector3d(-3, 4, 0), 2.0 * metre}); // -0.6 x + 0.8 y = 2, from where it is
    const Raw<S> at(1, 1);
    const auto misses = [&](double x0, double y0, double x1, double y1) {
        return slope.misses(Raw<S>(x0, y0), Raw<S>(x1, y1), at);
    };
    CHECK(misses(0, 4, 1, 5));              // (1, 4) is 0.4 m above it
    CHECK_FALSE(misses(0, 3, 2, 5));        // (2, 3) is below
    CHECK_FALSE(misses(0, 2, 1, 3.5));      // so is all of this one
    CHECK_FALSE(misses(-9, -9, 9, 9));      // it goes through this one
    CHECK_FALSE(misses(-0.5, 3.5, 1, 3.5)); // (1, 3.5) is on it
    const double no = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
    CHECK_FALSE(misses(0, no, 1, no));
    CHECK_FALSE(misses(0, endless, 1, endless)); // World::status tells of such a body
}

TEST_CASE("A shape that tells nothing is held against every box", "[collision]") {
    using S = Space<>;
    Boxes<S> boxes;
    for (int n = 0; n < 100; ++n)
        boxes.push_back(S::Position::from_value(Raw<S>(n, 5, 0)), S::Position::from_value(Raw<S>(n + 1, 6, 1)));
    const Anywhere shape;
    CHECK(near<S>(boxes, &shape, Raw<S>::Zero()).size() == 100);
    const Plane::In<S> ground(Plane::ground());
    CHECK(near<S>(boxes, &ground, Raw<S>::Zero()).empty());
    CHECK(near<S>(boxes, &ground, Raw<S>(0, 5, 0)).size() == 100);
    std::size_t count = 0; // no more than it was asked for, in blocks or not
    for (const std::size_t n : {0u, 1u, 63u, 64u, 65u}) {
        detail::each_box_near(boxes, n, &shape, S::Position::from_value(Raw<S>::Zero()), [&](std::size_t i) {
            CHECK(i < n);
            ++count;
        });
    }
    CHECK(count == 0 + 1 + 63 + 64 + 65);
}
