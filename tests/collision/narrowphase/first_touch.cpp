// SPDX-License-Identifier: BSL-1.0
// When two moving shapes first touch: the closed forms against bisection on thousands of seeded cases, and their
// limits.
// Runs long with the sanitizers.

#include "tests/collision/support.hpp"

#include <ansatz/collision/narrowphase/first_touch.hpp>

#include <random>

using namespace collision_tests;

namespace {

/// How far two shapes are apart, for x = x_a - x_b, in double; negative inside. Convex in x, so that along a line it
/// has one lowest place.
double gap(const Sphere& a, const Sphere& b, const Eigen::Vector3d& x) {
    return x.norm() - in(a.radius, metre) - in(b.radius, metre);
}
double gap(const Sphere& a, const Plane& b, const Eigen::Vector3d& x) {
    return x.dot(b.normal.value()) - in(b.offset, metre) - in(a.radius, metre);
}
double gap(const Sphere& a, const Box& b, const Eigen::Vector3d& x) {
    const Eigen::Vector3d h = VectorQuantity<unit::Length, 3>(b.half).value();
    return (x - x.cwiseMin(h).cwiseMax(-h)).norm() - in(a.radius, metre);
}
double gap(const Box& a, const Plane& b, const Eigen::Vector3d& x) {
    const Eigen::Vector3d h = VectorQuantity<unit::Length, 3>(a.half).value();
    return x.dot(b.normal.value()) - in(b.offset, metre) - h.dot(b.normal.value().cwiseAbs());
}
double gap(const Box& a, const Box& b, const Eigen::Vector3d& x) {
    const Eigen::Vector3d h =
        (VectorQuantity<unit::Length, 3>(a.half) + VectorQuantity<unit::Length, 3>(b.half)).value();
    return (x.cwiseAbs() - h).maxCoeff();
}

/// The first time in [0, 1] at which a convex function comes down to zero, by bisection; 2, if it does not. It is
/// positive at 0.
template <class F> double bisected(const F& f, double& lowest) {
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) { // the lowest place, by thirds
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        f(a) <= f(b) ? high = b : low = a;
    }
    double inside = f(1) <= f(low) ? 1 : low;
    lowest = f(inside);
    if (lowest > 0) return 2;
    double outside = 0;
    for (int i = 0; i < 200; ++i) {
        const double middle = (outside + inside) / 2;
        f(middle) > 0 ? outside = middle : inside = middle;
    }
    return inside;
}

struct Random {
    std::mt19937 engine;
    /// A number that a float holds exactly, too.
    double operator()(double low, double high) {
        return double(float(low + (high - low) * double(engine()) / 4294967295.0));
    }
    template <class S> Eigen::Vector3d vector(double size) {
        Eigen::Vector3d v((*this)(-size, size), (*this)(-size, size), (*this)(-size, size));
        if (S::dimension == 2) v[2] = 0;
        return v;
    }
};
template <class S> auto metres_of(const Eigen::Vector3d& v) { return vector_in<S, unit::Length>(v[0], v[1], v[2]); }

