// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Buoyancy`: water carries bodies, and bodies press water up (notes 7.4).
///
/// Use it beside `Pools` and `Gravity`, and add a `Floating` for each body that water shall carry. What it does to one
/// in a pool:
///
/// \f[ \mathbf F = \rho g V \,(-\partial_x \eta,\; 1,\; -\partial_z \eta) - \rho \left(\tfrac12 C A |\mathbf w| + \gamma V\right) \mathbf w, \qquad \mathbf w = \mathbf v - \mathbf u \f]
///
/// | symbol  | meaning                                                              | unit          |
/// |---------|----------------------------------------------------------------------|---------------|
/// | V       | volume under the water line, exact for spheres and upright boxes     | m^3           |
/// | eta     | level of the water in the ring around the body (ring.hpp)            | m             |
/// | rho, g  | density of the pool, downward part of the world's gravity            | kg/m^3, m/s^2 |
/// | u       | how the water flows there, along x and z by its policy, and its rise | m/s           |
/// | C, A    | drag of the body, and its section across w, by the part under water  | 1, m^2        |
/// | gamma   | damping, of the mass of water displaced                              | 1/s           |
///
/// The push stands on the surface, so that a body slides down a wave. What a body displaces rises in its ring, and is
/// taken away where it leaves: so the volume of water is kept, the level rises by m/(rho A) under what floats, and what
/// moves makes waves. A body that is fixed or moves by itself displaces, too. Drag is not given to the water's flow.
///
/// The level is the mean of the ring. There is no added mass, so that a body bobs a little faster than a real one, and
/// boxes stay upright. A body lies in the water as on a spring of rho g A, so that a step much longer than
/// sqrt(m / (rho g A)) gives light things energy: `stable_step` knows it, and StepLimit holds to it. Without drag a
/// body that waves push aside goes on, and may leave a pool that has no walls of bodies. The surface that a step begins
/// with acts during all its stages. A drag that would turn a body round within a step only stops it against the water.

#include <ansatz/motion/roles.hpp>
#include <ansatz/water/floating.hpp>
#include <ansatz/water/roles.hpp>

#include <Eigen/Core>

#include <string_view>

namespace ansatz {

/// The force of water on bodies; it needs Pools and Gravity in the world.
struct Buoyancy {
    using role = roles::Buoyancy;
    using Element = Floating; ///< what it keeps
    using reads = Columns<Position, Velocity, InverseMass>;
    static constexpr bool couples_bodies = true; ///< by the water between them

    static constexpr std::string_view name = "Buoyancy"; ///< in a saved file
    static void parameters(auto&, auto&&) {}

    /// The floating bodies of a world.
    template <class S> using State = detail::FloatingTable<S>;

    template <class S> struct In {
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        using Row = detail::FloatingRow<S>;
        explicit In(const Buoyancy&) {}

        /// The forces on all bodies that float.
        void couple(auto& view, const auto& context) const {
            const Scalar dt = context.dt().value();
            each(view, [&](std::size_t slot, const Row& row, const Vec& x, const Vec& w, const Scalar& inverse_mass) {
                const auto now = row.settled(row.beside.level - x[1], inverse_mass);
                Vec force = row.lift(now);
                force += row.against(resistance(row, now, w, inverse_mass, dt), w);
                view.add_force(slot, S::Force::from_value(force));
            });
        }
        /// How the force changes with position and velocity, for integrators that solve.
        /// \param add called with the slot of the body, `view.size()`, and the matrices in N/m and N s/m
        void jacobian(const auto& view, const auto& context, auto&& add) const {
            using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
            const Scalar dt = context.dt().value();
            each(view, [&](std::size_t slot, const Row& row, const Vec& x, const Vec& w, const Scalar& inverse_mass) {
                const auto now = row.settled(row.beside.level - x[1], inverse_mass);
                Matrix by_position = Matrix::Zero();
                by_position(1, 1) = -row.stiffness(now);
                Matrix by_velocity = Matrix::Zero();
                const Scalar c = resistance(row, now, w, inverse_mass, dt);
                for (int k = 0; k < S::dimension; ++k)
                    if (row.shaped() || k == 1) by_velocity(k, k) = -c; // as FloatingRow::against
                add(slot, view.size(), by_position, by_velocity);
            });
        }
        /// How stiff the water can hold each body, however deep it comes to lie, and how damped as it moves now. A ball
        /// in the air over a pool meets in one step what `stable_step` has to know before it.
        /// \param f called with the slot of the body, `view.size()`, N/m and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each(view, [&](std::size_t slot, const Row& row, const Vec& x, const Vec& w, const Scalar& inverse_mass) {
                const auto now = row.settled(row.beside.level - x[1], inverse_mass);
                f(slot, view.size(), row.largest_stiffness(inverse_mass), row.resistance(now, w));
            });
        }

    private:
        /// c of the drag, kg/s: no more than takes all of w in a step. Force and Jacobian have the same one, so that
        /// Newton's method meets the equation which it solves.
        static Scalar resistance(const Row& row, const auto& now, const Vec& w, const Scalar& inverse_mass,
                                 const Scalar& dt) {
            const Scalar c = row.resistance(now, w);
            const Scalar stops = c * inverse_mass * dt; // the fraction of w that the drag takes in a step
            return stops > Scalar(1) ? c / stops : c;
        }
        template <class F> static void each(const auto& view, F&& f) {
            view.state().for_each([&](std::uint32_t, const Row& row) {
                if (!row.beside.wet) return;
                const auto slot = std::size_t(view.slot(row.body));
                const Vec x = view.template get<Position>(slot).value();
                const Vec w = view.template get<Velocity>(slot).value() - row.flow(x[1]);
                f(slot, row, x, w, view.template get<InverseMass>(slot).value());
            });
        }
    };
};

} // namespace ansatz
