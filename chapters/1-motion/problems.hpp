// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The problems that integrators are measured on, each with its exact solution or its invariant (chapter 1).
///
/// Every force here is a policy as you would write one yourself: a struct that names its role, lists the columns it
/// reads, keeps its parameters as quantities, and has an `In<S>` that computes with one body's values. Copy the nearest
/// one when you need a law of your own. Nobody but an implicit integrator asks for `jacobian`, nobody but
/// potential_energy() for `potential`. The tests of tests/motion and what_it_costs.cpp run them in the real World.
///
/// | symbol      | meaning                                        | unit     |
/// |-------------|------------------------------------------------|----------|
/// | x, v, a     | position, velocity, acceleration               | m, m/s, m/s^2 |
/// | t           | time                                           | s        |
/// | omega       | angular frequency of a free oscillation        | 1/s      |
/// | c           | damping rate                                   | 1/s      |
/// | k, m        | stiffness, mass                                | N/m, kg  |
/// | mu          | G M of a centre; in Arenstorf the moon's share of the mass | m^3/s^2; none |

#include <ansatz/motion/concepts.hpp>
#include <ansatz/units/requirements.hpp>

#include <cmath>

namespace problems {

using namespace ansatz;

/// Where a body is and how fast it moves, along one axis.
struct OnALine {
    Quantity<unit::Length> x;
    Quantity<unit::Velocity> v;
};
/// The same in a plane.
struct InAPlane {
    VectorQuantity<unit::Length, 2> x;
    VectorQuantity<unit::Velocity, 2> v;
};

/// A multiple of the unit matrix, which is what most Jacobians here are made of.
template <class S, class Unit>
typename S::template MatrixOf<Unit> diagonal(const typename S::template ScalarOf<Unit>& entry) {
    using Matrix = typename S::template MatrixOf<Unit>::value_type;
    Matrix m = Matrix::Zero();
    for (int i = 0; i < S::dimension; ++i) m(i, i) = entry.value();
    return S::template MatrixOf<Unit>::from_value(m);
}

// ---------------------------------------------------------------------------------------------------------------------

/// The harmonic oscillator, the same for every mass: \f$ \mathbf a = -\omega^2 (\mathbf x - \mathbf x_c) \f$.
struct Oscillator {
    using role = roles::Force;
    using reads = Columns<Position>;

    Parameter<unit::Frequency> omega = 1.0 / second;
    VectorParameter<unit::Length> centre = metres(0, 0, 0);

    void check() const { require_finite("Oscillator", "omega", omega); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::FrequencySquared> omega_squared;
        typename S::Position centre;
        explicit In(const Oscillator& o)
            : omega_squared(S::convert(o.omega) * S::convert(o.omega)),
              centre(S::convert("Oscillator::centre", o.centre)) {}

        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            return -omega_squared * (x - centre);
        }
        Jacobian<S> jacobian(const typename S::Position&, const auto&) const {
            return {diagonal<S, unit::FrequencySquared>(-omega_squared), {}};
        }
        auto potential(const typename S::Position& x, const auto&) const {
            return 0.5 * omega_squared * squared_norm(x - centre);
        }
    };
};

/// A spring of length zero from the body to a point: \f$ \mathbf F = -k (\mathbf x - \mathbf x_c) \f$. A force, so the mass counts.
struct PointSpring {
    using role = roles::Force;
    using reads = Columns<Position>;

    Parameter<unit::Stiffness> k = 1.0 * newton_per_metre;
    VectorParameter<unit::Length> centre = metres(0, 0, 0);

    void check() const { require_not_negative("PointSpring", "k", k); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::Stiffness> k;
        typename S::Position centre;
        explicit In(const PointSpring& s) : k(S::convert(s.k)), centre(S::convert("PointSpring::centre", s.centre)) {}

        typename S::Force force(const typename S::Position& x, const auto&) const { return -k * (x - centre); }
        ForceJacobian<S> jacobian(const typename S::Position&, const auto&) const {
            return {diagonal<S, unit::Stiffness>(-k), {}};
        }
        auto potential(const typename S::Position& x, const auto&) const { return 0.5 * k * squared_norm(x - centre); }
    };
};

