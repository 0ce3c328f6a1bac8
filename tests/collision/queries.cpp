// SPDX-License-Identifier: BSL-1.0
// Ray casts and overlaps: against marching along the ray, against every body one by one, and what they refuse.

#include "tests/collision/support.hpp"

#include <ansatz/collision/queries.hpp>
#include <ansatz/collision/queries_in_world.hpp>

#include <random>
#include <sstream>

using namespace collision_tests;

namespace {
struct Random {
    std::mt19937 engine{11};
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
Ray ray_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double longest) {
    return Ray{metres(from[0], from[1], from[2]), to, longest * metre};
}
template <class S> Box box(double x, double y, double z) {
    if constexpr (S::dimension == 2) return Box{metres(x, y)};
    else return Box{metres(x, y, z)};
}

/// How far a point is from a shape at the origin, negative inside.
double distance_to(const Sphere& a, const Eigen::Vector3d& x) { return x.norm() - in(a.radius, metre); }
double distance_to(const Plane& a, const Eigen::Vector3d& x) {
    return x.dot(a.normal.value().normalized()) - in(a.offset, metre);
}
double distance_to(const Box& a, const Eigen::Vector3d& x) {
    Eigen::Vector3d h = VectorQuantity<unit::Length, 3>(a.half).value();
    if (h[2] == 0) h[2] = 1; // of two dimensions
    const Eigen::Vector3d out = (x.cwiseAbs() - h);
    return out.maxCoeff() < 0 ? out.maxCoeff() : out.cwiseMax(0).norm();
}
/// Marches along a ray by how far the surface is at least; 1e9 if it is not met.
template <class A>
double marched(const A& shape, const Eigen::Vector3d& from, const Eigen::Vector3d& unit, double longest,
               double& nearest) {
    double way = 0;
    nearest = 1e9;
    for (int i = 0; i < 200000 && way <= longest; ++i) {
        const double d = distance_to(shape, Eigen::Vector3d(from + way * unit));
        nearest = std::min(nearest, d);
        if (d <= 1e-11) return way;
        way += d;
    }
    return 1e9;
}

template <class S, class A> void check_rays(const A& shape, Random& random) {
    int hits = 0, misses = 0;
    for (int n = 0; n < 2000; ++n) {
        const Eigen::Vector3d from = random.vector<S>(3), to = random.vector<S>(1.5) - 0.4 * from; // about at it
        if (!(to.norm() > 0.01) || std::abs(distance_to(shape, from)) < 1e-3) continue;
        const double longest = n % 2 == 0 ? 2 : 50;
        double nearest = 0;
        const double way = marched(shape, from, to.normalized(), longest, nearest);
        const auto hit = cast(ray_of(from, to, longest), shape, metres_of<S>(Eigen::Vector3d::Zero()));
        if (way == 1e9 ? nearest < 1e-4 : std::abs(way - longest) < 1e-4) continue; // undecided within rounding
        INFO("case " << n << ": marched " << way);
        REQUIRE(hit.has_value() == (way < 1e9));
        ++(hit ? hits : misses);
        if (!hit) continue;
        const double d = double(hit->distance.value());
        const Eigen::Vector3d u = to.normalized(), x = from + d * u;
        CHECK(std::abs(distance_to(shape, x)) <= (way == 0 ? 10.0 : rounding<S>(400)));
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (int k = 0; k < S::dimension; ++k) normal[k] = double(hit->normal[k]);
        CHECK(std::abs(normal.norm() - 1) <= rounding<S>(4));
        CHECK(normal.dot(u) <= 0);
        CHECK(std::abs(d - way) <=
              (rounding<S>(400) + 1e-11) / std::max(-normal.dot(u), 1e-3)); // the march ends 1e-11 m before the surface
        // However large everything is, the answer is the same.
        const double larger = std::is_same_v<typename S::Scalar, float> ? 1e10 : 1e100;
        if constexpr (std::is_same_v<A, Sphere>) {
            const auto scaled =
                cast(Ray{metres(from[0] * larger, from[1] * larger, from[2] * larger), to, longest * larger * metre},
                     Sphere{larger * shape.radius}, metres_of<S>(Eigen::Vector3d::Zero()));
            REQUIRE(scaled);
            CHECK(std::abs(double(scaled->distance.value()) / larger - d) <= rounding<S>(100));
        }
    }
    CHECK(hits > 100);
    CHECK(misses > 100);
}

/// A world full of bodies of three kinds, of which every seventh only notices.
template <class World_> std::vector<Handle> fill(World_& world, int n) {
    using S = typename World_::S;
    Random random;
    std::vector<Handle> all;
    for (int i = 0; i < n; ++i) {
        const auto x = position(metres_of<S>(random.vector<S>(8)));
        if (i % 7 == 0) all.push_back(world.add(Sphere{random(0.1, 1) * metre}, x, mass(1.0 * kilogram), sensor));
        else if (i % 3 == 0) all.push_back(world.add(box<S>(random(0.1, 1), random(0.1, 1), random(0.1, 1)), x, fixed));
        else all.push_back(world.add(Sphere{random(0.1, 1) * metre}, x, mass(1.0 * kilogram)));
    }
    all.push_back(world.add(Plane{Eigen::Vector3d(0, 1, 0), -9.0 * metre}, fixed));
    return all;
}
} // namespace

