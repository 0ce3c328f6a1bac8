// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `measured_stiffness`: how stiff the springs of a world are together, as they are stretched now, by power iteration
/// (notes 3).
///
/// Use it where the bound of `stiffness_of` (stable_step.hpp) costs too much: that adds up the springs at each body, is
/// certain, and for cloth 1.4 to 1.6 times too careful with the step. What is measured comes from below, and of what it
/// does not see (a rope that is slack now, a sheet that is about to fold) it knows nothing. So take 0.95 of the step
/// that follows from it, and the bound where it has not converged; `StepLimit{.measured = 20}` does both.
///
/// \f[ \theta = \frac{\mathbf x^T K \mathbf x}{\mathbf x^T M \mathbf x}, \qquad
///     \rho = \frac{|M^{-1} K \mathbf x - \theta \mathbf x|_M}{|\mathbf x|_M} \f]
///
/// theta is never above the largest eigenvalue, and one lies within rho of it. It counts as converged when rho is a
/// twentieth of theta or less, does not grow, and a dozen iterations have had time to bring up what is stiffer still;
/// sheets take 12 to 16. 0.95 of the step allows for a largest eigenvalue of 1.1 theta. It is likely, and not certain,
/// that none is larger: of 4,000 chains of nine bodies whose masses and springs are random within a factor of 3 or 100,
/// ten had one.
///
/// R. von Mises, H. Pollaczek-Geiringer, ZAMM 9, 58 and 152 (1929).

#include <ansatz/motion/concepts.hpp>
#include <ansatz/world/world.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace ansatz {

namespace detail {
/// Calls `f<Q>()` for each force between bodies that says how stiff it is. `Attraction` does not, as no force of one
/// body does.
template <class W, class F> void for_each_stiff(F&& f) {
    auto one = [&]<class Q>() {
        if constexpr (DifferentiableCouplingIn<Q, typename W::S>) f.template operator()<Q>();
    };
    [&]<class... Q>(Types<Q...>) { (one.template operator()<Q>(), ...); }(typename W::composition::couplings{});
}

/// \f$ y = M^{-1} K x \f$, rows by slot.
template <class W> void apply_stiffness(const W& world, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
    using S = typename W::S;
    constexpr int n = S::dimension;
    const auto weight = world.template lane<InverseMass>();
    y.setZero(x.size());
    detail::for_each_stiff<W>([&]<class Q>() {
        Bound<Q, S>(world.template get<Q>())
            .jacobian(world.template view<Q>(), world.context().template restricted<reads_clock<Q>>(),
                      [&](std::size_t a, std::size_t b, const auto& by_x, const auto&) {
                          using Vec = Eigen::Matrix<double, n, 1>;
                          const Eigen::Matrix<double, n, n> block = -by_x.template cast<double>();
                          const Vec xa = x.segment<n>(Eigen::Index(a) * n);
                          const Vec xb = b < world.size() ? Vec(x.segment<n>(Eigen::Index(b) * n)) : Vec(Vec::Zero());
                          y.segment<n>(Eigen::Index(a) * n) += static_cast<double>(weight[a]) * (block * (xa - xb));
                          if (b < world.size()) // the transpose, where a block is not symmetric
                              y.segment<n>(Eigen::Index(b) * n) +=
                                  static_cast<double>(weight[b]) * (block * xb - block.transpose() * xa);
                      });
    });
}
} // namespace detail

/// What power iteration found.
struct MeasuredStiffness {
    Quantity<unit::FrequencySquared> largest{}; ///< theta, 1/s^2
    bool converged = false;                     ///< whether the vector is nearly one of the ways to swing and stays it
    int iterations = 0;                         ///< that were made
};
/// What it is computed in; kept by those who ask in every step.
struct MeasuredStiffnessScratch {
    Eigen::VectorXd x;                 ///< the vector
    Eigen::VectorXd y;                 ///< what the springs make of it
    std::vector<std::uint32_t> number; ///< of each body: as how many-th the springs name it
};

