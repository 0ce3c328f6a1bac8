// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Pools`: bodies of water in a world (notes 7.2), each a field of columns that advances with the step.
///
/// Use it where water is a part of a scene: it is stepped, copied, hashed and saved with the bodies, and asked between
/// the steps, `world.water(pool).level(x, z)`, without a frame of lag. A world may have several pools, of several kinds
/// too: `Pools<WaterColumns>{}, Pools<Pipes>{}`. It needs a Gravity in the world, whose downward part is the weight of
/// the water; there is no second constant. Alone it does nothing to bodies, and bodies do nothing to it.
///
/// A step that is longer than one of the pools takes is refused before anything moves, with the longest that all of
/// them take; in a world whose StepControl divides steps, the water takes it in substeps. A bed stands where the
/// surface has it, under y = 0 or above. What it does not do: overflow from one pool into another, or meet terrain of
/// bodies.

#include <ansatz/water/pool.hpp>
#include <ansatz/water/roles.hpp>

#include <array>
#include <string_view>

namespace ansatz {

namespace detail {
/// "Pools of " and the name of what moves them, by which they are saved.
template <class Policy> struct PoolsName {
    static constexpr std::string_view prefix = "Pools of ";
    static constexpr auto letters = [] {
        std::array<char, prefix.size() + std::string_view(Policy::name).size()> all{};
        std::size_t n = 0;
        for (const char c : prefix) all[n++] = c;
        for (const char c : std::string_view(Policy::name)) all[n++] = c;
        return all;
    }();
    static constexpr std::string_view name{letters.data(), letters.size()};
};
} // namespace detail

/// \tparam Policy what moves them: WaterColumns, ClampedColumns, Pipes, ShallowWater, SecondOrderShallowWater, or one of
/// yours
template <class Policy> struct Pools {
    using role = roles::Field;
    using Element = Pool<Policy>; ///< what it keeps
    using reads = Columns<>;
    using surface = Policy; ///< what moves them

    static constexpr std::string_view name = detail::PoolsName<Policy>::name; ///< in a saved file
    static void parameters(auto&, auto&&) {}

    /// The pools of a world.
    template <class S> using State = ElementTable<S, Pool<Policy>, detail::PoolRow<Policy, typename S::Scalar>>;
};

/// A pool of a world, to be asked: what it says is the state that the last step has made, or whatever was done since.
/// It refers to the world, which must stay where it is; other pools may come and go. Where its own is removed, it says
/// so.
/// \tparam Policy what moves it
/// \tparam S the space of the world
template <class Policy, class S> class WaterView {
public:
    using Scalar = typename S::Scalar;                       ///< of its heights
    using Length = Quantity<unit::Length>;                   ///< places, m
    using Height = Quantity<unit::Length, Scalar>;           ///< heights, m
    using Table = typename Pools<Policy>::template State<S>; ///< what the world keeps

    /// Of a table of pools.
    /// \throws std::out_of_range for a stale handle
    WaterView(const Table& table, PoolHandle<Policy> pool) : table_(&table), pool_(pool) { (void)row(); }

    /// The columns, with what bodies have pressed up, and the gravity of the last step: its `longest_step()` may be
    /// another than `World::longest_step_of_water()` where the world's gravity was set since.
    const Surface<Policy, Scalar>& surface() const { return *row().surface; }
    /// Where they stand.
    const ColumnGrid& grid() const { return surface().grid(); }
    /// Whether there is a column; elsewhere it is dry.
    bool covers(Length x, Length z) const { return surface().covers(x, z); }
    /// Where the surface is, m.
    /// \throws std::out_of_range where there are no columns
    Height level(Length x, Length z) const { return surface().level(x, z); }
    /// Its normal, upwards, of length 1.
    /// \throws std::out_of_range where there are no columns
    Vector<Scalar, 3> normal(Length x, Length z) const { return surface().normal(x, z); }
    /// How fast the water flows along x and z, of the column that stands there, m/s.
    /// \throws std::out_of_range where there is none
    VectorQuantity<unit::Velocity, 2, Scalar> velocity(Length x, Length z) const
        requires requires(const Surface<Policy, Scalar>& s) { s.velocity(0, 0); }
    {
        const auto n = grid().column(x, z);
        return surface().velocity(n % grid().columns_x(), n / grid().columns_x());
    }
    /// How fast the surface rises, of the column that stands there, m/s.
    /// \throws std::out_of_range where there is none
    Quantity<unit::Velocity, Scalar> rate(Length x, Length z) const
        requires requires(const Surface<Policy, Scalar>& s) { s.rate(0, 0); }
    {
        const auto n = grid().column(x, z);
        return surface().rate(n % grid().columns_x(), n / grid().columns_x());
    }
    /// How much water there is, m^3, without what bodies have pressed up.
    auto volume() const { return surface().volume() - displaced(); }
    /// How much bodies have pressed up, m^3.
    auto displaced() const { return grid().volume(std::span<const Scalar>(row().pressed)); }
    /// Its density, kg/m^3.
    Quantity<unit::Density, Scalar> density() const {
        return Quantity<unit::Density, Scalar>::from_value(row().density);
    }

private:
    using Row = detail::PoolRow<Policy, Scalar>;
    const Row& row() const { return table_->row(table_->id(pool_, "World::water")); }
    const Table* table_;
    PoolHandle<Policy> pool_;
};

} // namespace ansatz
