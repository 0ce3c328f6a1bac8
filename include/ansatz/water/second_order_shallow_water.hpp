// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `SecondOrderShallowWater`: the equations of ShallowWater, of second order in space and time (beyond notes 7.2).
///
/// Use it where a front or a long wave has to come through unsmeared: for the same error it needs far fewer columns
/// than ShallowWater. It keeps what that keeps, so that a state of one goes on in the other. Not for ripples on a still
/// pool, which WaterColumns do at a fraction of the price; and at a shock it, too, is of first order.
///
/// In each column the level, the height and the velocity are lines (MUSCL), as steep as the differences to both
/// neighbours allow:
///
/// \f[ \delta q = \operatorname{minmod}\Bigl(\tfrac\theta2 (q_{i+1} - q_i),\ \tfrac14 (q_{i+1} - q_{i-1}),\ \tfrac\theta2 (q_i - q_{i-1})\Bigr), \qquad q_{face} = q_i \pm \delta q \f]
///
/// so that a face has no more and no less than the two columns beside it. What passes it is the flux of ShallowWater,
/// of both faces' lines instead of both columns' means. Within a column the pressure of its two faces and the
/// weight on its sloping bed are
///
/// \f[ \frac g 2 (h_w^2 - h_e^2) + \frac g 2 (h_w + h_e)(b_w - b_e) = -2\,g\,h\,\delta\eta \f]
///
/// with the level \f$ \eta = b + h \f$: zero where that is the same everywhere, so that a lake at rest stays at rest. A
/// step is the mean of where it began and of what two steps of Euler come to (Heun); it keeps heights positive because
/// those do. Where the water has become so fast that the second would be too long, the second is shorter, and the mean
/// is weighted for it.
///
/// | symbol     | meaning                                                                | unit   |
/// |------------|------------------------------------------------------------------------|--------|
/// | h, b, eta  | height of a column, of its bed, level; w and e: at its west, its east  | m      |
/// | q, delta q | level, height or velocity, and half of what it changes within a column | m, m/s |
/// | theta      | steepness, from 1 (minmod) to 2 (monotonised central)                  | 1      |
///
/// The step is at most
///
/// \f[ \Delta t \le \frac 1 2 \Bigl(\max \frac{|u| + c}{\Delta x} + \max \frac{|w| + c}{\Delta z}\Bigr)^{-1} \f]
///
/// where the largest of |u|, and of c, of two neighbours counts. All sides are solid walls: mirrors. Friction is not
/// provided.
///
/// B. van Leer, Towards the Ultimate Conservative Difference Scheme V (1979); E. Audusse, F. Bouchut, M. Bristeau, R.
/// Klein, B. Perthame, A Fast and Stable Well-Balanced Scheme with Hydrostatic Reconstruction for Shallow Water Flows
/// (2004); S. Gottlieb, C. Shu, Total Variation Diminishing Runge-Kutta Schemes (1998).

#include <ansatz/water/shallow_water.hpp>

