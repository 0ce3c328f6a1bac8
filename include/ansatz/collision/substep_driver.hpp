// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SubstepDriver`: a step in substeps, by a response that owns substeps (`SoftSubsteps`). Before each substep contacts
/// and joints take away what is wrong with the velocities; behind it, what only corrected. (Beyond the notes.)

#include <ansatz/collision/hit_sleepers.hpp>
#include <ansatz/collision/step.hpp>
#include <ansatz/collision/substeps.hpp>
#include <ansatz/motion/policy_systems.hpp>

#include <utility>

namespace ansatz {

/// The driver of the phases from `substeps` to `contacts`.
template <class StepT> class SubstepDriver : public CollisionStep<StepT> {
    using Base = CollisionStep<StepT>;
    using Base::bound_;
    using Base::context_;
    using Base::data_;
    using Base::policies_;
    using Base::shares;
    using Base::step_;

public:
    using typename Base::C;
    using typename Base::Data;
    using typename Base::I;
    using typename Base::S;
    using typename Base::Scalar;
    using typename Base::Slot;

    /// Of a step.
    explicit SubstepDriver(StepT& step)
        : Base(step),
          response_(std::get<R>(policies_)),
          contacts_(data_.template state<R>()),
          before_(data_.collisions.before_solving()),
          start_(data_.clock.now()),
          whole_(context_),
          h_(context_.dt().value() / Scalar(response_.parts())),
          dt_(S::Time::from_value(h_)),
          last_(context_.dt().previous) {}

    /// The step.
    /// \param inside the systems between its beginning and the contacts: forces and integrator
    template <class Inside> void run(const Inside& inside) {
        if constexpr (C::executed && requires { contacts_.run_by(LoopRunner()); })
            contacts_.run_by(LoopRunner(detail::execution_of(policies_)));
        look_ahead();
        bool found = false; // not while all bodies sleep: their contacts keep their impulses
        for (int part = 0; part < response_.parts(); ++part) {
            begin_part(part);
            if (!found && (constrained || data_.bodies.any_goes())) {
                find_contacts();
                found = true;
            }
            if (!found) {
                move(part, inside);
                continue;
            }
            if (somebody_woke()) see_who_woke();
            else see_bodies();
            if constexpr (C::rests)
                while (wake_the_hit()) see_who_woke();
            const bool struck = bounce();
            hold(part);
            move(part, inside);
            if constexpr (C::rests) // before `let_go` takes it back: a body that is being pushed out is not slow
                if (part + 1 == response_.parts()) RestStep<StepT>(step_).note_speed();
            let_go(struck);
        }
        if constexpr (requires { contacts_.finish(); }) contacts_.finish();
        if (bounces_) contacts_.note_impacts();
        data_.collisions.parts = response_.parts();
        context_ = whole_;
        if constexpr (C::coupled) data_.coupled.current = false;
    }

private:
    using R = typename detail::FirstIn<typename C::template responses<Level::substeps>>::type;
    using Contacts = std::remove_cvref_t<decltype(std::declval<Data&>().template state<R>())>;
    /// The acceleration of a body while contacts are solved.
    struct Acceleration {
        const SubstepDriver* driver;
        typename S::Acceleration operator()(Slot slot, [[maybe_unused]] const typename Data::Body& row) const {
            if constexpr (shares) return driver->expected(slot, driver->known_acceleration(slot));
            else return driver->expected(slot, driver->acceleration(slot, row));
        }
    };
    /// The push of a solver of positions included: that of the last substep.
    typename S::Acceleration expected(Slot slot, const typename S::Acceleration& a) const {
        if constexpr (C::template stores<HeldAcceleration>) return a + data_.lanes.template get<HeldAcceleration>(slot);
        else return a;
    }
    static constexpr double leads = detail::velocity_leads<I>();

    /// When a substep begins.
    typename S::ClockTime time_of(int part) const {
        return start_ + S::ClockTime::from_value(typename S::ClockScalar(part) * typename S::ClockScalar(h_));
    }
    /// The pairs that may come to touch in the whole step.
    void look_ahead() {
        data_.collisions.expect(context_.dt());
        this->refresh_forces();
        find_near(context_.dt().previous);
        woken_ = data_.bodies.woken();
    }
    /// \param last the length of the step, or of the substep, before
    void find_near(const typename S::Time& last) {
        data_.collisions.refresh(data_, policies_, [&](Slot slot) {
            return expected(slot, this->acceleration(slot, data_.load(slot, last)));
        });
    }
    /// The contacts and their bodies, for all substeps.
    void find_contacts() {
        data_.collisions.wake_contacts(data_);
        bodies_.place(contacts_.bodies, contacts_.kicks);
        contacts_.expect_platforms(data_.bodies.count(Motion::moving) > 0);
        begin_contacts();
    }
    void begin_contacts() {
        contacts_.begin(data_, [&](std::size_t a, std::size_t b) { return response_.friction(data_, a, b); });
        bounces_ = response_.find_bouncing(contacts_, data_);
    }
    /// Its time and what is bound to it, and what accelerates bodies as they stand.
    void begin_part(int part) {
        context_ = Context<S>(time_of(part), TimeStep<S>(dt_, last_));
        bound_.prepare(context_);
        if constexpr (shares) this->know_own(context_);
        if constexpr (C::history) this->complete_starts();
        if constexpr (C::coupled) refresh_coupled(data_, policies_, context_);
        if constexpr (C::rests && C::coupled) // before contacts are solved, which then hold them, too
            RestStep<StepT>(step_).wake_pulled();
    }
    /// Positions, and the mean velocities over this substep, were there no contacts.
    void see_bodies() { bodies_.gather(contacts_.bodies, before_, 0.5 + leads, dt_, last_, &contacts_.kicks); }
    /// Something pulls at a sleeper: it goes on from here with its contacts and neighbours.
    /// \return whether any body was woken
    bool somebody_woke() {
        if constexpr (C::rests && C::coupled) {
            if (woken_ == data_.bodies.woken()) return false;
            data_.collisions.wake_contacts(data_);
            RestStep<StepT>(step_).wake_neighbours();
            return true;
        } else return false;
    }
    /// The same where bodies were woken: they are in other slots now, and what they may come to touch was not searched
    /// for while they slept.
    void see_who_woke() {
        woken_ = data_.bodies.woken();
        contacts_.impacts.find_again(contacts_, [&] {
            data_.collisions.make_stale();
            find_near(last_);
            bodies_.place(contacts_.bodies, contacts_.kicks);
            begin_contacts();
        });
        if constexpr (shares) {
            data_.own.value.known = false;
            this->know_own(context_);
        }
        if constexpr (C::history) this->complete_starts();
        see_bodies();
    }
    /// Sleepers that will be hit in this substep.
    /// \return whether any body was woken
    bool wake_the_hit() {
        if (!HitSleepers<C, Contacts>(data_, contacts_, dt_).wake()) return false;
        RestStep<StepT>(step_).wake_neighbours();
        return true;
    }
    /// \return whether any two bodies collided within this substep
    bool bounce() {
        const bool struck = bounces_ && response_.bounce(contacts_, h_);
        if (struck) bodies_.scatter_late(contacts_.bodies, before_, contacts_.impacts, -1 / h_, last_);
        return struck;
    }
    /// Contacts and joints take away what is wrong with the velocities, and separate what is in each other.
    void hold(int part) {
        if constexpr (constrained) {
            find_rows();
            data_.rows.value.warm_start(contacts_.bodies, before_, contacts_.kicks);
        }
        contacts_.warm_start();
        if (part == 0) contacts_.unload(without_contacts());
        if constexpr (constrained) data_.rows.value.solve(contacts_.bodies, h_, softness_of_rows(), contacts_.kicks);
        response_.solve(contacts_, h_);
        bodies_.scatter(contacts_.bodies, before_, last_, &contacts_.pushed);
        if constexpr (constrained) data_.rows.value.take_out(contacts_.bodies, contacts_.pushed);
        if constexpr (C::template couplings_read<Velocity>) data_.coupled.current = false;
    }
    /// Forces and integrator: all bodies move.
    template <class Inside> void move(int part, const Inside& inside) {
        last_ = dt_;
        if (part + 1 < response_.parts()) {
            auto one = step_.template as<Columns<>, StepT::later>();
            inside(one);
        } else inside(step_);
        if constexpr (C::coupled) {
            data_.coupled.current = false;
            refresh_coupled(data_, policies_, step_.after());
        }
        if constexpr (shares && (C::history || leads != 0.5)) { // the next substep begins with what they say now
            context_ = Context<S>(time_of(part + 1), TimeStep<S>(dt_, last_));
            bound_.prepare(context_);
            this->know_own_again(context_);
        }
    }
    /// Takes back velocity that only separated bodies or corrected joints, and energy that contacts have added.
    void let_go(bool struck) {
        bodies_.gather(contacts_.bodies, before_, leads - 0.5, dt_, last_);
        if (struck) bodies_.scatter_late(contacts_.bodies, before_, contacts_.impacts, 1 / h_, last_);
        if constexpr (constrained) {
            find_rows();
            data_.rows.value.relax(contacts_.bodies, h_);
        }
        contacts_.relax(h_);
        contacts_.calm(without_contacts());
        bodies_.scatter(contacts_.bodies, before_, last_);
    }

    /// Whether joints are solved with the contacts.
    static constexpr bool constrained = C::row_givers::size > 0;

    /// The rows of joints at the present positions.
    void find_rows() {
        auto& rows = data_.rows.value;
        rows.clear();
        auto of_one = [&]<class P>() {
            using Rows = typename P::template Rows<S>;
            SystemView<StepT, P, Rows> view(step_);
            Rows(std::get<P>(policies_)).rows(view, [&](const SolverRow<S>& row) { rows.add(row, contacts_.bodies); });
        };
        [&]<class... P>(Types<P...>) { (of_one.template operator()<P>(), ...); }(typename C::row_givers{});
    }
    /// By slot: velocities without the contacts of this pass.
    const auto& without_contacts() const {
        if constexpr (constrained) return data_.rows.value.without_contacts();
        else return before_;
    }
    /// As soft as the contacts with what is not moved, unless the response says something else.
    auto softness_of_rows() const {
        if constexpr (requires { response_.softness(h_); }) return response_.softness(h_);
        else return Softness<Scalar>::of(std::min(Scalar(120), Scalar(0.5) / h_), Scalar(5), h_);
    }

    detail::Bound<R, S> response_;
    Contacts& contacts_;
    Acceleration acceleration_{this};
    SubstepBodies<C, typename Base::Policies, Acceleration> bodies_{data_, policies_, acceleration_};
    std::remove_reference_t<decltype(std::declval<Data&>().collisions.before_solving())>& before_;
    typename S::ClockTime start_;
    Context<S> whole_;
    Scalar h_;                // s, a substep
    typename S::Time dt_;     // the same
    typename S::Time last_;   // the substep before
    bool bounces_ = false;    // whether anything may, in this step
    std::uint64_t woken_ = 0; // bodies, when they were seen last
};
template <class StepT> SubstepDriver(StepT&) -> SubstepDriver<StepT>; ///< of a step

} // namespace ansatz
