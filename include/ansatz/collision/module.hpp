// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `modules::Collision`: what a world has because its bodies collide. It comes with the roles Broadphase, Filter,
/// Narrowphase and Response, and its members of `World` are those of `CollisionDoor`.

#include <ansatz/collision/add_facts.hpp>
#include <ansatz/collision/check.hpp>
#include <ansatz/collision/door.hpp>
#include <ansatz/collision/hash_collisions.hpp>
#include <ansatz/collision/save_collisions.hpp>
#include <ansatz/collision/sleep.hpp>
#include <ansatz/collision/step.hpp>
#include <ansatz/collision/substep_driver.hpp>
#include <ansatz/motion/module.hpp>

#include <string_view>

namespace ansatz {

namespace phases {
inline constexpr Phase contacts = between(positions, fields); ///< contacts are found, and answered
}

namespace detail {

/// Where all bodies are before they move: those that move far are followed.
struct RememberPlaces {
    static constexpr Phase phase = phases::begin;
    static constexpr std::string_view name = "places before the step";
    static void run(auto& step) { CollisionStep(step).remember(); }
};
/// A response that owns substeps solves its contacts between them.
struct Substeps {
    static constexpr Phase phase = phases::substeps, until = phases::contacts;
    static constexpr std::string_view name = "substeps";
    static void run(auto& step, const auto& inside) { SubstepDriver(step).run(inside); }
};
/// Contacts are found, wake sleeping bodies, and are answered.
struct Collide {
    static constexpr Phase phase = phases::contacts;
    static constexpr std::string_view name = "contacts";
    static void run(auto& step) { CollisionStep(step).collide(); }
};

/// What `add` was given of a body that collides.
template <class Description, class Shape> struct AdmittedShape {
    Description description;
    Shape shape;
    bool sensor;
};

} // namespace detail

/// What a world holds of its collisions.
/// \tparam C the world's composition
template <class C> struct CollisionState {
    typename C::Narrowphase::template Collisions<C> collisions; ///< the shapes of bodies, and their contacts
    /// Room for the rows of joints.
    [[no_unique_address]] std::conditional_t<(C::row_givers::size > 0), detail::Cache<SolverRows<typename C::S>>,
                                             detail::NotKept<8>>
        rows;
};

namespace modules {

/// Bodies collide.
struct Collision {
    /// \cond members: the table of world/modules.hpp says what they are
    static constexpr int layer = 1;
    using stands_on = Types<Motion>;
    static constexpr bool relates_bodies = true;     ///< those that touch sleep and wake together
    static constexpr bool changes_velocities = true; ///< behind the integration
    /// Whether the laws are asked before the integrator asks, or what they said to it is read behind it.
    template <class... P> static constexpr bool asks_first = CollisionFacts<P...>::substeps;
    /// And sleepers that a force pulls at are searched for in each substep, before its contacts are solved.
    template <class... P> static constexpr bool wakes_pulled = CollisionFacts<P...>::substeps;
    template <class... P> static constexpr bool solves_rows = CollisionFacts<P...>::substeps;
    template <class... P> static constexpr bool looks_at_own = CollisionFacts<P...>::holds_near;

    template <class... P> using Facts = CollisionFacts<P...>;
    template <class... P> using Counts = detail::CollisionCounts<P...>;
    template <class... P> using CheckCounts = detail::CheckCollisionCounts<P...>;
    template <class P, class S> using FactsOf = typename detail::ChecksOfCollision<role_of<P>>::template Facts<P, S>;
    template <class P, class S>
    using SentencesOf = typename detail::ChecksOfCollision<role_of<P>>::template Sentences<P, S>;
    template <class P, class S>
    using needs = std::conditional_t<
        detail::couples_bodies<P>, union_of<reads_of<P>, Columns<CoupledForce, InverseMass>>,
        std::conditional_t<PlaysRole<P, roles::Response>, union_of<writes_of<P>, reads_of<P>, Columns<InverseMass>>,
                           union_of<writes_of<P>, reads_of<P>>>>;
    template <class C, class... Property> using AddFacts = detail::ShapeAddFacts<C, Property...>;
    template <class C, class... Property> using CheckAdd = detail::CheckShapeAdd<C, Property...>;

