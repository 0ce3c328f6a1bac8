// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Gathering`: the forces of elements between bodies (springs), summed by each body for itself.
///
/// A loop over the elements adds to the sums of their ends, so that two ranges of it may add to one sum. Where an
/// Execution runs the loops, the forces of all elements are written down first, each in a place of its own; then each
/// body adds those of its ends, in the order of the elements. It is the order in which the serial loop adds them, so
/// that the sums are the same to the bit. It costs a number for each component of each end, and reading it back: two
/// passes in the place of one, which only threads pay for.
///
/// Not for forces between all bodies (`Attraction`): their pairs are too many to be written down.

#include <ansatz/world/execution.hpp>
#include <ansatz/world/lanes.hpp>
#include <ansatz/world/view.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
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

/// What the bodies gather of one force: room that is kept, and which ends each body has.
template <class S> class Gathering {
public:
    using Scalar = typename S::Scalar;

    /// Adds the forces of all elements to the sums of the bodies.
    /// \tparam C    the world's composition
    /// \param  sums the lanes of the sums, component by component
    template <class C, class Policies, class Force, class View, class ContextT>
    void add(const Policies& policies, const Force& force, const View& view, const ContextT& context,
             const std::array<Scalar*, std::size_t(S::dimension)>& sums) {
        constexpr std::size_t n = ends_of_element<Force, View>;
        const std::size_t elements = force.element_count(view), bodies = view.size();
        // Slots may have changed since, or been assigned from another world: each element is visited anyway.
        std::atomic<bool> others = ends_.size() != elements * n || first_.size() != bodies + 2;
        ends_.resize(elements * n);
        forces_.resize(elements * n * dimension);
        in_ranges<C>(policies, 0, elements, [&](std::size_t begin, std::size_t end) {
            bool moved = false;
            for (std::size_t k = begin; k < end; ++k) {
                const auto ends = force.ends(view, k);
                const auto forces = force.forces(view, k, context);
                for (std::size_t j = 0; j < n; ++j) {
                    const auto slot = std::uint32_t(ends[j]);
                    moved |= ends_[k * n + j] != slot;
                    ends_[k * n + j] = slot;
                    for (std::size_t d = 0; d < dimension; ++d)
                        forces_[(k * n + j) * dimension + d] = forces[j].value()[Eigen::Index(d)];
                }
            }
            if (moved) others.store(true, std::memory_order_relaxed);
        });
        if (others) arrange(bodies);
        in_ranges<C>(policies, 0, bodies, [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < end; ++slot)
                for (std::size_t d = 0; d < dimension; ++d) {
                    Scalar sum = sums[d][slot];
                    for (std::uint32_t at = first_[slot]; at < first_[slot + 1]; ++at)
                        sum += forces_[places_[at] * dimension + d];
                    sums[d][slot] = sum;
                }
        });
    }

private:
    static constexpr std::size_t dimension = std::size_t(S::dimension);

    /// Sorts the ends by their bodies, those of one body by their elements.
    void arrange(std::size_t bodies) {
        first_.resize(bodies + 2);
        std::fill(first_.begin(), first_.end(), 0);
        for (const auto slot : ends_)
            if (slot < bodies) ++first_[slot + 2];
        for (std::size_t slot = 2; slot < first_.size(); ++slot) first_[slot] += first_[slot - 1];
        places_.resize(first_.back());
        for (std::size_t place = 0; place < ends_.size(); ++place)
            if (ends_[place] < bodies) places_[first_[ends_[place] + 1]++] = std::uint32_t(place);
    }

    std::vector<std::uint32_t> ends_;                        // by element, end by end: the slot of a body
    std::vector<Scalar, CacheLineAllocator<Scalar>> forces_; // the same, component by component
    std::vector<std::uint32_t> first_;                       // by slot: where its places begin
    std::vector<std::uint32_t> places_;                      // of its ends, in their order
};

} // namespace detail
} // namespace ansatz
