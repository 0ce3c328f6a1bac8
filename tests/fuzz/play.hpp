// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A scene, played and judged: by a plain model of who is there, and by laws that hold whatever happens.

#include "tests/fuzz/allocations.hpp"
#include "tests/fuzz/geometry.hpp"
#include "tests/fuzz/program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

/// A law that was broken.
struct Fault {
    std::string law;    ///< which one: the shrinker looks for the same
    std::size_t at = 0; ///< the operation
    std::string check;  ///< the line of C++ that fails
};

/// How often each law was judged: one that never was has held nothing.
struct Judged {
    std::uint64_t steps = 0, refusals = 0, copies = 0, loads = 0, taken_back = 0, contacts = 0, sleepers = 0,
                  momentum = 0, energy = 0;
};
inline Judged judged; // in this program

/// Plays one scene once.
class Play {
public:
    /// \param program takes the lines, if there is one
    explicit Play(const Subject& like, Program* program = nullptr)
        : facts_(like.facts()), like_(like), world_(like.fresh(false)), program_(program) {
        if (facts_.collides) others_.push_back({like.fresh(true), "other", "another broadphase: the same bits"});
    }

    std::optional<Fault> run(const Scene& scene) {
        for (at_ = 0; at_ < scene.size() && !fault_ && !over_; ++at_) {
            Operation o = scene[at_];
            if (!usable(o)) continue;
            if (program_ != nullptr) program_->begin();
            const int times = std::exchange(o.times, 1);
            if (times > 1 && program_ != nullptr) write(scene[at_], must_be_refused(o));
            Program* const program = times > 1 ? std::exchange(program_, nullptr) : program_;
            for (int i = 0; i < times && !fault_ && !over_; ++i) one(o);
            program_ = program;
        }
        return fault_;
    }
    /// Which operations of a scene meant something, one step at a time.
    const Scene& played() const { return played_; }

private:
    struct Known {
        bool there = true, heavy = true; // heavy: of a finite mass
        Operation as;                    // how it was added, its place and so on as they are now
        bool laid = false;               // asleep from the beginning, and not yet woken
    };
    struct Other {
        std::unique_ptr<Subject> world;
        std::string name, law;
    };
    /// What is looked at of a body.
    struct Seen {
        Numbers place{}, velocity{};
        double mass = 0, restitution = 0;
        ansatz::Motion motion{};
        friend bool operator==(const Seen&, const Seen&) = default;
    };

    bool is_there(int body) const {
        const auto found = known_.find(body);
        return found != known_.end() && found->second.there;
    }
    ansatz::Handle handle(int body) const { return names_.bodies[std::size_t(body)]; }
    bool has_spring(int spring) const { return springs_.contains(spring); }

    /// Whether an operation means anything here: a scene may have lost the line that made its body.
    bool usable(const Operation& o) const {
        const bool was = known_.contains(o.body);
        switch (o.verb) {
        case Verb::add: return !was;
        case Verb::set_mass:
        case Verb::apply_impulse: return facts_.mass && was;
        case Verb::set_restitution: return facts_.restitution && was;
        case Verb::apply_force: return facts_.applied && was;
        case Verb::add_spring:
            return facts_.springs && was && !has_spring(o.spring) && (o.second < 0 || known_.contains(o.second)) &&
                   o.second != o.body && !all_springs_.contains(o.spring);
        case Verb::remove_spring: return facts_.springs && all_springs_.contains(o.spring);
        case Verb::remove:
        case Verb::set_position:
        case Verb::set_velocity:
        case Verb::wake: return was;
        case Verb::copy:
        case Verb::load:
            return std::none_of(others_.begin(), others_.end(), [&](const Other& other) {
                return other.name == (o.verb == Verb::copy ? "copy" : "loaded");
            });
        case Verb::step:
        case Verb::again: return true;
        }
        return true;
    }
    bool must_be_refused(const Operation& o) const {
        if (!acceptable(o, facts_.dimension)) return true;
        switch (o.verb) {
        case Verb::set_velocity: return !is_there(o.body) || known_.at(o.body).as.kind == Kind::fixed;
        case Verb::set_mass: return !is_there(o.body) || !known_.at(o.body).heavy;
        case Verb::remove:
        case Verb::set_position:
        case Verb::set_restitution:
        case Verb::apply_force:
        case Verb::apply_impulse:
        case Verb::wake: return !is_there(o.body);
        case Verb::add_spring: return !is_there(o.body) || (o.second >= 0 && !is_there(o.second));
        case Verb::remove_spring: return !has_spring(o.spring);
        default: return false;
        }
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
        if (!fault_) fault_ = Fault{law, at_, check};
    }

