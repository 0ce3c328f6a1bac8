// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Traveller`: a body of a World that goes to tiles of a grid, and searches again when the notes' rule says so (notes
/// 6.3: "an additional time for each event that changes parts of the graph that form parts of the path").
///
/// It stands outside of the world and holds what a world cannot: a search on a map. `go` searches and gives the body a
/// `Walk`; `update`, called after each step, polls. It searches again when the map was changed and what is left of the
/// path, by its tiles or by the straight lines that are walked, is blocked or dearer; and when the walker is stuck or
/// was pushed to where its way is behind a wall. A walker that is on its way halts on it first, and goes on from there.
/// One that was pushed off the map searches when it is back on it.
///
/// The Walk is a part of the world and is copied and saved with it. A Traveller for a copy of the world is a copy of
/// the Traveller: it names the body by its handle.
// not in the umbrella: it brings a World along, and a search needs none; ansatz/paths/walking.hpp has it

#include <ansatz/paths/route.hpp>
#include <ansatz/paths/walking/clearance.hpp>
#include <ansatz/paths/walking/walkers.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace ansatz::paths {

/// How a walker walks.
struct Gait {
    Parameter<unit::Velocity> speed;              ///< m/s, the greatest
    Parameter<unit::Acceleration> acceleration;   ///< m/s^2, the greatest
    Parameter<unit::Length> radius = 0.0 * metre; ///< m, of the disc that must not touch a wall
    /// As in Walk: zero or along the third axis, and the map lies over the first two; or along the second, and its rows
    /// lie along the third.
    VectorParameter<unit::Dimensionless> up{};
    Parameter<unit::Length> astray = 0.5 * metre; ///< m, as in Walk
};

/// \tparam Search an AStar on a Grid: where the radius is more than half a tile, or the grid has another corner rule
///                than BothFree, on `map_for(map, radius)`
/// \tparam Map    the map itself, on which walls are searched for
template <class Search, class Map = std::remove_cvref_t<decltype(std::declval<const Search&>().graph())>>
class Traveller {
public:
    /// \param search used, not copied; several travellers may share one
    /// \param map    used, not copied
    /// \throws std::invalid_argument for a gait that cannot be
    Traveller(Search& search, const Map& map, Handle body, const Gait& gait, Replan rule = Replan::when_touched)
        : map_(&map), route_(search, rule), body_(body), gait_(gait) {
        require_positive("Traveller", "speed", gait.speed);
        require_positive("Traveller", "acceleration", gait.acceleration);
        require_not_negative("Traveller", "radius", gait.radius);
        const auto& up = gait.up.value();
        if (up[0] != 0 || (up[1] != 0 && up[2] != 0))
            refuse_value("Traveller", "up", gait.up, "it must be zero, or along the second or the third axis");
    }
    /// Where the radius is at most half a tile and diagonal steps need both neighbours: the search's own map.
    Traveller(Search& search, Handle body, const Gait& gait, Replan rule = Replan::when_touched)
        : Traveller(search, search.graph(), body, gait, rule) {}

