// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What a description of a soft body becomes before it is built: its bodies and its springs as numbers. It is checked
/// as a whole against the world first, and only then are its parts added, so that a refusal leaves the world as it was.
///
/// `add_cloth`, `add_rope`, `add_soft_ball` and `add_soft_box` are written with it, and so may be one of your own: fill
/// a `SoftPlan`, call `check` and `build`.

#include <ansatz/springs/springs.hpp>
#include <ansatz/world/world.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz {

/// How stiff and how damped the springs of one kind are: each of them, whatever its length.
struct SpringConstants {
    Parameter<unit::Stiffness> stiffness = 0.0 * newton_per_metre;    ///< k, N/m, finite, not negative
    Parameter<unit::Damping> damping = 0.0 * newton_second_per_metre; ///< c along the axis, N s/m, finite, not negative
    BreakLimit breaks = {}; ///< where each of them breaks, e.g. `breaks_at(0.3)`; never, without it
    /// Whether such springs do anything; those that do not are not built.
    bool act() const { return stiffness.value() != 0 || damping.value() != 0; }
};

/// How the mass of a surface is shared out among its vertices.
enum class Lumping : std::uint8_t {
    by_area, ///< each has the mass of the area around it: at the border of a grid half as much, at its corners a
             ///< quarter
    equal    ///< all have the same
};

/// Bodies that a world does not have yet, as `from` of a row asks for them: what is built on them is refused before
/// they are added.
template <class S> struct PlannedBodies {
    std::string_view where;                     ///< the caller, for messages
    std::vector<Handle> handles;                ///< by which a description names them here, in order
    std::vector<typename S::Position> places{}; ///< in the scalar of the world, m

    BodyId body(Handle h) const { return {h.id}; }                ///< which
    const auto& position(Handle h) const { return places[h.id]; } ///< where, m
};

/// Bodies and springs that are to be added to a world.
struct SoftPlan {
    /// One body.
    struct Body {
        VectorQuantity<unit::Length> place; ///< m
        Quantity<unit::Mass> mass;          ///< kg, of a body that is awake
        Motion motion = Motion::awake;      ///< awake, fixed or moving
    };
    /// One spring: at rest as its ends lie.
    struct Link {
        std::uint32_t a;           ///< one end, by its number among the bodies
        std::uint32_t b;           ///< the other
        SpringConstants constants; ///< N/m and N s/m
    };

    std::string_view where;                  ///< the caller, for messages, e.g. "add_cloth"
    std::string_view vertex = "vertex";      ///< what a body is called in them
    VectorQuantity<unit::Velocity> velocity; ///< m/s, of the bodies that are awake
    std::vector<Body> bodies;                ///< in the order in which they are added
    std::vector<Link> links;                 ///< likewise

    /// Checks the constants of one kind of springs.
    /// \throws std::invalid_argument
    void check(std::string_view kind, const SpringConstants& constants) const {
        require_not_negative(where, detail::joined({kind, " stiffness"}), constants.stiffness);
        require_not_negative(where, detail::joined({kind, " damping"}), constants.damping);
    }
    /// Adds a spring, if it does anything.
    void link(std::uint32_t a, std::uint32_t b, const SpringConstants& constants) {
        if (constants.act()) links.push_back({a, b, constants});
    }
    /// Holds bodies: they become fixed or moving ones.
    /// \param list the name of the list, for the sentences
    /// \throws std::invalid_argument for a number of no body, and for one that is held already
    void hold(std::string_view list, std::span<const std::uint32_t> held, Motion motion) {
        for (std::size_t i = 0; i < held.size(); ++i) {
            const auto name = detail::joined({list, "[", std::to_string(i), "]"});
            if (held[i] >= bodies.size())
                refuse_value(where, name, std::to_string(held[i]),
                             detail::joined({"there are ", std::to_string(bodies.size()), " of them, from 0"}));
            if (bodies[held[i]].motion != Motion::awake)
                refuse_value(where, name, std::to_string(held[i]),
                             detail::joined({"that ", vertex, " is held already; each is named once"}));
            bodies[held[i]].motion = motion;
        }
    }

