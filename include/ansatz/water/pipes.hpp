// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Pipes`: columns that are joined through their faces, each face with a flow of its own (notes 7.2; the virtual pipes
/// of O'Brien and Hodgins).
///
/// Use it over any bed: shores, islands, a basin that is filled, a ford that falls dry. The waves are those of
/// WaterColumns, faster where the water is deep; a flow ends where its column would run dry, so that no height is ever
/// negative and no water is lost. The flow is the water's velocity along the surface, which drag and drift want. Not
/// for a torrent: flows do not carry their own momentum along, so that there are no shocks and no hydraulic jumps;
/// ShallowWater has them.
///
/// \f[ \dot Q = g\,w\,d\,\frac{\eta_{here} - \eta_{there}}{s} - \gamma Q, \qquad \dot h = \frac{\sum Q_{in} - \sum Q_{out}}{\Delta x\,\Delta z} \f]
///
/// | symbol   | meaning                                                                      | unit  |
/// |----------|------------------------------------------------------------------------------|-------|
/// | eta      | level, b + h: bed and height                                                 | m     |
/// | Q        | flow through a face, positive along x or z                                   | m^3/s |
/// | w, s     | width of the face, distance of the two centres                               | m     |
/// | d        | depth at the face: the higher level over the higher bed; 0 lets nothing pass | m     |
/// | gamma    | damping                                                                      | 1/s   |
///
/// A flow is held to what the depth at its face carries over one column in a step.
/// All sides are solid walls. The step is stable while \f$ \sqrt{g\,h_{max}}\,\Delta t \sqrt{1/\Delta x^2 + 1/\Delta z^2} \le 1 \f$.
///
/// J. O'Brien, J. Hodgins, Dynamic Simulation of Splashing Fluids (1995); X. Mei, P. Decaudin, B. Hu, Fast Hydraulic
/// Erosion Simulation and Visualization on GPU (2007), for the limit.

#include <ansatz/water/water_columns.hpp>

namespace ansatz {

/// Columns joined by pipes. Its parameters are read when the Surface is made.
struct Pipes {
    Quantity<unit::Acceleration> gravity = 9.81 * metre_per_second_squared; ///< g, m/s^2, finite, positive
    Quantity<unit::Frequency> damping{};                                    ///< gamma, 1/s, finite, not negative

    static constexpr std::string_view name = "Pipes"; ///< for sentences
    static constexpr bool has_bed = true;             ///< any bed
    /// \throws std::invalid_argument for parameters that it cannot have
    void check() const {
        require_positive(name, "gravity", gravity);
        require_not_negative(name, "damping", damping);
    }
    /// Its parameters, by name, as a world saves them with its pools: gravity is the world's.
    static void fields(auto& self, auto&& field) { field("damping", self.damping); }

    /// What is kept for each column.
    template <class Scalar> struct State {
        std::vector<Scalar> height; ///< m
        std::vector<Scalar> bed;    ///< m
        std::vector<Scalar> flow_x; ///< through the face to the next column along x, m^3/s; the last is a wall
        std::vector<Scalar> flow_z; ///< through the face to the next column along z, m^3/s; the last is a wall
        /// Its fields, by name.
        static void fields(auto& self, auto&& field) {
            field("height", self.height);
            field("bed", self.bed);
            field("flow_x", self.flow_x);
            field("flow_z", self.flow_z);
        }
        friend bool operator==(const State&, const State&) = default; ///< the same values
    };

