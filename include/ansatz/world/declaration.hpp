// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `World`, declared: the composition root. A world is the list of what happens in it. Include world/world.hpp, which
/// has its members, too.
///
/// Name the policies in any order; the compiler builds exactly that world. It is a value: copying it is the snapshot,
/// and the copy continues bit-identically. Use it when bodies should be advanced together by one integrator; when you
/// have an entity system of your own, call `for_lanes`, `Laws` and the policies directly instead.
///
/// Threads: a world has no hidden global and no lock. Different worlds, copies included, may be used on different
/// threads at the same time; so may const members of one world. A change needs that world for itself.

#include <ansatz/world/add_facts.hpp>
#include <ansatz/world/check.hpp>
#include <ansatz/world/checked_value.hpp>
#include <ansatz/world/held_parameters.hpp>
#include <ansatz/world/inside.hpp>
#include <ansatz/world/properties.hpp>
#include <ansatz/world/step.hpp>
#include <ansatz/world/user_data.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ansatz {

struct Archive; // save.hpp reads and writes the parts of a world

namespace detail {
/// The doors of a world: of its modules, then of its policies.
template <class P, class W, class C> struct DoorOfPolicy {
    using type = Nothing<P>;
};
template <class P, class W, class C>
    requires requires { typename P::template Door<W, C>; }
struct DoorOfPolicy<P, W, C> {
    using type = typename P::template Door<W, C>;
};
template <class W, class C, class Modules, class Policies> struct Doors;
template <class W, class C, class... M, class... P>
struct Doors<W, C, Types<M...>, Types<P...>>
    : DoorIn<M, W, C>::type...
    , DoorOfPolicy<P, W, C>::type... {};
template <class W, class C> using doors_of = Doors<W, C, typename C::modules, typename C::policies>;
} // namespace detail

/// A world: the list of what happens in it, with its bodies and its time.
///
/// Name the policies in any order; the compiler builds exactly that world. What is not named has no byte and no
/// instruction, and a list that cannot work does not compile. %Bodies are described by their properties and found again
/// by their handles; modules (collision, springs, water, ...) add members of their own. A world is a value: copying it
/// is the snapshot, and the copy continues bit-identically.
///
/// \dontinclude tests/package/engine.cpp
/// \skip World sky
/// \until sky.step(
///
/// \ref page_world "Worlds" tells the rest, \ref motion_compose "what to take for what" which policies there are.
///
/// \headerfile ansatz/world.hpp <ansatz/world.hpp>
/// \tparam P policies in any order, each one type once: exactly one Integrator; any number of Force, Effect, Observer;
///           at most one Space (`Space<double, 3>` without it)
template <class... P>
class World : public detail::doors_of<World<P...>, typename detail::ComposedOf<detail::is_world<P...>, P...>::type> {
    static_assert(detail::is_world<P...>, "Ansatz: this list of policies is not a world; the sentence above says why");

public:
    /// What follows from the list of policies.
    using composition = typename detail::ComposedOf<detail::is_world<P...>, P...>::type;
    using S = typename composition::S; ///< the space
    using Scalar = typename S::Scalar;
    using ClockTime = typename S::ClockTime; ///< the type of times: seconds, at least in double

    /// What a body takes in the lanes. Its handle adds 16 bytes; what modules keep comes to it.
    static constexpr std::size_t bytes_per_body = Lanes<S, typename composition::stored>::bytes_per_body;

    /// \throws std::invalid_argument if a policy's parameter is not acceptable
    explicit World(P... policies)
        : policies_(policies...), bound_(BoundPolicies<composition>::from(checked(policies_))) {}

    World(const World&) = default; ///< a snapshot that continues bit-identically and takes the same handles
    /// The other is left without bodies. Its policies have been moved from: one that shares something has it no more.
    World(World&&) = default;
    /// A snapshot, as by copying. Where it fails, the world is as it was.
    World& operator=(const World& other)
        requires std::is_copy_assignable_v<std::tuple<P...>>
    {
        if (this != &other) assign(other);
        return *this;
    }
    /// The other is left without bodies; a world moved to itself is what it was.
    World& operator=(World&& other)
        requires std::is_move_assignable_v<std::tuple<P...>>
    {
        if (this != &other) assign(std::move(other));
        return *this;
    }

    /// \name Bodies
    /// @{

    /// Adds a body, described by properties in any order: position(...), velocity(...), mass(...), with<Column>(...),
    /// datum(...), and fixed, moving or resting.
    /// \throws std::invalid_argument if a value is not acceptable; the world is then as it was
    template <class... Property> Handle add(const Property&... property);

