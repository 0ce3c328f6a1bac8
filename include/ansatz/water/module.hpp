// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `modules::Water`: what a world has because there is water in it. It comes with the role Field, and its members of
/// `World` are those of `WaterDoor`. The water moves behind the bodies, at phases::fields.

#include <ansatz/motion/gravity.hpp>
#include <ansatz/motion/module.hpp>
#include <ansatz/water/bodies_in_water.hpp>
#include <ansatz/water/buoyancy.hpp>
#include <ansatz/water/pools.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace ansatz {

template <class Beyond> struct StepLimit; // springs/step_limit.hpp
struct Refuse;

namespace detail {

template <class P> struct IsPools : std::bool_constant < PlaysRole<P, roles::Field>&& requires {
    typename P::surface;
} > {};
template <class P> struct IsBuoyancy : std::bool_constant<PlaysRole<P, roles::Buoyancy>> {};

/// What follows from a list of policies for its water.
template <class... P> struct WaterFacts {
    using pools = filter<IsPools, P...>;                                    ///< the kinds of pools
    using buoyancy = typename OrElse<void, filter<IsBuoyancy, P...>>::type; ///< what carries bodies; void if nothing
    static constexpr bool floats = !std::is_void_v<buoyancy>;               ///< whether something does
};

/// The downward part of the world's gravity, m/s^2; nothing where it does not pull downwards: water has no weight then.
template <class C, class Policies> double weight_of_water(const Policies& policies) {
    const auto g = C::S::convert("Gravity::acceleration", std::get<Gravity>(policies).acceleration);
    const double down = -static_cast<double>(g.value()[1]);
    return down > 0 ? down : 0.0;
}
/// Every pool weighs what the world's gravity says.
template <class C, class Data, class Policies> void weigh_water(Data& data, const Policies& policies) {
    const double gravity = weight_of_water<C>(policies);
    each_kind_of_pools<C>(data, [&](auto& table, auto) {
        table.for_each([&](std::uint32_t, auto& row) {
            SurfaceLanes::set_gravity(*row.surface, gravity);
            if constexpr (C::floats) row.pressing.value.resize(row.pressed.size()); // here, so that no step allocates
        });
    });
}
/// The longest step that all pools take, s, as a number of the world's scalar: rounded down.
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
    using Scalar = typename C::S::Scalar;
    if constexpr (std::is_same_v<Scalar, float>) {
        const auto near = static_cast<Scalar>(longest.value());
        const bool above = static_cast<double>(near) > longest.value();
        return static_cast<double>(above ? std::nextafter(near, Scalar(0)) : near) * second;
    } else return longest;
}

template <class Control> inline constexpr bool control_divides = true;
template <> inline constexpr bool control_divides<StepLimit<Refuse>> = false;
/// Whether a step that is too long for the water is taken in substeps.
template <class C> constexpr bool divides_for_water() {
    if constexpr (C::controlled) return control_divides<typename FirstIn<typename C::controls>::type>;
    else return false;
}
/// In how many substeps at most.
template <class C, class Policies> double most_parts_of_water(const Policies& policies) {
    const auto& control = std::get<typename FirstIn<typename C::controls>::type>(policies);
    if constexpr (requires { control.most_parts; }) return double(control.most_parts);
    else return 1e6;
}

/// \param substeps the number that the step may be divided into
[[noreturn, gnu::cold, gnu::noinline]] inline void
refuse_step_of_water(const auto& given, const Quantity<unit::Time>& longest, double substeps) {
    refuse_value(
        "World::step", "dt", given,
        joined({"the longest step that the pools of this world take is ", describe(longest), " (Courant's limit)",
                substeps > 1 ? ", and it is divided into " + describe(substeps) + " substeps at most" : ""}));
}
/// A step of a pool in equal substeps, and in more of them from where its water has become so fast that they are too
/// long: what runs down a hill is slow at first.
template <class S> void move_in_substeps(S& surface, Quantity<unit::Time> dt, double substeps) {
    auto substep = dt / substeps;
    for (auto left = static_cast<std::uint64_t>(substeps); left > 0; --left) {
        const auto longest = surface.longest_step();
        if (substep > (1 + 1e-9) * longest) { // their number was found from it, and may be off by rounding
            const double more = std::ceil(double(substep / longest));
            // Beyond that the water is infinitely fast, and no substep is short enough.
            if (more * static_cast<double>(left) <= 1e6) {
                substep /= more;
                left *= static_cast<std::uint64_t>(more);
            }
        }
        SurfaceLanes::advance(surface, substep);
    }
}

