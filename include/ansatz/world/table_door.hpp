// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `TableDoor`: what a door of your own is made of, the members that your policy brings to `World`.
///
///     template <class W, class C> class Door : public TableDoor<W, MyPolicy> {
///     public:
///         typename C::S::Length level() const { return this->kept().level; }
///         void fill(...) { this->change("World::fill", [&](auto& kept) { kept.level = ...; }); }
///     };

#include <ansatz/world/inside.hpp>

#include <cstdint>
#include <utility>

namespace ansatz {

/// \tparam W the world, of which the door is a base
/// \tparam P the policy that brings it
template <class W, class P> class TableDoor {
protected:
    /// What the policy keeps.
    const auto& kept() const { return inside().data.template state<P>(); }
    /// The parameters of the policy.
    const P& policy() const { return std::get<P>(inside().policies); }
    /// The id of a body, to be kept: slots change, ids do not.
    /// \throws std::out_of_range for a stale handle
    std::uint32_t id(Handle body, const char* where) const {
        inside().data.bodies.slot(body, where);
        return body.id;
    }
    /// Changes what the policy keeps: `f(kept)`. Check what you were given before you call it; where `f` throws, what
    /// it keeps is as it was. What is derived from the state of the world is known as stale.
    /// \param where the name of the member, for the sentence of a world that is lost
    template <class F> void change(const char* where, F&& f) {
        auto& world = static_cast<W&>(*this);
        detail::Key::get_ready(world, where);
        const auto in = detail::Key::inside(world);
        auto& kept = in.data.template state<P>();
        auto changed = kept;
        std::forward<F>(f)(changed);
        in.template tell<hook::BeforeChange<>>();
        kept = std::move(changed);
    }
    /// Wakes a body, because what is changed concerns it.
    void wake_body(std::uint32_t id) {
        const auto in = detail::Key::inside(static_cast<W&>(*this));
        in.template tell<hook::Wake>(in.data.bodies.slot_of_id(id));
    }

private:
    auto inside() const { return detail::Key::inside(static_cast<const W&>(*this)); }
};

} // namespace ansatz
