// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SurfaceContacts`: what lies on a soft surface, falls into it or is thrown back by it (notes 7.4).
///
///     const auto pond = add_soft_surface(world, {.grid = grid, .mass_per_area = 50.0 * kilogram / square_metre});
///     const auto on_it = world.add(SurfaceContact::of(pond, ball, spring, 0.3 * metre));
///
/// Use it beside a surface of `add_soft_surface`: the notes' spring between a body and the surface, which is slack
/// above it, carries the body, and is gone for good once it was pulled too deep; then the surface is free and closes.
/// Without damping a body is thrown back, with some it comes to float, and one that is too heavy for its spring sinks.
/// For bodies in pools take Buoyancy; between solid bodies, the contacts of chapter 2.
///
/// The body stands on the mean of the columns around it, each with a weight that fades to nothing at the rim, so that
/// it feels no lattice, and one contact is one contact, however many columns carry it:
///
/// \f[ \bar y = \frac{\sum_i w_i y_i}{\sum_i w_i}, \quad w_i = \Bigl(1 - \frac{r_i^2}{R^2}\Bigr)^2,
///     \quad d = \bar y - (y - r), \quad
///     F = \max(0,\; k d + c \dot d), \quad \mathbf F = F\,(-\partial_x \bar y,\; 1,\; -\partial_z \bar y) \f]
///
/// | symbol | meaning                                                                    | unit |
/// |--------|----------------------------------------------------------------------------|------|
/// | r, R   | `radius` of the body; that of the footprint, no less than 1.5 columns      | m    |
/// | d      | how deep the body's lowest point is under the mean                         | m    |
/// | k, c   | of the SurfaceSpring: N/m, N s/m; it breaks where d is larger than its depth | |
///
/// The columns get -F, by their weights: the forces are those of the potential \f$ \tfrac12 k d^2 \f$, and what is
/// damped is lost, so that no body gets energy from nothing. What pushes a body aside is not given to the columns,
/// which only go up and down.
///
/// **Why no contact flickers.** A body of mass m that is thrown up again and again comes down no sooner than after
/// \f$ 2\pi\sqrt{m/k} \f$, the period at which it would bob: however low it leaps, the time in the air and the time on
/// the spring add up to more. And a contact ends only where the body is clear of the surface by `skin`, so that one
/// which grazes it does not begin twice.

#include <ansatz/motion/policy_systems.hpp>
#include <ansatz/motion/roles.hpp>
#include <ansatz/water/floating.hpp>
#include <ansatz/water/soft_surface.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ansatz {

/// A body that a soft surface carries while it touches it: what `World::add` takes of a world with `SurfaceContacts`.
struct SurfaceContact {
    using element = SurfaceContact; ///< World::add takes it

    Handle body;                                  ///< which
    ColumnGrid grid;                              ///< of the surface, uniform
    std::vector<Handle> columns;                  ///< its bodies, by column
    SurfaceSpring spring;                         ///< N/m, N s/m, m; without damping it throws a body back
    Parameter<unit::Length> radius = 0.0 * metre; ///< from its position to its lowest point, m, finite, not negative

    /// Of the parts that `add_soft_surface` gave.
    static SurfaceContact of(const SoftSurfaceParts& surface, Handle body, const SurfaceSpring& spring,
                             const Parameter<unit::Length>& radius = 0.0 * metre) {
        return {body, surface.grid, surface.bodies, spring, radius};
    }
};
/// Names one.
using SurfaceContactHandle = ElementHandle<SurfaceContact>;

/// How a body and a soft surface meet.
template <class Scalar> struct SurfaceTouch {
    bool touches = false;                   ///< whether they do, within the skin
    bool broken = false;                    ///< whether the spring is
    std::uint64_t begun = 0;                ///< how many times a contact has begun
    Quantity<unit::Length, Scalar> level{}; ///< of the surface under the body, m
    Quantity<unit::Length, Scalar> depth{}; ///< of its lowest point under that, m; 0 away from the surface
    Quantity<unit::Force, Scalar> push{};   ///< up, N
};

