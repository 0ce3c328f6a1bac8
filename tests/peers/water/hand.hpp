// SPDX-License-Identifier: BSL-1.0
// What somebody writes by hand who knows the arrays and the compiler: for the contest of water.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace peers {

/// Reads two lanes and writes them again, with hardly any arithmetic: what the memory gives to a loop in place.
inline void probe(std::vector<float>& height, std::vector<float>& rate, float a, float dt) {
    float* __restrict h = height.data();
    float* __restrict v = rate.data();
    const std::size_t count = height.size();
    for (std::size_t n = 0; n < count; ++n) {
        v[n] = v[n] - a * h[n];
        h[n] = h[n] + dt * v[n];
    }
}

/// The sum of four neighbours less four times the column, as it is mostly written. Two large numbers are subtracted:
/// what a low wave is made of is rounded away.
struct RowOfSums {
    static void push(std::size_t count, float strength, const float* __restrict south, const float* __restrict here,
                     const float* __restrict north, float* __restrict v) {
        v[0] += strength * (here[1] + south[0] + north[0] - 3 * here[0]);
        for (std::size_t i = 1; i + 1 < count; ++i)
            v[i] += strength * (here[i - 1] + here[i + 1] + south[i] + north[i] - 4 * here[i]);
        const std::size_t e = count - 1;
        v[e] += strength * (here[e - 1] + south[e] + north[e] - 3 * here[e]);
    }
};
/// The sum of four differences, each of which is exact.
struct RowOfDifferences {
    static void push(std::size_t count, float strength, const float* __restrict south, const float* __restrict here,
                     const float* __restrict north, float* __restrict v) {
        auto one = [&](std::size_t i, float west, float east) {
            const float h = here[i];
            v[i] += strength * (((east - h) + (west - h)) + ((north[i] - h) + (south[i] - h)));
        };
        one(0, here[0], here[1]);
        for (std::size_t i = 1; i + 1 < count; ++i) one(i, here[i - 1], here[i + 1]);
        one(count - 1, here[count - 2], here[count - 1]);
    }
};

/// Columns of the notes with walls that reflect: all rates, then all heights.
class HandColumns {
public:
    HandColumns(std::size_t nx, std::size_t nz) : nx_(nx), nz_(nz), height(nx * nz), rate(nx * nz) {}
    /// \param strength c^2 dt / dx^2
    /// \tparam Row how a row of rates is made
    template <class Row> void two_passes(float strength, float dt) {
        for (std::size_t j = 0; j < nz_; ++j) push<Row>(j, strength);
        for (std::size_t j = 0; j < nz_; ++j) raise(j, dt);
    }
    /// One sweep: the row of heights behind the one whose rates are made is not needed any more.
    template <class Row> void one_sweep(float strength, float dt) {
        for (std::size_t j = 0; j < nz_; ++j) {
            push<Row>(j, strength);
            if (j > 0) raise(j - 1, dt);
        }
        raise(nz_ - 1, dt);
    }

private:
    template <class Row> void push(std::size_t j, float strength) {
        const float* here = &height[j * nx_];
        Row::push(nx_, strength, j > 0 ? here - nx_ : here, here, j + 1 < nz_ ? here + nx_ : here, &rate[j * nx_]);
    }
    void raise(std::size_t j, float dt) {
        float* __restrict h = &height[j * nx_];
        const float* __restrict v = &rate[j * nx_];
        for (std::size_t i = 0; i < nx_; ++i) h[i] += dt * v[i];
    }
    std::size_t nx_, nz_;

public:
    std::vector<float> height, rate; ///< m, m/s
};

/// A wave of a sum.
struct HandWave {
    float amplitude, kx, kz, turned; ///< m, 1/m, 1/m, the phase of now
};
/// A sum of sines by the standard library, point by point.
template <class Sine>
void sines(const std::vector<HandWave>& waves, std::size_t n, float dx, std::vector<float>& heights, Sine sine) {
    for (std::size_t j = 0; j < n; ++j) {
        float* __restrict row = &heights[j * n];
        for (std::size_t i = 0; i < n; ++i) row[i] = 0;
        for (const HandWave& w : waves) {
            const float start = w.kz * (float(j) * dx) + w.turned, turn = w.kx * dx, a = w.amplitude;
            for (std::size_t i = 0; i < n; ++i) row[i] += a * sine(start + turn * float(i));
        }
    }
}

