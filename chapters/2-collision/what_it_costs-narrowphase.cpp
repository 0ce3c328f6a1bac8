// SPDX-License-Identifier: BSL-1.0
// What a contact costs: how wrong its depth and its normal are, in float and double, near the origin and far from it

// The pairs are built from the answer: a normal and a depth are drawn, and the second body is put where the two are so
// deep in each other along it. What a scalar makes of that is wrong by the rounding of the places, which grows with the
// distance from the origin, and by the arithmetic, which does not. A contact that is not found any more has a depth of
// zero, so that its error is all of its depth; how many are lost stands beside it. Depths are 0.01 to 0.3 of the radius
// (of the half-width of a box).

#include "what_it_costs.hpp"

#include <ansatz/collision.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <type_traits>

using namespace ansatz;
using namespace collision_costs;
using workbook::Axis;
using workbook::Outcome;

namespace {

constexpr int pairs = 1000;
using Exact = Eigen::Matrix<long double, 3, 1>;

/// Two bodies of which the answer is known. Which of the numbers mean something is the pair's kind's affair.
struct Pair {
    Exact xa = Exact::Zero(), xb = Exact::Zero();         ///< m
    long double ra = 0, rb = 0;                           ///< m, radii
    Exact half_a = Exact::Zero(), half_b = Exact::Zero(); ///< m
    Exact plane = Exact::Zero();                          ///< its normal
    Exact normal = Exact::Zero();                         ///< the right answer
    long double depth = 0, size = 1;                      ///< m: the right answer, and what it is held against
};

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    long double between(long double low, long double high) {
        return low + (high - low) * (long double)(engine_() >> 11) * 0x1p-53L;
    }
    int below(int n) { return int(engine_() % std::uint64_t(n)); }
    /// A unit vector: a point of the ball, made longer.
    Exact direction() {
        for (;;) {
            Exact x;
            for (int k = 0; k < 3; ++k) x[k] = between(-1, 1);
            if (const long double n = x.norm(); n > 0.1L && n < 1) return x / n;
        }
    }
    Exact half() {
        Exact h;
        for (int k = 0; k < 3; ++k) h[k] = between(0.5L, 1);
        return h;
    }

private:
    std::mt19937_64 engine_;
};

/// A number that float has, too: sizes are exact, so that only places are rounded.
long double short_number(long double x) { return (long double)(float)x; }
Exact short_numbers(Exact x) {
    for (int k = 0; k < 3; ++k) x[k] = short_number(x[k]);
    return x;
}