namespace detail {

/// What is kept of a contact.
template <class S> struct SurfaceContactRow {
    using Scalar = typename S::Scalar;
    using Vec = Vector<Scalar, S::dimension>;
    BodyId body;
    std::vector<BodyId> columns; // none once it is broken: a body that has sunk no longer touches the surface
    std::uint32_t nx = 0, nz = 0;
    std::array<Scalar, 4> grid{}; // x and z of the first column, its widths, m
    Scalar stiffness{}, damping{}, breaks_at{}, radius{};
    bool touches = false, broken = false;
    std::uint64_t begun = 0;

    static void fields(auto& self, auto&& field) {
        field("body", self.body);
        field("columns", self.columns);
        field("nx", self.nx);
        field("nz", self.nz);
        field("grid", self.grid);
        field("stiffness", self.stiffness);
        field("damping", self.damping);
        field("breaks_at", self.breaks_at);
        field("radius", self.radius);
        field("touches", self.touches);
        field("broken", self.broken);
        field("begun", self.begun);
    }
    static SurfaceContactRow from(const auto& asked, const SurfaceContact& given) {
        SurfaceContactRow row;
        const std::string_view where = "SurfaceContact";
        row.body = asked.body(given.body);
        given.grid.require_one_each(where, "columns", given.columns.size());
        if (!given.grid.uniform())
            refuse_value(where, "grid", "of unequal columns", "the columns of a soft surface are all alike");
        for (const Handle& h : given.columns) row.columns.push_back(asked.body(h));
        row.nx = std::uint32_t(given.grid.columns_x());
        row.nz = std::uint32_t(given.grid.columns_z());
        const auto &x = given.grid.x(), &z = given.grid.z();
        row.grid = {length("x", x.centre(0)), length("z", z.centre(0)), length("width", x.width(0)),
                    length("width", z.width(0))};
        row.stiffness = S::convert("stiffness", Quantity<unit::Stiffness>(given.spring.stiffness)).value();
        row.damping = S::convert("damping", Quantity<unit::Damping>(given.spring.damping)).value();
        row.breaks_at = S::convert("breaks_at", Quantity<unit::Length>(given.spring.breaks_at)).value();
        row.radius = S::convert("radius", Quantity<unit::Length>(given.radius)).value();
        return row;
    }
    SurfaceContact describe(const auto& handle_of) const {
        auto d = [](const Scalar& x) { return static_cast<double>(x); };
        const auto at = [&](std::size_t k) { return d(grid[k]) * metre; };
        SurfaceContact all{
            handle_of(body),
            ColumnGrid(nx, nz, at(2), at(3)).at(at(0) - at(2) / 2.0, at(1) - at(3) / 2.0),
            {},
            {d(stiffness) * newton_per_metre, d(damping) * newton_second_per_metre, d(breaks_at) * metre},
            d(radius) * metre};
        for (const BodyId& column : columns) all.columns.push_back(handle_of(column));
        return all;
    }
    /// \throws std::invalid_argument for what it cannot be
    void check() const {
        const std::string_view where = "SurfaceContact";
        if (body == BodyId() || std::find(columns.begin(), columns.end(), BodyId()) != columns.end())
            refuse_value(where, "its body, or one of its columns,", "nobody", "each is a body of this world");
        auto in_si = []<class U>(std::type_identity<U>, const Scalar& x) { return Quantity<U, Scalar>::from_value(x); };
        require_positive(where, "stiffness", in_si(std::type_identity<unit::Stiffness>{}, stiffness));
        require_not_negative(where, "damping", in_si(std::type_identity<unit::Damping>{}, damping));
        require_positive(where, "breaks_at", in_si(std::type_identity<unit::Length>{}, breaks_at));
        require_not_negative(where, "radius", in_si(std::type_identity<unit::Length>{}, radius));
        for (std::size_t k = 0; k < 4; ++k) {
            const auto number = in_si(std::type_identity<unit::Length>{}, grid[k]);
            if (k < 2) require_finite(where, k == 0 ? "x" : "z", number);
            else require_positive(where, "width", number);
        }
        if (S::dimension == 2 && nz != 1)
            refuse_value(where, "the number of columns along z", std::to_string(nz),
                         "in a world of two dimensions the surface is a channel: 1");
        if (nx < 3 || nz == 0 || (broken ? !columns.empty() : columns.size() != std::size_t(nx) * nz))
            refuse_value(where, "the number of columns", std::to_string(columns.size()),
                         joined({"there is one for each of the ", std::to_string(nx), " by ", std::to_string(nz),
                                 " columns, or none once it is broken"}));
        std::vector<std::uint32_t> ids{body.id};
        for (const BodyId& column : columns) ids.push_back(column.id);
        std::sort(ids.begin(), ids.end());
        if (const auto twice = std::adjacent_find(ids.begin(), ids.end()); twice != ids.end())
            refuse_value(where, "columns", joined({"body ", std::to_string(*twice), " twice"}),
                         "the body and each column are bodies of their own");
    }

    /// How the surface stands under a body.
    struct Under {
        Scalar total{};          // of the weights; 0 where there is none
        Scalar level{}, depth{}; // m
        Scalar deepening{};      // m/s
        Vec up = Vec::Zero();    // by what the push is multiplied
        Scalar push{}, damped{}; // N; N s/m of it, while it pushes
    };
    /// Calls `f(column, weight, dw/dx, dw/dz)` for each in the footprint of a body that is over the grid.
    template <class F> void each(const Vec& at, F&& f) const {
        const Scalar half(0.5), reach = std::max(radius, Scalar(1.5) * std::max(grid[2], nz > 1 ? grid[3] : grid[2]));
        const Scalar x = at[0] - grid[0], z = S::dimension == 3 && nz > 1 ? at[S::dimension - 1] - grid[1] : Scalar(0);
        auto outside = [&](const Scalar& s, const Scalar& width, std::uint32_t n) {
            return !(s >= -half * width && s <= (Scalar(n) - half) * width);
        };
        if (outside(x, grid[2], nx) || (nz > 1 && outside(z, grid[3], nz))) return;
        if (S::dimension == 3 && nz == 1 && outside(at[S::dimension - 1] - grid[1], grid[3], 1)) return;
        auto first = [&](const Scalar& s, const Scalar& width) {
            return s > reach ? std::uint32_t((s - reach) / width) : std::uint32_t(0);
        };
        auto behind = [&](const Scalar& s, const Scalar& width, std::uint32_t n) {
            const Scalar last = (s + reach) / width;
            return last < Scalar(n) ? std::min(n, std::uint32_t(last) + 1) : n;
        };
        const std::uint32_t i0 = first(x, grid[2]), i1 = behind(x, grid[2], nx), j0 = first(z, grid[3]),
                            j1 = nz > 1 ? behind(z, grid[3], nz) : 1;
        const Scalar over = Scalar(1) / (reach * reach);
        for (std::uint32_t j = j0; j < j1; ++j)
            for (std::uint32_t i = i0; i < i1; ++i) {
                const Scalar dx = Scalar(i) * grid[2] - x, dz = nz > 1 ? Scalar(j) * grid[3] - z : Scalar(0);
                const Scalar rest = Scalar(1) - (dx * dx + dz * dz) * over;
                if (rest > Scalar(0))
                    f(columns[std::size_t(j) * nx + i], rest * rest, Scalar(4) * rest * dx * over,
                      Scalar(4) * rest * dz * over);
            }
    }
    /// \param view answers with positions and velocities
    Under under(const auto& view) const {
        Under all;
        if (broken) return all;
        const auto slot = view.slot(body);
        const Vec at = view.template get<Position>(slot).value(), v = view.template get<Velocity>(slot).value();
        Scalar y(0), rise(0), wx(0), wz(0), yx(0), yz(0);
        Scalar from(0); // heights over that of the first: what is level has no slope, to the bit
        each(at, [&](BodyId column, const Scalar& w, const Scalar& by_x, const Scalar& by_z) {
            const auto there = view.slot(column);
            const Scalar there_y = view.template get<Position>(there).value()[1];
            if (!(all.total > Scalar(0))) from = there_y;
            const Scalar height = there_y - from;
            all.total += w;
            y += w * height;
            rise += w * view.template get<Velocity>(there).value()[1];
            wx += by_x;
            wz += by_z;
            yx += by_x * height;
            yz += by_z * height;
        });
        if (!(all.total > Scalar(0))) return all;
        const Scalar mean = y / all.total;
        all.level = from + mean;
        all.depth = mean + (from - at[1]) + radius;
        all.up[1] = Scalar(1);
        all.up[0] = -(yx - mean * wx) / all.total;
        if constexpr (S::dimension == 3) all.up[2] = -(yz - mean * wz) / all.total;
        all.deepening = rise / all.total - all.up.dot(v);
        if (all.depth > Scalar(0)) {
            all.push = stiffness * all.depth + damping * all.deepening;
            all.damped = all.push > Scalar(0) ? damping : Scalar(0);
            if (!(all.push > Scalar(0))) all.push = Scalar(0);
        }
        return all;
    }

private:
    static Scalar length(std::string_view what, double x) { return S::convert(what, x * metre).value(); }
};

} // namespace detail

