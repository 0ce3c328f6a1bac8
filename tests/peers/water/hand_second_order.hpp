// SPDX-License-Identifier: BSL-1.0
// Shallow water of second order as somebody writes it by hand who has written that of first order: for the contest of
// water.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace peers {

/// Saint-Venant's equations by lines within columns of one width (MUSCL), HLL with hydrostatic reconstruction, and
/// Heun: a pass for each job. A column is nowhere dry.
template <class T> class HandSecondOrder {
public:
    HandSecondOrder(std::size_t nx, std::size_t nz, T dx)
        : nx_(nx), nz_(nz), over_(1 / dx), bed(nx * nz), height(nx * nz), hu(nx * nz), hw(nx * nz) {
        for (auto* lane : {&h1_, &hu1_, &hw1_, &level_, &u_, &w_}) lane->assign(nx * nz, T(0));
        for (auto* lane : {&minus_w_, &most_x_, &most_z_}) lane->assign(nx, T(0));
        for (Lines* lines : {&x_, &z_, &z_next_})
            for (auto* lane : {&lines->h, &lines->level, &lines->u, &lines->w}) lane->assign(nx, T(0));
        for (Faces* faces : {&east_, &south_, &north_})
            for (auto* lane : {&faces->mass, &faces->low, &faces->high, &faces->along}) lane->assign(nx, T(0));
    }
    /// \param limited whether the second stage is made shorter where the water has become too fast for it
    void step(T dt, bool limited) {
        stage<false>({height, hu, hw}, {h1_, hu1_, hw1_}, dt, 1);
        const T part = limited ? std::min(T(1), T(0.495) / fastest() / dt) : T(1);
        stage<true>({h1_, hu1_, hw1_}, {height, hu, hw}, part * dt, 1 / (1 + part));
    }

private:
    static constexpr T g = T(9.81);
    struct State {
        std::vector<T>&h, &hu, &hw;
    };
    /// Half of what changes within the columns of a row.
    struct Lines {
        std::vector<T> h, level, u, w;
    };
    struct Faces {
        std::vector<T> mass, low, high, along;
    };
    /// A row of columns with its lines; `across` is the velocity through the face.
    struct Side {
        const T *h, *level, *across, *along, *dh, *dlevel, *dacross, *dalong;
    };
    Side x_side(const State& s, std::size_t n, std::size_t i) const {
        return {&s.h[n + i], &level_[n + i], &u_[n + i], &w_[n + i], &x_.h[i], &x_.level[i], &x_.u[i], &x_.w[i]};
    }
    Side z_side(const State& s, std::size_t n, const Lines& z) const {
        return {&s.h[n], &level_[n], &w_[n], &u_[n], z.h.data(), z.level.data(), z.w.data(), z.u.data()};
    }
    /// A step of Euler; the last one is mixed with what is there.
    template <bool Last> void stage(State from, State to, T dt, T weight) {
        speeds(nx_ * nz_, from.h.data(), bed.data(), from.hu.data(), from.hw.data(), level_.data(), u_.data(),
               w_.data());
        lines_z(from.h, 0, z_);
        wall(z_side(from, 0, z_), -1, south_);
        for (std::size_t j = 0; j < nz_; ++j) {
            const std::size_t n = j * nx_;
            if (j + 1 < nz_) {
                lines_z(from.h, j + 1, z_next_);
                faces(nx_, z_side(from, n, z_), z_side(from, n + nx_, z_next_), north_.mass.data(), north_.low.data(),
                      north_.high.data(), north_.along.data());
            } else wall(z_side(from, n, z_), 1, north_);
            lines_x(from.h, n);
            faces(nx_ - 1, x_side(from, n, 0), x_side(from, n, 1), east_.mass.data(), east_.low.data(),
                  east_.high.data(), east_.along.data());
            const std::size_t e = nx_ - 1;
            east_.mass[e] = east_.along[e] = 0;
            east_.low[e] = stop(from.h[n + e] + x_.h[e], u_[n + e] + x_.u[e]);
            const T west = stop(from.h[n] - x_.h[0], -(u_[n] - x_.u[0]));
            update<Last>(nx_, dt * over_, weight, west, east_, south_, north_, x_.level.data(), z_.level.data(),
                         &from.h[n], &from.hu[n], &from.hw[n], &to.h[n], &to.hu[n], &to.hw[n]);
            std::swap(south_, north_);
            std::swap(z_, z_next_);
        }
    }
    static void speeds(std::size_t count, const T* __restrict h, const T* __restrict b, const T* __restrict qu,
                       const T* __restrict qw, T* __restrict level, T* __restrict u, T* __restrict w) {
        for (std::size_t n = 0; n < count; ++n) {
            const T over = 1 / std::max(h[n], T(1e-5));
            level[n] = b[n] + h[n];
            u[n] = qu[n] * over;
            w[n] = qw[n] * over;
        }
    }
    /// minmod of the differences to both neighbours and of half of their mean: the steepest one, theta = 2.
    static T half(T from, T here, T to) {
        const T back = here - from, on = to - here, middle = T(0.25) * (back + on);
        const T up = std::max(T(0), std::min(back, on)), down = std::min(T(0), std::max(back, on));
        return std::max(down, std::min(up, middle));
    }
    static void row(std::size_t count, const T* __restrict from, const T* __restrict here, const T* __restrict to,
                    T* __restrict lines) {
        for (std::size_t i = 0; i < count; ++i) lines[i] = half(from[i], here[i], to[i]);
    }
    /// Behind a wall is a mirror, in which the water runs the other way.
    void lines_z(const std::vector<T>& h, std::size_t j, Lines& to) {
        const std::size_t n = j * nx_, s = j > 0 ? n - nx_ : n, t = j + 1 < nz_ ? n + nx_ : n;
        for (std::size_t i = 0; i < nx_; ++i) minus_w_[i] = -w_[n + i];
        row(nx_, &h[s], &h[n], &h[t], to.h.data());
        row(nx_, &level_[s], &level_[n], &level_[t], to.level.data());
        row(nx_, &u_[s], &u_[n], &u_[t], to.u.data());
        row(nx_, j > 0 ? &w_[s] : minus_w_.data(), &w_[n], j + 1 < nz_ ? &w_[t] : minus_w_.data(), to.w.data());
    }
    void lines_x(const std::vector<T>& h, std::size_t n) {
        auto one = [&](const std::vector<T>& q, T mirror, std::vector<T>& to) {
            const T* here = &q[n];
            const std::size_t e = nx_ - 1;
            row(nx_ - 2, here, here + 1, here + 2, to.data() + 1);
            to[0] = half(mirror * here[0], here[0], here[1]);
            to[e] = half(here[e - 1], here[e], mirror * here[e]);
        };
        one(h, 1, x_.h);
        one(level_, 1, x_.level);
        one(u_, -1, x_.u);
        one(w_, 1, x_.w);
    }
    static T stop(T h, T u) { return h * u * (u + (std::abs(u) + std::sqrt(g * h))); }
    /// The wall ahead of a row (1), or that behind it (-1).
    void wall(Side s, T way, Faces& to) const {
        for (std::size_t i = 0; i < nx_; ++i) {
            to.mass[i] = to.along[i] = 0;
            to.low[i] = to.high[i] = stop(s.h[i] + way * s.dh[i], way * (s.across[i] + way * s.dacross[i]));
        }
    }
    static void faces(std::size_t count, Side one, Side other, T* __restrict mass, T* __restrict low,
                      T* __restrict high, T* __restrict along) {
        for (std::size_t i = 0; i < count; ++i) {
            const T h1 = one.h[i] + one.dh[i], h2 = other.h[i] - other.dh[i];
            const T b1 = one.level[i] + one.dlevel[i] - h1, b2 = other.level[i] - other.dlevel[i] - h2;
            const T u1 = one.across[i] + one.dacross[i], u2 = other.across[i] - other.dacross[i];
            const T t1 = one.along[i] + one.dalong[i], t2 = other.along[i] - other.dalong[i];
            const T sill = std::max(b1, b2), a = std::max(T(0), h1 + b1 - sill), b = std::max(T(0), h2 + b2 - sill);
            const T ca = std::sqrt(g * a), cb = std::sqrt(g * b);
            const T slow = std::min(T(0), std::min(u1 - ca, u2 - cb));
            const T fast = std::max(T(0), std::max(u1 + ca, u2 + cb));
            const T qa = a * u1, qb = b * u2, pa = T(0.5) * g * a * a, pb = T(0.5) * g * b * b;
            const T over = 1 / (fast - slow + T(1e-30));
            const T m = (fast * qa - slow * qb + fast * slow * (b - a)) * over;
            const T p = (fast * (qa * u1 + pa) - slow * (qb * u2 + pb) + fast * slow * (qb - qa)) * over;
            mass[i] = m;
            low[i] = p - pa;
            high[i] = p - pb;
            along[i] = m * (m > 0 ? t1 : t2);
        }
    }
    template <bool Last>
    static void update(std::size_t count, T by, T weight, T wall, const Faces& x, const Faces& s, const Faces& t,
                       const T* __restrict dx, const T* __restrict dz, const T* __restrict h, const T* __restrict qu,
                       const T* __restrict qw, T* __restrict to_h, T* __restrict to_qu, T* __restrict to_qw) {
        const T *xm = x.mass.data(), *xl = x.low.data(), *xh = x.high.data(), *xa = x.along.data(), *sm = s.mass.data(),
                *sh = s.high.data(), *sa = s.along.data(), *tm = t.mass.data(), *tl = t.low.data(),
                *ta = t.along.data();
        auto mix = [=](T& to, T after) { to = Last ? (1 - weight) * to + weight * after : after; };
        auto one = [=](std::size_t i, T west_m, T west_p, T west_a) {
            const T weighs = 2 * g * h[i];
            mix(to_h[i], h[i] + by * ((west_m - xm[i]) + (sm[i] - tm[i])));
            mix(to_qu[i], qu[i] + by * ((west_p - xl[i] - weighs * dx[i]) + (sa[i] - ta[i])));
            mix(to_qw[i], qw[i] + by * ((west_a - xa[i]) + (sh[i] - tl[i] - weighs * dz[i])));
        };
        one(0, 0, wall, 0);
        for (std::size_t i = 1; i < count; ++i) one(i, xm[i - 1], xh[i - 1], xa[i - 1]);
    }
    /// The largest (|u| + c) / dx of two neighbours along x, and the like along z, added, of what the first stage has
    /// made; 1/s.
    T fastest() {
        speeds(nx_ * nz_, h1_.data(), bed.data(), hu1_.data(), hw1_.data(), level_.data(), u_.data(), w_.data());
        std::fill(most_x_.begin(), most_x_.end(), T(0));
        std::fill(most_z_.begin(), most_z_.end(), T(0));
        for (std::size_t j = 0; j < nz_; ++j) {
            const std::size_t n = j * nx_;
            raise(nx_ - 1, &h1_[n], &h1_[n + 1], &u_[n], &u_[n + 1], most_x_.data());
            if (j > 0) raise(nx_, &h1_[n - nx_], &h1_[n], &w_[n - nx_], &w_[n], most_z_.data());
        }
        return (*std::max_element(most_x_.begin(), most_x_.end()) + *std::max_element(most_z_.begin(), most_z_.end())) *
               over_;
    }
    static void raise(std::size_t count, const T* __restrict h1, const T* __restrict h2, const T* __restrict u1,
                      const T* __restrict u2, T* __restrict most) {
        for (std::size_t i = 0; i < count; ++i)
            most[i] =
                std::max(most[i], std::max(std::abs(u1[i]), std::abs(u2[i])) + std::sqrt(g * std::max(h1[i], h2[i])));
    }
    std::size_t nx_, nz_;
    T over_;

public:
    std::vector<T> bed, height, hu, hw; ///< m, m, m^2/s, m^2/s

private:
    std::vector<T> h1_, hu1_, hw1_;                            // a step of Euler ahead
    std::vector<T> level_, u_, w_, minus_w_, most_x_, most_z_; // of the stage that is made
    Lines x_, z_, z_next_;
    Faces east_, south_, north_;
};

} // namespace peers
