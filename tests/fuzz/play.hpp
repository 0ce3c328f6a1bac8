// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A scene, played and judged: by a plain model of which bodies exist, and by laws that hold whatever happens.

#include "tests/fuzz/allocations.hpp"
#include "tests/fuzz/model.hpp"
#include "tests/fuzz/program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

/// A law that was broken.
struct Fault {
    std::string law;   ///< which one: the shrinker searches for the same
    std::string check; ///< the line of C++ that fails
};
/// How often each law was judged: one that never was has held nothing.
struct Judged {
    std::uint64_t steps = 0, refusals = 0, copies = 0, loads = 0, taken_back = 0, contacts = 0, sleepers = 0,
                  momentum = 0, energy = 0, without_memory = 0;
};
inline Judged judged; // in this program

/// Plays one scene once.
class Play {
public:
    /// \param program takes the lines, if there is one
    explicit Play(const Subject& like, Program* program = nullptr)
        : facts_(like.facts()), like_(like), world_(like.fresh(false)), model_(facts_), program_(program) {
        if (facts_.collides) others_.push_back({like.fresh(true), "other", "another broadphase: the same bits"});
    }

    std::optional<Fault> run(const Scene& scene) {
        for (std::size_t i = 0; i < scene.size() && !is_over(); ++i) {
            Operation o = scene[i];
            if (!is_usable(o)) continue;
            if (program_ != nullptr) program_->begin();
            const int times = std::exchange(o.times, 1);
            if (times > 1) write(scene[i], model_.must_be_refused(o));
            Program* const program = times > 1 ? std::exchange(program_, nullptr) : program_;
            for (int k = 0; k < times && !is_over(); ++k) one(o);
            program_ = program;
        }
        return fault_;
    }
    /// Which operations of a scene meant something, one step at a time.
    const Scene& played() const { return played_; }

private:
    struct Other {
        std::unique_ptr<Subject> world;
        std::string name, law;
    };
    using Pairs = std::set<std::pair<int, int>>;

    bool is_over() const { return fault_.has_value() || unbounded_; }
    /// One copy and one file in a scene: more of them are no other worlds.
    bool is_usable(const Operation& o) const {
        const auto there = [&](const char* name) {
            return std::any_of(others_.begin(), others_.end(), [&](const Other& other) { return other.name == name; });
        };
        if ((o.verb == Verb::copy && there("copy")) || (o.verb == Verb::load && there("loaded"))) return false;
        if (o.verb == Verb::again && model_.must_be_refused(o)) return false;
        return model_.is_usable(o);
    }
    void line(const std::string& text) {
        if (program_ != nullptr) program_->line(text);
    }
    void write(const Operation& o, bool refused) {
        if (program_ == nullptr) return;
        program_->call(o, "world", refused);
        for (const auto& other : others_) program_->call(o, other.name, refused);
    }
    void found(const std::string& law, const std::string& check) {
        if (!fault_) fault_ = Fault{law, check};
    }
    /// `world.position(b1) == before.position(b1)`
    static std::string as_before(const std::string& what, int body) {
        const auto b = "." + what + "(" + body_name(body) + ")";
        return "CHECK(world" + b + " == before" + b + ");";
    }

    void one(const Operation& o) {
        played_.push_back(o);
        if (o.verb == Verb::copy) return copy();
        if (o.verb == Verb::load) return load();
        if (o.verb == Verb::again) return again(o);
        const bool refused = model_.must_be_refused(o);
        const auto hash = world_->hash();
        const Sight before(*world_, model_);
        if (!refused && o.verb != Verb::step && !is_whole_without_memory(o))
            return found("a verb that finds no memory changes nothing",
                         "CHECK(fuzz::is_whole_without_memory(world, [&](auto& w) { w." + call_of(o, facts_) +
                             "; }));");
        write(o, refused);
        try {
            world_->perform(o, model_.names);
            if (refused) return found("bad input is refused", "CHECK_THROWS(world." + call_of(o, facts_) + ");");
        } catch (const std::exception&) {
            if (!refused) return found("what is right is taken", "CHECK_NOTHROW(world." + call_of(o, facts_) + ");");
        }
        judged.refusals += refused;
        judged.steps += o.verb == Verb::step;
        if (!refused) follow(o);
        if (refused && world_->hash() != hash)
            return found("a refusal changes nothing", "CHECK(world.hash() == before.hash());");
        judge_others(o);
        judge_who_is_there();
        if (fault_ || refused) return;
        if (o.verb == Verb::step) judge_step(o, before);
        else judge_verb(o, before, hash);
        model_.note_woken(*world_);
    }
    void follow(const Operation& o) {
        model_.follow(o);
        pushed_ = pushed_ || o.verb == Verb::apply_force;
        if (o.verb == Verb::add || o.verb == Verb::set_position)
            put_into_another_ = put_into_another_ || (facts_.collides && model_.overlaps_another(o.body, *world_));
    }