/// Damping as a law that the integrator sees: \f$ \mathbf a = -c\,\mathbf v \f$. With Oscillator it is the damped oscillator.
struct LinearDamping {
    using role = roles::Force;
    using reads = Columns<Velocity>;

    Parameter<unit::Frequency> c = 0.2 / second;

    void check() const { require_not_negative("LinearDamping", "c", c); }

    template <class S> struct In {
        typename S::template ScalarOf<unit::Frequency> c;
        explicit In(const LinearDamping& d) : c(S::convert(d.c)) {}

        typename S::Acceleration acceleration(const typename S::Velocity& v, const auto&) const { return -c * v; }
        Jacobian<S> jacobian(const typename S::Velocity&, const auto&) const {
            return {{}, diagonal<S, unit::Frequency>(-c)};
        }
    };
};

/// x'' = -omega^2 x - c v from (x0, v0), whichever way it is damped. With d = c/2 and w^2 = omega^2 - d^2,
/// \f$ x = e^{-dt} (x_0 C + (v_0 + d x_0) S), \quad v = e^{-dt} (v_0 C - (d v_0 + \omega^2 x_0) S) \f$, where C = cos wt and
/// S = sin(wt)/w; above critical damping (w imaginary) they are cosh and sinh, at it 1 and t.
inline OnALine damped_oscillator(Quantity<unit::Frequency> omega, Quantity<unit::Frequency> c, const OnALine& start,
                                 Quantity<unit::Time> t) {
    const auto d = 0.5 * c;
    const double time = t.value(), square = (omega * omega - d * d).value(), w = std::sqrt(std::abs(square));
    const double cosine = square > 0 ? std::cos(w * time) : std::cosh(w * time);
    const auto sine = (square > 0 ? std::sin(w * time) / w : square < 0 ? std::sinh(w * time) / w : time) * second;
    const double fading = std::exp(-d.value() * time);
    return {fading * (start.x * cosine + (start.v + d * start.x) * sine),
            fading * (start.v * cosine - (d * start.v + omega * omega * start.x) * sine)};
}

/// x'' = -omega^2 x from (x0, v0).
inline OnALine oscillator(Quantity<unit::Frequency> omega, const OnALine& start, Quantity<unit::Time> t) {
    return damped_oscillator(omega, 0.0 / second, start, t);
}

// ---------------------------------------------------------------------------------------------------------------------

/// A push that changes with time alone: \f$ \mathbf a = \mathbf A \cos(\Omega t) \f$. It lists Clock, so it may ask for the time.
struct Forcing {
    using role = roles::Force;
    using reads = Columns<Clock>;

    VectorParameter<unit::Acceleration> amplitude = metres_per_second_squared(1, 0, 0);
    Parameter<unit::Frequency> omega = 2.0 / second;

    template <class S> struct In {
        typename S::Acceleration amplitude;
        Quantity<unit::Frequency, typename S::ClockScalar> omega;
        explicit In(const Forcing& f)
            : amplitude(S::convert("Forcing::amplitude", f.amplitude)),
              omega(scalar_cast<typename S::ClockScalar>(Quantity<unit::Frequency>(f.omega))) {}

        typename S::Acceleration acceleration(const auto& context) const {
            using std::cos;
            const typename S::ClockScalar phase = omega.value() * context.time().value(); // in the clock's precision
            return static_cast<typename S::Scalar>(cos(phase)) * amplitude;
        }
    };
};

