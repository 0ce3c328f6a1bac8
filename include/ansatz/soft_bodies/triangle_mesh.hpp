// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `TriangleMesh`: vertices, triangles and what follows from them: edges, inner edges, the boundary, areas, the volume.
///
/// Use it to describe a soft body (cloth.hpp), and wherever something acts on triangles or across edges. It is a
/// description in doubles that knows no world; nothing of it is kept in one. Ready made: `grid`, and the closed
/// surfaces of closed_meshes.hpp. Not for meshes in which three triangles share an edge, nor for drawing: it has
/// neither normals nor textures.
///
/// What makes no surface is refused when it is made, by name, index and value: places that are not finite, triangles
/// with a vertex that does not exist, without an area or given twice, an edge of three triangles, a vertex of none.

#include <ansatz/units/function.hpp>
#include <ansatz/units/requirements.hpp>
#include <ansatz/units/vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ansatz {

/// Vertices and the triangles between them.
class TriangleMesh {
public:
    using Index = std::uint32_t;                ///< of a vertex or a triangle, from 0
    using Point = VectorQuantity<unit::Length>; ///< where a vertex is, m
    using Triangle = std::array<Index, 3>;      ///< its vertices, anticlockwise as seen from where its normal points
    using Edge = std::array<Index, 2>;          ///< its vertices, the smaller index first

    /// An edge of two triangles.
    struct InnerEdge {
        Edge ends;                      ///< its vertices, the smaller index first
        std::array<Index, 2> opposite;  ///< the third vertices of the two triangles
        std::array<Index, 2> triangles; ///< the two triangles, the smaller index first
        friend bool operator==(const InnerEdge&, const InnerEdge&) = default; ///< the same vertices and triangles
    };
    /// How many vertices a grid has along each of its sides.
    struct GridShape {
        Index columns; ///< along the first side
        Index rows;    ///< along the second
    };

