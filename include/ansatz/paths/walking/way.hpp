// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Way`: how a walker with a greatest speed and acceleration goes along a path: a place for every time, as quickly as
/// its corners allow. `Walkers` has one for each walker; alone it moves what is no body, a camera or a cursor.
///
/// A corner may be cut: the walker leaves the line at a distance t before it, and is back on the next line t behind it.
/// In between it moves with one constant acceleration, on a parabola,
///
/// \f[ \mathbf r(q) = \mathbf P + t\left(q^2\,\mathbf d_2 - (1 - q)^2\,\mathbf d_1\right), \qquad 0 \le q \le 1, \f]
///
/// which is the quickest way to turn a velocity of one size from \f$ \mathbf d_1 \f$ to \f$ \mathbf d_2 \f$, and needs
/// no function but the root. The whole acceleration turns a pace of
/// \f$ u = \sqrt{2 a t / |\mathbf d_2 - \mathbf d_1|} \f$. A tight corner is taken with nine tenths of it, which costs
/// a twentieth of that pace, and leaves something to gather and lose speed with. The walker comes no nearer to the
/// corner than \f$ t\,|\mathbf d_2 - \mathbf d_1| / 4 \f$, and lies within the triangle of the corner and its two
/// ends. A corner that may not be cut, t = 0, is one to stop at. Between corners, and in each of them, the speed is a
/// trapezoid: greatest acceleration, greatest speed, greatest deceleration.
///
/// The place as a function of time has nowhere a speed or an acceleration above the greatest. So steps of any length
/// that go from \f$ \mathbf r(t) \f$ to \f$ \mathbf r(t + \Delta t) \f$ have velocities that are no greater than the
/// speed and differ by no more than \f$ a\,\Delta t \f$, and leave the way between their ends by
/// \f$ a\,\Delta t^2/8 \f$ at most.

#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace ansatz::paths {

namespace detail {
/// The square root of a plain number; found by its argument for scalars that bring their own.
template <class Scalar> Scalar root(const Scalar& x) {
    using std::sqrt;
    return sqrt(x);
}
} // namespace detail