    /// Searches, and has the body go; one that is on its way to somewhere else halts first.
    /// \return whether there is a path
    /// \throws std::invalid_argument for a body or a goal outside of the map, for a body that has a walk from
    ///         elsewhere, and for an `up` in a world of two dimensions; everything goes on as before
    template <class W> bool go(W& world, Cell goal) {
        if (W::S::dimension == 2 && !gait_.up.value().isZero(0))
            refuse_value("Traveller", "up", gait_.up,
                         "in a world of two dimensions, over which the map lies, it is zero");
        if (const auto other = world.walk_of(body_); other && !(walk_ && *other == *walk_))
            refuse_value("Traveller", "body", "one that has a walk of somebody else",
                         "a body follows one at a time; remove that, world.remove(*world.walk_of(body))");
        const Cell from = tile_of(world, stopping_place(world));
        const Outcome outcome = route_.go(from, goal);
        goal_ = goal; // also where there is no path yet: `update` goes there when there is one
        if (outcome != Outcome::found) {
            halt(world);
            return false;
        }
        plan(world);
        return true;
    }
    /// After each step: polls the world and the map. \return whether it has searched
    template <class W> bool update(W& world) {
        if (!walk_ || !world.contains(*walk_)) return false;
        const auto now = world.walking(*walk_);
        for (const auto& event : world.walk_events())
            if (event.walk == *walk_) lost_ = lost_ || is_lost(world, event.news, now);
        follow(world);
        bool searched = false;
        if (lost_ || is_touched()) {
            if (!is_on_map(on_map(world, stopping_place(world)))) { // it comes back to its way, and then searches
                lost_ = true;
                halt(world);
                return false;
            }
            lost_ = false;
            searched = true;
            go_again(world);
        }
        if (waiting_ && !(world.walking(*walk_).pace.value() > 0)) set_out(world);
        return searched;
    }
    /// Whether it stands at the goal.
    template <class W> bool arrived(const W& world) const {
        return walk_ && !waiting_ && world.contains(*walk_) && world.walking(*walk_).arrived;
    }
    const Route<Search>& route() const { return route_; } ///< the tiles, and how often it has searched
    ElementHandle<Walk> walk() const { return walk_ ? *walk_ : ElementHandle<Walk>{}; } ///< of the body, once it goes
    const std::vector<WayPoint>& points() const { return points_; } ///< the corners of the last search

private:
    /// The place on the map of a place in the world.
    template <class W> VectorQuantity<unit::Length, 2> on_map(const W&, const auto& place) const {
        const auto& x = place.value();
        return metres(double(x[0]), double(gait_.up.value()[1] != 0 ? x[2] : x[1]));
    }
    bool is_on_map(const VectorQuantity<unit::Length, 2>& place) const {
        const auto tiles = place.value() / map_->tile().value();
        return tiles[0] >= 0 && tiles[1] >= 0 && tiles[0] < double(map_->width()) && tiles[1] < double(map_->height());
    }
    template <class W> Cell tile_of(const W& world, const auto& place) const {
        return map_->cell_at(on_map(world, place));
    }
    template <class W> auto stopping_place(const W& world) const {
        const auto place = world.position(body_);
        if (!walk_ || !world.contains(*walk_)) return place;
        const auto now = world.walking(*walk_);
        const bool beside =
            norm(on_map(world, place) - on_map(world, now.should_be)) > Quantity<unit::Length>(gait_.astray);
        return now.off || beside ? place : world.where_it_can_stop(*walk_);
    }
    /// A wall between the walker and its way, or nothing that gets on.
    template <class W> bool is_lost(const W& world, WalkNews news, const auto& now) const {
        if (news == WalkNews::stuck) return true;
        if (news != WalkNews::pushed_off) return false;
        if (!is_on_map(on_map(world, world.position(body_)))) return true;
        const auto spot = [&](const auto& place) {
            const auto p = on_map(world, place);
            return (1 / map_->tile().value()) * detail::Spot{p.value()[0], p.value()[1]};
        };
        const auto a = spot(world.position(body_)), b = spot(now.should_be);
        return !detail::is_free(*map_, {a, b, b}, 0);
    }
    /// Has the route know what was walked.
    template <class W> void follow(const W& world) {
        const auto place = on_map(world, world.position(body_));
        if (!is_on_map(place)) return;
        const Cell here = map_->cell_at(place);
        const auto ahead = route_.ahead();
        for (std::size_t k = 1; k < ahead.size(); ++k)
            if (ahead[k] == here) {
                for (; k > 0; --k) route_.step();
                break;
            }
    }
    /// Whether what is left is blocked or dearer, by the rule of the route; or a line that is walked.
    bool is_touched() {
        if (map_->version() == version_) return false;
        version_ = map_->version();
        if (route_.needs_new_path()) return true;
        if (route_.outcome() != Outcome::found) return false;
        const auto left = route_.ahead();
        bool begun = false;
        Cell before = route_.here();
        for (const auto& point : points_) { // only those that are still ahead
            const Cell corner = map_->cell_at(metres(point.place.value()[0], point.place.value()[1]));
            begun = begun || std::find(left.begin() + (left.empty() ? 0 : 1), left.end(), corner) != left.end();
            if (!begun) continue;
            if (!disc_passes(*map_, before, corner, gait_.radius)) return true;
            before = corner;
        }
        return false;
    }
    template <class W> void go_again(W& world) {
        const Cell from = tile_of(world, stopping_place(world));
        if (route_.go(from, goal_) == Outcome::found) plan(world);
        else halt(world);
    }
    template <class W> void halt(W& world) {
        waiting_ = false;
        points_.clear();
        if (walk_ && world.contains(*walk_)) world.halt(*walk_);
    }
    /// Corners of the path that was found; the body sets out when it stands.
    template <class W> void plan(W& world) {
        points_ = way_points(*map_, route_.ahead(), gait_.radius);
        version_ = map_->version();
        waiting_ = true;
        if (walk_ && world.contains(*walk_) && world.walking(*walk_).pace.value() > 0 && !world.walking(*walk_).off)
            world.halt(*walk_);
        else set_out(world);
    }
    template <class W> void set_out(W& world) {
        waiting_ = false;
        Walk walk{.body = body_,
                  .path = {},
                  .speed = gait_.speed,
                  .acceleration = gait_.acceleration,
                  .up = gait_.up,
                  .astray = gait_.astray};
        const auto place = on_map(world, world.position(body_));
        const auto centre = map_->position(route_.here());
        const double tile = map_->tile().value();
        const auto spot = [&](const auto& p) { return (1 / tile) * detail::Spot{p.value()[0], p.value()[1]}; };
        const auto away = [&](const WayPoint& p) { // from the map into the world
            const double height = 0;
            const auto& v = p.place.value();
            return WayPoint{.place = gait_.up.value()[1] != 0 ? metres(v[0], height, v[1]) : metres(v[0], v[1], height),
                            .cut = p.cut};
        };
        // From beside the centre of its tile it goes there first, unless it can go straight to the first corner.
        const bool beside = norm(place - centre).value() > 1e-6 * tile;
        const double far = gait_.radius.value() / tile;
        const bool straight =
            !points_.empty() && map_->blocked_edges() == 0 &&
            detail::is_free(*map_, {spot(place), spot(points_[0].place), spot(points_[0].place)}, far);
        if (points_.empty() || (beside && !straight)) walk.path.push_back(away({.place = centre}));
        for (const WayPoint& p : points_) walk.path.push_back(away(p));
        // A corner was cut by as much as between centres; from beside one its triangle is another.
        if (beside && straight) walk.path.front().cut = 0.0 * metre;
        if (walk_ && world.contains(*walk_)) world.set(*walk_, walk);
        else walk_ = world.add(walk);
    }

    const Map* map_;
    Route<Search> route_;
    Handle body_;
    Gait gait_;
    Cell goal_{};
    std::vector<WayPoint> points_;
    std::optional<ElementHandle<Walk>> walk_;
    std::size_t version_ = 0; ///< of the map that was searched
    bool waiting_ = false;    ///< for the walker to stand, to give it the next way
    bool lost_ = false;
};
/// `Traveller{search, body, gait}`.
template <class Search> Traveller(Search&, Handle, const Gait&) -> Traveller<Search>;
/// The same with a rule.
template <class Search> Traveller(Search&, Handle, const Gait&, Replan) -> Traveller<Search>;
/// With a map of its own.
template <class Search, class Map> Traveller(Search&, const Map&, Handle, const Gait&) -> Traveller<Search, Map>;
/// The same with a rule.
template <class Search, class Map>
Traveller(Search&, const Map&, Handle, const Gait&, Replan) -> Traveller<Search, Map>;

} // namespace ansatz::paths