/// Compares on cases of every density: a, b made anew by a function of the random numbers.
template <class S, class Make> void compare(const char* name, const Make& make) {
    INFO(name);
    Random random{std::mt19937(7)};
    int hits = 0, misses = 0;
    for (int n = 0; n < 4000; ++n) {
        const auto made = make(random);
        const auto& a = std::get<0>(made); // clang 14 captures no structured binding
        const auto& b = std::get<1>(made);
        const Eigen::Vector3d xa = random.vector<S>(2), da = random.vector<S>(n % 3 == 0 ? 1 : 12),
                              xb = random.vector<S>(2), db = random.vector<S>(2);
        const auto apart = [&](double t) { return gap(a, b, Eigen::Vector3d((xa - xb) + t * (da - db))); };
        if (!(apart(0) > 1e-4)) continue;
        double lowest = 0;
        const double time = bisected(apart, lowest);
        if (std::abs(lowest) < rounding<S>(400)) continue; // they graze within rounding: both answers are right
        const auto first = impact(a, metres_of<S>(xa), metres_of<S>(da), b, metres_of<S>(xb), metres_of<S>(db));
        INFO("case " << n << ", lowest " << lowest << ", bisected " << time << ", closed form "
                     << (first ? double(first->time) : 2));
        REQUIRE(first.has_value() == (time <= 1));
        ++(first ? hits : misses);
        if (!first) continue;
        const double t = double(first->time);
        CHECK(std::abs(apart(t)) <= rounding<S>(200)); // they touch then
        const double closing = (apart(t) - apart(t - 1e-6)) / 1e-6;
        const double slow = std::max(1.0, 1 / std::max(-closing, 1e-3)); // what a rounding of the gap is in time
        CHECK(std::abs(t - time) <= rounding<S>(400) * slow);
        CHECK(std::abs(double(first->normal.norm()) - 1) <= rounding<S>(4));
        // The normal is how the gap grows.
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (int k = 0; k < S::dimension; ++k) normal[k] = double(first->normal[k]);
        const Eigen::Vector3d between = (xa - xb) + t * (da - db);
        CHECK(std::abs(gap(a, b, Eigen::Vector3d(between + 1e-3 * normal)) - gap(a, b, between) - 1e-3) <=
              (std::is_same_v<typename S::Scalar, float> ? 1e-5 : 1e-9));
        // Seen the other way round it is the same.
        const auto other = impact(b, metres_of<S>(xb), metres_of<S>(db), a, metres_of<S>(xa), metres_of<S>(da));
        REQUIRE(other);
        CHECK(std::abs(double(other->time) - t) <= rounding<S>(16));
        CHECK(double((other->normal + first->normal).norm()) <= rounding<S>(64));
        const auto place = (metres_of<S>(xa) + first->time * metres_of<S>(da) + first->arm).value(),
                   same = (metres_of<S>(xb) + other->time * metres_of<S>(db) + other->arm).value();
        CHECK(double((place - same).norm()) <= rounding<S>(400) * slow);
    }
    CHECK(hits > 100);
    CHECK(misses > 100);
}
template <class S> Box random_box(Random& r) {
    if constexpr (S::dimension == 2) return Box{metres(r(0.05, 1), r(0.05, 1))};
    else return Box{metres(r(0.05, 1), r(0.05, 1), r(0.05, 1))};
}
/// The same with a third length, for the oracle.
Box solid(const Box& box) {
    const auto& h = box.half.value();
    return Box{metres(h[0], h[1], h[2])};
}
Plane random_plane(Random& r, bool flat) {
    Eigen::Vector3d n(r(-1, 1), r(-1, 1), flat ? 0 : r(-1, 1));
    return Plane{n.normalized(), r(-4, -2) * metre};
}
} // namespace

TEST_CASE("C20: when two first touch is what bisection says, for every pair of shapes", "[collision][swept]") {
    for_each_type(Types<Space<double, 3>, Space<float, 3>>{}, []<class S>() {
        compare<S>("sphere, sphere",
                   [](Random& r) { return std::pair(Sphere{r(0.05, 1) * metre}, Sphere{r(0.05, 1) * metre}); });
        compare<S>("sphere, plane",
                   [](Random& r) { return std::pair(Sphere{r(0.05, 1) * metre}, random_plane(r, false)); });
        compare<S>("sphere, box",
                   [](Random& r) { return std::pair(Sphere{r(0.05, 1) * metre}, solid(random_box<S>(r))); });
        compare<S>("box, plane", [](Random& r) { return std::pair(solid(random_box<S>(r)), random_plane(r, false)); });
        compare<S>("box, box", [](Random& r) { return std::pair(solid(random_box<S>(r)), solid(random_box<S>(r))); });
    });
    for_each_type(Types<Space<double, 2>, Space<float, 2>>{}, []<class S>() {
        compare<S>("sphere, sphere",
                   [](Random& r) { return std::pair(Sphere{r(0.05, 1) * metre}, Sphere{r(0.05, 1) * metre}); });
        compare<S>("sphere, plane",
                   [](Random& r) { return std::pair(Sphere{r(0.05, 1) * metre}, random_plane(r, true)); });
    });
}

