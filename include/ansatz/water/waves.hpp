// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Waves`: a surface as a sum of sines, known at any time without a step (notes 7.3).
///
/// Use it for an ocean, and wherever waves need not answer to what happens in them: any place at any time costs one
/// sine for each wave, nothing is stored, and nothing can become unstable. Not for a pool that somebody falls into; add
/// the heights of a Surface to it there. Crests are as round as troughs; GerstnerWaves has sharp ones.
///
/// \f[ y = \sum A_i \cos\theta_i, \qquad \theta_i = k_i\,\mathbf d_i\cdot(x, z) - \omega_i t + \varphi_i, \qquad
///     \omega_i^2 = g k_i \tanh(k_i d) \f]
///
/// Below the surface the water moves on orbits that die away with the depth; `velocity` is that, so that what floats
/// drifts to and fro, and a diver is at rest.
///
/// A whole map is filled by turning: the next point of a row is the last one turned by k dx, two products in the place
/// of a cosine, thirty-two points abreast. Each row begins anew in double, so that nothing adds up.

#include <ansatz/water/dispersion.hpp>
#include <ansatz/water/height_map.hpp>

#include <array>

namespace ansatz {

/// One wave of a sum.
struct Wave {
    Quantity<unit::Length> wavelength; ///< lambda, m, finite, positive
    Quantity<unit::Length> amplitude;  ///< A, m, finite, not negative: half of what lies between trough and crest
    double direction = 0;              ///< where it runs to, radians from x towards z, finite
    double phase = 0;                  ///< phi, radians, finite
};

/// The sum of some waves over one depth.
class Waves {
public:
    using Length = Quantity<unit::Length>; ///< m
    using Time = Quantity<unit::Time>;     ///< s

    /// \param waves   none is allowed: a level surface
    /// \param depth   of the ground below y = 0, m, positive, infinite by default
    /// \param gravity m/s^2, finite, positive
    /// \throws std::invalid_argument for values that a wave cannot have, with its number
    explicit Waves(const std::vector<Wave>& waves, Length depth = water::bottomless * metre,
                   Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared)
        : depth_(depth.value()) {
        for (std::size_t n = 0; n < waves.size(); ++n) {
            const Wave& wave = waves[n];
            const std::string where = "Waves: wave " + std::to_string(n);
            require_positive(where, "wavelength", wave.wavelength);
            require_not_negative(where, "amplitude", wave.amplitude);
            for (const auto& [name, angle] : {std::pair{"direction", wave.direction}, std::pair{"phase", wave.phase}})
                if (!is_finite(angle)) refuse_value(where, name, angle, "it must be finite, in radians");
            const double k = water::wave_number(wave.wavelength).value();
            terms_.push_back({wave.amplitude.value(), k * std::cos(wave.direction), k * std::sin(wave.direction), k,
                              water::angular_frequency(wave.wavelength, depth, gravity).value(), wave.phase});
        }
        if (!(depth_ > 0)) refuse_value("Waves", "depth", depth, "it must be greater than zero, or infinite");
        require_positive("Waves", "gravity", gravity);
    }

    /// The height of the surface, m.
    Length height(Length x, Length z, const Time& t) const {
        double y = 0;
        for (const Term& w : terms_) y += w.amplitude * std::cos(w.angle(x.value(), z.value(), t.value()));
        return y * metre;
    }
    /// Its normal: upwards, of length 1.
    Vector<double, 3> normal(Length x, Length z, const Time& t) const {
        double by_x = 0, by_z = 0;
        for (const Term& w : terms_) {
            const double slope = -w.amplitude * std::sin(w.angle(x.value(), z.value(), t.value()));
            by_x += w.kx * slope;
            by_z += w.kz * slope;
        }
        const double length = std::sqrt(by_x * by_x + by_z * by_z + 1);
        return {-by_x / length, 1 / length, -by_z / length};
    }
    /// How fast the water moves at a place, m/s: orbits, linear in the amplitude. Above y = 0 as at y = 0, where the
    /// linear theory ends; below the ground as on it.
    VectorQuantity<unit::Velocity> velocity(Length x, Length y, Length z, const Time& t) const {
        Vector<double, 3> v(0, 0, 0);
        const double at = std::max(std::min(y.value(), 0.0), -depth_);
        for (const Term& w : terms_) {
            const double theta = w.angle(x.value(), z.value(), t.value()), speed = w.amplitude * w.omega;
            // cosh(k (y + d)) / sinh(k d) and sinh over sinh, written with exponentials that do not overflow.
            const double down = std::exp(w.k * at), up = depth_ < 1e300 ? std::exp(-w.k * (2 * depth_ + at)) : 0.0,
                         all = depth_ < 1e300 ? -std::expm1(-2 * w.k * depth_) : 1.0;
            const double along = speed * (down + up) / all * std::cos(theta);
            v[0] += w.kx / w.k * along;
            v[1] += speed * (down - up) / all * std::sin(theta);
            v[2] += w.kz / w.k * along;
        }
        return VectorQuantity<unit::Velocity>::from_value(v);
    }

