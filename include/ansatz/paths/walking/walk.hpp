// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Walk`: what `world.add` takes to let a body follow a path, and what a world with `Walkers` keeps of it.
// not in the umbrella: it brings a World along, and a search needs none; ansatz/paths/walking.hpp has it

#include <ansatz/paths/walking/steering.hpp>
#include <ansatz/paths/walking/way.hpp>
#include <ansatz/paths/walking/way_point.hpp>
#include <ansatz/units/describe.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/world/element_table.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz::paths {

/// Lets a body follow a path, from where it is: `world.add(Walk{.body = fox, .path = {...}, .speed = ...})`. Setting
/// another Walk for the same handle gives it another path, while it walks.
struct Walk {
    using element = Walk;                       ///< it is one
    Handle body;                                ///< a body that is free to move and has no walk yet
    std::vector<WayPoint> path;                 ///< the places to come, in their order; the last is where it stops
    Parameter<unit::Velocity> speed;            ///< m/s, the greatest
    Parameter<unit::Acceleration> acceleration; ///< m/s^2, the greatest that it adds to what else acts on it
    /// Where walking has a ground, the direction away from it, such as (0, 1, 0): what goes on along it, gravity and
    /// jumps, is left alone, and heights of way points mean nothing. It is zero for what flies, and for worlds seen
    /// from above.
    VectorParameter<unit::Dimensionless> up{};
    Parameter<unit::Length> astray = 0.5 * metre; ///< m, how far from its way it may be before it is told as pushed off
};

/// What a walker has to tell.
enum class WalkNews : std::uint8_t {
    way_point,  ///< it has passed one that is not the last
    arrived,    ///< it stands at the last one
    pushed_off, ///< it is farther from its way than `astray`
    back,       ///< it is back from there
    stuck,      ///< for `patience` it has got no nearer
};