struct SphereSphere {
    static constexpr const char* name = "Sphere, Sphere";
    static Pair draw(Dice& dice) {
        Pair p;
        p.ra = short_number(dice.between(0.25L, 1));
        p.rb = short_number(dice.between(0.25L, 1));
        p.size = std::min(p.ra, p.rb);
        p.depth = p.size * dice.between(0.01L, 0.3L);
        p.normal = dice.direction();
        p.xa = p.normal * (p.ra + p.rb - p.depth);
        return p;
    }
    template <class S> static auto shapes(const Pair& p) {
        return std::pair(typename Sphere::In<S>(Sphere{double(p.ra) * metre}),
                         typename Sphere::In<S>(Sphere{double(p.rb) * metre}));
    }
};
struct SpherePlane {
    static constexpr const char* name = "Sphere, Plane";
    static Pair draw(Dice& dice) {
        Pair p;
        p.ra = p.size = short_number(dice.between(0.25L, 1));
        p.depth = p.size * dice.between(0.01L, 0.3L);
        p.plane = p.normal = dice.direction();
        p.xa = p.normal * (p.ra - p.depth);
        return p;
    }
    template <class S> static auto shapes(const Pair& p) {
        return std::pair(typename Sphere::In<S>(Sphere{double(p.ra) * metre}),
                         typename Plane::In<S>(Plane{Eigen::Vector3d(p.plane.cast<double>()), 0.0 * metre}));
    }
};
struct SphereBox {
    static constexpr const char* name = "Sphere, Box";
    static Pair
    draw(Dice& dice) { // at a face, an edge or a corner: where one, two or three components of the normal are not zero
        Pair p;
        p.ra = p.size = short_number(dice.between(0.25L, 0.5L));
        p.depth = p.size * dice.between(0.01L, 0.3L);
        p.half_b = short_numbers(dice.half());
        const int kept = 1 + dice.below(3), first = dice.below(3);
        const Exact way = dice.direction();
        Exact on = Exact::Zero();
        for (int n = 0; n < 3; ++n) {
            const int k = (first + n) % 3;
            if (n < kept) p.normal[k] = way[k], on[k] = way[k] < 0 ? -p.half_b[k] : p.half_b[k];
            else on[k] = p.half_b[k] * dice.between(-0.9L, 0.9L);
        }
        p.normal /= p.normal.norm();
        p.xa = on + p.normal * (p.ra - p.depth);
        return p;
    }
    template <class S> static auto shapes(const Pair& p) {
        return std::pair(typename Sphere::In<S>(Sphere{double(p.ra) * metre}),
                         typename Box::In<S>(Box{
                             VectorQuantity<unit::Length, 3>::from_value(Eigen::Vector3d(p.half_b.cast<double>()))}));
    }
};
struct BoxBox {
    static constexpr const char* name = "Box, Box";
    static Pair draw(Dice& dice) { // the overlap on the other axes is at least twice as large
        Pair p;
        p.half_a = short_numbers(dice.half());
        p.half_b = short_numbers(dice.half());
        p.size = std::min(p.half_a.minCoeff(), p.half_b.minCoeff());
        p.depth = p.size * dice.between(0.01L, 0.3L);
        const int axis = dice.below(3);
        for (int k = 0; k < 3; ++k) {
            const long double side = dice.between(-1, 1) < 0 ? -1 : 1,
                              overlap = k == axis ? p.depth : p.size * dice.between(0.6L, 1);
            if (k == axis) p.normal[k] = side;
            p.xa[k] = side * (p.half_a[k] + p.half_b[k] - overlap);
        }
        return p;
    }
    template <class S> static auto shapes(const Pair& p) {
        const auto box = [](const Exact& half) {
            return typename Box::In<S>(
                Box{VectorQuantity<unit::Length, 3>::from_value(Eigen::Vector3d(half.cast<double>()))});
        };
        return std::pair(box(p.half_a), box(p.half_b));
    }
};
struct BoxPlane {
    static constexpr const char* name = "Box, Plane";
    static Pair draw(Dice& dice) {
        Pair p;
        p.half_a = short_numbers(dice.half());
        p.size = p.half_a.minCoeff();
        p.depth = p.size * dice.between(0.01L, 0.3L);
        p.plane = p.normal = dice.direction();
        p.xa = p.normal * (p.normal.cwiseAbs().dot(p.half_a) - p.depth);
        return p;
    }
    template <class S> static auto shapes(const Pair& p) {
        return std::pair(typename Box::In<S>(Box{
                             VectorQuantity<unit::Length, 3>::from_value(Eigen::Vector3d(p.half_a.cast<double>()))}),
                         typename Plane::In<S>(Plane{Eigen::Vector3d(p.plane.cast<double>()), 0.0 * metre}));
    }
};

/// The pairs of a kind in a scalar, so far from the origin, and their answers.
template <class Kind, class S> struct Scene {
    using Shapes = decltype(Kind::template shapes<S>(Pair()));
    struct Item {
        Shapes shapes;
        typename S::Position xa, xb;
    };
    std::vector<Pair> answers;
    std::vector<Item> items;

    explicit Scene(double distance) {
        Dice dice(7);
        const Exact away = (long double)distance * Exact(0.6L, 0.48L, 0.64L);
        for (int i = 0; i < pairs; ++i) {
            const Pair p = Kind::draw(dice);
            using Scalar = typename S::Scalar;
            const auto place = [&](const Exact& x) {
                return S::Position::from_value(Vector<Scalar, 3>(Exact(x + away).template cast<Scalar>()));
            };
            items.push_back({Kind::template shapes<S>(p), place(p.xa), place(p.xb)});
            answers.push_back(p);
        }
    }
};

