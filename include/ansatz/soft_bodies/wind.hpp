// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Wind`: air that blows on triangles, or through which they move (notes 4).
///
/// Use it for flags, sails, parachutes, leaves: add the policy, then a `Sail` for each triangle, or give `Cloth` a
/// `drag` and a `lift`. What counts is how the triangle moves in the air, so that a cloth in still air is slowed, and
/// one that goes with the wind feels none. Wind on points (each body pulled along, however the cloth stands there) is a
/// law of one body, in ten lines (docs/world.md, "A force of your own"); a flag does not flutter in that. Not for air
/// that is moved by what moves in it.
///
/// \f[ \mathbf w = \mathbf v_{wind} - \tfrac13 (\mathbf v_a + \mathbf v_b + \mathbf v_c), \qquad u = \mathbf n \cdot \mathbf w, \qquad
///     \mathbf F = \tfrac12 \varrho A \Bigl( c_D\,u\,\mathbf w + c_L\,u\,\bigl(|\mathbf w|\,\mathbf n - u\,\mathbf{\hat
///     w}\bigr) \Bigr) \f]
///
/// | symbol   | meaning                                                                       | unit   |
/// |----------|-------------------------------------------------------------------------------|--------|
/// | w        | the wind as the triangle feels it                                             | m/s    |
/// | n        | its normal, on the side to which the wind goes, so that u is not negative     | 1      |
/// | A        | its area                                                                      | m^2    |
/// | rho      | `density` of the air                                                          | kg/m^3 |
/// | c_D, c_L | `drag` and `lift` of a Sail: along the wind, and across it                     | 1      |
///
/// Drag is that of the area that faces the wind; lift is across the wind, does no work on the air, and is largest where
/// the triangle stands at 45 degrees to it. Each vertex has a third. A triangle edge-on or without an area feels
/// nothing. Both sides of a sheet are one triangle: do not add it twice.
///
/// It is a force, and stays one beside a Solver, which asks it anew in each substep. Gusts are `world.set(Wind{...})`.
///
/// M. Keckeisen, S. Kimmerle, B. Thomaszewski, M. Wacker, Modelling Effects of Wind Fields in Cloth Animations, WSCG
/// 2004.

#include <ansatz/motion/concepts.hpp>
#include <ansatz/soft_bodies/constraint_force.hpp>
#include <ansatz/world/space.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ansatz {

/// A triangle on which wind blows: what `World::add` takes of a world with `Wind`.
struct Sail {
    using element = Sail;               ///< marks it as one that World::add takes
    std::array<Handle, 3> corners = {}; ///< its bodies
    double drag = 1;                    ///< c_D, finite, not negative; 1.1 to 1.3 of a plate
    double lift = 0;                    ///< c_L, finite, not negative
};

/// What is kept of a sail.
template <class S> struct SailRow {
    using Scalar = typename S::Scalar;
    std::array<BodyId, 3> corners; ///< its bodies
    Scalar drag = 0;               ///< c_D
    Scalar lift = 0;               ///< c_L

    /// Names what it consists of.
    static void fields(auto& self, auto&& field) {
        field("corners", self.corners);
        field("drag", self.drag);
        field("lift", self.lift);
    }
    /// Of a description.
    static SailRow from(const auto& asked, const Sail& sail) {
        SailRow row;
        for (std::size_t i = 0; i < 3; ++i) row.corners[i] = asked.body(sail.corners[i]);
        row.drag = coefficient(asked.where, "drag", sail.drag);
        row.lift = coefficient(asked.where, "lift", sail.lift);
        return row;
    }
    /// What it was made of.
    Sail describe(const auto& handle_of) const {
        return {{handle_of(corners[0]), handle_of(corners[1]), handle_of(corners[2])},
                static_cast<double>(drag),
                static_cast<double>(lift)};
    }
    /// Holds it against what a step relies on, whatever made it: a file, too.
    void check() const {
        detail::check_corners("a sail", corners);
        coefficient("a sail", "drag", drag);
        coefficient("a sail", "lift", lift);
    }
    /// Refuses a coefficient that is not finite or negative.
    template <class Number> static Scalar coefficient(std::string_view where, std::string_view what, const Number& c) {
        return S::convert(what, checked(where, what, Quantity<unit::Dimensionless, Number>::from_value(c))).value();
    }

private:
    template <class Q> static const Q& checked(std::string_view where, std::string_view what, const Q& c) {
        require_not_negative(where, what, c);
        return c;
    }
};

/// The sails of a world; behind `arrange` also by the slots of their corners.
template <class S> class SailTable : public ArrangedTable<S, Sail, SailRow<S>> {
public:
    /// One sail as the loop over all of them wants it.
    struct Set {
        std::array<std::size_t, 3> slots; ///< of its corners
        typename S::Scalar drag;          ///< c_D
        typename S::Scalar lift;          ///< c_L
    };
    /// Finds the slots anew, if sails or slots changed since.
    /// \param layout changes whenever bodies change their slots
    void arrange(const Bodies& bodies, std::uint64_t layout) {
        if (!this->take_stale(layout)) return;
        set_.clear();
        this->for_each([&](std::uint32_t, const SailRow<S>& row) {
            set_.push_back(set_of(row, [&](BodyId body) { return std::size_t(bodies.slot_of_id(body.id)); }));
        });
    }
    /// All of them, by id. Behind `arrange`.
    const std::vector<Set>& set() const { return set_; }
    /// One of them.
    static Set set_of(const SailRow<S>& row, const auto& slot) {
        return {{slot(row.corners[0]), slot(row.corners[1]), slot(row.corners[2])}, row.drag, row.lift};
    }

private:
    std::vector<Set> set_;
};

