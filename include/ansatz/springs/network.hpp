// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SpringNetwork`: the springs of a world, as its policies Springs and Ropes keep them.
///
/// A spring lies in one record by its id, so that the loop over all of them reads memory in order and the sums are the
/// same to the bit whatever bodies sleep, wake or are removed. What only some springs need (the place of an anchor) or
/// only some worlds (where it breaks) lies beside it. Ends are ids of bodies: a body that moves to another slot changes
/// nothing here.

#include <ansatz/springs/spring.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/hash.hpp>
#include <ansatz/world/named_by.hpp>
#include <ansatz/world/space.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ansatz {

namespace detail {
template <class S> struct StoredLimit {
    typename S::Scalar force, strain;
};
} // namespace detail

/// \tparam S the space
/// \tparam E Spring or Rope
/// \tparam Damped whether springs have a damping
/// \tparam Breaks whether springs break
template <class S, class E, bool Damped, bool Breaks> class SpringNetwork {
public:
    using Scalar = typename S::Scalar;
    using Description = E;            ///< Spring or Rope
    using Handle_ = ElementHandle<E>; ///< what names one

    static constexpr std::uint32_t no_body = 0xffffffffu; ///< the second end is a point

    /// One spring. Among `pairs` the bodies are named by their slots, elsewhere by their ids.
    struct Link {
        std::uint32_t a;                                                                  ///< a body
        std::uint32_t b;                                                                  ///< another, or `no_body`
        Scalar rest_length;                                                               ///< m
        Scalar stiffness;                                                                 ///< N/m
        [[no_unique_address]] std::conditional_t<Damped, Scalar, detail::Absent> damping; ///< N s/m
    };

    /// A spring between a body and a point, as the loop over all of them wants it.
    struct Hung {
        std::uint32_t a;                                                                  ///< the slot of the body
        Scalar rest_length;                                                               ///< m
        Scalar stiffness;                                                                 ///< N/m
        [[no_unique_address]] std::conditional_t<Damped, Scalar, detail::Absent> damping; ///< N s/m
        typename S::Position anchor;                                                      ///< m
    };

    /// How many there are.
    std::size_t size() const { return ids_.size(); }
    /// Ids ever given out.
    std::size_t ids() const { return ids_.ids(); }
    /// Whether a handle names one that is still there.
    bool contains(const Handle_& h) const { return ids_.contains(h); }
    /// The id of a handle.
    /// \throws std::out_of_range for a stale one
    std::uint32_t id(const Handle_& h, const char* where) const { return ids_.id(h, where); }
    /// All of them, by id.
    std::vector<Handle_> handles() const {
        std::vector<Handle_> all;
        all.reserve(size());
        for_each([&](std::uint32_t id, const Link&) { all.push_back(handle(id)); });
        return all;
    }
    /// The handle of a living one.
    Handle_ handle(std::uint32_t id) const { return {id, ids_.generation(id)}; }
    /// Those that broke in the last step.
    std::span<const Broken<E>> broken() const
        requires Breaks
    {
        return broken_;
    }
    /// Calls `f(id, link)` for each, by id.
    template <class F> [[gnu::always_inline]] void for_each(F&& f) const {
        const auto n = std::uint32_t(links_.size());
        const Link* link = links_.data();
        for (std::uint32_t id = 0; id < n; ++id)
            if (link[id].a != no_body) f(id, link[id]);
    }
    /// One of them.
    const Link& link(std::uint32_t id) const { return links_[id]; }
    /// Where the second end is, if it is a point.
    typename S::Position anchor(std::uint32_t id) const { return anchors_[id]; }
    /// Where it breaks.
    const detail::StoredLimit<S>& limit(std::uint32_t id) const
        requires Breaks
    {
        return limits_[id];
    }

    /// \name By slots, in the order of the ids: valid behind `arrange`
    /// Neither a look-up nor a branch is left in the loop over them; they took a tenth to a fifth of its time.
    /// @{
    const std::vector<Link>& pairs() const { return pairs_; } ///< between bodies
    const std::vector<Hung>& hung() const { return hung_; }   ///< at points
    /// Makes the two lists anew, if springs or the slots of bodies changed since.
    /// \param layout changes whenever bodies change their slots
    void arrange(const Bodies& bodies, std::uint64_t layout) {
        if (arranged_ && layout == layout_) return;
        pairs_.clear();
        hung_.clear();
        for_each([&](std::uint32_t id, const Link& l) {
            const auto a = bodies.slot_of_id(l.a);
            if (l.b != no_body) pairs_.push_back({a, bodies.slot_of_id(l.b), l.rest_length, l.stiffness, l.damping});
            else hung_.push_back({a, l.rest_length, l.stiffness, l.damping, anchors_[id]});
        });
        arranged_ = true;
        layout_ = layout;
        ++arrangement_.value;
    }
    /// Changes whenever they are made anew.
    std::uint64_t arrangement() const { return arrangement_.value; }
    /// @}

    /// What is checked and converted, before anything is changed.
    struct Admitted {
        Link link;                   ///< its ends and numbers
        typename S::Position anchor; ///< m, where the second end is a point
        BreakLimit limit;            ///< where it breaks
    };
    /// Checks a description.
    /// \param where    for the sentence of a refusal
    /// \param spring   what is asked for
    /// \param bodies   of the world
    /// \param position answers where the body in a slot is: the distance is the rest length, where none is given
    /// \param limit    where it breaks, if it may: what `breaks_at` made
    /// \throws std::invalid_argument with name, value and unit; std::out_of_range for a stale handle
    template <class Where, class... Limit>
    Admitted admit(const char* where, const E& spring, const Bodies& bodies, Where&& position,
                   const Limit&... limit) const {
        Admitted in{};
        const bool swapped = !spring.first.is_body();
        const auto& held = swapped ? spring.second : spring.first;
        const auto& other = swapped ? spring.first : spring.second;
        if (!held.is_body()) refuse_value(where, "its ends", "two points", "one end at least is a body");
        const auto a = bodies.slot(held.body(), where);
        in.link.a = held.body().id;
        in.link.b = no_body;
        in.anchor = S::template zero_vector<unit::Length>();
        auto to = in.anchor;
        if (other.is_body()) {
            const auto b = bodies.slot(other.body(), where);
            in.link.b = other.body().id;
            if (in.link.a == in.link.b)
                refuse_value(where, "its ends", "one body", "a spring joins two bodies, or a body and a point");
            to = position(b) - position(a);
        } else {
            if (!other.is_point()) refuse_value(where, "its second end", "not given", "it is a body or a point");
            require_finite(where, "anchor", other.point());
            in.anchor = S::convert("an anchor", other.point());
            to = in.anchor - position(a);
        }
        require_not_negative(where, "stiffness", spring.stiffness);
        require_not_negative(where, "damping", spring.damping);
        in.link.stiffness = S::convert("stiffness", spring.stiffness).value();
        if constexpr (Damped) in.link.damping = S::convert("damping", spring.damping).value();
        else if (spring.damping.value() != 0)
            refuse_value(where, "damping", spring.damping, "the springs of this world are Undamped");
        if (spring.rest_length) {
            require_not_negative(where, "rest length", *spring.rest_length);
            in.link.rest_length = S::convert("rest length", *spring.rest_length).value();
        } else {
            const auto distance = norm(to);
            if (!is_finite(distance))
                refuse_value(where, "rest length", distance, "give it, since the ends are infinitely far apart");
            in.link.rest_length = distance.value();
        }
        (add_limit(where, in, limit), ...);
        return in;
    }

    /// Room for so many. Room for notes is made when a step begins: a loop over broken springs may add new ones.
    void reserve(std::size_t n) {
        ids_.reserve(n);
        anchors_.reserve(n);
        pairs_.reserve(n);
        hung_.reserve(n);
        if constexpr (Breaks) limits_.reserve(n);
        links_.reserve(n); // last: room here means room everywhere
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const SpringNetwork& other) {
        if constexpr (Breaks) broken_.reserve(other.broken_.size());
        reserve(other.ids());
    }
    /// Adds one. With room for it, it cannot fail.
    Handle_ insert(const Admitted& in) {
        const auto id = ids_.take();
        if (id == links_.size()) {
            links_.emplace_back();
            anchors_.emplace_back();
            if constexpr (Breaks) limits_.emplace_back();
        }
        put(id, in);
        return handle(id);
    }
    /// Calls `f(body id)` for each body that it holds.
    template <class F> void for_each_body(std::uint32_t id, F&& f) const {
        f(links_[id].a);
        if (links_[id].b != no_body) f(links_[id].b);
    }
    /// Room for one more, so that `insert` cannot fail.
    void make_room() {
        if (links_.size() == links_.capacity() && ids_.next() == links_.size())
            reserve(std::max<std::size_t>(8, 2 * links_.size()));
    }
    /// Another description for one that is there.
    void replace(std::uint32_t id, const Admitted& in) { put(id, in); }
    /// Removes one.
    void erase(std::uint32_t id) {
        ids_.give_back(id);
        links_[id].a = no_body;
        arranged_ = false;
    }
    /// Calls `f(id)` for each, by id from the last to the first.
    template <class F> void for_each_backwards(F&& f) const {
        for (auto id = std::uint32_t(links_.size()); id-- > 0;)
            if (links_[id].a != no_body) f(id);
    }
    /// A body will be removed: `bodies` is one more than the largest id of one.
    void find_named(std::size_t bodies) { named_by_.find(*this, bodies); }
    /// Whether that is known.
    bool knows_named() const { return named_by_.known(); }
    /// Calls `f(id)` by id for each that holds a body, of which `f` may remove it. Behind `find_named`.
    template <class F> void for_each_naming(std::uint32_t body, F&& f) const {
        named_by_.each(body, [&](std::uint32_t id) {
            if (links_[id].a != no_body && (links_[id].a == body || links_[id].b == body)) f(id);
        });
    }
    /// Whether one of them holds both bodies. What this asks of the network is found when it is first asked, and kept
    /// while springs are added and removed.
    bool joins(std::uint32_t a, std::uint32_t b) const {
        if (!named_by_.known()) {
            std::uint32_t most = 0;
            for_each([&](std::uint32_t id, const Link&) {
                for_each_body(id, [&](std::uint32_t body) { most = std::max(most, body); });
            });
            named_by_.find(*this, std::size_t(most) + 1);
        }
        bool found = false;
        for_each_naming(a, [&](std::uint32_t id) { found = found || links_[id].a == b || links_[id].b == b; });
        return found;
    }
    /// Removes all that hold this body.
    void body_removed(std::uint32_t body) {
        for_each_naming(body, [&](std::uint32_t id) { erase(id); });
    }

    /// The description of a living one.
    E describe_element(std::uint32_t id, const Bodies& bodies) const {
        const auto& l = links_[id];
        E spring;
        spring.first = bodies.handle(bodies.slot_of_id(l.a));
        if (l.b != no_body) spring.second = bodies.handle(bodies.slot_of_id(l.b));
        else spring.second = scalar_cast<double>(anchors_[id]);
        spring.stiffness = static_cast<double>(l.stiffness) * newton_per_metre;
        if constexpr (Damped) spring.damping = static_cast<double>(l.damping) * newton_second_per_metre;
        spring.rest_length = static_cast<double>(l.rest_length) * metre;
        return spring;
    }

    /// Forgets what broke in the step before.
    void begin_step() {
        if constexpr (Breaks) broken_.clear();
    }
    /// Notes that one breaks; it is still there.
    void note_broken(std::uint32_t id, const typename S::template ScalarOf<unit::Force>& tension, const Scalar& strain,
                     const Bodies& bodies)
        requires Breaks
    {
        const auto spring = describe_element(id, bodies);
        broken_.push_back(
            {handle(id), spring.first, spring.second, scalar_cast<double>(tension), static_cast<double>(strain)});
    }
    /// Removes those that were noted behind the first `known`, which were removed in an earlier substep.
    void erase_broken(std::size_t known)
        requires Breaks
    {
        for (const auto& broken : std::span(broken_).subspan(known)) erase(broken.which.id);
    }
    /// Room for the notes of a step.
    void reserve_notes() { ids_.reserve_notes(); }
    /// Room for bodies that a step may make by dividing others: so many there are then.
    void make_room_for_bodies(std::size_t bodies) { named_by_.reserve(bodies); }
    /// Room for all that may break in a step.
    void reserve_notes_of_step() {
        if constexpr (Breaks) broken_.reserve(std::max(ids(), links_.capacity()));
    }
    /// Whether it does nothing where its ends are now: a rope that hangs slack.
    /// \param at a function of a body's id: where it is
    template <class At> bool is_slack([[maybe_unused]] std::uint32_t id, [[maybe_unused]] const At& at) const {
        if constexpr (std::same_as<E, Rope>) {
            const Link& link = links_[id];
            const typename S::Position to = (link.b == no_body ? anchors_[id] : at(link.b)) - at(link.a);
            return !(robust_norm(to).value() > link.rest_length);
        } else return false;
    }

    /// Adds everything to a hash.
    void add_to(StateHash& hash) const {
        ids_.add_to(hash);
        for_each([&](std::uint32_t id, const Link& l) {
            hash.add(std::uint64_t(l.a) << 32 | l.b);
            numbers(*this, id, [&](const char*, const auto& number, NumberIn) { hash.add_number(number); });
            if (l.b == no_body)
                for (int k = 0; k < S::dimension; ++k) hash.add_number(anchors_[id].value()[k]);
        });
    }
    /// Every number of one spring, by the name that it has in a file.
    static void numbers(auto& self, std::uint32_t id, auto&& visit) {
        auto& l = self.links_[id];
        visit("rest length", l.rest_length, NumberIn::not_negative);
        visit("stiffness", l.stiffness, NumberIn::not_negative);
        if constexpr (Damped) visit("damping", l.damping, NumberIn::not_negative);
        if constexpr (Breaks) {
            visit("break force", self.limits_[id].force, NumberIn::positive_or_infinite);
            visit("break strain", self.limits_[id].strain, NumberIn::positive_or_infinite);
        }
    }

private:
    friend struct ElementArchive;

    void put(std::uint32_t id, const Admitted& in) {
        links_[id] = in.link;
        anchors_[id] = in.anchor;
        if constexpr (Breaks) limits_[id] = {Scalar(in.limit.force.value()), Scalar(in.limit.strain)};
        arranged_ = false;
        named_by_.note(id);
    }
    static void add_limit(const char* where, Admitted& in, const BreakLimit& limit) {
        static_assert(Breaks, "Ansatz: the springs of this world do not break; write Springs<Breaking>{} or "
                              "Ropes<Breaking>{} among its policies");
        // In the world's scalar, in which it is kept: what is 0 there would break at once, and no file would take it
        // back.
        if (!(Scalar(limit.force.value()) > Scalar(0)))
            refuse_value(where, "break force", limit.force, "it is greater than 0 N in the world's scalar");
        if (!(Scalar(limit.strain) > Scalar(0)))
            refuse_value(where, "break strain", limit.strain, "it is greater than 0 in the world's scalar");
        static_cast<void>(S::convert("break force", limit.force)); // one that is finite is none that never breaks
        static_cast<void>(S::convert("break strain", Quantity<unit::Dimensionless>::from_value(limit.strain)));
        if (limit.strain < std::numeric_limits<double>::infinity() && !(in.link.rest_length > Scalar(0)))
            refuse_value(where, "break strain", limit.strain, "a spring of rest length 0 has no strain; give a force");
        if (limit.force < in.limit.force) in.limit.force = limit.force;
        if (limit.strain < in.limit.strain) in.limit.strain = limit.strain;
    }
    template <class Other> static void add_limit(const char*, Admitted&, const Other&) {
        constexpr bool is_limit = sizeof(Other) == 0;
        static_assert(is_limit, "Ansatz: World::add and World::set take beside a spring or a rope where it breaks; "
                                "write e.g. breaks_at(50.0 * newton)");
    }

    ElementIds ids_;
    std::vector<Link> links_;                   // by id; one that is gone has no body at its first end
    std::vector<typename S::Position> anchors_; // by id
    [[no_unique_address]] std::conditional_t<Breaks, std::vector<detail::StoredLimit<S>>, detail::Absent> limits_;
    [[no_unique_address]] std::conditional_t<Breaks, std::vector<Broken<E>>, detail::Absent> broken_;
    std::vector<Link> pairs_;
    std::vector<Hung> hung_;
    mutable detail::NamedBy named_by_;
    bool arranged_ = false;
    std::uint64_t layout_ = 0;
    detail::Stamp arrangement_;
};

} // namespace ansatz