namespace ansatz {

namespace detail {

/// How steep a line within a column may be: weights of the differences to the column before and to that after it.
template <class Scalar> struct LineWeights {
    Scalar before, after;           ///< of the slope through both
    Scalar most_before, most_after; ///< which fraction of each it may not pass
    /// Half of what changes within the column.
    [[gnu::always_inline]] Scalar half(const Scalar from, const Scalar here, const Scalar to) const {
        const Scalar zero(0), back = here - from, on = to - here;
        const Scalar middle = before * back + after * on, a = most_before * back, b = most_after * on;
        const Scalar low = a < b ? a : b, high = a < b ? b : a;
        const Scalar up = low > zero ? low : zero, down = high < zero ? high : zero;
        const Scalar not_above = middle < up ? middle : up;
        return not_above < down ? down : not_above;
    }
};
/// Those of the columns along one axis. Behind a wall is a mirror, a column as wide as the last.
template <class Scalar> struct LinesAlong {
    std::vector<Scalar> before, after, most_before, most_after;
    LinesAlong(const ColumnAxis& axis, double steepness) {
        const std::size_t n = axis.count();
        for (std::size_t i = 0; i < n; ++i) {
            const double w = axis.width(i), to_before = i > 0 ? axis.distance(i - 1) : w,
                         to_after = i + 1 < n ? axis.distance(i) : w, all = 2 * (to_before + to_after);
            before.push_back(Scalar(w * to_after / (to_before * all)));
            after.push_back(Scalar(w * to_before / (to_after * all)));
            most_before.push_back(Scalar(std::min(1.0, 0.5 * steepness * w / to_before)));
            most_after.push_back(Scalar(std::min(1.0, 0.5 * steepness * w / to_after)));
        }
    }
    [[gnu::always_inline]] LineWeights<Scalar> operator[](std::size_t i) const {
        return {before[i], after[i], most_before[i], most_after[i]};
    }
};

} // namespace detail

/// Depth and momentum, of second order. Its parameters are read when the Surface is made.
struct SecondOrderShallowWater {
    Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared; ///< g, m/s^2, finite, positive
    /// theta of the limiter: from 1, which smears more, to 2, which makes smooth humps a little angular.
    double steepness = 2;

    static constexpr std::string_view name = "SecondOrderShallowWater"; ///< for sentences
    static constexpr bool has_bed = true;                               ///< any bed
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const {
        require_positive(name, "gravity", gravity);
        if (!(steepness >= 1 && steepness <= 2))
            refuse_value(name, "steepness", steepness,
                         "it is from 1 (minmod, the most careful) to 2 (monotonised central, the steepest)");
    }
    /// Its parameters, by name, as a world saves them with its pools: gravity is the world's.
    static void fields(auto& self, auto&& field) { field("steepness", self.steepness); }

    /// What is kept for each column: the same.
    template <class Scalar> using State = ShallowWater::State<Scalar>;

