// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Collisions`: what a world holds of its bodies' shapes and contacts, and how contacts are found (notes 2.1).
///
///     positions -> boxes -> broadphase -> filter -> narrowphase -> contacts, by the ids of their bodies -> events
///
/// It is a part of a world's data and exists only where there is a Narrowphase. Bodies that are fixed or at rest are
/// not tested with each other; the contacts that a body had when it fell asleep are kept, and hold it.

#include <ansatz/collision/boxes.hpp>
#include <ansatz/collision/concepts.hpp>
#include <ansatz/collision/contact.hpp>
#include <ansatz/collision/contact_order.hpp>
#include <ansatz/collision/divided_search.hpp>
#include <ansatz/collision/division.hpp>
#include <ansatz/collision/facts.hpp>
#include <ansatz/collision/look_ahead.hpp>
#include <ansatz/collision/near_contacts.hpp>
#include <ansatz/collision/response/contact_pushes.hpp>
#include <ansatz/collision/sleep.hpp>
#include <ansatz/collision/still_boxes.hpp>
#include <ansatz/collision/unbounded.hpp>
#include <ansatz/collision/world_contacts.hpp>
#include <ansatz/world/bodies.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/columns.hpp>
#include <ansatz/world/data.hpp>
#include <ansatz/world/elements.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

template <class C> class SweptCollisions;