/// Things on soft surfaces.
struct SurfaceContacts {
    using role = roles::Force;
    using reads = Columns<Position, Velocity>;
    static constexpr bool couples_bodies = true;
    using Element = SurfaceContact;                             ///< what World::add takes for it
    static constexpr std::string_view name = "SurfaceContacts"; ///< in a saved file

    Parameter<unit::Length> skin = 0.01 * metre; ///< how far above the surface a contact ends, m, finite, not negative

    static void parameters(auto& self, auto&& visit) { visit("skin", self.skin); }
    /// \throws std::invalid_argument for a skin that is not finite or negative
    void check() const { require_not_negative(name, "skin", skin); }

    /// The contacts of a world.
    template <class S> using State = ElementTable<S, SurfaceContact, detail::SurfaceContactRow<S>>;

    /// Behind each step: what is too deep breaks, and contacts begin and end.
    template <class S> struct Note {
        static constexpr Phase phase = phases::breaking; ///< where springs break, too
        static constexpr std::string_view name = "surface contacts";
        using reads = Columns<Position, Velocity>;
        typename S::Scalar skin; ///< m
        /// Of the policy.
        explicit Note(const SurfaceContacts& policy)
            : skin(S::convert("SurfaceContacts::skin", Quantity<unit::Length>(policy.skin)).value()) {}
        /// All contacts, by id.
        void run(auto& view, const auto&) const {
            using Scalar = typename S::Scalar;
            view.state().for_each([&](std::uint32_t, auto& row) {
                if (row.broken) return;
                const auto now = row.under(view);
                const bool there = now.total > Scalar(0);
                if (there && now.depth > row.breaks_at) {
                    row.broken = true;
                    row.touches = false;
                    row.columns.clear();
                    return;
                }
                const bool touches = there && now.depth > (row.touches ? -skin : Scalar(0));
                if (touches && !row.touches) ++row.begun;
                row.touches = touches;
            });
        }
    };
    /// What it does behind each step.
    template <class S> using systems = Types<Note<S>>;

