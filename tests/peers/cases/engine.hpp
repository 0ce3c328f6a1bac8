// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What `peers cases` asks of an engine: a world of balls, planes, upright boxes and springs, and nothing beside them.
///
/// A row is written once against this interface (rows.hpp), so that scene and measure are the same for everybody; an
/// engine is written once against its own library (ansatz.cpp, bullet.cpp, ode.cpp, box2d.cpp), with its settings in
/// one place. Nobody's balls turn, since ours do not. In a flat engine the third axis is left out.

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace peers {

using Vector = Eigen::Vector3d; // m, m/s, N; y is up

/// What a world is told before anybody is in it. SI units.
struct Scene {
    double dt = 1.0 / 60;
    Vector gravity{0, -9.81, 0};
    double size = 1;             ///< lengths of the scene are multiples of it: thresholds that are lengths go along
    double bounces_above = 0.25; ///< slower approaches do not bounce
    bool sleeps = false;
    double slow = 0.05, slow_for = 0.5; ///< m/s, s: who falls asleep, where an engine lets that be said;
                                        ///< zero is what it takes by itself
    enum class Detection { usual, discrete, continuous } detection = Detection::usual;
    bool rubs = false;                 ///< there is friction
    bool springs = false;              ///< there are springs, and nobody collides
    bool resolved = true;              ///< of springs: the step is short enough for an explicit method
    double soft = 0, soft_damping = 0; ///< N/m, N s/m: contacts are springs
    double pull_of_sun = 0;            ///< m^3/s^2: everybody is drawn to the origin by this / r^2
    double drag = 0;                   ///< 1/s: of a velocity e^(-drag t) shall be left
    double drag_dt = 0;                ///< s, the step for which drag is set up, where an engine takes a factor a step
    bool far = false;                  ///< bodies are so far from the origin that places are coarse beside their steps
};

struct Ball {
    Vector x = Vector::Zero(), v = Vector::Zero();
    double mass = 1, radius = 0.5, bounce = 0, friction = 0;
};

/// Holds balls `a` and `b`; with b = -1 ball a and the point `at`. Scenes have them along one axis.
struct SpringOf {
    int a = 0, b = -1;
    Vector at = Vector::Zero();
    double stiffness = 0, damping = 0, rest = 0; // N/m, N s/m, m
};

/// A box of a broadphase.
struct BoxOf {
    Vector low, high;
};
using Pairs = std::vector<std::pair<int, int>>; ///< indices, the smaller first

/// What an engine cannot do is a reason.
struct Cannot : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A world of an engine. Bodies are numbered as they are added.
class Engine {
public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    virtual int add(const Ball&) = 0;
    virtual int plane(const Vector& normal, double offset, double bounce, double friction) = 0; ///< solid below it
    virtual int box(const Vector& x, const Vector& half, double bounce, double friction) = 0;   ///< fixed
    virtual int platform(const Vector& x, const Vector& half) = 0; ///< a box that goes with its velocity
    virtual void add(const SpringOf&) { throw Cannot("it has no springs"); }
    virtual void remove(int) = 0;
    virtual void step() = 0;

    virtual Vector x(int) const = 0;
    virtual Vector v(int) const = 0;
    virtual bool asleep(int) const = 0;
    virtual void put(int, const Vector& x) = 0; ///< a fixed box somewhere else
    virtual void send(int, const Vector& v) = 0;
    virtual void push(int, const Vector& force) = 0; ///< during the next step
    virtual void set_gravity(const Vector&) = 0;

    void steps(int n) {
        for (int i = 0; i < n; ++i) step();
    }
};

/// An engine that takes part.
struct Contestant {
    std::string name, version, scalar;
    double epsilon = 0; ///< of its scalar, in this build
    bool flat = false;  ///< two dimensions
    double slop = 0;    ///< m, how deep it lets bodies lie in each other on purpose
    std::vector<std::string> settings{};
    std::vector<std::string> does_more{}; ///< than Ansatz, in the same field
    std::function<std::unique_ptr<Engine>(const Scene&)> make;
    std::function<Pairs(const std::vector<BoxOf>&)> pairs; ///< what its broadphase tells of these boxes
};

/// \name Who takes part; each is compiled only where its library was found
/// @{
Contestant ansatz_double();
Contestant ansatz_float();
Contestant bullet();
Contestant ode();
Contestant box2d();
/// @}

} // namespace peers
