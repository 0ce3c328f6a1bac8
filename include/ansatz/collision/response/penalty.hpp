// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Penalty`: a damped spring between bodies that intersect, as long as they do (notes 2.2.2, on the springs of notes
/// 3).
///
/// Use it where contacts should be soft, or where an implicit integrator takes them with everything else. The contacts
/// found at the end of a step, and those that may begin in the next one, are springs of that one: their depth and
/// velocity are asked anew at every stage of the integrator, so that each keeps its order, and StepLimit divides the
/// step in which two begin to touch as any other. (Shapes of your own begin at the end of the step in which they come
/// to
/// touch.) The stiffest contact decides the step: \f$ \Delta t < 2/\sqrt{k (w_a + w_b)} \f$ for semi-implicit Euler and
/// without damping; `stable_step(world)` and `StepLimit` know it.
///
/// | symbol | meaning                                               | unit  |
/// |--------|-------------------------------------------------------|-------|
/// | p      | penetration depth                                     | m     |
/// | N      | contact normal, from b to a                           | 1     |
/// | v_N    | N . (v_a - v_b)                                       | m/s   |
/// | k      | stiffness                                             | N/m   |
/// | c      | damping                                               | N s/m |
/// | F      | force on a; on b it is -F                             | N     |
///
/// The notes have F = -kp - c v_N for both bodies. With N from b to a it is **+kp**: p grows while they approach; and
/// Newton's third law gives b the opposite, or two bodies that touch push each other off with momentum from nowhere.
/// And a higher c is *less* bouncy, not more: two that meet separate with
/// \f$ e = e^{-\pi\zeta/\sqrt{1-\zeta^2}} \f$, \f$ \zeta = c / (2\sqrt{k\mu}) \f$. k sets how deep and how long they touch,
/// not how they bounce.