    /// The heights of a whole grid of points: `heights[j * points_x + i]` is the one at x0 + i dx, z0 + j dz, in m.
    /// What was there is replaced. Nothing is checked but their number.
    /// \throws std::invalid_argument for another number of heights
    template <class Scalar>
    void fill(std::span<Scalar> heights, std::size_t points_x, std::size_t points_z, Length x0, Length z0, Length dx,
              Length dz, const Time& t) const {
        if (heights.size() != points_x * points_z)
            refuse_value("Waves::fill", "the number of heights", std::to_string(heights.size()),
                         "there is one for each of the " + std::to_string(points_x * points_z) + " points");
        std::fill(heights.begin(), heights.end(), Scalar(0));
        for (const Term& w : terms_) {
            const double turn = w.kx * dx.value();
            std::array<double, abreast> c, s;
            for (std::size_t i = 0; i < abreast; ++i) {
                c[i] = std::cos(turn * double(i));
                s[i] = std::sin(turn * double(i));
            }
            const Scalar stride_c(std::cos(turn * double(abreast))), stride_s(std::sin(turn * double(abreast)));
            for (std::size_t j = 0; j < points_z; ++j)
                for (std::size_t first = 0; first < points_x; first += in_a_row) {
                    const double start = w.angle(x0.value() + double(first) * dx.value(),
                                                 z0.value() + double(j) * dz.value(), t.value());
                    const double a = w.amplitude * std::cos(start), b = w.amplitude * std::sin(start);
                    std::array<Scalar, abreast> now_c, now_s;
                    for (std::size_t i = 0; i < abreast; ++i) {
                        now_c[i] = Scalar(a * c[i] - b * s[i]);
                        now_s[i] = Scalar(b * c[i] + a * s[i]);
                    }
                    add_row(std::min(in_a_row, points_x - first), stride_c, stride_s, now_c.data(), now_s.data(),
                            heights.data() + j * points_x + first);
                }
        }
    }
    /// The heights of a whole map, m.
    template <class Scalar = double>
    HeightMap<Scalar> height_map(std::size_t points_x, std::size_t points_z, Length dx, Length dz,
                                 const Time& t) const {
        std::vector<Scalar> heights(points_x * points_z);
        fill(std::span<Scalar>(heights), points_x, points_z, 0.0 * metre, 0.0 * metre, dx, dz, t);
        HeightMap<Scalar> map(points_x, points_z, dx, dz);
        for (std::size_t j = 0; j < points_z; ++j)
            for (std::size_t i = 0; i < points_x; ++i)
                map.set(i, j, Quantity<unit::Length, Scalar>::from_value(heights[j * points_x + i]));
        return map;
    }

    /// A wave as it is computed with.
    struct Term {
        double amplitude; ///< m
        double kx;        ///< wave number along x, 1/m
        double kz;        ///< wave number along z, 1/m
        double k;         ///< its size, 1/m
        double omega;     ///< 1/s
        double phase;     ///< radians
        /// theta, radians.
        double angle(double x, double z, double t) const { return kx * x + kz * z - omega * t + phase; }
    };
    std::span<const Term> terms() const { return terms_; } ///< what is summed

private:
    static constexpr std::size_t abreast = 32;
    static constexpr std::size_t in_a_row = 1024; // so many are rotated before the phase is computed anew
    template <class Scalar>
    static void add_row(std::size_t count, const Scalar turn_c, const Scalar turn_s, Scalar* __restrict c,
                        Scalar* __restrict s, Scalar* __restrict heights) {
        std::size_t i = 0;
        for (; i + abreast <= count; i += abreast)
            for (std::size_t n = 0; n < abreast; ++n) {
                const Scalar was_c = c[n], was_s = s[n];
                heights[i + n] += was_c;
                c[n] = was_c * turn_c - was_s * turn_s;
                s[n] = was_s * turn_c + was_c * turn_s;
            }
        const std::size_t left = std::min(count - i, abreast);
        for (std::size_t n = 0; n < left; ++n) heights[i + n] += c[n];
    }
    double depth_;
    std::vector<Term> terms_;
};

} // namespace ansatz
