// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StillForces`: forces between bodies that rest, kept from step to step (notes 1.1: nothing is computed for a body at
/// rest).
///
/// An element whose ends all rest, or are fixed, pulls today as it did yesterday. Where most elements are such, a sum
/// of forces goes through the others alone: those of bodies that move, and those of sleepers that hang on one. The sums
/// of all other sleepers stay in their column, and it is not asked whether they still sleep. A change of any kind (a
/// body that wakes, sleeps, comes, goes or is put elsewhere, an element that is another) is seen by numbers that change
/// with it; then everything is summed once, and again once nothing has changed since.

#include <ansatz/motion/gathering.hpp>
#include <ansatz/motion/state.hpp>
#include <ansatz/world/view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <tuple>
#include <utility>

namespace ansatz {

namespace detail {
/// Whether a force between bodies follows from its elements' ends alone, and says when its elements are others.
template <class Q, class S> constexpr bool follows_from_ends() {
    if constexpr (keeps_state<Q, S> && !reads_clock<Q>)
        if constexpr (requires(const state_of<Q, S>& state) { state.arrangement(); }) return GatheredCouplingIn<Q, S>;
    return false;
}
/// Whether all forces between bodies of a world do, and nothing else hangs them together.
template <class C> constexpr bool keeps_still_forces() {
    if constexpr (C::coupled && C::islands)
        return []<class... Q>(Types<Q...>) {
            return C::element_keepers::size == sizeof...(Q) && (follows_from_ends<Q, typename C::S>() && ...);
        }(typename C::couplings{});
    else return false;
}

/// What is needed to sum forces between bodies.
template <class Q, class C> struct AskedForce {
    using S = typename C::S;
    CouplingView<S, Q> view;
    Bound<Q, S> force;
    Context<S, reads_clock<Q>> context;

    template <class Policies>
    AskedForce(WorldData<C>& data, const Policies& policies, const Context<S>& now)
        : view(data.lanes, data.bodies, std::as_const(data).template state<Q>()),
          force(std::get<Q>(policies)),
          context(now.template restricted<reads_clock<Q>>()) {
        if constexpr (requires { force.prepare(context); }) force.prepare(context);
    }
};
} // namespace detail

/// The elements that act on bodies which move, or on sleepers that hang on one, while all others do what they did.
/// \tparam C the composition
template <class C> class StillForces {
public:
    using S = typename C::S; ///< the space

    /// Whether all that is kept is of the world as it stands.
    bool holds(WorldData<C>& data) { return known_ && same(data); }
    /// All forces have been summed. When they are summed again, and nothing has changed since, they are kept.
    template <class Policies> void note_sum(WorldData<C>& data, const Policies& policies, const Context<S>& context) {
        try {
            make_room(data);
            if (data.bodies.count(Motion::resting) < fewest) return;
            if (!same(data)) {
                known_ = tried_ = asked_ = false;
                changes_ = data.bodies.changes();
                elements_ = elements_of(data);
            } else if (!tried_) {
                tried_ = true;
                known_ = find(data, policies, context);
            }
        } catch (const std::bad_alloc&) { // without room for them all forces are summed
            known_ = false;
        }
    }
    /// Sums the forces on those for which they are not kept.
    template <class Policies> void sum(WorldData<C>& data, const Policies& policies, const Context<S>& context) const {
        for (int k = 0; k < S::dimension; ++k) {
            auto* lane = data.lanes.template lane<CoupledForce>(k);
            for (const auto motion : {Motion::awake, Motion::moving})
                std::fill(lane + data.bodies.begin(motion), lane + data.bodies.end(motion), typename S::Scalar(0));
            for (const auto slot : border_) lane[slot] = typename S::Scalar(0);
            for (const auto slot : hooks_) lane[slot] = typename S::Scalar(0);
        }
        each([&]<class Q>(const auto& acting) { sum_one<Q>(data, policies, context, acting); });
    }
    /// Sleepers that hang on a body which moves, from the last slot to the first.
    const std::vector<Bodies::Slot>& border() const { return border_; }
    /// Whether all sleepers were asked since anything has changed, and sleep on: then only `border` need be asked.
    bool asked() const { return asked_; }
    /// They have been.
    void note_asked() { asked_ = true; }
    /// Whether a body that moves, and on which a sleeper hangs, has a property.
    /// \param has a function of its slot
    bool any_mover(const auto& has) const { return std::any_of(movers_.begin(), movers_.end(), has); }

private:
    static constexpr std::size_t fewest = 16; // with fewer sleepers it is as quick to go through all
    static constexpr std::size_t couplings = C::couplings::size;
    using Elements = std::array<std::uint64_t, couplings>;

    static Elements elements_of(WorldData<C>& data) {
        return []<class... Q>(WorldData<C>& of, Types<Q...>) {
            (of.template state<Q>().arrange(of.bodies, of.states.layout), ...);
            return Elements{of.template state<Q>().arrangement()...};
        }(data, typename C::couplings{});
    }
    bool same(WorldData<C>& data) const {
        if (changes_ != data.bodies.changes()) return false;
        const Elements now = elements_of(data);
        bool all = true; // not ==, which calls a function for eight bytes
        for (std::size_t n = 0; n < couplings; ++n) all = all && elements_[n] == now[n];
        return all;
    }
    /// With everything inlined, as in `couple` of a force.
    template <class Q, class Policies>
    [[gnu::flatten]] void sum_one(WorldData<C>& data, const Policies& policies, const Context<S>& context,
                                  const std::vector<std::uint32_t>& acting) const {
        detail::AskedForce<Q, C> in(data, policies, context);
        const std::uint8_t* summed = summed_.data();
        const std::size_t size = in.view.size();
        for (const auto k : acting) {
            const auto ends = in.force.ends(std::as_const(in.view), k);
            const auto forces = in.force.forces(std::as_const(in.view), k, in.context);
            for (std::size_t end = 0; end < ends.size(); ++end)
                if (ends[end] < size && summed[ends[end]]) in.view.add_force(ends[end], forces[end]);
        }
    }
    /// Calls `f.operator()<Q>(elements)` for each force, with those that act.
    void each(auto&& f) const {
        std::size_t n = 0;
        [&]<class... Q>(Types<Q...>) { (f.template operator()<Q>(acting_[n++]), ...); }(typename C::couplings{});
    }
    /// \return whether it is worth it
    template <class Policies> bool find(WorldData<C>& data, const Policies& policies, const Context<S>& context) {
        const auto& bodies = data.bodies;
        summed_.assign(bodies.size(), 0);
        for (const auto motion : {Motion::awake, Motion::moving})
            std::fill(summed_.begin() + std::ptrdiff_t(bodies.begin(motion)),
                      summed_.begin() + std::ptrdiff_t(bodies.end(motion)), 1);
        find_border(data, policies, context);
        std::size_t all = 0, act = 0, n = 0;
        each([&]<class Q>(const auto&) {
            auto& acting = acting_[n++];
            acting.clear();
            detail::AskedForce<Q, C> in(data, policies, context);
            const std::size_t count = in.force.element_count(std::as_const(in.view));
            for (std::size_t k = 0; k < count; ++k) {
                const auto ends = in.force.ends(std::as_const(in.view), k);
                if (std::any_of(ends.begin(), ends.end(), [&](auto e) { return e < bodies.size() && summed_[e]; }))
                    acting.push_back(std::uint32_t(k));
            }
            all += count;
            act += acting.size();
        });
        return (C::executed ? 8 : 2) * act <= all; // what is kept is summed by one thread
    }
    /// The sleepers and the fixed bodies that share an element with one that moves: all that acts on them is summed.
    template <class Policies>
    void find_border(WorldData<C>& data, const Policies& policies, const Context<S>& context) {
        const auto& bodies = data.bodies;
        border_.clear();
        hooks_.clear();
        movers_.clear();
        each([&]<class Q>(const auto&) {
            detail::AskedForce<Q, C> in(data, policies, context);
            const std::size_t count = in.force.element_count(std::as_const(in.view));
            for (std::size_t k = 0; k < count; ++k) {
                const auto ends = in.force.ends(std::as_const(in.view), k);
                const auto is = [&](auto&& what) {
                    return std::any_of(ends.begin(), ends.end(), [&](auto e) { return e < bodies.size() && what(e); });
                };
                if (!is([&](auto e) { return bodies.goes(e); })) continue;
                const bool rests = is([&](auto e) { return bodies.motion(Bodies::Slot(e)) == Motion::resting; });
                for (const auto end : ends) {
                    if (end >= bodies.size()) continue;
                    if (bodies.goes(end)) {
                        if (rests) movers_.push_back(Bodies::Slot(end));
                    } else if (!summed_[end]) {
                        summed_[end] = 1;
                        (bodies.motion(Bodies::Slot(end)) == Motion::resting ? border_ : hooks_)
                            .push_back(Bodies::Slot(end));
                    }
                }
            }
        });
        std::sort(border_.begin(), border_.end(), std::greater<>());
    }
    /// For all that may be searched for, so that a step in which bodies fall asleep needs none.
    void make_room(WorldData<C>& data) {
        const std::size_t n = data.bodies.size();
        if (summed_.capacity() < n) {
            summed_.reserve(2 * n);
            border_.reserve(2 * n);
            hooks_.reserve(2 * n);
        }
        std::size_t all = 0, place = 0;
        [&]<class... Q>(Types<Q...>) {
            ((acting_[place].capacity() < data.template state<Q>().ids()
                  ? acting_[place].reserve(2 * data.template state<Q>().ids())
                  : void(),
              all += data.template state<Q>().ids(), ++place),
             ...);
        }(typename C::couplings{});
        if (movers_.capacity() < 2 * all) movers_.reserve(4 * all);
    }

    std::array<std::vector<std::uint32_t>, couplings> acting_; // of each force, in their order
    std::vector<std::uint8_t> summed_;                         // by slot: whether it is one of those below
    std::vector<Bodies::Slot> border_;                         // sleepers that hang on moving bodies
    std::vector<Bodies::Slot> hooks_;                          // fixed bodies on which moving bodies hang
    std::vector<Bodies::Slot> movers_;                         // bodies on which sleepers hang
    std::uint64_t changes_ = 0;                                // what those of the bodies were
    Elements elements_{};                                      // and of the elements
    bool tried_ = false, known_ = false, asked_ = false;
};

} // namespace ansatz
