// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Two boxes along the axes: they intersect where they overlap on every axis, and separate along the axis with the
/// least overlap.
///
/// Where two axes have the same overlap the lower one is taken; boxes with one centre on it separate upwards for the
/// first. The contact point is the middle of what they have in common.

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/contact.hpp>

namespace ansatz {

/// Whether two boxes intersect, and how.
/// \param xa, xb where their centres are, m
template <class S>
bool collide(const Box::In<S>& a, const typename S::Position& xa, const Box::In<S>& b, const typename S::Position& xb,
             Touch<S>& touch) {
    using Scalar = typename S::Scalar;
    const typename S::Position between = xa - xb;
    int axis = 0;
    Scalar least{};
    for (int k = 0; k < S::dimension; ++k) {
        const Scalar overlap = (a.half.value()[k] + b.half.value()[k]) - abs(between.value()[k]);
        if (!(overlap > Scalar(0))) return false;
        if (k == 0 || overlap < least) axis = k, least = overlap;
    }
    touch.depth = S::Length::from_value(least);
    auto middle = xa.value();
    for (int k = 0; k < S::dimension; ++k) {
        touch.normal[k] = k != axis ? Scalar(0) : between.value()[k] < Scalar(0) ? Scalar(-1) : Scalar(1);
        const Scalar low = max(xa.value()[k] - a.half.value()[k], xb.value()[k] - b.half.value()[k]);
        const Scalar high = min(xa.value()[k] + a.half.value()[k], xb.value()[k] + b.half.value()[k]);
        middle[k] = Scalar(0.5) * (low + high);
    }
    touch.point = S::Position::from_value(middle);
    return true;
}

} // namespace ansatz
