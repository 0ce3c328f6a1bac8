// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ElementTable`: where a policy of your own keeps its elements: ties between bodies, thrusters on one, pools on none.
///
/// You write the description that `world.add` takes, and the row that is kept of it. From the fields of the row it
/// follows how elements are copied, hashed, saved and loaded, and which go with a body: a `BodyId` among the fields
/// names a body, and the row goes when that body does.
///
/// \snippet tests/world/element_table.cpp tie
///
/// A row says `from(asked, description)`, which checks and converts: `asked.body(handle)` answers with the id of a
/// body that is there, `asked.position(handle)` where it is, `asked.where` is the verb's name for a sentence. It may
/// say `describe(handle_of)`, for `world.get(handle)`, and `check()`, which throws std::invalid_argument; it is called
/// for rows that are added and for rows of a file.
///
/// A table that is derived from it and keeps a number beside its rows says so in `fields`, as a row does, and adds it
/// to the hash in an `add_to` of its own.

#include <ansatz/world/elements.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/named_by.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

/// What `from` of a row may ask.
/// \tparam Where a function of a slot: where the body is
template <class Where> struct ElementAsked {
    const char* where;    ///< the verb, e.g. "World::add"
    const Bodies& bodies; ///< of the world
    const Where& place;   ///< answers where the body of a slot is, m

    /// The id of a body.
    /// \throws std::out_of_range for a stale handle
    BodyId body(Handle h) const {
        bodies.slot(h, where);
        return {h.id};
    }
    /// Where a body is, m.
    /// \throws std::out_of_range for a stale handle
    auto position(Handle h) const { return place(bodies.slot(h, where)); }
};

