// SPDX-License-Identifier: BSL-1.0
// Ways: the greatest speed and acceleration hold in steps of any length, the time is that of the ideal profile, and cut
// corners stay where they may.

#include <ansatz/paths/walking/way.hpp>

#include "tests/catch.hpp"

#include <ansatz/world/space.hpp>

#include <cmath>
#include <random>
#include <vector>

using namespace ansatz;
using namespace ansatz::paths;

namespace {

/// A way of random legs.
/// \param sharpest the largest turn at a corner, rad
template <class S>
Way<S> random_way(std::mt19937& random, int legs, double sharpest, double speed, double acceleration, double share) {
    using Scalar = typename S::Scalar;
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Way<S> way;
    Vector<double, S::dimension> at = Vector<double, S::dimension>::Zero(), to = at;
    to[0] = 1;
    for (int i = 0; i <= legs; ++i) {
        way.corners.push_back(S::Position::from_value(at.template cast<Scalar>()));
        way.cuts.push_back(S::Length::from_value(Scalar(uniform(0, 1) < share ? uniform(0.1, 3) : 0)));
        const double turn = uniform(-sharpest, sharpest);
        Vector<double, S::dimension> side = Vector<double, S::dimension>::Random();
        for (int k = 0; k < S::dimension; ++k) side[k] = uniform(-1, 1);
        side -= side.dot(to) * to;
        to = std::cos(turn) * to + std::sin(turn) * side.normalized();
        at += uniform(0.5, 10) * to;
    }
    way.speed = S::Speed::from_value(Scalar(speed));
    way.acceleration = Way<S>::Acceleration::from_value(Scalar(acceleration));
    way.prepare();
    return way;
}

/// The time of the ideal along the same line: the fastest profile of the pace for which the acceleration, all of it, is
/// nowhere above the greatest. Made by going over a fine division forwards and backwards; nobody is quicker than it.
template <class S> double ideal_time(const Way<S>& way) {
    std::vector<double> end{0};
    for (std::uint32_t k = 1; k <= way.last(); ++k) end.push_back(end.back() + double(way.length(k).value()));
    const int parts = 20000;
    const double all = end.back(), step = all / parts, a = double(way.acceleration.value());
    std::vector<double> v(parts + 1, double(way.speed.value())); // the pace at each place
    struct At {
        double pace = 1e300, side = 0, slope = 1; // of the corner; of r'' along r', and the square of |r'|
    };
    std::vector<At> at(parts + 1);
    for (std::uint32_t k = 1; k < way.last(); ++k) {
        const double turn = double((way.direction(k + 1) - way.direction(k)).norm()), cut = double(way.cuts[k].value());
        if (turn < 1e-5) continue;
        const double half = turn / 2, from = end[k] - cut;
        for (int i = std::max(0, int(std::ceil(from / step))); i <= parts && i * step <= end[k] + cut; ++i) {
            const double q = (i * step - from) / (2 * cut);
            at[std::size_t(i)] = {std::sqrt(2 * a * cut / turn), half * (2 * q - 1), 1 - 4 * half * half * q * (1 - q)};
            v[std::size_t(i)] = std::min(v[std::size_t(i)], at[std::size_t(i)].pace);
        }
        if (cut == 0) v[std::size_t(std::lround(end[k] / step))] = 0;
    }
    // |w^2 n + w' T| <= a, with n = r'' and T = r' of the line by its length, solved for w'.
    const auto along = [&](int i, double sign) {
        const At& here = at[std::size_t(i)];
        const double c = std::min(1.0, v[std::size_t(i)] * v[std::size_t(i)] / (here.pace * here.pace));
        const double root = c * c * here.side * here.side + here.slope * (1 - c * c);
        return a * std::max(0.0, -sign * c * here.side + std::sqrt(root)) / std::max(1e-6, here.slope);
    };
    v.front() = v.back() = 0;
    for (int i = 1; i <= parts; ++i) {
        const auto k = std::size_t(i);
        v[k] = std::min(v[k], std::sqrt(v[k - 1] * v[k - 1] + 2 * along(i - 1, 1) * step));
    }
    for (int i = parts; i-- > 0;) {
        const auto k = std::size_t(i);
        v[k] = std::min(v[k], std::sqrt(v[k + 1] * v[k + 1] + 2 * along(i + 1, -1) * step));
    }
    double time = 0;
    for (int i = 0; i < parts; ++i) time += 2 * step / (v[std::size_t(i)] + v[std::size_t(i + 1)]);
    return time;
}

} // namespace

TEMPLATE_TEST_CASE("no step of a way is too fast, and no two differ by more than a dt", "[walking]", (Space<double, 2>),
                   (Space<double, 3>), (Space<float, 2>), (Space<float, 3>)) {
    using S = TestType;
    const double eps = std::numeric_limits<typename S::Scalar>::epsilon();
    std::mt19937 random(3);
    for (const double speed : {0.1, 1.0, 10.0})
        for (const double dt : {0.01, 0.1, 1.0})
            for (int i = 0; i < 4; ++i) {
                const double a = 0.7;
                const auto way = random_way<S>(random, 8, 3.1, speed, a, 0.7);
                typename Way<S>::Moment m;
                auto x = way.place(m);
                auto v = S::template zero_vector<unit::Velocity>();
                const auto h = S::Time::from_value(typename S::Scalar(dt));
                const double rounding = 64 * eps * 80 / dt; // of a place, over a step
                double time = 0;
                for (bool more = true; more && time < 5000; time += dt) {
                    more = !way.is_end(m);
                    auto middle = m;
                    way.advance(middle, typename S::Time(typename S::Scalar(0.5) * h));
                    way.advance(m, h);
                    const auto next = way.place(m);
                    const typename S::Velocity u = (next - x) / h;
                    REQUIRE(double(norm(u).value()) <= speed * (1 + 1e-5) + rounding);
                    REQUIRE(double(norm(u - v).value()) <= a * dt * (1 + 1e-4) + rounding);
                    const auto chord = typename S::Scalar(0.5) * (x + next);
                    REQUIRE(double(norm(way.place(middle) - chord).value()) <=
                            a * dt * dt / 8 * (1 + 1e-4) + rounding * dt);
                    x = next, v = u;
                }
                CHECK(way.is_end(m));
                CHECK(norm(x - way.corners.back()).value() == 0);
                CHECK(v.value().squaredNorm() == 0);
            }
}

