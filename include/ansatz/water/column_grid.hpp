// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ColumnGrid`: where the columns of a body of water stand (notes 7.2), rows of cuboids side by side, each with a
/// footprint in the plane of x and z.
///
/// Use it for every surface of this chapter. Columns may be of one size, or each row along x and z may have a width of
/// its own: fine where something is watched, coarse elsewhere. What it does not do: refine a part of a row, or turn.
///
/// y points up, so a column of height h over a footprint of dx and dz holds
///
/// \f[ V = h\,\Delta x\,\Delta z \f]
///
/// The notes write "the fixed area in the XY plane"; with y up that plane stands upright, and an area in it contains
/// the height already.

#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ansatz {

class ColumnGrid;

namespace detail {
/// What a sum over many columns is kept in: at least double.
template <class Scalar> using SumOf = std::conditional_t<std::is_same_v<Scalar, float>, double, Scalar>;

/// Two neighbours and how far between them: low has the fraction 1 - part, high has the fraction part.
struct Between {
    std::size_t low, high;
    double part;
};

/// The columns along x, or along z: where their faces are, in m.
class ColumnAxis {
public:
    ColumnAxis(std::string_view which, std::size_t count, Quantity<unit::Length> width)
        : widths_(count_checked(which, count), width.value()) {
        finish(which);
    }
    ColumnAxis(std::string_view which, const std::vector<Quantity<unit::Length>>& widths) {
        count_checked(which, widths.size());
        for (const auto& width : widths) widths_.push_back(width.value());
        finish(which);
    }
    std::size_t count() const { return widths_.size(); }
    double width(std::size_t i) const { return widths_[i]; }
    double begin() const { return faces_.front(); }
    double end() const { return faces_.back(); }
    double centre(std::size_t i) const { return 0.5 * (faces_[i] + faces_[i + 1]); }
    double distance(std::size_t i) const { return 0.5 * (widths_[i] + widths_[i + 1]); } // to the next centre
    bool uniform() const {
        return std::all_of(widths_.begin(), widths_.end(), [&](double w) { return w == widths_.front(); });
    }
    bool covers(double x) const { return x >= begin() && x <= end(); } // false for NaN
    /// From the first face to the last; of a grid that stands far away, more exact than the difference of the two.
    double length() const { return std::accumulate(widths_.begin(), widths_.end(), 0.0); }
    /// From the widths, so that a grid that has been elsewhere is to the bit one that has not.
    void move_to(std::string_view which, double begin) {
        double length = 0;
        faces_.front() = begin;
        for (std::size_t i = 0; i < count(); ++i) {
            faces_[i + 1] = begin + (length += widths_[i]);
            if (!(faces_[i + 1] > faces_[i]))
                refuse_value("ColumnGrid::at", which, begin * metre,
                             joined({"a column of ", describe(widths_[i] * metre), " is lost in rounding there"}));
        }
    }
    /// The column that contains x, which is covered; a face belongs to the column after it, the last to the last.
    std::size_t column(double x) const {
        const auto after = std::upper_bound(faces_.begin(), faces_.end(), x);
        return std::min(count() - 1, std::size_t(std::max<std::ptrdiff_t>(1, after - faces_.begin()) - 1));
    }
    /// The two columns whose centres x lies between; beyond the outermost centre, that one alone.
    Between between(double x) const {
        const std::size_t i = column(x);
        const std::size_t low = x < centre(i) ? (i > 0 ? i - 1 : 0) : i, high = std::min(low + 1, count() - 1);
        if (low == high || x < centre(low)) return {low, low, 0};
        return {low, high, (x - centre(low)) / (centre(high) - centre(low))};
    }
    friend bool operator==(const ColumnAxis&, const ColumnAxis&) = default;

private:
    friend class ::ansatz::ColumnGrid;
    static std::size_t count_checked(std::string_view which, std::size_t count) {
        if (count < 3 && !(which == "z" && count == 1))
            refuse_value("ColumnGrid", joined({"the number of columns along ", which}), std::to_string(count),
                         "a grid has at least 3 columns along x and along z, or 1 along z: a channel");
        return count;
    }
    void finish(std::string_view which) {
        faces_.push_back(0);
        for (std::size_t i = 0; i < widths_.size(); ++i) {
            const auto width = widths_[i] * metre;
            if (!(widths_[i] > 0) || !is_finite(width))
                refuse_value("ColumnGrid", joined({"the width of column ", std::to_string(i), " along ", which}), width,
                             "it must be finite and greater than zero");
            faces_.push_back(faces_.back() + widths_[i]);
        }
        require_finite("ColumnGrid", joined({"the length along ", which}), faces_.back() * metre);
    }
    /// Checks numbers that were read from a file.
    void check(std::string_view which) const {
        ColumnAxis same(*this);
        same.faces_.clear();
        count_checked(which, widths_.size());
        same.finish(which);
        if (faces_.size() != same.faces_.size())
            refuse_value("ColumnGrid", joined({"the number of faces along ", which}), std::to_string(faces_.size()),
                         joined({"there is one more than the ", std::to_string(widths_.size()), " columns"}));
        const double rounding = 1e-9 * (same.faces_.back() + std::abs(faces_.front()));
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            const double expected = faces_.front() + same.faces_[i];
            if (!(std::abs(faces_[i] - expected) <= rounding) || !is_finite(faces_[i] * metre))
                refuse_value(
                    "ColumnGrid", joined({"face ", std::to_string(i), " along ", which}), faces_[i] * metre,
                    joined({"it must be finite, and by the widths before it at ", describe(expected * metre)}));
        }
    }
    std::vector<double> widths_, faces_;
};
} // namespace detail

