// SPDX-License-Identifier: BSL-1.0
// ResponseIn at each of its levels: archetypes, two models, near misses.

#include <ansatz/collision.hpp>

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

/// Two spheres that intersect, so that a response is asked.
template <class World_> auto use_with_contacts(World_ world) {
    for (int i = 0; i < 2; ++i) world.add(Sphere{1.0 * metre}, position(metres(0.5 * i, 0, 0)), mass(1.0 * kilogram));
    return use(world);
}
template <class Response> auto respond_with(Response response) {
    return use_with_contacts(World{SemiImplicitEuler{}, BoundingBoxes{}, Narrowphase<Sphere>{}, response});
}

// ---------------------------------------------------------------- contact by contact
struct Stops : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;
    template <class Sp> struct In : NothingMore {
        using Body = Row<Sp, Columns<Velocity, InverseMass>>;
        explicit In(const Stops&) : NothingMore(0) {}
        template <class M> void respond(const Contact<Sp>&, Body&, Body&, const M&) const {}
    };
};
static_assert(ResponseIn<Stops, S> && ContactResponseIn<Stops, Space<float, 2>> && !ForceResponseIn<Stops, S> &&
              !SubstepResponseIn<Stops, S>);
auto of_velocities() { return respond_with(Stops(1)); }
struct Places : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Response;
    static constexpr Level level = Level::positions;
    using writes = Columns<Position>;
    template <class Sp> struct In : NothingMore {
        using Body = Row<Sp, Columns<Position, InverseMass>>;
        explicit In(const Places&) : NothingMore(0) {}
        template <class M> void respond(const Contact<Sp>&, Body&, Body&, const M&) const {}
    };
};
static_assert(ResponseIn<Places, S>);
auto of_positions() { return respond_with(Places(1)); }

// ---------------------------------------------------------------- forces of the next step
/// Unlike a policy it is made by the world, and copied with it.
struct Kept {
    template <class Data, class Contacts> void take(const Data&, const Contacts& contacts) { there = contacts.size(); }
    void arrange(const Bodies&, std::uint64_t) {}
    void begin_step() {}
    void reserve_notes() {}
    void body_removed(std::uint32_t) {}
    void add_to(auto&) const {}
    std::size_t there = 0;
};
struct Presses : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Response;
    static constexpr Level level = Level::accelerations;
    static constexpr bool couples_bodies = true;
    using reads = Columns<>;
    template <class> using State = Kept;
    template <class Sp> struct In : NothingMore {
        explicit In(const Presses&) : NothingMore(0) {}
        void couple(CouplingView<Sp, Presses>& view, const Context<Sp, false>&) const {
            if (view.state().there > 0) view.add_force(0, typename Sp::Force());
        }
    };
};
static_assert(ResponseIn<Presses, S> && ForceResponseIn<Presses, S> && CouplingIn<Presses, S> && !ForceIn<Presses, S> &&
              !ContactResponseIn<Presses, S>);
auto of_accelerations() { return respond_with(Presses(1)); }

// ---------------------------------------------------------------- the whole step
/// What a world reads of a contact that is solved between substeps.
struct Solved : Kept {
    struct One {
        std::uint32_t a, b;
        double impulse;
    };
    std::vector<One> all;
    std::vector<SolverBody<S>> bodies;
    std::vector<SolverBody<S>::Raw> kicks, pushed;
    SoftImpacts<S> impacts;
    template <class Data, class F> void begin(const Data&, const F&) {}
    void expect_platforms(bool) {}
    void warm_start() {}
    void unload(const std::vector<SolverBody<S>::Raw>&) {}
    void relax(double) {}
    void calm(const std::vector<SolverBody<S>::Raw>&) {}
    void note_impacts() {}
};
struct Divides : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Response;
    static constexpr Level level = Level::substeps;
    template <class> using State = Solved;
    template <class Sp> struct In : NothingMore {
        explicit In(const Divides&) : NothingMore(0) {}
        int parts() const { return 2; }
        void solve(Solved&, double) const {}
        template <class Data> bool find_bouncing(Solved&, const Data&) const { return false; }
        bool bounce(Solved&, double) const { return false; }
        template <class Data> double friction(const Data&, std::size_t, std::size_t) const { return 0; }
    };
};
static_assert(ResponseIn<Divides, S> && SubstepResponseIn<Divides, S> && !ContactResponseIn<Divides, S>);
auto of_substeps() { return respond_with(Divides(1)); }

// Models: the library's, and one that reads, writes and sweeps more than once.
struct Sticks {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using reads = Columns<Position, Restitution>;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        int sweeps = 3;
        explicit In(Sticks) {}
        void respond(const auto& contact, auto& a, auto& b, const auto& meeting) const {
            if (contact.depth.value() > 0 && meeting.pull().value() <= 0)
                b.template get<Velocity>() = a.template get<Velocity>();
        }
    };
};
static_assert(ResponseIn<Impulse<Friction>, S> && ResponseIn<Projection, S> && ResponseIn<Penalty, S> &&
              ResponseIn<SoftSubsteps<Friction>, S> && ResponseIn<Sticks, S>);
auto of_sticks() { return respond_with(Sticks{}); }

// Near misses.
struct WithoutLevel {
    using role = roles::Response;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        explicit In(const WithoutLevel&);
        void respond(const auto&, auto&, auto&, const auto&) const;
    };
};
struct OfValues {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        explicit In(const OfValues&);
        void respond(const auto&, auto&, auto, const auto&) const;
    };
};
struct OnPlacesWritesVelocities {
    using role = roles::Response;
    static constexpr Level level = Level::positions;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        explicit In(const OnPlacesWritesVelocities&);
        void respond(const auto&, auto&, auto&, const auto&) const;
    };
};
struct OnVelocitiesWritesPlaces {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity, Position>;
    template <class Sp> struct In {
        explicit In(const OnVelocitiesWritesPlaces&);
        void respond(const auto&, auto&, auto&, const auto&) const;
    };
};
struct OfThreeArguments {
    using role = roles::Response;
    static constexpr Level level = Level::velocities;
    using writes = Columns<Velocity>;
    template <class Sp> struct In {
        explicit In(const OfThreeArguments&);
        void respond(const auto&, auto&, auto&) const;
    };
};
static_assert(!ResponseIn<WithoutLevel, S> && !ResponseIn<OfValues, S> && !ResponseIn<OnPlacesWritesVelocities, S>);
static_assert(!ResponseIn<OnVelocitiesWritesPlaces, S> && !ResponseIn<OfThreeArguments, S> &&
              !ResponseIn<Attraction, S> && !ResponseIn<int, S>);
struct ForgetsContacts : Presses {
    using Presses::Presses;
    template <class> struct State {};
};
struct KeepsNothing {
    using role = roles::Response;
    static constexpr Level level = Level::accelerations;
    static constexpr bool couples_bodies = true;
    using reads = Columns<>;
    template <class Sp> struct In {
        explicit In(const KeepsNothing&);
        void couple(auto&, const auto&) const;
    };
};
struct CouplesNobody : Penalty {
    static constexpr bool couples_bodies = false;
};
static_assert(!ResponseIn<ForgetsContacts, S> && !ResponseIn<KeepsNothing, S> && !ResponseIn<CouplesNobody, S>);
struct HalvesAPart : Divides {
    template <class Sp> struct In : Divides::In<Sp> {
        explicit In(const HalvesAPart&);
        double parts() const;
    };
};
static_assert(!ResponseIn<HalvesAPart, S>);

} // namespace ansatz::archetypes
