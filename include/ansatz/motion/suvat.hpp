// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `suvat::solve`: from any three of displacement, two velocities, acceleration and time the other two (notes 1.5).
///
/// Use it for questions about motion along a line under a constant acceleration that have an answer in closed form:
/// when does the ball land, how fast must it leave, how long is the braking distance. No step and no integrator is
/// involved, so the answer is also what an integrator is held against. Not for an acceleration that changes (drag, a
/// spring, an orbit): there the equations hold within a small step only. For motion in space ask it once for each axis.
///
/// \code
/// const auto fall = suvat::solve(suvat::displacement(-20 * metre), suvat::initial_velocity(5 * metre_per_second),
///                                suvat::acceleration(-9.81 * metre_per_second_squared));
/// std::cout << fall.back().t << ", " << fall.back().v << '\n'; // 2.59229 s, -20.4304 m/s
/// \endcode
///
/// | symbol | meaning                                      | unit  |
/// |--------|----------------------------------------------|-------|
/// | s      | displacement: end minus start, signed        | m     |
/// | u      | velocity at the start (t = 0)                | m/s   |
/// | v      | velocity at the end (t)                      | m/s   |
/// | a      | acceleration, the same from start to end     | m/s^2 |
/// | t      | time from start to end; negative: before it  | s     |
///
/// \f[ v = u + a t, \quad s = u t + \tfrac12 a t^2, \quad s = \tfrac12 (u + v) t, \quad v^2 = u^2 + 2 a s, \quad
///     s = v t - \tfrac12 a t^2 \f]
/// The minus in the last belongs to the *final* velocity: with the initial one it is wrong, and often written.
///
/// Rounding: results are accurate to a few units in the last place, also where the textbook's formula for a root
/// cancels, as long as products of two of the given quantities can be held by the scalar. A class scalar
/// (Boost.Multiprecision) has no fused multiply-add and relies on its own digits.

#include <ansatz/units/requirements.hpp>
#include <ansatz/world/properties.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace ansatz::suvat {

/// A motion under constant acceleration; the letters are the notes'.
template <class Scalar> struct Solution {
    Quantity<unit::Length, Scalar> s{};       ///< displacement
    Quantity<unit::Velocity, Scalar> u{};     ///< initial velocity
    Quantity<unit::Velocity, Scalar> v{};     ///< final velocity
    Quantity<unit::Acceleration, Scalar> a{}; ///< acceleration
    Quantity<unit::Time, Scalar> t{};         ///< time from start to end; negative for an end before the start
};

/// One motion or two, the earlier first.
template <class Scalar> class Solutions {
public:
    /// 1 or 2.
    std::size_t size() const { return size_; }
    /// The earlier motion.
    const Solution<Scalar>* begin() const { return all_.data(); }
    /// Behind the later one.
    const Solution<Scalar>* end() const { return all_.data() + size_; }
    /// The earlier one; the only one where there is one.
    const Solution<Scalar>& front() const { return all_[0]; }
    /// The later one; the only one where there is one.
    const Solution<Scalar>& back() const { return all_[size_ - 1]; }

    /// Takes a motion to its place by time; one that the scalar cannot hold is left out.
    void add(const Solution<Scalar>& m) {
        if (!is_finite(m.s) || !is_finite(m.u) || !is_finite(m.v) || !is_finite(m.a) || !is_finite(m.t)) return;
        all_[size_++] = {m.s + zero<decltype(m.s)>(), m.u + zero<decltype(m.u)>(),
                         m.v + zero<decltype(m.v)>(), // -0 becomes 0
                         m.a + zero<decltype(m.a)>(), m.t + zero<decltype(m.t)>()};
        if (size_ == 2 && all_[1].t < all_[0].t) std::swap(all_[0], all_[1]);
    }

private:
    std::array<Solution<Scalar>, 2> all_{};
    std::size_t size_ = 0;
};