    void one(const Operation& o) {
        played_.push_back(o);
        if (o.verb == Verb::copy) return copy();
        if (o.verb == Verb::load) return load();
        if (o.verb == Verb::again) return again(o);
        const bool refused = must_be_refused(o);
        const auto hash = world_->hash();
        const auto before = see();
        const auto momentum = total_momentum();
        const double energy = kinetic_energy();
        const bool quiet = nobody_rests();
        write(o, refused);
        try {
            world_->perform(o, names_);
            if (refused) return found("bad input is refused", "CHECK_THROWS(world." + call_of(o, facts_) + ");");
        } catch (const std::exception& e) {
            if (!refused) return found("what is right is taken", "CHECK_NOTHROW(world." + call_of(o, facts_) + ");");
        }
        follow(o, refused);
        judged.refusals += refused;
        judged.steps += o.verb == Verb::step;
        if (refused && world_->hash() != hash)
            return found("a refusal changes nothing", "CHECK(world.hash() == before.hash());");
        for (const auto& other : others_) {
            try {
                other.world->perform(o, names_);
            } catch (const std::exception&) {
            }
            if (other.world->hash() != world_->hash())
                return found(other.law, "CHECK(" + other.name + ".hash() == world.hash());");
        }
        judge_who_is_there();
        if (fault_ || refused) return;
        if (o.verb == Verb::step) {
            judge_step(o, before, momentum, energy, quiet);
        } else {
            judge_verb(o, before, hash);
        }
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
        if (must_be_refused(o)) return;
        ++judged.taken_back;
        const auto snapshot = world_->copy();
        std::uint64_t hash = 0;
        const auto step = "world." + call_of(o, facts_) + ";";
        line("const auto snapshot = world;");
        for (int i = 0; i < 4 && !fault_; ++i) {
            std::size_t allocations = 0;
            try {
                allocations = allocations_of([&] { world_->perform(o, names_); });
            } catch (const std::exception&) {
                return found("what is right is taken", "CHECK_NOTHROW(" + step + ");");
            }
            const bool warm = i == 3; // some lists change places with each other from step to step
            if (warm && allocations > 0)
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

    /// What the model knows after an operation.
    void follow(const Operation& o, bool refused) {
        if (refused) return;
        if (o.verb == Verb::add) {
            auto& known = known_[o.body];
            known.as = o;
            known.heavy = o.kind == Kind::awake || o.kind == Kind::resting;
            known.laid = o.kind == Kind::resting;
            if (facts_.collides && o.shape == Shape::plane) known.heavy = false, known.as.kind = Kind::fixed;
        }
        if (o.verb == Verb::apply_force) pushed_ = true;
        if (o.verb == Verb::remove) {
            known_.at(o.body).there = false;
            std::erase_if(springs_,
                          [&](const auto& s) { return s.second.first == o.body || s.second.second == o.body; });
        }
        if (o.verb == Verb::add_spring) springs_[o.spring] = {o.body, o.second}, all_springs_.insert(o.spring);
        if (o.verb == Verb::remove_spring) springs_.erase(o.spring);
        if ((o.verb == Verb::add || o.verb == Verb::set_position) && overlaps(o.body)) put_into_another_ = true;
    }

    void judge_who_is_there() {
        std::size_t size = 0;
        for (const auto& [body, known] : known_) {
            const auto name = body_name(body);
            size += known.there;
            if (world_->contains(handle(body)) != known.there)
                return found("who is there",
                             "CHECK(world.contains(" + name + ") == " + (known.there ? "true" : "false") + ");");
            if (known.there && world_->datum(handle(body)) != body)
                return found("whose datum it is", "CHECK(world.datum(" + name + ") == " + std::to_string(body) + ");");
        }
        if (world_->size() != size) found("who is there", "CHECK(world.size() == " + std::to_string(size) + ");");
        for (const int spring : all_springs_)
            if (world_->contains_spring(names_.springs[std::size_t(spring)]) != has_spring(spring))
                return found("which springs are there", "CHECK(world.contains(" + spring_name(spring) +
                                                            ") == " + (has_spring(spring) ? "true" : "false") + ");");
    }

    /// A verb changes whom it is done to, and nobody else; what it changes shows in the hash.
    void judge_verb(const Operation& o, const std::map<int, Seen>& before, std::uint64_t hash) {
        const auto now = see();
        for (const auto& [body, was] : before) {
            if (body == o.body || !now.contains(body)) continue;
            const auto& is = now.at(body);
            const auto b = body_name(body);
            if (is.place != was.place)
                return found("a verb touches nobody else",
                             "CHECK(world.position(" + b + ") == before.position(" + b + "));");
            if (!same_velocity(is.velocity, was.velocity))
                return found("a verb touches nobody else",
                             "CHECK(world.velocity(" + b + ") == before.velocity(" + b + "));");
            if (is.mass != was.mass)
                return found("a verb touches nobody else", "CHECK(world.mass(" + b + ") == before.mass(" + b + "));");
            if (is.restitution != was.restitution)
                return found("a verb touches nobody else",
                             "CHECK(world.read<Restitution>(" + b + ") == before.read<Restitution>(" + b + "));");
        }
        const auto it = before.find(o.body);
        if (it != before.end() && now.contains(o.body) && !(now.at(o.body) == it->second) && world_->hash() == hash)
            return found("every number counts in the hash", "CHECK(world.hash() != before.hash());");
        if (o.verb == Verb::set_position && !near(now.at(o.body).place, o.place, 0))
            found("a verb does what it says", "CHECK(norm(world.position(" + body_name(o.body) + ") - " +
                                                  text_of("metres", o.place, facts_.dimension) + ").value() < 1e-5);");
        if (o.verb == Verb::set_velocity && !near(now.at(o.body).velocity, o.vector, facts_.history ? 1e-3 : 0))
            found("a verb does what it says", "CHECK(norm(world.velocity(" + body_name(o.body) + ") - " +
                                                  text_of("metres_per_second", o.vector, facts_.dimension) +
                                                  ").value() < 1e-5);");
        if (o.verb == Verb::wake && world_->motion(handle(o.body)) == ansatz::Motion::resting)
            found("a verb does what it says", "CHECK(world.motion(" + body_name(o.body) + ") != Motion::resting);");
        note_woken();
    }

    void judge_step(const Operation& o, const std::map<int, Seen>& before, const Numbers& momentum, double energy,
                    bool quiet) {
        const bool pushed = std::exchange(pushed_, false);
        if (o.dt == 0) return;
        if (!world_->ok()) {
            over_ = !facts_.bounded;
            if (facts_.bounded) found("every number is finite", "CHECK(world.status().ok());");
            return;
        }
        const auto now = see();
        for (const auto& [body, is] : now) {
            const auto b = body_name(body);
            const auto& was = before.at(body);
            const bool slept = is.motion == ansatz::Motion::resting;
            if (slept && is.velocity != Numbers{})
                return found("a sleeper has no velocity", "CHECK(norm(world.velocity(" + b + ")).value() == 0);");
            if (slept && was.motion == ansatz::Motion::resting && is.place != was.place)
                return found("a sleeper stays where it is",
                             "CHECK(world.position(" + b + ") == before.position(" + b + "));");
            if (was.motion == ansatz::Motion::fixed && is.place != was.place)
                return found("a fixed body stays where it is",
                             "CHECK(world.position(" + b + ") == before.position(" + b + "));");
        }
        note_woken();
        const auto touching = pairs();
        if (facts_.falls && facts_.rests) judge_sleepers(now, touching);
        if (fault_) return;
        if (facts_.collides && facts_.stays) judge_contacts(touching);
        if (fault_) return;
        const bool alone =
            std::all_of(known_.begin(), known_.end(), [](const auto& k) { return !k.second.there || k.second.heavy; });
        bool anchored = false;
        for (const auto& [spring, ends] : springs_) anchored = anchored || ends.second < 0;
        if (facts_.mass && facts_.closed && alone && !anchored && !pushed && quiet && nobody_rests())
            judge_momentum(o, momentum);
        const bool platforms = std::any_of(known_.begin(), known_.end(), [](const auto& k) {
            return k.second.there && k.second.as.kind == Kind::moving;
        });
        if (facts_.mass && facts_.keeps_energy && springs_.empty() && !pushed && !platforms &&
            !(facts_.soft && put_into_another_))
            judge_energy(o, energy);
    }
    void judge_momentum(const Operation& o, const Numbers& before) {
        ++judged.momentum;
        const auto now = total_momentum();
        const double margin = rounding(o.dt) * 64;
        for (int k = 0; k < facts_.dimension; ++k)
            if (std::abs(now[std::size_t(k)] - before[std::size_t(k)]) > margin)
                return found(
                    "momentum is kept",
                    "CHECK(norm(total_momentum(world) - total_momentum(before)).value() <= " + text_of(margin) + ");");
    }
    void judge_energy(const Operation& o, double before) {
        ++judged.energy;
        double fastest = 0;
        for (const auto& [body, is] : see()) fastest = std::max(fastest, norm(is.velocity));
        const double relative = facts_.epsilon < 1e-10 ? 1e-12 : 1e-5;
        const double margin = relative * before + (facts_.history ? rounding(o.dt) * fastest * 16 : 0);
        if (kinetic_energy() > before + margin)
            found("V3: no energy from nothing",
                  "CHECK(kinetic_energy(world).value() <= kinetic_energy(before).value() + " + text_of(margin) + ");");
    }
    /// Nobody sleeps in the air.
    void judge_sleepers(const std::map<int, Seen>& now, const std::set<std::pair<int, int>>& touching) {
        for (const auto& [body, is] : now) {
            if (is.motion != ansatz::Motion::resting || known_.at(body).laid) continue;
            ++judged.sleepers;
            bool held = false;
            for (const auto& [a, b] : touching) held = held || a == body || b == body;
            for (const auto& [spring, ends] : springs_) held = held || ends.first == body || ends.second == body;
            if (!held)
                return found("no sleeper is without support",
                             "CHECK(world.motion(" + body_name(body) + ") != Motion::resting);");
        }
    }
    /// The contacts that a loop over all pairs finds, but for those that a rounding decides.
    void judge_contacts(const std::set<std::pair<int, int>>& touching) {
        for (const auto& [a, one] : known_)
            for (const auto& [b, two] : known_) {
                if (a >= b || !one.there || !two.there) continue;
                if (!active(a) && !active(b)) continue;
                const double depth = depth_of(body_at(a), body_at(b), facts_.dimension);
                const double margin = 256 * facts_.epsilon * (1 + norm(body_at(a).place) + norm(body_at(b).place));
                if (std::isnan(depth) || std::abs(depth) <= margin) continue;
                ++judged.contacts;
                const bool told = touching.contains({a, b});
                if (told != (depth > 0))
                    return found("contacts are those of all pairs", std::string("CHECK(fuzz::touch(world, ") +
                                                                        body_name(a) + ", " + body_name(b) +
                                                                        ") == " + (told ? "false" : "true") + ");");
            }
    }

    bool active(int body) const { return world_->motion(handle(body)) == ansatz::Motion::awake; }
    Body body_at(int body) const {
        const auto& as = known_.at(body).as;
        return {as.shape, as.axis, as.size, world_->position(handle(body))};
    }
    bool overlaps(int body) const {
        if (!facts_.collides) return false;
        for (const auto& [b, known] : known_)
            if (b != body && known.there && depth_of(body_at(body), body_at(b), facts_.dimension) > -1e-6) return true;
        return false;
    }
    std::set<std::pair<int, int>> pairs() const {
        std::set<std::pair<int, int>> all;
        for (const auto& pair : world_->contacts()) {
            const int a = name_of(pair.first), b = name_of(pair.second);
            if (a >= 0 && b >= 0) all.insert({std::min(a, b), std::max(a, b)});
        }
        return all;
    }
    int name_of(const ansatz::Handle& body) const {
        for (const auto& [name, known] : known_)
            if (known.there && handle(name) == body) return name;
        return -1;
    }
    void note_woken() {
        for (auto& [body, known] : known_)
            if (known.there && world_->motion(handle(body)) != ansatz::Motion::resting) known.laid = false;
    }
    bool nobody_rests() const {
        return std::none_of(known_.begin(), known_.end(), [&](const auto& k) {
            return k.second.there && world_->motion(handle(k.first)) == ansatz::Motion::resting;
        });
    }
    std::map<int, Seen> see() const {
        std::map<int, Seen> all;
        for (const auto& [body, known] : known_)
            if (known.there) {
                const auto h = handle(body);
                all[body] = {world_->position(h), world_->velocity(h), world_->mass(h), world_->restitution(h),
                             world_->motion(h)};
            }
        return all;
    }
    Numbers total_momentum() const {
        Numbers sum{};
        for (const auto& [body, is] : see())
            for (std::size_t k = 0; k < 3; ++k) sum[k] += is.mass * is.velocity[k];
        return sum;
    }
    double kinetic_energy() const {
        double sum = 0;
        for (const auto& [body, is] : see()) sum += is.mass * norm(is.velocity) * norm(is.velocity) / 2;
        return sum;
    }
    /// What the roundings of a step may do to the momentum, kg m/s.
    double rounding(double dt) const {
        double sum = 0;
        for (const auto& [body, is] : see())
            sum += is.mass * facts_.epsilon * (norm(is.velocity) + (facts_.history ? norm(is.place) / dt : 0));
        return sum;
    }
    bool near(const Numbers& a, const Numbers& b, double margin) const {
        for (int k = 0; k < facts_.dimension; ++k) {
            const double x = a[std::size_t(k)], y = b[std::size_t(k)];
            if (std::abs(x - y) > margin * (1 + std::abs(y)) + 2 * facts_.epsilon * std::abs(y)) return false;
        }
        return true;
    }
    /// A history's velocity is made anew where forces change; it may differ by a rounding of the places.
    bool same_velocity(const Numbers& a, const Numbers& b) const {
        return facts_.history ? near(a, b, facts_.epsilon < 1e-10 ? 1e-9 : 1e-2) : a == b;
    }

    const Facts& facts_;
    const Subject& like_;
    std::unique_ptr<Subject> world_;
    std::vector<Other> others_;
    Program* program_;
    Names names_;
    std::map<int, Known> known_;
    std::map<int, std::pair<int, int>> springs_;
    std::set<int> all_springs_;
    bool over_ = false; // an unstable step has made its numbers infinite: nothing more can be judged
    bool pushed_ = false, put_into_another_ = false;
    std::size_t at_ = 0;
    std::optional<Fault> fault_;
    Scene played_;
};

} // namespace fuzz
