// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `way_points`: from the tiles of a path to the corners that a round body walks, without touching a wall (notes 6.3).
///
/// A search knows tiles; a body has a radius and turns in curves. `map_for` is the map as it is for such a body: tiles
/// whose centre it does not fit are blocked, and steps on which it would touch. On that search. `way_points` then
/// leaves out the corners of the path between which the body passes in a straight line, and finds for each of the
/// others by how much it may be cut, the most that the map allows: walls are tested where they are, not tile by
/// tile.
///
/// Blocked tiles, and all beyond the map, are walls for the whole body. Edges that are shut (thin walls, drops) hold
/// its centre only.

#include <ansatz/paths/grid/grid.hpp>
#include <ansatz/paths/smoothing.hpp>
#include <ansatz/paths/walking/way_point.hpp>
#include <ansatz/units.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ansatz::paths {

namespace detail {

/// A point of the map, counted in tiles.
struct Spot {
    double x = 0, y = 0;
    friend Spot operator+(Spot a, Spot b) { return {a.x + b.x, a.y + b.y}; }
    friend Spot operator-(Spot a, Spot b) { return {a.x - b.x, a.y - b.y}; }
    friend Spot operator*(double f, Spot a) { return {f * a.x, f * a.y}; }
};
inline double across(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
inline Spot centre(Cell c) { return {c.x + 0.5, c.y + 0.5}; }

/// Squared distance of a point from a stretch.
inline double squared_distance(Spot p, Spot a, Spot b) {
    const Spot d = b - a, r = p - a;
    const double all = d.x * d.x + d.y * d.y;
    const double q = all > 0 ? std::clamp((d.x * r.x + d.y * r.y) / all, 0.0, 1.0) : 0.0;
    const Spot off = r - q * d;
    return off.x * off.x + off.y * off.y;
}
/// Whether two stretches cross.
inline bool cross_each_other(Spot a, Spot b, Spot c, Spot d) {
    const double u = across(b - a, c - a), v = across(b - a, d - a);
    const double s = across(d - c, a - c), t = across(d - c, b - c);
    return u * v < 0 && s * t < 0;
}
/// Squared distance of two stretches.
inline double squared_distance(Spot a, Spot b, Spot c, Spot d) {
    if (cross_each_other(a, b, c, d)) return 0;
    return std::min(std::min(squared_distance(a, c, d), squared_distance(b, c, d)),
                    std::min(squared_distance(c, a, b), squared_distance(d, a, b)));
}
inline bool inside(Spot p, const std::array<Spot, 3>& t) {
    const double a = across(t[1] - t[0], p - t[0]), b = across(t[2] - t[1], p - t[1]),
                 c = across(t[0] - t[2], p - t[2]);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}
/// Whether a tile is farther than `far` from a triangle, or, where that is zero, does not overlap it.
inline bool apart(const std::array<Spot, 3>& t, double x, double y, double far) {
    const std::array<Spot, 4> square{Spot{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    const bool flat = t[1].x == t[2].x && t[1].y == t[2].y; // no triangle but a stretch
    if (!flat && inside({x + 0.5, y + 0.5}, t)) return false;
    const double within = 1e-9; // what only touches does not overlap
    for (std::size_t i = 0; i < 3; ++i) {
        const Spot a = t[i], b = t[(i + 1) % 3];
        if (a.x > x + within && a.x < x + 1 - within && a.y > y + within && a.y < y + 1 - within) return false;
        for (std::size_t k = 0; k < 4; ++k) {
            const Spot c = square[k], d = square[(k + 1) % 4];
            if (far > 0 ? squared_distance(a, b, c, d) < far * far * (1 - 1e-9) : cross_each_other(a, b, c, d))
                return false;
        }
        if (!(far > 0) && squared_distance({x + 0.5, y + 0.5}, a, b) < within) return false; // through two corners
    }
    return true;
}
/// Whether everything within a distance of a triangle is free of blocked tiles.
template <class Map> bool is_free(const Map& map, const std::array<Spot, 3>& t, double far) {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    for (int x = int(std::floor(left - far)); x <= int(std::floor(right + far)); ++x) {
        // The rows that the triangle can touch between this column's sides.
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < 3; ++i) {
            Spot a = t[i], b = t[(i + 1) % 3];
            if (a.x > b.x) std::swap(a, b);
            const double from = std::max(a.x, x - far), to = std::min(b.x, x + 1 + far);
            if (from > to) continue;
            const double rise = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
            for (const double y :
                 b.x > a.x ? std::array{a.y + (from - a.x) * rise, a.y + (to - a.x) * rise} : std::array{a.y, b.y})
                low = std::min(low, y), high = std::max(high, y);
        }
        if (low > high) continue;
        for (int y = int(std::floor(low - far)); y <= int(std::floor(high + far)); ++y) {
            const bool free = x >= 0 && y >= 0 && x < int(map.width()) && y < int(map.height()) &&
                              map.passable(Cell{std::uint16_t(x), std::uint16_t(y)});
            if (!free && !apart(t, x, y, far)) return false;
        }
    }
    return true;
}
/// Whether a triangle keeps away from the edges that are shut between free tiles.
template <class Map> bool keeps_from_edges(const Map& map, const std::array<Spot, 3>& t) {
    if (map.blocked_edges() == 0) return true;
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto shut = [&](Cell a, Cell b) {
        return map.passable(a) && map.passable(b) && (!map.passable(a, b) || !map.passable(b, a));
    };
    for (int y = std::max(0, int(top) - 1); y <= std::min(int(map.height()) - 1, int(bottom)); ++y)
        for (int x = std::max(0, int(left) - 1); x <= std::min(int(map.width()) - 1, int(right)); ++x) {
            const Cell c{std::uint16_t(x), std::uint16_t(y)};
            const Spot east{x + 1.0, double(y)}, south{double(x), y + 1.0}, corner{x + 1.0, y + 1.0};
            const auto hit = [&](Spot a, Spot b) {
                if (inside(a, t) || inside(b, t)) return true;
                for (std::size_t i = 0; i < 3; ++i)
                    if (squared_distance(t[i], t[(i + 1) % 3], a, b) <= 0) return true;
                return false;
            };
            if (x + 1 < int(map.width()) && shut(c, Cell{std::uint16_t(x + 1), c.y}) && hit(east, corner)) return false;
            if (y + 1 < int(map.height()) && shut(c, Cell{c.x, std::uint16_t(y + 1)}) && hit(south, corner))
                return false;
        }
    return true;
}
/// Whether a body can cut a corner by t: everything between the two lines and the parabola is free. The triangles from
/// the corner to eight chords cover it.
template <class Map> bool can_cut(const Map& map, Spot corner, Spot from, Spot to, double t, double radius) {
    Spot before = corner - t * from;
    for (int k = 1; k <= 8; ++k) {
        const double q = k / 8.0;
        const Spot next = corner + t * (q * q * to - (1 - q) * (1 - q) * from);
        const std::array<Spot, 3> part{corner, before, next};
        if (!is_free(map, part, radius) || !keeps_from_edges(map, part)) return false;
        before = next;
    }
    return true;
}
inline void require_radius(const char* where, Quantity<unit::Length> radius) {
    require_not_negative(where, "radius", radius);
}
/// The direction from one point to another, of length one.
inline Spot towards(Spot a, Spot b) { return (1 / std::hypot(b.x - a.x, b.y - a.y)) * (b - a); }

} // namespace detail

/// Whether a round body has room at a place of the map.
/// \param radius m; zero for a point, for which it is whether the place is inside no blocked tile
template <class Map>
bool disc_fits(const Map& map, const VectorQuantity<unit::Length, 2>& place, Quantity<unit::Length> radius) {
    detail::require_radius("disc_fits", radius);
    const double tile = map.tile().value();
    const detail::Spot p{place.value()[0] / tile, place.value()[1] / tile};
    return detail::is_free(map, {p, p, p}, radius.value() / tile);
}
/// Whether it can walk straight from one tile's centre to another's.
template <class Map> bool disc_passes(const Map& map, Cell a, Cell b, Quantity<unit::Length> radius) {
    detail::require_radius("disc_passes", radius);
    return line_of_sight(map, a, b) && detail::is_free(map, {detail::centre(a), detail::centre(b), detail::centre(b)},
                                                       radius.value() / map.tile().value());
}

/// The map as it is for a round body: what it does not fit on is blocked, steps on which it would touch a wall are
/// shut.
/// \param radius m
template <class Map> Map map_for(const Map& map, Quantity<unit::Length> radius) {
    detail::require_radius("map_for", radius);
    Map own = map;
    const auto each = [&](auto&& use) {
        for (std::uint16_t y = 0; y < map.height(); ++y)
            for (std::uint16_t x = 0; x < map.width(); ++x)
                if (map.passable(Cell{x, y})) use(Cell{x, y});
    };
    each([&](Cell c) {
        if (!disc_fits(map, map.position(c), radius)) own.set_passable(c, false);
    });
    each([&](Cell c) {
        for (int d = 0; d < Map::neighbours::directions; ++d)
            if ((own.open_directions(c) >> d & 1) != 0) {
                const Cell to = detail::step(c, unsigned(d));
                if (!disc_passes(map, c, to, radius)) own.set_passable(c, to, false);
            }
    });
    return own;
}

/// The corners of a path for a round body, and by how much each may be cut; without the first tile, on which it stands.
/// \param map    the map itself, not that of `map_for`
/// \param path   tiles, such as AStar found on `map_for(map, radius)`
/// \param radius m
/// \throws std::invalid_argument for a path on which the body would touch a wall
template <class Map>
std::vector<WayPoint> way_points(const Map& map, std::span<const Cell> path, Quantity<unit::Length> radius) {
    detail::require_radius("way_points", radius);
    const double tile = map.tile().value(), r = radius.value() / tile;
    std::vector<Cell> corners;
    if (!path.empty()) corners.push_back(path.front());
    for (std::size_t from = 0; from + 1 < path.size();) {
        if (!disc_passes(map, path[from], path[from + 1], radius))
            refuse_value("way_points", "the step from " + name_of(path[from]) + " to " + name_of(path[from + 1]),
                         "one on which a disc of this radius touches a wall", "search on map_for(map, radius)");
        std::size_t to = from + 1;
        const double weight = map.weight(path[to]);
        for (std::size_t k = to + 1; k < path.size() && map.weight(path[k]) == weight; ++k)
            if (detail::straight_and_even(map, path[from], path[k]) && disc_passes(map, path[from], path[k], radius))
                to = k;
        corners.push_back(path[to]);
        from = to;
    }
    std::vector<WayPoint> points;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        double cut = 0;
        if (i + 1 < corners.size()) {
            const detail::Spot a = detail::centre(corners[i - 1]), b = detail::centre(corners[i]),
                               c = detail::centre(corners[i + 1]);
            const detail::Spot from = detail::towards(a, b), to = detail::towards(b, c);
            const double most = 0.5 * std::min(std::hypot(b.x - a.x, b.y - a.y), std::hypot(c.x - b.x, c.y - b.y));
            double free = 0, not_free = most;
            if (detail::can_cut(map, b, from, to, most, r)) free = most;
            for (int halving = 0; halving < 10 && free < not_free; ++halving) {
                const double t = 0.5 * (free + not_free);
                (detail::can_cut(map, b, from, to, t, r) ? free : not_free) = t;
            }
            cut = free;
        }
        points.push_back({.place = map.position(corners[i]), .cut = cut * tile * metre});
    }
    return points;
}

} // namespace ansatz::paths