/// \tparam C the world's composition
template <class C>
class Collisions
    : public WorldContacts<C>
    , public Division<detail::any_brings_bodies<typename C::keepers, typename C::S>> {
    using Contacts_ = WorldContacts<C>;

public:
    using Contacts_::contacts, Contacts_::ended; ///< as the last step found them
    using S = typename C::S;                     ///< the space
    using Scalar = typename S::Scalar;
    using Narrowphase = typename C::Narrowphase;             ///< of the world
    using Broadphase = typename C::Broadphase;               ///< of the world
    using Shapes = typename Narrowphase::template Shapes<S>; ///< by kind

    Shapes shapes;                 ///< of the bodies, by their ids
    typename S::Time expected{};   ///< the length of the step for which bodies are tested, s
    int parts = 1;                 ///< the number of substeps of the last step
    detail::Movers had_velocities; ///< which slots had one when a response that owns substeps placed the bodies

    /// Whether steps of this world divide bodies.
    static constexpr bool divides = detail::any_brings_bodies<typename C::keepers, S>;

    /// Room for so many bodies; where steps make bodies, also in what a step tests them with.
    void reserve(std::size_t n) {
        detail::reserve_each(n, shapes, sensors_);
        if constexpr (divides) {
            auto& w = working_.value;
            detail::reserve_each(n, this->siblings_, w.boxes, w.ids, w.finder, w.order, w.before, w.pushes, w.near);
            if constexpr (C::anticipates) w.ahead.reserve(n);
            w.still.make_room(n, n);
        }
    }
    /// Room for a body with this id.
    void make_room(std::uint32_t id) {
        shapes.make_room(id);
        if (sensors_.size() <= id) sensors_.resize(std::size_t(id) + 1);
        if constexpr (C::rests)
            if (pulls_.size() <= id) pulls_.resize(std::size_t(id) + 1, S::template zero_vector<unit::Acceleration>());
        if constexpr (divides) this->siblings_.make_room(id);
    }
    /// Room for n bodies behind `ids`, which a step may make by dividing others, and for contacts that they take along.
    void make_room_to_come(std::size_t n, std::size_t ids) {
        make_room(std::uint32_t(ids + n - 1));
        shapes.make_room_for_more(n);
        detail::make_room_for_copies(contacts.acting, contacts.asleep());
    }
    /// A body has been divided (division.hpp). What acts in the next step is searched for again.
    void body_divided(const Bodies& bodies, std::uint32_t id, std::uint32_t part) {
        shapes.copy(id, part);
        sensors_[part] = sensors_[id];
        if constexpr (C::rests) pulls_[part] = pulls_[id];
        if constexpr (divides) this->siblings_.divided(id, part);
        contacts.changed();
        detail::copy_contacts(contacts.acting, bodies.handle(bodies.slot_of_id(id)),
                              bodies.handle(bodies.slot_of_id(part)));
        stale_ = true;
    }
    /// Whether an assignment cannot fail where there is room.
    static constexpr bool assigns_in_place = Shapes::assigns_in_place;
    /// Room for the contents of another, so that assigning it cannot fail.
    void make_room_for(const Collisions& other) {
        shapes.make_room_for(other.shapes);
        contacts.make_room_for(other.contacts);
        ended.reserve(other.ended.size());
        sensors_.reserve(other.sensors_.size());
        pulls_.reserve(other.pulls_.size());
        if constexpr (divides) this->siblings_.make_room_for(other.siblings_);
    }
    /// Whether two bodies intersect now, whatever a filter says.
    template <class Data> bool intersect(const Data& data, std::uint32_t a, std::uint32_t b) const {
        const auto at = [&](std::uint32_t id) { return data.lanes.template get<Position>(data.bodies.slot_of_id(id)); };
        Contact<S> contact;
        return Narrowphase::template collide_bodies<S>(shapes, a, at(a), b, at(b), contact);
    }
    /// Whether a body is a sensor.
    bool is_sensor(std::uint32_t id) const { return sensors_[id] != 0; }
    /// Makes it one.
    void set_sensor(std::uint32_t id, bool is) { sensors_[id] = is; }
    /// A removed body takes its shape with it. Its contacts end in the next step: a caller may be iterating over them.
    void body_removed(std::uint32_t id) {
        shapes.erase(id);
        working_.value.still.forget(id);
        if constexpr (divides) this->siblings_.leave(id);
        if (id < pulls_.size()) pulls_[id] = S::template zero_vector<unit::Acceleration>(); // for the next body
        this->body_gone(id);
    }
    /// The acceleration that pulled at a resting body when it fell asleep, m/s^2; zero for one that was added asleep.
    typename S::Acceleration pull_when_it_slept(std::uint32_t id) const {
        return id < pulls_.size() ? pulls_[id] : S::template zero_vector<unit::Acceleration>();
    }
    /// A body falls asleep.
    void slept(std::uint32_t id, const typename S::Acceleration& pull) { pulls_[id] = pull; }
    /// Velocities before a pass over the contacts.
    auto& before_solving() { return working_.value.before; }
    /// The solver of contacts that are answered together.
    auto& pushes() { return working_.value.pushes; }
    /// The pairs that nearly touch.
    auto& near() { return working_.value.near; }
    /// The parameters of the broadphase have changed.
    void new_broadphase() { working_.value.finder.reset(); }

    /// Finds the contacts of the present positions.
    /// \param pull a function of a slot: the acceleration of an awake body, m/s^2
    /// \param later whether this is a substep and not the first
    template <class Data, class Policies, class Pull>
    void detect(Data& data, const Policies& policies, const Pull& pull, bool later) {
        if (working_.value.as_before && !stale_ && !this->any_gone() && !data.bodies.any_goes())
            return this->go_on(later);
        this->wake_contacts(data);
        if (!later) contacts.sleep_on();
        this->part_siblings([&](std::uint32_t a, std::uint32_t b) { return intersect(data, a, b); });
        find(data, policies, pull);
        stale_ = false;
        if constexpr (C::acts_next) {
            hand_over(data, NextStep{}, working_.value.found);
            const auto& acting = std::as_const(data).template state<typename detail::FirstIn<NextStep>::type>();
            using Acting = std::remove_cvref_t<decltype(acting)>;
            this->compare(working_.value.found, later, detail::KeepThoseThatTouch<C::substeps, Acting>(acting));
        } else this->compare(working_.value.found, later, detail::KeepAll());
        working_.value.as_before = !data.bodies.any_goes();
        this->put_contacts_to_sleep(data, std::exchange(working_.value.kept, {}).asleep);
    }
    /// Bodies were added or changed between two steps: brings the contacts of the next step up to date.
    /// \return whether contacts were found anew
    template <class Data, class Policies, class Pull>
    bool refresh(Data& data, const Policies& policies, const Pull& pull) {
        if (!stale_) return false;
        working_.value.as_before = false;
        if constexpr (C::acts_next) {
            this->wake_contacts(data);
            find(data, policies, pull);
            hand_over(data, NextStep{}, working_.value.found);
        }
        stale_ = false; // last: after an exception contacts are still stale
        return true;
    }
    /// Forces that are asked for between two steps are those of the present contacts; the next step finds its own.
    template <class Data, class Policies> void refresh_between_steps(Data& data, const Policies& policies) {
        if constexpr (C::acts_next)
            if (refresh(data, policies, [](Bodies::Slot) { return S::template zero_vector<unit::Acceleration>(); }))
                stale_ = true;
    }
    /// A step of this length is about to be taken: what may come to touch in it is searched for.
    void expect(const typename S::Time& dt) {
        if (dt != expected)
            stale_ = true; // a shorter one, too: a world that was loaded searches again, and finds the same
        expected = dt;
    }
    /// Bodies were moved.
    void make_stale() { stale_ = true; }

private:
    using typename Contacts_::NextStep;

    /// The present contacts, sorted, into `found`.
    template <class Data, class Policies, class Pull>
    void find(const Data& data, const Policies& policies, const Pull& pull) {
        auto& w = working_.value;
        w.found.clear();
        if constexpr (C::holds_near) w.near.all.clear();
        if (data.bodies.any_goes()) find_among_moving(data, policies, pull);
        if constexpr (C::continuous)
            static_cast<typename Narrowphase::template Collisions<C>&>(*this).add_impacts(data, w.found);
        const auto before = w.found.size();
        w.kept = detail::keep_contacts_at_rest(data, w.found);
        w.order.sort(w.found, data.bodies.ids(), w.found.size() - before);
        if constexpr (C::holds_near) w.order.sort(w.near.all, data.bodies.ids());
        if (C::continuous || w.kept.twice)
            detail::keep_the_first_of_each_pair(w.found); // of what the discrete functions found and what was added
    }
    template <class Data, class Policies, class Pull>
    void find_among_moving(const Data& data, const Policies& policies, [[maybe_unused]] const Pull& pull) {
        auto& w = working_.value;
        [[maybe_unused]] const auto going = [&](auto slot) { return data.load(slot).template get<Velocity>(); };
        if constexpr (C::anticipates) w.ahead.begin(data.bodies, expected, pull, going);
        if constexpr (C::holds_near) w.near.begin(data.bodies, pull, going);
        gather(data);
        if constexpr (Narrowphase::any_unbounded) unbounded(data, policies); // first: ground and walls have low ids
        if constexpr (Narrowphase::any_bounded) {
            if (!w.finder) detail::make_finder<divides>(w.finder, std::get<Broadphase>(policies), w.ids.capacity());
            Unfinished unfinished{&w.finder};
            if constexpr (C::executed) // flattened: g++ would call the copying of a point for each contact
                w.search.template find<Broadphase>(
                    detail::runner_of<C>(policies), *w.finder, w.boxes,
                    [&](std::size_t i, std::size_t j, auto& share) __attribute__((flatten)) {
                        test(data, policies, w.ids[i], w.ids[j], share.contacts, &share.near);
                    },
                    w.found, near_list());
            else
                w.finder->find(
                    w.boxes, [&](std::size_t i, std::size_t j) __attribute__((flatten)) {
                        test(data, policies, w.ids[i], w.ids[j], w.found, near_list());
                    });
            unfinished.finder = nullptr;
        }
    }
    template <class Data, class... R>
    void hand_over([[maybe_unused]] Data& data, Types<R...>, [[maybe_unused]] const std::vector<Contact<S>>& all) {
        (data.template state<R>().take(data, all), ...);
    }

    struct Working {                    // what is named with `conditional` only where it is used
        Boxes<S> boxes;                 // the awake, the moving, then the resting and the fixed
        std::vector<std::uint32_t> ids; // the bodies of these boxes
        std::optional<typename Broadphase::template In<S>> finder;
        std::vector<Contact<S>> found;
        detail::ContactsKept kept;
        ContactOrder<S> order;
        std::vector<Vector<Scalar, S::dimension>> before; // velocities, by slot
        [[no_unique_address]] std::conditional_t<C::anticipates, LookAhead<S>, detail::NotAhead> ahead;
        StillBoxes<S> still;    // boxes of bodies that are fixed or at rest
        bool as_before = false; // whether no body could move when contacts were found last
        [[no_unique_address]] std::conditional_t<C::as_one, ContactPushes<S>, detail::Absent> pushes;
        [[no_unique_address]] std::conditional_t<C::holds_near, NearContacts<S>, detail::NoNear> near;
        [[no_unique_address]] std::conditional_t<C::executed, DividedSearch<S, C::holds_near>, detail::NoDividedSearch>
            search;
    };

    /// A search that was broken off leaves nothing behind that disturbs the next one.
    struct Unfinished {
        std::optional<typename Broadphase::template In<S>>* finder;
        ~Unfinished() {
            if (finder) finder->reset();
        }
    };

    template <class Data> void gather(const Data& data) {
        auto& w = working_.value;
        const auto resize = [&](std::size_t size) { w.boxes.resize(size), w.ids.resize(size); };
        if (w.ids.capacity() < data.bodies.size())
            detail::reserve_each(std::max(data.bodies.size(), 2 * w.ids.capacity()), w.boxes, w.ids);
        resize(data.bodies.count(Motion::awake) + data.bodies.count(Motion::moving));
        std::size_t n = 0;
        for (const auto motion : {Motion::awake, Motion::moving}) n = gather_range(data, motion, n);
        w.boxes.set_active(n);
        if (most_are_still(data, n)) {
            resize(n);
            return gather_near(data);
        }
        resize(data.bodies.size());
        for (const auto motion : {Motion::resting, Motion::fixed}) n = gather_range(data, motion, n);
        resize(n);
    }
    /// Whether to search for the still bodies that are near to moving ones, instead of giving all of them to the
    /// broadphase. Not where a plane moves, since it may meet every body.
    template <class Data> bool most_are_still(const Data& data, std::size_t active) {
        if (C::rests && data.bodies.size() >= StillBoxes<S>::fewest) // room before they are asleep
            working_.value.still.make_room(data.bodies.size(), data.bodies.ids());
        const std::size_t still = data.bodies.count(Motion::resting) + data.bodies.count(Motion::fixed);
        bool few_move = still >= StillBoxes<S>::fewest && still >= 2 * active;
        if (few_move)
            Narrowphase::for_each_kind([&]<class Kind>() {
                if constexpr (!Kind::bounded)
                    for (const auto id : shapes.template owners<Kind>())
                        few_move = few_move && !data.bodies.goes(data.bodies.slot_of_id(id));
            });
        return few_move;
    }
    template <class Data> void gather_near(const Data& data) {
        auto& w = working_.value;
        typename StillBoxes<S>::Places places;
        for (int k = 0; k < S::dimension; ++k) places[std::size_t(k)] = data.lanes.template lane<Position>(k);
        w.still.follow(data.bodies, assigned_.value, places,
                       [&](std::size_t slot, auto& lower, auto& upper) { return box_of(data, slot, lower, upper); });
        w.still.begin_asking();
        for (std::size_t i = 0; i < w.boxes.active(); ++i)
            w.still.each_near(w.boxes.lower_corner(i), w.boxes.upper_corner(i),
                              [&](std::uint32_t id, const auto& lower, const auto& upper) {
                                  w.boxes.push_back(lower, upper);
                                  w.ids.push_back(id);
                              });
    }
    /// The box of a body, if it has one and it is finite; World::status reports the others.
    /// \return whether there is one
    template <class Data>
    [[gnu::always_inline]] bool box_of(const Data& data, std::size_t slot, auto& lower, auto& upper) const {
        bool is = false;
        shapes.visit(data.bodies.id(slot), [&](const auto& shape) {
            if constexpr (std::remove_cvref_t<decltype(shape)>::description::bounded) {
                shape.bounds(data.lanes.template get<Position>(slot), lower, upper);
                is = is_finite(lower) && is_finite(upper);
            }
        });
        return is;
    }
    template <class Data>
    [[gnu::flatten, gnu::noinline]] std::size_t gather_range(const Data& data, Motion motion, std::size_t n) {
        auto& w = working_.value;
        for (std::size_t slot = data.bodies.begin(motion); slot < data.bodies.end(motion); ++slot) {
            typename S::Position lower, upper;
            if (!box_of(data, slot, lower, upper)) continue;
            if constexpr (C::anticipates) w.ahead.widen(data.bodies, slot, lower, upper);
            if constexpr (C::holds_near) w.near.widen(slot, lower, upper);
            if (!is_finite(lower) || !is_finite(upper)) continue;
            w.boxes.set(n, lower, upper);
            w.ids[n++] = data.bodies.id(slot);
        }
        return n; // boxes so far
    }

    /// Where pairs that nearly touch are noted, if they are.
    std::vector<Contact<S>>* near_list() {
        if constexpr (C::holds_near) return &working_.value.near.all;
        else return nullptr;
    }
    /// The narrowphase of two bodies: into `found`, or into `near` those that nearly touch.
    template <class Data, class Policies>
    [[gnu::always_inline]] void test(const Data& data, [[maybe_unused]] const Policies& policies, std::uint32_t i,
                                     std::uint32_t j, std::vector<Contact<S>>& found,
                                     [[maybe_unused]] std::vector<Contact<S>>* near) const {
        const auto a = i < j ? i : j, b = i < j ? j : i;
        const auto slot_a = data.bodies.slot_of_id(a), slot_b = data.bodies.slot_of_id(b);
        if (this->were_one(a, b)) return;
        if (!detail::pass<S>(policies, data, slot_a, slot_b, typename C::filters{})) return;
        Contact<S> contact;
        if constexpr (C::anticipates) {
            if (!working_.value.ahead.template meet<Narrowphase>(data, a, slot_a, b, slot_b, contact)) return;
        } else if (!Narrowphase::template collide_bodies<S>(shapes, a, data.lanes.template get<Position>(slot_a), b,
                                                            data.lanes.template get<Position>(slot_b), contact)) {
            if constexpr (C::holds_near)
                working_.value.near.template test<Narrowphase>(data, a, slot_a, b, slot_b, *near);
            return;
        }
        contact.first = data.bodies.handle(slot_a);
        contact.second = data.bodies.handle(slot_b);
        detail::append(found, contact);
    }

    /// Shapes without a box, such as planes, are tested against all that have one, but for those that they surely miss.
    template <class Data, class Policies> void unbounded(const Data& data, const Policies& policies) {
        auto& w = working_.value;
        Narrowphase::for_each_kind([&]<class Kind>() {
            if constexpr (!Kind::bounded)
                for (const auto id : shapes.template owners<Kind>()) {
                    const auto slot = data.bodies.slot_of_id(id);
                    const auto* still = data.bodies.goes(slot) ? nullptr : &shapes.template get<Kind>(id);
                    detail::each_box_near(w.boxes, still ? w.boxes.active() : w.boxes.size(), still,
                                          data.lanes.template get<Position>(slot), [&](std::size_t i) {
                                              test(data, policies, id, w.ids[i], w.found, near_list());
                                          });
                }
        });
    }

    friend struct CollisionArchive;
    template <class> friend class SweptCollisions;
    bool stale_ = false;                          // the contacts do not belong to the present positions
    std::vector<std::uint8_t> sensors_;           // by id
    std::vector<typename S::Acceleration> pulls_; // by id
    detail::Cache<Working> working_;
    detail::Stamp assigned_; // changes when another world is assigned, whose `working_` does not come along
};

} // namespace ansatz
