// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ClampedColumns`: WaterColumns whose heights are kept between two limits, as the notes ask for (7.2), without losing
/// water on the way.
///
/// Use it where waves must stay within what a scene can show, or so that no column runs below its floor. To clamp the
/// heights and nothing else is what is usually done, and is wrong twice: the water that is cut off is gone, and the
/// rate that drove the column there goes on pushing, so that it stays at the limit and a plateau grows around it.
///
/// Here the column that reaches a limit stops (its rate is given to the others, or the volume would go on to change),
/// and what was cut off is spread evenly over all columns that have room, or counted, as you choose. Where none has
/// room (a body is dipped into a full pool) it is owed to the pool, and spread when one has again. Energy is lost in
/// any case: a clamp hits the water as a lid does. What is set or poured between two steps, or pressed up by a body,
/// may lie beyond the limits until the next step. Pipes need no lower limit, because a flow ends where there is no
/// water.

#include <ansatz/water/water_columns.hpp>

namespace ansatz {

/// What becomes of the water that a clamp cuts off.
enum class Excess {
    spread,  ///< it is given to the columns that have room; what none has room for waits until one has
    counted, ///< it is gone, and `state().cut_off` says how much
};
/// The range of heights.
struct Clamp {
    Quantity<unit::Length> low;     ///< m, finite, not negative
    Quantity<unit::Length> high;    ///< m, finite, above low
    Excess excess = Excess::spread; ///< what becomes of the water beyond
};

/// One clamping of columns: heights in m, rates in m/s, one for each column, x fastest.
/// \param owed what earlier calls returned, m^3: with Excess::spread it is given back as soon as there is room
/// \return the volume that was cut off above less that which was filled in below, and given to no column, with what is
///         owed: m^3. With Excess::spread it is zero unless no column had room.
template <class Scalar>
Quantity<unit::Volume, detail::SumOf<Scalar>> clamp_columns(const Clamp& clamp, const ColumnGrid& grid,
                                                            std::span<Scalar> height, std::span<Scalar> rate,
                                                            detail::SumOf<Scalar> owed = {}) {
    using Sum = detail::SumOf<Scalar>;
    const Scalar low(clamp.low.value()), high(clamp.high.value());
    const auto &along_x = grid.x(), &along_z = grid.z();
    auto each = [&](auto&& f) {
        for (std::size_t j = 0, n = 0; j < along_z.count(); ++j)
            for (std::size_t i = 0; i < along_x.count(); ++i, ++n) f(n, Sum(along_x.width(i) * along_z.width(j)));
    };
    Sum cut(owed), push(0), open(0); // m^3, m^3/s, m^2
    each([&](std::size_t n, const Sum& footprint) {
        const bool above = height[n] > high, below = height[n] < low;
        if (height[n] > low && height[n] < high) open += footprint;
        if (!above && !below) return;
        cut += Sum(height[n] - (above ? high : low)) * footprint;
        height[n] = above ? high : low;
        if (above ? rate[n] > Scalar(0) : rate[n] < Scalar(0)) {
            push += Sum(rate[n]) * footprint;
            rate[n] = Scalar(0);
        }
    });
    if (push != Sum(0)) {
        const bool any = open > Sum(0);
        const Scalar more(push / (any ? open : Sum(grid.area().value())));
        each([&](std::size_t n, const Sum&) {
            if (!any || (height[n] > low && height[n] < high)) rate[n] += more;
        });
    }
    // Each pass fills at least one column, or is the last.
    for (std::size_t pass = 0; clamp.excess == Excess::spread && cut != Sum(0) && pass < height.size(); ++pass) {
        const bool fills = cut > Sum(0);
        auto has_room = [&](std::size_t n) { return fills ? height[n] < high : height[n] > low; };
        Sum room(0);
        each([&](std::size_t n, const Sum& footprint) { room += has_room(n) ? footprint : Sum(0); });
        if (!(room > Sum(0))) break;
        const Scalar more(cut / room);
        cut = Sum(0);
        each([&](std::size_t n, const Sum& footprint) {
            if (!has_room(n)) return;
            const Scalar wanted = height[n] + more, taken = std::clamp(wanted, low, high);
            cut += Sum(wanted - taken) * footprint;
            height[n] = taken;
        });
    }
    return Quantity<unit::Volume, Sum>::from_value(cut);
}

/// WaterColumns, clamped after each step.
struct ClampedColumns {
    WaterColumns columns; ///< what moves them
    Clamp clamp;          ///< the range

    static constexpr std::string_view name = "ClampedColumns"; ///< for sentences
    static constexpr bool has_bed = false;                     ///< the bed is level, at y = 0
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const {
        columns.check();
        require_not_negative(name, "low", clamp.low);
        require_finite(name, "high", clamp.high);
        if (!(clamp.high > clamp.low))
            refuse_value(name, "high", clamp.high, "it must be above low, which is " + describe(clamp.low));
    }
    /// Its parameters, by name, as a world saves them with its pools.
    static void fields(auto& self, auto&& field) {
        WaterColumns::fields(self.columns, field);
        field("low", self.clamp.low);
        field("high", self.clamp.high);
        detail::choice_field(field, "Pool", "excess", self.clamp.excess, Excess::counted);
    }
    /// What is kept for each column, and how much was cut off.
    template <class Scalar> struct State {
        std::vector<Scalar> height; ///< m
        std::vector<Scalar> rate;   ///< m/s
        std::uint64_t steps = 0;    ///< how many were made
        /// m^3: above less below, and given to no column: gone with Excess::counted, else owed until a column has room
        detail::SumOf<Scalar> cut_off{};
        /// Its fields, by name.
        static void fields(auto& self, auto&& field) {
            field("height", self.height);
            field("rate", self.rate);
            field("steps", self.steps);
            field("cut_off", self.cut_off);
        }
        friend bool operator==(const State&, const State&) = default; ///< the same values
    };
    /// The loop by itself.
    template <class Scalar> class In {
    public:
        using Time = Quantity<unit::Time>; ///< s
        /// As that of WaterColumns.
        /// \throws std::invalid_argument where water that is to be spread begins beyond the range: none has room
        In(const ClampedColumns& policy, const ColumnGrid& grid, Quantity<unit::Length> level)
            : clamp_(policy.clamp), grid_(grid), columns_(policy.columns, grid, level) {
            if (clamp_.excess == Excess::spread && !(level >= clamp_.low && level <= clamp_.high))
                refuse_value(name, "the level", level,
                             detail::joined({"it must be from low, ", describe(clamp_.low), ", to high, ",
                                             describe(clamp_.high), ": no column would have room for the rest"}));
        }
        /// All columns at rest.
        void prepare(State<Scalar>& state, Quantity<unit::Length>) const {
            state.rate.assign(state.height.size(), Scalar(0));
        }
        /// As that of WaterColumns, s.
        Time longest_step(const State<Scalar>&) const { return columns_.longest_step({}); }
        /// A pass over the columns, then the clamp.
        void advance(State<Scalar>& state, Time dt) const {
            const std::span height(state.height), rate(state.rate);
            columns_.advance(height, rate, dt);
            if (++state.steps % 32 == 0) columns_.take_out_rise(rate);
            state.cut_off = clamp_columns(clamp_, grid_, height, rate, state.cut_off).value();
        }

    private:
        Clamp clamp_;
        ColumnGrid grid_;
        WaterColumns::In<Scalar> columns_;
    };
};

static_assert(SurfacePolicyIn<ClampedColumns, double>);

} // namespace ansatz
