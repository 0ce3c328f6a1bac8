// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Faults on purpose, one at a time, as they have been in worlds: the fuzzer must find each of them. They are policies
/// and a world of a user's own, so that the library stays as it is.

#include "tests/fuzz/either.hpp"

#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world.hpp>
#include <ansatz/world/keep.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace fuzz {

enum class Plant {
    nothing,
    stale_slot,       ///< a verb looks a slot up, and then wakes bodies, which changes slots
    energy_twice,     ///< a bounce is given back twice
    forgotten_number, ///< the hash leaves a column out
    missed_pair,      ///< the broadphase does not tell each fourth pair
    uneven_push,      ///< one of two that bounce gets half of what the other gets
    half_changed,     ///< a verb stops the body before it finds that its argument is none
    poor_copy,        ///< a copy leaves a column out
    lasting_garbage,  ///< each bounce takes memory from the heap
    little_room,      ///< a copy has the note how much room there is, and not the room
    early_sleep       ///< what is slow for a step falls asleep, as a ball does then at the top of its flight
};
inline Plant planted = Plant::nothing; // what is wrong now

/// SortAndSweep that, for the fault, does not tell each fourth pair.
struct ShortSighted {
    using role = ansatz::roles::Broadphase;
    template <class S> class In {
    public:
        explicit In(const ShortSighted&) : sweep_(ansatz::SortAndSweep{}) {}
        template <class F> void find(const ansatz::Boxes<S>& boxes, F&& found) {
            std::size_t told = 0;
            sweep_.find(boxes, [&](std::size_t i, std::size_t j) {
                if (planted == Plant::missed_pair && ++told % 4 == 0) return;
                found(i, j);
            });
        }

    private:
        ansatz::SortAndSweep::In<S> sweep_;
    };
};

inline std::vector<int> garbage;

/// An impulse, contact by contact, that bounces; for the faults its restitution counts twice, the second body gets half
/// of it, or it allocates.
struct Bouncing {
    using role = ansatz::roles::Response;
    static constexpr ansatz::Level level = ansatz::Level::velocities;
    using reads = ansatz::Columns<ansatz::Restitution>;
    using writes = ansatz::Columns<ansatz::Velocity>;
    template <class S> struct In {
        explicit In(const Bouncing&) {}
        void respond(const auto& touch, auto& a, auto& b, const auto&) const {
            auto& va = a.template get<ansatz::Velocity>();
            auto& vb = b.template get<ansatz::Velocity>();
            const auto wa = a.template get<ansatz::InverseMass>(), wb = b.template get<ansatz::InverseMass>();
            const typename S::Speed along = ansatz::dot(va - vb, touch.normal);
            if (!(along.value() < 0)) return;
            const auto e =
                ansatz::max(a.template get<ansatz::Restitution>(), b.template get<ansatz::Restitution>()).value();
            const auto given = planted == Plant::energy_twice ? e + e : e;
            const auto j = (-(typename S::Scalar(1) + given) * along) / (wa + wb);
            va += (wa * j) * touch.normal;
            vb -= (wb * j) * touch.normal * typename S::Scalar(planted == Plant::uneven_push ? 0.5 : 1);
            if (planted == Plant::lasting_garbage) std::vector<int>(1).swap(garbage);
        }
    };
};

/// Rest that, for the fault, asks as little as the notes do: a velocity close to zero, once.
struct Dozing : ansatz::Rest {
    template <class S> struct In : ansatz::Rest::In<S> {
        explicit In(const Dozing& rest) : ansatz::Rest::In<S>(rest) {}
        bool long_enough(const typename S::Time& slow_for) const {
            if (planted == Plant::early_sleep) return slow_for.value() > typename S::Scalar(0);
            return ansatz::Rest::In<S>::long_enough(slow_for);
        }
        bool balanced(const typename S::Acceleration& remains) const {
            return planted == Plant::early_sleep || ansatz::Rest::In<S>::balanced(remains);
        }
    };
};

/// A world with the verbs that the other faults are in.
template <class... P> class Faulty : public ansatz::World<P...> {
    using Base = ansatz::World<P...>;

public:
    explicit Faulty(P... policies) : Base(policies...) {}
    Faulty(const Faulty& other) : Base(other), added_(other.added_), room_(other.room_) {
        if (planted == Plant::poor_copy) forget_restitution();
    }
    Faulty(Faulty&&) = default;
    Faulty& operator=(const Faulty&) = default;
    Faulty& operator=(Faulty&&) = default;
    ~Faulty() = default;
    template <class... Q> ansatz::Handle add(Q&&... properties) {
        if (planted == Plant::little_room && added_.size() == room_) {
            added_.reserve(2 * room_ + 8);
            room_ = 2 * room_ + 8;
        }
        const auto body = Base::add(std::forward<Q>(properties)...);
        if (planted == Plant::little_room) added_.push_back(body); // there is room, or so it was noted
        return body;
    }
    template <class Q> void set_velocity(ansatz::Handle body, const Q& velocity) {
        if (planted == Plant::stale_slot && this->contains(body)) {
            std::size_t slot = 0;
            while (!(this->body_at(slot) == body)) ++slot;
            Base::wake(body);
            body = this->body_at(slot);
        }
        if (planted == Plant::half_changed && this->contains(body) && !ansatz::is_finite(velocity))
            Base::set_velocity(body, Base::S::template zero_vector<ansatz::unit::Velocity>());
        Base::set_velocity(body, velocity);
    }
    std::uint64_t hash() const {
        if (planted != Plant::forgotten_number) return Base::hash();
        Faulty without = *this;
        without.forget_restitution();
        return without.Base::hash();
    }

private:
    void forget_restitution() {
        for (const auto body : this->handles())
            this->template write<ansatz::Restitution>(body, ansatz::Quantity<ansatz::unit::Dimensionless>(0.0));
    }

    std::vector<ansatz::Handle> added_; // only for its fault
    std::size_t room_ = 0;              // of it
};
template <class... P> Faulty(P...) -> Faulty<P...>;

/// An empty one.
/// \param gravity    along the second axis, m/s^2
/// \param every_pair whether its broadphase is the one that tests every pair
inline auto faulty(double gravity, bool every_pair = false) {
    using namespace ansatz;
    return Faulty{SemiImplicitEuler{},
                  Gravity{metres_per_second_squared(0, gravity, 0)},
                  Either<ShortSighted>{{}, every_pair},
                  Narrowphase<Sphere, Plane, Box>{},
                  Bouncing{},
                  Dozing{},
                  Keep<InverseMass>{},
                  Datum<int>{}};
}

} // namespace fuzz
