// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Inside`: the inside of a world for the modules that its doors and hooks belong to: its data, its policies, and the
/// policies as they are bound.

#include <ansatz/world/context.hpp>
#include <ansatz/world/data.hpp>

namespace ansatz {

/// The policies of a world, bound to its space: what its modules bind.
template <class C, class Modules = typename C::modules> struct BoundPolicies;
/// Made of each module's.
template <class C, class... M> struct BoundPolicies<C, Types<M...>> : detail::BoundIn<M, C>::type... {
    /// Binds a world's policies.
    template <class Policies> static BoundPolicies from(const Policies& policies) {
        return {from_one<typename detail::BoundIn<M, C>::type>(policies)...};
    }
    /// What can be computed once for all bodies.
    void prepare(const Context<typename C::S>& context) {
        (prepare_one(static_cast<typename detail::BoundIn<M, C>::type&>(*this), context), ...);
    }

private:
    template <class One, class Policies> static One from_one([[maybe_unused]] const Policies& policies) {
        if constexpr (requires { One::from(policies); }) return One::from(policies);
        else return One{};
    }
    template <class One> static void prepare_one([[maybe_unused]] One& one, [[maybe_unused]] const auto& context) {
        if constexpr (requires { one.prepare(context); }) one.prepare(context);
    }
};

/// \tparam C        the world's composition
/// \tparam Data     its data, const where it may not be changed
/// \tparam Policies its policies
template <class C, class Data, class Policies> struct Inside {
    using Composition_ = C;    ///< of the world
    using S = typename C::S;   ///< its space
    using Slot = Bodies::Slot; ///< a body's place in the lanes

    Data& data;                    ///< what it holds
    Policies& policies;            ///< its policies
    const BoundPolicies<C>& bound; ///< the same, bound

    /// When the next step begins.
    Context<S> context() const { return Context<S>(data.clock.now(), TimeStep<S>(data.last_dt(), data.last_dt())); }
    /// Tells the modules.
    template <class Hook, class... A> void tell(A&&... argument) const {
        detail::tell<Hook>(typename C::modules{}, *this, argument...);
    }
};

namespace detail {
/// The key to a world, for doors.
struct Key {
    template <class W> static auto inside(W& world) { return world.inside(); }
    template <class W> static const auto& bound(const W& world) { return world.bound_; }
    template <class W> static void get_ready(W& world, const char* where) { world.get_ready(where); }
};
} // namespace detail

} // namespace ansatz
