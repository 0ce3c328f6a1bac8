// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Walkers`: the policy of a World by which bodies follow paths (notes 6.3, which find the path and leave the walking
/// open). `World w{SemiImplicitEuler{}, Walkers{}}; w.add(Walk{.body = fox, .path = {...}, .speed = ..., ...});`
///
/// At the beginning of each step it gives a walker the velocity that leads to where its `Way` says it should be at the
/// end of the step. While nothing else acts the body is there, to the rounding: it circles no way point and no goal,
/// whatever speed and step are, because a place is reached in a step and not steered at. What a walker can add is
/// bounded by its acceleration, so that it can be pushed: then it goes on from the place of its way that is nearest to
/// it, at the speed that it has, and steers back to the way; from farther than `astray` it comes back first. Gravity,
/// drag and contacts do to it what they do to any body; what they add in a step it feels behind that step, so that a
/// steady push g leaves it g dt^2 beside its way.
///
/// It knows no map. `Traveller` finds the path, and another one when the map changes (traveller.hpp).
/// Between the ends of a step a body moves straight, and may cut its own curve by a dt^2/8. A walker that Rest has put
/// to sleep, because something is in its way, is told as stuck; it goes on when its body wakes: what it leant on is
/// gone, or it is given another Walk.
// not in the umbrella: it brings a World along, and a search needs none; ansatz/paths/walking.hpp has it

#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/paths/walking/walk.hpp>
#include <ansatz/world/table_door.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace ansatz::paths {

/// Something that happened to a walker in the last step.
struct WalkEvent {
    ElementHandle<Walk> walk; ///< whose
    WalkNews news{};          ///< what
    std::uint32_t passed = 0; ///< with WalkNews::way_point: how many at once
};

/// How a walker gets on.
/// \tparam S the space
template <class S> struct Walking {
    std::uint32_t way_points = 0;   ///< how many are to come, with the last
    typename S::Length left{};      ///< m, of the way, corner by corner
    typename S::Time time_left{};   ///< s, if nothing disturbs it
    typename S::Speed pace{};       ///< m/s, along its way at the end of the last step
    typename S::Position should_be; ///< m, where on its way it is; level with the origin where it has an `up`
    bool arrived = false;           ///< it stands at the last way point, and keeps to it
    bool off = false;               ///< it is farther from its way than `astray`
    bool halting = false;           ///< it was told to halt
    bool stuck = false;             ///< it has got no nearer for `patience`, and has not since
};

/// Lets bodies follow paths.
struct Walkers {
    using role = ansatz::roles::System;
    using Element = Walk; ///< what it keeps
    static constexpr std::string_view name = "Walkers";

    /// s, after which a walker that gets no nearer is reported as stuck
    Parameter<unit::Time> patience = 1.0 * second;
    static void parameters(auto& self, auto&& visit) { visit("patience", self.patience); }
    void check() const { require_positive("Walkers", "patience", patience); }

    template <class S> using State = detail::WalkTable<S>; ///< all walks, one of a body at most

