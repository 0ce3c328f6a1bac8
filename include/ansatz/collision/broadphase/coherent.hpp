// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Coherent`: any broadphase, with pairs that live across steps (notes 2.1.1).
///
/// Use it where most bodies move by less than a tenth of their width in a step: piles, crowds, what drifts. Bodies keep
/// their neighbours then, and searching for them anew in each step is work for nothing. Each box is put into a fat one,
/// longer in the direction in which it goes; the inner broadphase finds the pairs of these, and until a box leaves its
/// own they are all that can touch. Each call tests those pairs, by the boxes as they are, so that what it tells is
/// what the inner one would tell, in another order: by the first index, then by the second.
///
/// It does not pay where bodies cross their width in a few steps, and where their number changes in every step. It
/// notices that, hands the boxes on to the inner broadphase, and tries again after 16 calls, then 32 and so on; all
/// this by counting, never by a clock, so that equal boxes are equal work. What it costs then is the order of the
/// pairs.

#include <ansatz/collision/broadphase/broadphase.hpp>
#include <ansatz/collision/broadphase/kept_pairs.hpp>
#include <ansatz/collision/broadphase/uniform_grid.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace ansatz {

namespace detail {
/// Whether its pairs can be kept: AllPairs tests no box.
template <class P> inline constexpr bool finds_by_boxes = PlaysRole<P, roles::Broadphase> && needs_boxes<P>;
} // namespace detail

