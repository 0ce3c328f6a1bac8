// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `StrainLimit`: no spring is stretched by more than a fraction of its length, whatever pulls (notes 4).
///
/// Use it for cloth: threads give way a little and then hold, where springs go on giving way, so that a sheet hung by
/// two corners is stretched most at these (the "super-elastic effect"). Behind the integrator and a solver, it checks
/// each spring: one that is too long has its ends brought together along its axis, each by its share of the masses, and
/// what they have of velocity away from each other is gone, as at the end of a rope. Several times, to and fro over
/// the springs, until none is too long or `passes` are used up. So it may leave a little; `largest_strain` says how
/// much.
///
/// Momentum is kept, and energy of motion is only taken: a limit that is switched on over a sheet that is stretched
/// pulls it together without giving it any speed. It costs one pass over the springs where none is too long. Not for
/// bodies that should be elastic, nor for rods: it does not hold against being pressed together.
///
/// | parameter | meaning                                                               |
/// |-----------|-----------------------------------------------------------------------|
/// | `most`    | the largest strain, length / rest length - 1; greater than zero        |
/// | `passes`  | passes over the springs in a step, or in a substep                     |
///
/// X. Provot, Deformation Constraints in a Mass-Spring Model to Describe Rigid Cloth Behaviour, Graphics Interface
/// 1995. There only positions are changed, and the velocity follows from what is done to them; here it is stopped.

#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/springs/springs.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace ansatz {

namespace detail {
/// A prefix and the name of a policy, as one name.
template <class Of, char First> struct StrainLimitName {
    static constexpr std::string_view prefix = First == 'S' ? "StrainLimit of " : "strain limit of ";
    static constexpr auto letters = [] {
        std::array<char, prefix.size() + std::string_view(Of::name).size()> all{};
        std::size_t n = 0;
        for (const char c : prefix) all[n++] = c;
        for (const char c : std::string_view(Of::name)) all[n++] = c;
        return all;
    }();
    static constexpr std::string_view name{letters.data(), letters.size()};
};
} // namespace detail

/// A limit of how far springs are stretched.
/// \tparam Of whose springs: `Springs<...>` or `Ropes<...>`, as it stands in the world's list
template <class Of = Springs<>> struct StrainLimit {
    using role = roles::System;

    double most = 0.1; ///< of the strain, finite, greater than zero
    int passes = 40;   ///< at least 1

    static constexpr std::string_view name = detail::StrainLimitName<Of, 'S'>::name; ///< in a saved file
    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) {
        visit("most", self.most);
        visit("passes", self.passes);
    }
    /// Refuses a strain that is not finite or not greater than zero, and fewer than one pass.
    void check() const {
        if (!(most > 0 && most < std::numeric_limits<double>::infinity()))
            refuse_value("StrainLimit", "most", most, "a strain that may be reached is finite and greater than zero");
        if (passes < 1) refuse_value("StrainLimit", "passes", passes, "it is at least 1");
    }

    /// Behind whatever moves bodies.
    template <class S> class Hold {
        using Scalar = typename S::Scalar;
        using Position_ = typename S::Position;
        using Velocity_ = typename S::Velocity;

    public:
        static constexpr Phase phase = phases::positions; ///< behind the integrator
        /// Behind "constraints".
        static constexpr std::string_view name = detail::StrainLimitName<Of, 's'>::name;
        using writes = Columns<Position, Velocity>;
        using reads = Columns<InverseMass>;
        using sees = Types<Of>; ///< the springs

        /// Takes the parameters.
        explicit Hold(const StrainLimit& limit) : most_(Scalar(limit.most)), passes_(limit.passes) {}

        /// Passes over all springs, to and fro.
        void run(auto& view, const auto&) const {
            const auto& springs = view.template table<Of>();
            for (int i = 0; i < passes_; ++i) {
                bool held = false;
                const auto limit = [&](std::uint32_t id, const auto& link) {
                    held = shorten(view, springs, id, link) || held;
                };
                if (i % 2 == 0) springs.for_each(limit);
                else springs.for_each_backwards([&](std::uint32_t id) { limit(id, springs.link(id)); });
                if (!held) return;
            }
        }

    private:
        /// One spring.
        /// \return whether it was too long
        bool shorten(auto& view, const auto& springs, std::uint32_t id, const auto& link) const {
            using Network = std::remove_cvref_t<decltype(springs)>;
            const Scalar limit = link.rest_length * (1 + most_);
            if (!(limit > Scalar(0))) return false;
            const std::size_t a = view.slot_of_id(link.a);
            const bool anchored = link.b == Network::no_body;
            const std::size_t b = anchored ? a : std::size_t(view.slot_of_id(link.b));
            const Position_ xa = view.template get<Position>(a),
                            xb = anchored ? springs.anchor(id) : view.template get<Position>(b);
            const Position_ to = xb - xa;
            const Scalar length = robust_norm(to).value();
            // What rounding leaves of a spring that was brought to its limit is not too long.
            const Scalar rounding = 8 * std::numeric_limits<Scalar>::epsilon();
            if (!(length > limit * (1 + rounding)) || !(length < std::numeric_limits<Scalar>::infinity())) return false;
            const Scalar wa = weight(view, a), wb = anchored ? Scalar(0) : weight(view, b);
            if (!(wa + wb > Scalar(0))) return false;
            const Vector<Scalar, S::dimension> axis = to.value() / length;
            const Velocity_ va = view.template get<Velocity>(a),
                            vb = anchored ? S::template zero_vector<unit::Velocity>() : view.template get<Velocity>(b);
            const Scalar way = (length - limit) / (wa + wb);
            const Scalar apart = std::max(Scalar(0), axis.dot(vb.value() - va.value())) / (wa + wb);
            if (wa > Scalar(0)) move(view, a, xa, va, wa * way * axis, wa * apart * axis);
            if (wb > Scalar(0)) move(view, b, xb, vb, -wb * way * axis, -wb * apart * axis);
            return true;
        }
        /// 1/m of a body that may be moved.
        static Scalar weight(const auto& view, std::size_t slot) {
            return slot < view.end(Motion::awake) ? view.template get<InverseMass>(slot).value() : Scalar(0);
        }
        using Vec = Vector<Scalar, S::dimension>;
        static void move(auto& view, std::size_t slot, const Position_& x, const Velocity_& v, const Vec& by,
                         const Vec& kick) {
            view.template set<Position>(slot, x + Position_::from_value(by));
            view.template set<Velocity>(slot, v + Velocity_::from_value(kick));
        }

        Scalar most_;
        int passes_;
    };
    template <class S> using systems = Types<Hold<S>>; ///< what it does in a step
};

/// The largest strain of a spring as the bodies are now, length / rest length - 1; those without a rest length do not
/// count, and without any it is 0.
/// \tparam Of whose springs
template <class Of = Springs<>, class World_> typename World_::S::Scalar largest_strain(const World_& world) {
    using S = typename World_::S;
    typename S::Scalar largest(0);
    detail::Bound<Of, S>(world.template get<Of>())
        .tensions(world.template view<Of>(), [&](std::uint32_t, const auto&, const typename S::Scalar& strain) {
            largest = std::max(largest, strain);
        });
    return largest;
}

} // namespace ansatz
