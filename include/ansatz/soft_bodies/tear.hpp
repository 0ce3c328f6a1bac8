// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How a sheet tears: what becomes of springs, hinges, sails and vertices when some of its triangles are torn. Use
/// `Tearing` (soft_bodies/tearing.hpp), which says the rules; this is for changing them.
///
/// A step in which nothing breaks reads nothing here. One with a break costs one visit of each triangle, hinge, sail
/// and spring, as finding out what breaks does; the triangles are sorted by their corners for it, in room that was made
/// before the step.

#include <ansatz/soft_bodies/area.hpp>
#include <ansatz/soft_bodies/bending.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/soft_bodies/wind.hpp>
#include <ansatz/springs/springs.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {

/// What a tear takes, or hands on.
using TornElements = Types<Spring, Rope, Hinge, Sail, Membrane>;

/// One tear of a world.
template <class S, class View> class Tear {
    using Row_ = TearableRow<S>;
    static constexpr std::uint32_t none = 0xffffffffu;

public:
    /// \param table the triangles, `view.state()`
    Tear(View& view, auto& table)
        : view_(view), table_(table), corners_(table.scratch.value.corners), before_(table.scratch.value.before) {}

    /// Tears the triangles of which a spring along an edge has broken.
    /// \return whether there was one
    bool take_broken() {
        bool any = false;
        each_network([&](auto& springs) {
            for (const auto& broken : springs.broken()) {
                if (!broken.first.is_body() || !broken.second.is_body()) continue;
                if (corners_are_stale_) sort_corners();
                const auto b = broken.second.body().id;
                each_at(broken.first.body().id, [&](std::uint32_t id) {
                    auto& row = table_.row(id);
                    if (row.torn || !row.has(b)) return;
                    row.torn = true;
                    any = true;
                });
            }
        });
        return any;
    }

    /// Removes what was on torn triangles.
    void remove_what_is_torn() {
        remember();
        each_on_triangles<Sail>([&](auto& table, std::uint32_t id, const auto& row) {
            if (is_torn(find(row.corners[0], row.corners[1], row.corners[2]))) table.erase(id);
        });
        each_on_triangles<Membrane>([&](auto& table, std::uint32_t id, const auto& row) {
            if (is_torn(find(row.corners[0], row.corners[1], row.corners[2]))) table.erase(id);
        });
        each_on_triangles<Hinge>([&](auto& table, std::uint32_t id, const auto& row) {
            const auto [a, b, c, d] = row.bodies;
            if (is_torn(find(a, b, c)) || is_torn(find(a, b, d))) table.erase(id);
        });
        each_spring([&](auto& springs, std::uint32_t id, const auto& link) {
            if (!is_edge(link.a, link.b) && (reaches_past_torn(link.a, link.b) || reaches_past_torn(link.b, link.a)))
                springs.erase(id);
        });
    }

    /// Gives each side of a vertex that hangs together by it alone a body of its own.
    /// \param room for how many in all, those of earlier steps included
    void split(std::size_t room) {
        table_.waiting = 0;
        const auto made = table_.split;
        for (std::size_t first = 0, last = 0; first < corners_.size(); first = last) {
            const auto body = corners_[first].body;
            bool torn = false;
            for (last = first; last < corners_.size() && corners_[last].body == body; ++last)
                torn = torn || before_[corners_[last].triangle].torn;
            if (torn && view_.motion(view_.slot_of_id(body)) < Motion::moving) split_vertex(body, first, last, room);
        }
        if (table_.split != made) hand_on();
    }

private:
    // The triangles by their corners, as they were when the step's tear began.

    void sort_corners() {
        corners_are_stale_ = false;
        corners_.clear();
        table_.for_each([&](std::uint32_t id, const Row_& row) {
            for (const BodyId corner : row.corners) corners_.push_back({corner.id, id});
        });
        std::sort(corners_.begin(), corners_.end());
    }
    void remember() {
        before_.clear();
        for (std::uint32_t id = 0; id < table_.ids(); ++id) before_.push_back(table_.row(id));
    }
    /// Calls `f(triangle)` by id for each with this corner.
    template <class F> void each_at(std::uint32_t body, F&& f) const {
        auto at = std::lower_bound(corners_.begin(), corners_.end(), TriangleCorner{body, 0});
        for (; at != corners_.end() && at->body == body; ++at) f(at->triangle);
    }
    /// The triangle with these corners, or `none`.
    std::uint32_t find(BodyId a, BodyId b, BodyId c) const {
        std::uint32_t found = none;
        each_at(a.id, [&](std::uint32_t id) {
            if (found == none && before_[id].has(b.id) && before_[id].has(c.id)) found = id;
        });
        return found;
    }
    bool is_torn(std::uint32_t triangle) const { return triangle != none && before_[triangle].torn; }
    bool is_edge(std::uint32_t a, std::uint32_t b) const {
        bool edge = false;
        each_at(a, [&](std::uint32_t id) { edge = edge || before_[id].has(b); });
        return edge;
    }
    /// Whether a torn triangle at `a` has another corner that an edge joins with `b`.
    bool reaches_past_torn(std::uint32_t a, std::uint32_t b) const {
        bool reaches = false;
        each_at(a, [&](std::uint32_t id) {
            if (!before_[id].torn || before_[id].has(b)) return;
            for (const BodyId middle : before_[id].corners)
                reaches = reaches || (middle.id != a && is_edge(middle.id, b));
        });
        return reaches;
    }

    // The elements that others keep.

    template <class F> void each_network(F&& f) {
        const auto one = [&](const auto& springs) {
            if constexpr (requires { springs.broken(); }) f(springs);
        };
        one(view_.template elements<Spring>());
        one(view_.template elements<Rope>());
    }
    template <class E, class F> void each_on_triangles(F&& f) {
        auto& table = view_.template edit<E>();
        if constexpr (requires { table.size(); })
            table.for_each([&](std::uint32_t id, const auto& row) { f(table, id, row); });
    }
    /// Springs and ropes between bodies.
    template <class F> void each_spring(F&& f) {
        const auto one = [&](auto& springs) {
            if constexpr (requires { springs.size(); })
                springs.for_each([&](std::uint32_t id, const auto& link) {
                    if (link.b != springs.no_body) f(springs, id, link);
                });
        };
        one(view_.template edit<Spring>());
        one(view_.template edit<Rope>());
    }

    // Vertices.

    /// The triangles around a vertex that are whole, in fans: those of one fan hang together by edges.
    /// \return how many fans there are; they are numbered by their first triangles
    std::uint32_t find_fans(std::uint32_t body, std::size_t first, std::size_t last) {
        auto& around = table_.scratch.value.around;
        auto& fans = table_.scratch.value.fans;
        around.clear();
        for (; first != last; ++first)
            if (!before_[corners_[first].triangle].torn) around.push_back(corners_[first].triangle);
        fans.assign(around.size(), none);
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < around.size(); ++i) {
            if (fans[i] != none) continue;
            fans[i] = count;
            for (bool grown = true; grown;) {
                grown = false;
                for (std::size_t j = 0; j < around.size(); ++j)
                    for (std::size_t k = 0; k < around.size() && fans[j] == none; ++k)
                        if (fans[k] == count && share_an_edge(before_[around[j]], before_[around[k]], body)) {
                            fans[j] = count;
                            grown = true;
                        }
            }
            ++count;
        }
        return count;
    }
    static bool share_an_edge(const Row_& one, const Row_& other, std::uint32_t at) {
        for (const BodyId corner : one.corners)
            if (corner.id != at && other.has(corner.id)) return true;
        return false;
    }
    /// The fraction of the mass that goes with these areas. Beside a side that is larger by more than rounding can
    /// tell, a side gets the least share that leaves both of them a mass: with none its inverse mass would be infinite.
    static typename S::Scalar share_of(typename S::Scalar goes, typename S::Scalar stays) {
        using Scalar = typename S::Scalar;
        const Scalar least = std::numeric_limits<Scalar>::epsilon(), most = Scalar(1) - least;
        const Scalar share = goes / (goes + stays);
        if (!(share >= least)) return least; // areas whose sum is no number either
        return share > most ? most : share;
    }
    void split_vertex(std::uint32_t body, std::size_t first, std::size_t last, std::size_t room) {
        const auto count = find_fans(body, first, last);
        const auto& around = table_.scratch.value.around;
        const auto& fans = table_.scratch.value.fans;
        for (std::uint32_t fan = 1; fan < count; ++fan) {
            if (table_.split >= room) {
                table_.waiting += count - fan;
                return;
            }
            typename S::Scalar goes(0), stays(0); // m^2, of this fan, and of the others that have not gone yet
            for (std::size_t i = 0; i < around.size(); ++i)
                if (fans[i] == 0 || fans[i] >= fan) (fans[i] == fan ? goes : stays) += before_[around[i]].area.value();
            const auto part = view_.divide(body, share_of(goes, stays));
            for (std::size_t i = 0; i < around.size(); ++i)
                if (fans[i] == fan) {
                    Row_ row = table_.row(around[i]);
                    row.corners[row.corner_of(body)] = BodyId{part};
                    table_.replace(around[i], row);
                }
            ++table_.split;
            table_.split_vertices.push_back({view_.handle_of_id(body), view_.handle_of_id(part)});
        }
    }

    // What goes with the triangles to their new corners.

    /// The body that a corner of a triangle is now.
    BodyId now(std::uint32_t triangle, std::uint32_t corner) const {
        return table_.row(triangle).corners[before_[triangle].corner_of(corner)];
    }
    void hand_on() {
        const auto to_corners = [&](auto& table, std::uint32_t id, auto row) {
            const auto t = find(row.corners[0], row.corners[1], row.corners[2]);
            if (t == none) return;
            const auto were = row.corners;
            for (BodyId& corner : row.corners) corner = now(t, corner.id);
            if (row.corners != were) table.replace(id, row);
        };
        each_on_triangles<Sail>(to_corners);
        each_on_triangles<Membrane>(to_corners);
        each_on_triangles<Hinge>([&](auto& table, std::uint32_t id, auto row) {
            const auto were = row.bodies;
            const auto left = find(were[0], were[1], were[2]), right = find(were[0], were[1], were[3]);
            if (left == none || right == none) return;
            row.bodies = {now(left, were[0].id), now(left, were[1].id), now(left, were[2].id), now(right, were[3].id)};
            if (row.bodies != were) table.replace(id, row);
        });
        each_spring([&](auto& springs, std::uint32_t id, const auto& link) {
            if (is_edge(link.a, link.b)) hand_on_edge(springs, id, link.a, link.b);
            else hand_on_across(springs, id, link.a, link.b);
        });
    }
    /// A spring along an edge goes with a whole triangle; a thread stays where it is.
    void hand_on_edge(auto& springs, std::uint32_t id, std::uint32_t a, std::uint32_t b) const {
        std::uint32_t whole = none;
        each_at(a, [&](std::uint32_t t) {
            if (whole == none && !before_[t].torn && before_[t].has(b)) whole = t;
        });
        if (whole != none) put(springs, id, now(whole, a), now(whole, b));
    }
    /// One from a triangle past a corner to another triangle goes with both, as long as that corner is one body.
    void hand_on_across(auto& springs, std::uint32_t id, std::uint32_t a, std::uint32_t b) const {
        bool across = false, done = false;
        BodyId first{}, second{};
        each_at(a, [&](std::uint32_t t) {
            if (done || before_[t].torn) return;
            for (const BodyId middle : before_[t].corners)
                if (middle.id != a)
                    each_at(b, [&](std::uint32_t u) {
                        if (done || before_[u].torn || !before_[u].has(middle.id)) return;
                        across = true;
                        if (!(now(t, middle.id) == now(u, middle.id))) return;
                        done = true;
                        first = now(t, a);
                        second = now(u, b);
                    });
        });
        if (done) put(springs, id, first, second);
        else if (across) springs.erase(id);
    }
    static void put(auto& springs, std::uint32_t id, BodyId a, BodyId b) {
        auto link = springs.link(id);
        if (link.a == a.id && link.b == b.id) return;
        link.a = a.id;
        link.b = b.id;
        BreakLimit limit{};
        if constexpr (requires { springs.limit(id); })
            limit = {double(springs.limit(id).force) * newton, double(springs.limit(id).strain)};
        springs.replace(id, {link, springs.anchor(id), limit});
    }

    View& view_;
    std::remove_reference_t<decltype(std::declval<View&>().state())>& table_;
    std::vector<TriangleCorner>& corners_;
    std::vector<Row_>& before_;
    bool corners_are_stale_ = true;
};

} // namespace detail
} // namespace ansatz
