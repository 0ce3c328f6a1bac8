// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Surface<Policy, Scalar>`: a body of water by itself, whose surface a policy moves (notes 7.2): WaterColumns, Pipes,
/// ShallowWater.
///
/// Use it to have water without a world: heights in, a step, heights out. A copy is a snapshot, and continues bit for
/// bit as the original does. For one loop over spans of your own, without checks, take the policy's `In<Scalar>`.
///
/// Everything that can be wrong is refused here, at the door, with the water left as it was: a height that is negative
/// or not finite, and a step that is longer than the policy takes (its Courant limit), with the longest that would do.

#include <ansatz/water/height_map.hpp>

#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// A choice among few as a field of something that is saved: a number from 0 to that of the last one.
/// \param where whose it is, for the sentence
template <class E>
void choice_field(auto& field, std::string_view where, std::string_view name, E& choice, std::remove_const_t<E> last) {
    auto number = std::uint8_t(choice);
    if constexpr (std::is_const_v<E>) field(name, std::as_const(number));
    else {
        field(name, number);
        if (number > std::uint8_t(last))
            refuse_value(where, name, std::size_t(number),
                         joined({"it is a whole number from 0 to ", std::to_string(int(last))}));
        choice = E(number);
    }
}
/// What a policy keeps of columns.
template <class T>
concept KeptOfColumns = requires(const T& state) { state.height.size(); };
struct SurfaceLanes; // what may write lanes: the pools of a world (pool.hpp)
} // namespace detail

/// What moves a surface, bound to a scalar: what Surface asks of a policy. `State<Scalar>` has the lane `height`, and
/// what else is kept; `In<Scalar>` says the longest step and makes one.
///
/// \ref ansatz::WaterColumns "WaterColumns", \ref ansatz::ClampedColumns "ClampedColumns", \ref ansatz::Pipes "Pipes",
/// \ref ansatz::ShallowWater "ShallowWater" and \ref ansatz::SecondOrderShallowWater "SecondOrderShallowWater" are such
/// policies (notes 7.2).
template <class P, class Scalar>
concept SurfacePolicyIn =
    requires(const P& policy, const ColumnGrid& grid, typename P::template State<Scalar>& state,
             typename P::template In<Scalar>& bound, Quantity<unit::Length> level, Quantity<unit::Time> dt) {
        { P::name } -> std::convertible_to<std::string_view>;
        { P::has_bed } -> std::convertible_to<bool>;
        policy.check();
        requires std::constructible_from<typename P::template In<Scalar>, const P&, const ColumnGrid&,
                                         Quantity<unit::Length>>;
        bound.prepare(state, level);
        { bound.longest_step(state) } -> std::convertible_to<Quantity<unit::Time>>;
        bound.advance(state, dt);
        { state.height } -> std::same_as<std::vector<Scalar>&>;
    };