    void copy() {
        ++judged.copies;
        line("auto copy = world;");
        others_.push_back({world_->copy(), "copy", "a copy continues to the bit"});
        if (others_.back().world->hash() != world_->hash())
            found("a copy continues to the bit", "CHECK(copy.hash() == world.hash());");
    }
    void load() {
        line(facts_.type + " loaded{" + facts_.text + "};");
        line("load_text(loaded, text_of(world));");
        ++judged.loads;
        auto loaded = like_.fresh(false);
        try {
            loaded->load(world_->save());
        } catch (const std::exception&) {
            return found("what was saved can be loaded", "CHECK_NOTHROW(load_text(loaded, text_of(world)));");
        }
        others_.push_back({std::move(loaded), "loaded", "what was saved and loaded continues to the bit"});
        if (others_.back().world->hash() != world_->hash())
            found("what was saved and loaded continues to the bit", "CHECK(loaded.hash() == world.hash());");
    }
    /// Rolled back, as a game over a network does it: the same step again, to the bit, and without an allocation.
    void again(const Operation& o) {
        ++judged.taken_back;
        Operation once = o;
        once.verb = Verb::step;
        once.times = 1;
        const auto snapshot = world_->copy();
        std::uint64_t hash = 0;
        const auto step = "world." + call_of(o, facts_) + ";";
        line("const auto snapshot = world;");
        for (int i = 0; i < 4 && !fault_; ++i) {
            std::size_t count = 0;
            try {
                count = allocations_of([&] { world_->perform(once, model_.names); });
            } catch (const std::exception&) {
                return found("what is right is taken", "CHECK_NOTHROW(" + step + ");");
            }
            const bool warm = i == 3; // some lists change places with each other from step to step
            if (warm && count > 0)
                return found("a warm step does not allocate",
                             "CHECK(fuzz::allocations_of([&] { " + step + " }) == 0);");
            line(step);
            if (i > 0 && world_->hash() != hash)
                found("a step that was taken back is the same again", "CHECK(world.hash() == first);");
            if (i == 0) line("const auto first = world.hash();");
            hash = world_->hash();
            world_->assign(*snapshot);
            line("world = snapshot;");
            if (world_->hash() != snapshot->hash())
                found("an assigned snapshot is the world that it was", "CHECK(world.hash() == snapshot.hash());");
        }
    }

    void judge_others(const Operation& o) {
        for (const auto& other : others_) {
            try {
                other.world->perform(o, model_.names);
            } catch (const std::exception&) { // the hashes tell, if only one of them refuses it
            }
            if (other.world->hash() != world_->hash())
                return found(other.law, "CHECK(" + other.name + ".hash() == world.hash());");
        }
    }
    /// What is_whole_without_memory does, to what the world is now. A step that finds no memory is lost.
    bool is_whole_without_memory(const Operation& o) const {
        ++judged.without_memory;
        Names names = model_.names; // with room: only the world may ask for more
        names.bodies.resize(names.bodies.size() + 1 + std::size_t(std::max(o.body, 0)));
        names.springs.resize(names.springs.size() + 1 + std::size_t(std::max(o.spring, 0)));
        for (std::size_t n = 0;; ++n) {
            const auto copy = world_->copy();
            const auto before = copy->hash(); // whether it is a faithful copy is another law
            try {
                if (done_with(n, [&] { copy->perform(o, names); })) return true;
            } catch (const std::exception&) { // the world itself will say that it refuses what is right
                return true;
            }
            if (copy->hash() != before) return false;
        }
    }
    void judge_who_is_there() {
        const auto contains = [&](const std::string& name, bool there) {
            found("who is there", "CHECK(world.contains(" + name + ") == " + (there ? "true" : "false") + ");");
        };
        std::size_t size = 0;
        for (const auto& [body, known] : model_.bodies()) {
            size += known.there;
            if (world_->contains(model_.handle(body)) != known.there) return contains(body_name(body), known.there);
            if (known.there && world_->datum(model_.handle(body)) != body)
                return found("whose datum it is",
                             "CHECK(world.datum(" + body_name(body) + ") == " + std::to_string(body) + ");");
        }
        if (world_->size() != size) found("who is there", "CHECK(world.size() == " + std::to_string(size) + ");");
        for (const int spring : model_.all_springs()) {
            const bool there = model_.springs().contains(spring);
            if (world_->contains_spring(model_.names.springs[std::size_t(spring)]) != there)
                return contains(spring_name(spring), there);
        }
    }

