// SPDX-License-Identifier: BSL-1.0
// CouplingIn: an archetype, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

struct Couples : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    template <class> struct In : NothingMore {
        explicit In(const Couples&) : NothingMore(0) {}
        void couple(CouplingView<S, Couples>& view, const Context<S, false>&) const { view.add_force(0, S::Force()); }
    };
};
static_assert(CouplingIn<Couples, S> && ForceIn<Couples, S> && !LawIn<Couples, S>);
auto of_coupling() { return use(World{RungeKutta4{}, Couples(1)}); }

// Models: the library's, and one that also prepares and knows the time.
struct Gust {
    using role = roles::Force;
    using reads = Columns<Clock>;
    static constexpr bool couples_bodies = true;
    template <class Sp> struct In {
        explicit In(const Gust&) {}
        void prepare(const auto& context) { (void)context.time(); }
        void couple(auto&, const auto&) const {}
    };
};
static_assert(CouplingIn<Attraction, S> && CouplingIn<Attraction, Space<float, 2>> && CouplingIn<Gust, S>);
auto of_gust() { return use(World{Verlet{}, Gust{}}); }

// Near misses.
struct DoesNotSaySo {
    using role = roles::Force;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const DoesNotSaySo&);
        void couple(auto&, const auto&) const;
    };
};
struct SaysNo : DoesNotSaySo {
    static constexpr bool couples_bodies = false;
};
struct WithoutContext {
    using role = roles::Force;
    using reads = Columns<>;
    static constexpr bool couples_bodies = true;
    template <class Sp> struct In {
        explicit In(const WithoutContext&);
        void couple(auto&) const;
    };
};
struct NoColumns {
    using role = roles::Force;
    static constexpr bool couples_bodies = true;
    template <class Sp> struct In {
        explicit In(const NoColumns&);
        void couple(auto&, const auto&) const;
    };
};
struct OfAnotherKind { // a law that says it couples
    using role = roles::Force;
    using reads = Columns<>;
    static constexpr bool couples_bodies = true;
    template <class Sp> struct In {
        explicit In(const OfAnotherKind&);
        typename Sp::Acceleration acceleration(const auto&) const;
    };
};
static_assert(!CouplingIn<DoesNotSaySo, S> && !CouplingIn<SaysNo, S> && !CouplingIn<WithoutContext, S> &&
              !CouplingIn<NoColumns, S>);
static_assert(!CouplingIn<OfAnotherKind, S> && !ForceIn<OfAnotherKind, S> && !CouplingIn<Gravity, S>);

} // namespace ansatz::archetypes