/// The library's own function for two shapes.
struct Collide {
    template <class S, class Item> static bool at(const Item& item, Touch<S>& touch) {
        return collide(item.shapes.first, item.xa, item.shapes.second, item.xb, touch);
    }
};
/// Notes 2.1.2 to the letter, N = S1 - S2: cheaper by a division, and as long as the two are far apart.
struct RawDifference {
    template <class S, class Item> static bool at(const Item& item, Touch<S>& touch) {
        const auto between = item.xa - item.xb;
        const auto distance = norm(between), reach = item.shapes.first.radius + item.shapes.second.radius;
        if (!(distance < reach)) return false;
        touch.depth = reach - distance;
        touch.normal = between.value();
        touch.point = item.xa - (item.shapes.first.radius - typename S::Scalar(0.5) * touch.depth) * touch.normal;
        return true;
    }
};

enum class Norm { depth, normal };

template <class Kind, class S, class How> Outcome wrong(double distance, Norm norm) {
    const Scene<Kind, S> scene(distance);
    long double worst = 0;
    int lost = 0;
    for (int i = 0; i < pairs; ++i) {
        const Pair& answer = scene.answers[std::size_t(i)];
        Touch<S> touch;
        const bool found = How::template at<S>(scene.items[std::size_t(i)], touch);
        lost += !found;
        if (norm == Norm::depth) {
            const long double depth = found ? (long double)touch.depth.value() : 0;
            worst = std::max(worst, std::abs(depth - answer.depth) / answer.size);
        } else if (found) {
            Exact normal;
            for (int k = 0; k < 3; ++k) normal[k] = (long double)touch.normal[k];
            worst = std::max(worst, (normal - answer.normal).norm());
        }
    }
    return {.error = double(worst), .work = lost};
}

template <class Kind, class S, class How = Collide> void add_rows(Costs& costs, const char* choice) {
    for (const auto norm : {Norm::depth, Norm::normal}) {
        const bool depth = norm == Norm::depth;
        const Axis axis{.name = "narrowphase",
                        .error_norm = depth ? "max |p - exact| / r" : "max |N - exact|",
                        .work_unit = "contacts lost of 1000",
                        .time_unit = "ns per pair",
                        .has_order = false};
        for (const double distance : {0.0, 1e2, 1e4, 1e6}) {
            const auto scene = std::make_shared<const Scene<Kind, S>>(distance);
            costs.add(axis, {.choice = choice,
                             .problem = std::string(Kind::name) + (depth ? ": depth" : ": normal"),
                             .parameter = {"distance from the origin", distance * metre},
                             .n = pairs,
                             .error_run = [=] { return wrong<Kind, S, How>(distance, norm); },
                             .timed_run =
                                 [scene] {
                                     typename S::Scalar sum(0);
                                     for (const auto& item : scene->items) {
                                         Touch<S> touch;
                                         if (How::template at<S>(item, touch))
                                             sum += touch.depth.value() + touch.normal[0] + touch.point.value()[1];
                                     }
                                     return sum;
                                 },
                             .per = pairs});
        }
    }
}

template <class Kind> void add_kind(Costs& costs) {
    add_rows<Kind, Space<float, 3>>(costs, "float");
    add_rows<Kind, Space<double, 3>>(costs, "double");
    if constexpr (std::is_same_v<Kind, SphereSphere>)
        add_rows<Kind, Space<double, 3>, RawDifference>(costs, "double, N = S1 - S2 of the notes");
}

} // namespace

void collision_costs::add_narrowphase(Costs& costs) {
    add_kind<SphereSphere>(costs);
    add_kind<SpherePlane>(costs);
    add_kind<SphereBox>(costs);
    add_kind<BoxBox>(costs);
    add_kind<BoxPlane>(costs);
}
