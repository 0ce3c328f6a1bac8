// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Pool`: a body of water in a world, as `World::add` takes it, and what the world keeps of one.
///
///     World world{SemiImplicitEuler{}, Gravity{}, Pools<WaterColumns>{}};
///     const auto pool = world.add(Pool{Surface{WaterColumns{3.0 * metre_per_second}, grid, 2.0 * metre}});
///
/// It is made of a `Surface`, with whatever heights and bed that has. From then on it is the world's: it advances in
/// each step, is copied, hashed and saved with it, and its gravity is the world's. A pool names no body, and
/// bodies in one pool do not wake or sleep together because of it. For a surface without a world take the Surface
/// itself.

#include <ansatz/water/surface.hpp>
#include <ansatz/world/cache.hpp>
#include <ansatz/world/element_table.hpp>

#include <optional>
#include <vector>

namespace ansatz {

/// A body of water. World::get gives it back as it would be without the bodies that lie in it.
/// \tparam Policy what moves it: WaterColumns, ClampedColumns, Pipes, ShallowWater, SecondOrderShallowWater, or one of
/// yours
template <class Policy> struct Pool {
    using element = Pool; ///< World::add takes it

    Surface<Policy> surface;                                            ///< its columns, as they are at first
    Parameter<unit::Density> density = 1000 * kilogram_per_cubic_metre; ///< kg/m^3, finite, positive
};
template <class Policy> Pool(const Surface<Policy>&) -> Pool<Policy>; ///< of fresh water
/// Of any density.
template <class Policy, class Density> Pool(const Surface<Policy>&, Density) -> Pool<Policy>;

/// Names a pool.
template <class Policy> using PoolHandle = ElementHandle<Pool<Policy>>;

namespace detail {

/// What may write the lanes of a surface.
struct SurfaceLanes {
    template <class S> static auto& of(S& surface) { return surface.state_; }
    /// One step, whose length was checked already.
    template <class S> static void advance(S& surface, Quantity<unit::Time> dt) {
        surface.bound_.advance(surface.state_, dt);
    }
    /// \throws std::invalid_argument for lanes that no water has
    template <class S> static void check(const S& surface, std::string_view where) { surface.check_state(where); }
    template <class S> static bool weighs(const S& surface, double gravity) {
        if constexpr (requires { surface.policy_.gravity; }) return surface.policy_.gravity.value() == gravity;
        else return true;
    }
    /// What moves it, as a Surface takes it: water that weighs nothing has the gravity of its policy in it.
    template <class S> static auto policy(const S& surface) {
        auto policy = surface.policy_;
        if constexpr (requires { policy.gravity; })
            if (weighs(surface, 0)) policy.gravity = decltype(policy){}.gravity;
        return policy;
    }
    /// Another gravity, where the policy has one.
    template <class S> static void set_gravity(S& surface, double gravity) {
        if constexpr (requires { surface.policy_.gravity; }) {
            if (weighs(surface, gravity)) return;
            surface.policy_.gravity = gravity * metre_per_second_squared;
            using Bound_ = std::remove_cvref_t<decltype(surface.bound_)>;
            surface.bound_ = Bound_(surface.policy_, surface.grid_, surface.level_);
        }
    }
    /// The longest step under a gravity, s.
    template <class S> static Quantity<unit::Time> longest_step(const S& surface, double gravity) {
        if (weighs(surface, gravity)) return surface.longest_step();
        auto other = surface;
        set_gravity(other, gravity);
        return other.longest_step();
    }
};

/// Rows of columns along z, from the first to behind the last; none where it begins behind its end.
struct RowsOfColumns {
    std::size_t begin = std::numeric_limits<std::size_t>::max(), end = 0;
    void add(std::size_t first, std::size_t behind) {
        begin = std::min(begin, first);
        end = std::max(end, behind);
    }
    /// Calls `f(n)` for each of their columns.
    template <class F> void each(const ColumnGrid& grid, F&& f) const {
        const std::size_t nx = grid.columns_x(), last = std::min(end, grid.columns_z()) * nx;
        for (std::size_t n = begin < end ? begin * nx : last; n < last; ++n) f(n);
    }
};

/// What is kept of a pool.
template <class Policy, class Scalar> struct PoolRow {
    using Surface_ = Surface<Policy, Scalar>;
    std::optional<Surface_> surface;     // none before it is read from a file
    Scalar density{};                    // kg/m^3
    std::vector<Scalar> pressed;         // of each column: how much of its height bodies have pressed up, m
    bool begun = false;                  // whether a step was made: before, nothing that bodies pressed up is in it
    Cache<std::vector<Scalar>> pressing; // the same as this step makes it
    // Beyond these rows nothing is pressed up; a pool that was read from a file visits all of them once.
    RowsOfColumns rows{0, std::numeric_limits<std::size_t>::max()}, next_rows;

    static PoolRow from(const auto&, const Pool<Policy>& pool) {
        require_positive("Pool", "density", pool.density);
        PoolRow row;
        row.density = Scalar(Quantity<unit::Density>(pool.density).value());
        const auto& given = pool.surface;
        row.surface.emplace(given.policy(), given.grid(), given.first_level(), given.state());
        row.pressed.assign(given.grid().size(), Scalar(0));
        return row;
    }
    /// Without the bodies that lie in it.
    Pool<Policy> describe(const auto&) const {
        auto state = surface->state();
        for (std::size_t n = 0; n < pressed.size(); ++n) state.height[n] -= pressed[n];
        if constexpr (Policy::has_bed) give_owed(state.height, surface->grid());
        return {Surface<Policy>(SurfaceLanes::policy(*surface), surface->grid(), surface->first_level(), state),
                static_cast<double>(density) * kilogram_per_cubic_metre};
    }
    static void fields(auto& self, auto&& field) {
        constexpr bool read = !std::is_const_v<std::remove_reference_t<decltype(self)>>;
        if constexpr (read) {
            auto& surface = self.surface; // a reader that only lists the fields is shown what is there
            auto policy = surface ? surface->policy() : Policy{};
            auto grid = surface ? surface->grid() : ColumnGrid(3, 1, 1.0 * metre);
            auto level = surface ? surface->first_level() : Quantity<unit::Length>{};
            auto state = surface ? surface->state() : typename Surface_::State{};
            each(policy, grid, level, state, field);
            grid.check();
            // Before there is memory for all columns that a file names: it may name more than it holds.
            if (surface || grid.size() > 3 || !state.height.empty()) // 3: nothing was read
                grid.require_one_each("Pool", "height", state.height.size());
            surface.emplace(policy, grid, level);
            SurfaceLanes::of(*surface) = state; // check reads it
        } else {
            const auto& surface = *self.surface;
            const auto level = surface.first_level();
            each(surface.policy(), surface.grid(), level, surface.state(), field);
        }
        field("density", self.density);
        field("pressed", self.pressed);
        field("begun", self.begun);
    }
    /// \throws std::invalid_argument where the numbers do not fit together
    void check() const {
        const Surface_ fresh(SurfaceLanes::policy(*surface), surface->grid(), surface->first_level());
        std::vector<std::size_t> sizes;
        auto size_of = [](const auto& x) {
            if constexpr (requires { x.size(); }) return x.size();
            else return std::size_t(0);
        };
        Surface_::State::fields(fresh.state(), [&](std::string_view, const auto& x) { sizes.push_back(size_of(x)); });
        std::size_t lane = 0;
        Surface_::State::fields(surface->state(), [&](std::string_view name, const auto& x) {
            if (size_of(x) != sizes[lane++]) surface->grid().require_one_each("Pool", name, size_of(x));
        });
        const auto& grid = surface->grid();
        grid.require_one_each("Pool", "pressed", pressed.size());
        require_positive("Pool", "density", static_cast<double>(density) * kilogram_per_cubic_metre);
        SurfaceLanes::check(*surface, "Pool");
        // A column that ran dry may owe what was pressed up there, so that no height bounds it.
        for (const Scalar& h : pressed)
            if (!is_finite(h) || h < Scalar(0))
                refuse_value("Pool", "pressed, of a column,", Quantity<unit::Length, Scalar>::from_value(h),
                             "it must be finite and not negative");
    }

private:
    /// A column that ran dry owes water which bodies had pressed up there: without them the others give it, each by
    /// what it has, so that none holds less than nothing and the volume is the same.
    static void give_owed(std::vector<Scalar>& height, const ColumnGrid& grid) {
        SumOf<Scalar> owed(0), held(0); // m^3
        for (std::size_t n = 0, nx = grid.columns_x(); n < height.size(); ++n) {
            const auto volume = SumOf<Scalar>(height[n]) * grid.x().width(n % nx) * grid.z().width(n / nx);
            if (volume < 0) owed -= volume;
            else held += volume;
        }
        if (!(owed > 0)) return;
        const Scalar left(held > owed ? (held - owed) / held : SumOf<Scalar>(0));
        for (Scalar& h : height) h = h > Scalar(0) ? left * h : Scalar(0);
    }
    static void each(auto& policy, auto& grid, auto& level, auto& state, auto& field) {
        Policy::fields(policy, field);
        std::remove_cvref_t<decltype(grid)>::fields(grid, field);
        field("level", level);
        std::remove_cvref_t<decltype(state)>::fields(state, field);
    }
};

} // namespace detail
} // namespace ansatz
