// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// Tearing by a plain model: which bodies exist after a step in which springs broke, by the rules as the header says
/// them.

#include "tests/soft_bodies/letting_go.hpp"
#include "tests/soft_bodies/support.hpp"

#include <ansatz/soft_bodies/area.hpp>
#include <ansatz/soft_bodies/tearable.hpp>
#include <ansatz/soft_bodies/tearing.hpp>

#include <iterator>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace soft_tests {

template <class I, class Scalar, class Policy> auto tearing_world(const Policy& policy) {
    return World{Space<Scalar, 3>{},
                 I{},
                 Gravity{metres_per_second_squared(0, 0, 0)},
                 Springs<Breaking>{},
                 Bending{},
                 Wind{},
                 Area{},
                 policy};
}
/// A sheet that has everything on its triangles; two corners are held.
template <class World_> ClothParts add_sheet(World_& world, std::size_t n, std::size_t m) {
    auto cloth = woven(n, m);
    cloth.rigidity = 1e-4 * joule;
    cloth.drag = 0.5;
    cloth.pins = {0, std::uint32_t(n - 1)};
    const auto parts = add_cloth(world, cloth);
    for (const auto& [a, b, c] : cloth.mesh.triangles())
        world.add(Membrane{{parts.bodies[a], parts.bodies[b], parts.bodies[c]}, 5.0 * N_per_m});
    return parts;
}

using Ids = std::vector<std::uint32_t>;
template <class Of> Ids ids_of(const Of& bodies) {
    Ids all;
    for (const auto& body : bodies) all.push_back(body.id);
    return all;
}

/// As std::erase_if, which hands elements on as const.
template <class F> void erase(std::map<std::uint32_t, Ids>& all, F&& f) {
    for (auto it = all.begin(); it != all.end();) it = f(*it) ? all.erase(it) : std::next(it);
}

/// What exists, by the rules as the header says them and by testing everything.
struct Model {
    struct Triangle {
        Ids corners;
        bool torn;
        bool has(std::uint32_t body) const { return std::count(corners.begin(), corners.end(), body) > 0; }
    };
    std::map<std::uint32_t, Triangle> triangles;
    std::map<std::uint32_t, Ids> sails, membranes, hinges, springs; // their bodies

