// SPDX-License-Identifier: BSL-1.0
// ObserverIn: archetypes, two models, near misses.

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

struct Looks : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Observer;
    using reads = Columns<Position>;
    void observe(const ObserverView<S, Looks>&) {}
};
/// An observer need not read: Keep and Datum only declare.
struct Declares : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Observer;
};
static_assert(ObserverIn<Looks, S> && ObserverIn<Declares, S>);
auto of_observers() { return use(World{SemiImplicitEuler{}, Looks(1), Declares(1)}); }

static_assert(ObserverIn<Keep<InverseMass>, S> && ObserverIn<Datum<int>, Space<float, 2>>);

// Near misses.
struct Writes {
    using role = roles::Observer;
    using writes = Columns<Position>;
};
struct WantsToChange {
    using role = roles::Observer;
    using reads = Columns<Position>;
    void observe(ObserverView<S, WantsToChange>& view);
};
struct WantsMore {
    using role = roles::Observer;
    using reads = Columns<Position>;
    void observe(const auto& view, int more);
};
struct Private {
    using role = roles::Observer;

private:
    void observe(const auto& view);
};
static_assert(!ObserverIn<Writes, S> && !ObserverIn<WantsToChange, S> && !ObserverIn<WantsMore, S> &&
              !ObserverIn<Private, S>);
static_assert(!ObserverIn<Drag, S> && !ObserverIn<int, S>);

} // namespace ansatz::archetypes
