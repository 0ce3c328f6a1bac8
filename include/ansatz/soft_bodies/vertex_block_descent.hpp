// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `VertexBlockDescent`: implicit Euler, one body after the other (notes 4).
///
/// The positions at the end of a substep make the energy
/// \f$ G(\mathbf x) = \sum_i \frac{m_i}{2 h^2} |\mathbf x_i - \mathbf y_i|^2 +
/// \sum_c \tfrac12 k_c C_c(\mathbf x)^2 + \text{damping} \f$ least, where y is where forces and velocity alone
/// would take a body.
/// Each body in turn takes one step of Newton's method in its own place, the others standing still; what is left to do
/// after all iterations is left. Never explodes, and needs no multipliers; iterated to the end it is ImplicitEuler,
/// which loses as much energy. It is made for bodies with many constraints each, and a fixed price; on sheets Xpbd
/// comes nearer to the truth. It is at its worst on long chains of stiff springs, along which every iteration carries
/// news by one body. For those take Xpbd with many substeps.
///
/// Curvature that is negative (a spring that is pushed together is unstable across its axis) is left out of the
/// matrices, so that each of them can be solved and each step goes down. A wide constraint, such as the volume of a
/// ball, is linearised once an iteration. Bodies are taken by their slots.
///
/// **Momentum.** Bodies that are moved one by one do not push each other equally hard before all is done: a stiff sheet
/// alone in space would drive itself along. So what hangs together, and on nothing else, is moved as one behind the
/// iterations, to where its energy is least: there its momentum is what forces and velocities make it, to rounding. For
/// constraints that say `static constexpr bool moves_along = true`, being unchanged where all their bodies are moved by
/// the same way; one that does not say so counts as holding its bodies in place. The turning is not kept.
///
/// A. H. Chen, Z. Liu, Y. Yang, C. Yuksel, Vertex Block Descent, SIGGRAPH 2024.

#include <ansatz/core/error.hpp>
#include <ansatz/motion/islands.hpp>
#include <ansatz/soft_bodies/constraint_system.hpp>
#include <ansatz/soft_bodies/module.hpp>

#include <Eigen/Cholesky>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace ansatz {

/// One body after the other.
struct VertexBlockDescent {
    using role = roles::Solver;

    /// Number of substeps of a step; in each, forces are computed, bodies moved and constraints held
    int substeps = 1;
    /// How often each body is moved in a substep
    int iterations = 20;

    static constexpr std::string_view name = "VertexBlockDescent";
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
        using Vec = Vector<Scalar, S::dimension>;
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;

        /// A wide constraint, linearised once an iteration: each body that moves takes its value along.
        struct Wide {
            std::size_t first; // of its gradients
            Scalar value, way; // C, and h times its rate
        };
        /// An island as one body.
        struct Drift {
            Vec moved = Vec::Zero(); // kg m: mass times way, of all its bodies
            Scalar mass{0};          // kg
            bool held = false;       // by something that is not of it
        };
        /// All constraints of a type, and which of them hold the body of a slot: those that `numbers` has from
        /// `first[slot]` up to `first[slot + 1]`, with the place that the body has in each.
        template <class K> struct Of {
            struct Entry {
                std::uint32_t number, place;
            };
            std::vector<K> all;
            std::vector<std::uint32_t> first;
            std::vector<Entry> entries;
            std::vector<Wide> wide;     // of each, if it is a wide one
            std::vector<Vec> gradients; // of all wide ones, body by body
        };
        template <class List> struct Stars;
        template <class... K> struct Stars<Types<K...>> {
            static_assert(
                ((CurvedConstraintIn<K, S> || WideConstraintIn<K, S>)&&...),
                "Ansatz: a constraint that VertexBlockDescent cannot use; it needs, beside what Xpbd asks for, "
                "`Matrix curvature(std::size_t body, x, gradient) const`, as SpringConstraint has");
            std::tuple<Of<K>...> of;
            std::vector<Vec> moved;           // m, by slot: what this substep's iterations have done
            std::vector<std::uint32_t> order; // slots of the bodies that are moved, by their ids
            Islands islands;                  // of slots: what hangs together
            std::vector<Drift> drifts;        // by the slot that stands for an island
        };

    public:
        /// What it keeps between steps: room for the constraints of each body.
        template <class List> using Kept = Stars<List>;

        /// Takes the parameters.
        explicit In(const VertexBlockDescent& descent) : iterations_(descent.iterations) {}

        /// Lessens the energy behind one substep.
        void solve(auto& system, auto& kept) const {
            gather(system, kept);
            kept.moved.reserve(system.room());
            kept.moved.assign(system.awake(), Vec::Zero());
            for (int i = 0; i < iterations_; ++i) {
                each_type(kept, [&](auto& of) { linearise_wide(system, of); });
                for (const auto slot : kept.order) descend(system, kept, slot);
            }
            move_as_one(system, kept);
        }

