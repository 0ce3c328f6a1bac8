// SPDX-License-Identifier: BSL-1.0
// StepControlFor: an archetype, two models, near misses.

#include "tests/archetypes/archetype.hpp"

#include <ansatz/springs/step_limit.hpp>

namespace ansatz::archetypes {

struct Decides : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::StepControl;
    struct Kept {};
    template <class W> int parts(const W&, const Quantity<unit::Time>&, Kept&) const { return 1; }
};
using W = World<SemiImplicitEuler>;
static_assert(StepControlFor<Decides, W>);
auto of_control() { return use(World{SemiImplicitEuler{}, Decides(1)}); }

static_assert(StepControlFor<StepLimit<Refuse>, W> &&
              StepControlFor<StepLimit<Divide>, World<RungeKutta4, Space<float, 2>>>);

// Near misses: nothing to keep, an answer that is no number of substeps, one that changes itself, one without a role.
struct KeepsNothing {
    using role = roles::StepControl;
    int parts(const auto&, const Quantity<unit::Time>&, auto&) const;
};
struct AnswersWithATime {
    using role = roles::StepControl;
    struct Kept {};
    Quantity<unit::Time> parts(const auto&, const Quantity<unit::Time>&, Kept&) const;
};
struct ChangesItself {
    using role = roles::StepControl;
    struct Kept {};
    int parts(const auto&, const Quantity<unit::Time>&, Kept&);
};
struct WithoutRole {
    struct Kept {};
    int parts(const auto&, const Quantity<unit::Time>&, Kept&) const;
};
static_assert(!StepControlFor<KeepsNothing, W> && !StepControlFor<AnswersWithATime, W> &&
              !StepControlFor<ChangesItself, W>);
static_assert(!StepControlFor<WithoutRole, W> && !StepControlFor<Drag, W>);

} // namespace ansatz::archetypes
