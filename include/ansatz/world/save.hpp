// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// `save` and `load`: a world's state as a JSON file with a version.
// not in the umbrella: it is the only header that needs nlohmann-json, and takes two seconds to compile
///
/// Use them for saved games and for the case that goes wrong on somebody else's machine: a loaded world continues
/// bit-identically with the saved one. A copy of a world is the faster snapshot within a program. Saved are the bodies,
/// their handles, the clock, and the parameters of every policy that names them (`name` and `parameters`, see Gravity).
/// A `Datum` is saved where it can be (datum_text.hpp). Not saved: what can be made anew, and polled events. A file is
/// checked in full before the world is touched; it must come from a world of the same columns, scalar and dimension.
///
/// Needs exceptions, for the parser's sake.

#include <ansatz/world/datum_text.hpp>
#include <ansatz/world/fields.hpp>
#include <ansatz/world/save_elements.hpp>
#include <ansatz/world/save_parameters.hpp>
#include <ansatz/world/whole_file.hpp>
#include <ansatz/world/world.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <istream>
#include <limits>
#include <ostream>
#include <string>

namespace ansatz {

namespace detail {

template <class T> constexpr const char* scalar_name() {
    if constexpr (std::same_as<T, float>) return "float";
    if constexpr (std::same_as<T, double>) return "double";
    return "class";
}

template <class P>
concept Named = requires(P& p) {
    { P::name } -> std::convertible_to<std::string_view>;
    P::parameters(p, [](std::string_view, auto&) {});
};

} // namespace detail

/// The one that may read a world to save and load it.
struct Archive {
    static constexpr int version = 1; ///< the version of the format that is written

    /// The world as text.
    template <class... P> static detail::Json write(const World<P...>& world) {
        if (world.lost_) world.refuse_lost("save");
        using detail::number_to_file;
        using C = typename World<P...>::composition;
        const auto& data = world.data_;
        detail::Json file;
        file["format"] = "ansatz world";
        file["version"] = version;
        file["scalar"] = detail::scalar_name<typename World<P...>::Scalar>();
        file["dimension"] = C::S::dimension;
        file["columns"] = columns(typename C::state{});
        file["policies"] = detail::Json::object();
        (write_policy(file["policies"], std::get<P>(world.policies_)), ...);
        if constexpr (C::element_keepers::size > 0) {
            auto& elements = file["elements"] = detail::Json::object();
            [&]<class... K>(Types<K...>) {
                (ElementArchive::write<C>(elements[std::string(K::name)], data.template state<K>()), ...);
            }(typename C::element_keepers{});
        }
        [&]<class... K>(Types<K...>) { (write_state<K>(file, data.template state<K>()), ...); }(typename C::keepers{});
        data.template ask<hook::Save>(file, detail::Files{});
        file["clock"] = {{"start", number_to_file(data.clock.start_.value())},
                         {"dt", number_to_file(data.clock.dt_.value())},
                         {"steps", data.clock.steps_},
                         {"tick", data.clock.tick_}};
        file["generations"] = data.bodies.generation_;
        file["free"] = data.bodies.free_;
        auto& bodies = file["bodies"] = detail::Json::array(); // slot by slot
        for (std::uint32_t slot = 0; slot < data.bodies.size(); ++slot) {
            detail::Json body;
            body["id"] = data.bodies.id(slot);
            body["motion"] = name_of(data.bodies.motion(slot));
            data.template ask<hook::SaveBody>(slot, body);
            write_columns(body, data.lanes, slot, typename C::state{});
            if constexpr (saves_datum<World<P...>>)
                body["datum"] = detail::datum_text(world.user_.at(data.bodies.id(slot)));
            bodies.push_back(std::move(body));
        }
        return file;
    }

