// SPDX-License-Identifier: BSL-1.0
// Bytes a body of settled piles. The script of this name says what it shows.
#include <ansatz/collision.hpp>
#include <ansatz/motion.hpp>
#include <ansatz/world.hpp>

#include "tests/peers/collision/pile.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>

static std::size_t bytes_held = 0; // bytes that were asked for and not given back

/// In front of each block stands its size.
static void* take(std::size_t bytes, std::size_t front) {
    char* const all = static_cast<char*>(std::aligned_alloc(front, (front + bytes + front - 1) / front * front));
    if (all == nullptr) throw std::bad_alloc();
    *reinterpret_cast<std::size_t*>(all) = bytes;
    bytes_held += bytes;
    return all + front;
}
static void give_back(void* p, std::size_t front) noexcept {
    if (p == nullptr) return;
    char* const all = static_cast<char*>(p) - front;
    bytes_held -= *reinterpret_cast<std::size_t*>(all);
    std::free(all);
}
static constexpr std::size_t plain = __STDCPP_DEFAULT_NEW_ALIGNMENT__;
void* operator new(std::size_t n) { return take(n, plain); }
void* operator new[](std::size_t n) { return take(n, plain); }
void* operator new(std::size_t n, std::align_val_t a) { return take(n, std::size_t(a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return take(n, std::size_t(a)); }
void operator delete(void* p) noexcept { give_back(p, plain); }
void operator delete[](void* p) noexcept { give_back(p, plain); }
void operator delete(void* p, std::size_t) noexcept { give_back(p, plain); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p, plain); }
void operator delete(void* p, std::align_val_t a) noexcept { give_back(p, std::size_t(a)); }
void operator delete[](void* p, std::align_val_t a) noexcept { give_back(p, std::size_t(a)); }
void operator delete(void* p, std::size_t, std::align_val_t a) noexcept { give_back(p, std::size_t(a)); }
void operator delete[](void* p, std::size_t, std::align_val_t a) noexcept { give_back(p, std::size_t(a)); }

using namespace ansatz;
using peers::Pile;

static bool all_within = true;

/// \param most bytes a body
template <class... P> void pile(const char* name, double most, P... policies) {
    constexpr int bodies = 1000;
    const Pile pile = Pile::of(bodies);
    const std::size_t before = bytes_held;
    World world{Space<float, 3>{}, SemiImplicitEuler{}, Gravity{}, Narrowphase<Sphere, Plane>{}, policies...};
    world.reserve(bodies + 5);
    world.add(Plane::ground(), fixed);
    for (const double side : {-1.0, 1.0}) {
        world.add(Plane{Eigen::Vector3d(side, 0, 0), -pile.half_side * metre}, fixed);
        world.add(Plane{Eigen::Vector3d(0, 0, side), -pile.half_side * metre}, fixed);
    }
    for (const auto& x : pile.start)
        world.add(Sphere{Pile::radius * metre}, position(metres(x[0], x[1], x[2])), mass(Pile::mass * kilogram));
    for (int step = 0; step < 300; ++step) world.step(Pile::dt * second);
    const double contacts = double(world.contacts().size()) / bodies, bytes = double(bytes_held - before) / bodies;
    std::printf("%s: %.2f contacts and %.0f bytes a body, at most %.0f\n", name, contacts, bytes, most);
    if (contacts < 2.5) std::printf("%s: too few contacts: the case has lost its point\n", name);
    all_within = all_within && contacts >= 2.5 && bytes <= most;
}

int main() {
    pile("UniformGrid, SoftSubsteps", 915, UniformGrid<>{}, SoftSubsteps<>{});
    pile("UniformGrid, SoftSubsteps<Friction>", 980, UniformGrid<>{}, SoftSubsteps<Friction>{});
    pile("Coherent, SoftSubsteps<Coloured>", 1470, Coherent<UniformGrid<>>{}, SoftSubsteps<Coloured>{});
    return all_within ? 0 : 1;
}
