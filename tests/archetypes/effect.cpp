// SPDX-License-Identifier: BSL-1.0
// EffectIn: archetypes at every place, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

template <Place At> struct Acts : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = At;
    template <class> struct In : NothingMore {
        explicit In(const Acts&) : NothingMore(0) {}
        void apply(S::Velocity&, const Context<S, false>&) const {}
    };
};
/// Reads beside what it writes, knows the time, and prepares.
struct ActsOnMore : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Effect;
    using reads = Columns<Velocity, Position, Clock>;
    using writes = Columns<Position>;
    static constexpr Place place = Place::after_integration;
    template <class> struct In : NothingMore {
        explicit In(const ActsOnMore&) : NothingMore(0) {}
        void prepare(const Context<S, true>&) {}
        void apply(S::Position&, const S::Velocity&, const Context<S, true>&) const {}
    };
};
static_assert(EffectIn<Acts<Place::before_forces>, S> && EffectIn<Acts<Place::end_of_step>, S> &&
              EffectIn<ActsOnMore, S>);
auto of_effects() {
    return use(World{SemiImplicitEuler{}, Acts<Place::before_forces>(1), Acts<Place::after_integration>(1),
                     Acts<Place::end_of_step>(1), ActsOnMore(1)});
}
auto of_effects_on_history() { return use(World{Verlet{}, Attraction{}, Acts<Place::end_of_step>(1), ActsOnMore(1)}); }

static_assert(EffectIn<Drag, Space<float, 2>> && EffectIn<Rest, S> && EffectIn<Interpolation, Space<float, 3>>);

// Near misses.
struct NoPlace {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        explicit In(const NoPlace&);
        void apply(typename Sp::Velocity&, const auto&) const;
    };
};
template <class Argument> struct Takes {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::end_of_step;
    template <class Sp> struct In {
        explicit In(const Takes&);
        void apply(Argument, const auto&) const;
    };
};
struct NoWrites {
    using role = roles::Effect;
    using reads = Columns<Velocity>;
    static constexpr Place place = Place::end_of_step;
    template <class Sp> struct In {
        explicit In(const NoWrites&);
        void apply(const typename Sp::Velocity&, const auto&) const;
    };
};
struct NotConst {
    using role = roles::Effect;
    using writes = Columns<Velocity>;
    static constexpr Place place = Place::end_of_step;
    template <class Sp> struct In {
        explicit In(const NotConst&);
        void apply(typename Sp::Velocity&, const auto&);
    };
};
static_assert(EffectIn<Takes<S::Velocity&>, S>); // what the others below just miss
static_assert(!EffectIn<NoPlace, S> && !EffectIn<Takes<S::Velocity>, S> && !EffectIn<Takes<const S::Velocity&>, S>);
static_assert(!EffectIn<Takes<S::Position&>, S>);
static_assert(!EffectIn<NoWrites, S> && !EffectIn<NotConst, S> && !EffectIn<Gravity, S>);
static_assert(!EffectIn<Takes<S::Velocity&>, Space<float, 2>>); // another space is another velocity

} // namespace ansatz::archetypes