    /// Removes a body. Other handles stay valid; this one becomes stale. What was polled (`events()`, `handles()`,
    /// which bodies touched) stays as it was until the next step, so that a loop over it may remove bodies; ask
    /// `contains` before you use a handle of it.
    /// \throws std::out_of_range for a stale handle
    void remove(Handle body);
    /// Whether the handle names a body that is in this world.
    bool contains(Handle body) const { return data_.bodies.contains(body); }
    /// How many bodies there are, the fixed and the resting included.
    std::size_t size() const { return data_.bodies.size(); }
    /// How many there are of a kind.
    std::size_t count(Motion m) const { return data_.bodies.count(m); }
    /// Makes room, so that adding `n` bodies in all does not allocate.
    /// \throws std::invalid_argument for more bodies than handles can name
    [[gnu::cold]] void reserve(std::size_t n);
    /// The handles of all bodies, by id: a list of your own, for loops that add or remove.
    std::vector<Handle> handles() const {
        std::vector<Handle> all;
        all.reserve(size());
        for_each([&](Handle h) { all.push_back(h); });
        return all;
    }
    /// Calls `f(handle)` for each body, by id. Do not add or remove bodies in it.
    template <class F> void for_each(F&& f) const {
        for (std::uint32_t id = 0; id < data_.bodies.ids(); ++id)
            if (data_.bodies.alive(id)) f(data_.bodies.handle(data_.bodies.slot_of_id(id)));
    }
    /// Awake, resting, moving or fixed.
    Motion motion(Handle body) const { return data_.bodies.motion(data_.bodies.slot(body, "World::motion")); }
    /// @}

    /// \name Elements: what policies keep beside the bodies, such as springs (springs/spring.hpp)
    /// @{

    /// Adds an element, e.g. `add(Spring{ball, hook, 100.0 * newton_per_metre})`, and wakes the bodies that it holds.
    /// \param option what the policy takes beside it, e.g. `breaks_at(50.0 * newton)`
    /// \throws std::invalid_argument if a value is not acceptable, std::out_of_range for a stale handle of a body; the
    ///         world is then as it was
    template <Element E, class... Option> ElementHandle<E> add(const E& element, const Option&... option);
    /// Removes an element. Other handles stay valid; this one becomes stale. Wakes the bodies that it held.
    /// \throws std::out_of_range for a stale handle
    template <class E> void remove(ElementHandle<E> element);
    /// Gives an element another description. Its handle stays; options that are not given again are gone.
    /// \throws as `add`
    template <Element E, class... Option> void set(ElementHandle<E> element, const E& to, const Option&... option);
    /// The description of an element.
    /// \throws std::out_of_range for a stale handle
    template <class E> E get(ElementHandle<E> element) const {
        const auto& all = elements<E>();
        return all.describe_element(all.id(element, "World::get"), data_.bodies);
    }
    /// Whether the handle names an element that is in this world. One is gone with a body that it held.
    template <class E> bool contains(ElementHandle<E> element) const { return elements<E>().contains(element); }
    /// All elements of a type: how many, their handles, and what happened to them in the last step.
    template <class E> const auto& elements() const {
        need_element<E>();
        return data_.template state<typename detail::KeeperOf<E, P...>::type>();
    }
    /// Makes room, so that adding `n` elements of a type in all does not allocate.
    template <class E> void reserve(std::size_t n) {
        need_element<E>();
        data_.template state<typename detail::KeeperOf<E, P...>::type>().reserve(n);
    }
    /// @}

    /// \name Reading a body
    /// All throw std::out_of_range for a stale handle.
    /// @{
    /// The value of any stored column.
    template <class C> value_of<C, S> read(Handle body) const {
        need_column<C>();
        return data_.lanes.template get<C>(data_.bodies.slot(body, "World::read"));
    }
    /// The user's own datum of the body.
    auto& datum(Handle body) {
        need_datum();
        data_.bodies.slot(body, "World::datum");
        return user_.at(body.id);
    }
    /// The user's own datum of the body, to read.
    const auto& datum(Handle body) const {
        need_datum();
        data_.bodies.slot(body, "World::datum");
        return user_.at(body.id);
    }
    /// A lane of a stored column: raw SI scalars of one component, slot by slot; for plotting and other libraries. The
    /// body of slot i is `body_at(i)`; slots change when bodies are added, removed, fall asleep or wake.
    /// \param component from 0
    /// \throws std::out_of_range for a component that the column does not have
    template <class C> std::span<const Scalar> lane(int component = 0) const {
        need_column<C>();
        if (component < 0 || std::size_t(component) >= lanes_of<C>(S::dimension))
            detail::refuse_component(C::name, component, lanes_of<C>(S::dimension));
        return {data_.lanes.template lane<C>(component), size()};
    }
    /// The body of a slot.
    /// \throws std::out_of_range for a slot that is not below size()
    Handle body_at(std::size_t slot) const {
        if (slot >= size()) detail::refuse_slot(slot, size());
        return data_.bodies.handle(slot);
    }
    /// @}