    /// A verb changes the body that it is done to, and no other; what it changes shows in the hash.
    void judge_verb(const Operation& o, const Sight& before, std::uint64_t hash) {
        const Sight now(*world_, model_);
        for (const auto& [body, was] : before.bodies) {
            if (body == o.body || !now.bodies.contains(body)) continue;
            const auto& is = now.bodies.at(body);
            const char* const law = "a verb touches nobody else";
            if (is.place != was.place) return found(law, as_before("position", body));
            if (!same_velocity(is.velocity, was.velocity)) return found(law, as_before("velocity", body));
            if (is.mass != was.mass) return found(law, as_before("mass", body));
            if (is.restitution != was.restitution) return found(law, as_before("read<Restitution>", body));
        }
        const auto was = before.bodies.find(o.body), is = now.bodies.find(o.body);
        if (is == now.bodies.end()) return;
        if (was != before.bodies.end() && !(is->second == was->second) && world_->hash() == hash)
            return found("every number counts in the hash", "CHECK(world.hash() != before.hash());");
        const char* const law = "a verb does what it says";
        const auto near_to = [&](const char* what, const Numbers& should) {
            const auto b = std::string(what) + "(" + body_name(o.body) + "), ";
            found(law, "CHECK(fuzz::apart(world." + b + list_of(should) + ") < 1e-5);");
        };
        if (o.verb == Verb::set_position && !near(is->second.place, o.place, 0)) near_to("position", o.place);
        if (o.verb == Verb::set_velocity &&
            !near(is->second.velocity, o.vector, facts_.history ? 4e5 * facts_.epsilon : 0))
            near_to("velocity", o.vector);
        if (o.verb == Verb::wake && is->second.motion == ansatz::Motion::resting)
            found(law, "CHECK(world.motion(" + body_name(o.body) + ") != Motion::resting);");
    }