    /// The world of a file that was parsed; it is left as it was where the file is refused.
    template <class... P> static void read(World<P...>& world, const detail::FileValue& file) {
        using W = World<P...>;
        using C = typename W::composition;
        file.at("format").is("ansatz world", "");
        file.at("version").is(version, ", the version that this library reads");
        file.at("scalar").is(detail::scalar_name<typename W::Scalar>(), ", the scalar of this world");
        file.at("dimension").is(C::S::dimension, ", the dimension of this world");
        same_columns(file.at("columns"), columns(typename C::state{}));

        auto policies = world.policies_;
        (read_policy(std::get<P>(policies), file.at("policies")), ...);
        refuse_others<P...>(file.at("policies"));
        auto bound = [&] {
            try {
                return BoundPolicies<C>::from(W::checked(policies));
            } catch (const std::invalid_argument& e) {
                refuse(Refusal::invalid_argument, file.place + ": policies: " + e.what());
            }
        }();

        typename W::Data data;
        read_clock(data.clock, file.at("clock"));
        read_bodies<C>(data, file);
        if constexpr (C::element_keepers::size > 0) {
            const auto elements = file.at("elements");
            [&]<class... K>(Types<K...>) {
                (ElementArchive::read<C>(data.template state<K>(), data.bodies,
                                         elements.at(std::string(K::name).c_str())),
                 ...);
            }(typename C::element_keepers{});
        }
        [&]<class... K>(Types<K...>) { (read_state<K>(data.template state<K>(), file), ...); }(typename C::keepers{});
        data.template tell<hook::Load>(file);

        // Of what cannot be saved: a body that this world has keeps its datum, every other begins with a new one.
        decltype(world.user_) user;
        if constexpr (W::has_datum) user.by_id.resize(data.bodies.ids());
        if constexpr (saves_datum<W>)
            for (std::uint32_t slot = 0; slot < data.bodies.size(); ++slot)
                read_datum(user.at(data.bodies.id(slot)), file.at("bodies").at(slot).at("datum"));
        const auto room = std::max<std::size_t>(data.bodies.ids(), world.capacity_);
        data.reserve(room);
        if constexpr (W::has_datum && !saves_datum<W>)
            for (std::uint32_t id = 0; id < data.bodies.ids(); ++id)
                if (data.bodies.alive(id) && world.data_.bodies.contains({id, data.bodies.generation_of_id(id)}))
                    user.by_id[id] = std::move(world.user_.by_id[id]); // behind all that may fail
        world.capacity_ = room;
        world.lost_ = false;
        world.policies_ = std::move(policies);
        world.bound_ = std::move(bound);
        world.data_ = std::move(data);
        if constexpr (W::has_datum) world.user_ = std::move(user);
    }

private:
    using FileValue = detail::FileValue;

    template <class W> static constexpr bool saves_datum = detail::datum_is_saved<typename W::Datum>;
    template <class T> static void read_datum(T& datum, const FileValue& file) {
        if (!file.json.is_string()) file.refuse_here("the body's datum as text");
        try {
            detail::datum_from(datum, file.json.template get<std::string>());
        } catch (const std::invalid_argument& expected) {
            file.refuse_here(expected.what());
        }
    }

    template <class... Col> static detail::Json columns(Columns<Col...>) {
        auto names = detail::Json::array();
        (names.push_back(Col::name), ...);
        return names;
    }

    /// The order of the columns follows from that of the policies, which means nothing.
    static void same_columns(const FileValue& file, const detail::Json& expected) {
        const bool same = file.size("columns") == expected.size() &&
                          std::is_permutation(expected.begin(), expected.end(), file.json.begin());
        if (!same) file.refuse_here(expected.dump() + ", the columns of this world, in any order");
    }

    /// What a policy keeps, by its fields.
    template <class P, class State> static void write_state(detail::Json& file, const State& state) {
        if constexpr (detail::NamesFields<State>) {
            need_name<P>();
            detail::write_fields<detail::Files>(file["states"][std::string(P::name)] = detail::Json::object(), state);
        }
    }
    template <class P, class State> static void read_state(State& state, const FileValue& file) {
        if constexpr (detail::NamesFields<State>) {
            need_name<P>();
            detail::read_fields(state, file.at("states").at(std::string(P::name).c_str()));
        }
    }
    template <class P> static constexpr void need_name() {
        constexpr bool named = requires { std::string_view(P::name); };
        static_assert(named, "Ansatz: save: a policy that keeps a State has no name for it to stand under in the file; "
                             "give it `static constexpr std::string_view name`");
    }

    template <class P> static void write_policy(detail::Json& policies, const P& policy) {
        if constexpr (detail::Named<P>)
            detail::write_parameters(policies[std::string(P::name)] = detail::Json::object(), policy);
    }
    template <class P> static void read_policy(P& policy, const FileValue& policies) {
        if constexpr (detail::Named<P>) detail::read_parameters(policy, policies.at(std::string(P::name).c_str()));
    }

