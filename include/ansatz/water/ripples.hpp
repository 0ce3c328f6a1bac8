// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Ripples`: rings that run out from where something disturbed the water (notes 7.3).
///
/// Use them where an entity wades, drops in or leaps, on water that is otherwise still or a sum of sines; what begins a
/// ring is best a machine of chapter 5, which knows when the water is disturbed and when no longer. Heights of several
/// surfaces add. Rings know no walls and no ground that rises; drop a height into WaterColumns where they should.
///
/// \f[ y = A\,\frac{e^{-\gamma\tau}}{\sqrt{1 + r/\lambda}}\, \exp\Bigl(-\Bigl(\frac{r - c_g \tau}{s}\Bigr)^2\Bigr) \cos(k r - \omega \tau), \qquad \tau = t - t_0 \ge 0 \f]
///
/// The group runs out at the speed of groups, c_g, and crests run through it at theirs, omega / k, twice as fast over
/// deep water: they rise at its back and die at its front, as on a pond. The root spreads the energy over the growing
/// ring. At the middle r is rounded by an eighth of a wavelength, so that there is no tip.

#include <ansatz/water/dispersion.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace ansatz {

/// One disturbance.
struct Ripple {
    Quantity<unit::Length> x;                        ///< where, m, finite
    Quantity<unit::Length> z;                        ///< where, m, finite
    Quantity<unit::Time> begun;                      ///< when, s, finite; before it there is nothing
    Quantity<unit::Length> amplitude = 0.05 * metre; ///< A, m, finite, not negative
    Quantity<unit::Length> wavelength = 0.5 * metre; ///< lambda, m, finite, positive
    Quantity<unit::Length> width = 0.75 * metre;     ///< s, half of the ring's width, m, finite, positive
    Quantity<unit::Frequency> damping = 0.5 * hertz; ///< gamma, 1/s, finite, positive: or it would never end
};

/// Some rings at most; when one more begins, the oldest is forgotten. A value: copies go on alike.
class Ripples {
public:
    using Length = Quantity<unit::Length>; ///< m
    using Time = Quantity<unit::Time>;     ///< s

    /// \param most  how many rings are kept, at least 1; they are all the memory that is ever taken
    /// \param depth of the water, m, positive, infinite by default
    /// \param gravity m/s^2, finite, positive: that of the world, where there is one
    /// \throws std::invalid_argument for other values
    explicit Ripples(std::size_t most, Length depth = water::bottomless * metre,
                     Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared)
        : most_(most), depth_(depth), gravity_(gravity) {
        if (most == 0) refuse_value("Ripples", "most", most, "at least 1 ring is kept");
        if (most > rings_.max_size())
            refuse_value("Ripples", "most", most,
                         detail::joined({"there is room for ", std::to_string(rings_.max_size()), " rings"}));
        if (!(depth.value() > 0)) refuse_value("Ripples", "depth", depth, "it must be greater than zero, or infinite");
        require_positive("Ripples", "gravity", gravity);
        rings_.reserve(most);
    }
    /// A copy has room for as many.
    Ripples(const Ripples& other) : most_(other.most_), depth_(other.depth_), gravity_(other.gravity_) {
        rings_.reserve(most_);
        rings_ = other.rings_;
    }
    /// As the copy.
    Ripples& operator=(const Ripples& other) {
        if (this != &other) *this = Ripples(other);
        return *this;
    }
    Ripples(Ripples&&) = default;            ///< takes the memory along
    Ripples& operator=(Ripples&&) = default; ///< takes the memory along
    ~Ripples() = default;

    /// Begins a ring.
    /// \throws std::invalid_argument for values that it cannot have, with the rings left as they were
    void begin(const Ripple& ripple) {
        constexpr std::string_view where = "Ripples::begin";
        require_finite(where, "x", ripple.x);
        require_finite(where, "z", ripple.z);
        require_finite(where, "begun", ripple.begun);
        require_not_negative(where, "amplitude", ripple.amplitude);
        require_positive(where, "wavelength", ripple.wavelength);
        require_positive(where, "width", ripple.width);
        require_positive(where, "damping", ripple.damping);
        const Ring ring{ripple.x.value(),
                        ripple.z.value(),
                        ripple.begun.value(),
                        ripple.amplitude.value(),
                        1 / ripple.wavelength.value(),
                        1 / ripple.width.value(),
                        ripple.damping.value(),
                        water::wave_number(ripple.wavelength).value(),
                        water::angular_frequency(ripple.wavelength, depth_, gravity_).value(),
                        water::group_speed(ripple.wavelength, depth_, gravity_).value()};
        if (rings_.size() < most_) {
            rings_.push_back(ring);
            return;
        }
        *std::min_element(rings_.begin(), rings_.end(),
                          [](const Ring& a, const Ring& b) { return a.begun < b.begun; }) = ring;
    }
    /// Forgets the rings that have lost all but a thousandth by now.
    void forget_faded(Time now) {
        std::erase_if(rings_, [&](const Ring& r) { return std::exp(-r.damping * (now.value() - r.begun)) < 1e-3; });
    }
    std::size_t size() const { return rings_.size(); } ///< how many rings there are
    std::size_t most() const { return most_; }         ///< how many there may be

    /// What they add to the surface, m.
    Length height(Length x, Length z, const Time& t) const {
        double y = 0;
        for (const Ring& ring : rings_) y += ring.at(x.value(), z.value(), t.value()).height;
        return y * metre;
    }
    /// The slopes that they add, along x and along z. The normal of a surface with slopes a and b is (-a, 1, -b),
    /// normalized.
    Vector<double, 2> slope(Length x, Length z, const Time& t) const {
        Vector<double, 2> sum(0, 0);
        for (const Ring& ring : rings_) {
            const auto here = ring.at(x.value(), z.value(), t.value());
            sum += Vector<double, 2>(here.by_x, here.by_z);
        }
        return sum;
    }

private:
    struct Here {
        double height, by_x, by_z;
    };
    struct Ring {
        double x, z, begun, amplitude, over_length, over_width, damping, k, omega, group;
        Here at(double to_x, double to_z, double t) const {
            const double tau = t - begun, dx = to_x - x, dz = to_z - z, round = 0.125 / over_length;
            if (!(tau >= 0)) return {0, 0, 0};
            const double r = std::sqrt(dx * dx + dz * dz + round * round), off = (r - group * tau) * over_width;
            if (!(off * off < 750)) return {0, 0, 0}; // exp(-750) is 0, and far off r may not be finite
            const double spread = 1 / (1 + r * over_length),
                         size = amplitude * std::exp(-damping * tau - off * off) * std::sqrt(spread);
            const double c = std::cos(k * r - omega * tau), s = std::sin(k * r - omega * tau);
            const double by_r = size * (-c * (2 * off * over_width + 0.5 * over_length * spread) - k * s);
            return {size * c, by_r * dx / r, by_r * dz / r};
        }
    };
    std::size_t most_;
    Length depth_;
    Quantity<unit::Acceleration> gravity_;
    std::vector<Ring> rings_;
};

} // namespace ansatz
