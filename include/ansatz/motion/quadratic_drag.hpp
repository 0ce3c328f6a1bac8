// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `QuadraticDrag`: the resistance of air or water, against the motion and with the square of the speed (beyond
/// notes 1.7).
///
/// Use it where a terminal speed matters: a falling body approaches \f$ \sqrt{m g / k} \f$. It is a force, so it needs
/// masses, and an explicit integrator is stable only while 2 k |v| dt / m stays below about 2. For a cheap fade-out
/// take drag.hpp.
///
/// | symbol | meaning                              | unit   |
/// |--------|--------------------------------------|--------|
/// | k      | coefficient, 1/2 rho C_d A           | kg/m   |
/// | v      | velocity of the body in the still air| m/s    |

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \mathbf F = -k\,|\mathbf v|\,\mathbf v \f$
struct QuadraticDrag {
    using role = roles::Force;
    using reads = Columns<Velocity>;

    /// k in kg/m, finite, not negative; zero is no drag, to the bit, while the square of the speed can be held
    Parameter<unit::QuadraticDrag> coefficient = 0.1 * kilogram_per_metre;

    /// From the density of the fluid, the drag coefficient of the shape (a sphere: about 0.47) and its frontal area.
    static QuadraticDrag of(Parameter<unit::Density> density, double drag_coefficient, Parameter<unit::Area> area) {
        return {0.5 * drag_coefficient * density * area};
    }
    /// The one that lets a mass fall no faster than `speed` under gravity `g`.
    static QuadraticDrag with_terminal_speed(Parameter<unit::Velocity> speed, Parameter<unit::Mass> m,
                                             Parameter<unit::Acceleration> g) {
        return {m * g / (speed * speed)};
    }

    static constexpr std::string_view name = "QuadraticDrag";
    static void parameters(auto& self, auto&& visit) { visit("coefficient", self.coefficient); }
    void check() const { require_not_negative("QuadraticDrag", "coefficient", coefficient); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::QuadraticDrag> k;
        explicit In(const QuadraticDrag& drag) : k(S::convert(drag.coefficient)) {}

        [[gnu::always_inline]] typename S::Force force(const typename S::Velocity& v, const auto&) const {
            return -(k * norm(v)) * v;
        }

        /// dF/dv = -k (|v| 1 + v v^T / |v|), which goes to zero with v.
        ForceJacobian<S> jacobian(const typename S::Velocity& v, const auto&) const {
            ForceJacobian<S> j{};
            const auto speed = norm(v).value();
            if (!(speed > 0)) return j;
            const auto& c = v.value();
            auto m = j.velocity.value();
            for (int row = 0; row < S::dimension; ++row)
                for (int column = 0; column < S::dimension; ++column)
                    m(row, column) =
                        -k.value() * ((row == column ? speed : typename S::Scalar(0)) + c[row] * c[column] / speed);
            j.velocity = decltype(j.velocity)::from_value(m);
            return j;
        }
    };
};

} // namespace ansatz
