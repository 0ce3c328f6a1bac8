// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What contacts do whose targets contradict each other: no velocity keeps a ball out of a floor and out of the press
/// that comes down on it, and no displacement separates it from both.
///
/// The least motion that meets all targets (contact_pushes.hpp) does not exist then: conjugate gradients push without
/// end, and what they push is thrown away. Here the targets are missed by least squares instead, each in units of its
/// contact's \f$ n_a w_a + n_b w_b \f$: a row of balls between two walls that approach shares out their speed among its
/// contacts. Forces that hold each other grow with the sweeps, and move nothing.
///
/// The method is an accelerated projected gradient, begun anew where a step goes uphill; its step is never longer
/// than 1 / A. (Y. Nesterov, A method of solving a convex programming problem with convergence rate O(1/k^2), 1983; for
/// contacts: H. Mazhar et al., Using Nesterov's Method to Accelerate Multibody Dynamics with Friction and Contact,
/// 2015.)

#include <ansatz/units.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ansatz::detail {

/// What a contact misses of its target, squared, in units of its share; of contacts that push, to be pulled apart is a
/// miss as well.
template <class Push, class Scalar> Scalar missed(Push& p, const Scalar& along) {
    p.residual = along - p.target;
    return p.lambda > Scalar(0) || !(p.residual >= Scalar(0)) ? p.residual / p.share * p.residual : Scalar(0);
}

/// Solves the clusters that are marked as infeasible once more, from where their bodies and pushes started. Those that
/// do not miss less than before, of `Cluster::size`, stay as they are.
/// \param bodies, pushes, clusters those of ContactPushes
/// \param sweeps           half as many sweeps as are made
/// \param root             the cluster of a body, by its place among `bodies`
template <class Bodies, class Pushes, class Clusters, class Root>
void miss_least(Bodies& bodies, Pushes& pushes, Clusters& clusters, int sweeps, const Root& root) {
    using Body = typename Bodies::value_type;
    using Push = typename Pushes::value_type;
    using Cluster = typename Clusters::value_type;
    using Raw = decltype(Body::u);
    using Scalar = decltype(Push::lambda);

    const auto each_body = [&](const auto& what) {
        for (std::uint32_t n = 0; n < bodies.size(); ++n)
            if (bodies[n].count > 0 && bodies[n].weight > Scalar(0) && clusters[root(n)].infeasible) what(bodies[n]);
    };
    const auto each_push = [&](const auto& what) {
        for (auto& p : pushes)
            if (!p.waits && clusters[p.root].infeasible) what(p, clusters[p.root]);
    };
    const auto swap_with_start = [&] {
        each_body([](Body& body) { std::swap(body.u, body.start); });
        each_push([](Push& p, const Cluster&) {
            std::swap(p.lambda, p.start);
            std::swap(p.total, p.start_total);
        });
    };
    const auto along = [&](const Push& p) { return dot(Raw(bodies[p.a].u - bodies[p.b].u), p.normal); };
    const auto push = [&](Push& p, Scalar lambda) {
        const Scalar more = lambda - p.lambda;
        p.lambda = lambda;
        p.total += more;
        bodies[p.a].by += (more * bodies[p.a].weight) * p.normal;
        bodies[p.b].by -= (more * bodies[p.b].weight) * p.normal;
    };
    const auto move = [&] {
        each_body([](Body& body) {
            body.u += body.by;
            body.by = Raw::Zero();
        });
    };

    swap_with_start();
    each_body([](Body& body) { body.by = Raw::Zero(); });
    each_push([](Push& p, Cluster& c) {
        p.step = p.lambda; // the push of the sweep before
        c.count = 0;
    });
    for (std::int64_t sweep = 0; sweep < 2 * std::int64_t(sweeps); ++sweep) {
        each_push([&](Push& p, const Cluster& c) { // nearly as far again as the last sweep went
            const Scalar before = std::exchange(p.step, p.lambda), steps = Scalar(c.count);
            push(p, p.lambda + steps / (steps + Scalar(3)) * (p.lambda - before));
        });
        move();
        for (auto& c : clusters) {
            c.slope = c.mixed = Scalar(0);
            ++c.count;
        }
        each_push([&](Push& p, Cluster& c) {
            p.residual = along(p) - p.target;
            push(p, std::max(p.lambda - p.residual / p.share, Scalar(0)));
            c.slope += p.residual * (p.lambda - p.step);
        });
        move();
        for (auto& c : clusters)
            if (c.slope > Scalar(0)) c.count = 0;
    }
    each_push([&](Push& p, Cluster& c) { c.mixed += missed(p, along(p)); });
    for (auto& c : clusters) c.infeasible = c.infeasible && c.mixed >= c.size;
    swap_with_start();
}

} // namespace ansatz::detail
