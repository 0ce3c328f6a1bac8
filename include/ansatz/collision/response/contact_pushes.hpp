// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactPushes`: all contacts of a step at once, as one least-squares problem: what `Impulse` and `Projection` work
/// with.
///
/// One contact after another, a column of n bodies needs some n^2 sweeps, because each push reaches the neighbour
/// only. Here the pushes \f$ \lambda_i \ge 0 \f$ along the normals are those for which the whole moves as little as it
/// can, \f[ \min \tfrac12 \sum_b m_b |\Delta\mathbf u_b|^2 \quad\text{with}\quad \mathbf N_i\cdot(\mathbf u_a - \mathbf
/// u_b) \ge t_i, \f] found by conjugate gradients: a chain of n is solved in n sweeps, whatever its bodies weigh. u is
/// a velocity or a displacement. Every sweep comes nearer, so that no number of them adds energy to velocities (where
/// no t is greater than zero); each cluster of bodies that touch is solved for itself, and the order of the contacts
/// decides nothing but the last bit.
///
/// Those that bounce are reflected before, cluster after cluster, and again while any two still approach: a blow
/// goes through a row of balls one by one and keeps its energy, and two that are hit at once are hit alike (B. Smith et
/// al., Reflections on Simultaneous Impact, 2012; the share of each contact is that of a body divided among its
/// contacts).
///
/// The conjugate gradients are those of Polak and Ribiere, begun anew where a push ends; the step that follows is a
/// projected one of a length that cannot fail: with n contacts at a body, A is at most n_a w_a + n_b w_b on the
/// diagonal.
///
/// Targets may contradict each other; what is done then stands in infeasible_contacts.hpp.

#include <ansatz/collision/response/infeasible_contacts.hpp>
#include <ansatz/motion/islands.hpp>
#include <ansatz/units.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz {

