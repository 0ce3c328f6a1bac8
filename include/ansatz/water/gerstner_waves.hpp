// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `GerstnerWaves`: a sum of waves with sharp crests and flat troughs, whose height at a place is right (notes 7.3).
///
/// Use it for a rough sea that is seen from near. A point of the surface does not go up and down but on a circle, so
/// that points crowd together at crests:
///
/// \f[ \mathbf x = \mathbf x_0 - Q \sum A_i\,\mathbf d_i \sin\theta_i, \qquad y = \sum A_i \cos\theta_i, \qquad \theta_i = k_i\,\mathbf d_i\cdot\mathbf x_0 - \omega_i t + \varphi_i \f]
///
/// with Q chosen so that \f$ Q \sum k_i A_i \f$ is the steepness: 0 is a sum of sines, 1 has crests with an edge, and beyond
/// it the surface would run through itself, which is refused. Gerstner's own waves have Q = 1.
///
/// Who asks for the height at x has to find the x0 that is there now; the height at x0 = x is another one, and what
/// floats on it dips into each crest. Here that is solved, by Newton's method on a function that is convex while the
/// steepness is below 1.
///
/// F. J. von Gerstner, Theorie der Wellen (1804); A. Fournier, W. Reeves, A Simple Model of Ocean Waves (1986).

#include <ansatz/water/waves.hpp>

namespace ansatz {

/// Waves whose points go on circles.
class GerstnerWaves {
public:
    using Length = Quantity<unit::Length>; ///< m
    using Time = Quantity<unit::Time>;     ///< s

    /// \param waves     the same as those of a sum of sines
    /// \param steepness Q times the sum of k A: from 0 to 1
    /// \throws std::invalid_argument for another steepness
    GerstnerWaves(Waves waves, double steepness) : waves_(std::move(waves)) {
        if (!(steepness >= 0 && steepness <= 1))
            refuse_value("GerstnerWaves", "steepness", steepness, "it is from 0 (sines) to 1 (crests with an edge)");
        double slopes = 0;
        for (const auto& w : waves_.terms()) slopes += w.k * w.amplitude;
        q_ = slopes > 0 ? steepness / slopes : 0.0;
    }

    /// Where the point is now that rests at x0, z0: m.
    VectorQuantity<unit::Length> position(Length x0, Length z0, const Time& t) const {
        const Point p = at(x0.value(), z0.value(), t.value());
        return metres(p.x, p.y, p.z);
    }
    /// Where the point rests that is at x, z now: (x0, z0), m.
    VectorQuantity<unit::Length, 2> rest(Length x, Length z, const Time& t) const {
        const auto found = solved(x.value(), z.value(), t.value());
        return metres(found[0], found[1]);
    }
    /// The height of the surface at x, z, m: to 1e-9 m for waves of metres up to a steepness of 0.9.
    Length height(Length x, Length z, const Time& t) const {
        const auto found = solved(x.value(), z.value(), t.value());
        return at(found[0], found[1], t.value()).y * metre;
    }
    /// The normal of the surface at x, z: upwards, of length 1. At a steepness of 1 a crest has none.
    Vector<double, 3> normal(Length x, Length z, const Time& t) const {
        const auto found = solved(x.value(), z.value(), t.value());
        const Point p = at(found[0], found[1], t.value());
        // dP/dz0 x dP/dx0, with dP/dx0 = (xx, yx, xz) and dP/dz0 = (xz, yz, zz).
        Vector<double, 3> n(p.yz * p.xz - p.zz * p.yx, p.zz * p.xx - p.xz * p.xz, p.xz * p.yx - p.yz * p.xx);
        return n / n.norm();
    }
    /// How fast the point of the surface moves that is at x, z: m/s.
    VectorQuantity<unit::Velocity> velocity(Length x, Length z, const Time& t) const {
        const auto found = solved(x.value(), z.value(), t.value());
        Vector<double, 3> v(0, 0, 0);
        for (const auto& w : waves_.terms()) {
            const double theta = w.angle(found[0], found[1], t.value()), speed = w.amplitude * w.omega;
            v[0] += q_ * speed * w.kx / w.k * std::cos(theta);
            v[1] += speed * std::sin(theta);
            v[2] += q_ * speed * w.kz / w.k * std::cos(theta);
        }
        return VectorQuantity<unit::Velocity>::from_value(v);
    }

private:
    struct Point {
        double x, y, z;    // where it is
        double xx, xz, zz; // how its place follows x0 and z0; symmetric
        double yx, yz;     // how its height does
    };
    Point at(double x0, double z0, double t) const {
        Point p{x0, 0, z0, 1, 0, 1, 0, 0};
        for (const auto& w : waves_.terms()) {
            const double theta = w.angle(x0, z0, t), c = w.amplitude * std::cos(theta),
                         s = w.amplitude * std::sin(theta);
            const double dx = w.kx / w.k, dz = w.kz / w.k;
            p.x -= q_ * dx * s;
            p.y += c;
            p.z -= q_ * dz * s;
            p.xx -= q_ * dx * w.kx * c;
            p.xz -= q_ * dx * w.kz * c;
            p.zz -= q_ * dz * w.kz * c;
            p.yx -= w.kx * s;
            p.yz -= w.kz * s;
        }
        return p;
    }
    /// Newton's method from x0 = x, with steps halved until they come nearer.
    Vector<double, 2> solved(double x, double z, double t) const {
        Vector<double, 2> found(x, z);
        Point p = at(x, z, t);
        double off = std::hypot(p.x - x, p.z - z);
        for (int turn = 0; turn < 60 && off > 1e-15 * (1 + std::abs(x) + std::abs(z)); ++turn) {
            const double fx = p.x - x, fz = p.z - z, determinant = p.xx * p.zz - p.xz * p.xz;
            if (!(determinant > 0)) break; // a crest with an edge
            const Vector<double, 2> step((p.zz * fx - p.xz * fz) / determinant, (p.xx * fz - p.xz * fx) / determinant);
            double part = 1;
            Point next{};
            double nearer = off;
            for (int half = 0; half < 50; ++half) {
                next = at(found[0] - part * step[0], found[1] - part * step[1], t);
                nearer = std::hypot(next.x - x, next.z - z);
                if (nearer < off) break;
                part *= 0.5;
            }
            if (!(nearer < off)) break; // rounding
            found -= part * step;
            p = next;
            off = nearer;
        }
        return found;
    }
    Waves waves_;
    double q_ = 0;
};

} // namespace ansatz
