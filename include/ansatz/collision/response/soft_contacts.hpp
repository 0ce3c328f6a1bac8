// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftContacts`: the contacts of a step as soft constraints, and the passes over them, for `SoftSubsteps`.
///
/// A soft constraint is a damped spring whose stiffness is given as a frequency, solved implicitly, so that it never
/// overshoots: of the velocity that is wrong it takes away a share, and of the depth that is left another. Each pass
/// goes through the contacts one by one, in the order of their bodies' ids, and lets each see what those before it did
/// (sequential impulses, which is projected Gauss-Seidel). Impulses are kept from step to step and begin the next one
/// (warm start): what rests on a pile for a second has been solved sixty times over.
///
/// E. Catto, Soft Constraints (GDC 2011), and Solver2D (2024), for the method and the order of the passes; K. Macklin
/// et al., Small Steps in Physics Simulation (2019), for substeps instead of iterations.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/division.hpp>
#include <ansatz/collision/response/soft_impacts.hpp>
#include <ansatz/collision/response/soft_islands.hpp>
#include <ansatz/collision/response/soft_loads.hpp>
#include <ansatz/collision/response/solver_body.hpp>
#include <ansatz/collision/restitution.hpp>
#include <ansatz/collision/sleeping_contacts.hpp>
#include <ansatz/world/bodies.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace ansatz {

