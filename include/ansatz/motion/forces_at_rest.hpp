// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ForcesAtRest`: what forces between bodies would be if those that may fall asleep stood still (notes 1.1, 1.8).
///
/// A body that creeps on a strong damper is slow, and the damper balances what pulls at it. But it holds no body that
/// stands still: asked with the velocities that bodies have, its force would let them fall asleep far from where they
/// go.

#include <ansatz/motion/coupling.hpp>

#include <cstddef>
#include <vector>

namespace ansatz {

/// While it lives, the column CoupledForce has the sums of bodies that stand still, where a force between bodies reads
/// their velocity; without such a force it does nothing.
/// \tparam C the composition
template <class C> class ForcesAtRest {
public:
    /// \param slow    whether the awake body of a slot is to stand still; where none is, nothing is summed
    /// \param context of the state that the bodies are in
    template <class Policies, class Slow>
    ForcesAtRest(WorldData<C>& data, const Policies& policies, const Context<typename C::S>& context, const Slow& slow)
        : velocities_(data) {
        if constexpr (reads_velocity) {
            velocities_.make_room();
            bool any = false;
            for (std::size_t slot = 0; slot < data.bodies.end(Motion::awake) && !any; ++slot) any = slow(slot);
            if (!any) return;
            derive_velocities(data, policies, context.dt().previous);
            velocities_.save();
            for (std::size_t slot = 0; slot < data.bodies.end(Motion::awake); ++slot)
                if (slow(slot)) data.lanes.template set<Velocity>(slot, zero());
            data.coupled.current = false;
            sum_coupled(data, policies, context);
        }
    }
    /// Whether the sums are others now, so that they must be refreshed afterwards.
    bool any() const { return velocities_.saved; }

private:
    static constexpr bool reads_velocity = [] {
        if constexpr (C::coupled) return C::template couplings_read<Velocity>;
        else return false;
    }();
    static auto zero() { return C::S::template zero_vector<unit::Velocity>(); }

    /// Puts them back, whatever happens.
    struct Velocities {
        WorldData<C>& data;
        bool saved = false;

        explicit Velocities(WorldData<C>& d) : data(d) {}
        Velocities(const Velocities&) = delete;
        Velocities& operator=(const Velocities&) = delete;
        ~Velocities() {
            if constexpr (reads_velocity)
                if (saved) each([](auto& lane, auto& kept) { lane = kept; });
        }
        void make_room() {
            const std::size_t n = data.bodies.size() * std::size_t(C::S::dimension);
            if (data.velocities.value.capacity() < n) data.velocities.value.reserve(2 * n);
        }
        void save() {
            data.velocities.value.resize(data.bodies.end(Motion::awake) * std::size_t(C::S::dimension));
            each([](auto& lane, auto& kept) { kept = lane; });
            saved = true;
        }
        void each(const auto& f) {
            auto kept = data.velocities.value.begin();
            for (int k = 0; k < C::S::dimension; ++k) {
                auto* lane = data.lanes.template lane<Velocity>(k);
                for (std::size_t slot = 0; slot < data.bodies.end(Motion::awake); ++slot) f(lane[slot], *kept++);
            }
        }
    };
    Velocities velocities_;
};

} // namespace ansatz