/// The water moves.
struct MoveWater {
    static constexpr Phase phase = phases::fields;
    static constexpr std::string_view name = "water";
    template <class StepT> static void run(StepT& step) {
        using C = typename StepT::Composition_;
        const auto dt = static_cast<double>(step.context.dt().value()) * second;
        [[maybe_unused]] double substeps = 1;
        if constexpr (divides_for_water<C>()) // no more than were found before the step
            substeps = std::max(1.0, std::ceil(double(dt / longest_step_of_water<C>(step.data, step.policies))));
        each_kind_of_pools<C>(step.data, [&](auto& table, auto) {
            table.for_each([&](std::uint32_t, auto& row) {
                if constexpr (divides_for_water<C>()) move_in_substeps(*row.surface, dt, substeps);
                else SurfaceLanes::advance(*row.surface, dt);
            });
        });
        // Behind the waves: they were pushed by what bodies pressed up where this step began, as bodies were by the
        // water of then. Were it before them, a body that bobs would get energy from nothing.
        if constexpr (C::floats) {
            press_water<C>(step.data, weight_of_water<C>(step.policies));
            step.data.coupled.current = false;
        }
    }
};

template <class... P> struct WaterCounts {
    static constexpr bool weighs = (std::same_as<P, Gravity> || ...);
    static constexpr int carriers = count_of_role<roles::Buoyancy, P...>;
    static constexpr bool water = count_of_role<roles::Field, P...> > 0;
    static constexpr bool ok = weighs && carriers <= 1 && water;
};
template <class... P> struct CheckWaterCounts {
    static_assert(WaterCounts<P...>::weighs,
                  "Ansatz: World has water and no Gravity; the weight of water is that of the world, so add Gravity{}");
    static_assert(WaterCounts<P...>::water || !WaterCounts<P...>::weighs,
                  "Ansatz: World has Buoyancy and no water; add pools, e.g. Pools<WaterColumns>{}");
    static_assert(WaterCounts<P...>::carriers <= 1,
                  "Ansatz: World has more than one policy by which water carries bodies; keep one, e.g. Buoyancy{}");
};
template <class Policy, class S> constexpr bool is_surface_of_pools() {
    if constexpr (SurfacePolicyIn<Policy, typename S::Scalar> && SurfacePolicyIn<Policy, double>)
        return NamesFields<Policy>;
    else return false;
}
template <class P, class S> struct PoolsFacts {
    static constexpr bool moved = [] {
        if constexpr (requires { typename P::surface; }) return is_surface_of_pools<typename P::surface, S>();
        else return false;
    }();
    static constexpr bool ok = moved;
};
template <class P, class S> struct CheckPools {
    static_assert(PoolsFacts<P, S>::moved,
                  "Ansatz: Pools of something that moves no surface, or does not say what it consists of; take "
                  "Pools<WaterColumns>, Pools<Pipes>, or a policy of your own with State, In and `static void "
                  "fields(auto& self, auto&& field)` for its parameters");
};
template <class P, class S> struct BuoyancyFacts {
    static constexpr bool keeps = [] {
        if constexpr (keeps_state<P, S>) return std::same_as<state_of<P, S>, state_of<Buoyancy, S>>;
        else return false;
    }();
    static constexpr bool ok = keeps && CouplingIn<P, S>;
};
template <class P, class S> struct CheckBuoyancy {
    static_assert(
        BuoyancyFacts<P, S>::ok,
        "Ansatz: a policy by which water carries bodies keeps what Buoyancy keeps, and couples bodies; derive "
        "it from Buoyancy, with an In<S> of its own that has couple(view, context)");
};
template <class P, class S> constexpr auto check_of_water() {
    if constexpr (PlaysRole<P, roles::Field>)
        return std::type_identity<FactsAndSentences<PoolsFacts<P, S>, CheckPools<P, S>>>{};
    else return std::type_identity<FactsAndSentences<BuoyancyFacts<P, S>, CheckBuoyancy<P, S>>>{};
}

} // namespace detail