    /// Gives a stored column a value, and wakes a resting body.
    /// \throws std::out_of_range for a stale handle, std::invalid_argument for a value that is not acceptable; the
    ///         world is then as it was
    template <class C, class Q> void write(Handle body, const Q& value);

    /// \name Policies
    /// @{
    /// A policy, with its parameters as they are.
    template <class Policy> const Policy& get() const {
        constexpr bool there = (std::same_as<Policy, P> || ...);
        static_assert(there, "Ansatz: get: this world has no such policy; see the list in its type");
        if constexpr (there) return std::get<Policy>(policies_);
        else return detail::nowhere<Policy>();
    }
    /// Replaces a policy's parameters. A force, effect, response or filter that changes wakes every resting body.
    /// \throws std::invalid_argument if a parameter is not acceptable; the world is then as it was
    template <class Policy> void set(const Policy& policy);
    /// @}

    /// \name Time
    /// @{

    /// One step. A step of zero is exactly nothing.
    /// \param dt finite, not negative, and not so short that digits are lost (smallest_step.hpp)
    /// \throws std::invalid_argument before anything is touched. What a policy throws within the step, or a lack of
    /// memory, leaves
    ///         a world that is lost: it says so (`status()`, any change) until another is assigned to it or loaded
    template <class T> void step(const T& dt);

    /// The simulated time: a whole number of steps, never a sum of them.
    ClockTime time() const { return data_.clock.now(); }
    /// Steps taken.
    std::uint64_t tick() const { return data_.clock.tick(); }
    /// What went wrong inside steps, and what policies have to say; visits every body when it is called.
    Status status() const;
    /// @}

    /// A number that differs, almost surely, when anything of the state differs; equal states have equal hashes in
    /// every build. Policies' parameters are not part of it.
    std::uint64_t hash() const;

    /// What policy `P_` may see of this world: the columns that it declared.
    template <class P_> ObserverView<S, P_> view() const { return ObserverView<S, P_>(data_); }
    /// When the next step begins.
    Context<S> context() const { return inside().context(); }

private:
    friend struct Archive;
    friend struct detail::Key;
    using Data = WorldData<composition>;
    using Slot = Bodies::Slot;
    using Datum = typename detail::DatumOf<P...>::type;
    static constexpr bool has_datum = !std::is_void_v<Datum>;
    using Policies = std::tuple<P...>;

    static const Policies& checked(const Policies& policies) {
        std::apply([](const auto&... policy) { (detail::check_in<S>(policy), ...); }, policies);
        return policies;
    }

    static constexpr void need_datum() {
        static_assert(has_datum, "Ansatz: this world keeps no datum of yours; add Datum<T>{} to its policies");
    }
    template <class E> static constexpr void need_element() {
        static_assert((detail::keeps_element<P, E> || ...),
                      "Ansatz: none of this world's policies keeps such elements; add the one that does, as a Spring "
                      "needs Springs{} and a Rope needs Ropes{}");
    }
    template <class C> static constexpr void need_column() {
        constexpr bool stored = composition::template stores<C>;
        if constexpr (requires { typename C::template Needs<stored>; }) // a column that knows which policy asks for it
            static_assert(sizeof(typename C::template Needs<stored>) > 0);
        else
            static_assert(stored, "Ansatz: this world does not store that column, because none of its policies "
                                  "declares it; add Keep<Column>{} to its policies");
    }

    auto inside() { return Inside<composition, Data, Policies>{data_, policies_, bound_}; }
    auto inside() const { return Inside<composition, const Data, const Policies>{data_, policies_, bound_}; }
    template <class Hook, class... A> void tell(A&&... argument) { inside().template tell<Hook>(argument...); }

    // What keeps it whole: whole.hpp.
    void assign(const World& other);
    void assign(World&& other);
    void get_ready(const char* where);
    [[noreturn, gnu::cold, gnu::noinline]] static void refuse_lost(const char* where);

    template <class Policy> void let_say(Status& status) const;
    void wake_ends(const auto& state, std::uint32_t id);
    TimeStep<S> step_of(const typename S::Time& dt) const;
    template <class Transient, bool Later = false> void take_step(const ClockTime& dt);
    const auto& control() const {
        return std::get<typename detail::FirstIn<typename composition::controls>::type>(policies_);
    }

    template <class Row_, class Property> static void take(Row_& row, const Property& property);
    void grow();
    void make_room_to_come(std::size_t bodies);
    void follow_divisions();

    Policies policies_;
    BoundPolicies<composition> bound_;
    Data data_;
    [[no_unique_address]] detail::DataOfUser<Datum> user_;
    detail::Room capacity_;
    bool lost_ = false; // in the midst of a step, or for ever since one was broken off
};

template <class... P> World(P...) -> World<P...>; ///< the list of policies is the type

} // namespace ansatz
