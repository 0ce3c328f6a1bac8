// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ShallowWater`: the equations of Saint-Venant, depth and momentum, of first order (beyond notes 7.2; what the
/// columns of the notes leave out).
///
/// Use it where water runs: a dam that breaks, a flood over dry ground, a bore, anything with a front. Not for ripples
/// on a pool: it is of first order, so that it smears low waves, and costs several times what WaterColumns does
/// (SecondOrderShallowWater smears less, and costs more <!-- costs: water wave/seiche: ShallowWater > 3 WaterColumns;
/// water wave/seiche: SecondOrderShallowWater > 2 ShallowWater -->); and not for waves that are short against the
/// depth, which shallow water has not.
///
/// \f[ \partial_t \begin{pmatrix} h \\ hu \\ hw \end{pmatrix} +
///     \partial_x \begin{pmatrix} hu \\ hu^2 + \frac g 2 h^2 \\ huw \end{pmatrix} +
///     \partial_z \begin{pmatrix} hw \\ huw \\ hw^2 + \frac g 2 h^2 \end{pmatrix} =
///     -g h \begin{pmatrix} 0 \\ \partial_x b \\ \partial_z b \end{pmatrix} \f]
///
/// | symbol | meaning                               | unit  |
/// |--------|---------------------------------------|-------|
/// | h, b   | height of a column, height of the bed | m     |
/// | u, w   | velocity along x and z                | m/s   |
/// | hu, hw | momentum over density and footprint   | m^2/s |
///
/// Fluxes by HLL with the slowest and fastest wave of both sides; what is carried along goes with the mass. The bed by
/// hydrostatic reconstruction: both sides of a face are cut to what stands above the higher bed, so that a lake at rest
/// stays at rest and no height becomes negative while everywhere
/// \f$ 2\,\Delta t\,((|u|+c)/\Delta x + (|w|+c)/\Delta z) \le 1 \f$, with \f$ c = \sqrt{gh} \f$. All sides are solid
/// walls. There is no friction. Where the bed falls by s from column to column, water is pushed too little, by the
/// fraction s / 2h, and with s > h by its height alone. Finer columns help, or second order (O. Delestre, S. Cordier,
/// F. Darboux, F. James, A Limitation of the Hydrostatic Reconstruction Technique for Shallow Water Equations, 2012).
///
/// A. Harten, P. Lax, B. van Leer, On Upstream Differencing and Godunov-Type Schemes for Hyperbolic Conservation Laws
/// (1983); E. Audusse, F. Bouchut, M. Bristeau, R. Klein, B. Perthame, A Fast and Stable Well-Balanced Scheme with
/// Hydrostatic Reconstruction for Shallow Water Flows (2004).

#include <ansatz/water/surface.hpp>

#include <array>

