// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `CoupledSystem`: all bodies of a world as one system of equations, for integrators that advance them together.
///
/// Where forces couple bodies, an integrator that solves (ImplicitEuler, Odeint) cannot take one body at a time. It
/// sees the world as vectors x, v and a, with one row for each component of each body, by the body's id: rows stay
/// where they are while bodies sleep, wake and change slots. Bodies that do not take part (resting, moving, fixed,
/// removed) keep their rows; nothing acts on them.

#include <ansatz/motion/coupling.hpp>

#include <Eigen/Core>

#include <cstdint>

namespace ansatz {

/// \tparam C        the world's composition
/// \tparam Policies its policies
template <class C, class Policies> class CoupledSystem {
public:
    using S = typename C::S; ///< the space
    using Scalar = typename S::Scalar;
    using Block = Eigen::Matrix<Scalar, S::dimension, S::dimension>; ///< how one body acts on another
    static constexpr int dimension = S::dimension;                   ///< rows of a body

    /// The world at the beginning of its step.
    CoupledSystem(WorldData<C>& data, const Policies& policies, const typename C::Laws& laws, const Context<S>& context)
        : data_(data), policies_(policies), laws_(laws), context_(context) {}

    /// Bodies that have rows.
    Eigen::Index bodies() const { return Eigen::Index(data_.bodies.ids()); }
    /// Rows.
    Eigen::Index rows() const { return bodies() * dimension; }

    /// Positions in m, velocities in m/s, and masses in kg, zero for those that nothing moves.
    /// \tparam Column a number for each row: one of Eigen's vectors, or a GrowingColumn
    template <class Column> void read(Column& x, Column& v, Column& mass) const {
        x.setZero(rows());
        v.setZero(rows());
        mass.setZero(rows());
        each_awake([&](std::size_t slot, Eigen::Index row) {
            const auto m = 1 / data_.lanes.template lane<InverseMass>()[slot];
            for (int k = 0; k < dimension; ++k) {
                x[row + k] = data_.lanes.template lane<Position>(k)[slot];
                v[row + k] = data_.lanes.template lane<Velocity>(k)[slot];
                mass[row + k] = m;
            }
        });
    }
    /// Moves the bodies that take part.
    template <class Column> void write(const Column& x, const Column& v) {
        each_awake([&](std::size_t slot, Eigen::Index row) {
            for (int k = 0; k < dimension; ++k) {
                data_.lanes.template lane<Position>(k)[slot] = x[row + k];
                data_.lanes.template lane<Velocity>(k)[slot] = v[row + k];
            }
        });
    }
    /// What all forces do to the bodies as they stand, `fraction` of the step on; m/s^2, zero for those that nothing
    /// moves.
    template <class Column> void accelerations(double fraction, Column& a) {
        const auto now = context_.later(fraction);
        place_platforms(data_, fraction, context_.dt());
        sum_coupled(data_, policies_, now);
        a.setZero(rows());
        each_awake([&](std::size_t slot, Eigen::Index row) {
            typename S::Acceleration own = laws_.acceleration(data_.load(Bodies::Slot(slot)), now);
            own += data_.lanes.template get<InverseMass>(slot) * data_.lanes.template get<CoupledForce>(slot);
            for (int k = 0; k < dimension; ++k) a[row + k] = own.value()[k];
        });
    }
    /// Calls `f(i, j)` for each two bodies, by their numbers, that a force couples now or may couple without being
    /// added.
    template <class F> void joined(F&& f) const {
        each_coupling([&]<class Q>(const auto& force, const auto& view) {
            force.stiffnesses(view, [&](std::size_t a, std::size_t b, const auto&, const auto&) {
                if (b != view.size()) f(Eigen::Index(view.id(a)), Eigen::Index(view.id(b)));
            });
        });
    }
    /// How the forces change with positions (N/m) and velocities (N s/m), as they stand, `fraction` of the step on.
    /// \param on_itself called with (i, by_position, by_velocity): the force on body i with its own motion
    /// \param on_other  called with (i, j, by_position, by_velocity): the force on i with the motion of j
    template <class F, class G> void jacobians(double fraction, F&& on_itself, G&& on_other) const {
        const auto both = [&](Eigen::Index i, Eigen::Index j, const Block& by_x, const Block& by_v) {
            on_itself(i, by_x, by_v);
            on_itself(j, by_x, by_v);
            on_other(i, j, -by_x, -by_v);
            on_other(j, i, -by_x.transpose(), -by_v.transpose());
        };
        pair_jacobians(fraction, on_itself, both);
    }
    /// The same, two bodies that take part at once.
    /// \param on_both called with (i, j, by_position, by_velocity): the force on i and on j, each with its own motion;
    ///                that on i with the motion of j is the opposite, that on j with the motion of i its transpose
    template <class F, class G> void pair_jacobians(double fraction, F&& on_itself, G&& on_both) const {
        const auto now = context_.later(fraction);
        const auto awake = data_.bodies.end(Motion::awake);
        each_coupling([&]<class Q>(const auto& force, const auto& view) {
            force.jacobian(view, now.template restricted<detail::reads_clock<Q>>(),
                           [&](std::size_t a, std::size_t b, const Block& by_x, const Block& by_v) {
                               if (a < awake && b < awake)
                                   on_both(Eigen::Index(view.id(a)), Eigen::Index(view.id(b)), by_x, by_v);
                               else if (a < awake) on_itself(Eigen::Index(view.id(a)), by_x, by_v);
                               else if (b < awake) on_itself(Eigen::Index(view.id(b)), by_x, by_v);
                           });
        });
        if constexpr (C::laws::size > 0)
            each_awake([&](std::size_t slot, Eigen::Index row) {
                const auto own = laws_.jacobian(data_.load(Bodies::Slot(slot)), now);
                const Scalar m = 1 / data_.lanes.template lane<InverseMass>()[slot];
                on_itself(row / dimension, Block(m * own.position.value()), Block(m * own.velocity.value()));
            });
    }

private:
    template <class F> void each_awake(F&& f) const {
        for (std::size_t slot = 0; slot < data_.bodies.end(Motion::awake); ++slot)
            f(slot, Eigen::Index(data_.bodies.id(slot)) * dimension);
    }
    template <class F> void each_coupling(F&& f) const {
        [&]<class... Q>(Types<Q...>) {
            (f.template operator()<Q>(detail::Bound<Q, S>(std::get<Q>(policies_)),
                                      ObserverView<S, Q>(std::as_const(data_))),
             ...);
        }(typename C::couplings{});
    }

    WorldData<C>& data_;
    const Policies& policies_;
    const typename C::Laws& laws_;
    const Context<S>& context_;
};

} // namespace ansatz
