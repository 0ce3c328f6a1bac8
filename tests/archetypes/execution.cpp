// SPDX-License-Identifier: BSL-1.0
// ExecutionPolicy: archetypes, two models, near misses.

#include "tests/archetypes/archetype.hpp"

#include <functional>

namespace ansatz::archetypes {

struct InOnePart : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(0, count); }
};
static_assert(ExecutionPolicy<InOnePart>);
auto of_execution() { return use(World{SemiImplicitEuler{}, InOnePart(1)}); }

/// Last part first, and a loop by a type that is no template.
struct Backwards {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& loop) const {
        for (std::size_t part = count / grain + 1; part-- > 0;)
            loop(part * grain, part * grain + grain < count ? part * grain + grain : count);
    }
};
static_assert(ExecutionPolicy<Backwards>);
auto of_backwards() { return use(World{RungeKutta4{}, Space<float, 2>{}, Gravity{}, Backwards{}}); }

// Near misses: one that changes itself, one that is told no grain, one that nobody outside can call, one without a
// role.
struct ChangesItself {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t grain, const auto& loop);
};
struct WithoutGrain {
    using role = roles::Execution;
    void execute(std::size_t count, const auto& loop) const;
};
struct OfOneIndex {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t grain, const std::function<void(std::size_t)>& loop) const;
};
struct Hidden {
    using role = roles::Execution;

private:
    void execute(std::size_t count, std::size_t grain, const auto& loop) const;
};
struct NoRole {
    void execute(std::size_t count, std::size_t grain, const auto& loop) const;
};
static_assert(!ExecutionPolicy<ChangesItself> && !ExecutionPolicy<WithoutGrain> && !ExecutionPolicy<OfOneIndex> &&
              !ExecutionPolicy<Hidden> && !ExecutionPolicy<NoRole>);
static_assert(!ExecutionPolicy<Drag> && !ExecutionPolicy<int>);

} // namespace ansatz::archetypes