namespace detail {

/// What is kept of a Walk.
template <class S> struct WalkRow {
    using Way_ = Way<S>;
    BodyId body;
    Way_ way;                                                ///< the path
    typename Way_::Moment moment;                            ///< where on it the body should be
    typename S::Velocity sent{};                             ///< m/s, the velocity that it was given last
    typename S::template VectorOf<unit::Dimensionless> up{}; ///< away from the ground, of length one, or zero
    typename S::Length astray{};                             ///< m
    typename S::Length nearest{};                            ///< m, the least that was left when it last got on
    typename S::Time waited{};                               ///< s, since then
    std::uint32_t passed = 0;                                ///< way points passed in the last step
    std::uint8_t told = 0;                                   ///< a bit for each WalkNews of the last step
    bool off = false, stuck = false, arrived = false, halting = false;

    static void fields(auto& self, auto&& field) {
        field("body", self.body);
        field("corners", self.way.corners);
        field("cuts", self.way.cuts);
        field("limits", self.way.limits);
        field("speed", self.way.speed);
        field("acceleration", self.way.acceleration);
        field("leg", self.moment.leg);
        field("along", self.moment.along);
        field("pace", self.moment.pace);
        field("sent", self.sent);
        field("up", self.up);
        field("astray", self.astray);
        field("nearest", self.nearest);
        field("waited", self.waited);
        field("passed", self.passed);
        field("told", self.told);
        field("off", self.off);
        field("stuck", self.stuck);
        field("arrived", self.arrived);
        field("halting", self.halting);
    }

    /// A vector without its part away from the ground.
    template <class V> V level(const V& v) const {
        return V::from_value(v.value() - up.value().dot(v.value()) * up.value());
    }
    static WalkRow from(const auto& asked, const Walk& walk) {
        WalkRow row;
        row.body = asked.body(walk.body);
        if (asked.bodies.motion(asked.bodies.slot(walk.body, asked.where)) == Motion::fixed ||
            asked.bodies.motion(asked.bodies.slot(walk.body, asked.where)) == Motion::moving)
            refuse_value("Walk", "body", "one that is fixed or moved by its velocity alone",
                         "a walker must be free to move");
        require_positive("Walk", "speed", walk.speed);
        require_positive("Walk", "acceleration", walk.acceleration);
        require_positive("Walk", "astray", walk.astray);
        require_finite("Walk", "up", walk.up);
        row.way.speed = S::convert("Walk::speed", walk.speed);
        row.way.acceleration = S::convert("Walk::acceleration", Quantity<unit::Acceleration>(walk.acceleration));
        row.astray = S::convert("Walk::astray", walk.astray);
        if (const double size = walk.up.value().norm(); size > 0)
            row.up = S::convert("Walk::up",
                                Quantity<unit::Dimensionless, Vector<double, 3>>::from_value(walk.up.value() / size));
        row.take(asked.position(walk.body), walk.path);
        row.nearest = row.way.left(row.moment);
        return row;
    }
    /// Makes a way of where the body is and the places to come.
    void take(const typename S::Position& here, const std::vector<WayPoint>& path) {
        if (path.empty()) refuse_value("Walk", "path", "empty", "it must have one way point at least");
        way.corners.push_back(level(here));
        way.cuts.emplace_back();
        for (std::size_t i = 0; i < path.size(); ++i) {
            const std::string which = "way point " + std::to_string(i);
            require_finite("Walk", which, path[i].place);
            require_not_negative("Walk", "the cut of " + which, path[i].cut);
            const auto place = level(typename S::Position(S::convert(which, path[i].place)));
            if (!(squared_norm(place - way.corners.back()).value() > typename S::Scalar(0))) {
                if (i == 0) continue; // it stands there already
                refuse_value("Walk", which, path[i].place, "it must lie elsewhere than the one before");
            }
            way.corners.push_back(place);
            way.cuts.push_back(S::convert("the cut of " + which, path[i].cut));
        }
        if (way.corners.size() == 1) { // nothing to walk: a way that ends where it begins
            way.corners.insert(way.corners.begin(), behind(level(here)));
            way.cuts.emplace_back();
            way.prepare();
            moment = {1, way.length(1), {}};
        } else {
            moment = {};
            way.prepare();
        }
    }
    /// A place to come from, for a walker that is there already.
    typename S::Position behind(const typename S::Position& place) const {
        int k = 0;
        for (int i = 1; i < S::dimension; ++i)
            if (std::abs(double(up.value()[i])) < std::abs(double(up.value()[k]))) k = i;
        auto at = place.value();
        at[k] -= typename S::Scalar(1) + std::abs(at[k]) / typename S::Scalar(2);
        return level(S::Position::from_value(at));
    }
    Walk describe(const auto& handle_of) const {
        Walk walk{.body = handle_of(body),
                  .path = {},
                  .speed = scalar_cast<double>(way.speed),
                  .acceleration = scalar_cast<double>(way.acceleration),
                  .up = {},
                  .astray = scalar_cast<double>(astray)};
        for (std::size_t i = moment.leg; i < way.corners.size(); ++i) {
            Vector<double, 3> place(0, 0, 0);
            for (int k = 0; k < S::dimension; ++k) place[k] = double(way.corners[i].value()[k]);
            walk.path.push_back({.place = Quantity<unit::Length, Vector<double, 3>>::from_value(place),
                                 .cut = scalar_cast<double>(way.cuts[i])});
        }
        Vector<double, 3> away(0, 0, 0);
        for (int k = 0; k < S::dimension; ++k) away[k] = double(up.value()[k]);
        walk.up = away;
        return walk;
    }
    /// Whether what was read from a file can be walked.
    void check() const {
        const std::size_t n = way.corners.size();
        if (n < 2 || way.cuts.size() != n || way.limits.size() != n)
            refuse_value("a walk", "corners", std::to_string(n), "two at least, with as many cuts and limits");
        require_positive("a walk", "speed", way.speed);
        require_positive("a walk", "acceleration", way.acceleration);
        if (moment.leg < 1 || moment.leg >= n)
            refuse_value("a walk", "leg", std::to_string(moment.leg), "from 1 to " + std::to_string(n - 1));
        require_not_negative("a walk", "along", moment.along);
        require_not_negative("a walk", "pace", moment.pace);
        Way_ again = way;
        for (std::size_t i = 1; i < n; ++i)
            if (!(way.length(i).value() > typename S::Scalar(0)))
                refuse_value("a walk", "corner " + std::to_string(i), way.corners[i], "elsewhere than the one before");
        again.prepare();
        for (std::size_t i = 0; i < n; ++i)
            if (!(again.cuts[i] == way.cuts[i]) || !(again.limits[i] == way.limits[i]))
                refuse_value("a walk", "the limit of corner " + std::to_string(i), way.limits[i],
                             "what follows from its corners");
    }
};

/// The walks of a world, of which a body has one at most: two would give it two velocities.
template <class S> class WalkTable : public ElementTable<S, Walk, WalkRow<S>> {
    using Base = ElementTable<S, Walk, WalkRow<S>>;
    using Row = WalkRow<S>;

public:
    static constexpr std::uint32_t none = 0xffffffffu; ///< no walk

    /// The id of the walk of a body, or `none`.
    std::uint32_t walk_of(std::uint32_t body) const {
        if (known_) return body < by_body_.size() ? by_body_[body] : none;
        std::uint32_t found = none;
        this->for_each([&](std::uint32_t id, const Row& row) { found = row.body.id == body ? id : found; });
        return found;
    }
    /// Nothing beside the walks; it makes a file that is loaded come to `check`.
    static void fields(auto&, auto&&) {}
    /// Whether no body of a file has two walks.
    void check() const {
        std::vector<std::uint32_t> bodies;
        this->for_each([&](std::uint32_t, const Row& row) { bodies.push_back(row.body.id); });
        std::sort(bodies.begin(), bodies.end());
        const auto twice = std::adjacent_find(bodies.begin(), bodies.end());
        if (twice != bodies.end())
            refuse_value("the walks", "the number of walks of body " + std::to_string(*twice), "2", "one at most");
    }

    /// \name As ElementTable has them
    /// @{

    std::uint32_t id(const ElementHandle<Walk>& h, const char* where) const { return Base::id(h, where); }
    /// A verb is about to change this one; `admit`, which follows and is not told, takes it from here.
    std::uint32_t id(const ElementHandle<Walk>& h, const char* where) { return changed_ = Base::id(h, where); }
    /// Checks a description, before anything is changed.
    template <class Where, class... Option>
    Row admit(const char* where, const Walk& walk, const Bodies& bodies, const Where& place, const Option&... option) {
        const auto own = std::string_view(where) == "World::set" ? changed_ : none;
        Row row = Base::admit(where, walk, bodies, place, option...);
        find_bodies(row.body.id);
        if (const auto other = walk_of(row.body.id); other != none && other != own)
            refuse_value("Walk", "body", "one that has a walk",
                         "a body follows one at a time; set this one for the handle of the other, or remove that");
        return row;
    }
    ElementHandle<Walk> insert(Row row) {
        const auto body = row.body.id;
        const auto handle = Base::insert(std::move(row));
        note(body, handle.id);
        return handle;
    }
    void replace(std::uint32_t id, Row row) {
        forget(this->row(id).body.id, id);
        note(row.body.id, id);
        Base::replace(id, std::move(row));
    }
    void erase(std::uint32_t id) {
        forget(this->row(id).body.id, id);
        Base::erase(id);
    }
    void body_removed(std::uint32_t body) {
        if (body < by_body_.size()) by_body_[body] = none;
        Base::body_removed(body);
    }
    /// @}

private:
    /// Room for a body, and for the walkers, if a file has brought them: this may fail, and what follows cannot.
    void find_bodies(std::uint32_t body) {
        if (body >= by_body_.size()) by_body_.resize(std::max<std::size_t>(body + 1, 2 * by_body_.size()), none);
        if (known_) return;
        std::uint32_t most = 0;
        this->for_each([&](std::uint32_t, const Row& row) { most = std::max(most, row.body.id); });
        by_body_.assign(std::max<std::size_t>(most + 1, by_body_.size()), none);
        this->for_each([&](std::uint32_t id, const Row& row) { by_body_[row.body.id] = id; });
        known_ = true;
    }
    void note(std::uint32_t body, std::uint32_t id) {
        if (body < by_body_.size()) by_body_[body] = id;
        else known_ = false; // the rows of a file, which are filled in behind this
    }
    void forget(std::uint32_t body, std::uint32_t id) {
        if (body < by_body_.size() && by_body_[body] == id) by_body_[body] = none;
    }
    std::vector<std::uint32_t> by_body_; // a cache: the walk of each body
    bool known_ = true;                  // whether that is right
    std::uint32_t changed_ = none;       // by `set`
};

} // namespace detail
} // namespace ansatz::paths
