// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Tearing`: where a spring breaks, what its triangles do goes with it; and a sheet comes apart (notes 4).
///
/// Use it for flags, sails, paper, curtains that are shot at, beside `Springs<Breaking>` (or `Ropes<Breaking>`) whose
/// springs break by themselves. The policy knows the sheet by its triangles, `TearableTriangle`, of which `add_cloth`
/// adds all. Not for skins that are filled: a torn `Enclosure` keeps its air. Not for fracture of what is solid.
///
/// | what                                                     | goes when                                            |
/// |----------------------------------------------------------|------------------------------------------------------|
/// | a triangle: it is torn, and may still be asked for       | a spring along one of its edges breaks               |
/// | `Sail`, `Membrane`                                       | their triangle is torn                               |
/// | `Hinge`                                                  | one of its two triangles is torn                     |
/// | a spring that is no edge of a triangle: bend, and shear across a cell | a triangle at one of its ends is torn, past which it reaches the other |
/// | a spring along an edge                                   | it breaks by itself: it may be the last thread       |
///
/// What is left often hangs together by a point: whole triangles on both sides of a vertex, and torn ones between. With
/// `Tearing<>` it does. With `Tearing<Splitting>{.room = 200}` that vertex splits: each side but one gets a body of its
/// own, at the same place, with the same velocity, and with the fraction of the mass that its triangles have of the
/// area, so that mass, momentum and energy are what they were. Springs, hinges and sails go with their triangles. The
/// new bodies come from room that is made before the step, for `room` of them in all; when it is used up no more
/// vertices split, and `world.tearing()` says how many sides wait for it. Set more, and they split at the next tear.
///
/// What is held (fixed, `moving`) does not split; nor does what other elements hold at a vertex, such as a spring to a
/// body elsewhere, go to the new one. In a world of collisions a new body has the shape of the other, its contacts and
/// its share of their impulses; the two do not collide with each other until they have been apart. Lists by body have
/// room for all that may come, so that a warm step that tears allocates nothing as long as there are no more contacts
/// than ever before, with the integrator `ImplicitEulerBy<MatrixFree>` too. With `ImplicitEuler`,
/// `ImplicitEulerBy<Cholesky>` and `Odeint` it does: where a body comes, they make their matrix or their state anew. A
/// Datum of yours is copied to it behind the step.

#include <ansatz/soft_bodies/tear.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/world/schedule.hpp>
#include <ansatz/world/table_door.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace ansatz {

/// Option of Tearing: vertices split.
struct Splitting {};

/// What has been torn so far.
struct TearStatus {
    std::size_t torn = 0;    ///< triangles, of those that are there
    std::size_t split = 0;   ///< bodies that vertices have become
    std::size_t waiting = 0; ///< sides that hang by a vertex and have no body of their own, because there was no room
                             ///< when something tore last
};

namespace detail {

/// At the place of the step where springs break, and behind them.
template <class S, bool Splits> struct TearOpen {
    static constexpr Phase phase = between(phases::breaking, phases::sums);
    static constexpr std::string_view name = "tearing";
    using edits = TornElements;
    std::size_t room = 0;

    explicit TearOpen(const auto& tearing) {
        if constexpr (Splits) room = std::size_t(tearing.room);
    }
    void run(auto& view, const auto&) const {
        constexpr bool breaks = requires { view.template elements<Spring>().broken(); } ||
                                requires { view.template elements<Rope>().broken(); };
        static_assert(breaks, "Ansatz: a world with Tearing in which nothing breaks; write Springs<Breaking>{} or "
                              "Ropes<Breaking>{} among its policies, and give springs a limit, e.g. Cloth::structural "
                              "with .breaks = breaks_at(0.3)");
        if constexpr (breaks) {
            auto& table = view.state();
            Tear<S, std::remove_reference_t<decltype(view)>> tear(view, table);
            if (!tear.take_broken()) return;
            tear.remove_what_is_torn();
            if constexpr (Splits) tear.split(room);
        }
    }
};

/// Members of a world that tears.
template <class W, class P> class TearDoor : public TableDoor<W, P> {
public:
    /// What has been torn so far; visits every triangle when it is called.
    TearStatus tearing() const {
        TearStatus status;
        this->kept().for_each([&](std::uint32_t, const auto& row) { status.torn += row.torn ? 1U : 0U; });
        status.split = std::size_t(this->kept().split);
        status.waiting = std::size_t(this->kept().waiting);
        return status;
    }
    /// Whether a triangle is torn. `World::set` with a triangle mends it.
    /// \throws std::out_of_range for a stale handle
    bool is_torn(ElementHandle<TearableTriangle> triangle) const {
        return this->kept().row(this->kept().id(triangle, "World::is_torn")).torn;
    }
    /// The vertices that split in the last step, in the order in which they did.
    std::span<const SplitVertex> split_vertices() const
        requires P::splits
    {
        return this->kept().split_vertices;
    }
};

} // namespace detail

/// Sheets tear where their springs break; their vertices hold.
/// \tparam Options Splitting, or none
template <class... Options> struct Tearing {
    static_assert(sizeof...(Options) == 0,
                  "Ansatz: the option of Tearing is Splitting, e.g. Tearing<Splitting>{.room = 200}");
    static constexpr bool splits = false; ///< whether vertices split

    using role = roles::System;
    using Element = TearableTriangle;                                      ///< what World::add takes for it
    template <class S> using State = TearTable<S, false>;                  ///< where they are kept
    template <class S> using systems = Types<detail::TearOpen<S, false>>;  ///< what it does in a step
    template <class W, class C> using Door = detail::TearDoor<W, Tearing>; ///< members of World
    static constexpr std::string_view name = "Tearing";                    ///< in a saved file

    static void parameters(auto&, auto&&) {}
};
/// Sheets tear where their springs break, and what hangs together by a vertex alone comes apart.
template <> struct Tearing<Splitting> {
    static constexpr bool splits = true; ///< whether vertices split

    using role = roles::System;
    using Element = TearableTriangle;                                      ///< what World::add takes for it
    template <class S> using State = TearTable<S, true>;                   ///< where they are kept
    template <class S> using systems = Types<detail::TearOpen<S, true>>;   ///< what it does in a step
    template <class W, class C> using Door = detail::TearDoor<W, Tearing>; ///< members of World
    static constexpr std::string_view name = "Tearing";                    ///< in a saved file

    int room = 0; ///< for how many bodies that vertices become, in all; not negative

    /// Names the parameters.
    static void parameters(auto& self, auto&& visit) { visit("room", self.room); }
    /// \throws std::invalid_argument for less than nothing
    void check() const {
        if (room < 0) refuse_value(name, "room", room, "it is for so many bodies, 0 or more");
    }
};

} // namespace ansatz
