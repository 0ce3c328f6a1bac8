// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `WaterColumns`: the column approach of the notes (7.2): each column has a height and the rate at which it rises, and
/// is pulled towards its four neighbours.
///
/// Use it for ripples on a pool, a drop, a wake: waves that are low against the depth, at the lowest price there is.
/// Not over a bed, not where columns run dry, not for a flood: the height is free to become negative, and all waves
/// travel at one speed. Pipes and ShallowWater do that. The rate is the vertical speed of the surface, nothing else;
/// the water's own flow, which carries a boat, is not in it.
///
/// \f[ \dot h = v, \qquad \dot v = c^2 \Bigl(\frac{\partial^2 h}{\partial x^2} + \frac{\partial^2 h}{\partial z^2}\Bigr) - \gamma v \f]
///
/// | symbol | meaning                                            | unit |
/// |--------|----------------------------------------------------|------|
/// | h, v   | height of a column, the rate at which it rises     | m, m/s |
/// | c      | speed of waves; sqrt(g d) in shallow water         | m/s  |
/// | gamma  | damping: a rate decays by exp(-gamma dt) in a step | 1/s  |
///
/// Five points: the water that leaves a column through a face enters its neighbour, so that the volume is kept also
/// where footprints are unequal. First all rates move, then all heights (semi-implicit Euler). The step is stable while
///
/// \f[ c\,\Delta t\,\sqrt{\frac 1 {\Delta x^2} + \frac 1 {\Delta z^2}} \le 1 \f]
///
/// so for square columns \f$ c\,\Delta t / \Delta x \le 1/\sqrt 2 \f$; the 1 that is often quoted holds in a channel.
/// R. Courant, K. Friedrichs, H. Lewy, Ueber die partiellen Differenzengleichungen der mathematischen Physik (1928).

#include <ansatz/water/surface.hpp>

#include <array>
#include <cstdint>