/// \tparam Rubs whether there is friction
template <class S, bool Rubs> class SoftContacts {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI
    using Body = SolverBody<S>;               ///< what is solved for
    /// In place of what is not there; two of one type would need two places.
    template <int> struct Nothing {};

    /// A contact of this step. Each pass reads it: in double and three dimensions it is one line of the cache, without
    /// friction.
    struct Constraint {
        std::uint32_t a;          ///< the id of a body
        std::uint32_t b;          ///< and of the other
        std::uint32_t slot_a = 0; ///< where the first is
        std::uint32_t slot_b = 0; ///< and the other
        Raw normal;               ///< from b to a
        Scalar touching;          ///< N . (x_a - x_b) where they only touch, m
        Scalar impulse = 0;       ///< along the normal, of a substep, N s
        Scalar mass = 0;          ///< 1 / (w_a + w_b), kg
        [[no_unique_address]] std::conditional_t<Rubs, Raw, Nothing<0>> rubbing{};     ///< across the normal, N s
        [[no_unique_address]] std::conditional_t<Rubs, Scalar, Nothing<1>> friction{}; ///< the coefficient of the two
    };
    static constexpr bool rubs = Rubs; ///< whether there is friction
    std::vector<Constraint> all;       ///< by the ids of their bodies; without those whose bodies sleep
    std::vector<Body> bodies;          ///< by slot
    std::vector<Raw> kicks;            ///< by slot: what acceleration does to a velocity in a substep, m/s
    std::vector<Raw> pushed;           ///< by slot: by how much contacts changed a velocity before the substep, m/s
    SoftImpacts<S> impacts;            ///< those of this step, if something bounces

    /// Calls `f(constraint)` for each of which a body is awake: those of a sleeping pile cost no pass, and keep their
    /// impulses.
    template <class F> [[gnu::always_inline]] void each_acting(F&& f) {
        for (const auto n : acting_) f(all[n]);
    }

    /// How many those are.
    std::size_t acting() const { return acting_.size(); }
    /// One of them.
    Constraint& nth_acting(std::size_t n) { return all[acting_[n]]; }
    const Constraint& nth_acting(std::size_t n) const { return all[acting_[n]]; } ///< one of them

    /// The contacts of the state that a step has made; those that were there before keep their impulses.
    template <class Data, class Contacts> void take(const Data& data, const Contacts& contacts) {
        detail::grow(all, contacts.size()); // before anything changes: or impulses are lost
        impacts.pairs.clear();              // of the last step: they name contacts by their places
        const auto acts = [&](const auto& c) {
            return !data.collisions.is_sensor(c.first.id) && !data.collisions.is_sensor(c.second.id);
        };
        const auto same = [](const Constraint& old, const auto& c) {
            return old.a == c.first.id && old.b == c.second.id; // asked first: most go on from step to step
        };
        // In one list: those that go on come to the front, and from the last one on all are put where they belong. No
        // place is written before what goes on from it has been read, since as many contacts come before it.
        const std::size_t known = all.size();
        std::size_t before = 0, goes_on = 0, count = 0;
        for (const auto& c : contacts) {
            if (!acts(c)) continue;
            ++count;
            for (; before < known; ++before) {
                if (same(all[before], c)) {
                    if (goes_on != before) all[goes_on] = all[before];
                    ++goes_on, ++before;
                    break;
                }
                if (detail::ids_of(c) < detail::ids_of(all[before])) break;
            }
        }
        all.resize(count);
        const bool all_act = count == contacts.size();
        Constraint* const list = all.data();
        for (auto next = contacts.size(); count > 0;) {
            const auto& c = contacts[--next];
            if (!all_act && !acts(c)) continue;
            Constraint now;
            now.a = c.first.id;
            now.b = c.second.id;
            now.normal = c.normal;
            const auto between = data.lanes.template get<Position>(data.bodies.slot_of_id(now.a)) -
                                 data.lanes.template get<Position>(data.bodies.slot_of_id(now.b));
            now.touching = dot(typename S::Position(between), c.normal).value() + c.depth.value();
            if constexpr (Rubs)
                for (int k = 0; k < S::dimension; ++k) now.rubbing[k] = Scalar(0);
            for (; goes_on > 0; --goes_on) {
                const Constraint& old = list[goes_on - 1];
                if (same(old, c)) {
                    now.impulse = old.impulse;
                    if constexpr (Rubs) now.rubbing = old.rubbing;
                    --goes_on;
                    break;
                }
                if (detail::ids_of(old) < detail::ids_of(c)) break;
            }
            list[--count] = now;
        }
    }

    /// \name Contacts whose bodies sleep; where there is room, none of these can fail
    /// @{
    /// For so many more, of bodies with ids below `ids`.
    void make_room_to_sleep(std::size_t n, std::size_t ids) { asleep_.make_room(n, ids); }
    void put_to_sleep(const auto& sleeps) { asleep_.take(all, sleeps); } ///< those for which it holds
    /// For all of them.
    void make_room_to_wake() {
        if (all.capacity() < all.size() + asleep_.size()) all.reserve(all.size() + asleep_.size());
        asleep_.make_room_to_leave();
    }
    /// A body has woken: its contacts will act once `wake_contacts` is called.
    void leave(std::uint32_t id) {
        asleep_.leave(id, [](std::uint32_t) {});
    }
    /// Those that have left act.
    void wake_contacts() {
        const auto& woken = asleep_.left();
        std::size_t before = 0; // each of those that may bounce
        for (auto& pair : impacts.pairs) {
            while (before < woken.size() && detail::ids_of(asleep_[woken[before]]) < detail::ids_of(all[pair.which]))
                ++before;
            pair.which += std::uint32_t(before);
        }
        asleep_.merge(all, std::identity());
    }
    /// @}

    /// Before the iterations of a step: where the bodies are, and how each contact will answer.
    /// \param friction the coefficient of two slots
    template <class Data, class FrictionOf> void begin(const Data& data, const FrictionOf& friction) {
        awake_ = data.bodies.end(Motion::awake);
        weigh([&](Constraint& c) {
            c.slot_a = data.bodies.slot_of_id(c.a);
            c.slot_b = data.bodies.slot_of_id(c.b);
            for (const auto slot : {c.slot_a, c.slot_b})
                if (slot >= awake_) bodies[slot].position = data.lanes.template get<Position>(slot).value();
        });
        if constexpr (Rubs)
            each_acting([&](Constraint& c) {
                c.friction = friction(c.slot_a, c.slot_b);
                if (c.friction > Scalar(0)) c.rubbing -= dot(c.rubbing, c.normal) * c.normal; // it has turned since
                else c.rubbing = Raw::Zero(); // of a friction that it had before
            });
    }
    /// The same where the slots are known: which contacts act, and against what mass.
    void weigh() {
        weigh([](Constraint&) {});
    }
    /// How many bodies contacts may push; they come first.
    std::size_t awake() const { return awake_; }
    /// There are bodies that move by themselves.
    void expect_platforms(bool any) { platforms_ = any; }
    /// How far two are apart; negative where they intersect, m.
    [[gnu::always_inline]] Scalar apart(const Constraint& c) const {
        return dot(Raw(bodies[c.slot_a].position - bodies[c.slot_b].position), c.normal) - c.touching;
    }
    /// What a contact does to its first body, friction included, N s.
    [[gnu::always_inline]] static Raw whole(const Constraint& c) {
        if constexpr (Rubs) return c.impulse * c.normal + c.rubbing;
        else return c.impulse * c.normal;
    }
    /// N . (u_a - u_b), m/s.
    [[gnu::always_inline]] Scalar along(const Constraint& c) const {
        return dot(Raw(bodies[c.slot_a].u - bodies[c.slot_b].u), c.normal);
    }

    // The passes are flattened: in a file with several worlds g++ would call the arithmetic of vectors.
    /// The impulses of the substep before act again.
    [[gnu::flatten]] void warm_start() {
        each_acting([&](const Constraint& c) {
            push(c, c.impulse * c.normal);
            if constexpr (Rubs) push(c, c.rubbing);
        });
    }
    /// One pass in which contacts may not come deeper than they are, and those that are too deep separate.
    /// \param h        s, the substep
    /// \param push_out m/s, how fast they separate at most
    [[gnu::flatten]] void solve(Scalar h, const Softness<Scalar>& soft, const Softness<Scalar>& soft_held, Scalar slop,
                                Scalar push_out) {
        const Scalar per_h = 1 / h;
        each_acting([&](Constraint& c) {
            const Scalar s = apart(c);
            if (s > Scalar(0)) press(c, s * per_h, Scalar(1), Scalar(0));
            else {
                const bool held = !(bodies[c.slot_a].weight > Scalar(0)) || !(bodies[c.slot_b].weight > Scalar(0));
                const auto& how = held ? soft_held : soft;
                press(c, std::max(how.rate * std::min(s + slop, Scalar(0)), -push_out), how.mass, how.impulse);
            }
            rub(c);
        });
    }
    /// One pass that takes back the velocity which only separated them. Those that do not touch yet keep what they meet
    /// with.
    [[gnu::flatten]] void relax(Scalar h) {
        const Scalar per_h = 1 / h;
        each_acting([&](Constraint& c) {
            const Scalar s = apart(c);
            if (s > Scalar(0)) {
                if (!(c.impulse > Scalar(0))) return;
                press(c, s * per_h, Scalar(1), Scalar(0));
            } else press(c, Scalar(0), Scalar(1), Scalar(0));
            rub(c);
        });
    }
    /// After the warm start of a step: what pushes because of a load that has gone is taken back (soft_loads.hpp).
    /// \param before by slot: the velocities before the warm start, m/s
    void unload(const std::vector<Raw>& before) {
        if (loads_.take_off(*this, before)) warm_start();
    }
    /// Islands whose contacts have given them energy give it back (soft_islands.hpp).
    /// \param before by slot: the velocities before the last pass, m/s
    /// \return whether there was such an island; its bodies' velocities are not those of before
    bool calm(const std::vector<Raw>& before) { return islands_.calm(*this, before, platforms_); }
    /// Those that have bounced in this step have touched.
    void note_impacts() {
        for (const auto& pair : impacts.pairs)
            if (pair.met)
                all[pair.which].impulse = std::max(all[pair.which].impulse, std::numeric_limits<Scalar>::min());
    }
    /// An impulse on a, and the opposite one on b.
    template <class V> [[gnu::always_inline]] void push(const Constraint& c, const V& impulse) {
        bodies[c.slot_a].u += bodies[c.slot_a].weight * impulse;
        bodies[c.slot_b].u -= bodies[c.slot_b].weight * impulse;
    }

    /// \name What a world asks of everything that a policy keeps
    /// @{
    void begin_step() {}    ///< Nothing to forget.
    void reserve_notes() {} ///< Nothing to make room for.
    /// Room for so many bodies, of which steps make some.
    void reserve(std::size_t n) { detail::reserve_each(n, bodies, kicks, pushed, impacts, loads_, islands_); }
    /// Room for the contacts of bodies that a step may make by dividing others.
    void make_room_to_come() { detail::make_room_for_copies(all, asleep_.size()); }
    /// A body has been divided: the new one takes its share of the impulses, since it has that share of the load.
    void body_divided(std::uint32_t id, std::uint32_t part, const Scalar& share) {
        detail::divide_impulses<Rubs>(all, id, part, share);
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SoftContacts& other) {
        all.reserve(other.all.size());
        asleep_.make_room_for(other.asleep_);
        bodies.reserve(other.bodies.size());
        kicks.reserve(other.kicks.size());
        pushed.reserve(other.pushed.size());
        impacts.make_room_for(other.impacts);
        acting_.reserve(other.acting_.size());
        loads_.make_room_for(other.loads_);
        islands_.make_room_for(other.islands_);
    }
    /// Slots are looked up at the beginning of a step.
    void arrange(const Bodies&, std::uint64_t) {}
    /// Its contacts go with it.
    void body_removed(std::uint32_t id) {
        std::erase_if(all, [id](const Constraint& c) { return c.a == id || c.b == id; });
        asleep_.forget(id);
    }
    /// The impulses are state: the next step begins with them.
    void add_to(auto& hash) const {
        each([&](const Constraint& c) {
            if (c.impulse == Scalar(0)) return;
            hash.add(std::uint64_t(c.a) << 32 | c.b);
            hash.add_number(c.impulse);
        });
    }
    /// To a file: `f(a, b, numbers)` for each contact. Where and how they touch is written, too: found anew, it
    /// would be another by the last bits, and a loaded world would go on beside the saved one.
    template <class F> void saved(F&& f) const {
        each([&](const Constraint& c) {
            std::vector<Scalar> numbers{c.impulse, c.touching};
            numbers.insert(numbers.end(), c.normal.data(), c.normal.data() + S::dimension);
            if constexpr (Rubs) numbers.insert(numbers.end(), c.rubbing.data(), c.rubbing.data() + S::dimension);
            f(c.a, c.b, numbers);
        });
    }
    static constexpr int numbers_each = 2 + (Rubs ? 2 : 1) * S::dimension; ///< of a contact in a file
    /// What is wrong with the numbers of one from a file, and where; nothing, if it was taken.
    std::optional<std::pair<int, const char*>> load(std::uint32_t a, std::uint32_t b,
                                                    const std::vector<Scalar>& numbers) {
        if (numbers[0] < Scalar(0)) return std::pair(0, "an impulse that is not negative, because contacts never pull");
        Constraint c{};
        c.a = a;
        c.b = b;
        c.impulse = numbers[0];
        c.touching = numbers[1];
        for (int k = 0; k < S::dimension; ++k) {
            c.normal[k] = numbers[std::size_t(k) + 2];
            if constexpr (Rubs) c.rubbing[k] = numbers[std::size_t(k + S::dimension) + 2];
        }
        if (!(abs(c.normal.squaredNorm() - Scalar(1)) < Scalar(0.001)))
            return std::pair(2, "the first number of a unit vector");
        all.push_back(c);
        return std::nullopt;
    }
    /// They are no elements.
    static void for_each(auto&&) {}
    /// They hold no body.
    static void for_each_body(std::uint32_t, auto&&) {}
    /// @}

protected:
    std::vector<std::uint32_t> acting_; ///< which of all act in this step
    SoftLoads<S> loads_;                ///< what remembers a load that has gone
    SoftIslands<S> islands_;            ///< what has been given energy
    bool platforms_ = false;            ///< whether there are bodies that move and are not moved

private:
    /// Which contacts act, and against what mass.
    /// \param look_up is called with each of them first
    void weigh(const auto& look_up) {
        acting_.clear();
        detail::grow(acting_, all.size());
        impacts.pairs.clear();
        for (std::size_t n = 0; n < all.size(); ++n) {
            auto& c = all[n];
            look_up(c);
            const Scalar wa = bodies[c.slot_a].weight, wb = bodies[c.slot_b].weight;
            if (!(wa + wb > Scalar(0))) continue;
            acting_.push_back(std::uint32_t(n));
            c.mass = 1 / (wa + wb);
        }
        loads_.reserve_contacts(all.capacity());
        islands_.forget(); // those of another step; they are searched for where they are asked for
    }
    /// Those whose bodies sleep, too.
    void each(const auto& f) const { asleep_.each(all, f, f); }
    [[gnu::always_inline]] void press(Constraint& c, Scalar bias, Scalar mass_share, Scalar impulse_share) {
        const Scalar j = -c.mass * mass_share * (along(c) + bias) - impulse_share * c.impulse;
        const Scalar now = std::max(c.impulse + j, Scalar(0)); // contacts never pull
        push(c, (now - c.impulse) * c.normal);
        c.impulse = now;
    }
    /// Coulomb's law: what slides is held back by at most mu times what presses.
    [[gnu::always_inline]] void rub([[maybe_unused]] Constraint& c) {
        if constexpr (Rubs) {
            if (!(c.friction > Scalar(0))) return;
            const Raw between = bodies[c.slot_a].u - bodies[c.slot_b].u;
            Raw now = c.rubbing - c.mass * (between - dot(between, c.normal) * c.normal);
            const Scalar most = c.friction * c.impulse, size = norm(now);
            if (size > most) now *= most / size;
            push(c, Raw(now - c.rubbing));
            c.rubbing = now;
        }
    }
    SleepingContacts<Constraint> asleep_;
    std::size_t awake_ = 0;
};

} // namespace ansatz