    /// Checks everything against a world.
    /// \tparam Element Spring or Rope
    /// \throws std::invalid_argument; nothing has been changed then
    template <class Element, class... P> void check(const World<P...>&) const {
        using S = typename World<P...>::S;
        using Keeper = typename detail::KeeperOf<Element, P...>::type;
        constexpr bool kept = !std::is_void_v<Keeper>;
        static_assert(kept, "Ansatz: a soft body is built of springs, and none of this world's policies keeps them: "
                            "add_cloth, add_soft_ball and add_soft_box need Springs{}, add_rope needs Ropes{}");
        if constexpr (kept) {
            require_finite(where, "velocity", velocity);
            S::convert(detail::joined({where, ", velocity"}), velocity);
            std::vector<typename S::Position> places;
            places.reserve(bodies.size());
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                const auto name = detail::joined({vertex, " ", std::to_string(i)});
                require_finite(where, name, bodies[i].place);
                places.push_back(S::convert(detail::joined({where, ", ", name}), bodies[i].place));
                if (bodies[i].motion == Motion::awake)
                    detail::inverse_of_mass<S>(detail::joined({where, ", ", name}), bodies[i].mass);
            }
            for (const Link& link : links) {
                check_limit<S, Keeper::breaks>(link);
                S::convert("stiffness", link.constants.stiffness);
                S::convert("damping", link.constants.damping);
                if (!Keeper::damped && link.constants.damping.value() != 0)
                    refuse_value(where, "damping", link.constants.damping, "the springs of this world are Undamped");
                const auto length = norm(places[link.b] - places[link.a]);
                if (!is_finite(length))
                    refuse_value(where,
                                 detail::joined({"the distance of ", vertex, " ", std::to_string(link.a), " and ",
                                                 std::to_string(link.b)}),
                                 length, "it is a finite number that the world's scalar can hold");
            }
        }
    }

    /// Its bodies before they are built. Behind `check`.
    template <class S> PlannedBodies<S> planned() const {
        PlannedBodies<S> all{where, {}};
        for (const Body& body : bodies) {
            all.handles.push_back({std::uint32_t(all.handles.size()), 0});
            all.places.push_back(S::convert(body.place));
        }
        return all;
    }

    /// Adds the bodies, then the springs. Behind `check` only a lack of memory, or a property that is not acceptable,
    /// can stop it, and both do so before anything is added; what the copy of a datum of yours throws may come later.
    /// \tparam Element Spring or Rope
    /// \param added what is told of each: the handles, in order
    /// \param each  what each body is given beside its place, its velocity and its mass, e.g. `Sphere{...}`
    template <class Element, class... P, class... Property>
    void build(World<P...>& world, std::vector<Handle>& added, std::vector<ElementHandle<Element>>& springs,
               const Property&... each) const {
        using S = typename World<P...>::S;
        if constexpr (!std::is_void_v<typename detail::KeeperOf<Element, P...>::type>) {
            added.reserve(bodies.size());
            springs.reserve(links.size());
            // Powers of two: a thousand small bodies one after the other do not move the rest a thousand times.
            world.reserve(std::bit_ceil(world.size() + bodies.size()));
            world.template reserve<Element>(std::bit_ceil(world.template elements<Element>().ids() + links.size()));
            const typename S::Velocity v = S::convert(velocity);
            for (const Body& body : bodies) {
                const auto x = position(S::convert(body.place));
                if (body.motion == Motion::fixed) added.push_back(world.add(x, fixed, each...));
                else if (body.motion == Motion::moving) added.push_back(world.add(x, moving, each...));
                else added.push_back(world.add(x, ansatz::velocity(v), mass(body.mass), each...));
            }
            for (const Link& link : links) {
                const Element spring{.first = added[link.a],
                                     .second = added[link.b],
                                     .stiffness = link.constants.stiffness,
                                     .damping = link.constants.damping};
                if constexpr (detail::KeeperOf<Element, P...>::type::breaks)
                    springs.push_back(world.add(spring, link.constants.breaks));
                else springs.push_back(world.add(spring));
            }
        }
    }

private:
    /// What World::add would refuse of a limit, before anything is added.
    template <class S, bool Breaks> void check_limit(const Link& link) const {
        const auto& [force, strain] = link.constants.breaks;
        constexpr double never = std::numeric_limits<double>::infinity();
        if (!(typename S::Scalar(force.value()) > 0))
            refuse_value(where, "break force", force, "it is greater than 0 N in the world's scalar");
        if (!(typename S::Scalar(strain) > 0))
            refuse_value(where, "break strain", strain, "it is greater than 0 in the world's scalar");
        if (!Breaks && force.value() < never) refuse_value(where, "break force", force, no_breaking);
        if (!Breaks && strain < never) refuse_value(where, "break strain", strain, no_breaking);
        S::convert("break force", force);
        S::convert("break strain", Quantity<unit::Dimensionless>::from_value(strain));
        if (strain < never && S::convert(bodies[link.a].place) == S::convert(bodies[link.b].place))
            refuse_value(where, "break strain", strain,
                         detail::joined({"the springs have a length, and ", vertex, " ", std::to_string(link.a),
                                         " and ", std::to_string(link.b), " are in one place"}));
    }
    static constexpr const char* no_breaking =
        "the springs of this world do not break; write Springs<Breaking>{} or Ropes<Breaking>{} among its policies";
};

} // namespace ansatz
