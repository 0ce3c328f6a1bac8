// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Xpbd`: constraints held on positions, one after the other, in substeps (notes 4).
///
/// Use it for cloth, ropes and bodies that are stiff and need not be exact: it never explodes, whatever the stiffness
/// and the step, and costs the same in every step. Every spring of the world is a constraint then and no force; gravity
/// and drag stay forces. Take substeps rather than iterations: at equal cost the error falls with their number, or its
/// square. What it costs: a body is softer than its springs say unless \f$ h^2 k / m \f$ is small, and it loses energy
/// that nobody damped. Where a spring is to be what Hooke says, take an explicit integrator in steps below
/// `stable_step`, or ImplicitEuler.
///
/// Each constraint C with stiffness k and damping c is solved for what its multiplier \f$ \lambda \f$, a force times
/// \f$ h^2 \f$, must be at the end of the substep, the others being as they are:
///
/// \f[ \Delta\lambda = -\frac{\lambda + K\,C + D\,\nabla C\cdot\Delta\mathbf x}{1 + (K + D)\sum_i w_i\,|\nabla_i C|^2},
///     \qquad \Delta\mathbf x_i = w_i\,\nabla_i C\,\Delta\lambda, \qquad K = h^2 k, \quad D = h\,c \f]
///
/// That is Macklin's formula multiplied by K, so that a stiffness of zero is a mere damper and nothing is divided by
/// it. Of one spring alone it is implicit Euler, exactly where the force is linear.
///
/// | symbol | meaning                                   | unit |
/// |--------|-------------------------------------------|------|
/// | h      | length of a substep                       | s    |
/// | w      | 1/m of a body, 0 of one that is not moved | 1/kg |
/// | Delta x | the way since the substep began, h v      | m    |
///
/// M. Macklin, M. Mueller, N. Chentanez, XPBD, MIG 2016; M. Macklin et al., Small Steps in Physics Simulation, SCA
/// 2019.

#include <ansatz/core/error.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/module.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace ansatz {

/// Extended position based dynamics.
struct Xpbd {
    using role = roles::Solver;

    /// Number of substeps of a step; in each, forces are computed, bodies moved and constraints held
    int substeps = 10;
    /// Number of sweeps over all constraints in a substep
    int iterations = 1;