    /// \param vertices  where they are, m
    /// \param triangles their vertices, by index
    /// \throws std::invalid_argument where that is no surface, and says what is wrong with which of them
    TriangleMesh(std::vector<Point> vertices, std::vector<Triangle> triangles)
        : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
        check_vertices();
        for (Index t = 0; t < triangles_.size(); ++t) check_triangle(t);
        find_edges();
        check_used();
    }

    /// A flat sheet: vertex i + columns * j lies at `origin` + i / (columns - 1) `along` + j / (rows - 1) `across`.
    /// Each of its cells is two triangles, divided from its first corner to the one opposite; their normals point along
    /// the cross product of the two sides.
    /// \param columns, rows how many vertices along the first and the second side, at least 2 each
    /// \param along, across the two sides of the sheet, m
    /// \param origin        where vertex 0 is, m
    /// \throws std::invalid_argument
    static TriangleMesh grid(std::size_t columns, std::size_t rows, const Point& along, const Point& across,
                             const Point& origin = Point::from_value({0, 0, 0})) {
        for (const auto& [name, n] : {std::pair{"columns", columns}, std::pair{"rows", rows}})
            if (n < 2 || n > most)
                refuse_value("TriangleMesh::grid", name, std::to_string(n), "a grid has at least 2, and 2^31 at most");
        if (columns > most / rows)
            refuse_value("TriangleMesh::grid", "columns times rows",
                         detail::joined({std::to_string(columns), " x ", std::to_string(rows)}),
                         "a mesh has at most 2^31 vertices");
        std::vector<Point> vertices;
        std::vector<Triangle> triangles;
        vertices.reserve(columns * rows);
        triangles.reserve(2 * (columns - 1) * (rows - 1));
        for (std::size_t j = 0; j < rows; ++j)
            for (std::size_t i = 0; i < columns; ++i)
                vertices.push_back(origin + double(i) / double(columns - 1) * along +
                                   double(j) / double(rows - 1) * across);
        for (Index j = 0; j + 1 < rows; ++j)
            for (Index i = 0; i + 1 < columns; ++i) {
                const Index a = Index(i + columns * j), b = a + 1, d = Index(a + columns), c = d + 1;
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            }
        TriangleMesh mesh(std::move(vertices), std::move(triangles));
        mesh.grid_ = GridShape{Index(columns), Index(rows)};
        return mesh;
    }

    std::span<const Point> vertices() const { return vertices_; }      ///< where they are, m
    std::span<const Triangle> triangles() const { return triangles_; } ///< as they were given
    std::span<const Edge> edges() const { return edges_; }             ///< each once, by its vertices in rising order
    std::span<const InnerEdge> inner_edges() const { return inner_; }  ///< those of two triangles, in the same order
    std::span<const Edge> boundary() const { return boundary_; }       ///< those of one, in the same order
    bool is_closed() const { return boundary_.empty(); }               ///< whether it has no boundary
    std::optional<GridShape> grid_shape() const { return grid_; }      ///< its shape, if `grid` made it

    /// Whether all triangles face the same side: each inner edge runs one way in one triangle and the other way in
    /// the other. A volume, a pressure and a wind need it; springs do not.
    bool is_oriented() const { return oriented_; }

    /// The area of a triangle, m^2.
    /// \throws std::out_of_range if there is no such triangle
    Quantity<unit::Area> area(Index triangle) const {
        if (triangle >= triangles_.size())
            refuse(Refusal::out_of_range,
                   detail::joined({"TriangleMesh::area: triangle ", std::to_string(triangle),
                                   " does not exist; there are ", std::to_string(triangles_.size())}));
        return 0.5 * doubled_area(triangles_[triangle]);
    }
    /// The area of all triangles, m^2.
    Quantity<unit::Area> area() const {
        Quantity<unit::Area> sum{};
        for (const Triangle& t : triangles_) sum += 0.5 * doubled_area(t);
        return sum;
    }
    /// The share of the area that each vertex has, m^2: a third of each of its triangles; of a grid a quarter of each
    /// of its cells, so that it does not matter along which diagonal they are divided. Their sum is `area()`.
    std::vector<Quantity<unit::Area>> vertex_areas() const {
        std::vector<Quantity<unit::Area>> shares(vertices_.size());
        if (grid_) {
            for (std::size_t cell = 0; 2 * cell < triangles_.size(); ++cell) {
                const auto& [a, b, c] = triangles_[2 * cell];
                const Index d = triangles_[2 * cell + 1][2];
                const Quantity<unit::Area> quarter =
                    (doubled_area(triangles_[2 * cell]) + doubled_area(triangles_[2 * cell + 1])) / 8.0;
                for (const Index v : {a, b, c, d}) shares[v] += quarter;
            }
        } else {
            for (const Triangle& t : triangles_)
                for (const Index v : t) shares[v] += doubled_area(t) / 6.0;
        }
        return shares;
    }
    /// The volume inside, m^3; negative where the triangles face inwards.
    /// \f[ V = \tfrac16 \sum_{abc} (\mathbf x_a - \mathbf x_0) \cdot (\mathbf x_b - \mathbf x_0) \times
    ///         (\mathbf x_c - \mathbf x_0) \f]
    /// \throws std::invalid_argument if the surface is open or not oriented
    Quantity<unit::Volume> volume() const {
        if (!is_closed())
            refuse_value("TriangleMesh::volume", "the boundary",
                         detail::joined({std::to_string(boundary_.size()), " edges"}),
                         "only a closed surface has a volume");
        if (!is_oriented())
            refuse_value("TriangleMesh::volume", "the surface", "not oriented",
                         "all triangles must face the same side");
        Quantity<unit::Volume> sum{};
        const Point from = vertices_[0]; // relative to a vertex: far from the origin no digit is lost
        for (const auto& [a, b, c] : triangles_)
            sum += dot(vertices_[a] - from, cross(vertices_[b] - from, vertices_[c] - from));
        return sum / 6.0;
    }

    /// The same mesh elsewhere.
    /// \param by how far it is moved, m
    /// \throws std::invalid_argument
    TriangleMesh moved(const Point& by) const {
        TriangleMesh there = *this;
        for (Point& x : there.vertices_) x += by;
        there.check_vertices();
        return there;
    }