/// Rows of columns: `columns_x()` along x, `columns_z()` along z, numbered with x fastest. A value; two of the same
/// widths in the same place are equal.
class ColumnGrid {
public:
    using Length = Quantity<unit::Length>; ///< m

    /// Columns of one footprint, the first at the origin.
    /// \param columns_x at least 3
    /// \param columns_z at least 3, or 1 for a channel in which nothing moves along z
    /// \param dx        width along x, m, finite and positive
    /// \param dz        width along z, m, finite and positive
    /// \throws std::invalid_argument for other values
    ColumnGrid(std::size_t columns_x, std::size_t columns_z, Length dx, Length dz)
        : x_("x", columns_x, dx), z_("z", columns_z, dz) {}
    /// Square columns of one width.
    ColumnGrid(std::size_t columns_x, std::size_t columns_z, Length width)
        : ColumnGrid(columns_x, columns_z, width, width) {}
    /// Columns of unequal footprints: column (i, j) is `widths_x[i]` by `widths_z[j]`.
    /// \throws std::invalid_argument as above
    ColumnGrid(const std::vector<Length>& widths_x, const std::vector<Length>& widths_z)
        : x_("x", widths_x), z_("z", widths_z) {}

    /// The same grid with its first corner there: m, finite, and not so far away that columns have no width.
    /// \throws std::invalid_argument for other places
    ColumnGrid at(Length x, Length z) const {
        require_finite("ColumnGrid::at", "x", x);
        require_finite("ColumnGrid::at", "z", z);
        ColumnGrid moved = *this;
        moved.x_.move_to("x", x.value());
        moved.z_.move_to("z", z.value());
        return moved;
    }

