// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `modules::Water`: what a world has because there is water in it. It comes with the role Field, and its members of
/// `World` are those of `WaterDoor`. The water moves behind the bodies, at phases::fields.

#include <ansatz/motion/gravity.hpp>
#include <ansatz/motion/module.hpp>
#include <ansatz/water/pools.hpp>

#include <cmath>
#include <limits>

namespace ansatz {

template <class Beyond> struct StepLimit; // springs/step_limit.hpp
struct Refuse;

namespace detail {

template <class P> struct IsPools : std::bool_constant<PlaysRole<P, roles::Field>> {};

/// What follows from a list of policies for its water.
template <class... P> struct WaterFacts {
    using pools = filter<IsPools, P...>; ///< the kinds of pools
};

/// The downward part of the world's gravity, m/s^2; nothing where it does not pull downwards: water has no weight then.
template <class C, class Policies> double weight_of_water(const Policies& policies) {
    const auto g = C::S::convert("Gravity::acceleration", std::get<Gravity>(policies).acceleration);
    const double down = -static_cast<double>(g.value()[1]);
    return down > 0 ? down : 0.0;
}
/// Calls `f(table, policy)` for the pools of each kind.
template <class C, class Data, class F> void each_kind_of_pools(Data& data, F&& f) {
    [&]<class... Q>(Types<Q...>) { (f(data.template state<Q>(), std::type_identity<Q>{}), ...); }(typename C::pools{});
}
/// Every pool weighs what the world's gravity says.
template <class C, class Data, class Policies> void weigh_water(Data& data, const Policies& policies) {
    const double gravity = weight_of_water<C>(policies);
    each_kind_of_pools<C>(data, [&](auto& table, auto) {
        table.for_each([&](std::uint32_t, auto& row) { SurfaceLanes::set_gravity(*row.surface, gravity); });
    });
}
/// The longest step that all pools take, s.
template <class C, class Data, class Policies>
Quantity<unit::Time> longest_step_of_water(const Data& data, const Policies& policies) {
    const double gravity = weight_of_water<C>(policies);
    auto longest = std::numeric_limits<double>::infinity() * second;
    each_kind_of_pools<C>(data, [&](const auto& table, auto) {
        table.for_each([&](std::uint32_t, const auto& row) {
            const auto one = SurfaceLanes::longest_step(*row.surface, gravity);
            if (one < longest) longest = one;
        });
    });
    return longest;
}

template <class Control> inline constexpr bool control_divides = true;
template <> inline constexpr bool control_divides<StepLimit<Refuse>> = false;
/// Whether a step that is too long for the water is taken in parts.
template <class C> constexpr bool divides_for_water() {
    if constexpr (C::controlled) return control_divides<typename FirstIn<typename C::controls>::type>;
    else return false;
}

/// The water moves.
struct MoveWater {
    static constexpr Phase phase = phases::fields;
    static constexpr std::string_view name = "water";
    template <class StepT> static void run(StepT& step) {
        using C = typename StepT::Composition_;
        const auto dt = static_cast<double>(step.context.dt().value()) * second;
        double parts = 1;
        if constexpr (divides_for_water<C>())
            parts = std::max(1.0, std::ceil(double(dt / longest_step_of_water<C>(step.data, step.policies))));
        each_kind_of_pools<C>(step.data, [&](auto& table, auto) {
            table.for_each([&](std::uint32_t, auto& row) {
                for (double i = 0; i < parts; ++i) SurfaceLanes::advance(*row.surface, dt / parts);
            });
        });
    }
};

template <class... P> struct WaterCounts {
    static constexpr bool weighs = (std::same_as<P, Gravity> || ...);
    static constexpr bool ok = weighs;
};
template <class... P> struct CheckWaterCounts {
    static_assert(WaterCounts<P...>::weighs,
                  "Ansatz: World has water and no Gravity; the weight of water is that of the world, so add Gravity{}");
};
template <class P, class S> struct PoolsFacts {
    template <class Policy> static constexpr bool is_surface() {
        if constexpr (SurfacePolicyIn<Policy, typename S::Scalar> && SurfacePolicyIn<Policy, double>)
            return NamesFields<Policy>;
        else return false;
    }
    static constexpr bool moved = is_surface<typename P::surface>();
    static constexpr bool ok = moved;
};
template <class P, class S> struct CheckPools {
    static_assert(PoolsFacts<P, S>::moved,
                  "Ansatz: Pools of something that moves no surface, or does not say what it consists of; take "
                  "Pools<WaterColumns>, Pools<Pipes>, or a policy of your own with State, In and `static void "
                  "fields(auto& self, auto&& field)` for its parameters");
};

} // namespace detail

/// The members of `World` that ask its water.
template <class W, class C> class WaterDoor {
public:
    /// A pool, to be asked: `world.water(pool).level(x, z)`.
    /// \throws std::out_of_range for a stale handle
    template <class Policy> WaterView<Policy, typename C::S::Scalar> water(PoolHandle<Policy> pool) const {
        const auto& table = static_cast<const W&>(*this).template elements<Pool<Policy>>();
        return WaterView<Policy, typename C::S::Scalar>(table.row(table.id(pool, "World::water")));
    }
    /// Pours water into the column that stands there, or takes some out of it.
    /// \param x,z    m
    /// \param volume m^3, finite; negative to take out, no more than there is
    /// \throws std::out_of_range for a stale handle or where no column stands, std::invalid_argument for another
    ///         volume; the water is then as it was
    template <class Policy>
    void pour(PoolHandle<Policy> pool, Quantity<unit::Length> x, Quantity<unit::Length> z,
              Quantity<unit::Volume> volume) {
        auto& world = static_cast<W&>(*this);
        const auto& table = std::as_const(world).template elements<Pool<Policy>>();
        const auto id = table.id(pool, "World::pour");
        require_finite("World::pour", "volume", volume);
        const auto& surface = *table.row(id).surface;
        const auto n = surface.grid().column(x, z);
        const auto footprint = surface.grid().footprint(n % surface.grid().columns_x(), n / surface.grid().columns_x());
        using Scalar = typename C::S::Scalar;
        const auto there = surface.heights()[n];
        const auto then = there + Scalar((volume / footprint).value());
        if (!is_finite(then) || then < Scalar(0))
            refuse_value("World::pour", "volume", volume,
                         detail::joined({"a column holds no less than nothing, and this one holds ",
                                         describe(static_cast<double>(there) * footprint * metre)}));
        detail::Key::get_ready(world, "World::pour");
        const auto inside = detail::Key::inside(world);
        inside.template tell<hook::BeforeChange<>>();
        auto& row = inside.data.template state<Pools<Policy>>().row(id);
        detail::SurfaceLanes::of(*row.surface).height[n] = then;
    }
    /// The longest step that all pools take as they are, s; infinite where none limits it.
    Quantity<unit::Time> longest_step_of_water() const {
        const auto inside = detail::Key::inside(static_cast<const W&>(*this));
        return detail::longest_step_of_water<C>(inside.data, inside.policies);
    }
};

namespace modules {

/// There is water.
struct Water {
    /// \cond members: the table of world/modules.hpp says what they are
    static constexpr int layer = 3;
    using stands_on = Types<Motion>;

    template <class... P> using Facts = detail::WaterFacts<P...>;
    template <class... P> using Counts = detail::WaterCounts<P...>;
    template <class... P> using CheckCounts = detail::CheckWaterCounts<P...>;
    template <class P, class S> using FactsOf = detail::PoolsFacts<P, S>;
    template <class P, class S> using SentencesOf = detail::CheckPools<P, S>;
    template <class P, class S> using needs = reads_of<P>;
    template <class W, class C> using Door = WaterDoor<W, C>;
    template <class C> using systems = Types<detail::MoveWater>;

    template <class I, class Given>
    static void on(hook::CheckStep, const I& inside, const typename I::S::Time& dt, const Given& given) {
        using C = typename I::Composition_;
        const auto longest = detail::longest_step_of_water<C>(inside.data, inside.policies);
        detail::weigh_water<C>(inside.data, inside.policies);
        if constexpr (!detail::divides_for_water<C>())
            if (!(static_cast<double>(dt.value()) * second <= longest))
                refuse_value("World::step", "dt", given,
                             detail::joined({"the longest step that the pools of this world take is ",
                                             describe(longest), " (Courant's limit)"}));
    }
    /// \endcond
};

} // namespace modules
} // namespace ansatz
