// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `Waypoints`: places with coordinates, joined by roads; a graph of Boost.Graph that is searched by length or by time.
///
/// Take it where a designer sets the places, or where a navigation mesh has its portals. For tiles take `Grid`. A graph
/// of your own needs nothing of this: AStar takes any.
///
/// \par Which cost
/// `Waypoints<ByLength>` (the default) finds the shortest way, in metres; `Waypoints<ByTime>` the quickest, in seconds:
/// there every road has a speed.

#include <ansatz/paths/graph.hpp>
#include <ansatz/units.hpp>
#include <ansatz/units/requirements.hpp>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ansatz::paths {

struct Euclid;

struct ByLength {}; ///< a road costs its length, m
struct ByTime {};   ///< a road costs its length over its speed, s

/// A road from one place to another, as a graph's edge.
struct Road {
    /// The number of the place it leaves.
    std::size_t from = 0, number = 0; ///< its number among all roads
    friend bool operator==(const Road& a, const Road& b) { return a.number == b.number; }
};

/// Places and roads.
/// \tparam Measure `ByLength` or `ByTime`
/// \tparam Dim     2 or 3
template <class Measure = ByLength, int Dim = 3> class Waypoints {
    static constexpr bool timed = std::is_same_v<Measure, ByTime>;

public:
    using default_heuristic = Euclid;
    using Place = VectorQuantity<unit::Length, Dim>; ///< coordinates, m
    using Length = Quantity<unit::Length>;           ///< m
    using Speed = Quantity<unit::Velocity>;          ///< m/s

    /// A place.
    /// \return its number, from 0
    /// \throws std::invalid_argument for coordinates that are not finite
    std::size_t add(const Place& at) {
        require_finite("Waypoints::add", "the place", at);
        places_.push_back({at, true, {}});
        return places_.size() - 1;
    }
    /// A road in one direction, as long as its ends are apart.
    /// \return its number
    template <class M = Measure>
        requires std::is_same_v<M, ByLength>
    std::size_t connect(std::size_t from, std::size_t to) {
        require_places("Waypoints::connect", from, to);
        return put(from, to, apart(from, to), Speed::from_value(1));
    }
    /// The same with a length of its own: a winding road.
    /// \throws std::invalid_argument unless the length is finite and not less than the ends are apart, or every
    /// estimate
    ///         of the straight distance would be too much
    template <class M = Measure>
        requires std::is_same_v<M, ByLength>
    std::size_t connect(std::size_t from, std::size_t to, Length length) {
        require_places("Waypoints::connect", from, to);
        require_length("Waypoints::connect", from, to, length);
        return put(from, to, length, Speed::from_value(1));
    }
    /// A road with a speed.
    /// \throws std::invalid_argument unless the speed is finite and greater than zero
    template <class M = Measure>
        requires std::is_same_v<M, ByTime>
    std::size_t connect(std::size_t from, std::size_t to, Speed speed) {
        require_places("Waypoints::connect", from, to);
        require_positive("Waypoints::connect", "the speed", speed);
        return put(from, to, apart(from, to), speed);
    }
    /// The same with a length of its own.
    template <class M = Measure>
        requires std::is_same_v<M, ByTime>
    std::size_t connect(std::size_t from, std::size_t to, Length length, Speed speed) {
        require_places("Waypoints::connect", from, to);
        require_length("Waypoints::connect", from, to, length);
        require_positive("Waypoints::connect", "the speed", speed);
        return put(from, to, length, speed);
    }
    /// Roads in both directions, by the arguments of connect.
    template <class... Arguments> void connect_both(std::size_t a, std::size_t b, const Arguments&... arguments) {
        connect(a, b, arguments...);
        connect(b, a, arguments...);
    }

    /// \name Changes in place
    /// @{
    /// Blocks a place, or frees it.
    /// \throws std::invalid_argument for a place that there is not
    void set_passable(std::size_t place, bool free) {
        require_place("Waypoints::set_passable", place);
        if (places_[place].free != free) changed(free);
        places_[place].free = free;
    }
    /// Blocks a road, or frees it.
    /// \throws std::invalid_argument for a road that there is not
    void set_road_passable(std::size_t road, bool free) {
        require_road("Waypoints::set_road_passable", road);
        if (roads_[road].free != free) changed(free);
        roads_[road].free = free;
    }
    /// How long a road is.
    /// \throws std::invalid_argument unless the length is finite and not less than its ends are apart
    void set_length(std::size_t road, Length length) {
        require_road("Waypoints::set_length", road);
        require_length("Waypoints::set_length", roads_[road].from, roads_[road].to, length);
        const double old = roads_[road].cost;
        roads_[road].length = length;
        measure(road, old);
    }
    /// How fast one goes on a road.
    /// \throws std::invalid_argument unless the speed is finite and greater than zero
    template <class M = Measure>
        requires std::is_same_v<M, ByTime>
    void set_speed(std::size_t road, Speed speed) {
        require_road("Waypoints::set_speed", road);
        require_positive("Waypoints::set_speed", "the speed", speed);
        const double old = roads_[road].cost;
        roads_[road].speed = speed;
        if (speed > fastest_) fastest_ = speed;
        measure(road, old);
    }
    /// @}

    std::size_t size() const { return places_.size(); } ///< how many places
    std::size_t roads() const { return roads_.size(); } ///< how many roads
    /// Whether there is this place and it is free.
    bool passable(std::size_t place) const { return place < size() && places_[place].free; }
    /// Whether a road is free.
    bool road_passable(std::size_t road) const { return roads_[road].free; }
    /// Where a place is, m.
    const Place& position(std::size_t place) const { return places_[place].at; }
    /// The place that a road leads to.
    std::size_t end_of(std::size_t road) const { return roads_[road].to; }
    double cost_of(std::size_t road) const { return roads_[road].cost; } ///< m or s, by the measure
    /// The roads that leave a place, by their numbers.
    std::span<const std::size_t> roads_from(std::size_t place) const { return places_[place].roads; }
    Speed fastest() const { return fastest_; } ///< the highest speed that a road ever had

    Length length(std::span<const std::size_t> path) const { ///< of the cheapest roads between these places
        return Length::from_value(sum(path, [](const Kept& r) { return r.length.value(); }));
    }
    /// How long the quickest roads between these places take, each at its own speed.
    Quantity<unit::Time> travel_time(std::span<const std::size_t> path) const
        requires std::is_same_v<Measure, ByTime>
    {
        return Quantity<unit::Time>::from_value(sum(path, [](const Kept& r) { return r.cost; }));
    }
    /// How long the shortest roads between these places take at this speed.
    /// \throws std::invalid_argument unless the speed is finite and greater than zero
    Quantity<unit::Time> travel_time(std::span<const std::size_t> path, Speed speed) const
        requires std::is_same_v<Measure, ByLength>
    {
        require_positive("Waypoints::travel_time", "the speed", speed);
        return length(path) / speed;
    }
    std::size_t version() const { return version_; }         ///< grows with every change
    std::size_t cheaper_version() const { return cheaper_; } ///< grows when something is freed or gets cheaper

private:
    struct Spot {
        Place at;
        bool free = true;
        std::vector<std::size_t> roads; ///< that leave it
    };
    struct Kept {
        std::size_t from, to;
        Length length;
        Speed speed;
        bool free = true;
        double cost = 0; ///< what the search sees
    };
    void require_place(const char* where, std::size_t place) const {
        if (place >= size())
            refuse_value(where, "the place", std::to_string(place),
                         "there are " + std::to_string(size()) + " places, numbered from 0");
    }
    void require_places(const char* where, std::size_t from, std::size_t to) const {
        require_place(where, from);
        require_place(where, to);
    }
    void require_road(const char* where, std::size_t road) const {
        if (road >= roads_.size())
            refuse_value(where, "the road", std::to_string(road),
                         "there are " + std::to_string(roads_.size()) + " roads, numbered from 0");
    }
    void require_length(const char* where, std::size_t from, std::size_t to, Length length) const {
        if (!is_finite(length) || length.value() < apart(from, to).value() * (1 - 1e-12))
            refuse_value(where, "the length from place " + std::to_string(from) + " to " + std::to_string(to), length,
                         "it must be finite and at least the straight distance, " + describe(apart(from, to)));
    }
    Length apart(std::size_t a, std::size_t b) const {
        return Length::from_value((places_[b].at - places_[a].at).value().norm());
    }
    std::size_t put(std::size_t from, std::size_t to, Length length, Speed speed) {
        roads_.push_back({from, to, length, speed, true, 0});
        places_[from].roads.push_back(roads_.size() - 1);
        if (roads_.size() == 1 || speed > fastest_) fastest_ = speed;
        measure(roads_.size() - 1, detail::infinite<double>);
        return roads_.size() - 1;
    }
    void measure(std::size_t road, double old) {
        Kept& r = roads_[road];
        r.cost = timed ? r.length.value() / r.speed.value() : r.length.value();
        if (r.cost != old) changed(r.cost < old);
    }
    void changed(bool cheaper) {
        ++version_;
        if (cheaper) ++cheaper_;
    }
    template <class Value> double sum(std::span<const std::size_t> path, Value&& value) const {
        double all = 0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Kept* best = nullptr;
            for (const std::size_t road : places_[path[i - 1]].roads)
                if (roads_[road].to == path[i] && roads_[road].free && (!best || roads_[road].cost < best->cost))
                    best = &roads_[road];
            if (!best)
                refuse_value("Waypoints", "the step", std::to_string(path[i - 1]) + " to " + std::to_string(path[i]),
                             "no road leads there");
            all += value(*best);
        }
        return all;
    }
    std::vector<Spot> places_;
    std::vector<Kept> roads_;
    Speed fastest_ = Speed::from_value(1);
    std::size_t version_ = 0, cheaper_ = 0;
};

