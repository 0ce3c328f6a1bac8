// SPDX-License-Identifier: BSL-1.0
// A policy outside the library: triangles that keep their area, as a constraint that every solver can hold.
#pragma once

#include <ansatz/world.hpp>

#include <array>
#include <cmath>

namespace examples {

using namespace ansatz;

//! [patches]
template <class S> struct AreaConstraint { // C = |(b - a) x (c - a)| / 2 - area, m^2; a stiffness is in N/m^3
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;
    static constexpr std::size_t bodies = 3;
    static constexpr bool one_sided = false;
    static constexpr bool moves_along = true; // it does not matter where the three are together
    std::array<std::size_t, 3> slots;
    Scalar area, stiffness, damping = 0;

    Scalar linearise(const std::array<Vec, 3>& x, std::array<Vec, 3>& gradient) const {
        const Vec u = x[1] - x[0], v = x[2] - x[0];
        const Scalar uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), twice = std::sqrt(uu * vv - uv * uv);
        gradient[1] = (vv * u - uv * v) / (2 * twice);
        gradient[2] = (uu * v - uv * u) / (2 * twice);
        gradient[0] = -gradient[1] - gradient[2];
        return twice / 2 - area;
    }
    auto curvature(std::size_t, const auto&, const auto&) const { // none that is known: the step is a little longer
        return Eigen::Matrix<Scalar, S::dimension, S::dimension>::Zero().eval();
    }
};

struct Patch { // what world.add takes
    using element = Patch;
    Handle a, b, c;
    double area = 1; // m^2
};
struct Patches {
    using role = roles::Force;
    using reads = Columns<Position>;
    static constexpr bool couples_bodies = true;
    using Element = Patch;
    static constexpr std::string_view name = "Patches";
    double stiffness = 100; // N/m^3
    static void parameters(auto& self, auto&& visit) { visit("stiffness", self.stiffness); }

    struct Row {
        BodyId a, b, c;
        double area = 1;
        static void fields(auto& self, auto&& field) {
            field("a", self.a);
            field("b", self.b);
            field("c", self.c);
            field("area", self.area);
        }
        static Row from(const auto& asked, const Patch& p) {
            return {asked.body(p.a), asked.body(p.b), asked.body(p.c), p.area};
        }
    };
    template <class S> using State = ElementTable<S, Patch, Row>;
    template <class S> struct In {
        using constraint_types = Types<AreaConstraint<S>>;
        typename S::Scalar stiffness;
        explicit In(const Patches& patches) : stiffness(typename S::Scalar(patches.stiffness)) {}
        void constraints(const auto& view, auto&& f) const {
            view.state().for_each([&](std::uint32_t, const Row& p) {
                f(AreaConstraint<S>{
                    {view.slot(p.a), view.slot(p.b), view.slot(p.c)}, typename S::Scalar(p.area), stiffness});
            });
        }
        void couple(auto& view, const auto&) const { // in a world without a solver: minus the energy's slope
            constraints(view, [&](const AreaConstraint<S>& k) {
                std::array<typename AreaConstraint<S>::Vec, 3> x, gradient;
                for (std::size_t i = 0; i < 3; ++i) x[i] = view.template get<Position>(k.slots[i]).value();
                const auto pull = -k.stiffness * k.linearise(x, gradient);
                for (std::size_t i = 0; i < 3; ++i)
                    view.add_force(k.slots[i], S::Force::from_value(pull * gradient[i]));
            });
        }
    };
};
//! [patches]

} // namespace examples
