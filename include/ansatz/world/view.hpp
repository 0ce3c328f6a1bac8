// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Views: how forces that couple bodies, and observers, see a world. A view shows the columns that its policy declared
/// and no other; touching another one is one sentence at compile time.

#include <ansatz/world/bodies.hpp>
#include <ansatz/world/context.hpp>
#include <ansatz/world/elements.hpp>
#include <ansatz/world/row.hpp>
#include <ansatz/world/seen_tables.hpp>

#include <cstddef>
#include <span>

namespace ansatz {

/// What `Lanes` of any columns look like to a view: pointers by column, found once when the view is made.
template <class S, class P, class Declared> class ColumnsView {
public:
    using Scalar = typename S::Scalar;
    using Slot = Bodies::Slot;                          ///< a body's place in the lanes
    using State = typename detail::StateOr<P, S>::type; ///< what the policy keeps beside the bodies

    /// The columns, the bodies, and what the policy keeps beside them.
    template <class LanesT>
    ColumnsView(const LanesT& lanes, const Bodies& bodies, const State& state)
        : pointers_(collect(lanes, Declared{})), bodies_(&bodies), state_(&state) {}

    /// All bodies stand in slots 0 to size(): first the awake ones, then resting, moving, fixed.
    std::size_t size() const { return bodies_->size(); }
    /// The first slot of a kind of bodies.
    std::size_t begin(Motion m) const { return bodies_->begin(m); }
    /// Behind its last.
    std::size_t end(Motion m) const { return bodies_->end(m); }

    /// Whether the handle names a body that is there.
    bool contains(Handle h) const { return bodies_->contains(h); }
    /// Where that body is.
    Slot slot(Handle h) const { return bodies_->slot(h, "view"); }
    /// Where the body is that an element names.
    [[gnu::always_inline]] Slot slot(BodyId body) const { return bodies_->slot_of_id(body.id); }
    /// The handle of the body in a slot.
    Handle handle(std::size_t slot) const { return bodies_->handle(slot); }
    /// What the policy keeps beside the bodies, such as its springs.
    const State& state() const { return *state_; }
    /// Where the body with this id is; it must be there.
    [[gnu::always_inline]] Slot slot_of_id(std::uint32_t id) const { return bodies_->slot_of_id(id); }
    /// Its id: the order in which sums must run.
    std::uint32_t id(std::size_t slot) const { return bodies_->id(slot); }
    /// Fixed, moving or resting.
    Motion motion(std::size_t slot) const { return bodies_->motion(slot); }

    /// Calls `f(slot)` for every body by id, an order that sleeping, waking and removal do not change. Sums that must
    /// be the same to the bit are made in this order.
    template <class F> void for_each(F&& f) const {
        for (std::uint32_t id = 0; id < bodies_->ids(); ++id)
            if (bodies_->alive(id)) f(std::size_t(bodies_->slot_of_id(id)));
    }

    /// The value of a declared column.
    template <class C> [[gnu::always_inline]] value_of<C, S> get(std::size_t slot) const {
        check<C>();
        Scalar raw[detail::room_for<C, S>] = {};
        for (std::size_t k = 0; k < lanes_of<C>(S::dimension); ++k) raw[k] = pointers_[offset<C>() + k][slot];
        return detail::load<C, S>(raw);
    }
    /// One lane of a declared column: the raw SI scalars of one component.
    template <class C> std::span<const Scalar> lane(int component = 0) const {
        check<C>();
        return {pointers_[offset<C>() + std::size_t(component)], size()};
    }

protected:
    /// Handles, ids and slots.
    const Bodies& bodies() const { return *bodies_; }

private:
    template <class C> static constexpr void check() {
        static_assert(detail::contains<C, Declared>,
                      "Ansatz: a policy touches a column that it did not declare; add it to its `reads`, "
                      "e.g. `using reads = Columns<Position, Velocity>;`");
    }
    template <class C> static constexpr std::size_t offset() {
        if constexpr (detail::contains<C, Declared>) return detail::offset_in<C>(Declared{}, S::dimension);
        return 0;
    }
    static constexpr std::size_t width = detail::lane_count(Declared{}, S::dimension);

    template <class LanesT, class... C> static auto collect([[maybe_unused]] const LanesT& lanes, Columns<C...>) {
        std::array<const Scalar*, width + 1> all{};
        [[maybe_unused]] std::size_t next = 0;
        [[maybe_unused]] auto take = [&]<class One>(Columns<One>) {
            for (std::size_t k = 0; k < lanes_of<One>(S::dimension); ++k)
                all[next++] = lanes.template lane<One>(int(k));
        };
        (take(Columns<C>{}), ...);
        return all;
    }

    std::array<const Scalar*, width + 1> pointers_;
    const Bodies* bodies_;
    const State* state_;
};

/// What a force that couples bodies works on: its columns to read, and one way to write, `add_force`.
template <class S, class P> class CouplingView : public ColumnsView<S, P, detail::without_clock<P>> {
    using Base = ColumnsView<S, P, detail::without_clock<P>>;

public:
    /// The columns, the bodies, and what the policy keeps.
    template <class LanesT>
    CouplingView(LanesT& lanes, const Bodies& bodies, const typename Base::State& state) : Base(lanes, bodies, state) {
        for (int k = 0; k < S::dimension; ++k) force_[std::size_t(k)] = lanes.template lane<CoupledForce>(k);
    }

    /// Adds a force on one body. On a body of infinite mass it has no effect.
    [[gnu::always_inline]] void add_force(std::size_t slot, const typename S::Force& f) {
        for (int k = 0; k < S::dimension; ++k) force_[std::size_t(k)][slot] += f.value()[k];
    }
    /// Newton's third law: `f` on the first body, `-f` on the second (notes 1.3).
    [[gnu::always_inline]] void add_force_pair(std::size_t on, std::size_t from, const typename S::Force& f) {
        add_force(on, f);
        add_force(from, -f);
    }

private:
    std::array<typename S::Scalar*, 3> force_{};
};

/// What an observer sees: the columns that it reads, and the tables that it says it sees (seen_tables.hpp).
template <class S, class P> class ObserverView : public ColumnsView<S, P, detail::without_clock<P>> {
    using Base = ColumnsView<S, P, detail::without_clock<P>>;

public:
    /// Of what a world holds.
    template <class Data>
    explicit ObserverView(const Data& data)
        : Base(data.lanes, data.bodies, data.template state<P>()),
          tables_(Tables::in(data)),
          time_(data.clock.now()),
          tick_(data.clock.tick()) {}

    /// A table that it sees: what policy `Q` keeps, or what a module names, such as `Contacts`.
    template <class Q> const auto& table() const { return tables_.template get<Q>(); }

    /// The world's time, s.
    const typename S::ClockTime& time() const { return time_; }
    /// The steps so far.
    std::uint64_t tick() const { return tick_; }

private:
    using Tables = SeenTables<S, detail::sees_of<P>>;
    [[no_unique_address]] Tables tables_;
    typename S::ClockTime time_;
    std::uint64_t tick_;
};

} // namespace ansatz