/// x'' = -omega^2 x - c v + A cos(Omega t) from (x0, v0), not undamped at resonance: the driven part
/// \f$ p \cos\Omega t + q \sin\Omega t \f$ with \f$ p = A (\omega^2 - \Omega^2)/D,\ q = A c\,\Omega/D,\ D = (\omega^2 - \Omega^2)^2 + c^2 \Omega^2 \f$,
/// and a free oscillation that makes up the start.
inline OnALine driven_oscillator(Quantity<unit::Frequency> omega, Quantity<unit::Frequency> c,
                                 Quantity<unit::Acceleration> A, Quantity<unit::Frequency> Omega, const OnALine& start,
                                 Quantity<unit::Time> t) {
    const auto gap = omega * omega - Omega * Omega, loss = c * Omega;
    const auto D = gap * gap + loss * loss;
    const Quantity<unit::Length> p = A * gap / D, q = A * loss / D;
    const auto free = damped_oscillator(omega, c, {start.x - p, start.v - Omega * q}, t);
    const double C = std::cos((Omega * t).value()), S = std::sin((Omega * t).value());
    return {free.x + p * C + q * S, free.v + Omega * (q * C - p * S)};
}

// ---------------------------------------------------------------------------------------------------------------------

/// m^3/s^2: G times a mass.
using GravitationalParameter =
    typename boost::units::multiply_typeof_helper<unit::GravitationalConstant, unit::Mass>::type;

/// A heavy body at the origin: \f$ \mathbf a = -\mu\,\mathbf x / |\mathbf x|^3 \f$ (Kepler's problem).
struct CentralGravity {
    using role = roles::Force;
    using reads = Columns<Position>;

    Parameter<GravitationalParameter> mu = 1.0 * GravitationalParameter{};

    template <class S> struct In {
        typename S::template ScalarOf<GravitationalParameter> mu;
        explicit In(const CentralGravity& g) : mu(S::convert(g.mu)) {}

        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            const auto r = norm(x);
            return -(mu / (r * r * r)) * x;
        }
        /// \f$ -\mu/r^3\,(1 - 3\,\mathbf x \mathbf x^T / r^2) \f$
        Jacobian<S> jacobian(const typename S::Position& x, const auto&) const {
            using Scalar = typename S::Scalar;
            const Scalar r = norm(x).value();
            auto m = diagonal<S, unit::FrequencySquared>(-(mu / (norm(x) * norm(x) * norm(x)))).value();
            for (int i = 0; i < S::dimension; ++i)
                for (int j = 0; j < S::dimension; ++j)
                    m(i, j) += 3 * mu.value() / (r * r * r * r * r) * x.value()[i] * x.value()[j];
            return {S::template MatrixOf<unit::FrequencySquared>::from_value(m), {}};
        }
        auto potential(const typename S::Position& x, const auto&) const { return -mu / norm(x); }
    };
};

/// The orbit of eccentricity e with mu = 1 m^3/s^2 and the major half-axis 1 m, so that it takes 2 pi s, at the time t
/// after
/// the point nearest to the centre: \f$ x = (\cos E - e, \sqrt{1-e^2} \sin E) \f$ with Kepler's equation \f$ E - e \sin E = t \f$.
inline InAPlane kepler(double e, double t = 0) {
    double E = t;
    for (int i = 0; i < 50; ++i) E -= (E - e * std::sin(E) - t) / (1 - e * std::cos(E)); // Newton
    const double s = std::sin(E), c = std::cos(E), b = std::sqrt(1 - e * e);
    return {metres(c - e, b * s), metres_per_second(-s / (1 - e * c), b * c / (1 - e * c))};
}

// ---------------------------------------------------------------------------------------------------------------------

/// Henon and Heiles' galaxy: \f$ \Phi = \tfrac12 \omega^2 (x^2 + y^2) + \lambda (x^2 y - y^3/3) \f$, \f$ \mathbf a = -\nabla\Phi \f$.
/// Chaotic, but its energy is not: a star below E = 1/6 m^2/s^2 (for omega = lambda = 1) never escapes.
/// M. Henon, C. Heiles, Astron. J. 69, 73 (1964).
struct HenonHeiles {
    using role = roles::Force;
    using reads = Columns<Position>;
    using PerLengthTimeSquared =
        typename boost::units::divide_typeof_helper<unit::FrequencySquared, unit::Length>::type;

