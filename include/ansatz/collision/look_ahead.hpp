// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `LookAhead`: how far bodies may come in the next step, for responses that act before two bodies touch
/// (`SoftSubsteps`; beyond the notes, whose section 2.2 answers intersections). Boxes are widened by it, and of the
/// pairs that the broadphase finds those are kept that may meet (notes 2.1).

#include <ansatz/collision/contact.hpp>
#include <ansatz/units.hpp>
#include <ansatz/world/bodies.hpp>
#include <ansatz/world/columns.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ansatz {

namespace detail {
struct NotAhead {}; // in its place
} // namespace detail

/// Of the bodies that move; it keeps its room.
template <class S> class LookAhead {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// Room for so many bodies.
    void reserve(std::size_t n) { all_.reserve(n); }
    /// From the velocities and accelerations of all bodies that move.
    /// \param step     its length
    /// \param pull     a function of a slot: the acceleration of an awake body, m/s^2
    /// \param velocity a function of a slot: its velocity, m/s
    template <class Pull, class Going>
    [[gnu::flatten]] void begin(const Bodies& bodies, const typename S::Time& step, const Pull& pull,
                                const Going& velocity) {
        all_.resize(bodies.size());
        const Scalar dt = step.value();
        for (const auto motion : {Motion::awake, Motion::moving})
            for (std::size_t slot = bodies.begin(motion); slot < bodies.end(motion); ++slot) {
                auto& ahead = all_[slot];
                ahead.way = (Scalar(1.1) * dt) * velocity(Bodies::Slot(slot)).value();
                ahead.slack = motion == Motion::awake ? norm(pull(Bodies::Slot(slot))).value() * dt * dt : Scalar(0);
                ahead.margin = norm(ahead.way) + ahead.slack;
            }
    }
    /// A body's box, made as much larger as it may come.
    void widen(const Bodies& bodies, std::size_t slot, typename S::Position& lower, typename S::Position& upper) {
        if (!bodies.goes(slot)) return;
        auto& ahead = all_[slot];
        auto by = (upper - lower).value();
        const Scalar pushed = Scalar(1) / 256 * by.minCoeff(); // by one that is faster
        ahead.slack += pushed;
        ahead.margin += pushed;
        for (int k = 0; k < S::dimension; ++k) by[k] = ahead.margin;
        lower -= S::Position::from_value(by);
        upper += S::Position::from_value(by);
    }
    /// The narrowphase of two bodies that will touch in the next step, if they go on so: not of two that fall abreast.
    template <class Narrowphase, class Data>
    [[gnu::always_inline]] bool meet(const Data& data, std::uint32_t a, std::size_t slot_a, std::uint32_t b,
                                     std::size_t slot_b, Contact<S>& contact) const {
        const auto xa = data.lanes.template get<Position>(slot_a), xb = data.lanes.template get<Position>(slot_b);
        return Narrowphase::template nearly_collide<S>(data.collisions.shapes, a, xa, b, xb,
                                                       margin(data.bodies, slot_a, slot_b), contact) &&
               (contact.depth.value() >= Scalar(0) || closes(data.bodies, slot_a, slot_b, -contact.depth.value()));
    }
    /// How far apart two bodies may be and still meet within the step.
    [[gnu::always_inline]] typename S::Length margin(const Bodies& bodies, std::size_t a, std::size_t b) const {
        return S::Length::from_value(of(bodies, a).margin + of(bodies, b).margin);
    }
    /// Whether two bodies with this gap meet within the step if they go on as they do: not two that fall side by side.
    /// \param gap m
    [[gnu::always_inline]] bool closes(const Bodies& bodies, std::size_t a, std::size_t b, Scalar gap) const {
        const Ahead &one = of(bodies, a), &other = of(bodies, b);
        return gap <= norm(Raw(one.way - other.way)) + one.slack + other.slack;
    }

private:
    /// How far a body comes in the next step if it goes on as it does: by its speed, and slack for pulls and pushes.
    struct Ahead {
        Raw way = Raw::Zero();      // m
        Scalar slack{0}, margin{0}; // m; both together
    };
    const Ahead& of(const Bodies& bodies, std::size_t slot) const { return bodies.goes(slot) ? all_[slot] : still_; }

    std::vector<Ahead> all_; // by slot; of those that move
    Ahead still_;
};

} // namespace ansatz