    std::size_t columns_x() const { return x_.count(); }                                  ///< how many along x
    std::size_t columns_z() const { return z_.count(); }                                  ///< how many along z
    std::size_t size() const { return columns_x() * columns_z(); }                        ///< how many columns
    std::size_t index(std::size_t i, std::size_t j) const { return j * columns_x() + i; } ///< in a span of heights
    /// The same of a column that is there.
    /// \throws std::out_of_range, with how many there are, if it is not
    std::size_t known_index(std::string_view where, std::size_t i, std::size_t j) const {
        if (i >= columns_x() || j >= columns_z())
            refuse(
                Refusal::out_of_range,
                detail::joined({where, ": a column is (", std::to_string(i), ", ", std::to_string(j), "); there are ",
                                std::to_string(columns_x()), " x ", std::to_string(columns_z()), ", counted from 0"}));
        return index(i, j);
    }
    bool uniform() const { return x_.uniform() && z_.uniform(); }                    ///< whether all are alike
    Length centre_x(std::size_t i) const { return x_.centre(known(i, x_)) * metre; } ///< of column i along x, m
    Length centre_z(std::size_t j) const { return z_.centre(known(j, z_)) * metre; } ///< of column j along z, m
    Length width_x(std::size_t i) const { return x_.width(known(i, x_)) * metre; }   ///< dx of column i, m
    Length width_z(std::size_t j) const { return z_.width(known(j, z_)) * metre; }   ///< dz of column j, m
    /// dx dz of column (i, j), m^2.
    Quantity<unit::Area> footprint(std::size_t i, std::size_t j) const { return width_x(i) * width_z(j); }
    /// Of all columns, m^2.
    Quantity<unit::Area> area() const { return x_.length() * z_.length() * square_metre; }
    Length begin_x() const { return x_.begin() * metre; } ///< the least x that is covered, m
    Length end_x() const { return x_.end() * metre; }     ///< the largest x that is covered, m
    Length begin_z() const { return z_.begin() * metre; } ///< the least z that is covered, m
    Length end_z() const { return z_.end() * metre; }     ///< the largest z that is covered, m
    /// Whether a column stands there; the outer faces belong to it.
    bool covers(Length x, Length z) const { return x_.covers(x.value()) && z_.covers(z.value()); }
    /// The number of the column that stands there.
    /// \throws std::out_of_range where none does
    std::size_t column(Length x, Length z) const {
        require_covered("ColumnGrid::column", x, z);
        return index(x_.column(x.value()), z_.column(z.value()));
    }
    /// \throws std::out_of_range, with both ranges, where no column stands
    void require_covered(std::string_view where, Length x, Length z) const {
        if (covers(x, z)) return;
        refuse(Refusal::out_of_range,
               detail::joined({where, ": (x, z) is (", describe(x), ", ", describe(z), "); the columns cover x from ",
                               describe(begin_x()), " to ", describe(end_x()), " and z from ", describe(begin_z()),
                               " to ", describe(end_z())}));
    }

    /// \f$ \sum h\,\Delta x\,\Delta z \f$, m^3, of one height for each column, in m. Summed in double for float.
    /// \throws std::invalid_argument for another number of heights
    template <class Scalar>
    Quantity<unit::Volume, detail::SumOf<std::remove_const_t<Scalar>>> volume(std::span<Scalar> heights) const {
        using Sum = detail::SumOf<std::remove_const_t<Scalar>>;
        require_one_each("ColumnGrid::volume", "heights", heights.size());
        Sum total(0);
        for (std::size_t j = 0; j < columns_z(); ++j) {
            Sum row(0);
            for (std::size_t i = 0; i < columns_x(); ++i) row += Sum(heights[index(i, j)]) * Sum(x_.width(i));
            total += row * Sum(z_.width(j));
        }
        return Quantity<unit::Volume, Sum>::from_value(total);
    }
    /// \throws std::invalid_argument unless there is one for each column
    void require_one_each(std::string_view where, std::string_view what, std::size_t count) const {
        if (count != size())
            refuse_value(where, detail::joined({"the number of ", what}), std::to_string(count),
                         detail::joined({"there is one for each of the ", std::to_string(size()), " columns"}));
    }

    const detail::ColumnAxis& x() const { return x_; }                      ///< for surfaces: the columns along x
    const detail::ColumnAxis& z() const { return z_; }                      ///< for surfaces: the columns along z
    friend bool operator==(const ColumnGrid&, const ColumnGrid&) = default; ///< the same columns

    /// Its fields, by name: widths, and faces to the bit.
    static void fields(auto& self, auto&& field) {
        field("widths_x", self.x_.widths_);
        field("faces_x", self.x_.faces_);
        field("widths_z", self.z_.widths_);
        field("faces_z", self.z_.faces_);
    }
    /// Checks numbers that were read from a file.
    /// \throws std::invalid_argument for those that are no grid
    void check() const {
        x_.check("x");
        z_.check("z");
    }

private:
    static std::size_t known(std::size_t i, const detail::ColumnAxis& axis) {
        if (i >= axis.count())
            refuse(Refusal::out_of_range,
                   detail::joined({"ColumnGrid: a column has number ", std::to_string(i), "; they are numbered 0 to ",
                                   std::to_string(axis.count() - 1)}));
        return i;
    }
    detail::ColumnAxis x_, z_;
};

} // namespace ansatz