/// \tparam S the space, for its number and its dimension
template <class S> struct Way {
    using Scalar = typename S::Scalar;
    using Length = typename S::Length;     ///< m
    using Speed = typename S::Speed;       ///< m/s
    using Time = typename S::Time;         ///< s
    using Position = typename S::Position; ///< m
    /// m/s^2, without a direction
    using Acceleration = typename S::template ScalarOf<unit::Acceleration>;
    using Direction = Vector<Scalar, S::dimension>; ///< of length one

    /// How far a walker is on it.
    struct Moment {
        std::uint32_t leg = 1; ///< from corner leg - 1 to corner leg, and the parabola at that corner
        Length along{};        ///< m, from corner leg - 1; on the parabola as if it were the two lines
        Speed pace{};          ///< m/s, the rate of `along`; the speed, but for the middle of a parabola
    };

    std::vector<Position> corners; ///< m, the first is where it begins
    std::vector<Length> cuts;      ///< m, t of each corner; none at both ends
    std::vector<Speed> limits;     ///< m/s, the greatest pace at which each corner may be begun
    Speed speed{};                 ///< m/s, the greatest
    Acceleration acceleration{};   ///< m/s^2, the greatest

    /// Makes cuts fit the legs, half a leg at most, and finds the limits. Every leg must be longer than zero.
    void prepare() {
        const std::size_t n = corners.size();
        limits.assign(n, speed);
        for (std::size_t i = 0; i < n; ++i) {
            if (i == 0 || i + 1 == n) cuts[i] = Length{};
            else cuts[i] = min(cuts[i], Scalar(0.5) * min(length(i), length(i + 1)));
        }
        limits.back() = Speed{};
        for (std::size_t i = n - 1; i-- > 1;) {
            const Turn turn = turn_at(i);
            limits[i] = min(turn.pace, pace_before(leaving(i), Scalar(2) * cuts[i], turn.acceleration));
        }
    }
    Length length(std::size_t leg) const { return norm(corners[leg] - corners[leg - 1]); } ///< m, of a leg
    /// Of a leg.
    Direction direction(std::size_t leg) const { return ansatz::direction(corners[leg] - corners[leg - 1]); }
    std::uint32_t last() const { return std::uint32_t(corners.size() - 1); } ///< the last leg, and corner
    /// Whether this is the end of it.
    bool is_end(const Moment& m) const { return m.leg == last() && !(m.along < length(m.leg)); }

    /// m, where one is.
    Position place(const Moment& m) const {
        const Length whole = length(m.leg), line = whole - cuts[m.leg];
        if (!(m.along > line)) // from the nearer end, so that ends are met exactly
            return m.along < whole - m.along ? corners[m.leg - 1] + m.along * direction(m.leg)
                                             : corners[m.leg] - (whole - m.along) * direction(m.leg);
        const Scalar q = part(m, line);
        const Direction to = m.leg < last() ? direction(m.leg + 1) : direction(m.leg);
        const Direction from = direction(m.leg);
        const Direction off = q * q * to - (Scalar(1) - q) * (Scalar(1) - q) * from;
        return corners[m.leg] + cuts[m.leg] * off;
    }
    /// The change of the place with `along`: a direction on a line, shorter on a parabola.
    Direction slope(const Moment& m) const {
        const Length line = length(m.leg) - cuts[m.leg];
        const Direction from = direction(m.leg);
        if (!(m.along > line) || m.leg == last()) return from;
        const Scalar q = part(m, line);
        return (Scalar(1) - q) * from + q * direction(m.leg + 1);
    }
    /// m, what is left of it.
    Length left(const Moment& m) const {
        Length all = length(m.leg) - m.along;
        for (std::size_t k = m.leg + 1; k <= last(); ++k) all += length(k);
        return max(Length{}, all);
    }
    /// s, how long the rest takes.
    Time time_left(Moment m) const { return advance(m, Time::from_value(std::numeric_limits<Scalar>::infinity())); }
    /// Goes on for a time, as quickly as may be. \return s, how much of it was needed: all, but at the end
    Time advance(Moment& m, const Time& time) const {
        Time used{};
        while (used < time) {
            const Length line = length(m.leg) - cuts[m.leg];
            if (m.along < line) {
                if (!run(m, line, limits[m.leg], {speed, acceleration}, time, used)) break;
            } else if (m.leg == last()) {
                m.along = line, m.pace = Speed{};
                break;
            } else if (!run(m, line + Scalar(2) * cuts[m.leg], leaving(m.leg), turn_at(m.leg), time, used)) break;
            else next_leg(m);
        }
        return used;
    }
    /// Comes to rest on the way as soon as may be, for a time.
    void brake(Moment& m, const Time& time) const {
        Time used{};
        while (used < time && m.pace.value() > Scalar(0)) {
            const Length line = length(m.leg) - cuts[m.leg];
            const bool turning = !(m.along < line);
            if (turning && m.leg == last()) {
                m.along = line, m.pace = Speed{};
                break;
            }
            const Length end = turning ? Length(line + Scalar(2) * cuts[m.leg]) : line;
            const Acceleration a = turning ? turn_at(m.leg).acceleration : acceleration;
            const auto left = m.pace * m.pace - Scalar(2) * a * (end - m.along);
            const bool on = left.value() > Scalar(0); // beyond the end of this part
            if (!phase(m, on ? Speed(sqrt(left)) : Speed{}, a, time, used) || !on) break;
            m.along = end;
            if (turning) next_leg(m);
        }
    }
    /// Moves on, or back within the leg, without regard to any time.
    void shift(Moment& m, Length by) const {
        m.along += by;
        if (m.along < cuts[m.leg - 1]) m.along = cuts[m.leg - 1];
        while (m.leg < last() && !(m.along < length(m.leg) + cuts[m.leg])) {
            m.along -= length(m.leg);
            ++m.leg;
        }
        if (m.leg == last()) m.along = min(m.along, length(m.leg));
    }

private:
    /// How far on the parabola, 0 to 1.
    Scalar part(const Moment& m, const Length& line) const {
        if (!(cuts[m.leg].value() > Scalar(0))) return Scalar(1);
        return std::min(Scalar(1), Scalar((m.along - line) / (Scalar(2) * cuts[m.leg])));
    }
    /// The share of the acceleration that turns, where a corner is tight.
    static constexpr double turned = 0.9;
    /// How fast one may be in a part of the way, and what is left there to gather and lose speed.
    struct Turn {
        Speed pace;
        Acceleration acceleration;
    };
    Turn turn_at(std::size_t i) const {
        const Direction change = direction(i + 1) - direction(i);
        const Scalar size = detail::root(change.squaredNorm());
        if (!(size > detail::root(std::numeric_limits<Scalar>::epsilon()))) return {speed, acceleration}; // straight on
        const auto most = Scalar(2) * acceleration * cuts[i] / size; // the square of the pace that all of it turns
        const Scalar share = most * Scalar(turned) > speed * speed ? Scalar(speed * speed / most) : Scalar(turned);
        const Scalar side = share * size / Scalar(2);
        const Scalar kept = detail::root(side * side + Scalar(1) - share * share) - side;
        return {min(speed, Speed(sqrt(share * most))), kept * acceleration};
    }
    /// The greatest pace behind corner i.
    Speed leaving(std::size_t i) const {
        const Length gap = max(Length{}, length(i + 1) - cuts[i] - cuts[i + 1]);
        return min(turn_at(i).pace, pace_before(limits[i + 1], gap, acceleration));
    }
    /// The pace from which one can brake to another.
    static Speed pace_before(const Speed& then, const Length& gap, const Acceleration& a) {
        return sqrt(then * then + Scalar(2) * a * gap);
    }
    void next_leg(Moment& m) const {
        m.along = cuts[m.leg];
        ++m.leg;
    }
    /// One part of a motion with constant acceleration. \return whether it came to its end
    bool phase(Moment& m, const Speed& to, const Acceleration& a, const Time& time, Time& used) const {
        const Time all = abs(to - m.pace) / a, have = time - used;
        const bool whole = !(have < all);
        const Time t = whole ? all : have;
        const Speed then = whole ? to : to < m.pace ? m.pace - a * t : m.pace + a * t;
        m.along += Scalar(0.5) * (m.pace + then) * t;
        m.pace = then;
        used = whole ? used + all : time;
        return whole;
    }
    /// A part of the way, to be no faster than `then` at its end. \return whether it came there
    bool run(Moment& m, const Length& end, const Speed& then, const Turn& most, const Time& time, Time& used) const {
        const Scalar half(0.5);
        const Acceleration& a = most.acceleration;
        const auto gained = Scalar(2) * a * (end - m.along); // in the square of the pace
        const Speed reach = sqrt(m.pace * m.pace + gained);  // without braking
        const Speed top = min(most.pace, min(reach, Speed(sqrt(half * (then * then + m.pace * m.pace + gained)))));
        if (m.pace < top && !phase(m, top, a, time, used)) return false;
        if (m.pace > most.pace && !phase(m, most.pace, a, time, used)) return false;
        const Length braking = half * (m.pace * m.pace - then * then) / a;
        const Length level = m.pace > then ? Length(end - m.along - braking) : Length(end - m.along);
        if (level.value() > Scalar(0) && m.pace.value() > Scalar(0)) {
            const Time all = level / m.pace, have = time - used;
            if (have < all) {
                m.along += m.pace * have;
                used = time;
                return false;
            }
            m.along += level, used += all;
        }
        if (m.pace > then && !phase(m, then, a, time, used)) {
            m.along = min(m.along, end);
            return false;
        }
        m.along = end, m.pace = min(m.pace, then);
        return true;
    }
};

} // namespace ansatz::paths
