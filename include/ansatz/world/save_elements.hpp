// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the elements of a world (springs) are written to a file and read from it: a part of save.hpp.
// not in the umbrella: it is a part of save.hpp, and needs nlohmann-json

#include <ansatz/world/data.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/file_value.hpp>
#include <ansatz/world/save_parameters.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ansatz {

namespace detail {
/// Whether a state keeps rows with fields (element_table.hpp).
template <class State> inline constexpr bool is_element_table = requires { typename State::Row_; };
} // namespace detail

/// The one that may read what a policy keeps, to save and load it.
struct ElementArchive {
    /// What a policy keeps beside the bodies: its elements by id.
    template <class C, class State> static void write(detail::Json& file, const State& state) {
        file["generations"] = state.ids_.generation_;
        file["free"] = state.ids_.free_;
        auto& list = file["list"] = detail::Json::array();
        state.for_each([&](std::uint32_t id, const auto& one) {
            detail::Json element;
            element["id"] = id;
            if constexpr (detail::is_element_table<State>)
                detail::write_fields<detail::Files>(element["row"] = detail::Json::object(), one);
            else write_link<C>(element, state, id, one);
            list.push_back(std::move(element));
        });
        if constexpr (detail::NamesFields<State>)
            detail::write_fields<detail::Files>(file["beside"] = detail::Json::object(), state);
    }
    /// The same from a file, into a state that is empty.
    /// \throws std::invalid_argument naming the place in the file
    template <class C, class State>
    static void read(State& state, const Bodies& bodies, const detail::FileValue& file) {
        const auto generations = file.at("generations");
        const auto ids = generations.size("generations");
        state.reserve(ids);
        for (std::size_t id = 0; id < ids; ++id) state.insert({});
        std::vector<char> listed(ids);
        const auto list = file.at("list");
        const auto count = list.size("elements");
        for (std::size_t i = 0; i < count; ++i) {
            const auto element = list.at(i);
            const auto id = std::uint32_t(element.at("id").whole(ids == 0 ? 0 : ids - 1));
            if (id >= ids || listed[id]) element.at("id").refuse_here("an id that no other element has");
            listed[id] = 1;
            if constexpr (detail::is_element_table<State>) read_row(state.rows_[id], bodies, element.at("row"));
            else read_link<C>(state, id, bodies, element);
        }
        const auto free = file.at("free");
        free.size_is(ids - count, "free ids");
        for (std::size_t i = 0; i < ids - count; ++i) {
            const auto id = std::uint32_t(free.at(i).whole(ids - 1));
            if (listed[id]) free.at(i).refuse_here("an id that no element and no other free place has");
            listed[id] = 1;
            state.erase(id);
        }
        for (std::size_t id = 0; id < ids; ++id)
            state.ids_.generation_[id] = std::uint32_t(generations.at(id).whole(0xffffffffu));
        if constexpr (detail::NamesFields<State>) detail::read_fields(state, file.at("beside"));
    }

private:
    static constexpr const char* a_body = "the id of a body that is in the file";

    /// Of a table: the fields of its row.
    template <class Row> static void read_row(Row& row, const Bodies& bodies, const detail::FileValue& file) {
        detail::read_fields(row, file);
        Row::fields(row, [&](std::string_view name, const auto& x) {
            detail::each_body_in(x, [&](std::uint32_t id) {
                if (id >= bodies.ids() || !bodies.alive(id)) file.at(std::string(name).c_str()).refuse_here(a_body);
            });
        });
    }
    /// Of a network: ends by the ids of bodies or as points, and its numbers.
    template <class C, class State>
    static void write_link(detail::Json& element, const State& state, std::uint32_t id, const auto& link) {
        element["first"] = link.a;
        if (link.b != State::no_body) element["second"] = link.b;
        else
            for (int k = 0; k < C::S::dimension; ++k)
                element["point"].push_back(detail::number_to_file(state.anchors_[id].value()[k]));
        State::numbers(state, id, [&](const char* name, const auto& number, NumberIn) {
            element[name] = detail::number_to_file(number);
        });
    }
    template <class C, class State>
    static void read_link(State& state, std::uint32_t id, const Bodies& bodies, const detail::FileValue& element) {
        using Scalar = typename C::S::Scalar;
        const auto body = [&](const detail::FileValue& given) {
            const auto n = given.whole(bodies.ids() == 0 ? 0 : bodies.ids() - 1);
            if (n >= bodies.ids() || !bodies.alive(std::uint32_t(n))) given.refuse_here(a_body);
            return std::uint32_t(n);
        };
        auto& link = state.links_[id];
        link.a = body(element.at("first"));
        if (element.json.contains("second")) {
            link.b = body(element.at("second"));
            if (link.b == link.a) element.at("second").refuse_here("another body than the first");
        } else {
            link.b = State::no_body;
            const auto point = element.at("point");
            point.size_is(std::size_t(C::S::dimension), "numbers");
            auto value = state.anchors_[id].value();
            for (int k = 0; k < C::S::dimension; ++k) value[k] = point.at(std::size_t(k)).template number<Scalar>();
            state.anchors_[id] = C::S::Position::from_value(value);
        }
        State::numbers(state, id, [&](const char* name, auto& number, NumberIn accepted) {
            const auto given = element.at(name);
            if (accepted == NumberIn::positive_or_infinite && given.json == "inf") {
                number = std::numeric_limits<Scalar>::infinity();
                return;
            }
            number = given.template number<Scalar>();
            if (accepted == NumberIn::not_negative ? number < Scalar(0) : !(number > Scalar(0)))
                given.refuse_here(accepted == NumberIn::not_negative ? "a number that is not negative"
                                                                     : "a number greater than 0, or \"inf\"");
        });
    }
};

} // namespace ansatz