namespace ansatz {

/// What a wall does to the waves that reach it.
enum class Wall {
    reflects, ///< a solid wall: they come back upright, and no water passes
    holds,    ///< the level there is held: they come back upside down, and water passes
    absorbs,  ///< a wave from straight ahead leaves, but for k dx / 4 of it; one that runs along the wall stays
};
/// The four sides. A channel has no walls along z.
struct Walls {
    Wall west = Wall::reflects;  ///< at the least x
    Wall east = Wall::reflects;  ///< at the largest x
    Wall south = Wall::reflects; ///< at the least z
    Wall north = Wall::reflects; ///< at the largest z
    /// All four alike.
    static constexpr Walls all(Wall wall) { return {wall, wall, wall, wall}; }
    friend bool operator==(const Walls&, const Walls&) = default; ///< the same on each side
};

namespace detail {

/// How strongly a column is pulled to its neighbours along one axis, 1/m^2: of each column, to the one before it and to
/// the one after it. At a wall that does not hold, 0.
template <class Scalar> struct Pulls {
    std::vector<Scalar> before, after;
    Scalar held_first{}, held_last{};         // 2 / width^2 at a wall that holds, which is half a width away
    Scalar absorbed_first{}, absorbed_last{}; // 1 / width at one that absorbs
    double largest = 0;                       // no eigenvalue along this axis is larger

    Pulls(const ColumnAxis& axis, Wall first, Wall last) {
        const std::size_t n = axis.count();
        if (n == 1) {
            before.assign(1, Scalar(0));
            after.assign(1, Scalar(0));
            return;
        }
        auto wall = [](double width, Wall kind, Scalar& held, Scalar& absorbed) {
            held = Scalar(kind == Wall::holds ? 2 / (width * width) : 0.0);
            absorbed = Scalar(kind == Wall::absorbs ? 1 / width : 0.0);
            return kind == Wall::holds ? 2 / (width * width) : 0.0;
        };
        for (std::size_t i = 0; i < n; ++i) {
            const double to_before = i > 0 ? 1 / (axis.width(i) * axis.distance(i - 1)) : 0.0,
                         to_after = i + 1 < n ? 1 / (axis.width(i) * axis.distance(i)) : 0.0;
            before.push_back(Scalar(to_before));
            after.push_back(Scalar(to_after));
            double row = 2 * (to_before + to_after); // Gershgorin
            if (i == 0) row += wall(axis.width(i), first, held_first, absorbed_first);
            if (i + 1 == n) row += wall(axis.width(i), last, held_last, absorbed_last);
            largest = std::max(largest, row);
        }
    }
};
/// What pulls along a row whose columns are alike, and along one whose are not, of the differences to both neighbours.
template <class Scalar> struct EqualPulls {
    Scalar pull; // c^2 dt / dx^2
    [[gnu::always_inline]] Scalar operator()(std::size_t, const Scalar& east, const Scalar& west) const {
        return pull * (east + west);
    }
};
template <class Scalar> struct UnequalPulls {
    Scalar strength; // c^2 dt
    const Scalar *to_before, *to_after;
    [[gnu::always_inline]] Scalar operator()(std::size_t i, const Scalar& east, const Scalar& west) const {
        return strength * (to_after[i] * east + to_before[i] * west);
    }
};

/// One row of rates from the heights around it. Nothing overlaps but what is only read: the compiler may take many
/// columns at once. Differences of heights are taken first: they are exact where waves are low.
template <bool Damped, class Scalar> struct ColumnRow {
    std::size_t count;
    Scalar to_south, to_north, keep; // c^2 dt / dz^2, exp(-gamma dt)
    template <class PullsAlongX>
    [[gnu::always_inline]] void operator()(const PullsAlongX& along_x, const Scalar* __restrict south,
                                           const Scalar* __restrict here, const Scalar* __restrict north,
                                           Scalar* __restrict rate) const {
        if (to_south == to_north)
            each(
                along_x, here, rate,
                [ =, by = to_north ](std::size_t i, const Scalar& h)
                    __attribute__((always_inline)) { return by * ((north[i] - h) + (south[i] - h)); });
        else
            each(
                along_x, here, rate, [ =, this ](std::size_t i, const Scalar& h) __attribute__((always_inline)) {
                    return to_north * (north[i] - h) + to_south * (south[i] - h);
                });
    }

private:
    template <class PullsAlongX, class Across>
    [[gnu::always_inline]] void each(const PullsAlongX& along_x, const Scalar* __restrict here, Scalar* __restrict rate,
                                     const Across& across) const {
        auto one = [&](std::size_t i, const Scalar& west, const Scalar& east) __attribute__((always_inline)) {
            const Scalar h = here[i], v = rate[i] + (along_x(i, east - h, west - h) + across(i, h));
            rate[i] = Damped ? v * keep : v;
        };
        one(0, here[0], here[1]);
        for (std::size_t i = 1; i + 1 < count; ++i) one(i, here[i - 1], here[i + 1]);
        one(count - 1, here[count - 2], here[count - 1]);
    }
};

} // namespace detail

/// The notes' columns: a height and its rate, five points, walls. Its parameters are read when the Surface is made.
struct WaterColumns {
    Quantity<unit::Velocity> wave_speed; ///< c, m/s, finite, positive
    Quantity<unit::Frequency> damping{}; ///< gamma, 1/s, finite, not negative
    Walls walls{}; ///< what the sides do; those that hold, hold the level that the surface begins with

    static constexpr std::string_view name = "WaterColumns"; ///< for sentences
    static constexpr bool has_bed = false;                   ///< the bed is level, at y = 0
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const {
        require_positive(name, "wave_speed", wave_speed);
        require_not_negative(name, "damping", damping);
    }
    /// Its parameters, by name, as a world saves them with its pools.
    static void fields(auto& self, auto&& field) {
        field("wave_speed", self.wave_speed);
        field("damping", self.damping);
        detail::choice_field(field, "Pool", "west", self.walls.west, Wall::absorbs);
        detail::choice_field(field, "Pool", "east", self.walls.east, Wall::absorbs);
        detail::choice_field(field, "Pool", "south", self.walls.south, Wall::absorbs);
        detail::choice_field(field, "Pool", "north", self.walls.north, Wall::absorbs);
    }