namespace detail {
/// A number between -1/2 and 1/2 that follows from another by no rule that a spring could know.
inline double scattered(std::uint32_t n) {
    n *= 2654435761u;
    n = (n ^ (n >> 16)) * 0x45d9f3bu;
    return double(n ^ (n >> 16)) / 4294967296.0 - 0.5;
}
/// Where power iteration begins: everywhere a little of everything, so that no way to swing is left out. (Neighbours
/// against each other, which swing fast, is one of many ways, and where it is nearly one of the springs' own but not
/// the fastest, nothing leads away from it.) Bodies are counted as springs name them and not by slots, so that worlds
/// whose bodies slept and woke measure alike.
template <class W> void begin_anywhere(const W& world, MeasuredStiffnessScratch& scratch) {
    using S = typename W::S;
    constexpr int n = S::dimension;
    const auto weight = world.template lane<InverseMass>();
    auto& number = scratch.number;
    number.assign(world.size() + 1, 0);
    std::uint32_t named = 0;
    detail::for_each_stiff<W>([&]<class Q>() {
        Bound<Q, S>(world.template get<Q>())
            .stiffnesses(world.template view<Q>(), [&](std::size_t a, std::size_t b, const auto&, const auto&) {
                if (number[a] == 0) number[a] = ++named;
                if (number[b] == 0) number[b] = ++named;
            });
    });
    scratch.x.resize(Eigen::Index(world.size()) * n);
    for (Eigen::Index i = 0; i < scratch.x.size(); ++i) {
        const auto body = std::size_t(i / n);
        const bool swings = number[body] != 0 && weight[body] > 0;
        scratch.x[i] = swings ? scattered(std::uint32_t(n) * number[body] + std::uint32_t(i % n)) : 0;
    }
}
/// Power iteration from where `scratch.x` begins.
template <class W>
MeasuredStiffness iterate_power(const W& world, int most_iterations, bool until_converged,
                                MeasuredStiffnessScratch& scratch) {
    constexpr int n = W::S::dimension;
    const auto weight = world.template lane<InverseMass>();
    auto &x = scratch.x, &y = scratch.y;
    MeasuredStiffness found;
    double largest = 0, last = std::numeric_limits<double>::infinity();
    while (found.iterations < most_iterations && x.size() > 0 && !(until_converged && found.converged)) {
        const double size = x.norm();
        if (!(size > 0)) break;
        ++found.iterations;
        x /= size;
        apply_stiffness(world, x, y);
        double above = 0, below = 0, square = 0; // in the measure of the masses
        for (Eigen::Index row = 0; row < x.size(); ++row) {
            const double w = static_cast<double>(weight[std::size_t(row / n)]);
            if (!(w > 0)) continue;
            above += x[row] * y[row] / w;
            below += x[row] * x[row] / w;
            square += y[row] * y[row] / w;
        }
        if (!(below > 0)) break;
        const double theta = above / below, rho = std::sqrt(std::max(0.0, square / below - theta * theta));
        largest = std::max(largest, theta);
        const double off = rho / theta;
        found.converged = found.iterations >= 12 && off <= 0.05 && off <= last; // what is stiffer still comes up
        last = off;
        x.swap(y);
    }
    found.largest = largest / (second * second);
    return found;
}
} // namespace detail

/// How stiff the springs of a world are as they are stretched now, in as many iterations as it takes to converge.
/// \param most_iterations of power iteration; each costs about two passes over the springs
/// \param scratch         room
template <class... P>
MeasuredStiffness measured_stiffness(const World<P...>& world, int most_iterations, MeasuredStiffnessScratch& scratch) {
    if constexpr (World<P...>::composition::coupled) {
        detail::begin_anywhere(world, scratch);
        return detail::iterate_power(world, most_iterations, true, scratch);
    } else return {};
}

/// The same after so many iterations, whether it has converged or not: never above the bound, and as close to the truth
/// as they allow. It tells how much the bound is on the safe side.
template <class... P>
Quantity<unit::FrequencySquared> measured_stiffness(const World<P...>& world, int iterations = 1000) {
    using W = World<P...>;
    if constexpr (W::composition::coupled) {
        constexpr int n = W::S::dimension;
        const auto weight = world.template lane<InverseMass>();
        MeasuredStiffnessScratch scratch;
        scratch.x.resize(Eigen::Index(world.size()) * n);
        for (Eigen::Index i = 0; i < scratch.x.size(); ++i) // neighbours against each other swing fastest
            scratch.x[i] =
                weight[std::size_t(i / n)] > 0 ? (i / n % 2 == 0 ? 1.0 : -1.0) + 0.01 * std::sin(double(i)) : 0.0;
        return detail::iterate_power(world, iterations, false, scratch).largest;
    } else return {};
}

} // namespace ansatz