TEST_CASE("a ray meets a sphere, a plane and a box where marching along it does", "[collision][queries]") {
    for_each_type(AllSpaces{}, []<class S>() {
        Random random;
        check_rays<S>(Sphere{0.75 * metre}, random);
        check_rays<S>(box<S>(0.5, 0.75, 1), random);
        check_rays<S>(Plane{Eigen::Vector3d(0.6, 0.8, 0), 0.5 * metre}, random);
    });
}

TEST_CASE("a ray that begins inside hits at once, one that grazes or points away does not", "[collision][queries]") {
    for_each_type(AllSpaces{}, []<class S>() {
        const auto here = vector_in<S, unit::Length>(0);
        auto check = [&](const auto& shape, double inside, double surface) {
            const auto once = cast(Ray{metres(inside, 0), Eigen::Vector3d(1, 0, 0)}, shape, here);
            REQUIRE(once);
            CHECK((once->distance.value() == 0 && once->normal[0] == -1));
            CHECK_FALSE(cast(Ray{metres(surface + 1, 0), Eigen::Vector3d(3, 0, 0)}, shape, here));
            const auto there = cast(Ray{metres(surface + 1, 0), Eigen::Vector3d(-3, 0, 0)}, shape, here);
            REQUIRE(there);
            CHECK((there->distance.value() == 1 && there->normal[0] == 1));
            CHECK(
                cast(Ray{metres(surface + 1, 0), Eigen::Vector3d(-3, 0, 0), 1.0 * metre}, shape, here)); // just as far
            CHECK_FALSE(cast(Ray{metres(surface + 1, 0), Eigen::Vector3d(-3, 0, 0), 0.99 * metre}, shape, here));
        };
        check(Sphere{0.5 * metre}, 0.25, 0.5);
        check(box<S>(0.5, 1, 1), 0.25, 0.5);
        check(Plane{Eigen::Vector3d(1, 0, 0)}, -0.25, 0);
        CHECK_FALSE(cast(Ray{metres(-2, 0.5), Eigen::Vector3d(1, 0, 0)}, Sphere{0.5 * metre}, here));
        CHECK_FALSE(cast(Ray{metres(-2, 0), Eigen::Vector3d(1, 0, 0)}, Plane::ground(), here)); // along the surface
        for (const double from : {-2.0, 0.0})                                                   // along a face of a box
            CHECK_FALSE(cast(Ray{metres(from, 0.5), Eigen::Vector3d(1, 0, 0)}, box<S>(0.5, 0.5, 0.5), here));
    });
}

TEST_CASE("a ray meets what is before it, however thin and however far away", "[collision][queries]") {
    for_each_type(AllSpaces{}, []<class S>() {
        const auto here = vector_in<S, unit::Length>(0);
        const double last =
            double(std::numeric_limits<typename S::Scalar>::epsilon()); // the places of a coordinate of 1 m
        for (const double far : {1.0, 1e3, 0.5 / (last * last)}) {
            const Ray ray{metres(-far, 0), Eigen::Vector3d(1, 0, 0)};
            const double thin = far * last / 8;
            const auto wall = cast(ray, box<S>(thin, 5, 5), here);
            REQUIRE(wall);
            CHECK(std::abs(double(wall->distance.value()) - far) <= rounding<S>(2 * far));
            CHECK(wall->normal[0] == -1);
            const auto ball = cast(ray, Sphere{thin * metre}, here);
            REQUIRE(ball);
            CHECK(std::abs(double(ball->distance.value()) - far) <= rounding<S>(2 * far));
            CHECK(ball->normal[0] == -1);
            CHECK_FALSE(
                cast(Ray{metres(-far, 0), Eigen::Vector3d(1, 0, 0), 0.5 * far * metre}, box<S>(thin, 5, 5), here));
        }
    });
}

