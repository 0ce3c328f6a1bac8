// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ConstraintForce`: all that a policy needs of whose elements each is a constraint of a fixed number of bodies, such
/// as a hinge between two triangles. You write the description, the row that is kept, and the constraint; the rest
/// follows from C and its gradient.
///
/// Without a solver it is a force; implicit integrators get the part of its Jacobian that is never unstable; solvers
/// get the constraints; and it knows its energy and how stiff it is, for `stable_step`:
///
/// \f[ \mathbf F_i = -(k\,C + c\,\dot C)\,\nabla_i C, \qquad
///     \frac{\partial \mathbf F_i}{\partial \mathbf x_j} \approx -k\,\nabla_i C\,\nabla_j C^T, \qquad
///     \frac{\partial \mathbf F_i}{\partial \mathbf v_j} = -c\,\nabla_i C\,\nabla_j C^T \f]
///
/// What is left out is \f$ -k\,C\,\nabla\nabla C \f$: Newton's method arrives at the same state without it. Use it where C does
/// not change when all bodies are moved or turned together; then momentum and angular momentum are kept. Springs do not
/// use it: theirs is the same law, written out for speed (springs/springs.hpp).
///
/// \snippet tests/soft_bodies/constraint_force.cpp corner

#include <ansatz/motion/concepts.hpp>
#include <ansatz/soft_bodies/constraint.hpp>
#include <ansatz/world/element_table.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// Refuses corners of a triangle that are no bodies, or not three different bodies.
inline void check_corners(std::string_view where, const std::array<BodyId, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] == BodyId()) refuse_value(where, "one of its corners", "nobody", "each is a body");
        if (corners[i] == corners[(i + 1) % 3])
            refuse_value(where, "two of its corners", "one body", "they are three different ones");
    }
}
} // namespace detail

/// A table of elements from which something is derived by the slots of their bodies: it knows when that is stale.
template <class S, class E, class Row> class ArrangedTable : public ElementTable<S, E, Row> {
    using Base = ElementTable<S, E, Row>;

public:
    /// \name As ElementTable has them
    /// @{

    /// Adds one.
    typename Base::Handle_ insert(Row row) {
        arranged_ = false;
        return Base::insert(std::move(row));
    }
    /// Another description for one that is there.
    void replace(std::uint32_t id, Row row) {
        arranged_ = false;
        Base::replace(id, std::move(row));
    }
    /// Removes one.
    void erase(std::uint32_t id) {
        arranged_ = false;
        Base::erase(id);
    }
    /// Removes all that name this body.
    void body_removed(std::uint32_t body) {
        arranged_ = false;
        Base::body_removed(body);
    }
    /// @}

protected:
    /// Whether it must be derived anew; from now on it is not.
    /// \param layout changes whenever bodies change their slots
    bool take_stale(std::uint64_t layout) {
        if (arranged_ && layout == layout_) return false;
        arranged_ = true;
        layout_ = layout;
        return true;
    }

private:
    bool arranged_ = false;
    std::uint64_t layout_ = 0;
};

/// Elements that are constraints; behind `arrange` also the constraints, by the slots of their bodies.
/// \tparam Row has `constraint(slot)`, where `slot` answers with the slot of a BodyId
template <class S, class E, class Row> class ConstraintTable : public ArrangedTable<S, E, Row> {
public:
    /// What a row becomes.
    using Constraint = decltype(std::declval<const Row&>().constraint([](BodyId) { return std::size_t(); }));

    /// Makes the constraints anew, if elements or slots changed since.
    /// \param layout changes whenever bodies change their slots
    void arrange(const Bodies& bodies, std::uint64_t layout) {
        if (!this->take_stale(layout)) return;
        constraints_.clear();
        this->for_each([&](std::uint32_t, const Row& row) {
            constraints_.push_back(row.constraint([&](BodyId b) { return std::size_t(bodies.slot_of_id(b.id)); }));
        });
    }
    /// All of them, by id. Behind `arrange`.
    const std::vector<Constraint>& constraints() const { return constraints_; }

private:
    std::vector<Constraint> constraints_;
};

