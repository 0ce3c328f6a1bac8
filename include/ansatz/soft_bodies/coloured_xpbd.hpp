// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ColouredXpbd`: XPBD that holds many springs at once (notes 4).
///
/// Use it in place of Xpbd for sheets of many springs, on one thread or several: the same formula for each constraint
/// in another order, by colours (spring_colours.hpp), so that square roots and divisions of springs are done together
/// by whatever vector units there are. It comes to the same bits with any of them, and with none; they are others than
/// Xpbd's, since each constraint sees what those before it did. Along a rope the order of Xpbd is better than colours:
/// there news runs from end to end in one iteration.
///
/// What are no springs between two bodies (anchored ones, hinges, fillings, constraints of yours) are held one after
/// the other behind them, as by Xpbd.
///
/// M. Fratarcangeli, V. Tibaldo, F. Pellacini, Vivace: a Practical Gauss-Seidel Method for Stable Soft Body Dynamics,
/// SIGGRAPH Asia 2016, for colours.

#include <ansatz/soft_bodies/spring_colours.hpp>
#include <ansatz/soft_bodies/xpbd.hpp>
#include <ansatz/springs/constraint.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace ansatz {

/// Extended position based dynamics, many springs at once.
struct ColouredXpbd {
    using role = roles::Solver;

    /// Number of substeps of a step; in each, forces are computed, bodies moved and constraints held
    int substeps = 10;
    /// Number of sweeps over all constraints in a substep
    int iterations = 1;

