// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Shapes without a box, such as planes: which boxes they may touch. Beyond the notes.
///
/// A broadphase does not know them, so that each is held against every body. One that can tell of a box that it misses
/// it (`Plane` can) spares the narrowphase most of them.

#include <ansatz/collision/boxes.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace ansatz::detail {

/// Whether a shape tells which boxes it misses, from their corners and its own place, all in m. Where rounding decides,
/// it does not miss.
template <class Shape, class S>
concept TellsMisses = requires(const Shape& shape, const Vector<typename S::Scalar, S::dimension>& at) {
    { shape.misses(at, at, at) } -> std::same_as<bool>;
};

/// Calls `f(i)` for those of the first `n` boxes that a shape may touch: in their order, and for all of them if it does
/// not tell which it misses.
/// \param shape null where it moves, so that its way is not known here: it may touch all
/// \param x     where the shape's body is, m
template <class S, class Shape, class F>
[[gnu::always_inline]] inline void each_box_near(const Boxes<S>& boxes, std::size_t n, const Shape* shape,
                                                 const typename S::Position& x, F&& f) {
    constexpr std::size_t block = 64; // asked at once, without a branch
    for (std::size_t first = 0; first < n; first += block) {
        const std::size_t count = std::min(block, n - first);
        std::array<std::uint8_t, block> misses{};
        if constexpr (TellsMisses<Shape, S>)
            if (shape)
                for (std::size_t k = 0; k < count; ++k)
                    misses[k] = shape->misses(boxes.lower_corner(first + k), boxes.upper_corner(first + k), x.value());
        for (std::size_t k = 0; k < count; ++k)
            if (!misses[k]) f(first + k);
    }
}

} // namespace ansatz::detail