TEST_CASE("a world's rays and overlaps are those of every body, one by one", "[collision][queries]") {
    for_each_type(AllSpaces{}, []<class S>() {
        World world{SemiImplicitEuler{}, S{}, Impulse<>{}, SortAndSweep{}, Narrowphase<Sphere, Plane, Box>{}};
        const auto all = fill(world, 300);
        Random random;
        std::vector<RayHit<S>> hits;
        std::vector<Handle> bodies;
        int found = 0;
        for (int n = 0; n < 100; ++n) {
            const Eigen::Vector3d from = random.vector<S>(8), to = random.vector<S>(1);
            if (!(to.norm() > 0)) continue;
            const Ray ray = ray_of(from, to, 30);
            for (const bool sensors : {false, true}) {
                sensors ? world.query().all(ray, hits, with_sensors) : world.query().all(ray, hits);
                std::vector<std::pair<double, std::uint32_t>> expected;
                for (std::size_t i = 0; i < all.size(); ++i) {
                    if (!sensors && i % 7 == 0 && i < 300) continue;
                    world.visit_shape(all[i], [&](const auto& shape) {
                        if (const auto hit = cast(ray, shape, world.position(all[i])))
                            expected.emplace_back(double(hit->distance.value()), all[i].id);
                    });
                }
                std::sort(expected.begin(), expected.end());
                REQUIRE(hits.size() == expected.size());
                for (std::size_t i = 0; i < hits.size(); ++i)
                    CHECK((hits[i].body.id == expected[i].second &&
                           double(hits[i].distance.value()) == expected[i].first));
                const auto first = sensors ? world.query().closest(ray, with_sensors) : world.query().closest(ray);
                REQUIRE(first.has_value() == !hits.empty());
                if (first)
                    CHECK((first->body == hits[0].body && first->distance == hits[0].distance &&
                           first->point == hits[0].point));
                found += int(hits.size());
            }
            auto check_overlap = [&](const auto& shape) {
                const auto x = metres_of<S>(from);
                world.query().overlap(shape, x, bodies);
                std::vector<Handle> expected;
                for (std::size_t i = 0; i < all.size(); ++i)
                    world.visit_shape(all[i], [&](const auto& other) {
                        if ((i % 7 != 0 || i >= 300) && contact(shape, x, other, world.position(all[i])))
                            expected.push_back(all[i]);
                    });
                CHECK(bodies == expected);
                found += int(bodies.size());
            };
            check_overlap(Sphere{1.5 * metre});
            check_overlap(box<S>(1, 2, 0.5));
        }
        CHECK(found > 200);
    });
}

TEST_CASE("of two bodies as near a ray tells the one with the smaller id first, also after removals and sleep",
          "[collision][queries]") {
    World world{SemiImplicitEuler{}, Impulse<>{}, SortAndSweep{}, Narrowphase<Sphere>{}, Rest{}};
    const auto gone = world.add(Sphere{0.5 * metre}, at<Space<>>(5), fixed);
    const auto one = world.add(Sphere{0.5 * metre}, at<Space<>>(0), fixed),
               two = world.add(Sphere{0.5 * metre}, at<Space<>>(0), mass(1.0 * kilogram));
    world.remove(gone);
    const Ray ray{metres(3, 0, 0), Eigen::Vector3d(-1, 0, 0)};
    CHECK(world.query().closest(ray)->body == one);
    std::vector<RayHit<Space<>>> hits;
    world.query().all(ray, hits);
    REQUIRE(hits.size() == 2);
    CHECK((hits[0].body == one && hits[1].body == two));
    world.set_position(one, metres(0, 7, 0)); // what was changed since the last step is seen
    CHECK(world.query().closest(ray)->body == two);
}