    void judge_step(const Operation& o, const Sight& before) {
        const bool pushed = std::exchange(pushed_, false);
        if (o.dt == 0) return;
        if (!world_->ok()) {
            unbounded_ = !facts_.bounded;
            if (facts_.bounded) found("every number is finite", "CHECK(world.status().ok());");
            return;
        }
        const Sight now(*world_, model_);
        judge_who_stays(before, now);
        const auto touching = pairs();
        if (facts_.falls && facts_.rests) judge_sleepers(now, touching);
        if (facts_.collides && facts_.stays) judge_contacts(before, now, touching);
        const bool alone = model_.all_of([](const Model::Known& known) { return known.heavy; });
        if (facts_.closed && alone && !model_.is_anchored() && !pushed && !before.sleepers && !now.sleepers)
            judge_momentum(o, before, now);
        const bool platforms = !model_.all_of([](const Model::Known& known) { return known.kind != Kind::moving; });
        const bool separated = !facts_.soft || !put_into_another_;
        if (facts_.keeps_energy && model_.springs().empty() && !pushed && !platforms && separated)
            judge_energy(o, before, now);
    }
    void judge_who_stays(const Sight& before, const Sight& now) {
        for (const auto& [body, is] : now.bodies) {
            const auto& was = before.bodies.at(body);
            const bool sleeps = is.motion == ansatz::Motion::resting;
            if (sleeps && is.velocity != Numbers{})
                return found("a sleeper has no velocity",
                             "CHECK(norm(world.velocity(" + body_name(body) + ")).value() == 0);");
            if (is.place == was.place) continue;
            if (sleeps && was.motion == ansatz::Motion::resting)
                return found("a sleeper stays where it is", as_before("position", body));
            if (was.motion == ansatz::Motion::fixed)
                return found("a fixed body stays where it is", as_before("position", body));
        }
    }
    void judge_momentum(const Operation& o, const Sight& before, const Sight& now) {
        ++judged.momentum;
        const double margin = 64 * now.rounding(facts_, o.dt);
        for (std::size_t k = 0; k < 3; ++k)
            if (std::abs(now.momentum[k] - before.momentum[k]) > margin)
                return found(
                    "momentum is kept",
                    "CHECK(norm(total_momentum(world) - total_momentum(before)).value() <= " + text_of(margin) + ");");
    }
    void judge_energy(const Operation& o, const Sight& before, const Sight& now) {
        ++judged.energy;
        const double relative = facts_.epsilon < 1e-10 ? 1e-12 : 1e-5;
        const double margin =
            relative * before.energy + (facts_.history ? 16 * now.rounding(facts_, o.dt) * now.fastest : 0);
        if (now.energy > before.energy + margin)
            found("V3: no energy from nothing",
                  "CHECK(kinetic_energy(world).value() <= kinetic_energy(before).value() + " + text_of(margin) + ");");
    }
    /// No body sleeps in the air.
    void judge_sleepers(const Sight& now, const Pairs& touching) {
        for (const auto& [body, is] : now.bodies) {
            if (is.motion != ansatz::Motion::resting || model_.bodies().at(body).laid) continue;
            ++judged.sleepers;
            const bool held = std::any_of(touching.begin(), touching.end(), [body = body](const auto& pair) {
                return pair.first == body || pair.second == body;
            });
            if (!held && !model_.is_hung(body))
                return found("no sleeper is without support",
                             "CHECK(world.motion(" + body_name(body) + ") != Motion::resting);");
        }
    }
    /// The contacts that a loop over all pairs finds, but for those that a rounding decides. A sleeper that is woken in
    /// the step itself is tested in the next.
    void judge_contacts(const Sight& before, const Sight& now, const Pairs& touching) {
        const auto awake = [&](int body) {
            return before.bodies.at(body).motion == ansatz::Motion::awake &&
                   now.bodies.at(body).motion == ansatz::Motion::awake;
        };
        for (const auto& [a, one] : model_.bodies())
            for (const auto& [b, two] : model_.bodies()) {
                if (a >= b || !one.there || !two.there || (!awake(a) && !awake(b))) continue;
                const auto first = model_.body_at(a, *world_), second = model_.body_at(b, *world_);
                const double depth = depth_of(first, second, facts_.dimension);
                const double margin = 256 * facts_.epsilon * (1 + norm(first.place) + norm(second.place));
                if (std::isnan(depth) || std::abs(depth) <= margin) continue;
                ++judged.contacts;
                const bool told = touching.contains({a, b});
                if (told != (depth > 0))
                    return found("contacts are those of all pairs", "CHECK(fuzz::touch(world, " + body_name(a) + ", " +
                                                                        body_name(b) +
                                                                        ") == " + (told ? "false" : "true") + ");");
            }
    }

    Pairs pairs() const {
        Pairs all;
        for (const auto& pair : world_->contacts()) {
            const int a = model_.name_of(pair.first), b = model_.name_of(pair.second);
            if (a >= 0 && b >= 0) all.insert({std::min(a, b), std::max(a, b)});
        }
        return all;
    }
    bool near(const Numbers& a, const Numbers& b, double margin) const {
        for (std::size_t k = 0; k < std::size_t(facts_.dimension); ++k)
            if (std::abs(a[k] - b[k]) > margin * (1 + std::abs(b[k])) + 2 * facts_.epsilon * std::abs(b[k]))
                return false;
        return true;
    }
    /// A history's velocity is made anew where forces change; it may differ by a rounding of the places.
    bool same_velocity(const Numbers& a, const Numbers& b) const {
        return facts_.history ? near(a, b, 4e5 * facts_.epsilon) : a == b;
    }

    const Facts& facts_;
    const Subject& like_;
    std::unique_ptr<Subject> world_;
    Model model_;
    std::vector<Other> others_;
    Program* program_;
    bool pushed_ = false;           // by a force, until the next step
    bool put_into_another_ = false; // a body, by a verb
    bool unbounded_ = false; // a step that was too long for a spring has made numbers infinite: nothing can be judged
    std::optional<Fault> fault_;
    Scene played_;
};

} // namespace fuzz