    template <class C, class Data> using State = CollisionState<C>;
    template <class W, class C> using Door = CollisionDoor<W, C>;
    template <class C>
    using systems = detail::joined_types<detail::only_if<C::continuous, detail::RememberPlaces>,
                                         detail::only_if<C::substeps, detail::Substeps>, Types<detail::Collide>>;

    // Room.
    template <class C>
    static constexpr bool assigns_in_place = C::Narrowphase::template Collisions<C>::assigns_in_place;
    template <class C> static void on(hook::Reserve, WorldData<C>& data, std::size_t n) {
        data.collisions.reserve(n);
        if constexpr (decltype(data.collisions)::divides) { // a step makes some of them, and allocates nothing
            if constexpr (C::row_givers::size > 0) data.rows.value.reserve(n);
            if constexpr (C::substeps) {
                auto& kept = data.template state<
                    typename detail::FirstIn<typename C::template responses<Level::substeps>>::type>();
                if constexpr (requires { kept.reserve(n); }) kept.reserve(n);
            }
        }
    }
    static void on(hook::MakeRoom, auto& data, std::uint32_t id, bool) { data.collisions.make_room(id); }
    template <class C> static void on(hook::ReserveNotes, WorldData<C>& data, [[maybe_unused]] std::size_t n) {
        if constexpr (C::rests) data.collisions.reserve_neighbours(n); // disturbed bodies wake
    }
    static void on(hook::MakeRoomFor, auto& data, const auto& other) {
        data.collisions.make_room_for(other.collisions);
    }
    static void on(hook::MakeRoomToCome, auto& data, std::size_t n) {
        data.collisions.make_room_to_wake(data);
        data.collisions.make_room_to_come(n, data.bodies.ids());
    }

    // Bodies.
    template <class C, class... Property> static auto admit(const Property&... property) {
        const auto description = detail::given_shape(property...);
        const auto shape = detail::shape_in<typename C::S>(description);
        return detail::AdmittedShape<std::decay_t<decltype(description)>, std::decay_t<decltype(shape)>>{
            description, shape, (std::same_as<Property, Sensor> || ...)};
    }
    template <class D, class T> static void make_room_to_keep(auto& data, const detail::AdmittedShape<D, T>&) {
        if constexpr (ShapeDescription<D>) data.collisions.shapes.template make_room_for_one<D>();
    }
    template <class D, class T>
    static void keep(auto& data, std::uint32_t id, const detail::AdmittedShape<D, T>& admitted) {
        if constexpr (ShapeDescription<D>) data.collisions.shapes.set(id, admitted.description, admitted.shape);
        data.collisions.set_sensor(id, admitted.sensor);
    }
    template <class C>
    static void on(hook::Divided, WorldData<C>& data, std::uint32_t id, std::uint32_t part, const auto& /*share*/) {
        data.collisions.wake_contacts_of(data, id); // the new body takes them along
        data.collisions.body_divided(data.bodies, id, part);
    }
    static void on(hook::Removed, auto& data, std::uint32_t slot) {
        data.collisions.body_removed(data.bodies.id(slot));
    }
    /// A moving body wakes by itself what it hits; one that stands still and was put on a sleeping body wakes it here.
    template <class I> static void on(hook::Placed, const I& inside, std::uint32_t id) {
        if constexpr (I::Composition_::rests) {
            auto& data = inside.data;
            if (data.bodies.motion(data.bodies.slot_of_id(id)) == ansatz::Motion::awake ||
                data.collisions.is_sensor(id))
                return;
            constexpr auto resting = ansatz::Motion::resting;
            for (std::size_t slot = data.bodies.begin(resting); slot < data.bodies.end(resting); ++slot) {
                const auto sleeper = data.bodies.id(slot);
                if (sleeper == id || data.collisions.is_sensor(sleeper) ||
                    !data.collisions.intersect(data, id, sleeper))
                    continue;
                // The first sleeping body, which was visited, takes this place.
                inside.template tell<hook::Wake>(std::uint32_t(slot));
            }
        }
    }
    template <class C> static void on(hook::EachNeighbour, const WorldData<C>& data, std::uint32_t id, const auto& f) {
        data.collisions.each_neighbour(data.bodies, id, f);
    }