TEST_CASE("queries ask the world's filter", "[collision][queries]") {
    World world{SemiImplicitEuler{}, Impulse<>{}, SortAndSweep{}, Swept<Narrowphase<Sphere>>{}, Layers{}};
    const auto glass = world.add(Sphere{0.5 * metre}, at<Space<>>(0), fixed, member_of(2));
    const auto wall = world.add(Sphere{0.5 * metre}, at<Space<>>(2), fixed, member_of(1));
    const auto shy = world.add(Sphere{0.5 * metre}, at<Space<>>(-2), fixed, ignores(4));
    const Ray ray{metres(-5, 0, 0), Eigen::Vector3d(1, 0, 0)};
    CHECK(world.query().closest(ray)->body == shy);
    CHECK(world.query().closest(ray, member_of(4))->body == glass);
    CHECK(world.query().closest(ray, member_of(4), ignores(2))->body == wall);
    std::vector<Handle> bodies;
    world.query().overlap(Sphere{10.0 * metre}, metres(0, 0, 0), bodies, ignores(2));
    CHECK((bodies == std::vector<Handle>{wall, shy}));
}

TEST_CASE("what is no ray and no shape is refused with a sentence, and nothing is changed", "[collision][queries]") {
    World world{SemiImplicitEuler{}, Impulse<>{}, SortAndSweep{}, Narrowphase<Sphere>{}};
    world.add(Sphere{0.5 * metre}, fixed);
    const double nan = std::nan("");
    auto said = [&](const Ray& ray) { return refusal([&] { world.query().closest(ray); }); };
    CHECK(said(Ray{metres(0, 0, 0), Eigen::Vector3d(0, 0, 0)}).find("Ray") != std::string::npos);
    CHECK(said(Ray{metres(0, 0, 0), Eigen::Vector3d(0, 0, 0)}).find("direction") != std::string::npos);
    CHECK(said(Ray{metres(0, nan, 0), Eigen::Vector3d(1, 0, 0)}).find("origin") != std::string::npos);
    CHECK(said(Ray{metres(0, 0, 0), Eigen::Vector3d(nan, 0, 0)}).find("direction") != std::string::npos);
    CHECK(said(Ray{metres(0, 0, 0), Eigen::Vector3d(1, 0, 0), -1.0 * metre}).find("-1 m") != std::string::npos);
    std::vector<Handle> bodies(3);
    CHECK(refusal([&] { world.query().overlap(Sphere{-1.0 * metre}, metres(0, 0, 0), bodies); }).find("radius") !=
          std::string::npos);
    CHECK(refusal([&] { world.query().overlap(Sphere{1.0 * metre}, metres(0, nan, 0), bodies); }).find("position") !=
          std::string::npos);
    CHECK(bodies.size() == 3);
    World flat{SemiImplicitEuler{}, Space<double, 2>{}, Impulse<>{}, SortAndSweep{}, Narrowphase<Sphere>{}};
    CHECK(refusal([&] {
              flat.query().closest(Ray{metres(0, 0), Eigen::Vector3d(0, 0, 1)});
          }).find("Ray::direction") != std::string::npos);
}

TEST_CASE("what the page shows: what is below, what a ray goes through, what is near", "[collision][queries]") {
    auto world = world_of(SemiImplicitEuler{}, Gravity{}, Impulse<>{});
    const auto ground = world.add(Plane::ground(), fixed);
    const auto ball = world.add(Sphere{0.5 * metre}, position(metres(0, 1, 0)), mass(1.0 * kilogram));
    std::ostringstream said;
    //! [ask]
    const Ray ray{metres(0, 2, 0), Eigen::Vector3d(0, -1, 0), 100.0 * metre};
    if (const auto hit = world.query().closest(ray)) said << hit->distance << " to body " << hit->body.id << '\n';
    std::vector<RayHit<Space<>>> hits;
    world.query().all(ray, hits, with_sensors); // by distance
    std::vector<Handle> near;
    world.query().overlap(Sphere{3.0 * metre}, metres(0, 1, 0), near); // by id
    //! [ask]
    CHECK(said.str() == "0.5 m to body 1\n");
    REQUIRE(hits.size() == 2);
    CHECK((hits[0].body == ball && hits[1].body == ground && hits[1].distance == 2.0 * metre));
    CHECK(near == std::vector<Handle>{ground, ball});
}