    /// What is kept for each column.
    template <class Scalar> struct State {
        std::vector<Scalar> height; ///< m
        std::vector<Scalar> rate;   ///< m/s
        std::uint64_t steps = 0;    ///< how many were made
        /// Its fields, by name.
        static void fields(auto& self, auto&& field) {
            field("height", self.height);
            field("rate", self.rate);
            field("steps", self.steps);
        }
        friend bool operator==(const State&, const State&) = default; ///< the same values
    };

    /// The loop by itself, over heights and rates of yours. It checks nothing.
    template <class Scalar> class In {
    public:
        using Time = Quantity<unit::Time>; ///< s
        /// \param level what walls hold that hold, m
        In(const WaterColumns& policy, const ColumnGrid& grid, Quantity<unit::Length> level)
            : speed_(policy.wave_speed.value()),
              damping_(policy.damping.value()),
              held_(Scalar(level.value())),
              x_(grid.x(), policy.walls.west, policy.walls.east),
              z_(grid.z(), policy.walls.south, policy.walls.north),
              uniform_(grid.x().uniform()),
              closed_(policy.walls == Walls{}),
              area_(grid.area().value()) {
            for (std::size_t i = 0; i < grid.columns_x(); ++i) width_x_.push_back(grid.x().width(i));
            for (std::size_t j = 0; j < grid.columns_z(); ++j) width_z_.push_back(grid.z().width(j));
        }
        /// All columns at rest.
        void prepare(State<Scalar>& state, Quantity<unit::Length>) const {
            state.rate.assign(state.height.size(), Scalar(0));
        }
        /// The Courant limit: 2 over the fastest that anything swings, s.
        Time longest_step(const State<Scalar>&) const {
            return 2 / (speed_ * std::sqrt(x_.largest + z_.largest)) * second;
        }
        /// One pass over all columns, in place; every 32nd time also what keeps a closed basin from rising.
        void advance(State<Scalar>& state, Time dt) const {
            advance(std::span(state.height), std::span(state.rate), dt);
            if (++state.steps % 32 == 0) take_out_rise(state.rate);
        }
        /// The same over spans: m and m/s, one for each column, x fastest, not overlapping.
        void advance(std::span<Scalar> height, std::span<Scalar> rate, Time dt) const {
            const Scalar h(dt.value());
            const Step step{Scalar(speed_ * speed_ * dt.value()), Scalar(std::exp(-damping_ * dt.value())), h,
                            Scalar(0.5 * speed_ * dt.value())};
            const std::size_t nx = x_.before.size(), nz = z_.before.size();
            for (std::size_t j = 0; j < nz; ++j) {
                Scalar* const here = height.data() + j * nx;
                Scalar* const rates = rate.data() + j * nx;
                absorb(j, rates, [&](Scalar& v, const Scalar& a) { v *= Scalar(1) - step.way * a; });
                hold(j, here, rates, step);
                const Scalar* const north = j + 1 < nz ? here + nx : here;
                if (damping_ > 0) row<true>(j, step, j == 0 ? here : here - nx, here, north, rates);
                else row<false>(j, step, j == 0 ? here : here - nx, here, north, rates);
                if (j > 0) raise(nx, h, here - nx, rates - nx);
                absorb(j, rates, [&](Scalar& v, const Scalar& a) { v /= Scalar(1) + step.way * a; });
            }
            Scalar* const last = height.data() + (nz - 1) * nx;
            const Scalar* const rates = rate.data() + (nz - 1) * nx;
            for (std::size_t i = 0; i < nx; ++i) last[i] = last[i] + h * rates[i];
        }
        /// Between four walls that reflect, the rates of all columns sum to nothing. Rounding adds to that sum, and the
        /// basin would rise by it for ever: 1e4 steps in float were 1e-4 of the volume. So its mean is taken out.
        void take_out_rise(std::span<Scalar> rate) const {
            if (!closed_) return;
            using Sum = detail::SumOf<Scalar>;
            const std::size_t nx = width_x_.size(), nz = width_z_.size();
            Sum rise(0);
            for (std::size_t j = 0; j < nz; ++j) {
                std::array<Sum, 16> part; // so many sums abreast, or each waits for the one before
                part.fill(Sum(0));
                const Scalar* const row = rate.data() + j * nx;
                std::size_t i = 0;
                for (; i + part.size() <= nx; i += part.size())
                    for (std::size_t k = 0; k < part.size(); ++k) part[k] += Sum(row[i + k]) * Sum(width_x_[i + k]);
                for (; i < nx; ++i) part[0] += Sum(row[i]) * Sum(width_x_[i]);
                Sum all(0);
                for (const Sum& one : part) all += one;
                rise += all * Sum(width_z_[j]);
            }
            const Scalar mean(rise / Sum(area_));
            for (Scalar& v : rate) v -= mean;
        }

    private:
        static void raise(std::size_t count, Scalar h, Scalar* __restrict height, const Scalar* __restrict rate) {
            for (std::size_t i = 0; i < count; ++i) height[i] = height[i] + h * rate[i];
        }
        struct Step {
            Scalar strength, keep, dt, way; // c^2 dt, exp(-gamma dt), dt, c dt / 2
        };
        template <bool Damped>
        void row(std::size_t j, const Step& step, const Scalar* south, const Scalar* here, const Scalar* north,
                 Scalar* rate) const {
            const detail::ColumnRow<Damped, Scalar> one{x_.before.size(), step.strength * z_.before[j],
                                                        step.strength * z_.after[j], step.keep};
            if (uniform_) one(detail::EqualPulls<Scalar>{step.strength * x_.before[1]}, south, here, north, rate);
            else
                one(detail::UnequalPulls<Scalar>{step.strength, x_.before.data(), x_.after.data()}, south, here, north,
                    rate);
        }
        /// What walls that hold pull at the columns beside them.
        void hold(std::size_t j, const Scalar* here, Scalar* rate, const Step& step) const {
            const std::size_t nx = x_.before.size(), nz = z_.before.size();
            auto pull = [&](std::size_t i, const Scalar& by) { rate[i] += step.strength * by * (held_ - here[i]); };
            if (x_.held_first > Scalar(0)) pull(0, x_.held_first);
            if (x_.held_last > Scalar(0)) pull(nx - 1, x_.held_last);
            const Scalar south = j == 0 ? z_.held_first : Scalar(0), north = j + 1 == nz ? z_.held_last : Scalar(0);
            if (south + north > Scalar(0))
                for (std::size_t i = 0; i < nx; ++i) pull(i, south + north);
        }
        /// What leaves through walls that absorb, a wave that runs outwards: dh/dn = -v/c at the wall, with the mean of
        /// the rates before and after the step, so that it takes energy whatever the step is.
        template <class F> void absorb(std::size_t j, Scalar* rate, F&& scale) const {
            const std::size_t nx = x_.before.size(), nz = z_.before.size();
            const Scalar across =
                (j == 0 ? z_.absorbed_first : Scalar(0)) + (j + 1 == nz ? z_.absorbed_last : Scalar(0));
            if (!(across + x_.absorbed_first + x_.absorbed_last > Scalar(0))) return;
            scale(rate[0], across + x_.absorbed_first);
            scale(rate[nx - 1], across + x_.absorbed_last);
            if (across > Scalar(0))
                for (std::size_t i = 1; i + 1 < nx; ++i) scale(rate[i], across);
        }
        double speed_, damping_;
        Scalar held_;
        detail::Pulls<Scalar> x_, z_;
        bool uniform_, closed_;
        double area_;
        std::vector<double> width_x_, width_z_;
    };
};

static_assert(SurfacePolicyIn<WaterColumns, double> && SurfacePolicyIn<WaterColumns, float>);

} // namespace ansatz