    /// Bound to a space.
    template <class S> class In {
        using Scalar = typename S::Scalar;
        using Vec = Vector<Scalar, S::dimension>;
        using Matrix = Eigen::Matrix<Scalar, S::dimension, S::dimension>;
        using Row = detail::SurfaceContactRow<S>;

    public:
        explicit In(const SurfaceContacts&) {}

        /// The forces on bodies and columns.
        void couple(auto& view, const auto&) const {
            view.state().for_each([&](std::uint32_t, const Row& row) {
                const auto now = row.under(view);
                if (!(now.push > Scalar(0))) return;
                const auto slot = view.slot(row.body);
                view.add_force(slot, S::Force::from_value(Vec(now.push * now.up)));
                row.each(view.template get<Position>(slot).value(),
                         [&](BodyId column, const Scalar& w, const Scalar&, const Scalar&) {
                             Vec f = Vec::Zero();
                             f[1] = -now.push * w / now.total;
                             view.add_force(view.slot(column), S::Force::from_value(f));
                         });
            });
        }
        /// How the push changes with heights and rates, for integrators that solve; what a slope changes is left out.
        /// \param add called with two slots, and the matrices in N/m and N s/m
        void jacobian(const auto& view, const auto&, auto&& add) const {
            each_pair(view, [&](auto a, auto b, const Scalar& by, const Row& row, const Scalar& damped) {
                Matrix k = Matrix::Zero(), c = Matrix::Zero();
                k(1, 1) = -row.stiffness * by;
                c(1, 1) = -damped * by;
                add(a, b, k, c);
            });
        }
        /// How stiff and how damped they are for each other as they are now.
        /// \param f called with two slots, N/m and N s/m
        void stiffnesses(const auto& view, auto&& f) const {
            each_pair(view, [&](auto a, auto b, const Scalar& by, const Row& row, const Scalar& damped) {
                if (by > Scalar(0)) f(a, b, row.stiffness * by, damped * by);
            });
        }
        /// \f$ \tfrac12 k d^2 \f$, J.
        typename S::Energy potential_energy(const auto& view) const {
            Scalar sum(0);
            view.state().for_each([&](std::uint32_t, const Row& row) {
                const auto now = row.under(view);
                if (now.depth > Scalar(0)) sum += row.stiffness * now.depth * now.depth / Scalar(2);
            });
            return S::Energy::from_value(sum);
        }

    private:
        /// Each two of a body and its columns: d is a sum of heights g_i y_i, and by is -g_i g_j, as of a spring
        /// between the two; of two columns it is negative.
        static void each_pair(const auto& view, auto&& f) {
            view.state().for_each([&](std::uint32_t, const Row& row) {
                const auto now = row.under(view);
                if (!(now.push > Scalar(0))) return;
                const auto slot = std::size_t(view.slot(row.body));
                const Vec at = view.template get<Position>(slot).value();
                std::size_t first = 0;
                row.each(at, [&](BodyId a, const Scalar& wa, const Scalar&, const Scalar&) {
                    const auto there = std::size_t(view.slot(a));
                    f(slot, there, wa / now.total, row, now.damped);
                    std::size_t other = 0;
                    row.each(at, [&](BodyId b, const Scalar& wb, const Scalar&, const Scalar&) {
                        if (other++ > first)
                            f(there, std::size_t(view.slot(b)), -wa * wb / (now.total * now.total), row, now.damped);
                    });
                    ++first;
                });
            });
        }
    };
};

/// How a body and a soft surface meet, as they are now.
/// \throws std::out_of_range for a stale handle
template <class... P> auto surface_touch(const World<P...>& world, SurfaceContactHandle which) {
    using Scalar = typename World<P...>::S::Scalar;
    const auto view = world.template view<SurfaceContacts>();
    const auto& row = view.state().row(view.state().id(which, "surface_touch"));
    const auto now = row.under(view);
    SurfaceTouch<Scalar> all;
    all.touches = row.touches;
    all.broken = row.broken;
    all.begun = row.begun;
    all.level = decltype(all.level)::from_value(now.level);
    all.depth = decltype(all.depth)::from_value(now.depth > Scalar(0) ? now.depth : Scalar(0));
    all.push = decltype(all.push)::from_value(now.push);
    return all;
}

} // namespace ansatz
