// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Rows: what a joint of your own asks of two bodies, solved with the contacts, in each substep of `SoftSubsteps`.
///
/// A row is one number that should be zero (how much too long a rod is), the direction along which the bodies change
/// it, and the impulse that holds them. A policy of any role gives them anew in each substep, from where the bodies are
/// then:
///
///     template <class S> struct Rows {
///         using reads = Columns<Position>;
///         explicit Rows(const MyRods&) {}
///         void rows(auto& view, auto&& row) const {
///             view.state().for_each([&](std::uint32_t, auto& rod) { row(SolverRow<S>{...}); });
///         }
///     };
///
/// The impulse is kept by the element, as one of its fields: it begins the next substep (warm start), and is copied,
/// hashed and saved with it. Rows are solved in the order in which they are given, before the contacts of each pass, so
/// that of the two it is the contacts that hold to the last. Softness is that of the response; a row that may only pull
/// or only push acts ahead, as contacts do.
///
/// E. Catto, Soft Constraints (GDC 2011), and Solver2D (2024).

#include <ansatz/collision/response/soft_contacts.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace ansatz {

/// What is asked of two bodies, or of a body and a point.
template <class S> struct SolverRow {
    using Scalar = typename S::Scalar;
    using Impulse = typename S::template ScalarOf<unit::Impulse>; ///< N s
    static constexpr std::uint32_t point = 0xffffffffu;           ///< in the place of a second body: what nothing moves

    std::uint32_t first;  ///< the slot of a body
    std::uint32_t second; ///< that of another, or `point`
    Vector<Scalar, S::dimension>
        direction;          ///< of length 1: where the first is pushed by a positive impulse, the second opposite
    typename S::Length off; ///< how much too far the first is along the direction; less than zero: too little, m
    Impulse* impulse;       ///< what holds them, N s: of the substep before, and then of this one
    Scalar least = -std::numeric_limits<Scalar>::infinity(); ///< N s: 0 for what only pushes
    Scalar most = std::numeric_limits<Scalar>::infinity();   ///< N s: 0 for what only pulls
};

/// The rows of a substep, and the passes over them.
template <class S> class SolverRows {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI
    using Body = SolverBody<S>;               ///< what is solved for

    /// Room for so many bodies.
    void reserve(std::size_t n) { without_contacts_.reserve(n); }
    /// Before those of a substep are given.
    void clear() { all_.clear(); }
    /// One of them; those between bodies that nothing moves are left out.
    void add(const SolverRow<S>& row, const std::vector<Body>& bodies) {
        const Scalar wb = row.second == row.point ? Scalar(0) : bodies[row.second].weight;
        const Scalar w = bodies[row.first].weight + wb;
        if (w > Scalar(0)) all_.push_back({row, 1 / w, Scalar(0)});
    }
    /// Whether there are none.
    bool empty() const { return all_.empty(); }

    /// The impulses of the substep before act again. To contacts, what rows do is one more acceleration.
    /// \param before by slot: the velocities before, m/s
    /// \param kicks  by slot: what acceleration does to a velocity in a substep, m/s
    void warm_start(std::vector<Body>& bodies, const std::vector<Raw>& before, std::vector<Raw>& kicks) {
        for (const auto& one : all_) push(bodies, one.row, one.row.impulse->value());
        remember(bodies);
        for (std::size_t slot = 0; slot < before.size(); ++slot)
            if (bodies[slot].weight > Scalar(0)) kicks[slot] += without_contacts_[slot] - before[slot];
    }
    /// One pass that takes away what is wrong, softly.
    /// \param h s, the substep
    void solve(std::vector<Body>& bodies, Scalar h, const Softness<Scalar>& soft, std::vector<Raw>& kicks) {
        for (auto& one : all_) one.change = -one.row.impulse->value();
        for (const auto& one : all_) {
            const Scalar off = one.row.off.value();
            if (ahead(one.row)) press(bodies, one, off / h, Scalar(1), Scalar(0));
            else press(bodies, one, soft.rate * off, soft.mass, soft.impulse);
        }
        const auto add = [&](std::uint32_t slot, const Raw& by) {
            without_contacts_[slot] += bodies[slot].weight * by;
            kicks[slot] += bodies[slot].weight * by;
        };
        for (const auto& one : all_) {
            const Raw by = (one.change + one.row.impulse->value()) * one.row.direction;
            add(one.row.first, by);
            if (one.row.second != one.row.point) add(one.row.second, Raw(-by));
        }
    }
    /// What contacts have changed in this substep, by slot, m/s.
    void take_out(const std::vector<Body>& bodies, std::vector<Raw>& pushed) const {
        for (std::size_t slot = 0; slot < bodies.size(); ++slot)
            if (bodies[slot].weight > Scalar(0)) pushed[slot] = bodies[slot].u - without_contacts_[slot];
    }
    /// By slot: the velocities without what contacts have changed in this pass, m/s.
    const std::vector<Raw>& without_contacts() const { return without_contacts_; }
    /// One pass that takes back the velocity which only corrected.
    void relax(std::vector<Body>& bodies, Scalar h) {
        for (const auto& one : all_) {
            if (!ahead(one.row)) press(bodies, one, Scalar(0), Scalar(1), Scalar(0));
            else if (one.row.impulse->value() != Scalar(0))
                press(bodies, one, one.row.off.value() / h, Scalar(1), Scalar(0));
        }
        remember(bodies);
    }

private:
    struct One {
        SolverRow<S> row;
        Scalar mass;      // 1 / (w_a + w_b), kg
        Scalar change{0}; // of its impulse in a pass, N s
    };
    void remember(const std::vector<Body>& bodies) {
        without_contacts_.resize(bodies.size());
        for (std::size_t slot = 0; slot < bodies.size(); ++slot) without_contacts_[slot] = bodies[slot].u;
    }
    /// Whether it does not hold yet: a slack rope, two that do not touch.
    static bool ahead(const SolverRow<S>& row) {
        const Scalar off = row.off.value();
        return (off < Scalar(0) && !(row.most > Scalar(0))) || (off > Scalar(0) && !(row.least < Scalar(0)));
    }
    static void push(std::vector<Body>& bodies, const SolverRow<S>& row, Scalar impulse) {
        bodies[row.first].u += (bodies[row.first].weight * impulse) * row.direction;
        if (row.second != row.point) bodies[row.second].u -= (bodies[row.second].weight * impulse) * row.direction;
    }
    void press(std::vector<Body>& bodies, const One& one, Scalar bias, Scalar mass_share, Scalar impulse_share) {
        Raw between = bodies[one.row.first].u;
        if (one.row.second != one.row.point) between -= bodies[one.row.second].u;
        const Scalar before = one.row.impulse->value(),
                     j = -one.mass * mass_share * (dot(between, one.row.direction) + bias) - impulse_share * before,
                     now = std::clamp(before + j, one.row.least, one.row.most);
        push(bodies, one.row, now - before);
        *one.row.impulse = SolverRow<S>::Impulse::from_value(now);
    }

    std::vector<One> all_;
    std::vector<Raw> without_contacts_;
};

namespace detail {
/// Whether a policy gives rows.
template <class S> struct GivesRowsIn {
    template <class P> struct Is : std::bool_constant < requires {
        typename P::template Rows<S>;
    } > {};
};
} // namespace detail

} // namespace ansatz