    /// The loops by themselves. They check nothing.
    template <class Scalar> class In {
    public:
        using Time = Quantity<unit::Time>; ///< s
        /// The level is not used.
        In(const SecondOrderShallowWater& policy, const ColumnGrid& grid, Quantity<unit::Length>)
            : gravity_(Scalar(policy.gravity.value())),
              nx_(grid.columns_x()),
              nz_(grid.columns_z()),
              lines_x_(grid.x(), policy.steepness),
              lines_z_(grid.z(), policy.steepness) {
            for (std::size_t i = 0; i < nx_; ++i) over_x_.push_back(Scalar(1 / grid.x().width(i)));
            for (std::size_t j = 0; j < nz_; ++j) over_z_.push_back(Scalar(nz_ > 1 ? 1 / grid.z().width(j) : 0.0));
            for (auto* row : {&here_, &next_, &after_, &mirror_, &x_, &z_, &next_z_}) row->resize(nx_);
            for (auto* row : {&along_x_, &south_face_, &north_face_}) row->resize(nx_);
            for (auto* lane : {&ahead_.height, &ahead_.momentum_x, &ahead_.momentum_z})
                lane->assign(grid.size(), Scalar(0));
            if (compensated) ahead_.owed.assign(grid.size(), Scalar(0));
        }
        /// A level bed, and no flow.
        void prepare(State<Scalar>& state, Quantity<unit::Length>) const {
            for (auto* lane : {&state.bed, &state.momentum_x, &state.momentum_z})
                lane->assign(state.height.size(), Scalar(0));
            if (compensated) state.owed.assign(state.height.size(), Scalar(0));
        }
        /// Half of Courant's limit, s, less 1 %, so that no height becomes negative; infinite where all is dry.
        Time longest_step(const State<Scalar>& state) const { return 0.495 / fastest(state) * second; }
        /// Two stages: a step ahead, and from there one more.
        void advance(State<Scalar>& state, const Time& dt) {
            pass<false>(state, state.bed, ahead_, Scalar(dt.value()), Scalar(1));
            // The mean of the first state and of one that is dt (1 + part) later, weighted so that it is dt later.
            const double part = std::min(1.0, 0.495 / fastest(ahead_) / dt.value());
            pass<true>(ahead_, state.bed, state, Scalar(part * dt.value()), Scalar(1 / (1 + part)));
        }
        /// How fast the water of a column flows, m/s; zero where it is dry.
        Vector<Scalar, 2> velocity(const State<Scalar>& state, std::size_t i, std::size_t j) const {
            const std::size_t n = j * nx_ + i;
            return {detail::speed_of_water<Scalar>(state.momentum_x[n], state.height[n], film_),
                    detail::speed_of_water<Scalar>(state.momentum_z[n], state.height[n], film_)};
        }

    private:
        /// In float the part of each height that rounding took off goes on beside it: it has 48 bits then.
        static constexpr bool compensated = std::is_same_v<Scalar, float>;
        /// The largest (|u| + c) / dx of two neighbours along x, and the like along z, added; 1/s.
        double fastest(const State<Scalar>& state) const {
            constexpr std::size_t block = 64;
            struct Speeds {
                std::array<Scalar, block + 1> u, w, c;
            } now, before;
            std::array<Scalar, block> most_x{}, most_z{};
            for (std::size_t begin = 0; begin < nx_; begin += block) {
                const std::size_t count = std::min(block, nx_ - begin), pairs = std::min(block, nx_ - 1 - begin);
                for (std::size_t j = 0; j < nz_; ++j) {
                    const std::size_t n = j * nx_ + begin;
                    speeds(std::max(count, pairs + 1), gravity_, film_, &state.height[n], &state.momentum_x[n],
                           &state.momentum_z[n], now.u.data(), now.w.data(), now.c.data());
                    for (std::size_t i = 0; i < pairs; ++i)
                        raise_to(most_x[i], now.u[i], now.u[i + 1], now.c[i], now.c[i + 1],
                                 std::max(over_x_[begin + i], over_x_[begin + i + 1]));
                    if (j > 0)
                        for (std::size_t i = 0; i < count; ++i)
                            raise_to(most_z[i], now.w[i], before.w[i], now.c[i], before.c[i],
                                     std::max(over_z_[j - 1], over_z_[j]));
                    std::swap(now, before);
                }
            }
            return static_cast<double>(*std::max_element(most_x.begin(), most_x.end())) +
                   static_cast<double>(*std::max_element(most_z.begin(), most_z.end()));
        }
        [[gnu::always_inline]] static void raise_to(Scalar& most, const Scalar u1, const Scalar u2, const Scalar c1,
                                                    const Scalar c2, const Scalar over) {
            const Scalar rate = ((u1 < u2 ? u2 : u1) + (c1 < c2 ? c2 : c1)) * over, was = most;
            most = was < rate ? rate : was;
        }
        static void speeds(std::size_t count, Scalar g, Scalar film, const Scalar* __restrict height,
                           const Scalar* __restrict hu, const Scalar* __restrict hw, Scalar* __restrict u,
                           Scalar* __restrict w, Scalar* __restrict c) {
            using std::abs;
            using std::sqrt;
            for (std::size_t i = 0; i < count; ++i) {
                const Scalar h = height[i];
                u[i] = abs(detail::speed_of_water<Scalar>(hu[i], h, film));
                w[i] = abs(detail::speed_of_water<Scalar>(hw[i], h, film));
                c[i] = sqrt(g * h);
            }
        }
        /// A row of columns, or half of what changes within each of them.
        struct Row {
            std::vector<Scalar> h, level, u, w;
            void resize(std::size_t n) {
                for (auto* lane : {&h, &level, &u, &w}) lane->assign(n, Scalar(0));
            }
        };
        using Faces = detail::RowOfFaces<Scalar>;
        /// Lanes of a row and of its slopes, from one column on.
        struct Lines {
            const Scalar *h, *level, *across, *along, *to_h, *to_level, *to_across, *to_along;
            /// At the face ahead of column i, or at that behind it.
            template <int Way> [[gnu::always_inline]] detail::FaceSide<Scalar> at(std::size_t i, const Scalar g) const {
                using std::sqrt;
                const Scalar h1 = Way > 0 ? h[i] + to_h[i] : h[i] - to_h[i],
                             y1 = Way > 0 ? level[i] + to_level[i] : level[i] - to_level[i],
                             u1 = Way > 0 ? across[i] + to_across[i] : across[i] - to_across[i],
                             w1 = Way > 0 ? along[i] + to_along[i] : along[i] - to_along[i];
                return {h1, y1 - h1, u1, w1, sqrt(g * h1)};
            }
        };
        static Lines lines_along_x(const Row& r, const Row& to, std::size_t i) {
            return {&r.h[i], &r.level[i], &r.u[i], &r.w[i], &to.h[i], &to.level[i], &to.u[i], &to.w[i]};
        }
        static Lines lines_along_z(const Row& r, const Row& to) {
            return {r.h.data(),  r.level.data(),  r.w.data(),  r.u.data(),
                    to.h.data(), to.level.data(), to.w.data(), to.u.data()};
        }

        /// One step of Euler from one state into another; the last stage mixes it with what is there.
        template <bool Last>
        void pass(const State<Scalar>& from, const std::vector<Scalar>& bed, State<Scalar>& to, Scalar dt,
                  Scalar weight) {
            load(from, bed, 0, here_);
            if (nz_ > 1) {
                load(from, bed, 1, next_);
                reflect(here_);
                slopes_z(0, mirror_, here_, next_, z_);
            }
            wall<-1>(here_, z_, south_face_);
            for (std::size_t j = 0; j < nz_; ++j) {
                if (j + 2 < nz_) load(from, bed, j + 2, after_);
                else if (j + 1 < nz_) reflect(next_);
                if (j + 1 < nz_) {
                    slopes_z(j + 1, here_, next_, j + 2 < nz_ ? after_ : mirror_, next_z_);
                    through(nx_, lines_along_z(here_, z_), lines_along_z(next_, next_z_), north_face_);
                } else wall<1>(here_, z_, north_face_);
                slopes_x();
                through(nx_ - 1, lines_along_x(here_, x_, 0), lines_along_x(here_, x_, 1), along_x_);
                along_x_.mass[nx_ - 1] = along_x_.along[nx_ - 1] = Scalar(0);
                along_x_.push_low[nx_ - 1] =
                    lines_along_x(here_, x_, 0).template at<1>(nx_ - 1, gravity_).at_wall(Scalar(1));
                apply<Last>(from, to, j, dt, weight);
                std::swap(here_, next_);
                std::swap(next_, after_);
                std::swap(z_, next_z_);
                std::swap(south_face_, north_face_);
            }
        }
        void load(const State<Scalar>& state, const std::vector<Scalar>& bed, std::size_t j, Row& row) const {
            const std::size_t n = j * nx_;
            read(nx_, film_, &state.height[n], &bed[n], &state.momentum_x[n], &state.momentum_z[n], row.h.data(),
                 row.level.data(), row.u.data(), row.w.data());
        }
        static void read(std::size_t count, Scalar film, const Scalar* __restrict height, const Scalar* __restrict bed,
                         const Scalar* __restrict hu, const Scalar* __restrict hw, Scalar* __restrict h,
                         Scalar* __restrict level, Scalar* __restrict u, Scalar* __restrict w) {
            for (std::size_t i = 0; i < count; ++i) {
                const Scalar here = height[i];
                h[i] = here;
                level[i] = bed[i] + here;
                u[i] = detail::speed_of_water<Scalar>(hu[i], here, film);
                w[i] = detail::speed_of_water<Scalar>(hw[i], here, film);
            }
        }
        /// What is behind a wall along the row.
        void reflect(const Row& row) {
            mirror_.h = row.h;
            mirror_.level = row.level;
            mirror_.u = row.u;
            for (std::size_t i = 0; i < nx_; ++i) mirror_.w[i] = -row.w[i];
        }
        void slopes_z(std::size_t j, const Row& south, const Row& here, const Row& north, Row& to) const {
            const auto weights = lines_z_[j];
            across(nx_, weights, south.h.data(), here.h.data(), north.h.data(), to.h.data());
            across(nx_, weights, south.level.data(), here.level.data(), north.level.data(), to.level.data());
            across(nx_, weights, south.u.data(), here.u.data(), north.u.data(), to.u.data());
            across(nx_, weights, south.w.data(), here.w.data(), north.w.data(), to.w.data());
        }
        static void across(std::size_t count, const detail::LineWeights<Scalar> weights, const Scalar* __restrict from,
                           const Scalar* __restrict here, const Scalar* __restrict to, Scalar* __restrict half) {
            for (std::size_t i = 0; i < count; ++i) half[i] = weights.half(from[i], here[i], to[i]);
        }
        void slopes_x() {
            along(lines_x_, here_.h, Scalar(1), x_.h);
            along(lines_x_, here_.level, Scalar(1), x_.level);
            along(lines_x_, here_.u, Scalar(-1), x_.u); // the other way behind a wall
            along(lines_x_, here_.w, Scalar(1), x_.w);
        }
        static void along(const detail::LinesAlong<Scalar>& lines, const std::vector<Scalar>& q, const Scalar mirror,
                          std::vector<Scalar>& half) {
            const std::size_t e = q.size() - 1;
            half[0] = lines[0].half(mirror * q[0], q[0], q[1]);
            within(e, lines.before.data(), lines.after.data(), lines.most_before.data(), lines.most_after.data(),
                   q.data(), half.data());
            half[e] = lines[e].half(q[e - 1], q[e], mirror * q[e]);
        }
        static void within(std::size_t last, const Scalar* __restrict before, const Scalar* __restrict after,
                           const Scalar* __restrict most_before, const Scalar* __restrict most_after,
                           const Scalar* __restrict q, Scalar* __restrict half) {
            for (std::size_t i = 1; i < last; ++i) {
                const detail::LineWeights<Scalar> weights{before[i], after[i], most_before[i], most_after[i]};
                half[i] = weights.half(q[i - 1], q[i], q[i + 1]);
            }
        }
        void through(std::size_t count, const Lines& low, const Lines& high, Faces& faces) const {
            fill(count, gravity_, low, high, faces.mass.data(), faces.push_low.data(), faces.push_high.data(),
                 faces.along.data());
        }
        // Nothing that is written here overlaps: said of parameters, since compilers trust no others.
        static void fill(std::size_t count, const Scalar g, const Lines low, const Lines high, Scalar* __restrict mass,
                         Scalar* __restrict push_low, Scalar* __restrict push_high, Scalar* __restrict along) {
            for (std::size_t i = 0; i < count; ++i) {
                const auto flux = detail::hll<Scalar>(low.template at<1>(i, g), high.template at<-1>(i, g), g);
                mass[i] = flux.mass;
                push_low[i] = flux.push_low;
                push_high[i] = flux.push_high;
                along[i] = flux.along;
            }
        }
        /// A solid wall along the row, ahead of it or behind: nothing passes.
        template <int Way> void wall(const Row& row, const Row& to, Faces& faces) const {
            const auto lines = lines_along_z(row, to);
            for (std::size_t i = 0; i < nx_; ++i) {
                faces.mass[i] = faces.along[i] = Scalar(0);
                faces.push_low[i] = faces.push_high[i] = lines.template at<Way>(i, gravity_).at_wall(Scalar(Way));
            }
        }
        /// A row after the step, from its four faces: heights, then both momenta.
        template <bool Last>
        void apply(const State<Scalar>& from, State<Scalar>& to, std::size_t j, Scalar dt, Scalar weight) {
            const std::size_t n = j * nx_;
            const Scalar by_z = dt * over_z_[j], zero(0), *const over = over_x_.data();
            const Faces &x = along_x_, &s = south_face_, &t = north_face_;
            raise<Last>(nx_, dt, by_z, weight, over, x.mass.data(), s.mass.data(), t.mass.data(), here_.h.data(),
                        &to.height[n], compensated ? &from.owed[n] : nullptr, compensated ? &to.owed[n] : nullptr);
            const Scalar wall = lines_along_x(here_, x_, 0).template at<-1>(0, gravity_).at_wall(Scalar(-1));
            const Scalar *h = here_.h.data(), *u = here_.u.data(), *w = here_.w.data(), g2 = Scalar(2) * gravity_;
            carry<Last, true>(nx_, {dt, by_z, weight, g2, wall}, over, x.push_high.data(), x.push_low.data(),
                              s.along.data(), t.along.data(), x_.level.data(), h, u, &to.momentum_x[n]);
            carry<Last, false>(nx_, {dt, by_z, weight, g2, zero}, over, x.along.data(), x.along.data(),
                               s.push_high.data(), t.push_low.data(), z_.level.data(), h, w, &to.momentum_z[n]);
        }
        template <bool Last>
        static void raise(std::size_t count, Scalar dt, Scalar by_z, Scalar weight, const Scalar* __restrict over,
                          const Scalar* __restrict mass, const Scalar* __restrict south, const Scalar* __restrict north,
                          const Scalar* __restrict before, Scalar* __restrict height, const Scalar* __restrict owed,
                          Scalar* __restrict owes) {
            auto one = [=](std::size_t i, const Scalar& west) __attribute__((always_inline)) {
                const Scalar more = dt * over[i] * (west - mass[i]) + by_z * (south[i] - north[i]);
                if constexpr (compensated) {
                    double sum = double(before[i]) + double(owed[i]) + double(more);
                    if constexpr (Last)
                        sum = (1 - double(weight)) * (double(height[i]) + double(owes[i])) + double(weight) * sum;
                    const Scalar rounded(sum), there = Scalar(0.5) * (rounded + std::abs(rounded)); // as ShallowWater
                    owes[i] = Scalar(sum - double(there));
                    height[i] = there;
                } else if constexpr (Last) height[i] = (Scalar(1) - weight) * height[i] + weight * (before[i] + more);
                else height[i] = before[i] + more;
            };
            one(0, Scalar(0));
            for (std::size_t i = 1; i < count; ++i) one(i, mass[i - 1]);
        }
        struct Carry {
            Scalar dt, by_z, weight, g2, wall; // g2: twice g; wall: what that in the west gives
        };
        /// What each column gets from west and gives to east, gets from south and gives to north, and the weight of its
        /// slope, along x or along z.
        template <bool Last, bool AlongX>
        static void carry(std::size_t count, const Carry by, const Scalar* __restrict over,
                          const Scalar* __restrict west, const Scalar* __restrict east, const Scalar* __restrict south,
                          const Scalar* __restrict north, const Scalar* __restrict slope, const Scalar* __restrict h,
                          const Scalar* __restrict speed, Scalar* __restrict momentum) {
            auto one = [=](std::size_t i, const Scalar& in) __attribute__((always_inline)) {
                const Scalar weight_of_slope = by.g2 * h[i] * slope[i], x = in - east[i], z = south[i] - north[i];
                const Scalar more = AlongX ? by.dt * over[i] * (x - weight_of_slope) + by.by_z * z
                                           : by.dt * over[i] * x + by.by_z * (z - weight_of_slope);
                const Scalar after = h[i] * speed[i] + more;
                momentum[i] = Last ? (Scalar(1) - by.weight) * momentum[i] + by.weight * after : after;
            };
            one(0, by.wall);
            for (std::size_t i = 1; i < count; ++i) one(i, west[i - 1]);
        }
        Scalar gravity_;
        Scalar film_ = detail::thinnest_water<Scalar>(); // m
        std::size_t nx_, nz_;
        detail::LinesAlong<Scalar> lines_x_, lines_z_;
        std::vector<Scalar> over_x_, over_z_; // 1 / width
        Row here_, next_, after_, mirror_;    // before the stage: this row and the two behind it; one behind a wall
        Row x_, z_, next_z_;                  // half of what changes within columns: along x, along z
        Faces along_x_, south_face_, north_face_;
        State<Scalar> ahead_; // a step of Euler ahead; it has no bed
    };
};

static_assert(SurfacePolicyIn<SecondOrderShallowWater, double> && SurfacePolicyIn<SecondOrderShallowWater, float>);

} // namespace ansatz