/// The roads that leave a place, one after the other.
class RoadsOut {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = Road;
    using difference_type = std::ptrdiff_t;
    using pointer = const Road*;
    using reference = Road;
    RoadsOut() = default;
    /// At one of the roads that leave this place.
    RoadsOut(std::size_t from, const std::size_t* at) : from_(from), at_(at) {}
    Road operator*() const { return {from_, *at_}; }
    RoadsOut& operator++() {
        ++at_;
        return *this;
    }
    RoadsOut operator++(int) {
        auto old = *this;
        ++at_;
        return old;
    }
    friend bool operator==(const RoadsOut& a, const RoadsOut& b) { return a.at_ == b.at_; }

private:
    std::size_t from_ = 0;
    const std::size_t* at_ = nullptr;
};
/// The numbers of places, which are the places themselves, as an iterator.
class PlaceNumbers {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::size_t*;
    using reference = std::size_t;
    PlaceNumbers() = default;
    /// At this number.
    explicit PlaceNumbers(std::size_t at) : at_(at) {}
    /// The number itself.
    std::size_t operator*() const { return at_; }
    PlaceNumbers& operator++() {
        ++at_;
        return *this;
    }
    PlaceNumbers operator++(int) { return PlaceNumbers(at_++); }
    friend bool operator==(const PlaceNumbers& a, const PlaceNumbers& b) { return a.at_ == b.at_; }

private:
    std::size_t at_ = 0;
};
/// What a road costs, as a property map.
template <class M, int D> struct RoadCosts {
    using key_type = Road;
    using value_type = double;
    using reference = double;
    using category = boost::readable_property_map_tag;
    const Waypoints<M, D>* graph; ///< whose roads
    friend double get(const RoadCosts& map, const Road& r) { return map.graph->cost_of(r.number); }
};

