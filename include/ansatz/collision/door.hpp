// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `CollisionDoor`: the members of `World` that tell which bodies touch, and answer questions about shapes.

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/inside.hpp>

#include <span>

namespace ansatz {

/// \tparam W the world, of which this is a base
/// \tparam C its composition
template <class W, class C> class CollisionDoor {
public:
    /// \name Contacts (notes 2.1.2)
    /// @{

    /// Which bodies intersected where the last step left them, by their ids; one that `begins()` was none before it.
    /// Stays what it is until the next step, in which those of a removed body end: `contains(contact.first)` tells
    /// whether it is there.
    std::span<const Contact<typename C::S>> contacts() const { return inside().data.collisions.contacts.all(); }
    /// Which ended in the last step, or with a body that was removed before it; of a divided step, in any substep.
    /// Stays until the next.
    std::span<const ContactEnd> contacts_ended() const { return inside().data.collisions.ended; }
    /// Calls `f(shape)` with the shape of a body as it was given, e.g. a Sphere; not at all, if it has none.
    /// \throws std::out_of_range for a stale handle
    template <class F> void visit_shape(Handle body, F&& f) const {
        const auto& data = inside().data;
        data.bodies.slot(body, "World::visit_shape");
        data.collisions.shapes.visit_description(body.id, f);
    }
    /// Ray casts and overlaps, e.g. `world.query().closest(Ray{...})`: see collision/queries_in_world.hpp. Do not keep
    /// it.
    auto query() const {
        using Policies = std::remove_cvref_t<decltype(inside().policies)>;
        using Asked = typename C::Narrowphase::template Query<C, Policies>;
        constexpr bool defined = requires { sizeof(Asked); };
        static_assert(defined, "Ansatz: query: what answers it is not included; write #include "
                               "<ansatz/collision/queries_in_world.hpp>, or "
                               "<ansatz/collision.hpp> for all of collision");
        const auto in = inside();
        if constexpr (defined) return Asked(in.data, in.policies);
    }
    /// @}

private:
    auto inside() const { return detail::Key::inside(static_cast<const W&>(*this)); }
};

} // namespace ansatz