#include <ansatz/collision/box.hpp>
#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/contact_step.hpp>
#include <ansatz/collision/plane.hpp>
#include <ansatz/collision/sphere.hpp>
#include <ansatz/springs/hooke.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// The contacts that act in the next step, or may begin in it.
///
/// Two boxes, two spheres and one of each intersect exactly where one point, a seen from b, lies in one box with
/// rounded edges: as large as both boxes together, rounded by both radii together. So their depth is known wherever the
/// stages of a step take them. What touches a half-space does so along one normal for ever; and so, for the length of a
/// step, do shapes of a user's own.
template <class S> class PenaltyContacts {
public:
    using Scalar = typename S::Scalar;
    /// One of them, by ids; by slots among `pairs()`.
    struct Pair {
        std::uint32_t a;                   ///< a body
        std::uint32_t b;                   ///< the other
        bool flat;                         ///< they touch along `normal`, whatever happens
        Scalar reach;                      ///< m: r_a + r_b; where flat, how far apart along the normal they only touch
        Vector<Scalar, S::dimension> half; ///< m: of both boxes together
        Vector<Scalar, S::dimension> normal; ///< from b to a: where flat, and where their centres coincide
    };

    /// Where and how two of them intersect now: their depth, negative where they do not, with N in `normal`.
    [[gnu::always_inline]] static typename S::Length depth(const Pair& pair, const typename S::Position& between,
                                                           Vector<Scalar, S::dimension>& normal) {
        normal = pair.normal;
        if (pair.flat) return S::Length::from_value(pair.reach) - dot(between, normal);
        auto out = between.value(); // what of it is outside the box that has no rounded edges
        bool outside = false;
        int axis = 0;
        Scalar nearest{}; // face of that box, if it is inside; negative
        for (int k = 0; k < S::dimension; ++k) {
            const Scalar beyond = abs(out[k]) - pair.half[k];
            if (k == 0 || beyond > nearest) axis = k, nearest = beyond;
            outside = outside || beyond > Scalar(0);
            out[k] = beyond > Scalar(0) ? (out[k] < Scalar(0) ? -beyond : beyond) : Scalar(0);
        }
        if (outside) {
            const auto distance = robust_norm(S::Position::from_value(out));
            if (!detail::unit_vector(out, normal)) normal = pair.normal;
            return S::Length::from_value(pair.reach) - distance;
        }
        if (pair.half[axis] > Scalar(0))
            for (int k = 0; k < S::dimension; ++k)
                normal[k] = k != axis ? Scalar(0) : between.value()[k] < Scalar(0) ? Scalar(-1) : Scalar(1);
        return S::Length::from_value(pair.reach - nearest);
    }

    /// The contacts of the state that a step has made, and those that may begin in the next one (depth not greater than
    /// zero).
    template <class Data, class Contacts> void take(const Data& data, const Contacts& contacts) {
        if (contacts_.capacity() < contacts.size())
            contacts_.reserve(std::max(contacts.size(), 2 * contacts_.capacity()));
        contacts_.clear();
        for (const auto& c : contacts) {
            if (data.collisions.is_sensor(c.first.id) || data.collisions.is_sensor(c.second.id)) continue;
            Pair pair{c.first.id, c.second.id, true, Scalar(0), Vector<Scalar, S::dimension>::Zero(), c.normal};
            const bool known = measure(data, pair);
            if (!known && !(c.depth.value() > Scalar(0))) continue;
            if (pair.flat) {
                const auto xa = data.lanes.template get<Position>(data.bodies.slot_of_id(c.first.id)),
                           xb = data.lanes.template get<Position>(data.bodies.slot_of_id(c.second.id));
                pair.reach = (dot(typename S::Position(xa - xb), c.normal) + c.depth).value();
            }
            contacts_.push_back(pair);
        }
        arranged_ = false;
    }
    /// By slots, in the order of the ids: valid behind `arrange`.
    const std::vector<Pair>& pairs() const { return pairs_; }
    /// Calls `f(pair)` for each, by ids.
    template <class F> void each(F&& f) const {
        for (const auto& c : contacts_) f(c);
    }

    /// \name What a world asks of everything that a policy keeps
    /// @{
    /// Makes `pairs()` anew, if contacts or the slots of bodies changed.
    void arrange(const Bodies& bodies, std::uint64_t layout) {
        if (arranged_ && layout == layout_) return;
        pairs_.clear();
        for (auto c : contacts_) {
            c.a = bodies.slot_of_id(c.a);
            c.b = bodies.slot_of_id(c.b);
            pairs_.push_back(c);
        }
        arranged_ = true;
        layout_ = layout;
    }
    /// Nothing to forget.
    void begin_step() {}
    /// Nothing to make room for.
    void reserve_notes() {}
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const PenaltyContacts& other) {
        contacts_.reserve(other.contacts_.size());
        pairs_.reserve(other.pairs_.size());
    }
    /// Its contacts go with it.
    void body_removed(std::uint32_t id) {
        std::erase_if(contacts_, [id](const Pair& c) { return c.a == id || c.b == id; });
        arranged_ = false;
    }
    /// Nothing: contacts follow from where the bodies are.
    void add_to(auto&) const {}
    /// To a file: `f(a, b, numbers)` for each. A loaded world goes on with the very same ones.
    template <class F> void saved(F&& f) const {
        for (const auto& c : contacts_) {
            std::array<Scalar, numbers_each> numbers{Scalar(c.flat), c.reach};
            for (int k = 0; k < S::dimension; ++k)
                numbers[std::size_t(2 + k)] = c.half[k], numbers[std::size_t(2 + S::dimension + k)] = c.normal[k];
            f(c.a, c.b, numbers);
        }
    }
    static constexpr int numbers_each = 2 + 2 * S::dimension; ///< of a contact in a file
    /// What is wrong with the numbers of one from a file, and where; nothing, if it was taken.
    std::optional<std::pair<int, const char*>> load(std::uint32_t a, std::uint32_t b,
                                                    const std::vector<Scalar>& numbers) {
        Pair pair{a, b, numbers[0] == Scalar(1), numbers[1], {}, {}};
        if (!pair.flat && !(numbers[0] == Scalar(0))) return std::pair(0, "0 or 1");
        if (!pair.flat && !(pair.reach >= Scalar(0))) return std::pair(1, "a length that is not negative");
        for (int k = 0; k < S::dimension; ++k) {
            pair.half[k] = numbers[std::size_t(2 + k)];
            pair.normal[k] = numbers[std::size_t(2 + S::dimension + k)];
            if (!(pair.half[k] >= Scalar(0))) return std::pair(2 + k, "a length that is not negative");
        }
        if (!(abs(pair.normal.squaredNorm() - Scalar(1)) < Scalar(0.001)))
            return std::pair(2 + S::dimension, "the first number of a unit vector");
        contacts_.push_back(pair);
        arranged_ = false;
        return std::nullopt;
    }
    /// They are no elements.
    static void for_each(auto&&) {}
    /// They hold no body.
    static void for_each_body(std::uint32_t, auto&&) {}
    /// @}

private:
    /// Whether the depth of two is known wherever they are; for spheres and boxes, of what size.
    template <class Data> static bool measure(const Data& data, Pair& pair) {
        int rounded = 0, planes = 0;
        auto add = [&](const auto& shape) {
            using Kind = typename std::remove_cvref_t<decltype(shape)>::description;
            if constexpr (std::same_as<Kind, Sphere>) ++rounded, pair.reach += shape.radius.value();
            if constexpr (std::same_as<Kind, Box>) ++rounded, pair.half += shape.half.value();
            if constexpr (std::same_as<Kind, Plane>) ++planes;
        };
        data.collisions.shapes.visit(pair.a, add);
        data.collisions.shapes.visit(pair.b, add);
        pair.flat = rounded < 2;
        return rounded == 2 || planes > 0;
    }

    std::vector<Pair> contacts_, pairs_;
    bool arranged_ = false;
    std::uint64_t layout_ = 0;
};