/// What `solve` was told about: the unit of one of the five, and its name in sentences.
namespace named {
/// s
struct Displacement {
    using Unit = unit::Length;
    static constexpr std::string_view text = "displacement"; ///< its name in sentences
};
/// u
struct InitialVelocity {
    using Unit = unit::Velocity;
    static constexpr std::string_view text = "initial velocity"; ///< its name in sentences
};
/// v
struct FinalVelocity {
    using Unit = unit::Velocity;
    static constexpr std::string_view text = "final velocity"; ///< its name in sentences
};
/// a
struct Acceleration {
    using Unit = unit::Acceleration;
    static constexpr std::string_view text = "acceleration"; ///< its name in sentences
};
/// t
struct Time {
    using Unit = unit::Time;
    static constexpr std::string_view text = "time"; ///< its name in sentences
};
} // namespace named

/// A quantity with its name, since u and v have one unit.
template <class Name, class Scalar> struct Known {
    /// How large it is.
    Quantity<typename Name::Unit, Scalar> value{};
};

namespace detail {

template <class Name, class Q>
inline constexpr bool fits = ansatz::detail::has_unit<typename Name::Unit, ansatz::detail::stripped<Q>> &&
                             !ansatz::detail::vector_valued<ansatz::detail::stripped<Q>>;

/// What does not fit has raised its sentence already and must not raise a second one.
template <class Name, class Q> constexpr auto give(const Q& q) {
    if constexpr (fits<Name, Q>) return Known<Name, typename ansatz::detail::stripped<Q>::value_type>{q};
    else return Known<Name, double>{};
}

template <class Name, class... Names> inline constexpr int times_in = (0 + ... + int(std::is_same_v<Name, Names>));

/// The known with this name; zero where it is not among them.
template <class Name, class S, class... Names> auto known(const Known<Names, S>&... knowns) {
    Quantity<typename Name::Unit, S> found{};
    auto look = [&](const auto& one) {
        if constexpr (std::is_same_v<decltype(one), const Known<Name, S>&>) found = one.value;
    };
    (look(knowns), ...);
    return found;
}

/// x y + z with one rounding.
template <class S> S fused(const S& x, const S& y, const S& z) {
    if constexpr (std::is_floating_point_v<S>) return std::fma(x, y, z);
    else return x * y + z;
}
template <class U, class V, class S>
auto fused(const Quantity<U, S>& x, const Quantity<V, S>& y, const std::type_identity_t<decltype(x * y)>& z) {
    return decltype(x * y)::from_value(fused(x.value(), y.value(), z.value()));
}

/// What a case found: motions, or else the reason why there is none.
template <class S> struct Answer {
    Solutions<S> solutions{};
    std::string_view reason{};
};

/// The ten cases. Seven are written down; the three without the initial velocity are the same motion seen backwards.
template <class S> struct Formulas {
    using Length = Quantity<unit::Length, S>;
    using Velocity = Quantity<unit::Velocity, S>;
    using Acceleration = Quantity<unit::Acceleration, S>;
    using Time = Quantity<unit::Time, S>;
    using Motion = Solution<S>;

    static constexpr std::string_view any_time = "nothing changes, so any time would do; give the time";
    static constexpr std::string_view any_acceleration = "in no time, any acceleration would do; give another quantity";
    static constexpr std::string_view any_velocity = "in no time, any velocity would do; give another quantity";
    static constexpr std::string_view out_of_reach =
        "it is out of reach: the motion turns round before it, because u^2 + 2 a s is negative";
    static constexpr std::string_view no_way = "they contradict each other: in no time there is no displacement";
    static constexpr std::string_view no_change = "they contradict each other: in no time the velocity does not change";

    static Answer<S> one(const Length& s, const Velocity& u, const Velocity& v, const Acceleration& a, const Time& t) {
        Answer<S> answer;
        answer.solutions.add({s, u, v, a, t});
        return answer;
    }
    static Velocity mean(const Velocity& u, const Velocity& v) { return S(0.5) * u + S(0.5) * v; }

    static Answer<S> suv(const Length& s, const Velocity& u, const Velocity& v) {
        const auto average = mean(u, v);
        if (average == Velocity()) {
            if (!(s == Length()))
                return {{}, "they contradict each other: the mean velocity is 0 m/s, so nothing is displaced"};
            return {{}, "it is back where it was after any time; give the time"};
        }
        if (s == Length()) return {{}, u == v ? any_acceleration : no_change};
        const Time t = s / average;
        return one(s, u, v, (v - u) / t, t);
    }
    static Answer<S> sut(const Length& s, const Velocity& u, const Time& t) {
        if (t == Time()) return {{}, s == Length() ? any_acceleration : no_way};
        return one(s, u, fused(-u, t, S(2) * s) / t, S(2) * fused(-u, t, s) / t / t, t);
    }
    static Answer<S> sat(const Length& s, const Acceleration& a, const Time& t) {
        if (t == Time()) return {{}, s == Length() ? any_velocity : no_way};
        // a t^2 / 2 as four parts that add up to it exactly: s may cancel the first, and what is left of it the others.
        const Velocity half = S(0.5) * a * t, low = fused(S(0.5) * a, t, -half);
        const Length parts[] = {half * t, fused(half, t, -half * t), low * t, fused(low, t, -low * t)};
        const auto with = [&](const S& sign) {
            Length sum = s, dropped{};
            for (const Length& part : parts) {
                const Length before = sum;
                sum += sign * part;
                dropped += ansatz::detail::dropped_from_sum(before, Length(sign * part), sum);
            }
            return (sum + dropped) / t;
        };
        return one(s, with(S(-1)), with(S(1)), a, t);
    }
    static Answer<S> uva(const Velocity& u, const Velocity& v, const Acceleration& a) {
        if (a == Acceleration())
            return {{}, u == v ? any_time : "they contradict each other: without acceleration the velocity stays"};
        const Time t = (v - u) / a;
        return one(mean(u, v) * t, u, v, a, t);
    }
    static Answer<S> uvt(const Velocity& u, const Velocity& v, const Time& t) {
        if (t == Time()) return {{}, u == v ? any_acceleration : no_change};
        return one(mean(u, v) * t, u, v, (v - u) / t, t);
    }
    static Answer<S> uat(const Velocity& u, const Acceleration& a, const Time& t) {
        return one(fused(S(0.5) * a, t, u) * t, u, fused(a, t, u), a, t);
    }
    static Answer<S> sua(const Length& s, const Velocity& u, const Acceleration& a) {
        if (a == Acceleration()) {
            if (u == Velocity())
                return {{}, s == Length() ? any_time : "they contradict each other: a body at rest stays where it is"};
            return one(s, u, u, a, s / u);
        }
        const Velocity speed = end_speed(s, u, a);
        if (speed < Velocity()) return {{}, out_of_reach};
        if (speed == Velocity()) return one(s, u, speed, a, -u / a);
        // Neither v - u of the first nor u + v of the second cancels: they are sums of two numbers of one sign.
        const Velocity far = u > Velocity() ? -speed : speed;
        const Velocity near = -far;
        Answer<S> both = one(s, u, far, a, (far - u) / a);
        both.solutions.add({s, u, near, a, s / mean(u, near)});
        return both;
    }

    // Seen backwards a motion goes from its end to its start, so that v is its initial velocity.
    static Answer<S> sva(const Length& s, const Velocity& v, const Acceleration& a) {
        Answer<S> answer = backwards(sua(-s, v, a));
        if (answer.reason == out_of_reach)
            answer.reason = "it is out of reach: no motion ends so, because v^2 - 2 a s is negative";
        return answer;
    }
    static Answer<S> svt(const Length& s, const Velocity& v, const Time& t) { return backwards(sut(-s, v, -t)); }
    static Answer<S> vat(const Velocity& v, const Acceleration& a, const Time& t) { return backwards(uat(v, a, -t)); }
    static Answer<S> backwards(const Answer<S>& there) {
        Answer<S> back{{}, there.reason};
        for (const Motion& m : there.solutions) back.solutions.add({-m.s, m.v, m.u, m.a, -m.t});
        return back;
    }

    /// \f$ \sqrt{u^2 + 2 a s} \f$, or -1 m/s where it is not real. Scaled by powers of two, so that squares neither
    /// overflow nor vanish; with the rounding errors of both products (W. Kahan's way), so that it is right where they
    /// cancel.
    static Velocity end_speed(const Length& s, const Velocity& u, const Acceleration& a) {
        using std::frexp;
        using std::ldexp;
        int exponent_u = 0, exponent_s = 0, exponent_a = 0;
        S x = frexp(u.value(), &exponent_u);
        S y = frexp(s.value(), &exponent_s);
        const S z = frexp(a.value(), &exponent_a);
        const bool only_u = y == S(0);
        const int exponent_as = exponent_a + exponent_s + 1;
        const int half = only_u ? exponent_u : x == S(0) ? exponent_as / 2 : std::max(exponent_u, exponent_as / 2);
        x = ldexp(x, exponent_u - half);
        y = only_u ? y : ldexp(y, exponent_as - 2 * half);
        const S square = x * x;
        const S product = y * z;
        S sum = (square + product) + (fused(x, x, S(-square)) + fused(y, z, S(-product)));
        // Off the turning point by no more than what rounding s to its last place does: the turning point.
        if (sum < S(0) && -sum <= 4 * std::numeric_limits<S>::epsilon() * square) sum = S(0);
        if (sum < S(0)) return Velocity::from_value(S(-1));
        return Velocity::from_value(ldexp(S(sqrt(sum)), half));
    }
};

} // namespace detail