/// The pairs whose boxes touch, kept while the boxes move little.
/// \tparam Broadphase what finds them anew, e.g. UniformGrid<>; not AllPairs
template <class Broadphase = UniformGrid<>> struct Coherent {
    static_assert(detail::finds_by_boxes<Broadphase>,
                  "Ansatz: Coherent of something that is no broadphase of boxes; write e.g. Coherent<UniformGrid<>>");
    using role = roles::Broadphase;
    /// `Broadphase`; after that sentence another, so that no more is said
    using Inner = std::conditional_t<detail::finds_by_boxes<Broadphase>, Broadphase, UniformGrid<>>;

    /// What finds the pairs of fat boxes, and all pairs where keeping them does not pay
    Inner inner{};

    static constexpr std::string_view name = "Coherent";
    static void parameters(auto& self, auto&& visit) {
        if constexpr (requires { Inner::parameters(self.inner, visit); }) Inner::parameters(self.inner, visit);
    }
    void check() const {
        if constexpr (requires { inner.check(); }) inner.check();
    }

    template <class S> class In {
    public:
        explicit In(const Coherent& coherent) : inner_(coherent.inner) {}
        /// Room for so many boxes.
        void reserve(std::size_t n) {
            kept_.reserve(n);
            if constexpr (requires { inner_.reserve(n); }) inner_.reserve(n);
        }
        template <class F> void find(const Boxes<S>& boxes, F&& found) {
            prepare(boxes, detail::Serially());
            finish(tell(0, pieces(), found));
        }
        /// \name The search in pieces, pairs of fat boxes, which may be tested at the same time
        /// @{
        /// Makes what is kept that of these boxes.
        void prepare(const Boxes<S>& boxes, const auto& run) {
            const bool as_before = boxes.size() == size_ && boxes.active() == active_;
            size_ = boxes.size(), active_ = boxes.active();
            if (!as_before) state_ = State::apart;
            searched_ = active_ > 0 && size_ > 1;
            if (!searched_) return;
            if (state_ == State::keeps) follow(boxes, run);
            else if (state_ == State::watches) kept_.watch(boxes), make(boxes);
            else if (pause_ > 0) --pause_;
            else if (as_before) kept_.watch(boxes), state_ = State::watches;
            if (state_ != State::keeps) kept_.find(inner_, boxes);
        }
        /// How many there are.
        std::size_t pieces() const { return searched_ ? kept_.size() : 0; }
        /// Tells those whose boxes touch, in order.
        template <class F> void find(const Boxes<S>&, std::size_t first, std::size_t last, F&& found) const {
            tell(first, last, found);
        }
        /// Judges whether it has paid.
        /// \param told how many pairs
        void finish(std::size_t told) {
            if (searched_ && state_ == State::keeps) judge(told);
        }
        /// @}

        /// \name What it does, to see whether it pays
        /// @{
        /// Whether it keeps pairs now, and does not only hand the boxes on.
        bool keeps() const { return state_ == State::keeps; }
        /// How often it has made all fat boxes, so far.
        std::size_t rebuilds() const { return rebuilds_; }
        /// How many boxes have left their fat ones without a rebuild, so far.
        std::size_t amended() const { return amended_; }
        /// How often it has given up, so far.
        std::size_t given_up() const { return given_up_; }
        /// @}

    private:
        /// It watches for one call before it keeps: from two it sees how boxes move.
        enum class State : unsigned char { apart, watches, keeps };

        /// About what each costs, in nanoseconds where they were measured; only the ratios matter.
        struct Costs {
            static constexpr std::uint64_t test = 8, kept_pair = 7, find = 65, pair = 38, fatten = 25, left = 700,
                                           wide = 2, merge = 2, table = 15;
        };
        static constexpr double reach = 0.3;                // of its width, which a body may go in a fat box
        static constexpr double fewest = 3, most = 64;      // calls that fat boxes shall last
        static constexpr int shortest = 16, longest = 1024; // calls until it tries again
        static constexpr int trial = 8, proven = 64;        // calls until it judges, and until a pause is short again

        /// \return how many touch
        template <class F> std::size_t tell(std::size_t first, std::size_t last, F& found) const {
            if (state_ == State::keeps) return kept_.tell(first, last, found);
            for (auto p = first; p < last; ++p) found(std::size_t(kept_[p].i), std::size_t(kept_[p].j));
            return last - first;
        }
        std::uint64_t cost_to_make() const {
            return size_ * (Costs::find + Costs::fatten) + kept_.size() * Costs::pair;
        }
        std::uint64_t cost_to_amend() const {
            return kept_.left() * (Costs::left + kept_.wide() * Costs::wide) + kept_.size() * Costs::merge +
                   (kept_.table_is_made() ? 0 : size_ * Costs::table);
        }
        /// All fat boxes anew, if they are going to last.
        void make(const Boxes<S>& boxes) {
            state_ = State::apart; // until it is done
            const BoxMotion motion = kept_.motion(active_);
            calls_ = motion.moved > 0 ? std::min(reach * motion.width / motion.moved, most) : most;
            if (!(calls_ >= fewest) || !kept_.make(inner_, boxes, motion, calls_)) return give_up();
            spent_ += cost_to_make();
            ++rebuilds_;
            age_ = 0;
            state_ = State::keeps;
        }
        void follow(const Boxes<S>& boxes, const auto& run) {
            kept_.follow(boxes, run);
            ++age_;
            if (kept_.left() == 0) return;
            const std::uint64_t cost = cost_to_amend();
            if (cost > cost_to_make() / 2) return make(boxes);
            state_ = State::apart;             // until it is done
            const double rest = calls_ - age_; // until most others will leave theirs
            if (!kept_.amend(rest >= fewest ? rest : calls_)) return give_up();
            spent_ += cost;
            amended_ += kept_.left();
            state_ = State::keeps;
        }
        /// Whether it has paid.
        void judge(std::size_t told) {
            spent_ += size_ * Costs::test + kept_.size() * Costs::kept_pair;
            saved_ += size_ * Costs::find + told * Costs::pair;
            if (++judged_ >= trial && spent_ > saved_) return give_up();
            if (judged_ < proven) return;
            spent_ /= 2, saved_ /= 2, judged_ = proven / 2; // the past counts less and less
            next_pause_ = shortest;
        }
        void give_up() {
            state_ = State::apart;
            ++given_up_;
            pause_ = next_pause_;
            next_pause_ = std::min(2 * next_pause_, longest);
            spent_ = saved_ = 0;
            judged_ = 0;
        }

        using BoxMotion = detail::BoxMotion;
        typename Inner::template In<S> inner_;
        detail::KeptPairs<S> kept_;
        State state_ = State::apart;
        bool searched_ = false;             // whether there was anything to search, in the last call
        std::size_t size_ = 0, active_ = 0; // of the last call
        double calls_ = 0, age_ = 0;        // how many fat boxes shall last, and have
        std::uint64_t spent_ = 0, saved_ = 0;
        int judged_ = 0, pause_ = 0, next_pause_ = shortest;
        std::size_t rebuilds_ = 0, amended_ = 0, given_up_ = 0;
    };
};

/// `Coherent{UniformGrid{1.0 * metre}}` keeps the pairs of that one.
template <class Broadphase> Coherent(Broadphase) -> Coherent<Broadphase>;

} // namespace ansatz
