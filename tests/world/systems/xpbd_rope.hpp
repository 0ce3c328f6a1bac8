// SPDX-License-Identifier: BSL-1.0
// A policy outside the library, against the public frame only: a rope that XPBD holds (Macklin et al. 2016), in
// substeps that it drives itself. It keeps a table of links, a column of its own, and takes part in the step at four
// phases.
#pragma once

#include <ansatz/world.hpp>

namespace examples {

using namespace ansatz;

struct PlaceBefore {
    using Unit = unit::Length;
    static constexpr Shape shape = Shape::vector;
    static constexpr std::string_view name = "place before";
};

//! [rope]
struct Link { // what world.add takes
    using element = Link;
    Handle first, second;
    Parameter<unit::Length> length = 1.0 * metre;
};
template <class S> struct LinkRow { // what is kept of it
    BodyId first, second;
    typename S::Length length{};
    static void fields(auto& self, auto&& field) {
        field("first", self.first);
        field("second", self.second);
        field("length", self.length);
    }
    static LinkRow from(const auto& asked, const Link& link) {
        return {asked.body(link.first), asked.body(link.second), S::convert("length", link.length)};
    }
};

struct XpbdRope {
    using role = roles::System;
    using Element = Link;
    static constexpr std::string_view name = "XpbdRope";
    int substeps = 10;
    static void parameters(auto& self, auto&& visit) { visit("substeps", self.substeps); }

    template <class S> using State = ElementTable<S, Link, LinkRow<S>>;
    template <class S> struct Substeps {
        static constexpr Phase phase = phases::substeps, until = phases::fields;
        static constexpr std::string_view name = "rope: substeps";
        int n;
        explicit Substeps(const XpbdRope& rope) : n(rope.substeps) {}
        void run(auto&, const auto& dt, auto& part) const {
            const typename S::Time h = dt / typename S::Scalar(n);
            for (int i = 1; i < n; ++i) part(h);
            part.last(h);
        }
    };
    template <class S> struct Remember {
        static constexpr Phase phase = between(phases::substeps, phases::forces);
        static constexpr std::string_view name = "rope: remember";
        using writes = Columns<PlaceBefore>;
        using reads = Columns<Position>;
        explicit Remember(const XpbdRope&) {}
        void apply(auto& before, const auto& x, const auto&) const { before = x; }
    };
    template <class S> struct Solve {
        static constexpr Phase phase = phases::positions;
        static constexpr std::string_view name = "rope: solve";
        using writes = Columns<Position>;
        using reads = Columns<InverseMass>;
        explicit Solve(const XpbdRope&) {}
        void run(auto& view, const auto&) const {
            view.state().for_each([&](std::uint32_t, const auto& link) {
                const auto a = view.slot(link.first), b = view.slot(link.second);
                const auto wa = view.template get<InverseMass>(a), wb = view.template get<InverseMass>(b);
                const auto xa = view.template get<Position>(a), xb = view.template get<Position>(b);
                const auto apart = norm(xb - xa);
                if (!(apart > link.length)) return; // a rope only pulls
                const auto way = ((apart - link.length) / (apart * (wa + wb))) * (xb - xa);
                if (wa.value() > 0) view.template set<Position>(a, xa + wa * way);
                if (wb.value() > 0) view.template set<Position>(b, xb - wb * way);
            });
        }
    };
    template <class S> struct Velocities {
        static constexpr Phase phase = between(phases::positions, phases::fields);
        static constexpr std::string_view name = "rope: velocities";
        using writes = Columns<Velocity>;
        using reads = Columns<Position, PlaceBefore>;
        explicit Velocities(const XpbdRope&) {}
        void apply(auto& v, const auto& x, const auto& before, const auto& context) const {
            v = (x - before) / context.dt();
        }
    };
    template <class S> using systems = Types<Substeps<S>, Remember<S>, Solve<S>, Velocities<S>>;
};
//! [rope]

} // namespace examples