    template <class World_> static Model of(const World_& world) {
        Model model;
        world.template elements<TearableTriangle>().for_each([&](std::uint32_t id, const auto& row) {
            model.triangles[id] = {ids_of(row.corners), row.torn};
        });
        world.template elements<Sail>().for_each(
            [&](std::uint32_t id, const auto& row) { model.sails[id] = ids_of(row.corners); });
        world.template elements<Membrane>().for_each(
            [&](std::uint32_t id, const auto& row) { model.membranes[id] = ids_of(row.corners); });
        world.template elements<Hinge>().for_each(
            [&](std::uint32_t id, const auto& row) { model.hinges[id] = ids_of(row.bodies); });
        world.template elements<Spring>().for_each([&](std::uint32_t id, const auto& link) {
            model.springs[id] = {link.a, link.b};
        });
        return model;
    }
    bool operator==(const Model& other) const {
        const auto same = [](const Triangle& a, const Triangle& b) {
            return a.corners == b.corners && a.torn == b.torn;
        };
        return sails == other.sails && membranes == other.membranes && hinges == other.hinges &&
               springs == other.springs && triangles.size() == other.triangles.size() &&
               std::equal(triangles.begin(), triangles.end(), other.triangles.begin(),
                          [&](const auto& a, const auto& b) { return a.first == b.first && same(a.second, b.second); });
    }
    const Triangle* with(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        for (const auto& [id, triangle] : triangles)
            if (triangle.has(a) && triangle.has(b) && triangle.has(c)) return &triangle;
        return nullptr;
    }
    bool edge(std::uint32_t a, std::uint32_t b) const {
        for (const auto& [id, triangle] : triangles)
            if (triangle.has(a) && triangle.has(b)) return true;
        return false;
    }
    void tear(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& broken) {
        for (const auto& [a, b] : broken)
            for (auto& [id, triangle] : triangles)
                triangle.torn = triangle.torn || (triangle.has(a) && triangle.has(b));
        erase(sails, [&](const auto& s) { return with(s.second[0], s.second[1], s.second[2])->torn; });
        erase(membranes, [&](const auto& s) { return with(s.second[0], s.second[1], s.second[2])->torn; });
        erase(hinges, [&](const auto& h) {
            return with(h.second[0], h.second[1], h.second[2])->torn ||
                   with(h.second[0], h.second[1], h.second[3])->torn;
        });
        erase(springs, [&](const auto& s) {
            if (edge(s.second[0], s.second[1])) return false;
            for (const auto& [id, triangle] : triangles)
                for (const bool turned : {false, true}) {
                    const auto near = s.second[turned], far = s.second[!turned];
                    if (!triangle.torn || !triangle.has(near)) continue;
                    for (const auto middle : triangle.corners)
                        if (middle != near && edge(middle, far)) return true;
                }
            return false;
        });
    }
    /// The sides of a vertex: sets of triangles that hang together by edges, by their first ones.
    std::vector<Ids> sides(std::uint32_t body) const {
        std::vector<Ids> all;
        std::set<std::uint32_t> left;
        for (const auto& [id, triangle] : triangles)
            if (!triangle.torn && triangle.has(body)) left.insert(id);
        while (!left.empty()) {
            Ids side{*left.begin()};
            left.erase(left.begin());
            for (std::size_t k = 0; k < side.size(); ++k)
                for (auto it = left.begin(); it != left.end();) {
                    int shared = 0;
                    for (const auto corner : triangles.at(*it).corners) shared += triangles.at(side[k]).has(corner);
                    if (shared == 2) {
                        side.push_back(*it);
                        it = left.erase(it);
                    } else ++it;
                }
            all.push_back(side);
        }
        return all;
    }
    /// \param parts the new bodies in the order in which they came
    /// \return how many sides found no room
    std::size_t split(const std::set<std::uint32_t>& held, const std::vector<SplitVertex>& parts) {
        const auto before = *this;
        std::size_t used = 0, waiting = 0;
        std::set<std::uint32_t> bodies;
        for (const auto& [id, triangle] : triangles) bodies.insert(triangle.corners.begin(), triangle.corners.end());
        for (const auto body : bodies) {
            if (held.count(body) > 0) continue;
            const auto all = before.sides(body);
            for (std::size_t k = 1; k < all.size(); ++k) {
                if (used == parts.size()) {
                    ++waiting;
                    continue;
                }
                CHECK(parts[used].from.id == body);
                for (const auto id : all[k])
                    std::replace(triangles[id].corners.begin(), triangles[id].corners.end(), body, parts[used].to.id);
                ++used;
            }
        }
        CHECK(used == parts.size());
        const auto now = [&](std::uint32_t triangle, std::uint32_t body) {
            const auto& were = before.triangles.at(triangle).corners;
            return triangles.at(triangle)
                .corners[std::size_t(std::find(were.begin(), were.end(), body) - were.begin())];
        };
        const auto which = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            for (const auto& [id, triangle] : before.triangles)
                if (triangle.has(a) && triangle.has(b) && triangle.has(c)) return id;
            return 0xffffffffu;
        };
        for (auto* all : {&sails, &membranes})
            for (auto& [id, s] : *all) {
                const auto t = which(s[0], s[1], s[2]);
                s = {now(t, s[0]), now(t, s[1]), now(t, s[2])};
            }
        for (auto& [id, h] : hinges) {
            const auto t = which(h[0], h[1], h[2]), u = which(h[0], h[1], h[3]);
            CHECK(now(t, h[0]) == now(u, h[0])); // an edge that is whole is not divided
            h = {now(t, h[0]), now(t, h[1]), now(t, h[2]), now(u, h[3])};
        }
        erase(springs, [&](auto& spring) {
            auto& s = spring.second;
            const bool is_edge = before.edge(s[0], s[1]);
            bool across = false;
            for (const auto& [t, one] : before.triangles) {
                if (one.torn || !one.has(s[0])) continue;
                if (is_edge && one.has(s[1])) {
                    s = {now(t, s[0]), now(t, s[1])};
                    return false;
                }
                if (is_edge) continue;
                for (const auto& [u, other] : before.triangles)
                    for (const auto middle : one.corners)
                        if (!other.torn && other.has(s[1]) && middle != s[0] && other.has(middle)) {
                            across = true;
                            if (now(t, middle) != now(u, middle)) continue;
                            s = {now(t, s[0]), now(u, s[1])};
                            return false;
                        }
            }
            return across;
        });
        return waiting;
    }
};

template <class World_> VectorQuantity<unit::Momentum> momentum_of(const World_& world) {
    VectorQuantity<unit::Momentum> sum{};
    world.for_each([&](Handle body) {
        if (world.motion(body) == Motion::awake)
            sum += scalar_cast<double>(world.mass(body)) * scalar_cast<double>(world.velocity(body));
    });
    return sum;
}
/// The area of the triangles at a body that are not torn.
template <class World_> double whole_area_at(const World_& world, Handle body) {
    double sum = 0;
    world.template elements<TearableTriangle>().for_each([&](std::uint32_t, const auto& row) {
        if (!row.torn && row.has(body.id)) sum += double(row.area.value());
    });
    return sum;
}
template <class World_> void shake(World_& world, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-0.2, 0.2);
    for (const Handle body : world.handles())
        if (world.motion(body) == Motion::awake)
            world.set_velocity(body, metres_per_second(number(random), number(random), number(random)));
}
/// What a step with breaks makes of a model.
template <class World_> std::size_t follow(Model& model, const World_& world, const std::set<std::uint32_t>& held) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> broken;
    for (const auto& one : world.template elements<Spring>().broken()) {
        broken.push_back({one.first.body().id, one.second.body().id});
        model.springs.erase(one.which.id);
    }
    std::vector<bool> were;
    for (const auto& [id, triangle] : model.triangles) were.push_back(triangle.torn);
    auto torn = model;
    torn.tear(broken);
    bool any = false;
    std::size_t i = 0;
    for (const auto& [id, triangle] : torn.triangles) any = any || triangle.torn != were[i++];
    if (!any) return 0xffff; // only a thread, or a spring across
    model = torn;
    if constexpr (requires { world.split_vertices(); }) {
        const auto parts = world.split_vertices();
        return model.split(held, {parts.begin(), parts.end()});
    }
    return 0;
}

} // namespace soft_tests
