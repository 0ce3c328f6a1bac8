// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// How the shapes and contacts of a world are written to a file and read from it: what world/save.hpp is told.
///
/// What a response keeps of a contact that acts in the next step (the impulses of a warm start) is written beside it.
// not in the umbrella: it is a part of collision/module.hpp, which includes it; a program that saves includes the
// parser

#include <ansatz/collision/contact.hpp>
#include <ansatz/world/data.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/held_parameters.hpp>

#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ansatz {

/// The one that may read what a world holds of collisions, to save and load it.
struct CollisionArchive {
    /// Shapes by body, contacts by their two bodies.
    /// \tparam Files what writes a file (world/save.hpp)
    template <class C, class Files, class Data> static void write(typename Files::Json& file, const Data& data) {
        using Json = typename Files::Json;
        const auto& collisions = data.collisions;
        auto& shapes = file["shapes"] = Json::array();
        for (std::uint32_t id = 0; id < data.bodies.ids(); ++id) {
            if (!data.bodies.alive(id) || (!collisions.shapes.has(id) && !collisions.is_sensor(id))) continue;
            Json shape;
            shape["body"] = id;
            shape["sensor"] = collisions.is_sensor(id);
            collisions.shapes.visit_description(id, [&](const auto& description) {
                using Kind = std::remove_cvref_t<decltype(description)>;
                Files::parameters(shape[std::string(Kind::name)] = Json::object(), description);
            });
            if constexpr (C::rests) shape["pull"] = detail::field_to_file<Files>(collisions.pulls_[id]);
            shapes.push_back(std::move(shape));
        }
        if constexpr (C::rests) write_pulls_of_shapeless<C, Files>(file, data);
        auto& contacts = file["contacts"] = Json::array();
        for (const auto& c : collisions.contacts.all()) {
            Json one{{"first", c.first.id},
                     {"second", c.second.id},
                     {"steps", c.steps},
                     {"depth", Files::number(c.depth.value())}};
            for (int k = 0; k < C::S::dimension; ++k) {
                one["point"].push_back(Files::number(c.point.value()[k]));
                one["normal"].push_back(Files::number(c.normal[k]));
            }
            if (!collisions.lasts(data.bodies, c)) // it ends in the next step, which tells who they were
                one["generations"] = Json::array({c.first.generation, c.second.generation});
            contacts.push_back(std::move(one));
        }
        if constexpr (std::remove_cvref_t<decltype(collisions)>::divides) {
            auto& siblings = file["siblings"] = Json::array();
            collisions.siblings_.each([&](std::uint32_t id, std::uint32_t next) {
                siblings.push_back(Json{{"body", id}, {"next", next}});
            });
        }
        file["parts"] = collisions.parts;
        file["expected"] = Files::number(collisions.expected.value());
        file["stale"] = collisions.stale_;
        data.states.for_each([&](const auto& state) {
            if constexpr (requires { state.saved([](auto&&...) {}); }) {
                auto& list = file["acting"] = Json::array();
                state.saved([&](std::uint32_t a, std::uint32_t b, const auto& numbers) {
                    Json one{{"first", a}, {"second", b}, {"numbers", Json::array()}};
                    for (const auto& n : numbers) one["numbers"].push_back(Files::number(n));
                    list.push_back(std::move(one));
                });
            }
        });
    }

