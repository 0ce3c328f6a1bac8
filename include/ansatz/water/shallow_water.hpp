// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `ShallowWater`: the equations of Saint-Venant, depth and momentum, of first order (beyond notes 7.2; what the
/// columns of the notes leave out).
///
/// Use it where water runs: a dam that breaks, a flood over dry ground, a bore, anything with a front. Not for ripples
/// on a pool: it is of first order, so that it smears low waves, and costs several times what WaterColumns does; and
/// not for waves that are short against the depth, which shallow water has not.
///
/// \f[ \partial_t \begin{pmatrix} h \\ hu \\ hw \end{pmatrix} + \partial_x \begin{pmatrix} hu \\ hu^2 + \frac g 2 h^2 \\ huw \end{pmatrix} + \partial_z \begin{pmatrix} hw \\ huw \\ hw^2 + \frac g 2 h^2 \end{pmatrix} = -g h \begin{pmatrix} 0 \\ \partial_x b \\ \partial_z b \end{pmatrix} \f]
///
/// | symbol | meaning                               | unit  |
/// |--------|---------------------------------------|-------|
/// | h, b   | height of a column, height of the bed | m     |
/// | u, w   | velocity along x and z                | m/s   |
/// | hu, hw | momentum over density and footprint   | m^2/s |
///
/// Fluxes by HLL with the slowest and fastest wave of both sides; what is carried along goes with the mass. The bed by
/// hydrostatic reconstruction: both sides of a face are cut to what stands above the higher bed, so that a lake at rest
/// stays at rest and no height becomes negative while \f$ 2\,\Delta t\,((|u|+c)/\Delta x + (|w|+c)/\Delta z) \le 1 \f$ everywhere,
/// with \f$ c = \sqrt{gh} \f$. All sides are solid walls. There is no friction.
///
/// A. Harten, P. Lax, B. van Leer, On Upstream Differencing and Godunov-Type Schemes for Hyperbolic Conservation Laws
/// (1983); E. Audusse, F. Bouchut, M. Bristeau, R. Klein, B. Perthame, A Fast and Stable Well-Balanced Scheme with
/// Hydrostatic Reconstruction for Shallow Water Flows (2004).

#include <ansatz/water/surface.hpp>

namespace ansatz {

namespace detail {
/// What passes a face: mass, momentum across it less the pressure of either side, momentum along it.
template <class Scalar> struct FaceFlux {
    Scalar mass, push_low, push_high, along;
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
    const Scalar sill = low.b < high.b ? high.b : low.b;
    const Scalar rest1 = low.h + (low.b - sill), rest2 = high.h + (high.b - sill);
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
    const Scalar one(1), wall1 = rest1 > zero ? zero : low.at_wall(one),
                         wall2 = rest2 > zero ? zero : high.at_wall(-one);
    return {mass, momentum - p1 + wall1, momentum - p2 + wall2, mass * (mass > zero ? low.along : high.along)};
}
} // namespace detail

/// Depth and momentum. Its parameters are read when the Surface is made.
struct ShallowWater {
    Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared; ///< g, m/s^2, finite, positive

