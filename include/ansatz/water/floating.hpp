// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Floating`: a body that water carries, as `World::add` takes it, by one of four models (notes 7.4).
///
///     world.add(Floating{ball, Sphere{0.5 * metre}});                        // Archimedes, exactly
///     world.add(Floating{crate, Box{metres(0.5, 0.5, 0.5)}});                // the same, of an upright box
///     world.add(Floating{coin, FixedLift{4.0 * metre_per_second_squared}});  // the notes' fixed acceleration
///     world.add(Floating{duck, SurfaceSpring{200.0 * newton_per_metre, 20.0 * newton_second_per_metre, 0.5 * metre}});
///
/// Use Archimedes where things should float as deep as they would; the fixed acceleration where they should only sink
/// more slowly, or come up again, since it does not know how deep a body is; the spring where a thing shall stay at the
/// surface until something pulls it under. It is a description beside the body's own: its shape for collisions, if it
/// has one, is another matter. A body outside of every pool is dry, and so is one that is wider than its pool, or one
/// that presses water up with a spring stiffer than \f$ \rho g A \f$, with A the area of its pool.

#include <ansatz/water/ring.hpp>
#include <ansatz/water/submerged.hpp>
#include <ansatz/world/element_table.hpp>

#include <array>
#include <variant>

namespace ansatz {

/// The notes' model: while its position is under the surface, the body has this acceleration upwards. More than gravity
/// turns it round, less slows it down. Without gravity it does nothing, since nothing weighs what it would displace.
struct FixedLift {
    Parameter<unit::Acceleration> acceleration; ///< m/s^2, finite, not negative
};
/// The notes' spring between a body and the surface above it: slack above, and gone for good once it was pulled this
/// deep. Then the water that hung on it is free.
struct SurfaceSpring {
    Parameter<unit::Stiffness> stiffness; ///< k, N/m, finite, positive
    Parameter<unit::Damping> damping{};   ///< c, N s/m, finite, not negative, against the rising of the surface
    Parameter<unit::Length> breaks_at;    ///< m under the surface, finite, positive
};

/// A body that water carries.
struct Floating {
    using element = Floating; ///< World::add takes it