template <class M, int D> std::pair<RoadsOut, RoadsOut> out_edges(std::size_t v, const Waypoints<M, D>& g) {
    const auto roads = g.roads_from(v);
    return {RoadsOut(v, roads.data()), RoadsOut(v, roads.data() + roads.size())};
}
template <class M, int D> std::size_t out_degree(std::size_t v, const Waypoints<M, D>& g) {
    return g.roads_from(v).size();
}
template <class M, int D> std::size_t source(const Road& r, const Waypoints<M, D>&) { return r.from; }
template <class M, int D> std::size_t target(const Road& r, const Waypoints<M, D>& g) { return g.end_of(r.number); }
template <class M, int D> std::pair<PlaceNumbers, PlaceNumbers> vertices(const Waypoints<M, D>& g) {
    return {PlaceNumbers(0), PlaceNumbers(g.size())};
}
template <class M, int D> std::size_t num_vertices(const Waypoints<M, D>& g) { return g.size(); }
template <class M, int D> auto get(boost::vertex_index_t, const Waypoints<M, D>&) {
    return boost::typed_identity_property_map<std::size_t>();
}
template <class M, int D> RoadCosts<M, D> get(boost::edge_weight_t, const Waypoints<M, D>& g) { return {&g}; }
template <class M, int D> std::size_t get(boost::vertex_index_t, const Waypoints<M, D>&, std::size_t v) { return v; }
template <class M, int D> double get(boost::edge_weight_t, const Waypoints<M, D>& g, const Road& r) {
    return g.cost_of(r.number);
}
template <class M, int D> bool is_passable(std::size_t v, const Waypoints<M, D>& g) { return g.passable(v); }
template <class M, int D> bool is_passable(const Road& r, const Waypoints<M, D>& g) {
    return g.road_passable(r.number);
}
template <class M, int D> const auto& position_of(std::size_t v, const Waypoints<M, D>& g) { return g.position(v); }
/// "3 s" or "25 m".
template <class Cost, class M, int D> std::string cost_in_words(Cost cost, const Waypoints<M, D>&) {
    return std::is_same_v<M, ByTime> ? describe(double(cost) * second) : describe(double(cost) * metre);
}
template <class M, int D> double least_cost_per_metre(const Waypoints<M, D>& g) {
    return std::is_same_v<M, ByTime> ? 1 / g.fastest().value() : 1;
}

} // namespace ansatz::paths

