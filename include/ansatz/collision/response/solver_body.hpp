// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What contacts and joints are solved with: `SolverBody`, a body while they are, and `Softness`, how they answer.
/// Beyond the notes.

#include <ansatz/units.hpp>

#include <cstddef>

namespace ansatz {

/// How a soft contact answers in a substep of length h:
/// \f$ \omega = 2\pi f \f$, \f$ a_1 = 2\zeta + \omega h \f$, \f$ a_2 = \omega h a_1 \f$.
template <class Scalar> struct Softness {
    Scalar rate = 0;    ///< 1/s: how much of the depth is taken away in a second, omega / a1
    Scalar mass = 1;    ///< the share of the wrong velocity that is taken away, a2 / (1 + a2)
    Scalar impulse = 0; ///< the share of the impulse so far that is given back, 1 / (1 + a2)
    /// \param f    1/s
    /// \param zeta damping ratio
    /// \param h    s
    static Softness of(Scalar f, Scalar zeta, Scalar h) {
        const Scalar omega = Scalar(6.283185307179586476925286766559) * f, a1 = 2 * zeta + omega * h,
                     a2 = omega * h * a1;
        return {omega / a1, a2 / (1 + a2), 1 / (1 + a2)};
    }
};

/// A body while its contacts are solved.
template <class S> struct SolverBody {
    using Raw = Vector<typename S::Scalar, S::dimension>; ///< raw SI
    Raw u;                                                ///< the mean velocity over the substep, m/s
    Raw position;                                         ///< where it is, m
    typename S::Scalar weight{};                          ///< 1/m, 1/kg; zero for what is not moved
};

namespace detail {
/// The slots of bodies that may move.
struct Movers {
    std::size_t awake = 0;                  ///< how many are; they come first
    std::size_t moving = 0, moving_end = 0; ///< the platforms
};
} // namespace detail

} // namespace ansatz