/// \name The five quantities by name
/// \param q a quantity in one dimension, of float, double or a class scalar
/// @{

/// s: where it ends minus where it starts.
template <class Q> constexpr auto displacement(const Q& q) {
    static_assert(
        detail::fits<named::Displacement, Q>,
        "Ansatz: suvat::displacement takes a length in one dimension; write e.g. suvat::displacement(-20 * metre)");
    return detail::give<named::Displacement>(q);
}
/// u: the velocity at the start.
template <class Q> constexpr auto initial_velocity(const Q& q) {
    static_assert(detail::fits<named::InitialVelocity, Q>,
                  "Ansatz: suvat::initial_velocity takes a velocity in one dimension; write e.g. "
                  "suvat::initial_velocity(5 * metre_per_second)");
    return detail::give<named::InitialVelocity>(q);
}
/// v: the velocity at the end.
template <class Q> constexpr auto final_velocity(const Q& q) {
    static_assert(detail::fits<named::FinalVelocity, Q>,
                  "Ansatz: suvat::final_velocity takes a velocity in one dimension; write e.g. "
                  "suvat::final_velocity(0 * metre_per_second)");
    return detail::give<named::FinalVelocity>(q);
}
/// a: the constant acceleration.
template <class Q> constexpr auto acceleration(const Q& q) {
    static_assert(detail::fits<named::Acceleration, Q>,
                  "Ansatz: suvat::acceleration takes an acceleration in one dimension; write e.g. "
                  "suvat::acceleration(-9.81 * metre_per_second_squared)");
    return detail::give<named::Acceleration>(q);
}
/// t: the time from start to end.
template <class Q> constexpr auto time(const Q& q) {
    static_assert(detail::fits<named::Time, Q>,
                  "Ansatz: suvat::time takes a time; write e.g. suvat::time(2.0 * second)");
    ansatz::detail::refuse_whole_numbers<Q>();
    return detail::give<named::Time>(q);
}
/// @}