/// \f$ \mathbf F_a = \max(0,\; k\,p - c\,v_N)\,\mathbf N, \quad \mathbf F_b = -\mathbf F_a \f$ while p > 0. It never
/// pulls.
struct Penalty {
    using role = roles::Response;
    static constexpr Level level = Level::accelerations; ///< what it acts on
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position, Velocity>;
    template <class S> using State = PenaltyContacts<S>; ///< the contacts of the next step

    /// k, N/m, finite and greater than zero
    Parameter<unit::Stiffness> stiffness = 1e4 * newton_per_metre;
    /// c, N s/m, finite and not negative
    Parameter<unit::Damping> damping = 0.0 * newton_second_per_metre;

    static constexpr std::string_view name = "Penalty";
    static void parameters(auto& self, auto&& visit) {
        visit("stiffness", self.stiffness);
        visit("damping", self.damping);
    }
    /// \throws std::invalid_argument for parameters that are not acceptable
    void check() const {
        require_positive("Penalty", "stiffness", stiffness);
        require_not_negative("Penalty", "damping", damping);
    }

    template <class S> struct In {
        using Scalar = typename S::Scalar;
        using Pair = typename PenaltyContacts<S>::Pair;
        typename S::template ScalarOf<unit::Stiffness> k;
        typename S::template ScalarOf<unit::Damping> c;
        explicit In(const Penalty& penalty) : k(S::convert(penalty.stiffness)), c(S::convert(penalty.damping)) {}

        /// The forces of all contacts.
        void couple(auto& view, const auto&) const {
            for (const auto& pair : view.state().pairs()) {
                Vector<Scalar, S::dimension> normal;
                const auto pressed = press(view, pair, pair.a, pair.b, normal);
                if (pressed.value() > Scalar(0))
                    view.add_force_pair(pair.a, pair.b, typename S::Force(pressed * normal));
            }
        }
        /// How the forces change, along the normals: the part across them, which would push, is left out as for
        /// springs.
        void jacobian(const auto& view, const auto&, auto&& add) const {
            view.state().each([&](const Pair& pair) {
                const std::size_t a = view.slot_of_id(pair.a), b = view.slot_of_id(pair.b);
                Vector<Scalar, S::dimension> normal;
                if (!(press(view, pair, a, b, normal).value() > Scalar(0))) return;
                using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
                const Matrix along = normal * normal.transpose();
                add(a, b, Matrix(-k.value() * along), Matrix(-c.value() * along));
            });
        }
        /// How stiff and how damped the present contacts are.
        void stiffnesses(const auto& view, auto&& f) const {
            view.state().each([&](const Pair& pair) {
                f(std::size_t(view.slot_of_id(pair.a)), std::size_t(view.slot_of_id(pair.b)), k.value(), c.value());
            });
        }
        /// \f$ \sum \tfrac12 k p^2 \f$, J.
        typename S::Energy potential_energy(const auto& view) const {
            typename S::Energy sum{};
            view.state().each([&](const Pair& pair) {
                Vector<Scalar, S::dimension> normal;
                const auto p = PenaltyContacts<S>::depth(pair,
                                                         view.template get<Position>(view.slot_of_id(pair.a)) -
                                                             view.template get<Position>(view.slot_of_id(pair.b)),
                                                         normal);
                if (p.value() > Scalar(0)) sum += springs::energy(k, p);
            });
            return sum;
        }

    private:
        /// What two bodies press each other with, along the normal; nothing where they do not touch or would pull.
        [[gnu::always_inline]] typename S::template ScalarOf<unit::Force>
        press(const auto& view, const Pair& pair, std::size_t a, std::size_t b,
              Vector<Scalar, S::dimension>& normal) const {
            using Force = typename S::template ScalarOf<unit::Force>;
            const auto p = PenaltyContacts<S>::depth(
                pair, view.template get<Position>(a) - view.template get<Position>(b), normal);
            if (!(p.value() > Scalar(0))) return Force();
            const typename S::Velocity between = view.template get<Velocity>(a) - view.template get<Velocity>(b);
            const Force pressed = springs::force(k, -p, c, dot(between, normal));
            return pressed.value() > Scalar(0) ? pressed : Force();
        }
    };
};

} // namespace ansatz
