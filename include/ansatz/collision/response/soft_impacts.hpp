// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SoftImpacts`: which bodies hit each other within a substep, when, and how they separate: the bounces of
/// `SoftSubsteps`. Beyond the notes.
///
/// Each pair that runs into each other faster than the threshold has a moment at which it meets, by the velocities that
/// its bodies have *then*: what one impact has changed is what the next one sees. They are answered in the order of
/// these moments; those of one moment that share a body are answered together, and then the moments of those that share
/// a body with them are computed anew. Balls that touch in a row (Newton's cradle) meet one pair after another, as they
/// would with the smallest gap between them:
/// (1, 0, 0, 0, 0) becomes (0, 0, 0, 0, 1), and (1, 1, 0, 0, 0) becomes (0, 0, 0, 1, 1).
///
/// | symbol   | meaning                                                                            | unit |
/// |----------|------------------------------------------------------------------------------------|------|
/// | \f$ v \f$      | velocities before, of all bodies                                             | m/s  |
/// | \f$ N \f$      | the normals of those that meet at one moment                                 | 1    |
/// | \f$ M \f$      | masses                                                                       | kg   |
/// | \f$ \lambda \f$ | impulses, not negative                                                      | N s  |
///
/// \f[ v' = v + (1 + e)\,M^{-1} N \lambda, \qquad
///     \lambda = \arg\min_{\lambda \ge 0} \tfrac12 |v + M^{-1} N \lambda|_M^2 \f]
///
/// The velocity \f$ v + M^{-1}N\lambda \f$ is that of the perfectly plastic impact; v' is on its other side, at e = 1
/// the mirror image. It is unique, so that neither order nor numbering matters, and kinetic energy changes by
/// \f$ -\tfrac12 (1 - e^2)\,\lambda^T N^T M^{-1} N \lambda \f$, which is never a gain. Where coefficients differ, the
/// smallest of those that meet together counts.
///
/// B. Smith et al., Reflections on Simultaneous Impact (2012), for what a good answer keeps.

#include <ansatz/collision/contact.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// The impacts of a substep; what is kept here lives within a step.
template <class S> class SoftImpacts {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// A contact that may be an impact.
    struct Pair {
        std::uint32_t which;  ///< of the contacts
        Scalar restitution{}; ///< the larger one of the two bodies
        bool met = false;     ///< it was one in this step
        Scalar time{};        ///< when they meet, from the start of the substep, s
        Scalar approach{};    ///< how fast then, m/s
        Scalar impulse{};     ///< lambda, N s
        Scalar together{};    ///< the coefficient of all that meet with it
    };

    std::vector<Pair> pairs; ///< those of this step

    /// Answers all impacts of a substep. The bodies have the velocities that they will have at its end, minus half of
    /// what acceleration does in it; they are put to where they would have come from with it.
    /// \param h         s, the substep
    /// \param threshold m/s, slower ones are no impacts
    /// \return whether there were any
    bool answer(auto& contacts, Scalar h, Scalar threshold) {
        begin(contacts);
        bool any = false;
        // A row of n bodies takes n rounds. What meets more often (a grain under a piston) goes on in the next substep.
        for (std::size_t left = 64 + 4 * pairs.size(); left > 0 && find(contacts, h, threshold); --left) {
            agree(contacts);
            solve(contacts);
            part(contacts);
            look_again(contacts);
            any = true;
        }
        if (!any) return false;
        for (std::size_t slot = 0; slot < contacts.awake(); ++slot)
            if (bodies_[slot].struck) contacts.bodies[slot].position -= bodies_[slot].late;
        return true;
    }
    /// By how much a body has moved less than its last velocity says, m: it was struck at some time within the substep.
    const Raw& late(std::size_t slot) const { return bodies_[slot].late; }
    /// The pairs are found anew within a step, by `find_them`: those that have met in it still have, wherever their
    /// contacts stand now.
    template <class Find> void find_again(const auto& contacts, const Find& find_them) {
        const auto ids = [&](const Pair& pair) { return detail::ids_of(contacts.all[pair.which]); };
        met_.clear();
        for (const auto& pair : pairs)
            if (pair.met) met_.push_back(ids(pair));
        find_them();
        auto pair = pairs.begin();
        for (const auto& met : met_) {
            while (pair != pairs.end() && ids(*pair) < met) ++pair;
            if (pair != pairs.end() && ids(*pair) == met) pair->met = true;
        }
    }
    /// Room for so many bodies.
    void reserve(std::size_t n) { bodies_.reserve(n); }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SoftImpacts& other) {
        pairs.reserve(other.pairs.size());
        bodies_.reserve(other.bodies_.size());
        meeting_.reserve(other.meeting_.size());
        waiting_.reserve(other.waiting_.size());
        looked_.reserve(other.looked_.size());
        first_.reserve(other.first_.size());
        of_body_.reserve(other.of_body_.size());
    }

