// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Gathering`: the forces of elements between bodies (springs), summed by shares of the bodies.
///
/// A loop over the elements adds to the sums of their ends, so that two ranges of it may add to one sum. Where an
/// Execution runs the loops, the bodies are divided instead, into shares that follow each other by slot. Each share
/// goes through the elements that act on one of its bodies, in their order, and adds the forces on its own bodies
/// alone: the owner computes. It is the order in which the serial loop adds them, so that the sums are the same to the
/// bit.
///
/// An element between two shares is asked by both. Where bodies that hang together follow each other, as in a rope or a
/// sheet, those are few; where they stand in no order, every second one of two shares is.
///
/// Not for forces between all bodies (`Attraction`): every pair would be asked twice.

#include <ansatz/world/execution.hpp>
#include <ansatz/world/view.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
template <class Force, class View> inline constexpr std::size_t ends_of_element = 0;
template <class Force, class View>
    requires requires(const Force& force, const View& view) { force.ends(view, std::size_t()).size(); }
inline constexpr std::size_t ends_of_element<Force, View> =
    std::tuple_size_v<std::remove_cvref_t<decltype(std::declval<const Force&>().ends(std::declval<const View&>(), 0))>>;

/// A force that names this verb means to be gathered: without the others it would be summed serially in silence.
struct ElementVerb {
    int element_count;
};
template <class Force>
struct BesideElementVerb
    : Force
    , ElementVerb {};
template <class Force> inline constexpr bool names_elements = !requires { &BesideElementVerb<Force>::element_count; };
} // namespace detail

/// A force between bodies whose elements can be asked one by one, so that an Execution may divide the loop over them.
///
/// Beside `couple`, `In<S>` has `element_count(view)`; `ends(view, k)`, an array of the slots that element k acts on
/// (`view.size()` for one that is no body); and `forces(view, k, context)`, an array of the forces on them. `couple`
/// comes to the same: it adds them element by element, end by end.
///
/// \ref ansatz::Springs "Springs" and \ref ansatz::Ropes "Ropes" have them (notes 3).
template <class P, class S>
concept GatheredCouplingIn =
    (detail::ends_of_element<detail::Bound<P, S>, CouplingView<S, P>> > 0) &&
    requires(const detail::Bound<P, S>& force, const CouplingView<S, P>& view, std::size_t k,
             const Context<S, detail::reads_clock<P>>& context) {
        { force.element_count(view) } -> std::convertible_to<std::size_t>;
        { force.ends(view, k)[0] } -> std::convertible_to<std::size_t>;
        {
            force.forces(view, k, context)
        } -> std::convertible_to<
            std::array<typename S::Force, detail::ends_of_element<detail::Bound<P, S>, CouplingView<S, P>>>>;
    };

namespace detail {

/// The elements of one force by shares of the bodies: which share goes through which.
template <class S> class Gathering {
public:
    using Scalar = typename S::Scalar;

    /// Adds the forces of all elements to the sums of the bodies.
    /// \tparam C    the world's composition
    /// \param  sums the lanes of the sums, component by component
    /// \return false where elements act on other slots than the last time, which is noticed while they are added: the
    ///         sums are of no use then. Called again with the sums as they were before, it adds them
    template <class C, class Policies, class Force, class View, class ContextT>
    [[nodiscard]] bool add(const Policies& policies, const Force& force, const View& view, const ContextT& context,
                           const std::array<Scalar*, std::size_t(S::dimension)>& sums) {
        constexpr std::size_t n = ends_of_element<Force, View>;
        const std::size_t threads = threads_of<C>(policies);
        if (ends_.size() != force.element_count(view) * n || bodies_ != view.size()) arrange<n>(force, view, threads);
        std::atomic<bool> moved = false;
        runner_of<C>(policies)(shares_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin)
                if (!add_share<n>(shares_[begin], force, view, context, sums))
                    moved.store(true, std::memory_order_relaxed);
        });
        if (moved) arrange<n>(force, view, threads);
        return !moved;
    }