    static constexpr std::string_view name = "Xpbd";
    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) {
        visit("substeps", self.substeps);
        visit("iterations", self.iterations);
    }
    /// Refuses fewer than one of them.
    void check() const {
        if (substeps < 1) refuse_value(name, "substeps", substeps, "it is at least 1");
        if (iterations < 1) refuse_value(name, "iterations", iterations, "it is at least 1");
    }

    /// Bound to a space.
    template <class S> class In {
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        struct Room {
            std::vector<Scalar> multipliers; // of each constraint
            std::vector<Vec> gradients;      // of a wide one, by each of its bodies
        };

    public:
        /// What it keeps between steps: room.
        template <class> using Kept = Room;

        /// Takes the parameters.
        explicit In(const Xpbd& xpbd) : iterations_(xpbd.iterations) {}

        /// Holds all constraints behind one substep.
        void solve(auto& system, Room& room) const {
            room.multipliers.clear();
            if (iterations_ == 1) return sweep<Sweep::only>(system, room);
            sweep<Sweep::first>(system, room);
            for (int i = 1; i < iterations_; ++i) sweep<Sweep::later>(system, room);
        }

        /// Holds one constraint.
        /// \param multiplier lambda so far, N s^2
        /// \return lambda now
        template <class K>
        [[gnu::always_inline]] static Scalar hold_one(auto& system, Room& room, const K& k, Scalar multiplier) {
            if constexpr (WideConstraintIn<K, S>) return hold_wide(system, room.gradients, k, multiplier);
            else return hold(system, k, multiplier);
        }

    private:
        /// Whether a constraint says that its gradients have the length 1: they are not waited for then.
        template <class K> static constexpr bool unit_gradients = requires { requires K::unit_gradients; };

        /// Which of a substep's sweeps: the multipliers of a single one are not kept.
        enum class Sweep { only, first, later };

        /// Holds each constraint once. Flattened, and a function of its own, so that it is compiled in a file with
        /// several worlds as in a file with one.
        template <Sweep Which> [[gnu::noinline, gnu::flatten]] static void sweep(auto& system, Room& room) {
            [[maybe_unused]] std::size_t next = 0;
            system.each([&](const auto& constraint) {
                if constexpr (Which == Sweep::only) hold_one(system, room, constraint, Scalar(0));
                else if constexpr (Which == Sweep::first)
                    room.multipliers.push_back(hold_one(system, room, constraint, Scalar(0)));
                else {
                    auto& multiplier = room.multipliers[next++];
                    multiplier = hold_one(system, room, constraint, multiplier);
                }
            });
        }
        template <class K> [[gnu::always_inline]] static Scalar hold(auto& system, const K& k, Scalar multiplier) {
            static_assert(ConstraintIn<K, S>,
                          "Ansatz: what `constraints` gives is no constraint; it needs `bodies`, `slots`, `stiffness`, "
                          "`damping`, `one_sided` and `Scalar linearise(x, gradient) const`, as SpringConstraint has");
            std::array<Vec, K::bodies> x, gradient;
            std::array<Scalar, K::bodies> weight;
            for (std::size_t i = 0; i < K::bodies; ++i) {
                x[i] = system.position(k.slots[i]);
                weight[i] = system.weight(k.slots[i]);
            }
            const Scalar value = k.linearise(x, gradient), h = system.h();
            Scalar compliance(0), way = gradient[0].dot(system.velocity(k.slots[0]));
            for (std::size_t i = 0; i < K::bodies; ++i) {
                if constexpr (unit_gradients<K>) compliance += weight[i];
                else compliance += weight[i] * gradient[i].squaredNorm();
                if (i > 0) way += gradient[i].dot(system.velocity(k.slots[i]));
            }
            const Scalar by_value = h * h * k.stiffness, by_rate = h * k.damping;
            // The next constraint waits for this number: of a multiplier that is still zero nothing is left behind the
            // quotient, where `multiplier - quotient` would be one more thing to wait for.
            const Scalar held = 0 - multiplier;
            Scalar next =
                (held - by_value * value - by_rate * (h * way)) / (1 + (by_value + by_rate) * compliance) - held;
            if constexpr (K::one_sided)
                if (next > Scalar(0) || (multiplier == Scalar(0) && !(value > Scalar(0)))) next = Scalar(0);
            const Scalar change = next - multiplier;
            for (std::size_t i = 0; i < K::bodies; ++i) system.move(k.slots[i], weight[i] * change * gradient[i]);
            return next;
        }
        /// The same for one of many bodies, all of which move by the gradients of where they were.
        template <class K>
        static Scalar hold_wide(auto& system, std::vector<Vec>& gradient, const K& k, Scalar multiplier) {
            const std::size_t n = k.count();
            if (gradient.size() < n) gradient.resize(n);
            const auto at = [&](std::size_t slot) -> Vec { return system.position(slot); };
            const Scalar value = k.linearise(at, std::span<Vec>(gradient).first(n)), h = system.h();
            Scalar compliance(0), way(0);
            for (std::size_t i = 0; i < n; ++i) {
                compliance += system.weight(k.slot(i)) * gradient[i].squaredNorm();
                way += gradient[i].dot(system.velocity(k.slot(i)));
            }
            const Scalar by_value = h * h * k.stiffness, by_rate = h * k.damping;
            const Scalar change =
                -(multiplier + by_value * value + by_rate * (h * way)) / (1 + (by_value + by_rate) * compliance);
            for (std::size_t i = 0; i < n; ++i) system.move(k.slot(i), system.weight(k.slot(i)) * change * gradient[i]);
            return multiplier + change;
        }

        int iterations_;
    };
};

} // namespace ansatz