    Parameter<unit::Frequency> omega = 1.0 / second;
    Parameter<PerLengthTimeSquared> lambda = 1.0 * PerLengthTimeSquared{};

    template <class S> struct In {
        typename S::template ScalarOf<unit::FrequencySquared> omega_squared;
        typename S::template ScalarOf<PerLengthTimeSquared> lambda;
        explicit In(const HenonHeiles& h)
            : omega_squared(S::convert(h.omega) * S::convert(h.omega)), lambda(S::convert(h.lambda)) {}

        typename S::Acceleration acceleration(const typename S::Position& at, const auto&) const {
            const auto x = component(at, 0), y = component(at, 1);
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = (-omega_squared * x - 2.0 * lambda * x * y).value();
            a[1] = (-omega_squared * y - lambda * (x * x - y * y)).value();
            return S::Acceleration::from_value(a);
        }
        Jacobian<S> jacobian(const typename S::Position& at, const auto&) const {
            using Matrix = typename S::template MatrixOf<unit::FrequencySquared>::value_type;
            Matrix m = Matrix::Zero();
            const auto x = lambda * component(at, 0), y = lambda * component(at, 1);
            m(0, 0) = (-omega_squared - 2.0 * y).value();
            m(1, 1) = (-omega_squared + 2.0 * y).value();
            m(0, 1) = m(1, 0) = (-2.0 * x).value();
            return {S::template MatrixOf<unit::FrequencySquared>::from_value(m), {}};
        }
        auto potential(const typename S::Position& at, const auto&) const {
            const auto x = component(at, 0), y = component(at, 1);
            return 0.5 * omega_squared * (x * x + y * y) + lambda * (x * x * y - y * y * y / 3.0);
        }
    };
};

// ---------------------------------------------------------------------------------------------------------------------

/// A pendulum on a rod: the first component of the position is the arc s = length * angle, \f$ a_s = -g \sin(s/l) \f$; the
/// others do not move. Its exact motion is in pendulum.hpp.
struct Pendulum {
    using role = roles::Force;
    using reads = Columns<Position>;

    Parameter<unit::Length> length = 1.0 * metre;
    Parameter<unit::Acceleration> gravity = 1.0 * metre_per_second_squared;

    void check() const { require_positive("Pendulum", "length", length); }

    template <class S> struct In {
        typename S::Length length;
        typename S::template ScalarOf<unit::Acceleration> gravity;
        explicit In(const Pendulum& p) : length(S::convert(p.length)), gravity(S::convert(p.gravity)) {}

        typename S::Acceleration acceleration(const typename S::Position& x, const auto&) const {
            using std::sin;
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = -gravity.value() * sin(angle(x));
            return S::Acceleration::from_value(a);
        }
        Jacobian<S> jacobian(const typename S::Position& x, const auto&) const {
            using std::cos;
            Jacobian<S> j{};
            auto m = j.position.value();
            m(0, 0) = -(gravity / length).value() * cos(angle(x));
            j.position = decltype(j.position)::from_value(m);
            return j;
        }
        auto potential(const typename S::Position& x, const auto&) const {
            using std::cos;
            return gravity * length * typename S::Scalar(1 - cos(angle(x)));
        }

    private:
        typename S::Scalar angle(const typename S::Position& x) const { return (component(x, 0) / length).value(); }
    };
};

// ---------------------------------------------------------------------------------------------------------------------

/// A satellite between earth (at x = -mu) and moon (at x = 1 - mu), seen from axes that turn with them, in units of
/// their distance (1 m) and with one turn in 2 pi s. The force depends on the velocity (Coriolis), but not on the time:
/// \f[ \ddot x = x + 2 \dot y - (1-\mu) \frac{x + \mu}{D_1} - \mu \frac{x - (1-\mu)}{D_2}, \qquad
///     \ddot y = y - 2 \dot x - (1-\mu) \frac{y}{D_1} - \mu \frac{y}{D_2} \f]
/// with D_1 and D_2 the cubes of the distances from earth and moon. R. F. Arenstorf, Amer. J. Math. 85, 27 (1963).
struct Arenstorf {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;