    // Changes from outside. Whatever of a body changes, the pairs of the next step are found anew.
    template <class... Column, class I> static void on(hook::BeforeChange<Column...>, const I& inside) {
        contacts_change<I>(inside);
        inside.data.collisions.make_stale();
    }
    /// Before contacts that are forces are found anew: the forces of the present ones are kept until the change is made
    /// good, because the new ones differ, if only in the last bits.
    template <class I> static void contacts_change(const I& inside) {
        using C = typename I::Composition_;
        if constexpr (C::history && C::coupled && C::acts_next && !C::substeps) detail::forces_change(inside);
    }
    template <class Policy> static void on(hook::BeforeSet<Policy>, const auto& inside) {
        if constexpr (PlaysRole<Policy, roles::Filter>) contacts_change(inside);
    }
    template <class Column, class C> static constexpr bool looks_at = C::template collisions_read<Column>;
    template <class Policy> static void on(hook::AfterSet<Policy>, const auto& inside) {
        if constexpr (PlaysRole<Policy, roles::Broadphase>) inside.data.collisions.new_broadphase();
        if constexpr (PlaysRole<Policy, roles::Filter>) inside.data.collisions.make_stale();
        if constexpr (PlaysRole<Policy, roles::Response> || PlaysRole<Policy, roles::Filter>) detail::wake_all(inside);
    }

    // A step.
    static void on(hook::BeforeStep, const auto& inside, const auto& dt) {
        inside.data.collisions.wake_contacts(inside.data);
        look_around(inside, dt);
    }
    template <class C> static void on(hook::RefreshBetweenSteps, WorldData<C>& data, const auto& policies) {
        if constexpr (!C::substeps) data.collisions.refresh_between_steps(data, policies);
    }
    template <class I> static void on(hook::NextSubsteps, const I& inside, int& parts) {
        using C = typename I::Composition_;
        if constexpr (C::substeps) {
            using R = typename detail::FirstIn<typename C::template responses<Level::substeps>>::type;
            parts *= detail::Bound<R, typename C::S>(std::get<R>(inside.policies)).parts();
        }
    }

    // Rest.
    static void on(hook::WakeTouching, auto& step) { CollisionStep(step).wake_touching(); }
    static void on(hook::MarkHeld, auto& data, auto& scratch) {
        for (const auto& contact : data.collisions.contacts.acting)
            for (const auto& body : {contact.first, contact.second}) scratch.held[data.bodies.slot_of_id(body.id)] = 1;
    }
    template <class C> static void on(hook::Join, const WorldData<C>& data, auto& scratch) {
        detail::join_by_contacts(data, scratch);
    }
    static void on(hook::EachPush, auto& step, const auto& add) { CollisionStep(step).add_pushes(add); }
    static void on(hook::Slept, auto& data, std::uint32_t id, const auto& pull) { data.collisions.slept(id, pull()); }
    static void on(hook::WasHeld, const auto& data, std::uint32_t id, const auto& pull, bool& held) {
        held = held || pull == data.collisions.pull_when_it_slept(id);
    }

    // As a value.
    template <class C> static void on(hook::Hash, const WorldData<C>& data, auto& hash) {
        detail::add_collisions_to<C>(hash, data);
    }
    template <class C, class Files> static void on(hook::Save, const WorldData<C>& data, auto& file, const Files&) {
        CollisionArchive::write<C, Files>(file["collisions"] = typename Files::Json(Files::Json::object()), data);
    }
    template <class C> static void on(hook::Load, WorldData<C>& data, const auto& file) {
        CollisionArchive::read<C>(data, file.at("collisions"));
    }
    /// \endcond
};

} // namespace modules
} // namespace ansatz
