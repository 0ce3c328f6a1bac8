// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Swept<Narrowphase<...>>`: continuous detection, for steps in which bodies move by more than their own size
/// (notes 2.1.2: "the time step must be small enough").
///
/// Use it for bullets, fast balls and thin walls: `World{..., Swept<Narrowphase<Sphere, Box>>{}, ...}`. A body that
/// would pass through another in a step, or come so deep into it that it would be pushed out on the wrong side, is kept
/// at the place where the two first touch, with the velocity that it had there, and the responses see a contact with
/// the right normal. What is left of the step is lost to it. Not for scenes in which nothing moves by more than a
/// quarter of its radius in a step: there it costs a check of each body and changes no bit.
///
/// - Spheres are followed against spheres, planes and boxes, boxes against planes and boxes; a shape of yours needs
///   `first_touch`.
/// - A body with infinite mass is never held up; what it runs into goes along with it for the rest of the step, and may
///   be pressed into what stands behind it.
/// - An impact that would be over at the end of the step and never deeper than a sixteenth of the smaller radius is no
///   impact, so that a ball may roll over the seams of a floor.
/// - `Penalty` needs bodies inside each other: they are kept that sixteenth deep, and its spring throws them out again.
///   Nothing escapes, but the energy of such a hit is not kept.
/// - Springs between bodies act over the whole step: momentum is kept, and energy but for what they do in the time
///   that is lost.

#include <ansatz/collision/swept_collisions.hpp>

#include <concepts>
#include <string_view>
#include <type_traits>

namespace ansatz {

namespace detail {
template <class N>
concept Wrappable = PlaysRole<N, roles::Narrowphase> && std::is_class_v<N> && !std::is_final_v<N>;
struct NothingToSweep {
    using role = roles::Narrowphase;
};
} // namespace detail

/// A narrowphase that tests the motion of a step, too.
/// \tparam N    the narrowphase, e.g. Narrowphase<Sphere, Plane, Box>
/// \tparam More nothing; it stands here so that Swept<Sphere, Box> is told what is missing
template <class N, class... More> struct Swept : std::conditional_t<detail::Wrappable<N>, N, detail::NothingToSweep> {
    static_assert(
        detail::Wrappable<N> && sizeof...(More) == 0,
        "Ansatz: Swept of something that is no narrowphase; write e.g. Swept<Narrowphase<Sphere, Plane, Box>>{}");
    static_assert(
        !requires { requires N::continuous; },
        "Ansatz: Swept of a narrowphase that is swept already; leave one Swept out");

    static constexpr std::string_view name = "Swept"; ///< in a saved file
    static constexpr bool continuous = true;          ///< bodies are followed through the step

    /// Of any narrowphase.
    Swept() = default;
    /// Of this one.
    explicit Swept(const N& narrowphase) : N(narrowphase) {}

    /// What a world holds of them.
    template <class C> using Collisions = SweptCollisions<C>;
};

template <class N> Swept(N) -> Swept<N>; ///< what it wraps is the type

} // namespace ansatz