    /// Gives each walker its velocity for the step.
    template <class S> struct Steer {
        /// Before a driver divides the step.
        static constexpr Phase phase = between(phases::begin, phases::substeps);
        static constexpr std::string_view name = "walkers: steer";
        using writes = Columns<Velocity>;
        using reads = Columns<Position>;
        using Row = detail::WalkRow<S>; ///< what is kept of a walk
        using Scalar = typename S::Scalar;

        typename S::Time patience; ///< s
        /// Of the policy.
        explicit Steer(const Walkers& walkers) : patience(S::convert("Walkers::patience", walkers.patience)) {}

        /// All walkers, by the age of their walks.
        void run(auto& view, const auto& context) const {
            const typename S::Time dt = context.dt();
            view.state().for_each([&](std::uint32_t, Row& row) {
                row.told = 0, row.passed = 0;
                const auto slot = view.slot(row.body);
                if (!(dt.value() > Scalar(0))) return;
                if (slot >= view.end(Motion::awake)) { // asleep: it may have been stopped by something
                    if (slot < view.end(Motion::resting) && !row.arrived && !row.halting) wait(row, dt);
                    return;
                }
                const auto v = view.template get<Velocity>(slot);
                view.template set<Velocity>(slot, v + change(row, view.template get<Position>(slot), v, dt));
            });
        }
        /// What a walker adds to its velocity; moves it on along its way.
        typename S::Velocity change(Row& row, const typename S::Position& place, const typename S::Velocity& velocity,
                                    const typename S::Time& dt) const {
            using Speed = typename S::Speed;
            const auto& way = row.way;
            const auto x = row.level(place);
            const auto v = row.level(velocity);
            const Speed most = way.acceleration * dt;
            const auto rounding = rounding_at(x);
            const auto before = row.moment.leg;
            auto aside = typename S::Position(x - way.place(row.moment));
            const bool disturbed = norm(aside) > rounding || norm(v - row.sent) > rounding / dt;
            if (disturbed) aside = find_again(row, x, v, most);
            const bool off = norm(aside) > (row.off ? Scalar(0.5) * row.astray : row.astray);
            const auto from = way.place(row.moment);
            if (off) row.moment.pace = {}; // first back to the way
            else if (row.halting) way.brake(row.moment, dt);
            else way.advance(row.moment, dt);
            const bool stands = norm(way.place(row.moment) - from).value() == Scalar(0);
            auto after = typename S::Velocity((way.place(row.moment) - x) / dt); // which a Way keeps in its bounds
            if (disturbed || norm(after - v) > most + Scalar(2) * (rounding / dt))
                after = correcting(row, x, from, v, dt);
            else if (stands && !(norm(after) > rounding / dt)) after = S::template zero_vector<unit::Velocity>();
            tell(row, before, off, stands && !row.halting, aside, after, dt);
            row.sent = after;
            return after - v;
        }

    private:
        /// What a place may be off by rounding alone.
        static typename S::Length rounding_at(const typename S::Position& x) {
            return Scalar(16) * std::numeric_limits<Scalar>::epsilon() * norm(x);
        }
        /// The velocity of a walker beside its way: along it, and towards it as `arrive`, by half of the acceleration
        /// while the other half may be needed to brake.
        static typename S::Velocity correcting(const Row& row, const typename S::Position& x,
                                               const typename S::Position& from, const typename S::Velocity& v,
                                               const typename S::Time& dt) {
            const auto& way = row.way;
            const typename S::Velocity forward = (way.place(row.moment) - from) / dt;
            const bool stands = !(norm(forward).value() > Scalar(0));
            const typename Way<S>::Acceleration a = stands ? way.acceleration : Scalar(0.5) * way.acceleration;
            typename S::Velocity wanted = forward + arrive(x, from, way.speed, a, dt);
            if (norm(wanted) > way.speed) wanted = detail::along(wanted, way.speed);
            return steered(v, wanted, way.acceleration, dt);
        }
        /// Something else has moved it: the nearest place of the way around where it should be, and the pace there.
        /// \return m, from there to the body
        static typename S::Position find_again(Row& row, const typename S::Position& x, const typename S::Velocity& v,
                                               const typename S::Speed& most) {
            const auto& way = row.way;
            auto& m = row.moment;
            for (int i = 0; i < 3; ++i) { // the place is linear in `along` but on a parabola
                const auto slope = way.slope(m);
                const Scalar steep = slope.squaredNorm();
                if (steep < Scalar(0.25)) break;
                const auto off = x - way.place(m);
                way.shift(m, S::Length::from_value(off.value().dot(slope) / steep));
            }
            const auto slope = way.slope(m);
            const Scalar steep = slope.squaredNorm();
            if (!(steep < Scalar(0.25))) {
                const auto pace = S::Speed::from_value(v.value().dot(slope) / steep);
                const typename S::Speed half = Scalar(0.5) * most; // what is sent is the mean of a step
                m.pace = max(typename S::Speed{}, min(max(m.pace, pace - half), pace + half));
            }
            return x - way.place(m);
        }
        void tell(Row& row, std::uint32_t before, bool off, bool stands, const typename S::Position& aside,
                  const typename S::Velocity& after, const typename S::Time& dt) const {
            const auto note = [&](WalkNews news) { row.told = std::uint8_t(row.told | 1u << unsigned(news)); };
            const auto& way = row.way;
            row.passed = row.moment.leg > before ? row.moment.leg - before : 0;
            if (row.passed > 0) note(WalkNews::way_point);
            if (off != row.off) note(off ? WalkNews::pushed_off : WalkNews::back);
            row.off = off;
            const typename S::Speed most = way.acceleration * dt;
            const bool there = stands && way.is_end(row.moment) && !(norm(aside) > most * dt) && !(norm(after) > most);
            const bool arrived = there || (row.arrived && way.is_end(row.moment) && !off);
            if (arrived && !row.arrived) note(WalkNews::arrived);
            row.arrived = arrived;
            // A walker that starts from rest gets on by this much in a tenth of the time.
            const typename S::Length little =
                Scalar(0.05) * min(way.speed * patience, way.acceleration * patience * patience);
            const typename S::Length left = way.left(row.moment) + norm(aside);
            if (arrived || row.halting || left < row.nearest - little) {
                row.nearest = left, row.waited = {}, row.stuck = false;
                return;
            }
            wait(row, dt);
        }
        /// It has got no nearer in this step, either.
        void wait(Row& row, const typename S::Time& dt) const {
            row.waited += dt;
            if (row.waited < patience || row.stuck) return;
            row.stuck = true;
            row.told = std::uint8_t(row.told | 1u << unsigned(WalkNews::stuck));
        }
    };
    template <class S> using systems = Types<Steer<S>>; ///< what it does in a step