private:
    static constexpr std::size_t most = std::size_t(1) << 31;

    static std::string named(const char* what, Index i) { return detail::joined({what, " ", std::to_string(i)}); }
    static std::string text(const Triangle& t) {
        return detail::joined({"{", std::to_string(t[0]), ", ", std::to_string(t[1]), ", ", std::to_string(t[2]), "}"});
    }
    [[noreturn, gnu::cold]] static void refuse_mesh(const std::string& what, const std::string& value,
                                                    const std::string& accepted) {
        refuse_value("TriangleMesh", std::string_view(what), std::string_view(value), std::string_view(accepted));
    }
    static Edge edge(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }
    Quantity<unit::Area> doubled_area(const Triangle& t) const {
        const Point a = vertices_[t[0]];
        return norm(cross(vertices_[t[1]] - a, vertices_[t[2]] - a));
    }

    void check_vertices() const {
        if (vertices_.size() > most)
            refuse_mesh("the number of vertices", std::to_string(vertices_.size()), "2^31 at most");
        for (Index v = 0; v < vertices_.size(); ++v) require_finite("TriangleMesh", named("vertex", v), vertices_[v]);
    }
    void check_triangle(Index index) const {
        const Triangle& t = triangles_[index];
        for (const Index v : t)
            if (v >= vertices_.size())
                refuse_mesh(named("triangle", index), text(t),
                            detail::joined({"vertex ", std::to_string(v), " does not exist; there are ",
                                            std::to_string(vertices_.size()), ", from 0"}));
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            refuse_mesh(named("triangle", index), text(t), "its vertices are three different ones");
        // No area is one that rounding of the places alone may have left: those of a far triangle have fewer digits.
        Quantity<unit::Length> farthest{}, longest{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Point x = vertices_[t[k]];
            for (int i = 0; i < 3; ++i) farthest = std::max(farthest, abs(component(x, i)));
            longest = std::max(longest, norm(vertices_[t[(k + 1) % 3]] - x));
        }
        const auto doubled = doubled_area(t);
        const auto name = [&] {
            return detail::joined({"the area of triangle ", std::to_string(index), " ", text(t)});
        };
        if (!is_finite(doubled) || !is_finite(longest))
            refuse_mesh(name(), describe(0.5 * doubled), "it must be finite");
        if (!(doubled > 8 * std::numeric_limits<double>::epsilon() * ((farthest + longest) * longest)))
            refuse_mesh(name(), describe(0.5 * doubled),
                        "its vertices lie in a line or in one place; a triangle has an area");
    }
    /// One side of one triangle.
    struct Side {
        Edge ends;
        Index triangle, opposite;
        bool rising; // it runs from the smaller index to the larger
        friend auto operator<=>(const Side&, const Side&) = default;
    };
    void find_edges() {
        if (triangles_.empty()) refuse_mesh("the number of triangles", "0", "a mesh has at least one");
        if (triangles_.size() > most)
            refuse_mesh("the number of triangles", std::to_string(triangles_.size()), "2^31 at most");
        refuse_twice();
        std::vector<Side> sides;
        sides.reserve(3 * triangles_.size());
        for (Index t = 0; t < triangles_.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
                sides.push_back({edge(a, b), t, triangles_[t][(k + 2) % 3], a < b});
            }
        std::sort(sides.begin(), sides.end());
        for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
            while (next < sides.size() && sides[next].ends == sides[i].ends) ++next;
            add_edge(std::span(sides).subspan(i, next - i));
        }
    }
    void add_edge(std::span<const Side> sides) {
        const Edge ends = sides[0].ends;
        if (sides.size() > 2)
            refuse_mesh(detail::joined({"edge {", std::to_string(ends[0]), ", ", std::to_string(ends[1]), "}"}),
                        detail::joined({"a side of ", std::to_string(sides.size()), " triangles (",
                                        std::to_string(sides[0].triangle), ", ", std::to_string(sides[1].triangle),
                                        ", ", std::to_string(sides[2].triangle), ")"}),
                        "an edge belongs to one triangle or to two");
        edges_.push_back(ends);
        if (sides.size() == 1) return boundary_.push_back(ends);
        inner_.push_back({ends, {sides[0].opposite, sides[1].opposite}, {sides[0].triangle, sides[1].triangle}});
        oriented_ = oriented_ && sides[0].rising != sides[1].rising;
    }
    void refuse_twice() const {
        std::vector<std::pair<Triangle, Index>> sorted;
        sorted.reserve(triangles_.size());
        for (Index t = 0; t < triangles_.size(); ++t) {
            Triangle vertices = triangles_[t];
            std::sort(vertices.begin(), vertices.end());
            sorted.emplace_back(vertices, t);
        }
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end(),
                                              [](const auto& a, const auto& b) { return a.first == b.first; });
        if (twice != sorted.end())
            refuse_mesh(named("triangle", (twice + 1)->second), text(triangles_[(twice + 1)->second]),
                        detail::joined({"triangle ", std::to_string(twice->second),
                                        " has the same vertices; each is given once"}));
    }
    void check_used() const {
        std::vector<bool> used(vertices_.size());
        for (const Triangle& t : triangles_)
            for (const Index v : t) used[v] = true;
        const auto lone = std::find(used.begin(), used.end(), false);
        if (lone != used.end())
            refuse_mesh(named("vertex", Index(lone - used.begin())), "in no triangle",
                        "each belongs to one, or it would have no mass");
    }

    std::vector<Point> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<Edge> edges_, boundary_;
    std::vector<InnerEdge> inner_;
    std::optional<GridShape> grid_;
    bool oriented_ = true;
};

} // namespace ansatz