    /// A policy that only the file has would be forgotten without a word.
    template <class... P> static void refuse_others(const FileValue& policies) {
        if (!policies.json.is_object()) policies.refuse_here("an object of policies");
        auto is_name_of = []<class One>(std::type_identity<One>, const std::string& name) {
            if constexpr (detail::Named<One>) return name == One::name;
            return false;
        };
        for (const auto& [name, parameters] : policies.json.items())
            if (!(is_name_of(std::type_identity<P>{}, name) || ...))
                policies.at(name.c_str()).refuse_here("no such policy, because this world has none");
    }

    template <class S> static void read_clock(StepClock<S>& clock, const FileValue& json) {
        using Time = typename S::ClockTime;
        constexpr auto most = std::numeric_limits<std::uint64_t>::max();
        clock.start_ = Time::from_value(json.at("start").number<typename S::ClockScalar>());
        clock.dt_ = Time::from_value(json.at("dt").number<typename S::ClockScalar>());
        if (clock.dt_.value() < 0) json.at("dt").refuse_here("a time step that is not negative");
        clock.tick_ = json.at("tick").whole(most);
        clock.steps_ = json.at("steps").whole(clock.tick_);
        using Scalar = typename S::Scalar;
        if (!is_finite(clock.now())) json.at("steps").refuse_here("a number of steps after which the time is finite");
        if (clock.tick_ > 0 && !(static_cast<Scalar>(clock.dt_.value()) > Scalar(0)))
            json.at("dt").refuse_here("a time step greater than 0 that the world's scalar can hold");
    }

    template <class C, class Data> static void read_bodies(Data& data, const FileValue& file) {
        constexpr std::uint64_t most = 0xffffffffu;
        const auto generations = file.at("generations");
        const auto ids = generations.size("generations");
        for (std::size_t id = 0; id < ids; ++id) {
            data.bodies.generation_.push_back(std::uint32_t(generations.at(id).whole(most)));
            data.bodies.slot_of_.push_back(Bodies::none);
        }
        const auto bodies = file.at("bodies");
        const auto count = bodies.size("bodies");
        auto kind = Motion::awake;
        for (std::size_t slot = 0; slot < count; ++slot) {
            const auto body = bodies.at(slot);
            const auto id = body.at("id").whole(ids == 0 ? 0 : ids - 1);
            if (id >= ids || data.bodies.slot_of_[id] != Bodies::none)
                body.at("id").refuse_here("an id that no other body has");
            const auto motion = motion_from(body.at("motion"));
            if (motion < kind) body.at("motion").refuse_here("bodies in the order awake, resting, moving, fixed");
            kind = motion;
            data.bodies.slot_of_[id] = Bodies::Slot(slot);
            data.bodies.id_at_.push_back(std::uint32_t(id));
            if (slot % Bodies::block == 0) data.bodies.changes_by_block_.push_back(1);
            data.bodies.changes_ = 1;
            for (auto m = std::size_t(motion); m < 4; ++m) data.bodies.end_[m] = slot + 1;
            data.lanes.push_back();
            read_columns(data.lanes, body, slot, typename C::state{});
            if constexpr (C::has_mass)
                check_mass(data.lanes.template get<InverseMass>(slot).value(), motion, body.at("inverse mass"));
            data.template tell<hook::LoadBody>(std::uint32_t(slot), body);
        }
        const auto free = file.at("free");
        free.size_is(ids - count, "free ids");
        auto taken = data.bodies.slot_of_;
        for (std::size_t i = 0; i < ids - count; ++i) {
            const auto id = free.at(i).whole(ids - 1);
            if (taken[id] != Bodies::none) free.at(i).refuse_here("an id that is free, once");
            taken[id] = 0;
            data.bodies.free_.push_back(std::uint32_t(id));
        }
    }

    static Motion motion_from(const FileValue& json) {
        for (const auto m : {Motion::awake, Motion::resting, Motion::moving, Motion::fixed})
            if (json.json == name_of(m)) return m;
        json.refuse_here("\"awake\", \"resting\", \"moving\" or \"fixed\"");
    }

    template <class Scalar> static void check_mass(const Scalar& inverse, Motion motion, const FileValue& json) {
        const bool immovable = motion == Motion::moving || motion == Motion::fixed;
        if (immovable && !(inverse == Scalar(0))) json.refuse_here("0, because the body is fixed or moving");
        if (!immovable && !(inverse > Scalar(0))) json.refuse_here("a number greater than 0");
        if (!immovable && !is_finite(Scalar(Scalar(1) / inverse))) json.refuse_here("the inverse of a finite mass");
    }