/// What policies of such elements have in common: derive from it, and add a name.
/// \tparam E   the description
/// \tparam Row `Row<S>` is what is kept of one
template <class E, template <class> class Row> struct ConstraintForce {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    static constexpr bool couples_bodies = true;
    using Element = E;                                              ///< what World::add takes for it
    template <class S> using State = ConstraintTable<S, E, Row<S>>; ///< where they are kept

    static void parameters(auto&, auto&&) {}

    /// Bound to a space.
    template <class S> class In {
        using K = typename State<S>::Constraint;
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
        static constexpr std::size_t n = K::bodies;
        using Vecs = std::array<Vec, n>;
        static_assert(
            ConstraintIn<K, S>,
            "Ansatz: what a row's `constraint` gives is no constraint; it needs `bodies`, `slots`, "
            "`stiffness`, `damping`, `one_sided` and `Scalar linearise(x, gradient) const`, as HingeConstraint "
            "has");

    public:
        /// Has no parameters to take.
        explicit In(const ConstraintForce&) {}

        /// The forces of all elements.
        void couple(auto& view, const auto& context) const {
            for (std::size_t k = 0; k < view.state().constraints().size(); ++k) {
                const auto f = forces(view, k, context);
                for (std::size_t i = 0; i < n; ++i) view.add_force(view.state().constraints()[k].slots[i], f[i]);
            }
        }
        /// \name One element by itself, by id
        /// @{
        std::size_t element_count(const auto& view) const { return view.state().constraints().size(); }
        /// The slots of its bodies.
        std::array<std::size_t, n> ends(const auto& view, std::size_t k) const {
            return view.state().constraints()[k].slots;
        }
        /// The forces on them, N.
        std::array<typename S::Force, n> forces(const auto& view, std::size_t k, const auto&) const {
            const K& one = view.state().constraints()[k];
            Vecs gradient;
            const Scalar value = linearise(view, one, gradient);
            Scalar pull = one.stiffness * value;
            if (one.damping > Scalar(0))
                for (std::size_t i = 0; i < n; ++i)
                    pull += one.damping * gradient[i].dot(view.template get<Velocity>(one.slots[i]).value());
            if (K::one_sided && (!(value > Scalar(0)) || !(pull > Scalar(0)))) pull = Scalar(0);
            std::array<typename S::Force, n> f;
            for (std::size_t i = 0; i < n; ++i) f[i] = S::Force::from_value(-pull * gradient[i]);
            return f;
        }
        /// @}

        /// How the forces change with positions and velocities: see above.
        /// \param add called with two slots (the second is `view.size()` for none) and the matrices in N/m and N s/m
        void jacobian(const auto& view, const auto&, auto&& add) const {
            each(view, [&](const K& one, const Vecs& g) {
                Vec before = Vec::Zero();
                for (std::size_t i = 0; i < n; ++i) {
                    for (std::size_t j = i + 1; j < n; ++j) {
                        const Matrix both = g[i] * g[j].transpose();
                        add(one.slots[i], one.slots[j], Matrix(one.stiffness * both), Matrix(one.damping * both));
                    }
                    // What is left on the diagonal: each pair has given its block to both of its bodies.
                    const Matrix turned = own(g, i, before);
                    add(one.slots[i], view.size(), Matrix(one.stiffness * turned), Matrix(one.damping * turned));
                    before += g[i];
                }
            });
        }
        /// How stiff each two bodies are for each other, as they are now.
        /// \param f called with two slots, N/m and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each(view, [&](const K& one, const Vecs& g) {
                for (std::size_t i = 0; i < n; ++i)
                    for (std::size_t j = i + 1; j < n; ++j) {
                        const Scalar both = g[i].norm() * g[j].norm();
                        f(one.slots[i], one.slots[j], Scalar(one.stiffness * both), Scalar(one.damping * both));
                    }
            });
        }
        /// What `constraints` gives.
        using constraint_types = Types<K>;
        /// Every element as what a solver holds, by id.
        void constraints(const auto& view, auto&& f) const {
            for (const K& one : view.state().constraints()) f(one);
        }
        /// \f$ \sum \tfrac12 k C^2 \f$, J.
        typename S::Energy potential_energy(const auto& view) const {
            Scalar sum(0);
            each(view, [&](const K& one, const Vecs&, Scalar value) { sum += one.stiffness * value * value / 2; });
            return S::Energy::from_value(sum);
        }

    private:
        [[gnu::always_inline]] static Scalar linearise(const auto& view, const K& one, Vecs& gradient) {
            Vecs x;
            for (std::size_t i = 0; i < n; ++i) x[i] = view.template get<Position>(one.slots[i]).value();
            return one.linearise(x, gradient);
        }
        /// By id, wherever slots may have changed.
        static void each(const auto& view, auto&& f) {
            view.state().for_each([&](std::uint32_t, const auto& row) {
                const K one = row.constraint([&](BodyId body) { return std::size_t(view.slot(body)); });
                Vecs gradient;
                const Scalar value = linearise(view, one, gradient);
                if (K::one_sided && !(value > Scalar(0))) return;
                if constexpr (requires { f(one, gradient, value); }) f(one, gradient, value);
                else f(one, gradient);
            });
        }
        /// The block on the diagonal, less those that pairs have put there: of a body's own pairs -g_i g_j^T with those
        /// behind it, and of the others' -g_j g_i^T with those in front.
        static Matrix own(const Vecs& g, std::size_t i, const Vec& before) {
            Vec behind = Vec::Zero();
            for (std::size_t j = i + 1; j < n; ++j) behind += g[j];
            return -g[i] * g[i].transpose() - g[i] * behind.transpose() - before * g[i].transpose();
        }
    };
};

} // namespace ansatz
