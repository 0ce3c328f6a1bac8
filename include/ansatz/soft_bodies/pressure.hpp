// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Pressure`: what is in a closed surface presses on it from inside (notes 4).
///
/// Use it for balloons, tyres, cushions, balls whose skin is held up by what is in it: add the policy, then an
/// `Enclosure` of the bodies of a closed mesh. It needs a skin that holds against it, of springs along the edges. Not
/// for bodies that are filled with springs (soft_box.hpp), and not in two dimensions.
///
/// The force on a vertex is the pressure times the gradient of the volume, a third of the area vectors of its
/// triangles. So the forces of a closed surface are none in sum and turn nothing: momentum and angular momentum are
/// kept.
///
/// \f[ V = \frac16 \sum_{abc} (\mathbf x_a - \mathbf x_0) \cdot (\mathbf x_b - \mathbf x_0) \times (\mathbf x_c - \mathbf x_0),
///     \qquad \mathbf F_a = p(V)\,\nabla_a V, \qquad \nabla_a V = \frac16 \sum_{abc} (\mathbf x_b - \mathbf x_a) \times
///     (\mathbf x_c - \mathbf x_a) \f]
///
/// The law p(V) is that of `Filling`. It is a force, or a constraint where the world has a Solver: in each substep the
/// filling is then the spring that it is at the volume where the forces would take it. An implicit integrator gets the
/// part of the Jacobian that is never unstable, \f$ -p'(V)\,\nabla V\,\nabla V^T \f$: all vertices act on each other, so that
/// its system has the square of their number in blocks; that is for small surfaces, and Xpbd for large ones.
///
/// An enclosure is gone with any of its bodies, since its surface is open then.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/soft_bodies/enclosure.hpp>
#include <ansatz/world/world.hpp>

#include <Eigen/Core>

namespace ansatz {

/// The enclosures of a world; behind `arrange` also the slots of their bodies.
template <class S> class EnclosureTable : public ArrangedTable<S, Enclosure, EnclosureRow<S>> {
public:
    /// Finds the slots anew, if enclosures or slots changed since.
    /// \param layout changes whenever bodies change their slots
    void arrange(const Bodies& bodies, std::uint64_t layout) {
        if (!this->take_stale(layout)) return;
        slots_.clear();
        first_.clear();
        this->for_each([&](std::uint32_t, const EnclosureRow<S>& row) {
            first_.push_back(slots_.size());
            for (const BodyId& body : row.bodies) slots_.push_back(bodies.slot_of_id(body.id));
        });
    }
    /// Calls `f(row, slots)` for each, by id. Behind `arrange`.
    template <class F> void for_each_arranged(F&& f) const {
        std::size_t next = 0;
        this->for_each([&](std::uint32_t, const EnclosureRow<S>& row) {
            f(row, std::span<const std::size_t>(slots_).subspan(first_[next++], row.bodies.size()));
        });
    }

private:
    std::vector<std::size_t> slots_, first_;
};

/// The volume of an enclosure as a constraint, in numbers of SI: \f$ C = V - V_p \f$, where V_p is the volume at which the
/// tangent of the filling's law presses no more. Lives as long as a substep.
template <class S> struct PressureConstraint {
    using Scalar = typename S::Scalar;
    const EnclosureRow<S>* row;               ///< the surface
    std::span<const std::size_t> slots;       ///< of its vertices
    Scalar wanted;                            ///< V_p, m^3
    Scalar stiffness;                         ///< -dp/dV, Pa/m^3
    Scalar damping;                           ///< eta / V_0, Pa s/m^3
    static constexpr bool moves_along = true; ///< unchanged where all its bodies are moved by the same way

    /// How many bodies it holds.
    std::size_t count() const { return slots.size(); }
    /// Where they are.
    std::size_t slot(std::size_t i) const { return slots[i]; }
    /// C, m^3, and its gradient.
    Scalar linearise(const auto& at, std::span<Vector<Scalar, 3>> gradient) const {
        const auto vertex = [&](std::size_t i) -> decltype(auto) { return at(slots[i]); };
        row->gradients(vertex, 0, gradient);
        return row->volume_at(vertex) - wanted;
    }
};

/// Closed surfaces under pressure.
struct Pressure {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    static constexpr bool couples_bodies = true;
    using Element = Enclosure;                           ///< what World::add takes for it
    template <class S> using State = EnclosureTable<S>;  ///< where they are kept
    static constexpr std::string_view name = "Pressure"; ///< in a saved file

    static void parameters(auto&, auto&&) {}

