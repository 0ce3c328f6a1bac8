// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How bodies and the pools of a world meet: the water around a body, and what bodies press up.
///
/// For modules::Water, and for a model of your own beside Buoyancy. The pool of a body is the one that covers
/// its position; where two do, the higher. What a body displaces is added to the columns of its ring and taken out of
/// those of the step before, the sum of all bodies for each column, in the order of their ids.

#include <ansatz/water/floating.hpp>
#include <ansatz/water/pools.hpp>
#include <ansatz/world/types.hpp>

#include <algorithm>

namespace ansatz::detail {

/// Calls `f(table, policy)` for the pools of each kind.
template <class C, class Data, class F> void each_kind_of_pools(Data& data, F&& f) {
    [&]<class... Q>(Types<Q...>) { (f(data.template state<Q>(), std::type_identity<Q>{}), ...); }(typename C::pools{});
}
/// A number for a kind of pools that does not depend on the order of policies (FNV-1a).
constexpr std::uint32_t kind_number(std::string_view name) {
    std::uint32_t hash = 2166136261u;
    for (const char c : name) hash = (hash ^ std::uint8_t(c)) * 16777619u;
    return hash;
}

/// How much a column counts in a ring: over a bed by its depth, up to a fraction of the body's height.
template <class Policy, class Scalar> struct WetColumns {
    const Surface<Policy, Scalar>& surface;
    double deep;
    double operator()([[maybe_unused]] std::size_t n) const {
        if constexpr (Policy::has_bed) {
            const double h = static_cast<double>(surface.heights()[n]);
            return h > deep ? 1.0 : h > 0 ? h / deep : 0.0;
        } else return 1;
    }
};

/// How fast the surface of a column rises, m/s.
template <class Policy, class Scalar>
Scalar rise_of(const Surface<Policy, Scalar>& surface, std::size_t n, std::size_t i, std::size_t j) {
    const auto& state = surface.state();
    const auto& grid = surface.grid();
    const std::size_t nx = grid.columns_x();
    const Scalar dx(grid.x().width(i)), dz(grid.z().width(j));
    if constexpr (requires { state.rate; }) return state.rate[n];
    else if constexpr (requires { state.flow_x; })
        return ((i > 0 ? state.flow_x[n - 1] : Scalar(0)) - state.flow_x[n] +
                (j > 0 ? state.flow_z[n - nx] : Scalar(0)) - state.flow_z[n]) /
               (dx * dz);
    else if constexpr (requires { state.momentum_x; }) {
        const bool west = i > 0, east = i + 1 < nx, south = j > 0, north = j + 1 < grid.columns_z();
        auto mean = [&](bool there, const Scalar& here, const Scalar& other) {
            return there ? (here + other) / Scalar(2) : Scalar(0); // nothing passes a wall
        };
        const auto &hu = state.momentum_x, &hw = state.momentum_z;
        return (mean(west, hu[n], west ? hu[n - 1] : hu[n]) - mean(east, hu[n], east ? hu[n + 1] : hu[n])) / dx +
               (mean(south, hw[n], south ? hw[n - nx] : hw[n]) - mean(north, hw[n], north ? hw[n + nx] : hw[n])) / dz;
    } else return Scalar(0);
}

/// One pool as one body sees it.
template <class S, class Policy> class PoolAround {
public:
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;
    using Pool_ = PoolRow<Policy, Scalar>;
    using Wet = WetColumns<Policy, Scalar>;

    PoolAround(const Pool_& pool, const FloatingRow<S>& body, const Vec& at, double gravity)
        : pool_(pool),
          grid_(pool.surface->grid()),
          wet_{*pool.surface, 0.2 * static_cast<double>(body.below())},
          presses_(body.presses),
          spring_(body.model == LiftBy::spring) {
        water_.density = pool.density;
        water_.weight = pool.density * Scalar(gravity);
        if constexpr (S::dimension == 2) water_.width = Scalar(grid_.z().length());
        foot_ = body.footprint(at, water_);
        if constexpr (S::dimension == 2) foot_.z = 0.5 * (grid_.z().begin() + grid_.z().end());
        const auto &x = grid_.x(), &z = grid_.z();
        covered_ = x.covers(foot_.x) && z.covers(foot_.z) && 2 * foot_.half_x <= x.end() - x.begin() &&
                   2 * foot_.half_z <= z.end() - z.begin();
    }
    /// Whether the body's position is over the pool, and the pool is as wide as the body.
    bool covered() const { return covered_; }
    WaterRing<Wet> ring() const { return {grid_, foot_, wet_}; }
    /// Level, slope and flow in the ring.
    /// \param own what the body itself has pressed up there, m^3
    WaterBeside<Scalar> look(const Scalar& own) const {
        auto water = water_;
        if (!covered_) return water;
        // Heights over that of one column, so that the mean of a flat surface is that surface, to the bit.
        const Scalar from = level(grid_.column(foot_.x * metre, foot_.z * metre));
        Moments sums;
        const WaterRing<Wet> ring(grid_, foot_, wet_, [&](std::size_t n, std::size_t i, std::size_t j, double weight) {
            const Scalar w(weight), h = level(n) - from, x(grid_.x().centre(i) - foot_.x),
                                    z(grid_.z().centre(j) - foot_.z);
            sums.add(w, h, x, z);
            sums.depth += w * pool_.surface->heights()[n];
            add_flow(water, n, i, j, w);
        });
        if (!ring.wet()) return water_;
        const Scalar by = Scalar(1) / Scalar(ring.total());
        water.wet = true;
        const Scalar feedback(ring.feedback());
        // A spring has no end to what it displaces: where the water rises as fast as it is pressed up, there is no
        // level at which both come to rest, and within a hundredth of that a level far above the pool.
        if (spring_ && presses_ && ring.feedback() * ring.room() * foot_.section > 0.99) return water_;
        water.level = from + by * sums.h;
        water.bed = water.level - by * sums.depth;
        water.level -= feedback * own;
        water.feedback = presses_ ? feedback : Scalar(0);
        water.room = Scalar(ring.room());
        for (Scalar* flow : {&water.u, &water.rise, &water.w}) *flow *= by;
        sums.slopes(by, water);
        return water;
    }

private:
    /// Of the plane that fits the ring best.
    struct Moments {
        Scalar h{}, x{}, z{}, xx{}, xz{}, zz{}, hx{}, hz{}, depth{};
        void add(const Scalar& weight, const Scalar& height, const Scalar& at_x, const Scalar& at_z) {
            const Scalar wx = weight * at_x, wz = weight * at_z;
            h += weight * height;
            x += wx;
            z += wz;
            xx += wx * at_x;
            xz += wx * at_z;
            zz += wz * at_z;
            hx += wx * height;
            hz += wz * height;
        }
        void slopes(const Scalar& by, WaterBeside<Scalar>& water) const {
            const Scalar mx = by * x, mz = by * z, vxx = by * xx - mx * mx, vxz = by * xz - mx * mz,
                         vzz = by * zz - mz * mz, vhx = by * hx - by * h * mx, vhz = by * hz - by * h * mz;
            const Scalar determinant = vxx * vzz - vxz * vxz;
            if (determinant > Scalar(1e-4) * vxx * vzz) {
                water.slope_x = (vhx * vzz - vhz * vxz) / determinant;
                water.slope_z = (vhz * vxx - vhx * vxz) / determinant;
            } else if (vxx > Scalar(0)) water.slope_x = vhx / vxx; // a channel
        }
    };
    Scalar level(std::size_t n) const {
        const auto& state = pool_.surface->state();
        if constexpr (Policy::has_bed) return state.bed[n] + state.height[n];
        else return state.height[n];
    }
    void add_flow(WaterBeside<Scalar>& water, std::size_t n, std::size_t i, std::size_t j, const Scalar& weight) const {
        const auto& surface = *pool_.surface;
        water.rise += weight * rise_of(surface, n, i, j);
        if constexpr (requires { surface.velocity(0, 0); }) {
            const auto u = surface.velocity(i, j).value();
            water.u += weight * u[0];
            water.w += weight * u[1];
        }
    }
    const Pool_& pool_;
    const ColumnGrid& grid_;
    Wet wet_;
    WaterBeside<Scalar> water_;
    Footprint foot_;
    bool presses_, spring_, covered_ = false;
};

/// Where a body is, raw.
template <class C> auto where_is(const auto& data, BodyId body) {
    return data.lanes.template get<Position>(data.bodies.slot_of_id(body.id)).value();
}
/// The water around a body.
template <class C, class Data>
auto water_beside(const Data& data, const FloatingRow<typename C::S>& body, double gravity) {
    using Scalar = typename C::S::Scalar;
    const auto at = where_is<C>(data, body.body);
    WaterBeside<Scalar> best;
    each_kind_of_pools<C>(data, [&]<class Q>(const auto& pools, std::type_identity<Q>) {
        const auto kind = kind_number(Q::name);
        pools.for_each([&](std::uint32_t id, const auto& pool) {
            const bool there = pool.begun && body.kind == kind && body.pool == id;
            auto one = PoolAround<typename C::S, typename Q::surface>(pool, body, at, gravity)
                           .look(there ? body.displaced : Scalar(0));
            one.kind = kind;
            one.pool = id;
            const bool before =
                !best.wet || one.level > best.level ||
                (one.level == best.level && std::pair(one.kind, one.pool) < std::pair(best.kind, best.pool));
            if (one.wet && before) best = one;
        });
    });
    return best;
}
/// Refreshes what forces see of the water.
template <class C, class Data> void look_at_water(Data& data, double gravity) {
    data.template state<typename C::buoyancy>().for_each(
        [&](std::uint32_t, auto& body) { body.beside = water_beside<C>(data, body, gravity); });
}

/// Notes what one body presses up in its pool now; a spring that is too deep breaks.
template <class C, class Data> void press_one(Data& data, FloatingRow<typename C::S>& body, double gravity) {
    using S = typename C::S;
    using Scalar = typename S::Scalar;
    const auto water = body.beside = water_beside<C>(data, body, gravity);
    body.displaced = Scalar(0);
    body.kind = water.kind;
    body.pool = water.pool;
    if (!water.wet) return;
    const auto slot = data.bodies.slot_of_id(body.body.id);
    const auto at = data.lanes.template get<Position>(slot).value();
    const Scalar depth = water.level - at[1], inverse_mass = data.lanes.template get<InverseMass>(slot).value();
    auto now = body.settled(depth, inverse_mass);
    if (body.model == LiftBy::spring && depth + body.raised(now) > body.size[2]) {
        body.broken = true;
        now = {};
    }
    if (!body.presses) return;
    body.displaced = water.room * now.volume;
    each_kind_of_pools<C>(data, [&]<class Q>(auto& pools, std::type_identity<Q>) {
        if (kind_number(Q::name) != water.kind) return;
        auto& pool = pools.row(water.pool);
        const PoolAround<S, typename Q::surface> around(pool, body, at, gravity);
        const auto ring = around.ring();
        ring.each_with_area([&](std::size_t n, double share, double area) {
            pool.pressing.value[n] += body.displaced * Scalar(share / area);
        });
        pool.next_rows.add(ring.begin_row(), ring.end_row());
    });
}
/// What bodies displace rises around them, and falls where they have left. Over a bed a column gives no more than it
/// has; what it owes stays noted, and is given later.
template <class C, class Data> void press_water(Data& data, double gravity) {
    using Scalar = typename C::S::Scalar;
    each_kind_of_pools<C>(data, [&](auto& pools, auto) {
        pools.for_each([&](std::uint32_t, auto& pool) {
            pool.rows.each(pool.surface->grid(), [&](std::size_t n) { pool.pressing.value[n] = Scalar(0); });
            pool.next_rows = {};
        });
    });
    data.template state<typename C::buoyancy>().for_each(
        [&](std::uint32_t, auto& body) { press_one<C>(data, body, gravity); });
    each_kind_of_pools<C>(data, [&]<class Q>(auto& pools, std::type_identity<Q>) {
        pools.for_each([&](std::uint32_t, auto& pool) {
            auto& height = SurfaceLanes::of(*pool.surface).height;
            bool owes = false;
            auto both = pool.rows;
            both.add(pool.next_rows.begin, pool.next_rows.end);
            both.each(pool.surface->grid(), [&](std::size_t n) {
                const Scalar more = pool.pressing.value[n] - pool.pressed[n];
                if (more == Scalar(0)) return;
                if (Q::surface::has_bed && height[n] + more < Scalar(0)) {
                    owes = true;
                    pool.pressed[n] -= height[n];
                    height[n] = Scalar(0);
                } else {
                    height[n] += more;
                    pool.pressed[n] = pool.pressing.value[n];
                }
            });
            pool.rows = owes ? both : pool.next_rows;
            pool.begun = true;
        });
    });
}

} // namespace ansatz::detail