/// The members of `World` that ask its water.
template <class W, class C> class WaterDoor {
public:
    /// A pool, to be asked: `world.water(pool).level(x, z)`.
    /// \throws std::out_of_range for a stale handle
    template <class Policy> WaterView<Policy, typename C::S> water(PoolHandle<Policy> pool) const {
        return {static_cast<const W&>(*this).template elements<Pool<Policy>>(), pool};
    }
    /// Pours water into the column that stands there, or takes some out of it.
    /// \param x,z    m
    /// \param volume m^3, finite; negative to take out, no more than there is without what bodies have pressed up
    /// \throws std::out_of_range for a stale handle or where no column stands, std::invalid_argument for another
    ///         volume; the water is then as it was
    template <class Policy>
    void pour(PoolHandle<Policy> pool, Quantity<unit::Length> x, Quantity<unit::Length> z,
              Quantity<unit::Volume> volume) {
        auto& world = static_cast<W&>(*this);
        const auto& table = std::as_const(world).template elements<Pool<Policy>>();
        const auto id = table.id(pool, "World::pour");
        require_finite("World::pour", "volume", volume);
        const auto& before = table.row(id);
        const auto& surface = *before.surface;
        const auto n = surface.grid().column(x, z);
        const auto footprint = surface.grid().footprint(n % surface.grid().columns_x(), n / surface.grid().columns_x());
        using Scalar = typename C::S::Scalar;
        const Scalar there = surface.heights()[n], more((volume / footprint).value()), then = there + more;
        if (!is_finite(more) || !is_finite(then))
            refuse_value("World::pour", "volume", volume, "the height of the column must be a finite number");
        const Scalar own = there - before.pressed[n]; // columns that pull at each other may be below zero
        if (more < Scalar(0) && own + more < Scalar(0))
            refuse_value("World::pour", "volume", volume,
                         detail::joined({"the column would hold less than nothing; it has ",
                                         describe(std::max(0.0, static_cast<double>(own)) * footprint * metre)}));
        detail::Key::get_ready(world, "World::pour");
        const auto inside = detail::Key::inside(world);
        inside.template tell<hook::BeforeChange<>>();
        auto& row = inside.data.template state<Pools<Policy>>().row(id);
        detail::SurfaceLanes::of(*row.surface).height[n] = then;
    }
    /// What the water does to a body that floats, as it is now: the level around it, what of it is under water, what
    /// carries it.
    /// \throws std::out_of_range for a stale handle
    Afloat<typename C::S::Scalar, C::S::dimension> afloat(FloatingHandle floating) const {
        const auto& table = static_cast<const W&>(*this).template elements<Floating>();
        auto body = table.row(table.id(floating, "World::afloat"));
        Afloat<typename C::S::Scalar, C::S::dimension> all;
        all.broken = body.broken;
        if constexpr (C::floats) {
            const auto inside = detail::Key::inside(static_cast<const W&>(*this));
            auto& water = body.beside;
            water = detail::water_beside<C>(inside.data, body, detail::weight_of_water<C>(inside.policies));
            if (!water.wet) return all;
            const auto slot = inside.data.bodies.slot_of_id(body.body.id);
            const auto at = inside.data.lanes.template get<Position>(slot).value();
            const auto inverse_mass = inside.data.lanes.template get<InverseMass>(slot).value();
            const typename C::S::Scalar depth = water.level - at[1];
            const auto sunk = body.settled(depth, inverse_mass);
            all.in_pool = true;
            all.level = decltype(all.level)::from_value(water.level + body.raised(sunk));
            if (body.shaped()) {
                all.submerged = decltype(all.submerged)::from_value(sunk.volume);
                all.centre = decltype(all.centre)::from_value(at[1] - body.below() + sunk.centre);
            }
            all.flow = decltype(all.flow)::from_value(body.flow(at[1]));
            all.lift = decltype(all.lift)::from_value(body.lift(sunk));
        }
        return all;
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
    template <class P, class S> using FactsOf = typename decltype(detail::check_of_water<P, S>())::type::Facts;
    template <class P, class S> using SentencesOf = typename decltype(detail::check_of_water<P, S>())::type::Sentences;
    template <class P, class S>
    using needs = std::conditional_t<detail::couples_bodies<P>,
                                     union_of<reads_of<P>, Columns<CoupledForce, InverseMass>>, reads_of<P>>;
    template <class W, class C> using Door = WaterDoor<W, C>;
    template <class C> using systems = Types<detail::MoveWater>;

    template <class C> static void on(hook::RefreshBetweenSteps, WorldData<C>& data, const auto& policies) {
        if constexpr (C::floats) detail::look_at_water<C>(data, detail::weight_of_water<C>(policies));
    }
    template <class I, class Given>
    static void on(hook::CheckStep, const I& inside, const typename I::S::Time& dt, const Given& given) {
        using C = typename I::Composition_;
        const auto longest = detail::longest_step_of_water<C>(inside.data, inside.policies);
        detail::weigh_water<C>(inside.data, inside.policies);
        const auto step = static_cast<double>(dt.value()) * second;
        double substeps = 1; // at most
        if constexpr (detail::divides_for_water<C>()) substeps = detail::most_parts_of_water<C>(inside.policies);
        if (!(step <= longest) && !(std::ceil(double(step / longest)) <= substeps))
            detail::refuse_step_of_water(given, longest, substeps);
        // Not every integrator asks the forces anew where a step begins.
        if constexpr (C::floats)
            if (!inside.data.coupled.current)
                detail::look_at_water<C>(inside.data, detail::weight_of_water<C>(inside.policies));
    }
    /// \endcond
};

} // namespace modules
} // namespace ansatz
