// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ColouredSoftContacts`: the contacts of `SoftSubsteps<Coloured>`. Beyond the notes.
///
/// They are SoftContacts, which keeps them, hashes and saves them; only the passes over them are those of
/// ContactColours. The impulses are in two places: while `ahead_` says so, those of the colours are the newer ones, and
/// whoever asks for the others is given what they are now.

#include <ansatz/collision/response/contact_colours.hpp>
#include <ansatz/collision/response/soft_contacts.hpp>
#include <ansatz/world/execution.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam Rubs whether there is friction
template <class S, bool Rubs> class ColouredSoftContacts : public SoftContacts<S, Rubs> {
    using Base = SoftContacts<S, Rubs>;

public:
    using typename Base::Raw;
    using typename Base::Scalar;

    /// \name The passes
    /// @{
    /// The impulses of the substep before act again.
    void warm_start() {
        if (stale_) {
            colours_.colour(this->all, this->acting_, this->bodies, this->awake(), ids_, run_);
            stale_ = false;
        }
        colours_.warm_start(this->bodies, run_);
    }
    /// As SoftContacts::solve.
    void solve(Scalar h, const Softness<Scalar>& soft, const Softness<Scalar>& soft_held, Scalar slop,
               Scalar push_out) {
        colours_.solve(this->bodies, {h, soft, soft_held, slop, push_out, true}, run_);
        ahead_ = true;
    }
    /// As SoftContacts::relax.
    void relax(Scalar h) {
        colours_.solve(this->bodies, {h, {}, {}, Scalar(0), Scalar(0), false}, run_);
        ahead_ = true;
    }
    /// @}

    /// \name What asks for the impulses, or changes which contacts there are
    /// @{
    template <class F> void each_acting(F&& f) {
        catch_up();
        Base::each_acting(std::forward<F>(f));
    }
    void unload(const std::vector<Raw>& before) {
        if (!this->loads_.take_off(*this, before)) return;
        colours_.read_impulses(this->all);
        warm_start();
    }
    bool calm(const std::vector<Raw>& before) {
        const bool any = this->islands_.calm(*this, before, this->platforms_);
        if (any) colours_.read_impulses(this->all);
        return any;
    }
    template <class Data, class Contacts> void take(const Data& data, const Contacts& contacts) {
        change();
        Base::take(data, contacts);
    }
    void wake_contacts() {
        change();
        Base::wake_contacts();
    }
    template <class Data, class FrictionOf> void begin(const Data& data, const FrictionOf& friction) {
        change();
        ids_ = data.bodies.ids();
        Base::begin(data, friction);
    }
    void weigh() {
        change();
        Base::weigh();
    }
    void body_divided(std::uint32_t id, std::uint32_t part, const Scalar& share) {
        change();
        Base::body_divided(id, part, share);
    }
    /// What runs the passes, until the step ends.
    void run_by(const LoopRunner& run) { run_ = run; }
    /// A step ends.
    void finish() {
        change();
        run_ = {};
    }
    void make_room_for(const ColouredSoftContacts& other) {
        Base::make_room_for(other);
        colours_.make_room_for(other.colours_);
    }
    /// @}

private:
    void catch_up() {
        if (!std::exchange(ahead_, false)) return;
        colours_.write_impulses(this->all);
    }
    void change() {
        catch_up();
        stale_ = true;
    }

    ContactColours<S, Rubs> colours_;
    LoopRunner run_;
    std::size_t ids_ = 0; // of all bodies
    bool ahead_ = false;  // the impulses of the colours are newer
    bool stale_ = true;   // the colours are those of other contacts
};

} // namespace ansatz
