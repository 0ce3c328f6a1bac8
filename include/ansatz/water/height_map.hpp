// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `HeightMap`: a surface as one height y for each point of a fixed grid of x and z (notes 7.1), with the height and
/// the normal anywhere between them.
///
/// Use it for terrain, for the bed of a lake, and to draw a surface of water (`Surface::height_map`). It needs no
/// world. What it cannot show: overhangs, caves, a breaking wave; for one (x, z) there is one y.
///
/// Between four points the height is bilinear. With u and v from 0 to 1 along x and z,
///
/// \f[ y = (1-u)(1-v)\,y_{00} + u(1-v)\,y_{10} + (1-u)v\,y_{01} + u v\,y_{11}, \qquad
///     \mathbf n = \frac{(-\partial y/\partial x,\; 1,\; -\partial y/\partial z)}{|\cdot|} \f]
///
/// The height is continuous everywhere. The normal is that of this surface exactly; across the lines of the grid it
/// jumps, as the surface has an edge there, and on a line it is that of the cell after it.

#include <ansatz/water/column_grid.hpp>

namespace ansatz {

namespace detail {
/// A bilinear patch: its height and its slopes along x and z. u and v in 0..1, dx and dz the sides.
template <class Scalar> struct Patch {
    Scalar y00, y10, y01, y11, u, v, dx, dz;
    Scalar height() const { return between(between(y00, y10, u), between(y01, y11, u), v); }
    Vector<Scalar, 3> normal() const {
        using std::sqrt;
        const Scalar one(1);
        const Scalar by_x = ((y10 - y00) * (one - v) + (y11 - y01) * v) / dx,
                     by_z = ((y01 - y00) * (one - u) + (y11 - y10) * u) / dz;
        const Scalar length = sqrt(by_x * by_x + by_z * by_z + one);
        if (!is_finite(length)) return Vector<Scalar, 3>(-by_x, one, -by_z).stableNormalized(); // a cliff
        return {-by_x / length, one / length, -by_z / length};
    }
    /// Exact at both ends, and where they are equal.
    static Scalar between(const Scalar& a, const Scalar& b, const Scalar& part) {
        return part < Scalar(0.5) ? a + part * (b - a) : b - (Scalar(1) - part) * (b - a);
    }
};
} // namespace detail

/// A height for each of `points_x()` times `points_z()` points, `dx()` and `dz()` apart, numbered with x fastest.
/// \tparam Scalar float, double, or a class scalar
template <class Scalar = double> class HeightMap {
public:
    using Length = Quantity<unit::Length>;         ///< places, m
    using Height = Quantity<unit::Length, Scalar>; ///< heights, m

    /// A level map.
    /// \param points_x  at least 2
    /// \param points_z  at least 2
    /// \param dx        distance of two points along x, m, finite and positive
    /// \param dz        along z
    /// \throws std::invalid_argument for other values
    HeightMap(std::size_t points_x, std::size_t points_z, Length dx, Length dz) : nx_(points_x), nz_(points_z) {
        for (const auto& [name, n] : {std::pair{"x", nx_}, std::pair{"z", nz_}})
            if (n < 2)
                refuse_value("HeightMap", detail::joined({"the number of points along ", name}), std::to_string(n),
                             "a map has at least 2 points along x and along z");
        if (nx_ > std::numeric_limits<std::size_t>::max() / sizeof(Scalar) / nz_)
            refuse_value("HeightMap", "the number of points",
                         detail::joined({std::to_string(nx_), " x ", std::to_string(nz_)}),
                         "they must fit into memory");
        require_positive("HeightMap", "dx", dx);
        require_positive("HeightMap", "dz", dz);
        require_finite("HeightMap", "the length along x", dx * double(nx_ - 1));
        require_finite("HeightMap", "the length along z", dz * double(nz_ - 1));
        dx_ = dx.value();
        dz_ = dz.value();
        heights_.assign(nx_ * nz_, Scalar(0));
    }
    /// The heights of a function of x and z at each point: m from (m, m).
    /// \throws std::invalid_argument for a height that is not finite
    template <class F>
    static HeightMap of(std::size_t points_x, std::size_t points_z, Length dx, Length dz, F&& height) {
        HeightMap map(points_x, points_z, dx, dz);
        for (std::size_t j = 0; j < points_z; ++j)
            for (std::size_t i = 0; i < points_x; ++i) {
                const Height y = height(map.x(i), map.z(j));
                map.set(i, j, y);
            }
        return map;
    }
    /// The same map with its first point there.
    HeightMap at(Length x, Length z) const {
        require_finite("HeightMap::at", "x", x);
        require_finite("HeightMap::at", "z", z);
        HeightMap moved = *this;
        moved.x0_ = x.value();
        moved.z0_ = z.value();
        return moved;
    }

    std::size_t points_x() const { return nx_; }                              ///< how many along x
    std::size_t points_z() const { return nz_; }                              ///< how many along z
    Length dx() const { return dx_ * metre; }                                 ///< between two points along x, m
    Length dz() const { return dz_ * metre; }                                 ///< between two points along z, m
    Length x(std::size_t i) const { return (x0_ + double(i) * dx_) * metre; } ///< where point i is, m
    Length z(std::size_t j) const { return (z0_ + double(j) * dz_) * metre; } ///< where point j is, m
    std::span<const Scalar> heights() const { return heights_; }              ///< all of them in m, x fastest
    /// The height of point (i, j), m.
    /// \throws std::out_of_range if there is no such point
    Height operator()(std::size_t i, std::size_t j) const { return Height::from_value(heights_[known(i, j)]); }
    /// Sets the height of point (i, j): m, finite.
    /// \throws std::out_of_range, std::invalid_argument
    void set(std::size_t i, std::size_t j, const Height& height) {
        const std::size_t index = known(i, j);
        if (!is_finite(height))
            refuse_value("HeightMap::set",
                         detail::joined({"the height of point (", std::to_string(i), ", ", std::to_string(j), ")"}),
                         height, "it must be finite");
        heights_[index] = height.value();
    }

    /// Whether the map reaches there; its border belongs to it.
    bool covers(Length x, Length z) const {
        return x >= this->x(0) && x <= this->x(nx_ - 1) && z >= this->z(0) && z <= this->z(nz_ - 1);
    }
    /// The bilinear height, m.
    /// \throws std::out_of_range where the map does not reach
    Height height(Length x, Length z) const { return Height::from_value(patch("HeightMap::height", x, z).height()); }
    /// The normal of the bilinear surface there: upwards, of length 1.
    /// \throws std::out_of_range where the map does not reach
    Vector<Scalar, 3> normal(Length x, Length z) const { return patch("HeightMap::normal", x, z).normal(); }

    /// Each side of a cell divided into `factor` lengths: more points on the same bilinear surface (notes 7.4). It
    /// looks smoother once it is shaded; it knows nothing that the map did not.
    /// \throws std::invalid_argument for a factor of 0
    HeightMap tessellated(std::size_t factor) const {
        if (factor == 0)
            refuse_value("HeightMap::tessellated", "factor", std::size_t(0), "each side is divided into 1 or more");
        if (factor > std::numeric_limits<std::size_t>::max() / std::max(nx_, nz_))
            refuse_value("HeightMap::tessellated", "factor", factor, "the points must fit into memory");
        HeightMap fine((nx_ - 1) * factor + 1, (nz_ - 1) * factor + 1, dx() / double(factor), dz() / double(factor));
        fine.x0_ = x0_;
        fine.z0_ = z0_;
        for (std::size_t j = 0; j < fine.nz_; ++j)
            for (std::size_t i = 0; i < fine.nx_; ++i) {
                const std::size_t ci = std::min(i / factor, nx_ - 2), cj = std::min(j / factor, nz_ - 2);
                fine.heights_[j * fine.nx_ + i] =
                    in_cell(ci, cj, double(i - ci * factor) / double(factor), double(j - cj * factor) / double(factor))
                        .height();
            }
        return fine;
    }
    /// The least and the largest height, m.
    std::pair<Height, Height> range() const {
        const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
        return {Height::from_value(*low), Height::from_value(*high)};
    }
    friend bool operator==(const HeightMap&, const HeightMap&) = default; ///< the same heights in the same place

private:
    std::size_t known(std::size_t i, std::size_t j) const {
        if (i >= nx_ || j >= nz_)
            refuse(Refusal::out_of_range, detail::joined({"HeightMap: a point is (", std::to_string(i), ", ",
                                                          std::to_string(j), "); the map has ", std::to_string(nx_),
                                                          " x ", std::to_string(nz_), " points, counted from 0"}));
        return j * nx_ + i;
    }
    detail::Patch<Scalar> in_cell(std::size_t i, std::size_t j, double u, double v) const {
        const Scalar* low = &heights_[j * nx_ + i];
        return {low[0], low[1], low[nx_], low[nx_ + 1], Scalar(u), Scalar(v), Scalar(dx_), Scalar(dz_)};
    }
    detail::Patch<Scalar> patch(std::string_view where, Length x, Length z) const {
        if (!covers(x, z))
            refuse(Refusal::out_of_range,
                   detail::joined({where, ": (x, z) is (", describe(x), ", ", describe(z), "); the map covers x from ",
                                   describe(this->x(0)), " to ", describe(this->x(nx_ - 1)), " and z from ",
                                   describe(this->z(0)), " to ", describe(this->z(nz_ - 1))}));
        const auto a = cell(x.value(), x0_, dx_, nx_), b = cell(z.value(), z0_, dz_, nz_);
        return in_cell(a.low, b.low, a.part, b.part);
    }
    /// The cell that a place is in, and how far it is through it. The quotient alone would not do: rounded, it puts
    /// many a point of the map a hair before itself, into the cell that ends there, whose normal is another.
    static detail::Between cell(double x, double first, double step, std::size_t points) {
        const auto point = [=](std::size_t i) { return first + double(i) * step; };
        const double along = (x - first) / step;
        std::size_t i = std::min(std::size_t(along), points - 2);
        if (x < point(i) && i > 0) --i;
        else if (x >= point(i + 1) && i + 2 < points) ++i;
        const double part = x == point(i) ? 0.0 : x == point(i + 1) ? 1.0 : along - double(i);
        return {i, i + 1, std::clamp(part, 0.0, 1.0)};
    }
    std::size_t nx_, nz_;
    double dx_ = 1, dz_ = 1, x0_ = 0, z0_ = 0;
    std::vector<Scalar> heights_;
};

} // namespace ansatz