    template <class LanesT, class... Col>
    static void write_columns(detail::Json& body, const LanesT& lanes, std::size_t slot, Columns<Col...>) {
        auto one = [&]<class Which>(Columns<Which>) {
            auto& json = body[std::string(Which::name)];
            if constexpr (lanes_of<Which>(2) == 1 && lanes_of<Which>(3) == 1)
                json = detail::number_to_file(lanes.template lane<Which>()[slot]);
            else
                for (std::size_t k = 0; k < lanes_of<Which>(LanesT::dimension); ++k)
                    json.push_back(detail::number_to_file(lanes.template lane<Which>(int(k))[slot]));
        };
        (one(Columns<Col>{}), ...);
    }
    template <class LanesT, class... Col>
    static void read_columns(LanesT& lanes, const FileValue& body, std::size_t slot, Columns<Col...>) {
        auto one = [&]<class Which>(Columns<Which>) {
            const auto json = body.at(std::string(Which::name).c_str());
            using Scalar = typename LanesT::Scalar;
            if constexpr (lanes_of<Which>(2) == 1 && lanes_of<Which>(3) == 1) {
                const auto value = json.template number<Scalar>();
                if (!detail::in_range<Which>(value)) json.refuse_here(detail::range_of<Which>());
                lanes.template lane<Which>()[slot] = value;
            } else {
                constexpr std::size_t count = lanes_of<Which>(LanesT::dimension);
                json.size_is(count, "numbers");
                for (std::size_t k = 0; k < count; ++k)
                    lanes.template lane<Which>(int(k))[slot] = json.at(k).template number<Scalar>();
            }
            if constexpr (requires { lanes.template get<Which>(slot).check(); }) {
                try {
                    lanes.template get<Which>(slot).check();
                } catch (const std::invalid_argument& e) {
                    refuse(Refusal::invalid_argument, json.place + ": " + e.what());
                }
            }
        };
        (one(Columns<Col>{}), ...);
    }
};

namespace detail {
inline std::string text_of(const Json& file) {
    try {
        return file.dump(1);
    } catch (const Json::type_error& e) { // "[json.exception.type_error.316] invalid UTF-8 byte at index 3: 0xFF"
        const std::string what = e.what();
        const auto said = what.find("] ");
        refuse(Refusal::invalid_argument, "save: a datum is not a text in UTF-8, as a file needs it: " +
                                              (said == std::string::npos ? what : what.substr(said + 2)));
    }
}
} // namespace detail

/// Writes the state of a world.
/// \throws std::invalid_argument if the stream fails, or a datum is not a text in UTF-8
template <class... P> void save(const World<P...>& world, std::ostream& out) {
    out << detail::text_of(Archive::write(world)) << '\n';
    if (!out) refuse(Refusal::invalid_argument, "save: the stream could not be written to the end");
}
/// Writes the state of a world to a file, whole or not at all: it is written beside the file, as `path`.part, which
/// then takes the file's place.
/// \throws std::invalid_argument if the file cannot be written; what was there before is there as it was
template <class... P> void save(const World<P...>& world, const std::string& path) {
    detail::write_whole_file(path, detail::text_of(Archive::write(world)) + '\n');
}

/// Reads the state of a world; handles of the saved world name its bodies.
/// \param name how error sentences call the source, e.g. the path
/// \throws std::invalid_argument with the place in the file and what was expected; the world is then as it was
template <class... P> void load(World<P...>& world, std::istream& in, const std::string& name = "load") {
    detail::Json file;
    try {
        file = detail::parse_file(in);
    } catch (const detail::Json::exception& e) {
        const std::string what = e.what(); // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
        const auto sentence = what.find("] ");
        refuse(Refusal::invalid_argument,
               name + ": " + (sentence == std::string::npos ? what : what.substr(sentence + 2)));
    } catch (const std::ios_base::failure&) {
        refuse(Refusal::invalid_argument, name + " cannot be read; is it a file?");
    }
    Archive::read(world, detail::FileValue{file, name, true});
}
/// Reads the state of a world from a file.
template <class... P> void load(World<P...>& world, const std::string& path) {
    std::ifstream in(path);
    if (!in) refuse(Refusal::invalid_argument, "load: " + path + " cannot be opened for reading");
    load(world, in, path);
}

} // namespace ansatz
