// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Attraction`: bodies attract each other (Newton's law of gravitation), and so show his third law (notes 1.3, 1.4).
///
/// Use it for a handful of planets, or to see a force that couples bodies: what the first feels, the second feels with
/// the opposite sign, and the momentum of all of them together stays what it was. Every pair is visited, so a
/// thousand bodies are half a million pairs a stage. Near the ground take gravity.hpp. Not provided: a tree or a mesh
/// for many bodies, and a Jacobian, so an implicit integrator refuses it.
///
/// | symbol  | meaning                    | unit         |
/// |---------|----------------------------|--------------|
/// | G       | gravitational constant     | m^3/(kg s^2) |
/// | epsilon | softening length           | m            |

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <string_view>

namespace ansatz {

/// \f$ \mathbf F_{ij} = G\,m_i m_j\,\frac{\mathbf x_j - \mathbf x_i}{(|\mathbf x_j - \mathbf x_i|^2 + \varepsilon^2)^{3/2}} \f$
/// on body i, and its negative on body j. Two bodies in one place do not attract each other.
struct Attraction {
    using role = roles::Force;
    using reads = Columns<Position, InverseMass>;
    static constexpr bool couples_bodies = true;

    /// G, finite, not negative; nature's value unless a game asks for more
    Parameter<unit::GravitationalConstant> constant = 6.6743e-11 * (cubic_metre / (kilogram * second * second));
    /// Keeps the force finite at close encounters; finite, not negative
    Parameter<unit::Length> softening = 0.0 * metre;

    static constexpr std::string_view name = "Attraction";
    static void parameters(auto& self, auto&& visit) {
        visit("constant", self.constant);
        visit("softening", self.softening);
    }
    void check() const {
        require_not_negative("Attraction", "constant", constant);
        require_not_negative("Attraction", "softening", softening);
    }

    template <class S> struct In {
        typename S::template ScalarOf<unit::GravitationalConstant> G;
        typename S::Length softening;
        explicit In(const Attraction& a) : G(S::convert(a.constant)), softening(S::convert(a.softening)) {}

        void couple(auto& view, const auto&) const {
            for_each_pair(view, [&](std::size_t i, std::size_t j, const auto& mi, const auto& mj) {
                const auto to = view.template get<Position>(j) - view.template get<Position>(i);
                const auto distance = norm_softened(to);
                if (!(distance.value() > 0)) return;
                // Mass by mass and distance by distance: the product of two planets' masses is more than a float can
                // hold.
                const auto f = (G * mi / distance) * (mj / distance) * (to / distance).value();
                view.add_force_pair(i, j, f);
            });
        }

        /// \f$ -\sum_{i<j} G m_i m_j / \sqrt{r^2 + \varepsilon^2} \f$
        typename S::Energy potential_energy(const auto& view) const {
            typename S::Energy sum{};
            for_each_pair(view, [&](std::size_t i, std::size_t j, const auto& mi, const auto& mj) {
                const auto distance = norm_softened(view.template get<Position>(j) - view.template get<Position>(i));
                if (distance.value() > 0) sum -= (G * mi / distance) * mj;
            });
            return sum;
        }

    private:
        typename S::Length norm_softened(const typename S::Position& to) const {
            return sqrt(squared_norm(to) + softening * softening);
        }

        /// Pairs by id, so that the sums are the same to the bit whatever was removed before.
        static void for_each_pair(const auto& view, auto&& f) {
            view.for_each([&](std::size_t i) {
                const auto wi = view.template get<InverseMass>(i);
                if (!(wi.value() > 0)) return;
                view.for_each([&](std::size_t j) {
                    if (!(view.id(i) < view.id(j))) return;
                    const auto wj = view.template get<InverseMass>(j);
                    if (wj.value() > 0) f(i, j, typename S::Scalar(1) / wi, typename S::Scalar(1) / wj);
                });
            });
        }
    };
};

} // namespace ansatz
