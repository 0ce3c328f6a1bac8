// SPDX-License-Identifier: BSL-1.0
// A policy outside the library, against the public frame only: a field of columns of water with a state of its own,
// that bodies press and that carries them. What a body displaces rises in the columns around it, so that volume is
// kept.
#pragma once

#include <ansatz/world.hpp>

#include <numeric>
#include <vector>

namespace examples {

using namespace ansatz;

//! [field]
/// How tall a floating block is, and how much area it has seen from above.
struct Tall {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::scalar;
    static constexpr std::string_view name = "tall";
};

struct Pool {
    using role = roles::Force; // it carries bodies, and has systems beside
    static constexpr bool couples_bodies = true;
    using reads = Columns<Position, Velocity, Tall>;
    static constexpr std::string_view name = "Pool";
    double columns = 32, cell = 0.5, depth = 2, area = 0.25, density = 1000, gravity = 9.81, drag = 800;
    static void parameters(auto&, auto&&) {}

    template <class S> struct State {
        std::vector<typename S::Scalar> volume, flow, displaced; // of each column; a flow through each right wall
        static void fields(auto& self, auto&& field) {
            field("volume", self.volume);
            field("flow", self.flow);
            field("displaced", self.displaced);
        }
    };
    std::size_t column_of(double x) const { return std::size_t(std::min(columns - 2, std::max(1.0, x / cell))); }
    template <class StateT> double level(const StateT& kept, std::size_t i) const { // read beside what lies in it
        return 0.5 * (kept.volume[i - 1] + kept.volume[i + 1]) / (cell * cell);
    }
    double under_water(double y, double tall, double surface) const {
        return area * std::min(tall, std::max(0.0, surface - (y - tall / 2)));
    }
    template <class S> struct In {
        const Pool& pool;
        explicit In(const Pool& p) : pool(p) {}
        void couple(auto& view, const auto&) const { // Archimedes, and a drag
            for (std::size_t slot = 0; slot < view.end(Motion::awake); ++slot) {
                const auto x = view.template get<Position>(slot).value();
                const auto sunk = pool.under_water(x[1], view.template get<Tall>(slot).value(),
                                                   pool.level(view.state(), pool.column_of(x[0])));
                const double v = view.template get<Velocity>(slot).value()[1];
                view.add_force(slot,
                               newtons(0, pool.density * pool.gravity * sunk - (sunk > 0 ? pool.drag * v : 0), 0));
            }
        }
    };
    template <class S> struct Waves {
        static constexpr Phase phase = phases::fields;
        static constexpr std::string_view name = "pool: waves";
        using reads = Columns<Position, Tall>;
        const Pool& pool;
        explicit Waves(const Pool& p) : pool(p) {}
        void run(auto& view, const auto& context) const {
            auto& kept = view.state();
            const double dt = context.dt().value();
            std::vector<typename S::Scalar> now(kept.volume.size());
            view.for_each([&](std::size_t slot) {
                const auto x = view.template get<Position>(slot).value();
                const auto i = pool.column_of(x[0]);
                now[i] += pool.under_water(x[1], view.template get<Tall>(slot).value(), pool.level(kept, i));
            });
            for (std::size_t i = 1; i + 1 < now.size(); ++i) { // pressed out to both sides, or sucked in
                const double more = now[i] - kept.displaced[i];
                kept.volume[i - 1] += more / 2;
                kept.volume[i + 1] += more / 2;
            }
            kept.displaced = now;
            for (std::size_t i = 0; i + 1 < now.size(); ++i) // pipes between the columns
                kept.flow[i] = 0.99 * kept.flow[i] +
                               dt * pool.gravity * pool.depth * (kept.volume[i] - kept.volume[i + 1]) / pool.cell;
            for (std::size_t i = 0; i + 1 < now.size(); ++i) {
                kept.volume[i] -= dt * kept.flow[i] / pool.cell;
                kept.volume[i + 1] += dt * kept.flow[i] / pool.cell;
            }
        }
    };
    template <class S> using systems = Types<Waves<S>>;

    template <class W, class C> class Door : public TableDoor<W, Pool> {
    public:
        void fill() {
            this->change("World::fill", [&](auto& kept) {
                const auto n = std::size_t(this->policy().columns);
                kept.volume.assign(n, this->policy().depth * this->policy().cell * this->policy().cell);
                kept.flow.assign(n, 0);
                kept.displaced.assign(n, 0);
            });
        }
        double water() const { // what is there, without what bodies have pressed up
            const auto& kept = this->kept();
            return std::accumulate(kept.volume.begin(), kept.volume.end(), 0.0) -
                   std::accumulate(kept.displaced.begin(), kept.displaced.end(), 0.0);
        }
        double level_at(double x) const { return this->policy().level(this->kept(), this->policy().column_of(x)); }
    };
};
//! [field]

} // namespace examples