namespace ansatz {

namespace detail {
/// What passes a face: mass, momentum across it less the pressure of either side, momentum along it.
template <class Scalar> struct FaceFlux {
    Scalar mass, push_low, push_high, along;
};
/// The same of a row of faces, a lane for each.
template <class Scalar> struct RowOfFaces {
    std::vector<Scalar> mass, push_low, push_high, along;
    void resize(std::size_t n) {
        for (auto* lane : {&mass, &push_low, &push_high, &along}) lane->assign(n, Scalar(0));
    }
};
/// One side of a face: height, bed, velocity across the face and along it, speed of waves.
template <class Scalar> struct FaceSide {
    Scalar h, b, across, along, c;
    /// What a solid wall gives, by HLL of the side and its mirror image, less the pressure; 1 where the wall is ahead
    /// in the direction of x or z, -1 where it is behind.
    [[gnu::always_inline]] Scalar at_wall(const Scalar& side) const {
        using std::abs;
        return h * across * (across + side * (abs(across) + c));
    }
};
/// HLL of two sides after hydrostatic reconstruction. `push_low` is what the lower column gets, `push_high` what the
/// higher gets; the pressure of the column itself, which acts on both of its faces, is left out of both.
template <class Scalar>
[[gnu::always_inline]] inline FaceFlux<Scalar> hll(const FaceSide<Scalar>& low, const FaceSide<Scalar>& high,
                                                   const Scalar& g) {
    using std::sqrt;
    const Scalar zero(0), half_g = Scalar(0.5) * g, least = std::numeric_limits<Scalar>::min();
    const Scalar b1 = low.b, b2 = high.b, sill = b1 < b2 ? b2 : b1;
    const Scalar rest1 = low.h + (b1 - sill), rest2 = high.h + (b2 - sill);
    const Scalar h1 = rest1 > zero ? rest1 : zero, h2 = rest2 > zero ? rest2 : zero;
    const Scalar c1 = sqrt(g * h1), c2 = sqrt(g * h2);
    const Scalar back1 = low.across - c1, back2 = high.across - c2, on1 = low.across + c1, on2 = high.across + c2;
    const Scalar back = back1 < back2 ? back1 : back2, on = on1 < on2 ? on2 : on1;
    const Scalar slow = back < zero ? back : zero, fast = on > zero ? on : zero;
    const Scalar q1 = h1 * low.across, q2 = h2 * high.across;
    const Scalar p1 = half_g * h1 * h1, p2 = half_g * h2 * h2;
    const Scalar m1 = q1 * low.across + p1, m2 = q2 * high.across + p2;
    // F = F1 + slow / (fast - slow) (fast (U2 - U1) - (F2 - F1)): exact where both sides are alike.
    const Scalar share = slow / (fast - slow + least);
    const Scalar mass = q1 + share * (fast * (h2 - h1) - (q2 - q1));
    const Scalar momentum = m1 + share * (fast * (q2 - q1) - (m2 - m1));
    // A bed that is higher than the level of a side is a wall to it.
    const Scalar ahead = low.at_wall(Scalar(1)), behind = high.at_wall(Scalar(-1));
    const Scalar wall1 = rest1 > zero ? zero : ahead, wall2 = rest2 > zero ? zero : behind;
    const Scalar along1 = low.along, along2 = high.along, along = mass > zero ? along1 : along2;
    return {mass, momentum - p1 + wall1, momentum - p2 + wall2, mass * along};
}
/// Below this height a column is a film, m, whose momentum over its height is made of rounding.
template <class Scalar> Scalar thinnest_water() {
    return Scalar(0.03 * std::sqrt(static_cast<double>(std::numeric_limits<Scalar>::epsilon())));
}
/// Momentum over height, m/s; towards zero in a film.
template <class Scalar>
[[gnu::always_inline]] inline Scalar speed_of_water(const Scalar momentum, const Scalar h, const Scalar film) {
    const Scalar thick = h < film ? film : h, part = h / thick;
    return part * part * momentum / thick;
}
} // namespace detail

/// Depth and momentum. Its parameters are read when the Surface is made.
struct ShallowWater {
    Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared; ///< g, m/s^2, finite, positive

    static constexpr std::string_view name = "ShallowWater"; ///< for sentences
    static constexpr bool has_bed = true;                    ///< any bed
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const { require_positive(name, "gravity", gravity); }
    /// It has no parameter that a world saves with its pools: gravity is the world's.
    static void fields(auto&, auto&&) {}

    /// What is kept for each column.
    template <class Scalar> struct State {
        std::vector<Scalar> height;     ///< m
        std::vector<Scalar> bed;        ///< m
        std::vector<Scalar> momentum_x; ///< h u, m^2/s
        std::vector<Scalar> momentum_z; ///< h w, m^2/s
        std::vector<Scalar> owed;       ///< in float: what rounding owes each height, m; else empty
        /// Its fields, by name.
        static void fields(auto& self, auto&& field) {
            field("height", self.height);
            field("bed", self.bed);
            field("momentum_x", self.momentum_x);
            field("momentum_z", self.momentum_z);
            field("owed", self.owed);
        }
        friend bool operator==(const State&, const State&) = default; ///< the same values
    };