    static constexpr std::string_view name = "ColouredXpbd";
    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) {
        visit("substeps", self.substeps);
        visit("iterations", self.iterations);
    }
    /// Refuses fewer than one of them.
    void check() const {
        if (substeps < 1) refuse_value(name, "substeps", substeps, "it is at least 1");
        if (iterations < 1) refuse_value(name, "iterations", iterations, "it is at least 1");
    }

    /// Bound to a space.
    template <class S> class In {
        using Scalar = typename S::Scalar;
        using Four = typename HeldBody<S>::Four;
        using Numbers = Eigen::Array<Scalar, 4, 1>;
        using OneByOne = typename Xpbd::template In<S>;
        template <class Q> using SpringsOf = typename Q::template In<S>;

        /// The springs of a network, and the multipliers of each.
        struct Network {
            SpringColours<Scalar> springs;
            std::vector<Scalar> multipliers;
        };
        struct Room {
            std::array<Network, 2> networks; // Springs and Ropes
            typename OneByOne::template Kept<Types<>> others;
            std::vector<Scalar> multipliers; // of the others
        };

    public:
        /// What it keeps between steps: room, and the colours.
        template <class> using Kept = Room;

        /// Takes the parameters.
        explicit In(const ColouredXpbd& xpbd) : iterations_(xpbd.iterations) {}

        /// Holds all constraints behind one substep.
        void solve(auto& system, Room& room) const {
            std::size_t networks = 0;
            system.each_policy([&](const auto& policy, const auto& view) {
                if constexpr (requires { policy.network(view); }) {
                    Network& network = room.networks[networks++];
                    network.springs.colour(policy.network(view), system.bodies().size(), system.room());
                    network.multipliers.assign(network.springs.size(), Scalar(0));
                }
            });
            room.multipliers.clear();
            for (int i = 0; i < iterations_; ++i) {
                networks = 0;
                std::size_t next = 0;
                system.each_policy([&]<class Q>(const Q& policy, const auto& view) {
                    const auto one = [&](const auto& constraint) {
                        if (next == room.multipliers.size()) room.multipliers.push_back(Scalar(0));
                        auto& multiplier = room.multipliers[next++];
                        multiplier = OneByOne::hold_one(system, room.others, constraint, multiplier);
                    };
                    if constexpr (requires { policy.network(view); }) {
                        hold_springs<Q::pulls_only>(system, room.networks[networks++]);
                        policy.hung_constraints(view, one);
                    } else policy.constraints(view, one);
                });
            }
        }

    private:
        /// So many are taken at once: enough to fill vector units, few enough to stay in the nearest cache.
        static constexpr std::size_t chunk = 64;
        struct Chunk {
            alignas(64) std::array<Four, chunk> apart;     // x_b - x_a, m
            alignas(64) std::array<Four, chunk> going;     // v_b - v_a, m/s
            alignas(64) std::array<Scalar, chunk> squared; // |x_b - x_a|^2
            alignas(64) std::array<Scalar, chunk> weight;  // w_a + w_b, 1/kg
            alignas(64) std::array<Scalar, chunk> before;  // the multiplier, N s^2
            alignas(64) std::array<Scalar, chunk> by;      // the change of the multiplier, by the length, N s^2 / m
        };

        /// A four to calculate with. Written as loops over its numbers the same was put together from single ones, and
        /// took half as long again, where vector units hold more than a four.
        static auto all(auto& four) {
            constexpr bool read_only = std::is_const_v<std::remove_reference_t<decltype(four)>>;
            return Eigen::Map<std::conditional_t<read_only, const Numbers, Numbers>>(four.data());
        }
        template <bool PullsOnly> static void hold_springs(auto& system, Network& network) {
            const auto& springs = network.springs;
            Chunk kept;
            for (std::size_t colour = 0; colour <= SpringColours<Scalar>::most; ++colour) {
                // Those without a colour may hold the same bodies, and are taken one by one.
                const std::size_t step = colour < SpringColours<Scalar>::most ? chunk : 1, end = springs.end(colour);
                for (std::size_t n = springs.begin(colour); n < end; n += step)
                    hold_chunk<PullsOnly>(system, network, n, std::min(step, end - n), kept);
            }
        }
        template <bool PullsOnly>
        [[gnu::flatten]] static void hold_chunk(auto& system, Network& network, std::size_t first, std::size_t count,
                                                Chunk& kept) {
            auto* bodies = system.bodies().data();
            const auto* a = network.springs.a.data() + first;
            const auto* b = network.springs.b.data() + first;
            for (std::size_t n = 0; n < count; ++n) {
                const auto &from = bodies[a[n]], &to = bodies[b[n]];
                all(kept.apart[n]) = all(to.x) - all(from.x);
                all(kept.going[n]) = all(to.v) - all(from.v);
                kept.weight[n] = to.v[3] + from.v[3];
            }
            answer<PullsOnly>(kept, count, system.h(), network.springs.rest.data() + first,
                              network.springs.stiffness.data() + first, network.springs.damping.data() + first,
                              network.multipliers.data() + first);
            const Scalar rate = 1 / system.h();
            for (std::size_t n = 0; n < count; ++n) {
                if (!detail::squares_well(kept.squared[n])) [[unlikely]] {
                    answer_by_scaling<PullsOnly>(kept, n, system.h(), network, first + n);
                }
                auto &from = bodies[a[n]], &to = bodies[b[n]];
                const Numbers way_a = all(kept.apart[n]) * (-from.v[3] * kept.by[n]);
                const Numbers way_b = all(kept.apart[n]) * (to.v[3] * kept.by[n]);
                all(from.x) += way_a;
                all(from.v) += rate * way_a;
                all(to.x) += way_b;
                all(to.v) += rate * way_b;
            }
        }
        /// What each spring of a chunk does: Xpbd's formula in a loop without branches.
        template <bool PullsOnly>
        static void answer(Chunk& kept, std::size_t count, Scalar h, const Scalar* __restrict rest,
                           const Scalar* __restrict stiffness, const Scalar* __restrict damping,
                           Scalar* __restrict multiplier) {
            using std::sqrt;
            for (std::size_t n = 0; n < count; ++n) {
                const Four &x = kept.apart[n], &v = kept.going[n];
                kept.squared[n] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
                kept.by[n] = x[0] * v[0] + x[1] * v[1] + x[2] * v[2];
            }
            for (std::size_t n = 0; n < count; ++n) {
                const Scalar length = sqrt(kept.squared[n]), per_length = 1 / length;
                const Scalar by_value = h * h * stiffness[n], by_rate = h * damping[n];
                const Scalar before = multiplier[n], value = length - rest[n];
                kept.before[n] = before;
                Scalar next = before - (before + by_value * value + by_rate * (h * (kept.by[n] * per_length))) /
                                           (1 + (by_value + by_rate) * kept.weight[n]);
                if constexpr (PullsOnly) {
                    const bool slack = next > Scalar(0) || (before == Scalar(0) && !(value > Scalar(0)));
                    next = slack ? Scalar(0) : next;
                }
                kept.by[n] = (next - before) * per_length;
                multiplier[n] = next;
            }
        }
        /// The same for ends so near or so far apart that the square of their distance is none.
        template <bool PullsOnly>
        [[gnu::cold, gnu::noinline]] static void answer_by_scaling(Chunk& kept, std::size_t n, Scalar h,
                                                                   Network& network, std::size_t which) {
            using Vec = Vector<Scalar, S::dimension>;
            Vec to, axis, way;
            for (int k = 0; k < S::dimension; ++k) {
                to[k] = kept.apart[n][std::size_t(k)];
                way[k] = kept.going[n][std::size_t(k)];
            }
            const Scalar length = detail::axis_by_scaling<S>(to, axis);
            const auto& springs = network.springs;
            const Scalar by_value = h * h * springs.stiffness[which], by_rate = h * springs.damping[which];
            const Scalar before = kept.before[n], value = length - springs.rest[which];
            Scalar next = before - (before + by_value * value + by_rate * (h * axis.dot(way))) /
                                       (1 + (by_value + by_rate) * kept.weight[n]);
            if (PullsOnly && (next > Scalar(0) || (before == Scalar(0) && !(value > Scalar(0))))) next = Scalar(0);
            for (int k = 0; k < S::dimension; ++k) kept.apart[n][std::size_t(k)] = axis[k];
            kept.by[n] = next - before;
            network.multipliers[which] = next;
        }

        int iterations_;
    };
};

} // namespace ansatz