/// A body of water: columns, and what a policy keeps for each of them.
/// \tparam Policy WaterColumns, ClampedColumns, Pipes, ShallowWater, SecondOrderShallowWater, or one of yours
/// \tparam Scalar float, double, or a class scalar
template <class Policy, class Scalar = double> class Surface {
    static_assert(SurfacePolicyIn<Policy, Scalar>,
                  "Ansatz: Surface takes a policy that moves columns of water, e.g. Surface{WaterColumns{3.0 * "
                  "metre_per_second}, grid, 2.0 * metre}");

public:
    using Length = Quantity<unit::Length>;                        ///< places, m
    using Height = Quantity<unit::Length, Scalar>;                ///< heights, m
    using Time = Quantity<unit::Time>;                            ///< s
    using State = typename Policy::template State<Scalar>;        ///< what is copied and saved
    using Volume = Quantity<unit::Volume, detail::SumOf<Scalar>>; ///< m^3

    /// Still water of one height over a level bed at y = 0.
    /// \param level m, finite, not negative
    /// \throws std::invalid_argument for another level, or what the policy refuses
    Surface(const Policy& policy, ColumnGrid grid, Length level)
        : policy_(checked(policy, level)), grid_(std::move(grid)), level_(level), bound_(policy_, grid_, level) {
        state_.height.assign(grid_.size(), Scalar(level.value()));
        bound_.prepare(state_, level);
    }
    /// Still water over a bed: up to the level, and none where the bed is higher.
    /// \param bed   its height at each column, m, finite, x fastest
    /// \param level m, finite, not negative
    /// \throws std::invalid_argument for other values
    Surface(const Policy& policy, ColumnGrid grid, std::span<const Scalar> bed, Length level)
        requires(Policy::has_bed)
        : Surface(policy, std::move(grid), level) {
        grid_.require_one_each("Surface", "heights of the bed", bed.size());
        for (std::size_t n = 0; n < bed.size(); ++n) {
            state_.bed[n] = bed[n];
            state_.height[n] = std::max(Scalar(0), Scalar(level.value()) - bed[n]);
            if (!is_finite(bed[n])) refuse_value("Surface", place("the bed", n), meters(bed[n]), "it must be finite");
            if (!is_finite(state_.height[n]))
                refuse_value("Surface", place("the bed", n), meters(bed[n]),
                             "the height of the water over it must be finite");
        }
    }

    /// Goes on from a state.
    /// \param level m, with which it began: what walls hold that hold
    /// \param state as `state()` of another surface has it, also in another scalar
    /// \throws std::invalid_argument where it has not what this policy keeps, not one number for each column, or one
    ///         that is no number of water
    template <detail::KeptOfColumns OtherState>
    Surface(const Policy& policy, ColumnGrid grid, Length level, const OtherState& state)
        : Surface(policy, std::move(grid), level) {
        take(state);
        check_state("Surface");
    }

    /// Advances the water.
    /// \param dt s, finite in this scalar too, positive, at most longest_step()
    /// \throws std::invalid_argument for another step, before anything moves
    void step(Time dt) {
        require_positive("Surface::step", "dt", dt);
        require_finite("Surface::step", "dt, in its scalar,",
                       Quantity<unit::Time, Scalar>::from_value(Scalar(dt.value())));
        const Time longest = longest_step();
        if (!(dt <= longest))
            refuse_value("Surface::step", "dt", dt,
                         detail::joined({"the longest step that ", Policy::name, " takes with these columns is ",
                                         describe(longest), " (Courant's limit)"}));
        bound_.advance(state_, dt);
    }
    /// The longest step that does not make these waves grow, s; infinite where nothing can move.
    Time longest_step() const { return bound_.longest_step(state_); }

    const Policy& policy() const { return policy_; }                  ///< what moves it
    Length first_level() const { return level_; }                     ///< with which it began, m
    const ColumnGrid& grid() const { return grid_; }                  ///< where its columns are
    const State& state() const { return state_; }                     ///< its lanes, raw SI
    std::span<const Scalar> heights() const { return state_.height; } ///< of each column, m, x fastest
    /// \f$ \sum h\,\Delta x\,\Delta z \f$, m^3; summed in double for float.
    Volume volume() const { return grid_.volume(heights()); }
    /// How much water stands on column (i, j), m.
    /// \throws std::out_of_range if there is no such column
    Height height(std::size_t i, std::size_t j) const { return Height::from_value(state_.height[known(i, j)]); }
    /// Sets how much water stands on column (i, j): m, finite, not negative. What moves it stays.
    /// \throws std::out_of_range, std::invalid_argument
    void set_height(std::size_t i, std::size_t j, const Height& height) {
        const std::size_t n = known(i, j);
        require_height("Surface::set_height", n, height.value());
        state_.height[n] = height.value();
    }
    /// Sets them all: one for each column, m, finite, not negative, x fastest.
    /// \throws std::invalid_argument for other values, with the water left as it was
    void set_heights(std::span<const Scalar> heights) {
        grid_.require_one_each("Surface::set_heights", "heights", heights.size());
        for (std::size_t n = 0; n < heights.size(); ++n) require_height("Surface::set_heights", n, heights[n]);
        std::copy(heights.begin(), heights.end(), state_.height.begin());
    }

    /// Whether there are columns; where there are none, it is dry.
    bool covers(Length x, Length z) const { return grid_.covers(x, z); }
    /// Where the surface is: bilinear between the centres of columns, level from the outermost centres to the walls; m.
    /// \throws std::out_of_range where there are no columns
    Height level(Length x, Length z) const { return Height::from_value(patch("Surface::level", x, z).height()); }
    /// Its normal there: upwards, of length 1.
    /// \throws std::out_of_range where there are no columns
    Vector<Scalar, 3> normal(Length x, Length z) const { return patch("Surface::normal", x, z).normal(); }
    /// How fast the surface rises at column (i, j), m/s: the notes' velocity.
    Quantity<unit::Velocity, Scalar> rate(std::size_t i, std::size_t j) const
        requires requires(State s) { s.rate; }
    {
        return Quantity<unit::Velocity, Scalar>::from_value(state_.rate[known(i, j)]);
    }
    /// How fast the water of column (i, j) flows along x and z, m/s; zero where it is dry.
    VectorQuantity<unit::Velocity, 2, Scalar> velocity(std::size_t i, std::size_t j) const
        requires requires(const typename Policy::template In<Scalar>& b, State s) { b.velocity(s, i, j); }
    {
        known(i, j);
        return VectorQuantity<unit::Velocity, 2, Scalar>::from_value(bound_.velocity(state_, i, j));
    }
    /// The surface as a map of heights through the centres of columns.
    /// \throws std::invalid_argument for unequal footprints, or a channel
    HeightMap<Scalar> height_map() const {
        if (!grid_.uniform())
            refuse(Refusal::invalid_argument, "Surface::height_map: these columns have unequal footprints; a map has "
                                              "points at equal distances, ask for level(x, z) at each of them");
        HeightMap<Scalar> map(grid_.columns_x(), grid_.columns_z(), grid_.width_x(0), grid_.width_z(0));
        for (std::size_t j = 0; j < grid_.columns_z(); ++j)
            for (std::size_t i = 0; i < grid_.columns_x(); ++i)
                map.set(i, j, Height::from_value(surface_at(grid_.index(i, j))));
        return map.at(grid_.centre_x(0), grid_.centre_z(0));
    }

private:
    friend struct detail::SurfaceLanes;
    /// Every number of a state is finite, and over a bed no column holds less than nothing. Columns that pull at each
    /// other may: they do not know where the ground is.
    void check_state(std::string_view where) const {
        State::fields(state_, [&](std::string_view name, const auto& x) {
            if constexpr (requires { x.size(); }) {
                for (std::size_t n = 0; n < x.size(); ++n)
                    if (!is_finite(x[n]))
                        refuse_value(where, place(name, n), x[n], "it must be finite, in the scalar of this water");
            } else if constexpr (!std::is_integral_v<std::remove_cvref_t<decltype(x)>>)
                if (!is_finite(x)) refuse_value(where, name, x, "it must be finite");
        });
        if constexpr (Policy::has_bed)
            for (std::size_t n = 0; n < state_.height.size(); ++n) require_height(where, n, state_.height[n]);
    }
    /// Lane by lane; one that the other scalar does not need stays as prepared.
    template <class From> void take(const From& from) {
        std::vector<const std::remove_cvref_t<decltype(from.height)>*> lanes;
        std::vector<double> numbers;
        std::vector<std::string> lane_names, number_names;
        From::fields(from, [&](std::string_view name, const auto& x) {
            if constexpr (requires { x.size(); }) lanes.push_back(&x), lane_names.emplace_back(name);
            else numbers.push_back(static_cast<double>(x)), number_names.emplace_back(name);
        });
        std::size_t lane = 0, number = 0;
        State::fields(state_, [&](std::string_view name, auto& x) {
            if constexpr (requires { x.size(); }) require_kept("lane", lane_names, lane, name);
            else require_kept("number", number_names, number, name);
            if constexpr (requires { x.size(); }) {
                const auto& given = *lanes[lane++];
                if (given.empty() || x.empty()) return;
                grid_.require_one_each("Surface", name, given.size());
                for (std::size_t n = 0; n < x.size(); ++n) x[n] = Scalar(given[n]);
            } else x = std::remove_cvref_t<decltype(x)>(numbers[number++]);
        });
    }
    /// A state of another policy has other lanes in their places, or none.
    static void require_kept(std::string_view kind, const std::vector<std::string>& given, std::size_t at,
                             std::string_view name) {
        if (at < given.size() && given[at] == name) return;
        refuse_value("Surface", detail::joined({kind, " ", std::to_string(at), " of the state"}),
                     at < given.size() ? given[at] : "missing",
                     detail::joined({"a state of ", Policy::name, " has ", name, " there; give it one of its own, or ",
                                     "begin anew and set_heights"}));
    }
    static const Policy& checked(const Policy& policy, Length level) {
        policy.check();
        require_not_negative("Surface", "level", level);
        require_finite("Surface", "level, in its scalar,", meters(Scalar(level.value())));
        return policy;
    }
    static Height meters(const Scalar& value) { return Height::from_value(value); }
    std::string place(std::string_view what, std::size_t n) const {
        return detail::joined({what, " at column (", std::to_string(n % grid_.columns_x()), ", ",
                               std::to_string(n / grid_.columns_x()), ")"});
    }
    void require_height(std::string_view where, std::size_t n, const Scalar& height) const {
        if (!is_finite(height) || height < Scalar(0))
            refuse_value(where, place("the height", n), meters(height), "it must be finite and not negative");
    }
    std::size_t known(std::size_t i, std::size_t j) const { return grid_.known_index("Surface", i, j); }
    Scalar surface_at(std::size_t n) const {
        if constexpr (Policy::has_bed) return state_.bed[n] + state_.height[n];
        else return state_.height[n];
    }
    detail::Patch<Scalar> patch(std::string_view where, Length x, Length z) const {
        grid_.require_covered(where, x, z);
        const auto a = grid_.x().between(x.value()), b = grid_.z().between(z.value());
        auto apart = [](const detail::ColumnAxis& axis, const detail::Between& c) {
            return Scalar(c.low == c.high ? 1.0 : axis.distance(c.low)); // alone: equal heights, no slope
        };
        return {surface_at(grid_.index(a.low, b.low)),
                surface_at(grid_.index(a.high, b.low)),
                surface_at(grid_.index(a.low, b.high)),
                surface_at(grid_.index(a.high, b.high)),
                Scalar(a.part),
                Scalar(b.part),
                apart(grid_.x(), a),
                apart(grid_.z(), b)};
    }
    Policy policy_;
    ColumnGrid grid_;
    Length level_;
    typename Policy::template In<Scalar> bound_;
    State state_;
};

/// A surface in double; write Surface<WaterColumns, float> for lanes half as wide.
template <class Policy> Surface(const Policy&, ColumnGrid, Quantity<unit::Length>) -> Surface<Policy, double>;
/// In the scalar of the state that is given.
template <class Policy, detail::KeptOfColumns State>
Surface(const Policy&, ColumnGrid, Quantity<unit::Length>, const State&)
    -> Surface<Policy, std::remove_cvref_t<decltype(std::declval<const State&>().height[0])>>;
/// In the scalar of its bed.
template <class Policy, class Bed>
Surface(const Policy&, ColumnGrid, const Bed&, Quantity<unit::Length>)
    -> Surface<Policy, std::remove_cvref_t<decltype(*std::declval<const Bed&>().data())>>;

} // namespace ansatz
