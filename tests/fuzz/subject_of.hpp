// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A composition with the verbs of a Subject. The only part of the fuzzer that is compiled for each world.

#include "tests/fuzz/either.hpp"
#include "tests/fuzz/subject.hpp"

#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/springs.hpp>
#include <ansatz/world/keep.hpp>
#include <ansatz/world/save.hpp>

#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

namespace fuzz {

using namespace ansatz; // NOLINT(google-build-using-namespace): as a test does

template <class W> auto vec(const auto& unit, const Numbers& n) {
    if constexpr (W::S::dimension == 2) return vector_of(unit, n[0], n[1]);
    else return vector_of(unit, n[0], n[1], n[2]);
}

/// \tparam W the world, or what stands in for it
template <class W, class Make> class SubjectOf final : public Subject {
    using C = typename W::composition;
    using S = typename W::S;
    static constexpr bool collides = requires(const W& w) { w.contacts(); } && !std::is_void_v<typename C::Narrowphase>;
    static_assert(C::has_mass, "a composition of the fuzzer stores masses: its laws are about momentum and energy");
    static constexpr bool restitutes = C::template stores<Restitution>;
    static constexpr bool rubs = C::template stores<Friction>;
    static constexpr bool springs = C::element_keepers::size > 0;

public:
    SubjectOf(Facts facts, Make make) : facts_(std::move(facts)), make_(make), world_(make(false)) {
        facts_.dimension = S::dimension;
        facts_.epsilon = double(std::numeric_limits<typename S::Scalar>::epsilon());
        facts_.collides = collides;
        facts_.restitution = restitutes;
        facts_.friction = rubs;
        facts_.applied = C::template stores<AppliedForce>;
        facts_.springs = springs;
        facts_.history = C::history;
        facts_.rests = C::rests;
    }

    const Facts& facts() const override { return facts_; }
    std::unique_ptr<Subject> fresh(bool other) const override {
        auto made = std::make_unique<SubjectOf>(facts_, make_);
        if (other) made->world_ = make_(true);
        return made;
    }
    std::unique_ptr<Subject> copy() const override { return std::make_unique<SubjectOf>(*this); }
    void assign(const Subject& other) override { world_ = static_cast<const SubjectOf&>(other).world_; }
    std::string save() const override {
        std::ostringstream out;
        ansatz::save(world_, out);
        return out.str();
    }
    void load(const std::string& text) override {
        std::istringstream in(text);
        ansatz::load(world_, in);
    }

    void perform(const Operation& o, Names& names) override {
        const auto body = [&] { return names.bodies[std::size_t(o.body)]; };
        switch (o.verb) {
        case Verb::add: {
            const auto made = add(o);
            if (std::size_t(o.body) >= names.bodies.size()) names.bodies.resize(std::size_t(o.body) + 1);
            names.bodies[std::size_t(o.body)] = made;
            break;
        }
        case Verb::remove: world_.remove(body()); break;
        case Verb::set_position: world_.set_position(body(), vec<W>(metre, o.place)); break;
        case Verb::set_velocity: world_.set_velocity(body(), vec<W>(metre_per_second, o.vector)); break;
        case Verb::set_mass: world_.set_mass(body(), o.mass * kilogram); break;
        case Verb::set_restitution:
            if constexpr (restitutes)
                world_.template write<Restitution>(body(), Quantity<unit::Dimensionless>(o.restitution));
            break;
        case Verb::apply_force:
            if constexpr (C::template stores<AppliedForce>) world_.apply_force(body(), vec<W>(newton, o.vector));
            break;
        case Verb::apply_impulse: world_.apply_impulse(body(), vec<W>(newton_second, o.vector)); break;
        case Verb::wake: world_.wake(body()); break;
        case Verb::add_spring: add_spring(o, names); break;
        case Verb::remove_spring:
            if constexpr (springs) world_.remove(names.springs[std::size_t(o.spring)]);
            break;
        case Verb::step: world_.step(o.dt * second); break;
        case Verb::copy:
        case Verb::load:
        case Verb::again: break; // of several worlds
        }
    }

    bool contains(Handle body) const override { return world_.contains(body); }
    bool contains_spring(ElementHandle<Spring> spring) const override {
        if constexpr (springs) return world_.contains(spring);
        else return spring == ElementHandle<Spring>() && false;
    }
    std::size_t size() const override { return world_.size(); }
    Motion motion(Handle body) const override { return world_.motion(body); }
    int datum(Handle body) const override { return world_.datum(body); }
    Numbers position(Handle body) const override { return numbers(world_.position(body)); }
    Numbers velocity(Handle body) const override { return numbers(world_.velocity(body)); }
    double mass(Handle body) const override {
        const double inverse = double(world_.inverse_mass(body).value());
        return inverse > 0 ? 1 / inverse : 0;
    }
    double restitution(Handle body) const override {
        if constexpr (restitutes) return double(world_.template read<Restitution>(body).value());
        return 0;
    }
    std::vector<Pair> contacts() const override {
        std::vector<Pair> all;
        if constexpr (collides)
            for (const auto& c : world_.contacts()) all.push_back({c.first, c.second});
        return all;
    }
    std::uint64_t hash() const override { return world_.hash(); }
    bool ok() const override { return world_.status().ok(); }

private:
    static Numbers numbers(const auto& v) {
        Numbers n{};
        for (int k = 0; k < S::dimension; ++k) n[std::size_t(k)] = double(v.value()[k]);
        return n;
    }
    Handle add(const Operation& o) {
        if constexpr (!collides) return add_in_shape(o);
        else if constexpr (rubs) return add_shape(o, friction(0.5));
        else return add_shape(o);
    }
    Handle add_shape(const Operation& o, const auto&... rough) {
        const Sphere ball{o.size * metre};
        switch (o.shape) {
        case Shape::sphere: return add_in_shape(o, ball, rough...);
        case Shape::box: {
            const Box box{vec<W>(metre, {o.size, o.size, o.size})};
            if (o.kind == Kind::fixed) return world_.add(box, at(o), fixed, datum_of(o), rough...);
            return add_awake(o, box, rough...);
        }
        case Shape::plane: {
            Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // of three numbers, in two dimensions too
            normal[o.axis] = 1;
            return world_.add(Plane{normal, -o.size * metre}, fixed, datum_of(o), rough...);
        }
        case Shape::none: break;
        }
        return world_.add(shapeless, at(o), going(o), ansatz::mass(o.mass * kilogram), datum_of(o));
    }
    Handle add_in_shape(const Operation& o, const auto&... shape) {
        switch (o.kind) {
        case Kind::fixed: return world_.add(shape..., at(o), fixed, datum_of(o));
        case Kind::moving: return world_.add(shape..., at(o), going(o), moving, datum_of(o));
        case Kind::resting:
            if constexpr (C::rests)
                return world_.add(shape..., at(o), resting, ansatz::mass(o.mass * kilogram), datum_of(o));
            break;
        case Kind::awake: break;
        }
        return add_awake(o, shape...);
    }
    Handle add_awake(const Operation& o, const auto&... shape) {
        if constexpr (restitutes && sizeof...(shape) > 0)
            return world_.add(shape..., at(o), going(o), ansatz::mass(o.mass * kilogram),
                              ansatz::restitution(o.restitution), datum_of(o));
        else return world_.add(shape..., at(o), going(o), ansatz::mass(o.mass * kilogram), datum_of(o));
    }
    void add_spring(const Operation& o, Names& names) {
        if constexpr (springs) {
            SpringEnd to(vec<W>(metre, o.place));
            if (o.second >= 0) to = SpringEnd(names.bodies[std::size_t(o.second)]);
            const auto made = world_.add(Spring{names.bodies[std::size_t(o.body)], to, o.stiffness * newton_per_metre,
                                                o.damping * newton_second_per_metre});
            if (std::size_t(o.spring) >= names.springs.size()) names.springs.resize(std::size_t(o.spring) + 1);
            names.springs[std::size_t(o.spring)] = made;
        }
    }
    static auto at(const Operation& o) { return ansatz::position(vec<W>(metre, o.place)); }
    static auto going(const Operation& o) { return ansatz::velocity(vec<W>(metre_per_second, o.vector)); }
    static auto datum_of(const Operation& o) { return ansatz::datum(o.body); }

    Facts facts_;
    Make make_;
    W world_;
};

/// \param make gives an empty world; with `true` one whose broadphase tests every pair
template <class Make> std::unique_ptr<Subject> subject(Facts facts, Make make) {
    return std::make_unique<SubjectOf<decltype(make(false)), Make>>(std::move(facts), make);
}

} // namespace fuzz