    /// The loops by themselves. They check nothing.
    template <class Scalar> class In {
    public:
        using Time = Quantity<unit::Time>; ///< s
        /// The level is not used.
        In(const Pipes& policy, const ColumnGrid& grid, Quantity<unit::Length>)
            : gravity_(policy.gravity.value()),
              damping_(policy.damping.value()),
              nx_(grid.columns_x()),
              nz_(grid.columns_z()),
              part_(grid.size(), Scalar(1)) {
            const detail::ColumnAxis &x = grid.x(), &z = grid.z();
            fastest_ = detail::Pulls<double>(x, Wall::reflects, Wall::reflects).largest +
                       detail::Pulls<double>(z, Wall::reflects, Wall::reflects).largest;
            auto lanes = [](const detail::ColumnAxis& axis, std::vector<Scalar>& width, std::vector<Scalar>& over,
                            std::vector<Scalar>& way) {
                for (std::size_t i = 0; i < axis.count(); ++i) {
                    width.push_back(Scalar(axis.width(i)));
                    way.push_back(Scalar(i + 1 < axis.count() ? axis.distance(i) : 1.0));
                    over.push_back(Scalar(1) / way.back());
                }
            };
            lanes(x, width_x_, over_x_, way_x_);
            lanes(z, width_z_, over_z_, way_z_);
        }
        /// A level bed, and no flow.
        void prepare(State<Scalar>& state, Quantity<unit::Length>) const {
            for (auto* lane : {&state.bed, &state.flow_x, &state.flow_z}) lane->assign(state.height.size(), Scalar(0));
        }
        /// Courant's limit for the deepest column, s; infinite where all is dry.
        Time longest_step(const State<Scalar>& state) const {
            Scalar deepest(0);
            for (const Scalar& h : state.height) deepest = deepest < h ? h : deepest;
            return 2 / std::sqrt(gravity_ * static_cast<double>(deepest) * fastest_) * second;
        }
        /// Flows, their limit, heights.
        void advance(State<Scalar>& state, Time dt) {
            const Scalar pull(gravity_ * dt.value()), keep(std::exp(-damping_ * dt.value())), h(dt.value());
            for (std::size_t j = 0; j < nz_; ++j) {
                const std::size_t n = j * nx_, next = j + 1 < nz_ ? nx_ : 0;
                const Scalar *height = &state.height[n], *bed = &state.bed[n];
                along_x(nx_ - 1, {pull * width_z_[j], width_z_[j] / h, keep}, height, bed, over_x_.data(),
                        way_x_.data(), &state.flow_x[n]);
                if (next)
                    along_z(nx_, {pull * over_z_[j], way_z_[j] / h, keep}, height, bed, height + nx_, bed + nx_,
                            width_x_.data(), &state.flow_z[n]);
            }
            each_row(state, [&](std::size_t j, const Scalar* west, const Scalar* south, const Scalar* north) {
                const std::size_t n = j * nx_;
                give(nx_, h / width_z_[j], width_x_.data(), &state.height[n], west, south, north, &part_[n]);
            });
            for (std::size_t j = 0; j < nz_; ++j) {
                const std::size_t n = j * nx_;
                limit(nx_ - 1, &part_[n], &part_[n + 1], &state.flow_x[n]);
                if (j + 1 < nz_) limit(nx_, &part_[n], &part_[n + nx_], &state.flow_z[n]);
            }
            each_row(state, [&](std::size_t j, const Scalar* west, const Scalar* south, const Scalar* north) {
                raise(nx_, h / width_z_[j], width_x_.data(), west, south, north, &state.height[j * nx_]);
            });
        }
        /// How fast the water of a column flows, m/s: the mean of its faces, each with the higher column of the two;
        /// zero where it is dry.
        Vector<Scalar, 2> velocity(const State<Scalar>& state, std::size_t i, std::size_t j) const {
            const std::size_t n = j * nx_ + i;
            const Scalar h = state.height[n], half(0.5);
            if (!(h > Scalar(0))) return {Scalar(0), Scalar(0)};
            auto through = [&](const Scalar& flow, const Scalar& other) { return flow / (h < other ? other : h); };
            Scalar along_x(0), along_z(0);
            if (i > 0) along_x += through(state.flow_x[n - 1], state.height[n - 1]);
            if (i + 1 < nx_) along_x += through(state.flow_x[n], state.height[n + 1]);
            if (j > 0) along_z += through(state.flow_z[n - nx_], state.height[n - nx_]);
            if (j + 1 < nz_) along_z += through(state.flow_z[n], state.height[n + nx_]);
            return {half * along_x / width_z_[j], half * along_z / width_x_[i]};
        }

    private:
        struct Push {
            Scalar strength, reach, keep; // of the row: g dt times width or over the way, width or way over dt, damping
        };
        /// Depth at a face, and from it the flow: what ran before plus what the levels push.
        [[gnu::always_inline]] static Scalar pushed(const Scalar& flow, const Scalar& strength, const Scalar& keep,
                                                    const Scalar& reach, const Scalar& h, const Scalar& b,
                                                    const Scalar& h2, const Scalar& b2) {
            const Scalar level = b + h, level2 = b2 + h2, zero(0);
            const Scalar top = level < level2 ? level2 : level, sill = b < b2 ? b2 : b, depth = top - sill;
            const Scalar new_flow = (flow + strength * depth * (level - level2)) * keep;
            const Scalar most = depth > zero ? reach * depth : zero; // no water passes a whole column in a step
            const Scalar not_above = most < new_flow ? most : new_flow;
            return not_above < -most ? -most : not_above;
        }
        static void along_x(std::size_t count, Push by, const Scalar* __restrict h, const Scalar* __restrict b,
                            const Scalar* __restrict over, const Scalar* __restrict way, Scalar* __restrict flow) {
            for (std::size_t i = 0; i < count; ++i)
                flow[i] =
                    pushed(flow[i], by.strength * over[i], by.keep, by.reach * way[i], h[i], b[i], h[i + 1], b[i + 1]);
        }
        static void along_z(std::size_t count, Push by, const Scalar* __restrict h, const Scalar* __restrict b,
                            const Scalar* __restrict h2, const Scalar* __restrict b2, const Scalar* __restrict width,
                            Scalar* __restrict flow) {
            for (std::size_t i = 0; i < count; ++i)
                flow[i] =
                    pushed(flow[i], by.strength * width[i], by.keep, by.reach * width[i], h[i], b[i], h2[i], b2[i]);
        }
        /// Calls f(j, flows along x, flows into the row from south, out of it to north).
        template <class F> void each_row(State<Scalar>& state, F&& f) {
            if (none_.empty()) none_.assign(nx_, Scalar(0));
            for (std::size_t j = 0; j < nz_; ++j)
                f(j, &state.flow_x[j * nx_], j > 0 ? &state.flow_z[(j - 1) * nx_] : none_.data(),
                  &state.flow_z[j * nx_]);
        }
        /// Which fraction of what wants to leave a column may: all, unless it would run dry.
        static void give(std::size_t count, Scalar over_width, const Scalar* __restrict width_x,
                         const Scalar* __restrict height, const Scalar* __restrict flow_x,
                         const Scalar* __restrict south, const Scalar* __restrict north, Scalar* __restrict part) {
            // A hair less than all of it, so that rounding cannot make a height negative.
            const Scalar zero(0), one(1), all = one - Scalar(16) * std::numeric_limits<Scalar>::epsilon(),
                                          least = std::numeric_limits<Scalar>::min();
            auto column = [&](std::size_t i, const Scalar& west) {
                const Scalar east = flow_x[i], in_z = south[i], out_z = north[i];
                const Scalar out = ((east > zero ? east : zero) + (west < zero ? -west : zero)) +
                                   ((out_z > zero ? out_z : zero) + (in_z < zero ? -in_z : zero));
                const Scalar wanted = over_width * out / width_x[i] + least, share = all * height[i] / wanted;
                part[i] = share < one ? share : one;
            };
            column(0, zero);
            for (std::size_t i = 1; i < count; ++i) column(i, flow_x[i - 1]);
        }
        static void limit(std::size_t count, const Scalar* __restrict here, const Scalar* __restrict there,
                          Scalar* __restrict flow) {
            for (std::size_t i = 0; i < count; ++i) flow[i] *= flow[i] > Scalar(0) ? here[i] : there[i];
        }
        static void raise(std::size_t count, Scalar over_width, const Scalar* __restrict width_x,
                          const Scalar* __restrict flow_x, const Scalar* __restrict south,
                          const Scalar* __restrict north, Scalar* __restrict height) {
            height[0] += over_width * ((south[0] - north[0]) - flow_x[0]) / width_x[0];
            for (std::size_t i = 1; i < count; ++i)
                height[i] += over_width * ((flow_x[i - 1] - flow_x[i]) + (south[i] - north[i])) / width_x[i];
        }
        double gravity_, damping_, fastest_ = 0;
        std::size_t nx_, nz_;
        std::vector<Scalar> width_x_, width_z_;               // of columns
        std::vector<Scalar> way_x_, way_z_, over_x_, over_z_; // to the next centre, and 1 over it
        std::vector<Scalar> part_, none_;                     // scratch
    };
};

static_assert(SurfacePolicyIn<Pipes, double> && SurfacePolicyIn<Pipes, float>);

} // namespace ansatz