    static constexpr std::string_view name = "ShallowWater"; ///< for sentences
    static constexpr bool has_bed = true;                    ///< any bed
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const { require_positive(name, "gravity", gravity); }

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
        /// The level is not looked at.
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
            using std::abs;
            using std::sqrt;
            Scalar most(0);
            for (std::size_t j = 0, n = 0; j < nz_; ++j)
                for (std::size_t i = 0; i < nx_; ++i, ++n) {
                    const Scalar h = state.height[n], c = sqrt(gravity_ * h);
                    const Scalar rate = (abs(speed(state.momentum_x[n], h)) + c) * over_x_[i] +
                                        (abs(speed(state.momentum_z[n], h)) + c) * over_z_[j];
                    most = most < rate ? rate : most;
                }
            return 0.495 / static_cast<double>(most) * second;
        }
        /// One sweep over all rows, in place: what passes a face is kept until the row behind it needs it.
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
            return {speed(state.momentum_x[n], state.height[n]), speed(state.momentum_z[n], state.height[n])};
        }

    private:
        /// A slow flow rounds the same way in every step: in float 4e-5 of the volume in 1e4 steps.
        static constexpr bool compensated = std::is_same_v<Scalar, float>;
        /// Momentum over height; towards zero in a film, whose velocity is made of rounding.
        [[gnu::always_inline]] Scalar speed(const Scalar& momentum, const Scalar& h) const {
            const Scalar thick = h < film_ ? film_ : h, part = h / thick;
            return part * part * momentum / thick;
        }
        struct Row {
            std::vector<Scalar> h, b, u, w, c;
            void resize(std::size_t n) {
                for (auto* lane : {&h, &b, &u, &w, &c}) lane->assign(n, Scalar(0));
            }
            [[gnu::always_inline]] detail::FaceSide<Scalar> along_x(std::size_t i) const {
                return {h[i], b[i], u[i], w[i], c[i]};
            }
            [[gnu::always_inline]] detail::FaceSide<Scalar> along_z(std::size_t i) const {
                return {h[i], b[i], w[i], u[i], c[i]};
            }
        };
        void load(const State<Scalar>& state, std::size_t j, Row& row) const {
            const std::size_t from = j * nx_;
            const Scalar *height = &state.height[from], *bed = &state.bed[from], *hu = &state.momentum_x[from],
                         *hw = &state.momentum_z[from];
            Scalar *__restrict h = row.h.data(), *__restrict b = row.b.data(), *__restrict u = row.u.data(),
                   *__restrict w = row.w.data(), *__restrict c = row.c.data();
            using std::sqrt;
            for (std::size_t i = 0; i < nx_; ++i) {
                h[i] = height[i];
                b[i] = bed[i];
                c[i] = sqrt(gravity_ * height[i]);
                u[i] = speed(hu[i], height[i]);
                w[i] = speed(hw[i], height[i]);
            }
        }
        struct Faces {
            std::vector<Scalar> mass, push_low, push_high, along;
            void resize(std::size_t n) {
                for (auto* lane : {&mass, &push_low, &push_high, &along}) lane->assign(n, Scalar(0));
            }
            void set(std::size_t i, const detail::FaceFlux<Scalar>& flux) {
                mass[i] = flux.mass;
                push_low[i] = flux.push_low;
                push_high[i] = flux.push_high;
                along[i] = flux.along;
            }
        };
        /// Through face i, between columns i and i + 1; the last is the eastern wall.
        static void across_x(std::size_t count, const Scalar g, const Row& row, Faces& faces) {
            through(
                count - 1, g, [&](std::size_t i) { return row.along_x(i); },
                [&](std::size_t i) { return row.along_x(i + 1); }, faces);
            const std::size_t e = count - 1;
            faces.mass[e] = faces.along[e] = Scalar(0);
            faces.push_low[e] = row.along_x(e).at_wall(Scalar(1));
        }
        static void across_z(std::size_t count, const Scalar g, const Row& south, const Row& north, Faces& faces) {
            through(
                count, g, [&](std::size_t i) { return south.along_z(i); },
                [&](std::size_t i) { return north.along_z(i); }, faces);
        }
        template <class Low, class High>
        [[gnu::always_inline]] static void through(std::size_t count, const Scalar g, const Low& low, const High& high,
                                                   Faces& faces) {
            Scalar *__restrict mass = faces.mass.data(), *__restrict push_low = faces.push_low.data(),
                   *__restrict push_high = faces.push_high.data(), *__restrict along = faces.along.data();
            for (std::size_t i = 0; i < count; ++i) {
                const auto flux = detail::hll<Scalar>(low(i), high(i), g);
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
        /// A row after the step, from its four faces.
        void apply(State<Scalar>& state, std::size_t j, const Scalar& dt) {
            const std::size_t n = j * nx_;
            Faces& x = along_x_;
            auto column = [&](std::size_t i, const Scalar& mass, const Scalar& push, const Scalar& along)
                __attribute__((always_inline)) {
                const Scalar by_x = dt * over_x_[i], by_z = dt * over_z_[j];
                const Scalar more = by_x * (mass - x.mass[i]) + by_z * (south_face_.mass[i] - north_face_.mass[i]);
                const Scalar hu = here_.h[i] * here_.u[i] + (by_x * (push - x.push_low[i]) +
                                                             by_z * (south_face_.along[i] - north_face_.along[i]));
                const Scalar hw =
                    here_.h[i] * here_.w[i] +
                    (by_x * (along - x.along[i]) + by_z * (south_face_.push_high[i] - north_face_.push_low[i]));
                if constexpr (compensated) { // what the last sum has rounded away comes with the next (Kahan)
                    const Scalar due = more + state.owed[n + i], h = here_.h[i] + due;
                    state.owed[n + i] = due - (h - here_.h[i]);
                    state.height[n + i] = h;
                } else state.height[n + i] = here_.h[i] + more;
                state.momentum_x[n + i] = hu;
                state.momentum_z[n + i] = hw;
            };
            column(0, Scalar(0), here_.along_x(0).at_wall(Scalar(-1)), Scalar(0));
            for (std::size_t i = 1; i < nx_; ++i) column(i, x.mass[i - 1], x.push_high[i - 1], x.along[i - 1]);
        }
        Scalar gravity_;
        Scalar film_ = Scalar(0.03 * std::sqrt(static_cast<double>(std::numeric_limits<Scalar>::epsilon()))); // m
        std::size_t nx_, nz_;
        std::vector<Scalar> over_x_, over_z_; // 1 / width
        Row here_, north_;                    // before the step
        Faces along_x_, south_face_, north_face_;
    };
};

static_assert(SurfacePolicyIn<ShallowWater, double> && SurfacePolicyIn<ShallowWater, float>);

} // namespace ansatz