    /// Bound to a space.
    template <class S> class In {
        static_assert(S::dimension == 3,
                      "Ansatz: Pressure needs a volume, so a world of three dimensions; leave it out "
                      "of one of two");
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
        using Row = EnclosureRow<S>;

    public:
        explicit In(const Pressure&) {}

        /// The forces of all fillings.
        void couple(auto& view, const auto&) const {
            view.state().for_each_arranged([&](const Row& row, std::span<const std::size_t> slots) {
                const auto at = [&](std::size_t i) { return view.template get<Position>(slots[i]).value(); };
                Scalar p = row.law().excess(row.volume_at(at));
                if (row.damping.value() > Scalar(0))
                    p -= row.damping.value() * rate(view, row, at) / row.volume.value();
                row.each_triangle(at, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec& twice) {
                    const auto f = S::Force::from_value(p / 6 * twice);
                    view.add_force(slots[a], f);
                    view.add_force(slots[b], f);
                    view.add_force(slots[c], f);
                });
            });
        }
        /// How the forces change with positions and velocities, without what the turning of the triangles does.
        /// \param add called with two slots (the second is `view.size()` for none) and the matrices in N/m and N s/m
        void jacobian(const auto& view, const auto&, auto&& add) const {
            each(view, [&](const Row& row, const auto& at, const auto& slot) {
                const Scalar k = row.law().slope(row.volume_at(at)), c = row.damping.value() / row.volume.value();
                Vec before = Vec::Zero(); // the sum of the gradients of those in front
                each_pair(row, at, [&](std::size_t i, const Vec& gi, std::size_t j, const Vec& gj) {
                    const Matrix both = gi * gj.transpose();
                    add(slot(i), slot(j), Matrix(k * both), Matrix(c * both));
                });
                // What is left on the diagonal: each pair above has given its block to both of its bodies.
                each_gradient(row, at, [&](std::size_t i, const Vec& g) {
                    const Matrix turned = g * before.transpose() - before * g.transpose();
                    if (i > 0) add(slot(i), view.size(), Matrix(k * turned), Matrix(c * turned));
                    before += g;
                });
            });
        }
        /// How stiff each two vertices are for each other, as the surface is now.
        /// \param f called with two slots, N/m and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each(view, [&](const Row& row, const auto& at, const auto& slot) {
                const Scalar k = row.law().slope(row.volume_at(at)), c = row.damping.value() / row.volume.value();
                each_pair(row, at, [&](std::size_t i, const Vec& gi, std::size_t j, const Vec& gj) {
                    const Scalar both = gi.norm() * gj.norm();
                    f(slot(i), slot(j), Scalar(k * both), Scalar(c * both));
                });
            });
        }
        /// What `constraints` gives.
        using constraint_types = Types<PressureConstraint<S>>;
        /// Every filling as what a solver of positions holds.
        void constraints(const auto& view, auto&& f) const {
            view.state().for_each_arranged([&](const Row& row, std::span<const std::size_t> slots) {
                const auto law = row.law();
                const Scalar v =
                    row.volume_at([&](std::size_t i) { return view.template get<Position>(slots[i]).value(); });
                const Scalar k = law.slope(v);
                f(PressureConstraint<S>{&row, slots, v + law.excess(v) / k, k,
                                        row.damping.value() / row.volume.value()});
            });
        }
        /// J, zero at V_0.
        typename S::Energy potential_energy(const auto& view) const {
            Scalar sum(0);
            each(view,
                 [&](const Row& row, const auto& at, const auto&) { sum += row.law().energy(row.volume_at(at)); });
            return S::Energy::from_value(sum);
        }

    private:
        /// By id, wherever slots may have changed.
        static void each(const auto& view, auto&& f) {
            view.state().for_each([&](std::uint32_t, const Row& row) {
                const auto slot = [&](std::size_t i) { return std::size_t(view.slot(row.bodies[i])); };
                f(
                    row, [&](std::size_t i) { return view.template get<Position>(slot(i)).value(); }, slot);
            });
        }
        /// dV/dt, m^3/s.
        static Scalar rate(const auto& view, const Row& row, const auto& at) {
            Scalar sum(0);
            const auto v = [&](std::uint32_t i) {
                return view.template get<Velocity>(std::size_t(view.slot(row.bodies[i]))).value();
            };
            const Vec with = v(0); // all move with one of them: what is left changes the volume
            row.each_triangle(at, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec& twice) {
                sum += twice.dot((v(a) - with) + (v(b) - with) + (v(c) - with));
            });
            return sum / 6;
        }
        /// Gradients are made for this many vertices at a time, so that none of them needs room in the world.
        static constexpr std::size_t at_a_time = 64;
        using Some = std::array<Vec, at_a_time>;
        static void each_gradient(const Row& row, const auto& at, auto&& f) {
            Some some;
            const std::size_t n = row.bodies.size();
            for (std::size_t i = 0; i < n; i += at_a_time) {
                const auto these = std::span(some).first(std::min(at_a_time, n - i));
                row.gradients(at, i, these);
                for (std::size_t k = 0; k < these.size(); ++k) f(i + k, these[k]);
            }
        }
        static void each_pair(const Row& row, const auto& at, auto&& f) {
            Some near, far;
            const std::size_t n = row.bodies.size();
            for (std::size_t i = 0; i < n; i += at_a_time) {
                const auto these = std::span(near).first(std::min(at_a_time, n - i));
                row.gradients(at, i, these);
                for (std::size_t j = i; j < n; j += at_a_time) {
                    const auto those = std::span(far).first(std::min(at_a_time, n - j));
                    row.gradients(at, j, those);
                    for (std::size_t a = 0; a < these.size(); ++a)
                        for (std::size_t b = i == j ? a + 1 : 0; b < those.size(); ++b)
                            f(i + a, these[a], j + b, those[b]);
                }
            }
        }
    };
};

/// The volume of an enclosure as its bodies are now, m^3.
/// \throws std::out_of_range for a stale handle
template <class... P> auto enclosed_volume(const World<P...>& world, ElementHandle<Enclosure> which) {
    using S = typename World<P...>::S;
    const auto view = world.template view<Pressure>();
    const auto& row = view.state().row(view.state().id(which, "enclosed_volume"));
    return S::template ScalarOf<unit::Volume>::from_value(
        row.volume_at([&](std::size_t i) { return view.template get<Position>(view.slot(row.bodies[i])).value(); }));
}
/// By how much more its filling presses on the surface than what is around it, Pa, without the damping.
/// \throws std::out_of_range for a stale handle
template <class... P> auto excess_pressure(const World<P...>& world, ElementHandle<Enclosure> which) {
    using S = typename World<P...>::S;
    const auto view = world.template view<Pressure>();
    const auto& row = view.state().row(view.state().id(which, "excess_pressure"));
    return S::template ScalarOf<unit::Pressure>::from_value(row.law().excess(enclosed_volume(world, which).value()));
}

} // namespace ansatz
