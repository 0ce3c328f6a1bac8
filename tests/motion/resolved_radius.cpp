// SPDX-License-Identifier: BSL-1.0
// The radius within which a motion is resolved (hard case V7): the closed form against a search.

#include <ansatz/motion/integrators/compensated.hpp>
#include <ansatz/motion/integrators/velocity_verlet.hpp>
#include <ansatz/motion/resolved_radius.hpp>

#include "tests/measured.hpp"
#include "tests/motion/support.hpp"
#include "tests/refusal.hpp"

using namespace motion_tests;

namespace {

/// By which share of its way a body of this velocity errs at most in one step, from places of which the largest
/// coordinate is just below `r`.
template <class S, class I> double worst_step(double r, const std::array<double, 3>& v, double dt) {
    using Scalar = typename S::Scalar;
    constexpr bool keeps = detail::contains<PositionRemainder, writes_of<I>>;
    const double places = std::ldexp(r, -std::numeric_limits<Scalar>::digits);
    double most = 0;
    for (const double at : {0.9, 0.75, 0.6}) {
        World world{S{}, I{}};
        const auto start = vector_in<S, unit::Length>(at * r, -at * r, at * r);
        const auto dropped = vector_in<S, unit::Length>(0.45 * places, 0.4 * places, -0.35 * places);
        const auto body = [&] {
            if constexpr (keeps)
                return world.add(position(start), going<S>(v[0], v[1], v[2]), with<PositionRemainder>(dropped));
            else return world.add(position(start), going<S>(v[0], v[1], v[2]));
        }();
        world.step(dt * second);
        long double apart = 0, way = 0;
        for (int k = 0; k < S::dimension; ++k) {
            long double is = static_cast<long double>(world.position(body).value()[k]) - start.value()[k];
            if constexpr (keeps)
                is += static_cast<long double>(world.template read<PositionRemainder>(body).value()[k]) -
                      dropped.value()[k];
            const long double should = static_cast<long double>(Scalar(v[std::size_t(k)])) * Scalar(dt);
            apart += (is - should) * (is - should);
            way += should * should;
        }
        most = std::max(most, double(std::sqrt(apart / way)));
    }
    return most;
}
/// The same for any direction, and any speed up to twice as large.
template <class S, class I> double worst(double r, double speed, double dt) {
    double most = 0;
    for (double faster = 1; faster < 2; faster *= 1.0007) {
        most = std::max(most, worst_step<S, I>(r, {speed * faster, 0, 0}, dt));
        const double along = speed * faster / std::sqrt(double(S::dimension));
        most = std::max(most, worst_step<S, I>(r, {along, -along, S::dimension == 3 ? along : 0}, dt));
    }
    return most;
}
/// The largest power of two within which nothing errs by more than the share.
template <class S, class I> double searched(double speed, double dt, double share) {
    double r = std::ldexp(1.0, -20);
    while (worst<S, I>(2 * r, speed, dt) <= share) r *= 2;
    return r;
}

} // namespace

TEST_CASE("V7: the radius is the one that a search finds", "[motion][far]") {
    double most = 0;
    for_each_type(Types<Space<float, 2>, Space<float, 3>>{}, [&]<class S> {
        for (const double share : {0.01, 0.1})
            for (const auto& [speed, dt] :
                 {std::pair(0.05, 1.0 / 240), std::pair(1.0, 1.0 / 60), std::pair(7.3, 0.002)}) {
                const auto r = resolved_radius<S>(speed * metre_per_second, dt * second, share).value();
                const double found = searched<S, SemiImplicitEuler>(speed, dt, share);
                INFO(speed << " m/s, " << dt << " s, " << share << ": " << r << " m, found " << found << " m");
                if (share == 0.01) CHECK(r == found);
                CHECK(r <= found);
                CHECK(found <= 2 * r); // a few places a step: the next half of one may be some way off
                most = std::max(most, worst<S, VelocityVerlet>(r, speed, dt) / share);
            }
    });
    CHECK(test::measured("V7", "inside the radius: the largest error of a way, over what was declared", most,
                         test::at_most(1), ""));
    const double r = resolved_radius<Space<double, 3>>(0.05 * metre_per_second, 1.0 / 240 * second).value();
    CHECK(r == std::ldexp(32.0, 29));
    CHECK(worst<Space<double, 3>, SemiImplicitEuler>(r, 0.05, 1.0 / 240) <= 0.01);
    CHECK(worst<Space<double, 3>, SemiImplicitEuler>(2 * r, 0.05, 1.0 / 240) > 0.01);
}
TEST_CASE("V7: a compensated float resolves to the square of its digits", "[motion][far]") {
    using S = Space<float, 2>;
    using I = Compensated<SemiImplicitEuler>;
    const auto r = resolved_radius<S, I>(0.05 * metre_per_second, 1.0 / 240 * second);
    CHECK(r == std::ldexp(1.0, 24) * resolved_radius<S>(0.05 * metre_per_second, 1.0 / 240 * second));
    CHECK(r.value() > 1e7);
    CHECK(worst<S, I>(r.value(), 0.05, 1.0 / 240) <= 0.01);
    CHECK(worst<S, I>(4 * r.value(), 0.05, 1.0 / 240) > 0.01); // the control
}
TEST_CASE("V7: half the step is half the radius, and a share ten times as small eight or sixteen times",
          "[motion][far]") {
    using S = Space<float, 3>;
    const auto v = 0.05 * metre_per_second;
    const auto dt = 1.0 / 240 * second;
    CHECK(resolved_radius<S>(v, 0.5 * dt) == 0.5 * resolved_radius<S>(v, dt));
    CHECK(resolved_radius<S>(2.0 * v, dt) == 2.0 * resolved_radius<S>(v, dt));
    CHECK(resolved_radius<Space<double>, VelocityVerlet>(v, dt) == std::ldexp(1.0, 29) * resolved_radius<S>(v, dt));
    CHECK(resolved_radius<S>(v, 1e-40 * second).value() == 0);
}
TEST_CASE("V7: what is no speed, step or share is refused", "[motion][far]") {
    using S = Space<float, 3>;
    const auto ask = [](double v, double dt, double share) {
        return test::refusal([=] { resolved_radius<S>(v * metre_per_second, dt * second, share); });
    };
    CHECK(ask(0, 1, 0.01) == "resolved_radius: speed is 0 m/s; it must be finite and greater than zero");
    CHECK(ask(1, -1, 0.01) == "resolved_radius: dt is -1 s; it must be finite and greater than zero");
    for (const double share : {0.0, 1.0, 1e-6, std::nan("")})
        CHECK_THAT(ask(1, 1, share),
                   Catch::Contains("share") && Catch::Contains("at least 1.9") && Catch::Contains("less than 1"));
}
