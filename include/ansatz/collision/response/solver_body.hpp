// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What contacts and joints are solved with: `SolverBody`, a body while they are, and `Softness`, how they answer.
/// Beyond the notes.

#include <ansatz/units.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

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

/// A body while its contacts are solved: two halves of four numbers, each of which is read and written as a whole where
/// bodies are many.
template <class S>
struct alignas(std::is_floating_point_v<typename S::Scalar> ? 4 * sizeof(typename S::Scalar)
                                                            : alignof(typename S::Scalar)) SolverBody {
    using Scalar = typename S::Scalar;
    using Raw = Vector<Scalar, S::dimension>; ///< raw SI
    using Half = Eigen::Array<Scalar, 4, 1>;  ///< a vector, and what stands beside it
    struct Nothing {};                        ///< where no number is needed

    Raw u;           ///< the mean velocity over the substep, m/s
    Scalar weight{}; ///< 1/m, 1/kg; zero for what is not moved
    [[no_unique_address]] std::conditional_t<S::dimension == 2, Scalar, Nothing> beside_weight{}; ///< zero
    Raw position;                                                                                 ///< where it is, m
    std::array<Scalar, 4 - S::dimension> beside{};                                                ///< zero

    /// \param going what `u` is, m/s
    /// \param at    what `position` is, m
    /// \param w     what `weight` is, 1/kg
    SolverBody(const Raw& going, const Raw& at, Scalar w) : u(going), weight(w), position(at) {}

    /// The velocity, and beside it the weight.
    [[gnu::always_inline]] Half moving() const { return half(0, u, weight); }
    /// The position.
    [[gnu::always_inline]] Half standing() const { return half(1, position, beside[0]); }
    /// Sets the velocity, and beside it the weight.
    [[gnu::always_inline]] void move(const Half& to) {
        if constexpr (whole) std::memcpy(static_cast<void*>(this), to.data(), sizeof to);
        else
            for (int k = 0; k < S::dimension; ++k) u[k] = to[k];
    }
    /// A vector in this form, with zero beside it.
    static Half half_of(const Raw& vector) {
        Half made = Half::Zero();
        for (int k = 0; k < S::dimension; ++k) made[k] = vector[k];
        return made;
    }

private:
    static constexpr bool whole = std::is_floating_point_v<Scalar>; // other numbers are copied one by one

    [[gnu::always_inline]] Half half(std::size_t which, const Raw& vector, const Scalar& beside_it) const {
        Half made;
        if constexpr (whole) {
            static_assert(sizeof(SolverBody) == 2 * sizeof made);
            std::memcpy(made.data(), reinterpret_cast<const std::byte*>(this) + which * sizeof made, sizeof made);
        } else {
            made = half_of(vector);
            made[S::dimension] = beside_it;
        }
        return made;
    }
};

namespace detail {
/// The slots of bodies that may move.
struct Movers {
    std::size_t awake = 0;                  ///< how many are; they come first
    std::size_t moving = 0, moving_end = 0; ///< the platforms
};
} // namespace detail

} // namespace ansatz