    /// The loops by themselves. They check nothing.
    template <class Scalar> class In {
    public:
        using Time = Quantity<unit::Time>; ///< s
        /// The level is not used.
        In(const ShallowWater& policy, const ColumnGrid& grid, Quantity<unit::Length>)
            : gravity_(Scalar(policy.gravity.value())), nx_(grid.columns_x()), nz_(grid.columns_z()) {
            for (std::size_t i = 0; i < nx_; ++i) over_x_.push_back(Scalar(1 / grid.x().width(i)));
            for (std::size_t j = 0; j < nz_; ++j) over_z_.push_back(Scalar(nz_ > 1 ? 1 / grid.z().width(j) : 0.0));
            for (auto* row : {&here_, &north_}) row->resize(nx_);
            for (auto* row : {&along_x_, &south_face_, &north_face_}) row->resize(nx_);
        }
        /// A level bed, and no flow.
        void prepare(State<Scalar>& state, Quantity<unit::Length>) const {
            for (auto* lane : {&state.bed, &state.momentum_x, &state.momentum_z})
                lane->assign(state.height.size(), Scalar(0));
            if (compensated) state.owed.assign(state.height.size(), Scalar(0));
        }
        /// Half of Courant's limit, s, less 1 %, so that no height becomes negative; infinite where all is dry.
        Time longest_step(const State<Scalar>& state) const {
            std::array<Scalar, abreast> most{};
            for (std::size_t j = 0; j < nz_; ++j) {
                const std::size_t n = j * nx_;
                fastest(nx_, gravity_, film_, over_z_[j], over_x_.data(), &state.height[n], &state.momentum_x[n],
                        &state.momentum_z[n], most.data());
            }
            return 0.495 / static_cast<double>(*std::max_element(most.begin(), most.end())) * second;
        }
        /// One pass over all rows, in place: what passes a face is kept until the row behind it needs it.
        void advance(State<Scalar>& state, Time dt) {
            const Scalar h(dt.value());
            load(state, 0, here_);
            wall(here_, south_face_);
            for (std::size_t j = 0; j < nz_; ++j) {
                if (j + 1 < nz_) {
                    load(state, j + 1, north_);
                    across_z(nx_, gravity_, here_, north_, north_face_);
                } else wall(here_, north_face_);
                across_x(nx_, gravity_, here_, along_x_);
                apply(state, j, h);
                std::swap(here_, north_);
                std::swap(south_face_, north_face_);
            }
        }
        /// How fast the water of a column flows, m/s; zero where it is dry.
        Vector<Scalar, 2> velocity(const State<Scalar>& state, std::size_t i, std::size_t j) const {
            const std::size_t n = j * nx_ + i;
            return {speed(state.momentum_x[n], state.height[n], film_),
                    speed(state.momentum_z[n], state.height[n], film_)};
        }

    private:
        /// A slow flow rounds the same way in every step: in float 4e-5 of the volume in 1e4 steps.
        static constexpr bool compensated = std::is_same_v<Scalar, float>;
        [[gnu::always_inline]] static Scalar speed(Scalar momentum, Scalar h, Scalar film) {
            return detail::speed_of_water<Scalar>(momentum, h, film);
        }
        /// The largest (|u| + c) / dx + (|w| + c) / dz of a row, so many maxima abreast, or it would be done one by
        /// one.
        static constexpr std::size_t abreast = 16;
        static void fastest(std::size_t count, Scalar g, Scalar film, Scalar over_z, const Scalar* __restrict over_x,
                            const Scalar* __restrict height, const Scalar* __restrict hu, const Scalar* __restrict hw,
                            Scalar* __restrict most) {
            using std::abs;
            using std::sqrt;
            auto one = [=](std::size_t i, std::size_t k) __attribute__((always_inline)) {
                const Scalar h = height[i], c = sqrt(g * h);
                const Scalar rate =
                    (abs(speed(hu[i], h, film)) + c) * over_x[i] + (abs(speed(hw[i], h, film)) + c) * over_z;
                const Scalar before = most[k];
                most[k] = before < rate ? rate : before;
            };
            std::size_t i = 0;
            for (; i + abreast <= count; i += abreast)
                for (std::size_t k = 0; k < abreast; ++k) one(i + k, k);
            for (; i < count; ++i) one(i, 0);
        }
        struct Row {
            std::vector<Scalar> h, b, u, w, c;
            void resize(std::size_t n) {
                for (auto* lane : {&h, &b, &u, &w, &c}) lane->assign(n, Scalar(0));
            }
            detail::FaceSide<Scalar> along_x(std::size_t i) const { return {h[i], b[i], u[i], w[i], c[i]}; }
            detail::FaceSide<Scalar> along_z(std::size_t i) const { return {h[i], b[i], w[i], u[i], c[i]}; }
        };
        using Faces = detail::RowOfFaces<Scalar>;
        void load(const State<Scalar>& state, std::size_t j, Row& row) const {
            const std::size_t n = j * nx_;
            read(nx_, gravity_, film_, &state.height[n], &state.bed[n], &state.momentum_x[n], &state.momentum_z[n],
                 row.h.data(), row.b.data(), row.u.data(), row.w.data(), row.c.data());
        }
        static void read(std::size_t count, Scalar g, Scalar film, const Scalar* __restrict height,
                         const Scalar* __restrict bed, const Scalar* __restrict hu, const Scalar* __restrict hw,
                         Scalar* __restrict h, Scalar* __restrict b, Scalar* __restrict u, Scalar* __restrict w,
                         Scalar* __restrict c) {
            using std::sqrt;
            for (std::size_t i = 0; i < count; ++i) {
                const Scalar here = height[i];
                h[i] = here;
                b[i] = bed[i];
                c[i] = sqrt(g * here);
                u[i] = speed(hu[i], here, film);
                w[i] = speed(hw[i], here, film);
            }
        }
        /// Through face i, between columns i and i + 1; the last is the eastern wall.
        static void across_x(std::size_t count, const Scalar g, const Row& row, Faces& faces) {
            const Scalar *h = row.h.data(), *b = row.b.data(), *u = row.u.data(), *w = row.w.data(), *c = row.c.data();
            through(count - 1, g, {h, b, u, w, c}, {h + 1, b + 1, u + 1, w + 1, c + 1}, faces);
            const std::size_t e = count - 1;
            faces.mass[e] = faces.along[e] = Scalar(0);
            faces.push_low[e] = row.along_x(e).at_wall(Scalar(1));
        }
        static void across_z(std::size_t count, const Scalar g, const Row& south, const Row& north, Faces& faces) {
            auto side = [](const Row& row) -> Side {
                return {row.h.data(), row.b.data(), row.w.data(), row.u.data(), row.c.data()};
            };
            through(count, g, side(south), side(north), faces);
        }
        struct Side {
            const Scalar *h, *b, *across, *along, *c;
        };
        static void through(std::size_t count, const Scalar g, const Side low, const Side high, Faces& faces) {
            fill(count, g, low, high, faces.mass.data(), faces.push_low.data(), faces.push_high.data(),
                 faces.along.data());
        }
        // Nothing that is written here overlaps: said of parameters, since compilers trust no others.
        static void fill(std::size_t count, const Scalar g, const Side low, const Side high, Scalar* __restrict mass,
                         Scalar* __restrict push_low, Scalar* __restrict push_high, Scalar* __restrict along) {
            for (std::size_t i = 0; i < count; ++i) {
                const auto flux =
                    detail::hll<Scalar>({low.h[i], low.b[i], low.across[i], low.along[i], low.c[i]},
                                        {high.h[i], high.b[i], high.across[i], high.along[i], high.c[i]}, g);
                mass[i] = flux.mass;
                push_low[i] = flux.push_low;
                push_high[i] = flux.push_high;
                along[i] = flux.along;
            }
        }
        /// A solid wall along the row: nothing passes.
        static void wall(const Row& row, Faces& faces) {
            for (std::size_t i = 0; i < row.h.size(); ++i) {
                faces.mass[i] = faces.along[i] = Scalar(0);
                faces.push_low[i] = row.along_z(i).at_wall(Scalar(1));
                faces.push_high[i] = row.along_z(i).at_wall(Scalar(-1));
            }
        }
        /// A row after the step, from its four faces: heights, then both momenta.
        void apply(State<Scalar>& state, std::size_t j, const Scalar& dt) {
            const std::size_t n = j * nx_;
            const Scalar by_z = dt * over_z_[j], zero(0), *const over = over_x_.data();
            const Faces &x = along_x_, &s = south_face_, &t = north_face_;
            raise(nx_, dt, by_z, over, x.mass.data(), s.mass.data(), t.mass.data(), here_.h.data(), &state.height[n],
                  compensated ? &state.owed[n] : nullptr);
            const Scalar *h = here_.h.data(), *u = here_.u.data(), *w = here_.w.data();
            carry(nx_, dt, by_z, over, here_.along_x(0).at_wall(Scalar(-1)), x.push_high.data(), x.push_low.data(),
                  s.along.data(), t.along.data(), h, u, &state.momentum_x[n]);
            carry(nx_, dt, by_z, over, zero, x.along.data(), x.along.data(), s.push_high.data(), t.push_low.data(), h,
                  w, &state.momentum_z[n]);
        }
        static void raise(std::size_t count, Scalar dt, Scalar by_z, const Scalar* __restrict over,
                          const Scalar* __restrict mass, const Scalar* __restrict south, const Scalar* __restrict north,
                          const Scalar* __restrict before, Scalar* __restrict height, Scalar* __restrict owed) {
            using std::abs;
            auto one = [=](std::size_t i, const Scalar& west) __attribute__((always_inline)) {
                const Scalar more = dt * over[i] * (west - mass[i]) + by_z * (south[i] - north[i]);
                if constexpr (compensated) { // what the last sum has rounded away comes with the next (Kahan)
                    const Scalar due = more + owed[i], sum = before[i] + due;
                    // Where a column was set dry since, what it owes is more than it has: it stays owed. Half of the
                    // sum and its size is the sum, or nothing; g++ 12 vectorises no choice between them.
                    const Scalar there = Scalar(0.5) * (sum + abs(sum));
                    owed[i] = due - (there - before[i]);
                    height[i] = there;
                } else height[i] = before[i] + more;
            };
            one(0, Scalar(0));
            for (std::size_t i = 1; i < count; ++i) one(i, mass[i - 1]);
        }
        /// What each column gets from west and gives to east, gets from south and gives to north.
        static void carry(std::size_t count, Scalar dt, Scalar by_z, const Scalar* __restrict over, Scalar wall,
                          const Scalar* __restrict west, const Scalar* __restrict east, const Scalar* __restrict south,
                          const Scalar* __restrict north, const Scalar* __restrict h, const Scalar* __restrict speed,
                          Scalar* __restrict momentum) {
            auto one = [=](std::size_t i, const Scalar& in) __attribute__((always_inline)) {
                momentum[i] = h[i] * speed[i] + (dt * over[i] * (in - east[i]) + by_z * (south[i] - north[i]));
            };
            one(0, wall);
            for (std::size_t i = 1; i < count; ++i) one(i, west[i - 1]);
        }
        Scalar gravity_;
        Scalar film_ = detail::thinnest_water<Scalar>(); // m
        std::size_t nx_, nz_;
        std::vector<Scalar> over_x_, over_z_; // 1 / width
        Row here_, north_;                    // before the step
        Faces along_x_, south_face_, north_face_;
    };
};

static_assert(SurfacePolicyIn<ShallowWater, double> && SurfacePolicyIn<ShallowWater, float>);

} // namespace ansatz