/// The motion, or the two motions, of which three quantities are known.
///
/// Two there are only where s, a and one velocity are given: a ball thrown up passes a height twice. Both are answered,
/// also where one has a negative time: the same motion, continued to before its start. A displacement that is reached
/// only in the turning point gives one; so does one that misses that point by no more than its own rounding. A second
/// motion at a time that the scalar cannot hold is left out.
///
/// \param knowns exactly three different ones of displacement(...), initial_velocity(...), final_velocity(...),
///               acceleration(...) and time(...), in any order, of one scalar
/// \throws std::invalid_argument where a value is not finite; where no motion has these values (out of reach,
///         contradictory); where infinitely many have (in no time, any acceleration would do)
template <class... Name, class... Scalar> auto solve(const Known<Name, Scalar>&... knowns) {
    constexpr bool three = sizeof...(Name) == 3;
    static_assert(three, "Ansatz: suvat::solve takes exactly three of the five quantities, and answers the other two");
    constexpr bool different = ((detail::times_in<Name, Name...> == 1) && ...);
    static_assert(different, "Ansatz: suvat::solve was given one quantity twice; give three different ones");
    constexpr bool one_scalar = !three || ((detail::times_in<Scalar, Scalar...> == 3) && ...);
    static_assert(
        one_scalar,
        "Ansatz: suvat::solve was given different scalars, e.g. float and double; convert with scalar_cast<double>(q)");
    if constexpr (three && different && one_scalar) {
        using S = std::tuple_element_t<0, std::tuple<Scalar...>>;
        using F = detail::Formulas<S>;
        (require_finite("suvat::solve", Name::text, knowns.value), ...);

        const auto s = detail::known<named::Displacement>(knowns...);
        const auto u = detail::known<named::InitialVelocity>(knowns...);
        const auto v = detail::known<named::FinalVelocity>(knowns...);
        const auto a = detail::known<named::Acceleration>(knowns...);
        const auto t = detail::known<named::Time>(knowns...);
        constexpr bool has_s = detail::times_in<named::Displacement, Name...> == 1;
        constexpr bool has_u = detail::times_in<named::InitialVelocity, Name...> == 1;
        constexpr bool has_v = detail::times_in<named::FinalVelocity, Name...> == 1;
        constexpr bool has_a = detail::times_in<named::Acceleration, Name...> == 1;
        const detail::Answer<S> answer = [&] {
            if constexpr (has_s && has_u && has_v) return F::suv(s, u, v);
            else if constexpr (has_s && has_u && has_a) return F::sua(s, u, a);
            else if constexpr (has_s && has_v && has_a) return F::sva(s, v, a);
            else if constexpr (has_u && has_v && has_a) return F::uva(u, v, a);
            else if constexpr (has_s && has_u) return F::sut(s, u, t);
            else if constexpr (has_s && has_v) return F::svt(s, v, t);
            else if constexpr (has_s && has_a) return F::sat(s, a, t);
            else if constexpr (has_u && has_v) return F::uvt(u, v, t);
            else if constexpr (has_u && has_a) return F::uat(u, a, t);
            else return F::vat(v, a, t);
        }();
        if (answer.solutions.size() == 0) {
            std::string sentence = "suvat::solve: ";
            (sentence.append(Name::text).append(" ").append(describe(knowns.value)).append(", "), ...);
            sentence.replace(sentence.size() - 2, 2, ": ");
            refuse(Refusal::invalid_argument,
                   sentence.append(answer.reason.empty() ? "the motion has a value that the scalar cannot hold"
                                                         : answer.reason));
        }
        return answer.solutions;
    }
}

/// Quantities without a name: refused with the sentence that says how to name them.
template <class... Q> auto solve(const Q&...) { // deduced: so this is the first that a compiler says
    static_assert(ansatz::detail::never<Q...>,
                  "Ansatz: suvat::solve takes named quantities, because two of the five are velocities; write e.g. "
                  "solve(suvat::initial_velocity(5 * metre_per_second), suvat::acceleration(...), suvat::time(...))");
    return Solutions<double>();
}

} // namespace ansatz::suvat
