// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ContactColours`: the contacts of a step by colours, and the passes over them, for `SoftSubsteps<Coloured>`. Beyond
/// the notes.
///
/// No two contacts of a colour push the same body, so that all of a colour may be solved at once: their bodies are
/// gathered, the impulses of 64 contacts are computed in loops without branches, which compilers turn into whatever
/// vector instructions there are, and what they do to the bodies is written back. The formulas are those of
/// SoftContacts, for each contact by itself, so that the results are the same bits with wide instructions and without.
///
/// Colours are given by the ids of bodies, group by group (contact_groups.hpp): each contact has the first that neither
/// of its bodies has yet. What nothing moves (the floor) may be in any number of contacts of a colour. Piles of 64 to
/// 8000 spheres have nine to eleven colours in their largest group.
///
/// M. Fratarcangeli, V. Tibaldo, F. Pellacini, Vivace: a Practical Gauss-Seidel Method for Stable Soft Body Dynamics,
/// SIGGRAPH Asia 2016, for colours; E. Catto, SIMD Matters (2024), for contacts of a rigid body solver by colours.

#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/response/contact_groups.hpp>
#include <ansatz/collision/response/solver_body.hpp>
#include <ansatz/world/execution.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ansatz {

/// Lanes of contacts, colour by colour.
/// \tparam Rubs whether there is friction
template <class S, bool Rubs> class ContactColours {
public:
    using Scalar = typename S::Scalar;
    using Body = SolverBody<S>;             ///< what is solved for
    using Half = typename Body::Half;       ///< a vector and a number beside it
    static constexpr std::size_t most = 64; ///< colours; contacts that find none are solved one by one, behind them

    /// What a pass does about contacts that are too deep, and about those that do not touch yet.
    struct Pass {
        Scalar h{};              ///< s, the substep
        Softness<Scalar> free{}; ///< between bodies that may both be pushed
        Softness<Scalar> held{}; ///< with what nothing moves
        Scalar slop{};           ///< m, how deep bodies may stay in each other
        Scalar push_out{};       ///< m/s, how fast they separate at most
        bool separates = true;   ///< whether it takes depth away; else it takes back what that gave
    };

    /// Groups and colours those of `all` that act, and takes their impulses.
    /// \param awake how many bodies contacts may push, if they come first; zero if they stand anywhere
    /// \param ids   one more than the largest id of a body
    /// \param run   runs the groups of a stage
    void colour(const auto& all, const std::vector<std::uint32_t>& acting, const std::vector<Body>& bodies,
                std::size_t awake, std::size_t ids, const LoopRunner& run) {
        const std::size_t count = acting.size();
        const auto moved = [&](std::size_t n) {
            const auto& c = all[acting[n]];
            return std::pair(moves(bodies[c.slot_a]) ? c.a : c.b, moves(bodies[c.slot_b]) ? c.b : c.a);
        };
        groups_.divide(count, ids, moved, run);
        const std::size_t movers = awake > 0 ? awake : bodies.size(); // nothing for those that sleep
        detail::grow(taken_, movers);
        taken_.assign(movers, 0);
        resize(count, colour_of_, which_, held_, a_, b_, touching_, impulse_, mass_, normal_);
        if constexpr (Rubs) resize(count, rubbing_, friction_);
        begin_.resize(groups_.size());
        groups_.each(run, [&](std::size_t group) {
            colour_group(group, all, acting, bodies);
            fill(group, all, bodies);
        });
    }
    /// The impulses of `all`, which others have changed.
    void read_impulses(const auto& all) {
        for (std::size_t n = 0; n < which_.size(); ++n) read(n, all[which_[n]]);
    }
    /// The impulses, to `all`.
    void write_impulses(auto& all) const {
        for (std::size_t n = 0; n < which_.size(); ++n) {
            auto& c = all[which_[n]];
            c.impulse = impulse_[n];
            if constexpr (Rubs)
                for (int k = 0; k < S::dimension; ++k) c.rubbing[k] = rubbing_[n][k];
        }
    }
    /// The impulses of the substep before act again.
    void warm_start(std::vector<Body>& bodies, const LoopRunner& run) const {
        groups_.each(run, [&](std::size_t group) { warm_start(bodies, group); });
    }
    /// One pass.
    void solve(std::vector<Body>& bodies, const Pass& pass, const LoopRunner& run) {
        groups_.each(run, [&](std::size_t group) { solve(bodies, pass, group); });
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ContactColours& other) {
        const auto reserve = [](auto& lane, const auto& as) { lane.reserve(as.size()); };
        groups_.make_room_for(other.groups_);
        reserve(begin_, other.begin_);
        reserve(taken_, other.taken_);
        reserve(colour_of_, other.colour_of_);
        for (auto lane : {&ContactColours::a_, &ContactColours::b_, &ContactColours::which_})
            reserve(this->*lane, other.*lane);
        for (auto lane : {&ContactColours::touching_, &ContactColours::impulse_, &ContactColours::mass_,
                          &ContactColours::held_, &ContactColours::friction_})
            reserve(this->*lane, other.*lane);
        for (auto lane : {&ContactColours::normal_, &ContactColours::rubbing_}) reserve(this->*lane, other.*lane);
    }

private:
    static constexpr int dim = S::dimension;
    /// So many are taken at once: enough to fill vector units, few enough to stay in the nearest cache.
    static constexpr std::size_t chunk = 64;
    /// Not initialized: each pass writes what it reads.
    struct Chunk {
        alignas(64) std::array<Half, chunk> going;   // u_a - u_b, m/s
        alignas(64) std::array<Half, chunk> apart;   // x_a - x_b, m
        alignas(64) std::array<Half, chunk> push;    // what is done to the first body, N s
        alignas(64) std::array<Half, chunk> rubbing; // across the normal, N s
        alignas(64) std::array<Scalar, chunk> along; // N . (u_a - u_b), m/s
        alignas(64) std::array<Scalar, chunk> gap;   // negative where they intersect, m
        alignas(64) std::array<Scalar, chunk> by;    // by how much the impulse changes, N s
        alignas(64) std::array<Scalar, chunk> acts;  // 0 in `relax` for those that neither touch nor have pressed
        alignas(64) std::array<Scalar, chunk> share; // of what friction may do
    };

    // By value: of references compilers make branches.
    static Scalar smaller(Scalar a, Scalar b) { return b < a ? b : a; }
    static Scalar larger(Scalar a, Scalar b) { return a < b ? b : a; }
    static std::uint64_t moves(const Body& body) { return body.weight > Scalar(0); }
    void colour_group(std::size_t group, const auto& all, const std::vector<std::uint32_t>& acting,
                      const std::vector<Body>& bodies) {
        const auto [first, last] = groups_[group];
        std::array<std::uint32_t, most + 2> next{}; // where the next contact of each colour goes
        std::uint64_t none = 0;                     // the colours of what nothing moves
        // Pointers of its own: behind each byte that is written compilers would read those of the lists again.
        const Body* const body = bodies.data();
        std::uint64_t* const taken = taken_.data();
        std::uint8_t* const colour_of = colour_of_.data();
        const auto* const constraint = all.data();
        const auto number = [which = acting.data(), order = groups_.order()](std::uint32_t n) {
            return which[order ? order[n] : n];
        };
        for (std::uint32_t n = first; n < last; ++n) {
            const auto& c = constraint[number(n)];
            const std::uint64_t a = moves(body[c.slot_a]), b = moves(body[c.slot_b]);
            auto &of_a = a ? taken[c.slot_a] : none, &of_b = b ? taken[c.slot_b] : none;
            const auto colour = std::size_t(std::countr_one(of_a | of_b));
            colour_of[n] = std::uint8_t(colour | (a & b) << 7);
            ++next[colour + 1];
            if (colour == most) continue;
            of_a |= a << colour;
            of_b |= b << colour;
        }
        next[0] = first;
        for (std::size_t c = 0; c <= most; ++c) next[c + 1] += next[c];
        begin_[group] = next;
        for (std::uint32_t n = first; n < last; ++n) {
            const auto place = next[colour_of[n] & 127]++;
            which_[place] = number(n);
            held_[place] = Scalar(colour_of[n] & 128 ? 0 : 1);
        }
    }
    // Flattened: in a file with several worlds g++ would call the arithmetic of vectors.
    [[gnu::flatten, gnu::noinline]] void warm_start(std::vector<Body>& bodies, std::size_t group) const {
        each_chunk(group, [&](std::size_t first, std::size_t count) {
            Chunk kept;
            for (std::size_t n = 0; n < count; ++n) {
                kept.push[n] = impulse_[first + n] * normal_[first + n];
                if constexpr (Rubs) kept.push[n] += rubbing_[first + n];
            }
            push(bodies, first, count, kept);
        });
    }
    [[gnu::flatten, gnu::noinline]] void solve(std::vector<Body>& bodies, const Pass& pass, std::size_t group) {
        each_chunk(group, [&](std::size_t first, std::size_t count) {
            Chunk kept;
            gather(bodies, first, count, kept);
            press(pass, first, count, kept);
            rub(pass, first, count, kept);
            push(bodies, first, count, kept);
        });
    }
    template <class F> [[gnu::always_inline]] void each_chunk(std::size_t group, F&& f) const {
        const auto& begin = begin_[group];
        for (std::size_t colour = 0; colour <= most; ++colour) {
            // Those without a colour may push the same bodies.
            const std::size_t step = colour < most ? chunk : 1, end = begin[colour + 1];
            for (std::size_t n = begin[colour]; n < end; n += step) f(n, std::min(step, end - n));
        }
    }
    static void resize(std::size_t count, auto&... lanes) { ((detail::grow(lanes, count), lanes.resize(count)), ...); }
    void fill(std::size_t group, const auto& all, const std::vector<Body>& bodies) {
        const auto [first, last] = groups_[group];
        for (std::size_t n = first; n < last; ++n) {
            const auto& c = all[which_[n]];
            a_[n] = c.slot_a;
            b_[n] = c.slot_b;
            normal_[n] = Body::half_of(c.normal);
            touching_[n] = c.touching;
            mass_[n] = c.mass;
            if constexpr (Rubs) friction_[n] = c.friction;
            read(n, c);
            // The next group of these bodies begins with the first colour again.
            if (moves(bodies[c.slot_a])) taken_[c.slot_a] = 0;
            if (moves(bodies[c.slot_b])) taken_[c.slot_b] = 0;
        }
    }
    void read(std::size_t n, const auto& c) {
        impulse_[n] = c.impulse;
        if constexpr (Rubs) rubbing_[n] = Body::half_of(c.rubbing);
    }
    [[gnu::always_inline]] void gather(const std::vector<Body>& bodies, std::size_t first, std::size_t count,
                                       Chunk& kept) const {
        for (std::size_t n = 0; n < count; ++n) {
            const Body &a = bodies[a_[first + n]], &b = bodies[b_[first + n]];
            kept.going[n] = a.moving() - b.moving();
            kept.apart[n] = a.standing() - b.standing();
        }
    }
    /// How much more they press, or less: never so that they pull.
    [[gnu::always_inline]] void press(const Pass& pass, std::size_t first, std::size_t count, Chunk& kept) {
        const Half* __restrict normal = normal_.data() + first;
        const Scalar* __restrict touching = touching_.data() + first;
        for (std::size_t n = 0; n < count; ++n) {
            Scalar along(0), apart(0);
            for (int k = 0; k < dim; ++k) along += kept.going[n][k] * normal[n][k];
            for (int k = 0; k < dim; ++k) apart += kept.apart[n][k] * normal[n][k];
            kept.along[n] = along;
            kept.gap[n] = apart - touching[n];
        }
        const Scalar* __restrict mass = mass_.data() + first;
        const Scalar* __restrict held = held_.data() + first;
        Scalar* __restrict impulse = impulse_.data() + first;
        const Scalar per_h = 1 / pass.h, slop = pass.slop, push_out = pass.push_out;
        const Softness<Scalar> by_free = pass.free, by_held = pass.held;
        // By arithmetic: compilers make a branch of a choice between what is computed and what is not.
        if (pass.separates)
            for (std::size_t n = 0; n < count; ++n) {
                const Scalar gap = kept.gap[n], before = impulse[n], deep = gap > Scalar(0) ? Scalar(0) : Scalar(1);
                const Scalar one = held[n], both = Scalar(1) - one;
                const Scalar rate = both * by_free.rate + one * by_held.rate;
                const Scalar soft_mass = both * by_free.mass + one * by_held.mass;
                const Scalar soft_impulse = both * by_free.impulse + one * by_held.impulse;
                const Scalar bias =
                    larger(gap * per_h, Scalar(0)) + larger(rate * smaller(gap + slop, Scalar(0)), -push_out);
                const Scalar share = (Scalar(1) - deep) + deep * soft_mass;
                const Scalar j = -mass[n] * share * (kept.along[n] + bias) - deep * soft_impulse * before;
                const Scalar now = larger(before + j, Scalar(0));
                kept.by[n] = now - before;
                kept.acts[n] = 1;
                impulse[n] = now;
            }
        else
            for (std::size_t n = 0; n < count; ++n) {
                const Scalar gap = kept.gap[n], before = impulse[n];
                const Scalar presses = before > Scalar(0) ? Scalar(1) : Scalar(0);
                const Scalar acts = gap > Scalar(0) ? presses : Scalar(1);
                const Scalar bias = larger(gap * per_h, Scalar(0));
                const Scalar now = acts * larger(before - mass[n] * (kept.along[n] + bias), Scalar(0));
                kept.by[n] = now - before;
                kept.acts[n] = acts;
                impulse[n] = now;
            }
        for (std::size_t n = 0; n < count; ++n) kept.push[n] = kept.by[n] * normal[n];
    }
    /// Coulomb's law: what slides is held back by at most mu times what presses. What the impulse along the normal does
    /// is no sliding, so that both are computed from the same velocities.
    [[gnu::always_inline]] void rub([[maybe_unused]] const Pass& pass, [[maybe_unused]] std::size_t first,
                                    [[maybe_unused]] std::size_t count, [[maybe_unused]] Chunk& kept) {
        if constexpr (Rubs) {
            using std::sqrt;
            const Half* __restrict normal = normal_.data() + first;
            const Scalar* __restrict mass = mass_.data() + first;
            const Scalar* __restrict impulse = impulse_.data() + first;
            const Scalar* __restrict friction = friction_.data() + first;
            Half* __restrict before = rubbing_.data() + first;
            for (std::size_t n = 0; n < count; ++n)
                kept.rubbing[n] = before[n] - mass[n] * (kept.going[n] - kept.along[n] * normal[n]);
            const Scalar smallest = std::numeric_limits<Scalar>::denorm_min(); // Boost.Multiprecision's is zero
            const Scalar least = smallest > Scalar(0) ? smallest : (std::numeric_limits<Scalar>::min)();
            for (std::size_t n = 0; n < count; ++n) {
                Scalar squared(0);
                for (int k = 0; k < dim; ++k) squared += kept.rubbing[n][k] * kept.rubbing[n][k];
                const Scalar size = sqrt(squared), most_here = friction[n] * impulse[n];
                kept.share[n] = most_here / larger(larger(size, most_here), least); // 1: it sticks
            }
            for (std::size_t n = 0; n < count; ++n) {
                const Half was = before[n], slid = kept.share[n] * kept.rubbing[n];
                const Half now = kept.acts[n] > Scalar(0) ? slid : was;
                kept.push[n] += now - was;
                before[n] = now;
                kept.push[n][dim] = before[n][dim] = 0; // where the difference of weights stood
            }
        }
    }
    /// Impulses on the first bodies, and the opposite ones on the others.
    [[gnu::always_inline]] void push(std::vector<Body>& bodies, std::size_t first, std::size_t count,
                                     Chunk& kept) const {
        for (std::size_t n = 0; n < count; ++n) {
            Body &a = bodies[a_[first + n]], &b = bodies[b_[first + n]];
            // Beside a push stands zero: the weights stay.
            const Half pushed = kept.push[n];
            // What nothing moves is not written either: contacts of other groups read it at the same time.
            if (moves(a)) a.move(a.moving() + a.weight * pushed);
            if (moves(b)) b.move(b.moving() - b.weight * pushed);
        }
    }

    std::vector<std::uint32_t> a_, b_;    // slots
    std::vector<std::uint32_t> which_;    // of all
    std::vector<Half> normal_;            // from b to a
    std::vector<Scalar> touching_;        // N . (x_a - x_b) where they only touch, m
    std::vector<Scalar> impulse_;         // along the normal, N s
    std::vector<Scalar> mass_;            // 1 / (w_a + w_b), kg
    std::vector<Scalar> held_;            // 1 where nothing moves one of the bodies
    std::vector<Half> rubbing_;           // across the normal, N s
    std::vector<Scalar> friction_;        // the coefficient of the two
    std::vector<std::uint64_t> taken_;    // by slot: a bit for each colour
    std::vector<std::uint8_t> colour_of_; // by contact that acts; 128 more where nothing holds a body of it
    ContactGroups groups_;
    std::vector<std::array<std::uint32_t, most + 2>> begin_; // by group: of each colour, and of what has none
};

} // namespace ansatz