    private:
        /// Which bodies each constraint holds; in room that it has, once warm.
        static void gather(auto& system, auto& kept) {
            kept.order.clear();
            kept.order.reserve(system.room());
            system.each_by_id([&](std::size_t slot) {
                if (system.weight(slot) > Scalar(0)) kept.order.push_back(std::uint32_t(slot));
            });
            each_type(kept, [&](auto& of) { of.all.clear(); });
            system.each([&]<class K>(const K& constraint) { std::get<Of<K>>(kept.of).all.push_back(constraint); });
            each_type(kept, [&](auto& of) {
                of.first.reserve(system.room() + 1);
                index(of, system.awake());
            });
        }
        template <class K> static void index(Of<K>& of, std::size_t awake) {
            of.first.assign(awake + 1, 0);
            const auto each = [&](const auto& f) {
                for (std::size_t n = 0; n < of.all.size(); ++n)
                    for (std::size_t i = 0; i < detail::bodies_of(of.all[n]); ++i)
                        if (const auto slot = detail::slot_of(of.all[n], i); slot < awake) f(slot, n, i);
            };
            each([&](std::size_t slot, std::size_t, std::size_t) { ++of.first[slot + 1]; });
            for (std::size_t slot = 0; slot < awake; ++slot) of.first[slot + 1] += of.first[slot];
            of.entries.resize(of.first[awake]);
            each([&](std::size_t slot, std::size_t number, std::size_t place) {
                of.entries[of.first[slot]++] = {std::uint32_t(number), std::uint32_t(place)};
            });
            for (std::size_t slot = awake; slot > 0; --slot) of.first[slot] = of.first[slot - 1];
            of.first[0] = 0;
        }
        template <class K> static void linearise_wide(const auto& system, Of<K>& of) {
            if constexpr (WideConstraintIn<K, S>) {
                of.wide.clear();
                std::size_t all = 0;
                for (const K& k : of.all) {
                    of.wide.push_back({all, Scalar(0), Scalar(0)});
                    all += k.count();
                }
                of.gradients.resize(all);
                const auto at = [&](std::size_t slot) -> Vec { return system.position(slot); };
                for (std::size_t n = 0; n < of.all.size(); ++n) {
                    const K& k = of.all[n];
                    const auto gradient = std::span<Vec>(of.gradients).subspan(of.wide[n].first, k.count());
                    of.wide[n].value = k.linearise(at, gradient);
                    for (std::size_t i = 0; i < gradient.size(); ++i)
                        of.wide[n].way += system.h() * gradient[i].dot(system.velocity(k.slot(i)));
                }
            }
        }
        /// Moves each island that hangs on nothing back by how far its centre of mass has come: a push between its own
        /// bodies moves that nowhere.
        static void move_as_one(auto& system, auto& kept) {
            kept.islands.reserve(system.room());
            kept.drifts.reserve(system.room());
            kept.islands.reset(system.awake());
            kept.drifts.assign(system.awake(), Drift());
            each_type(kept, [&](const auto& of) { join(system, of, kept); });
            for (const auto slot : kept.order) {
                auto& drift = kept.drifts[kept.islands.of(slot)];
                const Scalar mass = 1 / system.weight(slot);
                drift.held = drift.held || kept.drifts[slot].held;
                drift.moved += mass * kept.moved[slot];
                drift.mass += mass;
            }
            for (const auto slot : kept.order)
                if (const auto& drift = kept.drifts[kept.islands.of(slot)]; !drift.held)
                    system.move(slot, Vec(-drift.moved / drift.mass));
        }
        template <class K> static void join(const auto& system, const Of<K>& of, auto& kept) {
            for (const K& k : of.all) {
                if (!acts(system, k)) continue;
                const std::size_t none = system.awake();
                std::size_t first = none;
                bool held = !moves_along<K>;
                for (std::size_t i = 0; i < detail::bodies_of(k); ++i) {
                    const auto slot = detail::slot_of(k, i);
                    if (slot >= none || !(system.weight(slot) > Scalar(0))) held = true;
                    else if (first == none) first = slot;
                    else kept.islands.unite(std::uint32_t(first), std::uint32_t(slot));
                }
                if (held && first != none) kept.drifts[first].held = true;
            }
        }
        /// Whether a constraint does anything at all: not a rope that hangs slack.
        template <class K> static bool acts(const auto& system, const K& k) {
            if (!(k.stiffness > Scalar(0)) && !(k.damping > Scalar(0))) return false;
            if constexpr (requires { requires K::one_sided; }) {
                std::array<Vec, K::bodies> x, gradient;
                for (std::size_t i = 0; i < K::bodies; ++i) x[i] = system.position(k.slots[i]);
                return k.linearise(x, gradient) > -rounding_of(x, gradient);
            } else return true;
        }
        /// How much of a constraint's value may be rounding of the places. What a stiff rope is longer under its load
        /// is less than that, so that one which was pulled to its end may come out as short as it may be, or shorter.
        template <std::size_t N>
        static Scalar rounding_of(const std::array<Vec, N>& x, const std::array<Vec, N>& gradient) {
            Scalar sum(0);
            for (std::size_t i = 0; i < N; ++i) sum += gradient[i].cwiseAbs().dot(x[i].cwiseAbs());
            return 2 * std::numeric_limits<Scalar>::epsilon() * sum;
        }
        template <class K> static constexpr bool moves_along = requires { requires K::moves_along; };
        /// A step of Newton's method for one body, the energy taken times h^2.
        static void descend(auto& system, auto& kept, std::size_t slot) {
            const Scalar mass = 1 / system.weight(slot), h = system.h();
            Vec slope = mass * kept.moved[slot];
            Matrix curved = mass * Matrix::Identity();
            bool at_the_end = false; // of a rope
            each_type(kept, [&]<class K>(const Of<K>& of) {
                for (auto n = of.first[slot]; n < of.first[slot + 1]; ++n) {
                    const auto [number, place] = of.entries[n];
                    if constexpr (WideConstraintIn<K, S>)
                        add_wide(of.all[number], of.wide[number], of.gradients[of.wide[number].first + place], h, slope,
                                 curved);
                    else at_the_end = add(system, of.all[number], place, h, slope, curved) || at_the_end;
                }
            });
            Vec by = curved.llt().solve(-slope);
            if (at_the_end) [[unlikely]]
                hold_at_the_end(system, kept, slot, slope, curved, by);
            if (!(by.squaredNorm() < std::numeric_limits<Scalar>::infinity())) return;
            kept.moved[slot] += by;
            system.move(slot, by);
            each_type(kept, [&]<class K>(Of<K>& of) {
                if constexpr (WideConstraintIn<K, S>)
                    for (auto n = of.first[slot]; n < of.first[slot + 1]; ++n) {
                        Wide& wide = of.wide[of.entries[n].number];
                        const Scalar change = of.gradients[wide.first + of.entries[n].place].dot(by);
                        wide.value += change;
                        wide.way += change;
                    }
            });
        }
        template <class K>
        static void add_wide(const K& k, const Wide& wide, const Vec& gradient, Scalar h, Vec& slope, Matrix& curved) {
            const Scalar by_value = h * h * k.stiffness, by_rate = h * k.damping;
            slope += (by_value * wide.value + by_rate * wide.way) * gradient;
            curved += (by_value + by_rate) * gradient * gradient.transpose();
        }
        /// What is one-sided and has come to its end, or is as near to it as rounding can tell, does nothing yet; but
        /// it does where the step would lead beyond. Without it the body would be let go, and caught again by the next
        /// iteration, and the last one might be either.
        [[gnu::cold, gnu::noinline]] static void hold_at_the_end(const auto& system, const auto& kept, std::size_t slot,
                                                                 Vec& slope, Matrix& curved, Vec& by) {
            bool any = false;
            const Vec before = by;
            each_type(kept, [&]<class K>(const Of<K>& of) {
                if constexpr (requires { requires K::one_sided; })
                    for (auto n = of.first[slot]; n < of.first[slot + 1]; ++n) {
                        const auto [number, place] = of.entries[n];
                        any = add(system, of.all[number], place, system.h(), slope, curved, &before) || any;
                    }
            });
            if (any) by = curved.llt().solve(-slope);
        }
        /// Adds what a constraint does to the slope and the curvature of one of its bodies.
        /// \param step null, or a step of the body: then only what is at its end is added, where the step leads beyond
        /// \return without a step, whether it does nothing and is at its end; with one, whether it was added
        template <class K>
        [[gnu::always_inline]] static bool add(const auto& system, const K& k, std::size_t place, Scalar h, Vec& slope,
                                               Matrix& curved, const Vec* step = nullptr) {
            std::array<Vec, K::bodies> x, gradient;
            for (std::size_t i = 0; i < K::bodies; ++i) x[i] = system.position(k.slots[i]);
            const Scalar value = k.linearise(x, gradient);
            Scalar way(0);
            for (std::size_t i = 0; i < K::bodies; ++i) way += h * gradient[i].dot(system.velocity(k.slots[i]));
            const Scalar by_value = h * h * k.stiffness, by_rate = h * k.damping;
            const Scalar pull = by_value * value + by_rate * way;
            if constexpr (K::one_sided) {
                const bool slack = !(value > Scalar(0)), ends = slack && value > -rounding_of(x, gradient);
                if (step == nullptr && (slack || !(pull > Scalar(0)))) return ends;
                if (step != nullptr && !(ends && value + gradient[place].dot(*step) > Scalar(0))) return false;
            }
            slope += pull * gradient[place];
            curved += (by_value + by_rate) * gradient[place] * gradient[place].transpose();
            if (value > Scalar(0)) curved += by_value * value * k.curvature(place, x, gradient);
            return step != nullptr;
        }
        template <class Kept_, class F> static void each_type(Kept_& kept, F&& f) {
            std::apply([&](auto&... of) { (f(of), ...); }, kept.of);
        }

        int iterations_;
    };
};

} // namespace ansatz