/// \tparam S   the space
/// \tparam E   the description: `using element = E;`
/// \tparam Row what is kept of one, with its `fields`
template <class S, class E, class Row> class ElementTable {
    static_assert(Element<E>, "Ansatz: ElementTable: the description of an element says that it is one: "
                              "`using element = ...;`, its own name");
    static_assert(detail::NamesFields<Row>, "Ansatz: ElementTable: a row needs `static void fields(auto& self, auto&& "
                                            "field)`, which calls field(\"name\", self.name) for each of its members");

public:
    using Handle_ = ElementHandle<E>; ///< what names one
    using Row_ = Row;                 ///< what is kept of one

    /// How many there are.
    std::size_t size() const { return ids_.size(); }
    /// Ids ever given out.
    std::size_t ids() const { return ids_.ids(); }
    /// Whether a handle names one that is still there.
    bool contains(const Handle_& h) const { return ids_.contains(h); }
    /// The id of a handle.
    /// \throws std::out_of_range for a stale one
    std::uint32_t id(const Handle_& h, const char* where) const { return ids_.id(h, where); }
    /// The handle of a living one.
    Handle_ handle(std::uint32_t id) const { return {id, ids_.generation(id)}; }
    /// All of them, by id.
    std::vector<Handle_> handles() const {
        std::vector<Handle_> all;
        all.reserve(size());
        for_each([&](std::uint32_t id, const Row&) { all.push_back(handle(id)); });
        return all;
    }
    /// What is kept of one.
    const Row& row(std::uint32_t id) const { return rows_[id]; }
    /// The same, for the systems of the policy, which may change numbers that add up over time.
    Row& row(std::uint32_t id) { return rows_[id]; }
    /// Calls `f(id, row)` for each, by id: an order that does not depend on earlier removals.
    template <class F> void for_each(F&& f) const {
        for (std::uint32_t id = 0; id < rows_.size(); ++id)
            if (ids_.alive(id)) f(id, rows_[id]);
    }
    /// The same, to change them.
    template <class F> void for_each(F&& f) {
        for (std::uint32_t id = 0; id < rows_.size(); ++id)
            if (ids_.alive(id)) f(id, rows_[id]);
    }

    /// \name What a world asks
    /// @{

    /// Checks a description, before anything is changed.
    template <class Where, class... Option>
    Row admit(const char* where, const E& description, const Bodies& bodies, const Where& place,
              const Option&...) const {
        static_assert(sizeof...(Option) == 0, "Ansatz: World::add takes nothing beside the description of an element "
                                              "of your own; let the description hold it");
        const ElementAsked<Where> asked{where, bodies, place};
        constexpr bool made = requires { Row(Row::from(asked, description)); };
        static_assert(made, "Ansatz: World::add: an element is kept as a row, and nothing makes one of its "
                            "description; give the row `static Row from(const auto& asked, const Description& d)`");
        if constexpr (made) {
            Row row = Row::from(asked, description);
            if constexpr (requires { row.check(); }) row.check();
            return row;
        }
    }
    /// Room for so many.
    void reserve(std::size_t n) {
        ids_.reserve(n);
        rows_.reserve(n); // last: room here means room everywhere
    }
    /// Room for one more, so that `insert` cannot fail.
    void make_room() {
        if (rows_.size() == rows_.capacity() && ids_.next() == rows_.size())
            reserve(std::max<std::size_t>(8, 2 * rows_.size()));
    }
    /// Room for what another holds, so that assigning it cannot fail.
    void make_room_for(const ElementTable& other)
        requires std::is_trivially_destructible_v<Row>
    {
        reserve(other.ids());
    }
    /// Room for every element to be removed.
    void reserve_notes() { ids_.reserve_notes(); }
    /// Adds one. With room for it, it cannot fail where a row can be moved.
    Handle_ insert(Row row) {
        const auto id = ids_.take();
        if (id == rows_.size()) rows_.push_back(std::move(row));
        else rows_[id] = std::move(row);
        named_by_.note(id);
        return handle(id);
    }
    /// Another description for one that is there.
    void replace(std::uint32_t id, Row row) {
        rows_[id] = std::move(row);
        named_by_.note(id);
    }
    /// Removes one.
    void erase(std::uint32_t id) { ids_.give_back(id); }
    /// Calls `f(body id)` for each body that an element names.
    template <class F> void for_each_body(std::uint32_t id, F&& f) const {
        Row::fields(rows_[id], [&](std::string_view, const auto& x) { detail::each_body_in(x, f); });
    }
    /// Calls `f(id)` for each, by id from the last to the first.
    template <class F> void for_each_backwards(F&& f) const {
        for (auto id = std::uint32_t(rows_.size()); id-- > 0;)
            if (ids_.alive(id)) f(id);
    }
    /// A body will be removed: `bodies` is one more than the largest id of one.
    void find_named(std::size_t bodies) { named_by_.find(*this, bodies); }
    /// Whether that is known.
    bool knows_named() const { return named_by_.known(); }
    /// Calls `f(id)` by id for each element that names a body, of which `f` may remove it. Behind `find_named`.
    template <class F> void for_each_naming(std::uint32_t body, F&& f) const {
        named_by_.each(body, [&](std::uint32_t id) {
            bool names = false;
            if (ids_.alive(id)) for_each_body(id, [&](std::uint32_t one) { names = names || one == body; });
            if (names) f(id);
        });
    }
    /// Removes all that name this body.
    void body_removed(std::uint32_t body) {
        for_each_naming(body, [&](std::uint32_t id) { erase(id); });
    }
    /// The description of a living one.
    E describe_element(std::uint32_t id, const Bodies& bodies) const {
        const auto handle_of = [&](BodyId body) { return bodies.handle(bodies.slot_of_id(body.id)); };
        constexpr bool describes = requires { E(rows_[id].describe(handle_of)); };
        static_assert(describes, "Ansatz: World::get: the rows of these elements cannot be described; give the row "
                                 "`describe(const auto& handle_of) const`, which answers with a description; "
                                 "handle_of(id) is the handle of a body");
        if constexpr (describes) return rows_[id].describe(handle_of);
        else return E();
    }
    /// Adds everything to a hash.
    void add_to(StateHash& hash) const {
        ids_.add_to(hash);
        for_each([&](std::uint32_t, const Row& row) { detail::hash_fields<true>(hash, row); });
    }
    /// @}

private:
    friend struct ElementArchive;

    ElementIds ids_;
    std::vector<Row> rows_; // by id
    detail::NamedBy named_by_;
};

} // namespace ansatz