#include <ansatz/paths/heuristics/euclid.hpp>

namespace boost {
template <class M, int D> struct graph_traits<ansatz::paths::Waypoints<M, D>> {
    struct traversal_category
        : virtual incidence_graph_tag
        , virtual vertex_list_graph_tag {};
    using vertex_descriptor = std::size_t;
    using edge_descriptor = ansatz::paths::Road;
    using out_edge_iterator = ansatz::paths::RoadsOut;
    using vertex_iterator = ansatz::paths::PlaceNumbers;
    using directed_category = directed_tag;
    using edge_parallel_category = allow_parallel_edge_tag;
    using vertices_size_type = std::size_t;
    using edges_size_type = std::size_t;
    using degree_size_type = std::size_t;
    using adjacency_iterator = void;
    using in_edge_iterator = void;
    using edge_iterator = void;
    static vertex_descriptor null_vertex() { return std::size_t(-1); }
};
template <class M, int D> struct property_map<ansatz::paths::Waypoints<M, D>, vertex_index_t> {
    using type = typed_identity_property_map<std::size_t>;
    using const_type = type;
};
template <class M, int D> struct property_map<ansatz::paths::Waypoints<M, D>, edge_weight_t> {
    using type = ansatz::paths::RoadCosts<M, D>;
    using const_type = type;
};
} // namespace boost
