// SPDX-License-Identifier: BSL-1.0
// ShapeIn and NarrowphaseIn: archetypes, two models, near misses. Unlike other archetypes a shape can be assigned,
// because a world keeps shapes by kind in vectors.

#include <ansatz/collision.hpp>
#include <ansatz/collision/narrowphase/pairs.hpp>

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

struct Assigned {
    explicit Assigned(int) {}
};

struct Dot : Assigned {
    using Assigned::Assigned;
    using shape = Dot;
    static constexpr bool bounded = true;
    static constexpr std::string_view name = "Dot";
    template <class Sp> struct In : Assigned {
        using description = Dot;
        explicit In(const Dot&) : Assigned(0) {}
        void bounds(const typename Sp::Position& x, typename Sp::Position& lower, typename Sp::Position& upper) const {
            lower = upper = x;
        }
    };
};
template <class Sp>
bool collide(const Dot::In<Sp>&, const typename Sp::Position&, const Dot::In<Sp>&, const typename Sp::Position&,
             Touch<Sp>& touch) {
    touch.depth = Sp::Length::from_value(1);
    for (int k = 0; k < Sp::dimension; ++k) touch.normal[k] = typename Sp::Scalar(k == 0);
    return true;
}
static_assert(ShapeIn<Dot, S> && ShapeIn<Dot, Space<float, 2>> && detail::can_meet<Dot, Dot, S> &&
              !detail::can_meet<Dot, Sphere, S>);
auto of_shape() {
    World world{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Dot>{}, Impulse<>{}, Projection{}};
    world.add(Dot(1), mass(1.0 * kilogram));
    const auto one = world.add(Dot(1), mass(1.0 * kilogram));
    world.step(0.01 * second);
    world.remove(one);
    return use(world);
}

/// A narrowphase that knows no shape at all, but all that a world asks.
struct KnowsNone : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Narrowphase;
    template <class C> using Collisions = ansatz::Collisions<C>;
    template <class Sp> using Shapes = ShapesOf<Sp>;
    template <class Kind> static constexpr bool knows = false;
    static constexpr bool any_bounded = false, any_unbounded = false;
    template <class F> static void for_each_kind(F&&) {}
    template <class Sp>
    static bool collide_bodies(const Shapes<Sp>&, std::uint32_t, const typename Sp::Position&, std::uint32_t,
                               const typename Sp::Position&, Touch<Sp>&) {
        return false;
    }
    template <class Sp>
    static bool nearly_collide(const Shapes<Sp>&, std::uint32_t, const typename Sp::Position&, std::uint32_t,
                               const typename Sp::Position&, const typename Sp::Length&, Touch<Sp>&) {
        return false;
    }
};
static_assert(NarrowphaseIn<KnowsNone, S> && NarrowphaseIn<KnowsNone, Space<float, 2>>);
auto of_narrowphase() { return use(World{SemiImplicitEuler{}, AllPairs{}, KnowsNone(1), Impulse<>{}}); }

// Models: the library's, and one without a box that meets spheres.
struct Outside {
    using shape = Outside;
    static constexpr bool bounded = false;
    static constexpr const char* name = "Outside";
    Parameter<unit::Length> radius;
    template <class Sp> struct In {
        using description = Outside;
        typename Sp::Length radius;
        explicit In(Outside o) : radius(Sp::convert(o.radius)) {}
    };
};
template <class Sp>
bool collide(const Sphere::In<Sp>&, const typename Sp::Position&, const Outside::In<Sp>&, const typename Sp::Position&,
             Touch<Sp>&) {
    return false;
}
static_assert(ShapeIn<Sphere, S> && ShapeIn<Plane, S> && ShapeIn<Box, Space<float, 2>> && ShapeIn<Outside, S>);
static_assert(detail::can_meet<Outside, Outside, S> && detail::can_meet<Outside, Plane, S>); // neither has a box
static_assert(detail::can_meet<Outside, Sphere, S> && detail::can_meet<Sphere, Outside, S> &&
              !detail::can_meet<Outside, Box, S>);
static_assert(NarrowphaseIn<Narrowphase<Sphere, Plane, Box>, S> &&
              NarrowphaseIn<Narrowphase<Outside, Sphere>, Space<float, 2>>);
template <class... T> constexpr bool list_ok = detail::NarrowphaseFacts<Narrowphase<T...>, S>::ok;
static_assert(list_ok<Sphere> && list_ok<Plane, Sphere, Box> && list_ok<Dot> && list_ok<Outside, Sphere, Plane>);
static_assert(!list_ok<> && !list_ok<Plane> && !list_ok<Sphere, Sphere> && !list_ok<Dot, Sphere> && !list_ok<int> &&
              !list_ok<Sphere, Box, Outside>);
auto of_outside() { return use(World{SemiImplicitEuler{}, AllPairs{}, Narrowphase<Sphere, Outside>{}, Impulse<>{}}); }

// Near misses.
struct NotItself {
    using shape = Sphere;
    static constexpr bool bounded = false;
    static constexpr std::string_view name = "NotItself";
    template <class Sp> struct In {
        using description = NotItself;
        explicit In(const NotItself&);
    };
};
struct BoundedByNothing {
    using shape = BoundedByNothing;
    static constexpr bool bounded = true;
    static constexpr std::string_view name = "BoundedByNothing";
    template <class Sp> struct In {
        using description = BoundedByNothing;
        explicit In(const BoundedByNothing&);
    };
};
struct Nameless {
    using shape = Nameless;
    static constexpr bool bounded = false;
    template <class Sp> struct In {
        using description = Nameless;
        explicit In(const Nameless&);
    };
};
struct OnlyMoved {
    using shape = OnlyMoved;
    static constexpr bool bounded = false;
    static constexpr std::string_view name = "OnlyMoved";
    template <class Sp> struct In {
        using description = OnlyMoved;
        explicit In(const OnlyMoved&);
        In(In&&) = default;
        In& operator=(In&&) = default;
    };
};
static_assert(!ShapeIn<NotItself, S> && !ShapeIn<BoundedByNothing, S> && !ShapeIn<Nameless, S> &&
              !ShapeIn<OnlyMoved, S> && !ShapeIn<int, S>);
struct WithoutMargin : Narrowphase<Sphere> {
    template <class Sp> static bool nearly_collide(const Shapes<Sp>&, std::uint32_t, std::uint32_t);
};
struct AnswersInNumbers : Narrowphase<Sphere> {
    template <class Sp>
    static int collide_bodies(const Shapes<Sp>&, std::uint32_t, const typename Sp::Position&, std::uint32_t,
                              const typename Sp::Position&, Touch<Sp>&);
};
struct OfTheWrongRole : Narrowphase<Sphere> {
    using role = roles::Broadphase;
};
static_assert(!NarrowphaseIn<WithoutMargin, S> && !NarrowphaseIn<AnswersInNumbers, S> &&
              !NarrowphaseIn<OfTheWrongRole, S> && !NarrowphaseIn<Impulse<>, S>);

} // namespace ansatz::archetypes