    Handle body;                                            ///< which
    std::variant<Sphere, Box, FixedLift, SurfaceSpring> by; ///< by which model
    double drag = 0;                      ///< C of \f$ \frac12 \rho C A v^2 \f$, finite, not negative; of a shape
    Parameter<unit::Frequency> damping{}; ///< gamma, 1/s, finite, not negative: \f$ \gamma \rho V v \f$ of a shape
    bool presses = true;                  ///< whether what it displaces rises around it
};
/// Names it.
using FloatingHandle = ElementHandle<Floating>;

/// What the water does to a body, in a space of `Scalar` and `Dim`.
template <class Scalar, int Dim> struct Afloat {
    bool in_pool = false;                       ///< whether there is water around it
    bool broken = false;                        ///< whether its spring is
    Quantity<unit::Length, Scalar> level{};     ///< of the water around it, m
    Quantity<unit::Volume, Scalar> submerged{}; ///< of its shape, m^3
    Quantity<unit::Length, Scalar> centre{};    ///< the height y of what is submerged, m
    VectorQuantity<unit::Velocity, Dim, Scalar> flow = VectorQuantity<unit::Velocity, Dim, Scalar>::from_value(
        Vector<Scalar, Dim>(Vector<Scalar, Dim>::Zero())); ///< of the water, m/s
    VectorQuantity<unit::Force, Dim, Scalar> lift = VectorQuantity<unit::Force, Dim, Scalar>::from_value(
        Vector<Scalar, Dim>(Vector<Scalar, Dim>::Zero())); ///< without drag, N
};

namespace detail {

enum class LiftBy : std::uint8_t { sphere, box, fixed, spring };

/// The water around a body.
template <class Scalar> struct WaterBeside {
    bool wet = false;
    Scalar level{}, bed{};       // m; the level as it would be without what this body presses up
    Scalar feedback{}, room{};   // of the ring: by how much that rises, 1/m^2, and how much of it there is room for
    Scalar slope_x{}, slope_z{}; // of the surface
    Scalar u{}, rise{}, w{};     // m/s: along x, up, along z
    Scalar density{}, weight{};  // kg/m^3, N/m^3
    Scalar width{1};             // of a channel, for bodies of two dimensions, m
    std::uint32_t kind = 0, pool = 0xffffffffu;
};

/// The volume that a body presses up where the water around it rises by what it presses up: \f$ P = P(d + \kappa P) \f$.
/// The least one, by Newton within a bracket.
/// \param pressed  of a depth
/// \param depth    under the level that the water would have without it, m
/// \param feedback kappa, 1/m^2
/// \param most     no volume is larger, m^3
template <class Scalar, class F>
Scalar pressed_in_ring(const F& pressed, const Scalar& depth, const Scalar& feedback, const Scalar& most) {
    using std::abs;
    Scalar low = pressed(depth).volume, high = most < low ? low : most, v = low;
    for (int i = 0; i < 100 && low < high; ++i) {
        const auto at = pressed(depth + feedback * v);
        const Scalar more = at.volume - v;
        if (more > Scalar(0)) low = v;
        else high = v;
        const Scalar slope = Scalar(1) - feedback * at.waterline;
        Scalar next = slope > Scalar(0) ? v + more / slope : low;
        if (!(next > low && next < high)) next = low + (high - low) / Scalar(2);
        if (abs(next - v) <= std::numeric_limits<Scalar>::epsilon() * high || next == v) return next;
        v = next;
    }
    return v;
}

/// What is kept of one.
template <class S> struct FloatingRow {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;
    BodyId body;
    LiftBy model = LiftBy::sphere;
    std::array<Scalar, 3> size{}; // radius; half lengths; m/s^2; N/m, N s/m, m
    Scalar drag{}, damping{};
    bool presses = true, broken = false;
    Scalar displaced{};                         // m^3 that it presses up in that pool
    std::uint32_t kind = 0, pool = 0xffffffffu; // the last step's
    WaterBeside<Scalar> beside;                 // the water around it, as forces see it: follows from the state

    static FloatingRow from(const auto& asked, const Floating& given) {
        FloatingRow row;
        row.body = asked.body(given.body);
        row.model = LiftBy(given.by.index());
        std::visit([&](const auto& by) { row.take(by); }, given.by);
        if (!(given.drag >= 0) || !is_finite(given.drag))
            refuse_value("Floating", "drag", given.drag, "it must be finite and not negative");
        require_not_negative("Floating", "damping", given.damping);
        row.drag = S::convert("drag", Quantity<unit::Dimensionless>::from_value(given.drag)).value();
        row.damping = S::convert("damping", Quantity<unit::Frequency>(given.damping)).value();
        row.presses = given.presses;
        return row;
    }
    Floating describe(const auto& handle_of) const {
        auto d = [&](int k) { return static_cast<double>(size[std::size_t(k)]); };
        Floating all{handle_of(body), Sphere{d(0) * metre}, static_cast<double>(drag),
                     static_cast<double>(damping) * hertz, presses};
        if (model == LiftBy::box) all.by = S::dimension == 2 ? Box{metres(d(0), d(1))} : Box{metres(d(0), d(1), d(2))};
        if (model == LiftBy::fixed) all.by = FixedLift{d(0) * metre_per_second_squared};
        if (model == LiftBy::spring)
            all.by = SurfaceSpring{d(0) * newton_per_metre, d(1) * newton_second_per_metre, d(2) * metre};
        return all;
    }
    static void fields(auto& self, auto&& field) {
        field("body", self.body);
        choice_field(field, "Floating", "model", self.model, LiftBy::spring);
        field("size", self.size);
        field("drag", self.drag);
        field("damping", self.damping);
        field("presses", self.presses);
        field("broken", self.broken);
        field("displaced", self.displaced);
        field("kind", self.kind);
        field("pool", self.pool);
    }
    /// \throws std::invalid_argument for numbers that it cannot have
    void check() const {
        if (body == BodyId()) refuse_value("Floating", "body", "nobody", "it is one of this world");
        const int positive = model == LiftBy::box ? S::dimension : 1;
        for (int k = 0; k < 3; ++k) {
            const Scalar& x = size[std::size_t(k)];
            const bool may_be_zero = model == LiftBy::spring ? k == 1 : model == LiftBy::fixed || k >= positive;
            if (!(may_be_zero ? x >= Scalar(0) : x > Scalar(0)) || !is_finite(x))
                refuse_value("Floating", joined({"number ", std::to_string(k), " of its model"}), x,
                             may_be_zero ? "it must be finite, in the scalar of the world, and not negative"
                                         : "it must be finite, in the scalar of the world, and greater than zero");
        }
        require_number("drag", drag);
        require_number("damping", damping);
        require_number("displaced", displaced);
    }

    bool shaped() const { return model == LiftBy::sphere || model == LiftBy::box; }
    /// From its position down to its lowest point, m.
    Scalar below() const { return model == LiftBy::sphere ? size[0] : model == LiftBy::box ? size[1] : Scalar(0); }
    /// What of it is under water where its position is so deep; the spring and the fixed lift displace what they carry.
    Sunk<Scalar> sunk(const Scalar& depth, const WaterBeside<Scalar>& water, const Scalar& inverse_mass) const {
        constexpr bool flat = S::dimension == 2;
        if (model == LiftBy::sphere)
            return flat ? sunk_disc(size[0], water.width, depth + size[0]) : sunk_sphere(size[0], depth + size[0]);
        if (model == LiftBy::box)
            return sunk_box(Scalar(flat ? Scalar(2) * size[0] * water.width : Scalar(4) * size[0] * size[2]),
                            Scalar(Scalar(2) * size[1]), Scalar(depth + size[1]));
        if (!(depth > Scalar(0)) || !(water.weight > Scalar(0))) return {};
        if (model == LiftBy::spring) {
            if (broken) return {};
            return {size[0] * depth / water.weight, Scalar(0), size[0] / water.weight};
        }
        if (!(inverse_mass > Scalar(0))) return {};
        return {size[0] / (inverse_mass * water.weight), Scalar(0), Scalar(0)};
    }
    /// The same in the level that the water around it has with what it presses up.
    Sunk<Scalar> settled(const Scalar& depth, const Scalar& inverse_mass) const {
        if (!(beside.feedback > Scalar(0)) || model == LiftBy::fixed) return sunk(depth, beside, inverse_mass);
        const auto pressed = [&](const Scalar& d) {
            auto all = sunk(d, beside, inverse_mass);
            all.volume *= beside.room;
            all.waterline *= beside.room;
            return all;
        };
        const Scalar most = pressed(std::numeric_limits<Scalar>::max() / Scalar(1e6)).volume;
        const Scalar volume = pressed_in_ring(pressed, depth, beside.feedback, most);
        return sunk(depth + beside.feedback * volume, beside, inverse_mass);
    }
    /// By how much the water around it stands higher for that, m.
    Scalar raised(const Sunk<Scalar>& now) const { return beside.feedback * beside.room * now.volume; }
    /// How much stronger it is pushed for each metre that it sinks, N/m.
    Scalar stiffness(const Sunk<Scalar>& now) const {
        const Scalar slope = Scalar(1) - beside.feedback * beside.room * now.waterline;
        return slope > Scalar(0) ? beside.weight * now.waterline / slope : Scalar(0);
    }
    /// The largest stiffness that it has at any depth, N/m: where its section is widest.
    Scalar largest_stiffness(const Scalar& inverse_mass) const {
        const Scalar depth = shaped() ? Scalar(0) : std::numeric_limits<Scalar>::min();
        return stiffness(sunk(depth, beside, inverse_mass));
    }
    /// Where it is seen from above, for the ring around it.
    Footprint footprint(const Vec& at, const WaterBeside<Scalar>& water) const {
        auto d = [](const Scalar& x) { return static_cast<double>(x); };
        Footprint foot;
        foot.x = d(at[0]);
        if constexpr (S::dimension == 3) foot.z = d(at[2]);
        foot.round = model == LiftBy::sphere;
        if (model == LiftBy::sphere || model == LiftBy::box) foot.half_x = d(size[0]);
        if (model == LiftBy::sphere) foot.half_z = S::dimension == 3 ? d(size[0]) : 0;
        if (model == LiftBy::box) foot.half_z = S::dimension == 3 ? d(size[2]) : 0;
        foot.section = S::dimension == 2 ? 2 * foot.half_x * d(water.width)
                       : foot.round      ? std::numbers::pi * foot.half_x * foot.half_x
                                         : 4 * foot.half_x * foot.half_z;
        if (model == LiftBy::spring && water.weight > Scalar(0)) foot.section = d(size[0] / water.weight);
        return foot;
    }
    /// Upwards along the surface's normal, N; without drag.
    Vec lift(const Sunk<Scalar>& now) const {
        const auto& water = beside;
        Vec f = Vec::Zero();
        if (!water.wet) return f;
        f[1] = water.weight * now.volume;
        if (!shaped()) return f; // the notes' two models push straight upwards
        f[0] = -water.slope_x * f[1];
        if constexpr (S::dimension == 3) f[2] = -water.slope_z * f[1];
        return f;
    }
    /// How the water flows where the body is, m/s: what rises at the surface does so less below, and not at the bed.
    Vec flow(const Scalar& y) const {
        const auto& water = beside;
        Vec u = Vec::Zero();
        u[0] = water.u;
        const Scalar part = water.level > water.bed ? (y - water.bed) / (water.level - water.bed) : Scalar(0);
        u[1] = water.rise * held_to(part, Scalar(1));
        if constexpr (S::dimension == 3) u[2] = water.w;
        return u;
    }
    /// c of -c w, against the water that passes with w, kg/s.
    Scalar resistance(const Sunk<Scalar>& now, const Vec& w) const {
        using std::abs;
        using std::sqrt;
        const auto& water = beside;
        if (!water.wet) return Scalar(0);
        if (!shaped()) return model == LiftBy::spring && now.volume > Scalar(0) ? size[1] : Scalar(0);
        const auto all = sunk(Scalar(2) * below(), water, Scalar(0));
        if (!(now.volume > Scalar(0))) return Scalar(0);
        Scalar speed(0), across(0); // |w|, and |w| times the area that it meets
        for (int k = 0; k < S::dimension; ++k) speed += w[k] * w[k];
        speed = sqrt(speed);
        if (model == LiftBy::box) {
            for (int k = 0; k < S::dimension; ++k) {
                Scalar face = S::dimension == 2 ? water.width : Scalar(2);
                for (int l = 0; l < S::dimension; ++l)
                    if (l != k) face *= S::dimension == 2 ? Scalar(2) * size[std::size_t(l)] : size[std::size_t(l)];
                across += abs(w[k]) * (S::dimension == 2 ? face : Scalar(2) * face);
            }
        } else
            across = speed * (S::dimension == 2 ? Scalar(2) * size[0] * water.width
                                                : Scalar(std::numbers::pi) * size[0] * size[0]);
        const Scalar part = now.volume / all.volume;
        return water.density * (Scalar(0.5) * drag * across * part + damping * now.volume);
    }

    /// -c w; the spring acts along y alone.
    Vec against(const Scalar& c, const Vec& w) const {
        if (shaped()) return -c * w;
        Vec f = Vec::Zero();
        f[1] = -c * w[1];
        return f;
    }

private:
    static void require_number(std::string_view what, const Scalar& x) {
        if (!(x >= Scalar(0)) || !is_finite(x))
            refuse_value("Floating", what, x, "it must be finite, in the scalar of the world, and not negative");
    }
    void take(const Sphere& sphere) { size = {typename Sphere::In<S>(sphere).radius.value(), Scalar(0), Scalar(0)}; }
    void take(const Box& box) {
        const auto half = typename Box::In<S>(box).half.value();
        for (int k = 0; k < S::dimension; ++k) size[std::size_t(k)] = half[k];
    }
    void take(const FixedLift& lift) {
        require_not_negative("FixedLift", "acceleration", lift.acceleration);
        size = {S::convert("acceleration", Quantity<unit::Acceleration>(lift.acceleration)).value(), Scalar(0),
                Scalar(0)};
    }
    void take(const SurfaceSpring& spring) {
        require_positive("SurfaceSpring", "stiffness", spring.stiffness);
        require_not_negative("SurfaceSpring", "damping", spring.damping);
        require_positive("SurfaceSpring", "breaks_at", spring.breaks_at);
        size = {S::convert("stiffness", Quantity<unit::Stiffness>(spring.stiffness)).value(),
                S::convert("damping", Quantity<unit::Damping>(spring.damping)).value(),
                S::convert("breaks_at", Quantity<unit::Length>(spring.breaks_at)).value()};
    }
};

/// The floating bodies of a world. A description that is replaced keeps what its body displaces, so that no water is
/// lost; a broken spring is whole again.
template <class S> class FloatingTable : public ElementTable<S, Floating, FloatingRow<S>> {
    using Base = ElementTable<S, Floating, FloatingRow<S>>;

public:
    void replace(std::uint32_t id, FloatingRow<S> row) {
        const auto& before = std::as_const(*this).row(id);
        if (before.body == row.body) {
            row.displaced = before.displaced;
            row.kind = before.kind;
            row.pool = before.pool;
        }
        Base::replace(id, std::move(row));
    }
};

} // namespace detail
} // namespace ansatz