private:
    struct Run {
        std::uint32_t begin, end;
        bool whole; // whether all that they act on are bodies of the share
    };
    struct Share {
        std::uint32_t begin, end; // the slots of its bodies
        std::vector<Run> runs{};  // of elements that act on one of them
    };

    /// With everything inlined, as in `couple` of a force.
    template <std::size_t n>
    [[gnu::flatten]] bool add_share(const Share& share, const auto& force, const auto& view, const auto& context,
                                    const std::array<Scalar*, std::size_t(S::dimension)>& sums) const {
        const std::uint32_t* kept = ends_.data();
        const std::uint32_t first = share.begin, count = share.end - share.begin;
        bool same = true;
        const auto add_run = [&](const Run& run, auto whole) {
            for (std::size_t k = run.begin; k < run.end; ++k) {
                const auto ends = force.ends(view, k);
                bool others = false;
                for (std::size_t j = 0; j < n; ++j) others |= kept[k * n + j] != std::uint32_t(ends[j]);
                if (others) {
                    same = false;
                    continue;
                }
                const auto forces = force.forces(view, k, context);
                for (std::size_t j = 0; j < n; ++j) {
                    const auto slot = std::uint32_t(ends[j]);
                    if (!whole && slot - first >= count) continue; // of another share, or no body
                    for (std::size_t d = 0; d < dimension; ++d) sums[d][slot] += forces[j].value()[Eigen::Index(d)];
                }
            }
        };
        for (const Run& run : share.runs)
            if (run.whole) add_run(run, std::true_type());
            else add_run(run, std::false_type());
        return same;
    }

    /// Finds out who goes through which elements. One that acts on no body is looked at, too: it may act on one later.
    template <std::size_t n> void arrange(const auto& force, const auto& view, std::size_t threads) {
        const std::size_t elements = force.element_count(view);
        bodies_ = 0; // unless it comes to its end
        ends_.resize(elements * n);
        for (std::size_t k = 0; k < elements; ++k) {
            const auto ends = force.ends(view, k);
            for (std::size_t j = 0; j < n; ++j) ends_[k * n + j] = std::uint32_t(ends[j]);
        }
        divide(view.size(), threads);
        for (std::size_t k = 0; k < elements; ++k) {
            std::array<std::size_t, n> of{}; // the shares; of no body: none
            for (std::size_t j = 0; j < n; ++j) {
                const std::size_t slot = ends_[k * n + j];
                of[j] = slot < view.size() ? share_of_line_[slot / line] : shares_.size();
            }
            const bool whole = std::count(of.begin(), of.end(), of[0]) == std::ptrdiff_t(n);
            bool none = true;
            for (const std::size_t share : of)
                if (share < shares_.size()) {
                    note(shares_[share], std::uint32_t(k), whole);
                    none = false;
                }
            if (none) note(shares_.front(), std::uint32_t(k), false);
        }
        bodies_ = view.size();
    }
    static void note(Share& share, std::uint32_t k, bool whole) {
        if (share.runs.empty() || share.runs.back().end < k || share.runs.back().whole != whole)
            share.runs.push_back({k, k + 1, whole});
        else share.runs.back().end = k + 1;
    }
    /// One share for each thread, with as many ends as the others: but no more shares than grow with the square root of
    /// the bodies, as the elements between two shares of a sheet do, so that they stay a twentieth of all.
    void divide(std::size_t bodies, std::size_t threads) {
        const std::size_t lines = (bodies + line - 1) / line, most = std::size_t(std::sqrt(double(bodies)) / 16);
        const std::size_t wanted = std::max<std::size_t>(1, threads ? std::min(threads, most) : std::bit_floor(most));
        share_of_line_.assign(lines, 0);
        for (const std::size_t slot : ends_)
            if (slot < bodies) ++share_of_line_[slot / line]; // first the number of its ends
        const auto all = std::accumulate(share_of_line_.begin(), share_of_line_.end(), std::uint64_t(0));
        for (Share& share : shares_) share.runs.clear();
        shares_.resize(wanted);
        std::uint64_t before = 0; // ends of the lines so far
        for (std::size_t share = 0, i = 0; i < lines; ++i) {
            const std::uint64_t of_line = share_of_line_[i];
            if (share + 1 < wanted && (2 * before + of_line) * wanted >= 2 * all * (share + 1)) ++share;
            share_of_line_[i] = std::uint32_t(share);
            before += of_line;
        }
        for (std::size_t share = 0, i = 0; share < wanted; ++share) {
            shares_[share].begin = std::uint32_t(std::min(bodies, i * line));
            while (i < lines && share_of_line_[i] == share) ++i;
            shares_[share].end = std::uint32_t(std::min(bodies, i * line));
        }
    }

    static constexpr std::size_t dimension = std::size_t(S::dimension);
    static constexpr std::size_t line = rows_of_a_line<Scalar>; // shares of bodies that write to no line together

    std::vector<std::uint32_t> ends_; // by element, end by end: the slot of a body
    std::size_t bodies_ = 0;
    std::vector<std::uint32_t> share_of_line_; // by slot, a cache line at a time
    std::vector<Share> shares_;
};

} // namespace detail
} // namespace ansatz