TEST_CASE("the time is that of the ideal profile: straight, gentle, and with any corners", "[walking]") {
    using S = Space<double, 2>;
    std::mt19937 random(5);
    double straight = 0, gentle = 0, any = 0, stops = 0;
    for (const double speed : {0.2, 1.0, 5.0, 20.0})
        for (int i = 0; i < 25; ++i) {
            const auto ratio = [&](const Way<S>& way) { return way.time_left({}).value() / ideal_time(way); };
            straight = std::max(straight, ratio(random_way<S>(random, 1, 0, speed, 1.3, 1)));
            const double turn =
                std::min(0.5, 0.8 * 2 * 1.3 * 0.1 / (speed * speed)); // that no corner is too tight for it
            gentle = std::max(gentle, ratio(random_way<S>(random, 8, turn, speed, 1.3, 1)));
            any = std::max(any, ratio(random_way<S>(random, 8, 3.1, speed, 1.3, 1)));
            stops = std::max(stops, ratio(random_way<S>(random, 8, 3.1, speed, 1.3, 0.5)));
        }
    CHECK(straight <= 1.001); // the ideal is made of 20000 parts
    CHECK(gentle <= 1.05);
    CHECK(any <= 1.2);
    CHECK(stops <= 1.2);
}

TEST_CASE("a cut corner is left by no more than it may, and is within its triangle", "[walking]") {
    using S = Space<double, 3>;
    std::mt19937 random(9);
    for (int i = 0; i < 50; ++i) {
        const auto way = random_way<S>(random, 2, 3.0, 3, 2, 1);
        const auto d1 = way.direction(1), d2 = way.direction(2);
        const double t = way.cuts[1].value(), size = (d2 - d1).norm();
        double nearest = 1e9;
        for (int k = 0; k <= 1000; ++k) {
            Way<S>::Moment m{1, way.length(1) - way.cuts[1] + (2.0 * k / 1000) * way.cuts[1], {}};
            const Eigen::Vector3d off = (way.place(m) - way.corners[1]).value();
            nearest = std::min(nearest, off.norm());
            // off = -u d1 + w d2 with u, w >= 0 and u + w <= t
            const double c = d1.dot(d2), p = off.dot(d1), q = off.dot(d2), det = c * c - 1;
            const double w = (c * p - q) / det, u = (p - c * q) / det;
            CHECK(u > -1e-9);
            CHECK(w > -1e-9);
            CHECK(u + w < t * (1 + 1e-9) + 1e-9);
            CHECK((off + u * d1 - w * d2).norm() < 1e-9);
        }
        CHECK(nearest == Approx(t * size / 4).epsilon(1e-5).margin(1e-9));
    }
}

TEST_CASE("a way is gone alike in steps of any length, and what is left of it adds up", "[walking]") {
    using S = Space<double, 2>;
    std::mt19937 random(2);
    for (int i = 0; i < 20; ++i) {
        const auto way = random_way<S>(random, 6, 2.5, 4, 1, 0.8);
        const double all = way.time_left({}).value();
        Way<S>::Moment one, many;
        way.advance(one, 0.6 * all * second);
        std::uniform_real_distribution<double> part(0, 0.02);
        double done = 0;
        while (done < 0.6 * all) {
            const double h = std::min(part(random) * all, 0.6 * all - done);
            way.advance(many, h * second);
            done += h;
        }
        CHECK(norm(way.place(one) - way.place(many)).value() < 1e-6 * way.left({}).value());
        CHECK(way.time_left(one).value() == Approx(0.4 * all).epsilon(1e-6));
    }
}

TEST_CASE("who brakes comes to rest on the way, and slower than the acceleration allows nowhere", "[walking]") {
    using S = Space<double, 2>;
    std::mt19937 random(4);
    for (int i = 0; i < 40; ++i) {
        const auto way = random_way<S>(random, 6, 2.5, 4, 1.5, 0.8);
        Way<S>::Moment m;
        way.advance(m, std::uniform_real_distribution<double>(0, 1)(random) * way.time_left({}));
        const auto from = m;
        const double dt = 0.01;
        auto before = way.place(m);
        auto ahead = m;
        way.brake(ahead, 1e-6 * second);
        Eigen::Vector2d v = (way.place(ahead) - before).value() / 1e-6;
        double longest = 0;
        for (; m.pace.value() > 0 && longest < 20; longest += dt) {
            way.brake(m, dt * second);
            const Eigen::Vector2d u = (way.place(m) - before).value() / dt;
            CHECK((u - v).norm() <= 1.5 * dt * (1 + 1e-4) + 1e-5);
            v = u;
            before = way.place(m);
        }
        CHECK(m.pace.value() == 0);
        Way<S>::Moment whole = from;
        way.brake(whole, 1e9 * second);
        CHECK(norm(way.place(whole) - way.place(m)).value() < 1e-9);
    }
}
