// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// A scene as a program: the lines that somebody would write who builds it by hand.

#include "tests/fuzz/subject.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

/// A number as C++ writes it, with no digit that is not needed.
inline std::string text_of(double x) {
    if (std::isnan(x)) return "std::nan(\"\")";
    if (std::isinf(x)) return x > 0 ? "HUGE_VAL" : "-HUGE_VAL";
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, x == 0 ? 0.0 : x).ptr;
    std::string text(digits, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}
/// `metres(1, 0.5, 0)`
inline std::string text_of(const char* unit, const Numbers& v, int dimension) {
    std::string text = std::string(unit) + "(";
    for (int k = 0; k < dimension; ++k) {
        auto number = text_of(v[std::size_t(k)]);
        if (number.size() > 2 && number.ends_with(".0")) number.resize(number.size() - 2);
        text += (k > 0 ? ", " : "") + number;
    }
    return text + ")";
}
/// `{1, 0.5, 0}`
inline std::string list_of(const Numbers& v) {
    return "{" + text_of("", v, 3).substr(1, text_of("", v, 3).size() - 2) + "}";
}
inline std::string body_name(int body) { return "b" + std::to_string(body); }
inline std::string spring_name(int spring) { return "s" + std::to_string(spring); }

/// `world.add(...)`, without what it is assigned to.
inline std::string text_of_add(const Operation& o, const Facts& facts) {
    const int dimension = facts.dimension;
    std::string text;
    const auto put = [&](const std::string& property) { text += (text.empty() ? "" : ", ") + property; };
    const auto size = text_of(o.size);
    const bool shaped = facts.collides && o.shape != Shape::none;
    if (facts.collides) switch (o.shape) {
        case Shape::sphere: put("Sphere{" + size + " * metre}"); break;
        case Shape::box: put("Box{" + text_of("metres", {o.size, o.size, o.size}, dimension) + "}"); break;
        case Shape::plane: {
            Numbers normal{};
            normal[std::size_t(o.axis)] = 1;
            put("Plane{" + text_of("Eigen::Vector3d", normal, 3) + ", " + text_of(-o.size) + " * metre}");
            break;
        }
        case Shape::none: put("shapeless"); break;
        }
    if (!shaped || o.shape != Shape::plane) put("position(" + text_of("metres", o.place, dimension) + ")");
    const auto velocity = "velocity(" + text_of("metres_per_second", o.vector, dimension) + ")";
    const auto mass = "mass(" + text_of(o.mass) + " * kilogram)";
    switch (o.kind) {
    case Kind::fixed: put("fixed"); break;
    case Kind::moving: put(velocity), put("moving"); break;
    case Kind::resting: put("resting"), put(mass); break;
    case Kind::awake:
        put(velocity);
        put(mass);
        if (facts.restitution && shaped) put("restitution(" + text_of(o.restitution) + ")");
    }
    if (facts.friction && shaped) put("friction(0.5)");
    put("datum(" + std::to_string(o.body) + ")");
    return "add(" + text + ")";
}
/// The call, such as `wake(b1)`.
inline std::string call_of(const Operation& o, const Facts& facts) {
    const auto body = body_name(o.body);
    const auto with = [&](const char* verb, const char* unit, const Numbers& v) {
        return std::string(verb) + "(" + body + ", " + text_of(unit, v, facts.dimension) + ")";
    };
    switch (o.verb) {
    case Verb::add: return text_of_add(o, facts);
    case Verb::remove: return "remove(" + body + ")";
    case Verb::set_position: return with("set_position", "metres", o.place);
    case Verb::set_velocity: return with("set_velocity", "metres_per_second", o.vector);
    case Verb::set_mass: return "set_mass(" + body + ", " + text_of(o.mass) + " * kilogram)";
    case Verb::set_restitution:
        return "write<Restitution>(" + body + ", Quantity<unit::Dimensionless>(" + text_of(o.restitution) + "))";
    case Verb::apply_force: return with("apply_force", "newtons", o.vector);
    case Verb::apply_impulse: return with("apply_impulse", "newton_seconds", o.vector);
    case Verb::wake: return "wake(" + body + ")";
    case Verb::add_spring:
        return "add(Spring{" + body + ", " +
               (o.second >= 0 ? body_name(o.second) : text_of("metres", o.place, facts.dimension)) + ", " +
               text_of(o.stiffness) + " * newton_per_metre, " + text_of(o.damping) + " * newton_second_per_metre})";
    case Verb::remove_spring: return "remove(" + spring_name(o.spring) + ")";
    case Verb::step:
    case Verb::again: return "step(" + text_of(o.dt) + " * second)";
    case Verb::copy:
    case Verb::load: break;
    }
    return "";
}

/// The lines of a program, as they are played.
class Program {
public:
    /// \param check the line that fails: what it does not name is left out
    Program(const Facts& facts, std::string check) : facts_(facts), check_(std::move(check)) {
        line(facts.type + " world{" + facts.text + "};");
        if (names("other")) line(facts.type + " other{" + facts.other + "};");
    }
    void line(const std::string& text) { lines_.push_back(text); }
    /// An operation begins: `before` is the world as it is now.
    void begin() { last_ = lines_.size(); }
    /// One operation, in a world of this name; the first world's bodies have the names.
    /// \param refused whether the world must refuse it
    void call(const Operation& o, const std::string& world, bool refused) {
        if (world != "world" && !names(world)) return;
        std::string made;
        if (world == "world" && o.verb == Verb::add) made = "const auto " + body_name(o.body) + " = ";
        if (world == "world" && o.verb == Verb::add_spring) made = "const auto " + spring_name(o.spring) + " = ";
        const std::string call = world + "." + call_of(o, facts_);
        const std::string loop = o.times > 1 ? "for (int i = 0; i < " + std::to_string(o.times) + "; ++i) " : "";
        line(refused ? "CHECK_THROWS(" + call + ");" : loop + made + call + ";");
    }
    /// A test case that can be pasted into a file that includes tests/fuzz/pasted.hpp.
    std::string text(const std::string& name) const {
        auto lines = lines_;
        if (names("before")) lines.insert(lines.begin() + std::ptrdiff_t(last_), "const auto before = world;");
        if (lines.back() != check_) lines.push_back(check_);
        for (std::size_t i = 0; i < lines.size(); ++i) leave_out_name(lines, i);
        std::string all = "TEST_CASE(\"" + name + "\", \"[fuzz]\") {\n";
        for (const auto& one : lines) all += "    " + one + "\n";
        return all + "}\n";
    }

private:
    bool names(const std::string& what) const { return has_word(check_, what); }
    static bool has_word(const std::string& text, const std::string& word) {
        const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
        for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
            const auto end = at + word.size();
            if ((at == 0 || !in_name(text[at - 1])) && (end == text.size() || !in_name(text[end]))) return true;
        }
        return false;
    }
    /// A body that nobody speaks of needs no name.
    static void leave_out_name(std::vector<std::string>& lines, std::size_t i) {
        const std::string constant = "const auto ";
        const auto equals = lines[i].find(" = world.add");
        if (!lines[i].starts_with(constant) || equals == std::string::npos) return;
        const auto name = lines[i].substr(constant.size(), equals - constant.size());
        for (std::size_t k = i + 1; k < lines.size(); ++k)
            if (has_word(lines[k], name)) return;
        lines[i].erase(0, equals + 3);
    }

    const Facts& facts_;
    std::string check_;
    std::vector<std::string> lines_;
    std::size_t last_ = 0;
};

} // namespace fuzz