/// Saint-Venant's equations of first order, HLL with hydrostatic reconstruction, over four arrays, a pass for each job.
template <class T> class HandShallow {
public:
    HandShallow(std::size_t nx, std::size_t nz, T dx)
        : nx_(nx),
          nz_(nz),
          over_(1 / dx),
          height(nx * nz),
          bed(nx * nz),
          hu(nx * nz),
          hw(nx * nz),
          u_(nx * nz),
          w_(nx * nz) {
        for (auto* lane : {&mass_, &low_, &high_, &along_}) lane->assign(nx, T(0));
        for (auto* lane : {&mass_z_, &low_z_, &high_z_, &along_z_, &mass_s_, &high_s_, &along_s_})
            lane->assign(nx, T(0));
    }
    void step(T dt) {
        speeds(nx_ * nz_, height.data(), hu.data(), hw.data(), u_.data(), w_.data());
        const T by = dt * over_;
        for (std::size_t j = 0; j < nz_; ++j) {
            const std::size_t n = j * nx_;
            if (j == 0) wall(n, high_s_, mass_s_, along_s_);
            faces(nx_ - 1, &height[n], &bed[n], &u_[n], &w_[n], &height[n + 1], &bed[n + 1], &u_[n + 1], &w_[n + 1],
                  mass_.data(), low_.data(), high_.data(), along_.data());
            const std::size_t e = n + nx_ - 1;
            mass_[nx_ - 1] = along_[nx_ - 1] = 0;
            low_[nx_ - 1] = stop(height[e], u_[e]);
            if (j + 1 < nz_)
                faces(nx_, &height[n], &bed[n], &w_[n], &u_[n], &height[n + nx_], &bed[n + nx_], &w_[n + nx_],
                      &u_[n + nx_], mass_z_.data(), low_z_.data(), high_z_.data(), along_z_.data());
            else wall(n, low_z_, mass_z_, along_z_);
            update(n, by);
            mass_s_.swap(mass_z_);
            high_s_.swap(high_z_);
            along_s_.swap(along_z_);
        }
    }

private:
    static constexpr T g = T(9.81);
    static T stop(T h, T u) { return h * u * (u + (std::abs(u) + std::sqrt(g * h))); }
    void wall(std::size_t n, std::vector<T>& push, std::vector<T>& mass, std::vector<T>& along) {
        const bool south = n == 0;
        for (std::size_t i = 0; i < nx_; ++i) {
            mass[i] = along[i] = 0;
            push[i] = south ? stop(height[n + i], -w_[n + i]) : stop(height[n + i], w_[n + i]);
        }
    }
    static void speeds(std::size_t count, const T* __restrict h, const T* __restrict hu, const T* __restrict hw,
                       T* __restrict u, T* __restrict w) {
        for (std::size_t n = 0; n < count; ++n) {
            const T over = 1 / std::max(h[n], T(1e-5));
            u[n] = hu[n] * over;
            w[n] = hw[n] * over;
        }
    }
    static void faces(std::size_t count, const T* __restrict h1, const T* __restrict b1, const T* __restrict u1,
                      const T* __restrict t1, const T* __restrict h2, const T* __restrict b2, const T* __restrict u2,
                      const T* __restrict t2, T* __restrict mass, T* __restrict low, T* __restrict high,
                      T* __restrict along) {
        for (std::size_t i = 0; i < count; ++i) {
            const T sill = std::max(b1[i], b2[i]);
            const T a = std::max(T(0), h1[i] + b1[i] - sill), b = std::max(T(0), h2[i] + b2[i] - sill);
            const T ca = std::sqrt(g * a), cb = std::sqrt(g * b);
            const T slow = std::min(T(0), std::min(u1[i] - ca, u2[i] - cb));
            const T fast = std::max(T(0), std::max(u1[i] + ca, u2[i] + cb));
            const T qa = a * u1[i], qb = b * u2[i], pa = T(0.5) * g * a * a, pb = T(0.5) * g * b * b;
            const T over = 1 / (fast - slow + T(1e-30));
            const T m = (fast * qa - slow * qb + fast * slow * (b - a)) * over;
            const T p = (fast * (qa * u1[i] + pa) - slow * (qb * u2[i] + pb) + fast * slow * (qb - qa)) * over;
            mass[i] = m;
            low[i] = p - pa;
            high[i] = p - pb;
            along[i] = m * (m > 0 ? t1[i] : t2[i]);
        }
    }
    void update(std::size_t n, T by) {
        T* __restrict h = &height[n];
        T* __restrict qu = &hu[n];
        T* __restrict qw = &hw[n];
        const T first = stop(h[0], -u_[n]);
        for (std::size_t i = 0; i < nx_; ++i) {
            const T west_m = i > 0 ? mass_[i - 1] : 0, west_p = i > 0 ? high_[i - 1] : first,
                    west_t = i > 0 ? along_[i - 1] : 0;
            h[i] += by * ((west_m - mass_[i]) + (mass_s_[i] - mass_z_[i]));
            qu[i] += by * ((west_p - low_[i]) + (along_s_[i] - along_z_[i]));
            qw[i] += by * ((west_t - along_[i]) + (high_s_[i] - low_z_[i]));
        }
    }
    std::size_t nx_, nz_;
    T over_;

public:
    std::vector<T> height, bed, hu, hw; ///< m, m, m^2/s, m^2/s

private:
    std::vector<T> u_, w_, mass_, low_, high_, along_, mass_z_, low_z_, high_z_, along_z_, mass_s_, high_s_, along_s_;
};

} // namespace peers