private:
    struct Struck {
        Raw late = Raw::Zero();   // sum of the changes of its velocity, each by its time
        Raw change = Raw::Zero(); // of its velocity by those that are being solved
        Scalar time{0};           // of the last
        Scalar first{}, together{};
        bool struck = false;
    };

    /// No body has been struck yet: of those that may be, and of those that they may meet.
    void begin(const auto& contacts) {
        bodies_.resize(contacts.bodies.size());
        std::fill_n(bodies_.begin(), contacts.awake(), Struck());
        for (const auto& pair : pairs)
            for (const auto slot : {contacts.all[pair.which].slot_a, contacts.all[pair.which].slot_b})
                bodies_[slot] = Struck();
        looks_at_all_ = true;
        first_.clear();
    }
    template <class F> void each_body(const auto& contacts, const auto& c, F&& f) {
        if (contacts.bodies[c.slot_a].weight > Scalar(0)) f(bodies_[c.slot_a]);
        if (contacts.bodies[c.slot_b].weight > Scalar(0)) f(bodies_[c.slot_b]);
    }

    /// Which meet, and when: into `meeting_`; those that meet later than another one of their bodies, into `waiting_`.
    bool find(const auto& contacts, Scalar h, Scalar threshold) {
        meeting_.clear();
        const auto look = [&](std::uint32_t n) {
            if (meets(contacts, pairs[n], h, threshold)) detail::append(meeting_, n);
        };
        if (looks_at_all_)
            for (std::uint32_t n = 0; n < pairs.size(); ++n) look(n);
        else
            for (const auto n : looked_) look(n);
        for (const auto n : meeting_)
            each_body(contacts, contacts.all[pairs[n].which], [&](Struck& body) { body.first = h; });
        for (const auto n : meeting_)
            each_body(contacts, contacts.all[pairs[n].which],
                      [&](Struck& body) { body.first = std::min(body.first, pairs[n].time); });
        const Scalar alike = h * sqrt(std::numeric_limits<Scalar>::epsilon());
        waiting_.clear();
        std::size_t first = 0;
        for (const auto n : meeting_) {
            bool later = false;
            each_body(contacts, contacts.all[pairs[n].which],
                      [&](Struck& body) { later = later || pairs[n].time > body.first + alike; });
            if (later) detail::append(waiting_, n);
            else meeting_[first++] = n;
        }
        meeting_.resize(first);
        return !meeting_.empty();
    }
    /// Whether a pair meets in this substep, and when.
    bool meets(const auto& contacts, Pair& pair, Scalar h, Scalar threshold) const {
        const auto& c = contacts.all[pair.which];
        const Struck &a = bodies_[c.slot_a], &b = bodies_[c.slot_b];
        // One that does not bounce is held softly, unless an impact has just set it in motion.
        if (!(pair.restitution > Scalar(0)) && !a.struck && !b.struck) return false;
        const Scalar pull = dot(Raw(contacts.kicks[c.slot_a] - contacts.kicks[c.slot_b]), c.normal) / h;
        const Scalar from = std::max(a.time, b.time), start = contacts.along(c) - pull * h / 2,
                     now = start + pull * from,
                     gap = contacts.apart(c) - dot(Raw(a.late - b.late), c.normal) + from * (start + pull * from / 2);
        pair.time = from;
        pair.approach = -now;
        if (gap > Scalar(0)) {
            const Scalar squared = now * now - 2 * pull * gap;
            if (!(squared > Scalar(0))) return false;
            pair.approach = sqrt(squared);
            const Scalar sum = pair.approach - now;
            if (!(sum > Scalar(0))) return false;
            pair.time += 2 * gap / sum;
        }
        return pair.time <= h && pair.approach > threshold;
    }
    /// The pairs that the next round looks at: those that waited, and those of the bodies that have just been struck.
    /// Nothing has changed for the others, so that a few that meet again and again do not cost the whole world.
    void look_again(const auto& contacts) {
        constexpr std::size_t few = 8; // one pair in so many: looking at all, in their order, is quicker
        const auto many = [&] { return few * looked_.size() > pairs.size(); };
        looked_.swap(waiting_);
        looks_at_all_ = many() || few * meeting_.size() > pairs.size();
        if (looks_at_all_) return;
        if (first_.empty()) list_pairs_of_bodies(contacts);
        for (const auto n : meeting_) {
            const auto& c = contacts.all[pairs[n].which];
            for (const auto slot : {c.slot_a, c.slot_b})
                if (contacts.bodies[slot].weight > Scalar(0))
                    for (auto at = first_[slot]; at < first_[slot + 1]; ++at) detail::append(looked_, of_body_[at]);
            looks_at_all_ = many();
            if (looks_at_all_) return;
        }
        std::sort(looked_.begin(), looked_.end());
        looked_.erase(std::unique(looked_.begin(), looked_.end()), looked_.end());
    }
    /// Of those that may be struck.
    void list_pairs_of_bodies(const auto& contacts) {
        const auto each_end = [&](std::uint32_t n, const auto& f) {
            const auto& c = contacts.all[pairs[n].which];
            for (const auto slot : {c.slot_a, c.slot_b})
                if (contacts.bodies[slot].weight > Scalar(0)) f(slot);
        };
        detail::grow(first_, contacts.awake() + 1);
        first_.assign(contacts.awake() + 1, 0);
        for (std::uint32_t n = 0; n < pairs.size(); ++n) each_end(n, [&](std::uint32_t slot) { ++first_[slot]; });
        std::uint32_t count = 0;
        for (auto& first : first_) first = count += first; // where those of a body end
        detail::grow(of_body_, count);
        of_body_.resize(count);
        for (auto n = std::uint32_t(pairs.size()); n-- > 0;)
            each_end(n, [&](std::uint32_t slot) { of_body_[--first_[slot]] = n; });
    }
    /// Those that meet together have one coefficient.
    void agree(const auto& contacts) {
        for (const auto n : meeting_) {
            auto& pair = pairs[n];
            pair.together = pair.restitution;
            each_body(contacts, contacts.all[pair.which], [](Struck& body) { body.together = 1; });
        }
        for (bool less = true; less;) {
            less = false;
            for (const auto n : meeting_) {
                auto& pair = pairs[n];
                each_body(contacts, contacts.all[pair.which], [&](Struck& body) {
                    less = less || body.together != pair.together;
                    body.together = pair.together = std::min(body.together, pair.together);
                });
            }
        }
    }
    /// The plastic impact of all that meet, by projected Gauss-Seidel: what converges is unique. One that shares no
    /// body with another is done at once.
    void solve(const auto& contacts) {
        for (const auto n : meeting_) {
            pairs[n].impulse = 0;
            each_body(contacts, contacts.all[pairs[n].which], [](Struck& body) { body.change = Raw::Zero(); });
        }
        const Scalar small = 4 * std::numeric_limits<Scalar>::epsilon();
        for (int sweep = 0; sweep < 1000; ++sweep) {
            bool done = true;
            for (const auto n : meeting_) {
                auto& pair = pairs[n];
                const auto& c = contacts.all[pair.which];
                const Scalar wrong = pair.approach - change(contacts, c),
                             now = std::max(pair.impulse + c.mass * wrong, Scalar(0));
                done = done && abs(now - pair.impulse) <= small * c.mass * pair.approach;
                push(contacts, c, Raw((now - pair.impulse) * c.normal),
                     [](Struck& body, const Raw& by) { body.change += by; });
                pair.impulse = now;
            }
            if (done) return;
        }
        // Not done: what is given back is no more than what has been taken.
        Scalar taken(0), given(0);
        for (const auto n : meeting_) {
            taken += pairs[n].impulse * pairs[n].approach;
            given += pairs[n].impulse * change(contacts, contacts.all[pairs[n].which]);
        }
        for (const auto n : meeting_) pairs[n].together = std::min(pairs[n].together, 2 * taken / given - 1);
    }
    /// They separate, and what slides is slowed.
    void part(auto& contacts) {
        for (const auto n : meeting_) {
            auto& pair = pairs[n];
            auto& c = contacts.all[pair.which];
            const Scalar j = (1 + pair.together) * pair.impulse;
            pair.met = true;
            strike(contacts, c, Raw(j * c.normal), pair.time);
        }
        if constexpr (std::remove_cvref_t<decltype(contacts)>::rubs)
            for (const auto n : meeting_) {
                auto& c = contacts.all[pairs[n].which];
                const Raw between = contacts.bodies[c.slot_a].u - contacts.bodies[c.slot_b].u,
                          sliding = between - dot(between, c.normal) * c.normal;
                const Scalar speed = norm(sliding);
                if (!(speed > Scalar(0))) continue;
                const Scalar most = c.friction * (1 + pairs[n].together) * pairs[n].impulse;
                strike(contacts, c, Raw(-std::min(c.mass, most / speed) * sliding), pairs[n].time);
            }
    }
    void strike(auto& contacts, const auto& c, const Raw& impulse, const Scalar& time) {
        contacts.push(c, impulse);
        push(contacts, c, impulse, [&](Struck& body, const Raw& by) {
            body.late += time * by;
            body.time = std::max(body.time, time);
            body.struck = true;
        });
    }
    /// N . (what the velocities of the two have been changed by).
    Scalar change(const auto& contacts, const auto& c) const {
        Scalar sum(0);
        if (contacts.bodies[c.slot_a].weight > Scalar(0)) sum += dot(bodies_[c.slot_a].change, c.normal);
        if (contacts.bodies[c.slot_b].weight > Scalar(0)) sum -= dot(bodies_[c.slot_b].change, c.normal);
        return sum;
    }
    template <class F> void push(const auto& contacts, const auto& c, const Raw& impulse, F&& f) {
        const Scalar wa = contacts.bodies[c.slot_a].weight, wb = contacts.bodies[c.slot_b].weight;
        if (wa > Scalar(0)) f(bodies_[c.slot_a], Raw(wa * impulse));
        if (wb > Scalar(0)) f(bodies_[c.slot_b], Raw(-wb * impulse));
    }

    std::vector<Struck> bodies_;                               // by slot
    std::vector<std::uint32_t> meeting_;                       // of `pairs`: those that are answered now
    std::vector<std::uint32_t> waiting_;                       // those that meet, but another one comes first
    std::vector<std::uint32_t> looked_;                        // those that may meet now, unless all are looked at
    std::vector<std::uint32_t> first_, of_body_;               // by slot: where its own begin in the second
    bool looks_at_all_ = true;                                 // the next round, and not only at those
    std::vector<std::pair<std::uint32_t, std::uint32_t>> met_; // while pairs are found again: whose have met
};

} // namespace ansatz