    /// \throws std::invalid_argument naming the place in the file
    template <class C, class Data, class File> static void read(Data& data, const File& file) {
        auto& collisions = data.collisions;
        if (data.bodies.ids() > 0) collisions.make_room(std::uint32_t(data.bodies.ids() - 1));
        const auto shapes = file.at("shapes");
        const auto count = shapes.size("shapes");
        for (std::size_t i = 0; i < count; ++i) read_shape<C>(data, shapes.at(i));
        if constexpr (C::rests)
            if (file.has(pulls)) read_pulls_of_shapeless(data, file.at(pulls));
        const auto contacts = file.at("contacts");
        const auto most = contacts.size("contacts");
        std::pair<std::uint32_t, std::uint32_t> last{};
        for (std::size_t i = 0; i < most; ++i) {
            const auto json = contacts.at(i);
            Contact<typename C::S> contact;
            read_bodies(data, json, contact);
            const std::pair ids(contact.first.id, contact.second.id);
            if (ids.first >= ids.second || (i > 0 && ids <= last))
                json.refuse_here("contacts in the order of their bodies' ids, the smaller first");
            last = ids;
            auto point = contact.point.value();
            json.at("point").size_is(std::size_t(C::S::dimension), "numbers");
            json.at("normal").size_is(std::size_t(C::S::dimension), "numbers");
            for (int k = 0; k < C::S::dimension; ++k) {
                point[k] = json.at("point").at(std::size_t(k)).template number<typename C::S::Scalar>();
                contact.normal[k] = json.at("normal").at(std::size_t(k)).template number<typename C::S::Scalar>();
            }
            if (!(abs(contact.normal.squaredNorm() - typename C::S::Scalar(1)) < typename C::S::Scalar(0.001)))
                json.at("normal").refuse_here("a unit vector");
            contact.point = C::S::Position::from_value(point);
            contact.depth = C::S::Length::from_value(json.at("depth").template number<typename C::S::Scalar>());
            contact.steps = std::uint32_t(json.at("steps").whole(0xffffffffu));
            collisions.contacts.acting.push_back(contact);
        }
        if constexpr (std::remove_cvref_t<decltype(collisions)>::divides) read_siblings(data, file.at("siblings"));
        collisions.parts = int(file.at("parts").whole(1u << 30));
        if (collisions.parts < 1) file.at("parts").refuse_here("a whole number of at least 1");
        collisions.expected = C::S::Time::from_value(file.at("expected").template number<typename C::S::Scalar>());
        if (collisions.expected.value() < 0) file.at("expected").refuse_here("a time step that is not negative");
        collisions.stale_ = file.at("stale").yes();
        data.states.for_each([&](auto& state) {
            if constexpr (requires { state.saved([](auto&&...) {}); }) read_acting<C>(data, state, file.at("acting"));
        });
    }

private:
    static constexpr const char* pulls = "pulls of bodies without a shape";
    /// What pulled at sleepers without a shape when they fell asleep; nothing is written where nothing did.
    template <class C, class Files, class Data>
    static void write_pulls_of_shapeless(typename Files::Json& file, const Data& data) {
        for (std::uint32_t id = 0; id < data.bodies.ids(); ++id) {
            if (!data.bodies.alive(id) || data.collisions.shapes.has(id) || data.collisions.is_sensor(id)) continue;
            const auto pull = data.collisions.pull_when_it_slept(id);
            if (pull == C::S::template zero_vector<unit::Acceleration>()) continue;
            file[pulls].push_back(typename Files::Json{{"body", id}, {"pull", detail::field_to_file<Files>(pull)}});
        }
    }
    template <class Data, class File> static void read_pulls_of_shapeless(Data& data, const File& list) {
        const auto count = list.size("pulls");
        for (std::size_t i = 0; i < count; ++i) {
            const auto json = list.at(i);
            const auto id = body(data, json.at("body"));
            if (data.collisions.shapes.has(id) || data.collisions.is_sensor(id))
                json.at("body").refuse_here("a body that has no shape");
            detail::field_from_file(data.collisions.pulls_[id], json.at("pull"));
        }
    }
    /// The two of a contact; of a body that was removed since, the file has the generation.
    template <class Data, class File> static void read_bodies(Data& data, const File& json, auto& contact) {
        constexpr const char* generations = "generations";
        if (!json.has(generations)) {
            contact.first = data.bodies.handle(data.bodies.slot_of_id(body(data, json.at("first"))));
            contact.second = data.bodies.handle(data.bodies.slot_of_id(body(data, json.at("second"))));
            return;
        }
        const auto both = json.at(generations);
        both.size_is(2, "numbers");
        const std::size_t most = data.bodies.ids() == 0 ? 0 : data.bodies.ids() - 1;
        contact.first.id = std::uint32_t(json.at("first").whole(most));
        contact.second.id = std::uint32_t(json.at("second").whole(most));
        contact.first.generation = std::uint32_t(both.at(std::size_t(0)).whole(0xffffffffu));
        contact.second.generation = std::uint32_t(both.at(std::size_t(1)).whole(0xffffffffu));
        if (data.bodies.contains(contact.first) && data.bodies.contains(contact.second))
            both.refuse_here("generations where a body was removed; both are in the file");
        data.collisions.some_are_gone();
    }
    template <class Data, class File> static std::uint32_t body(const Data& data, const File& json) {
        const auto id = json.whole(data.bodies.ids() == 0 ? 0 : data.bodies.ids() - 1);
        if (id >= data.bodies.ids() || !data.bodies.alive(std::uint32_t(id)))
            json.refuse_here("the id of a body that is in the file");
        return std::uint32_t(id);
    }
    template <class C, class Data, class File> static void read_shape(Data& data, const File& json) {
        using S = typename C::S;
        auto& collisions = data.collisions;
        const auto id = body(data, json.at("body"));
        if (collisions.shapes.has(id) || collisions.is_sensor(id))
            json.at("body").refuse_here("a body that has no shape yet");
        collisions.set_sensor(id, json.at("sensor").yes());
        bool known = false;
        C::Narrowphase::for_each_kind([&]<class Kind>() {
            const std::string name(Kind::name);
            if (known || !json.json.contains(name)) return;
            known = true;
            Kind description{};
            const auto numbers = json.at(name.c_str());
            numbers.parameters(description);
            try {
                detail::check_in<S>(description);
                collisions.shapes.template set<Kind>(id, description, typename Kind::template In<S>(description));
            } catch (const std::invalid_argument& e) {
                refuse(Refusal::invalid_argument, numbers.place + ": " + e.what());
            }
        });
        if (!known && !collisions.is_sensor(id)) json.refuse_here("a shape that the narrowphase of this world knows");
        if constexpr (C::rests) detail::field_from_file(collisions.pulls_[id], json.at("pull"));
    }
    template <class Data, class File> static void read_siblings(Data& data, const File& file) {
        std::vector<std::uint32_t> next(data.bodies.ids());
        std::iota(next.begin(), next.end(), 0U);
        std::vector<bool> named(next.size()), is_next(next.size());
        const auto count = file.size("siblings");
        for (std::size_t i = 0; i < count; ++i) {
            const auto json = file.at(i);
            const auto id = body(data, json.at("body")), to = body(data, json.at("next"));
            if (named[id] || is_next[to] || id == to) json.refuse_here("each body once, and once as another's next");
            named[id] = is_next[to] = true;
            next[id] = to;
        }
        if (named != is_next) file.refuse_here("rings: whoever is another's next has a next one, too");
        data.collisions.siblings_.load(std::move(next));
    }
    template <class C, class Data, class State, class File>
    static void read_acting(const Data& data, State& state, const File& file) {
        const auto count = file.size("contacts");
        std::pair<std::uint32_t, std::uint32_t> last{};
        for (std::size_t i = 0; i < count; ++i) {
            const auto json = file.at(i);
            const auto a = body(data, json.at("first")), b = body(data, json.at("second"));
            if (a >= b || (i > 0 && std::pair(a, b) <= last))
                json.refuse_here("contacts in the order of their bodies' ids, the smaller first");
            last = {a, b};
            const auto numbers = json.at("numbers");
            numbers.size_is(std::size_t(State::numbers_each), "numbers");
            std::vector<typename C::S::Scalar> all;
            for (int k = 0; k < State::numbers_each; ++k)
                all.push_back(numbers.at(std::size_t(k)).template number<typename C::S::Scalar>());
            if (const auto wrong = state.load(a, b, all))
                numbers.at(std::size_t(wrong->first)).refuse_here(wrong->second);
        }
    }
};

} // namespace ansatz