/// Air around triangles.
struct Wind {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    static constexpr bool couples_bodies = true;
    using Element = Sail;                            ///< what World::add takes for it
    template <class S> using State = SailTable<S>;   ///< where they are kept
    static constexpr std::string_view name = "Wind"; ///< in a saved file

    VectorParameter<unit::Velocity> velocity = {};                     ///< of the air, m/s
    Parameter<unit::Density> density = 1.2 * kilogram_per_cubic_metre; ///< of the air, kg/m^3, not negative

    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) {
        visit("velocity", self.velocity);
        visit("density", self.density);
    }
    /// \throws std::invalid_argument for what is not finite, and for a negative density
    void check() const {
        require_finite(name, "velocity", velocity);
        require_not_negative(name, "density", density);
    }

    /// Bound to a space.
    template <class S> class In {
        static_assert(S::dimension == 3,
                      "Ansatz: Wind blows on triangles, so in a world of three dimensions; leave it out "
                      "of one of two");
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
        using Set = typename SailTable<S>::Set;

    public:
        explicit In(const Wind& wind)
            : velocity_(S::convert("Wind::velocity", wind.velocity).value()),
              quarter_density_(S::convert("Wind::density", wind.density).value() / 4) {}

        /// The forces on all sails.
        void couple(auto& view, const auto& context) const {
            for (std::size_t k = 0; k < view.state().set().size(); ++k) {
                const auto f = forces(view, k, context);
                for (std::size_t i = 0; i < 3; ++i) view.add_force(view.state().set()[k].slots[i], f[i]);
            }
        }
        /// \name One sail by itself, by id
        /// @{
        std::size_t element_count(const auto& view) const { return view.state().set().size(); }
        /// The slots of its corners.
        std::array<std::size_t, 3> ends(const auto& view, std::size_t k) const { return view.state().set()[k].slots; }
        /// The forces on them, N.
        std::array<typename S::Force, 3> forces(const auto& view, std::size_t k, const auto&) const {
            const Set& sail = view.state().set()[k];
            const Felt felt = feels(view, sail);
            Vec f = Vec::Zero();
            if (felt.speed > Scalar(0)) {
                // Twice the area, and half of that for the density's half.
                f = (quarter_density_ * felt.faces * sail.drag) * felt.wind;
                if (sail.lift > Scalar(0))
                    f += (quarter_density_ * felt.faces * sail.lift) *
                         (felt.speed * felt.normal - (felt.across / felt.speed) * felt.wind);
            }
            const auto third = S::Force::from_value(f / 3);
            return {third, third, third};
        }
        /// @}

        /// How the drag changes with velocities, each corner by itself, exact where the wind comes from the front; what
        /// lift and the turning of the triangles change is left out, and Newton's method arrives without it.
        /// \param add called with a slot, `view.size()`, and the matrices in N/m and N s/m
        void jacobian(const auto& view, const auto&, auto&& add) const {
            each(view, [&](const Set& sail, const Felt& felt) {
                if (!(felt.speed > Scalar(0))) return;
                const Vec along = felt.wind / felt.speed;
                const Matrix by_velocity =
                    (-quarter_density_ * felt.faces * sail.drag / 3) * (Matrix::Identity() + along * along.transpose());
                for (const std::size_t slot : sail.slots) add(slot, view.size(), Matrix(Matrix::Zero()), by_velocity);
            });
        }
        /// How much each corner is damped, as it moves now.
        /// \param f called with a slot, `view.size()`, 0 and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each(view, [&](const Set& sail, const Felt& felt) {
                // Of drag 2, and of lift no more than that again.
                const Scalar c = quarter_density_ * felt.twice_area * felt.speed * 2 * (sail.drag + sail.lift) / 3;
                for (const std::size_t slot : sail.slots) f(slot, std::size_t(view.size()), Scalar(0), c);
            });
        }

    private:
        struct Felt {
            Vec wind;          // w, m/s
            Vec normal;        // n
            Scalar speed;      // |w|
            Scalar across;     // u = n . w
            Scalar twice_area; // m^2
            Scalar faces;      // 2 A u
        };
        Felt feels(const auto& view, const Set& sail) const {
            using std::sqrt;
            const auto x = [&](std::size_t i) { return view.template get<Position>(sail.slots[i]).value(); };
            const auto v = [&](std::size_t i) { return view.template get<Velocity>(sail.slots[i]).value(); };
            const Vec from = x(0), u = x(1) - from, w = x(2) - from;
            Felt felt{velocity_ - (v(0) + v(1) + v(2)) / 3, u.cross(w), Scalar(0), Scalar(0), Scalar(0), Scalar(0)};
            const Scalar squared = felt.normal.squaredNorm();
            if (!detail::squares_well(squared)) return felt;
            felt.speed = sqrt(felt.wind.squaredNorm());
            felt.twice_area = sqrt(squared);
            felt.normal /= felt.twice_area;
            felt.across = felt.normal.dot(felt.wind);
            if (felt.across < Scalar(0)) {
                felt.normal = -felt.normal;
                felt.across = -felt.across;
            }
            felt.faces = felt.twice_area * felt.across;
            return felt;
        }
        /// By id, wherever slots may have changed.
        void each(const auto& view, auto&& f) const {
            view.state().for_each([&](std::uint32_t, const SailRow<S>& row) {
                const Set sail = SailTable<S>::set_of(row, [&](BodyId body) { return std::size_t(view.slot(body)); });
                f(sail, feels(view, sail));
            });
        }

        Vec velocity_;
        Scalar quarter_density_;
    };
};

} // namespace ansatz