    /// What it adds to a World.
    template <class W, class C> class Door : public TableDoor<W, Walkers> {
        using S_ = typename C::S;

    public:
        /// What happened to walkers in the last step, by the age of their walks; for one walk in the order of WalkNews.
        std::vector<WalkEvent> walk_events() const {
            std::vector<WalkEvent> all;
            const auto& kept = this->kept();
            kept.for_each([&](std::uint32_t id, const auto& row) {
                for (unsigned k = 0; k <= unsigned(WalkNews::stuck); ++k)
                    if ((row.told >> k & 1u) != 0)
                        all.push_back({kept.handle(id), WalkNews(k), k == 0 ? row.passed : 0});
            });
            return all;
        }
        /// How a walker gets on.
        /// \throws std::out_of_range for a stale handle
        Walking<S_> walking(ElementHandle<Walk> walk) const {
            const auto& row = this->kept().row(this->kept().id(walk, "World::walking"));
            return {row.way.last() + 1 - row.moment.leg,
                    row.way.left(row.moment),
                    row.way.time_left(row.moment),
                    row.moment.pace,
                    row.way.place(row.moment),
                    row.arrived,
                    row.off,
                    row.halting,
                    row.stuck};
        }
        /// The walk of a body, if it has one.
        /// \throws std::out_of_range for a stale handle
        std::optional<ElementHandle<Walk>> walk_of(Handle body) const {
            const auto& kept = this->kept();
            const auto id = kept.walk_of(this->id(body, "World::walk_of"));
            if (id == detail::WalkTable<S_>::none) return std::nullopt;
            return kept.handle(id);
        }
        /// Has a walker come to rest on its way, as soon as it can, and wait; or go on.
        /// \throws std::out_of_range for a stale handle
        void halt(ElementHandle<Walk> walk, bool halting = true) {
            const auto id = this->kept().id(walk, "World::halt");
            this->change("World::halt", [&](auto& kept) { kept.row(id).halting = halting; });
            if (!halting) this->wake_body(this->kept().row(id).body.id);
        }
        /// m, where a walker would come to rest on its way if it were told to halt now.
        /// \throws std::out_of_range for a stale handle
        typename S_::Position where_it_can_stop(ElementHandle<Walk> walk) const {
            const auto& row = this->kept().row(this->kept().id(walk, "World::where_it_can_stop"));
            auto m = row.moment;
            row.way.brake(m, S_::Time::from_value(std::numeric_limits<typename S_::Scalar>::infinity()));
            return row.way.place(m);
        }
    };
};

} // namespace ansatz::paths