TEST_CASE("the first touch is as exact from afar, and where squares leave the scalar", "[collision][swept]") {
    const auto at_x = [](double x, double y = 0) { return metres(x, y, 0); };
    for (const double far : {1.0, 1e3, 1e6, 1e9}) { // from there to the other side of the target
        const auto first =
            impact(Sphere{0.05 * metre}, at_x(-far), at_x(2 * far), Sphere{0.05 * metre}, at_x(0), at_x(0));
        REQUIRE(first);
        const double touches = double(first->time) * 2 * far; // the way
        CHECK(std::abs(touches - (far - 0.1)) <= 4 * std::numeric_limits<double>::epsilon() * far);
        // A miss by a tenth of a thousandth, and a hit by as much.
        CHECK_FALSE(
            impact(Sphere{0.05 * metre}, at_x(-far, 0.1001), at_x(2 * far), Sphere{0.05 * metre}, at_x(0), at_x(0)));
        CHECK(impact(Sphere{0.05 * metre}, at_x(-far, 0.0999), at_x(2 * far), Sphere{0.05 * metre}, at_x(0), at_x(0)));
    }
    for (const double size : {1e-200, 1e200}) {
        const auto first =
            impact(Sphere{size * metre}, at_x(-4 * size), at_x(4 * size), Sphere{size * metre}, at_x(0), at_x(0));
        REQUIRE(first);
        CHECK(std::abs(double(first->time) - 0.5) <= rounding<Space<>>(4));
        CHECK(first->normal[0] == -1);
    }
}

TEST_CASE("what grazes within rounding is a hit or none, and never not a number", "[collision][swept]") {
    for_each_type(AllSpaces{}, []<class S>() {
        for (int n = -8; n <= 8; ++n) {
            const double off = 0.75 * (1 + n * double(std::numeric_limits<typename S::Scalar>::epsilon()));
            auto look = [&](const auto& a, const auto& b, double y) {
                const auto first = impact(a, vector_in<S, unit::Length>(-3, y), vector_in<S, unit::Length>(6), b,
                                          vector_in<S, unit::Length>(0), vector_in<S, unit::Length>(0));
                if (!first) return;
                CHECK((first->time >= 0 && first->time <= 1));
                CHECK(std::abs(double(first->normal.norm()) - 1) <= rounding<S>(4));
                CHECK(is_finite(first->arm));
            };
            const Box box = S::dimension == 2 ? Box{metres(0.5, 0.25)} : Box{metres(0.5, 0.25, 1)};
            look(Sphere{0.5 * metre}, Sphere{0.25 * metre}, off);
            look(Sphere{0.5 * metre}, box, off);
            look(box, box, off / 1.5);
            look(Sphere{0.75 * metre}, Plane::ground(), off);
        }
    });
}

TEST_CASE("what begins inside and comes nearer touches at once, what leaves does not, nor what stands still",
          "[collision][swept]") {
    for_each_type(AllSpaces{}, []<class S>() {
        auto at_x = [](double x) { return vector_in<S, unit::Length>(x); };
        const Box box = S::dimension == 2 ? Box{metres(1, 1)} : Box{metres(1, 1, 1)};
        auto check = [&](const auto& a, const auto& b, double inside) {
            const auto in = impact(a, at_x(inside), at_x(-1), b, at_x(0), at_x(0));
            REQUIRE(in);
            CHECK(in->time == 0);
            CHECK(in->normal[0] == 1);
            CHECK_FALSE(impact(a, at_x(inside), at_x(1), b, at_x(0), at_x(0)));
            CHECK_FALSE(impact(a, at_x(inside), at_x(0), b, at_x(0), at_x(0)));
            CHECK_FALSE(impact(a, at_x(3 * inside), at_x(5), b, at_x(0), at_x(5))); // side by side
        };
        check(Sphere{0.5 * metre}, Sphere{0.5 * metre}, 0.75);
        check(Sphere{0.5 * metre}, box, 1.25);
        check(Sphere{0.5 * metre}, box, 0.75); // its centre, too
        check(box, box, 1.5);
        check(box, Plane{Eigen::Vector3d(1, 0, 0), 0.0 * metre}, 0.25);
        check(Sphere{0.5 * metre}, Plane{Eigen::Vector3d(1, 0, 0), 0.0 * metre}, 0.25);
        // Along a face, from beside it and from upon it.
        for (const double from : {-3.0, 0.0})
            CHECK_FALSE(impact(box, vector_in<S, unit::Length>(from, 2), at_x(6), box, at_x(0), at_x(0)));
    });
}