    /// Share of the moon in the mass of both, without dimension
    double mu = 0.012277471;

    /// A closed orbit with three loops, and the time that it takes.
    static InAPlane start() { return {metres(0.994, 0), metres_per_second(0, -2.00158510637908252240537862224)}; }
    static Quantity<unit::Time> period() { return 17.0652165601579625588917206249 * second; }

    template <class S> struct In {
        using Scalar = typename S::Scalar;
        Scalar moon, earth;
        explicit In(const Arenstorf& a) : moon(static_cast<Scalar>(a.mu)), earth(1 - moon) {}

        // Plain numbers in these units: writing the turning axes' 1/s beside each term would hide the formula.
        typename S::Acceleration acceleration(const typename S::Position& at, const typename S::Velocity& velocity,
                                              const auto&) const {
            const Scalar x = at.value()[0], y = at.value()[1];
            const Scalar D1 = cube_of_norm(x + moon, y), D2 = cube_of_norm(x - earth, y);
            auto a = S::template zero_vector<unit::Acceleration>().value();
            a[0] = x + 2 * velocity.value()[1] - earth * (x + moon) / D1 - moon * (x - earth) / D2;
            a[1] = y - 2 * velocity.value()[0] - earth * y / D1 - moon * y / D2;
            return S::Acceleration::from_value(a);
        }

        /// What the orbit keeps (half of Jacobi's constant, with the sign of an energy), in m^2/s^2:
        /// \f$ \tfrac12 |\mathbf v|^2 - \tfrac12 (x^2 + y^2) - (1-\mu)/d_1 - \mu/d_2 \f$
        Quantity<unit::SpecificEnergy, Scalar> invariant(const typename S::Position& at,
                                                         const typename S::Velocity& velocity) const {
            using std::sqrt;
            const Scalar x = at.value()[0], y = at.value()[1];
            const Scalar d1 = sqrt((x + moon) * (x + moon) + y * y), d2 = sqrt((x - earth) * (x - earth) + y * y);
            return Quantity<unit::SpecificEnergy, Scalar>::from_value(
                (squared_norm(velocity).value() - x * x - y * y) / 2 - earth / d1 - moon / d2);
        }

    private:
        static Scalar cube_of_norm(const Scalar& x, const Scalar& y) {
            using std::sqrt;
            const Scalar square = x * x + y * y;
            return square * sqrt(square);
        }
    };
};

// ---------------------------------------------------------------------------------------------------------------------

/// A fall from rest through air with quadratic drag: the distance fallen and the speed, both downwards.
/// \f$ v = v_t \tanh(g t / v_t), \quad s = (v_t^2 / g) \ln\cosh(g t / v_t) \f$
inline OnALine fall_with_quadratic_drag(Quantity<unit::Velocity> terminal_speed, Quantity<unit::Acceleration> g,
                                        Quantity<unit::Time> t) {
    const double u = (g * t / terminal_speed).value();
    // ln cosh u without the overflow of cosh
    return {terminal_speed * terminal_speed / g * (u + std::log1p(std::exp(-2 * u)) - std::log(2.0)),
            terminal_speed * std::tanh(u)};
}

static_assert(DifferentiableIn<Oscillator, Space<>> && DifferentiableIn<PointSpring, Space<float, 2>> &&
              DifferentiableIn<LinearDamping, Space<>>);
static_assert(LawIn<Forcing, Space<>> && DifferentiableIn<CentralGravity, Space<>> &&
              LawIn<HenonHeiles, Space<float, 2>>);
static_assert(DifferentiableIn<Pendulum, Space<float, 2>> && LawIn<Arenstorf, Space<>>);

} // namespace problems
