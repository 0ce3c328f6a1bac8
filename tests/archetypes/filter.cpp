// SPDX-License-Identifier: BSL-1.0
// FilterIn: an archetype, two models, near misses.

#include <ansatz/collision.hpp>

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

/// What it answers with can be asked as a condition, and nothing more.
struct Yes : NothingMore {
    Yes() : NothingMore(0) {}
    operator bool() const { return true; }
};
struct Passes : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Filter;
    using reads = Columns<>;
    template <class Sp> struct In : NothingMore {
        explicit In(const Passes&) : NothingMore(0) {}
        Yes passes(const Row<Sp, Columns<>>&, const Row<Sp, Columns<>>&) const { return {}; }
    };
};
static_assert(FilterIn<Passes, S> && FilterIn<Passes, Space<float, 2>>);
auto of_filter() {
    World world{SemiImplicitEuler{}, AllPairs{}, Passes(1), Narrowphase<Sphere>{}, Impulse<>{}};
    world.add(Sphere{1.0 * metre},
              mass(1.0 * kilogram)); // the archetype's own is the second: it is asked about the two
    return use(world);
}

// Models: the library's, and one that reads what bodies do.
struct Approaching {
    using role = roles::Filter;
    using reads = Columns<Position, Velocity>;
    template <class Sp> struct In {
        explicit In(Approaching) {}
        bool passes(const auto& a, const auto& b) const {
            return dot(a.template get<Position>() - b.template get<Position>(),
                       a.template get<Velocity>() - b.template get<Velocity>())
                       .value() < 0;
        }
    };
};
static_assert(FilterIn<Layers, S> && FilterIn<Layers, Space<float, 2>> && FilterIn<Approaching, S>);
auto of_approaching() {
    return use(World{SemiImplicitEuler{}, BoundingBoxes{}, Approaching{}, Narrowphase<Sphere>{}, Impulse<>{}});
}

// Near misses.
struct OfOneBody {
    using role = roles::Filter;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const OfOneBody&);
        bool passes(const auto&) const;
    };
};
struct ReadsNothingDeclared {
    using role = roles::Filter;
    template <class Sp> struct In {
        explicit In(const ReadsNothingDeclared&);
        bool passes(const auto&, const auto&) const;
    };
};
struct AnswersNothing {
    using role = roles::Filter;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const AnswersNothing&);
        void passes(const auto&, const auto&) const;
    };
};
struct PassesNotConst {
    using role = roles::Filter;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const PassesNotConst&);
        bool passes(const auto&, const auto&);
    };
};
static_assert(!FilterIn<OfOneBody, S> && !FilterIn<ReadsNothingDeclared, S> && !FilterIn<AnswersNothing, S> &&
              !FilterIn<PassesNotConst, S>);
static_assert(!FilterIn<AllPairs, S> && !FilterIn<int, S>);

} // namespace ansatz::archetypes