/// The contacts and bodies of one level of a step. It keeps its room.
template <class S> class ContactPushes {
public:
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI

    /// A body that is pushed.
    struct Body {
        Raw u;                   ///< what is changed
        Raw was;                 ///< what it was
        Raw by;                  ///< the direction of a sweep
        Raw start;               ///< u before the sweeps
        Scalar weight{};         ///< 1/m, 1/kg; zero for what is not moved
        std::uint32_t slot = 0;  ///< where it is
        std::uint32_t count = 0; ///< of its contacts
    };
    /// Two that touch, or will.
    struct Push {
        std::uint32_t a = 0;     ///< a place among `bodies`
        std::uint32_t b = 0;     ///< and another
        std::uint32_t which = 0; ///< the number that it was added with
        std::uint32_t root = 0;  ///< the body that stands for its cluster
        Raw normal{};            ///< from b to a
        Raw point{};     ///< where, m: they are gone through in this order, so that the order of adding decides nothing
        Scalar depth{};  ///< m; negative where they do not touch yet
        Scalar target{}; ///< t
        Scalar kept{};   ///< t, while something else is solved
        Scalar along{};  ///< N . (u_a - u_b) when it was computed last
        Scalar total{};  ///< what was pushed so far, bounces and all
        Scalar restitution{}; ///< of the two
        Scalar friction{};    ///< of the two
        Scalar rubbed{};      ///< how much of what friction may push it has pushed
        Scalar ahead{};       ///< along the normal, what the velocity of the position's time has more than u
        bool touches = true;  ///< or is so near that it may within a step
        bool bounced = false; ///< in this step
        bool bounces = false; ///< in this round
        bool waits = false;   ///< it takes no part in the sweeps
        Scalar lambda{};      ///< along the normal, of the sweeps
        Scalar residual{};    ///< along - target
        Scalar step{};        ///< the direction of a sweep
        Scalar share{};       ///< n_a w_a + n_b w_b: A is at most this on the diagonal
        Scalar start{};       ///< lambda before the sweeps
        Scalar start_total{}; ///< total before them
    };
    std::vector<Body> bodies; ///< those that are in a contact
    std::vector<Push> pushes; ///< the contacts

    /// Room for so many bodies.
    void reserve(std::size_t n) {
        bodies.reserve(n);
        place_.reserve(n);
        scratch_.reserve(n);
        before_.reserve(n);
        roots_.reserve(n);
    }
    /// None.
    void clear(std::size_t slots) {
        for (const auto& body : bodies)
            if (body.slot < place_.size()) place_[body.slot] = nobody;
        place_.resize(slots, nobody);
        bodies.clear();
        pushes.clear();
    }
    /// The place of the body of a slot; `u()` tells what it is changed from.
    template <class U> std::uint32_t body(std::uint32_t slot, Scalar weight, const U& u) {
        if (place_[slot] == nobody) {
            place_[slot] = std::uint32_t(bodies.size());
            const Raw is = u();
            bodies.push_back({is, is, Raw::Zero(), is, weight, slot, 0});
        }
        return place_[slot];
    }
    /// Sorts contacts independently of the ids of bodies.
    void arrange() {
        std::sort(pushes.begin(), pushes.end(), [](const Push& p, const Push& q) {
            for (int k = S::dimension; k-- > 0;)
                if (p.point[k] != q.point[k]) return p.point[k] < q.point[k];
            return p.which < q.which;
        });
    }
    /// N . (u_a - u_b).
    [[gnu::always_inline]] Scalar along(const Push& p) const {
        return dot(Raw(bodies[p.a].u - bodies[p.b].u), p.normal);
    }

    /// Solves by up to `sweeps` sweeps, so that every contact has at least its target.
    /// \param enough what may be missing of the targets, of what was
    void solve(int sweeps, Scalar enough = Scalar(16) * std::numeric_limits<Scalar>::epsilon()) {
        cluster([](const Push& p) { return !p.waits; });
        for (auto& body : bodies) body.start = body.u;
        for (auto& p : pushes) p.start = p.lambda, p.start_total = p.total;
        for (int sweep = 0; sweep < sweeps && choose(sweep == 0, enough); ++sweep) advance();
        if (infeasible(enough))
            detail::miss_least(bodies, pushes, scratch_, sweeps, [&](std::uint32_t n) { return roots_.of(n); });
    }

    /// Bodies that bounce and are to be separated by `depth` get the velocity that they had where they first touched:
    /// to separate them is to go back that way, against what pulls. In a column this holds for all bodies that are
    /// lifted and not for the two that meet alone; otherwise separating them throws a dropped column upwards.
    /// With the displacements \f$ \mathbf d \f$ that separate them, u becomes \f$ \mathbf u + \gamma\mathbf d \f$
    /// with \f$ \tfrac12\sum m\,|\mathbf u + \gamma\mathbf d|^2 = \tfrac12\sum m\,|\mathbf u|^2 + \sum m\,\mathbf
    /// a\cdot\mathbf d \f$ in each cluster; for two alone that is \f$ v^2 + 2 a p \f$ along the normal.
    /// \param lead    s, by how much u is ahead of the positions
    /// \param bounces which contacts bounce
    /// \param pull    N . (a_a - a_b) of a contact, m/s^2
    template <class Bounces, class Pull>
    void back_to_touch(int sweeps, Scalar lead, const Bounces& bounces, const Pull& pull) {
        before_.clear();
        for (auto& body : bodies) {
            before_.push_back(body.u);
            body.u = Raw::Zero();
        }
        for (auto& p : pushes) {
            p.kept = p.target;
            p.target = bounces(p) ? p.depth : std::min(p.depth, Scalar(0));
        }
        solve(sweeps, Scalar(1) / 64); // the energy is right for whatever displacements they are
        // Of the pushes only those that separate act; sums over contacts are those over bodies.
        for (auto& c : scratch_) c.slope = c.curvature = c.mixed = Scalar(0);
        for (auto& p : pushes) {
            if (p.lambda > Scalar(0)) {
                auto& c = scratch_[p.root];
                const Scalar a = pull(p), now = dot(Raw(before_[p.a] - before_[p.b]), p.normal) + lead * a;
                c.slope -= p.lambda * now;
                c.curvature += p.lambda * along(p);
                c.mixed += p.lambda * a;
            }
            p.lambda = p.total = Scalar(0);
            p.target = p.kept;
        }
        for (auto& c : scratch_) {
            const Scalar squared = c.slope * c.slope + Scalar(2) * c.curvature * c.mixed;
            const bool meets = c.slope > Scalar(0) && c.curvature > Scalar(0);
            c.length = !meets ? Scalar(0) : (c.slope - (squared > Scalar(0) ? sqrt(squared) : Scalar(0))) / c.curvature;
        }
        for (std::uint32_t n = 0; n < bodies.size(); ++n) {
            auto& body = bodies[n];
            body.u = body.weight > Scalar(0) ? Raw(before_[n] + scratch_[roots_.of(n)].length * body.u) : before_[n];
        }
    }

    /// Coulomb's law, contact by contact: what slides is slowed, in all by no more than mu times what was pushed along
    /// the normal.
    void rub() {
        for (auto& p : pushes) {
            const Scalar most = p.friction * p.total - p.rubbed;
            if (!(most > Scalar(0))) continue;
            auto &a = bodies[p.a], &b = bodies[p.b];
            const Raw between = a.u - b.u, sliding = between - dot(between, p.normal) * p.normal;
            const Scalar speed = norm(sliding);
            if (!(speed > Scalar(0))) continue;
            const Scalar holding = std::min(speed / (a.weight + b.weight), most); // no more than would stop it
            const Raw j = (-holding / speed) * sliding;
            a.u += a.weight * j;
            b.u -= b.weight * j;
            p.rubbed += holding;
        }
    }

    /// One sweep of bounces: all that approach are reflected at once, to `wanted(push)` where each is alone.
    /// \param wanted the speed at which a contact that approaches is to separate; nothing, if it does not bounce
    /// \return whether there was one
    template <class Wanted> bool bounce(const Wanted& wanted) {
        bool any = false;
        for (auto& p : pushes) {
            p.along = along(p);
            const auto speed = wanted(p);
            p.bounces = speed && *speed > p.along;
            p.residual = p.bounces ? *speed - p.along : Scalar(0);
            any = any || p.bounces;
        }
        if (!any) return false;
        cluster([](const Push& p) { return p.bounces; });
        for (auto& p : pushes)
            if (p.bounces) {
                p.step = p.residual / p.share;
                add(p, p.step);
                scratch_[p.root].slope += p.step * p.residual;
            }
        for (const auto& p : pushes)
            if (p.bounces) scratch_[p.root].curvature += p.step * dot(Raw(bodies[p.a].by - bodies[p.b].by), p.normal);
        for (auto& p : pushes)
            if (p.bounces) p.total += length(scratch_[p.root]) * p.step;
        move([&](std::uint32_t root) { return length(scratch_[root]); });
        return true;
    }

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;
    /// Of a cluster.
    struct Cluster {
        Scalar slope{}, curvature{}, norm{}, longest{}, size{}, before{}, mixed{}, kept{}, first{}, length{};
        Scalar start{}; // the size before the sweeps
        std::uint32_t count = 0;
        bool anew = false;       // a push ended: the next step is a projected one
        bool done = false;       // whatever other clusters still do
        bool endless = false;    // pushes were found that move nothing
        bool infeasible = false; // its targets contradict each other
    };
    void add(const Push& p, Scalar amount) {
        bodies[p.a].by += (amount * bodies[p.a].weight) * p.normal;
        bodies[p.b].by -= (amount * bodies[p.b].weight) * p.normal;
    }
    /// Of one contact alone the step is known to be the right one.
    static Scalar length(const Cluster& c) {
        return c.count == 1 ? Scalar(1) : c.curvature > Scalar(0) ? c.slope / c.curvature : Scalar(0);
    }
    template <class Length> [[gnu::flatten]] void move(const Length& of) {
        for (std::uint32_t n = 0; n < bodies.size(); ++n) {
            auto& body = bodies[n];
            if (body.count == 0 || !(body.weight > Scalar(0))) continue;
            body.u += of(roots_.of(n)) * body.by;
            body.by = Raw::Zero();
        }
    }

    /// The clusters that some of the contacts make; a body that cannot move connects none.
    template <class Which> void cluster(const Which& which) {
        roots_.reset(bodies.size());
        for (auto& body : bodies) body.count = 0, body.by = Raw::Zero();
        for (const auto& p : pushes) {
            if (!which(p)) continue;
            ++bodies[p.a].count, ++bodies[p.b].count;
            if (bodies[p.a].weight > Scalar(0) && bodies[p.b].weight > Scalar(0)) roots_.unite(p.a, p.b);
        }
        scratch_.assign(bodies.size(), Cluster());
        for (auto& p : pushes) {
            if (!which(p)) continue;
            const auto &a = bodies[p.a], &b = bodies[p.b];
            p.root = roots_.of(a.weight > Scalar(0) ? p.a : p.b);
            p.share = Scalar(a.count) * a.weight + Scalar(b.count) * b.weight;
            ++scratch_[p.root].count;
        }
    }
    /// The direction of a sweep.
    /// \return whether there is one
    [[gnu::flatten]] bool choose(bool first, Scalar enough) {
        for (auto& p : pushes) {
            if (p.waits) continue;
            auto& c = scratch_[p.root];
            const Scalar before = p.residual;
            p.along = along(p);
            p.residual = p.along - p.target;
            const bool in = p.lambda > Scalar(0) || p.residual < Scalar(0);
            const Scalar z = in ? p.residual / p.share : Scalar(0);
            c.size += z * p.residual;
            c.mixed += z * (p.residual - before);
        }
        if (first)
            for (auto& c : scratch_) c.start = c.size;
        bool any = false;
        for (auto& c : scratch_) {
            const bool finite = c.size <= std::numeric_limits<Scalar>::max();
            c.endless = c.endless || !finite;
            c.done = c.done || !finite || !(c.size > enough * enough * c.first);
            const bool turns = first || c.anew || !(c.before > Scalar(0)) || !(c.mixed > Scalar(0));
            c.kept = turns ? Scalar(0) : c.mixed / c.before;
            c.norm = c.size + c.kept * c.kept * c.norm;
        }
        for (auto& p : pushes) {
            if (p.waits) continue;
            auto& c = scratch_[p.root];
            const bool in = !c.done && (p.lambda > Scalar(0) || p.residual < Scalar(0));
            const Scalar z = in ? p.residual / p.share : Scalar(0);
            p.step = in ? c.kept * p.step - z : Scalar(0);
            if (c.anew ? p.lambda + p.step < Scalar(0) : !(p.lambda > Scalar(0)) && p.step < Scalar(0))
                p.step = -p.lambda;
            any = any || p.step != Scalar(0);
        }
        return any;
    }
    [[gnu::flatten]] void advance() {
        const Scalar unbounded = std::numeric_limits<Scalar>::max();
        for (auto& c : scratch_) c.slope = c.curvature = Scalar(0), c.longest = unbounded;
        for (const auto& p : pushes) {
            if (p.waits) continue;
            auto& c = scratch_[p.root];
            c.slope -= p.step * p.residual;
            if (p.step < Scalar(0)) c.longest = std::min(c.longest, p.lambda / -p.step);
            if (p.step != Scalar(0)) add(p, p.step);
        }
        for (const auto& p : pushes)
            if (!p.waits) scratch_[p.root].curvature += p.step * dot(Raw(bodies[p.a].by - bodies[p.b].by), p.normal);
        for (auto& c : scratch_) {
            if (c.count == 0) continue;
            const bool descends = c.slope > Scalar(0);
            c.endless = c.endless || (descends && c.longest == unbounded && !(c.curvature > nothing() * c.norm));
            const Scalar best = descends ? length(c) : Scalar(0);
            c.anew = !descends || best >= c.longest;
            c.length = std::min(best, c.longest);
            c.before = c.size;
            c.first = std::max(c.first, c.size);
            c.size = c.mixed = Scalar(0);
        }
        for (auto& p : pushes) {
            if (p.waits) continue;
            const auto& c = scratch_[p.root];
            const Scalar then = std::max(p.lambda + c.length * p.step, Scalar(0));
            p.total += then - p.lambda;
            p.lambda = then;
        }
        move([&](std::uint32_t root) { return scratch_[root].length; });
    }

    /// Finds the clusters whose targets seem to contradict each other: those whose misses the sweeps did not halve, or
    /// that are not solved after pushes that move nothing. (Both are seen in tall columns under heavy loads as well,
    /// where the other method often misses less, and in pushes that lift what is 10^10 times heavier, where it misses
    /// more.)
    /// \return whether there are any
    bool infeasible(Scalar enough) {
        bool open = false;
        for (auto& c : scratch_) {
            open = open || (c.count > 1 && (!c.done || c.endless));
            c.size = Scalar(0);
        }
        if (!open) return false;
        for (auto& p : pushes)
            if (!p.waits) scratch_[p.root].size += detail::missed(p, along(p));
        bool any = false;
        for (auto& c : scratch_) {
            c.infeasible = c.count > 1 && !(c.size <= (c.endless ? enough * enough : Scalar(0.25)) * c.start);
            any = any || c.infeasible;
        }
        return any;
    }
    /// Of a curvature, what is not distinguished from none.
    static Scalar nothing() { return Scalar(4) * std::numeric_limits<Scalar>::epsilon(); }

    std::vector<std::uint32_t> place_; // by slot
    std::vector<Cluster> scratch_;     // by the body that stands for it
    std::vector<Raw> before_;          // velocities, while displacements are solved
    Islands roots_;
};

} // namespace ansatz
