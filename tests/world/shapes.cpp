// SPDX-License-Identifier: BSL-1.0
// Columns of a shape of one's own: through every door, in a hash and in a file.

#include <ansatz/world.hpp>
#include <ansatz/world/save.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>
#include <type_traits>

using namespace ansatz;

namespace {

//! [shape]
/// A symmetric matrix with a unit: 3 numbers in a plane, 6 in space.
template <class Scalar, int Dimension, class Unit> struct Symmetric {
    static constexpr int size = Dimension * (Dimension + 1) / 2;
    Scalar of[size] = {}; // by rows, from the diagonal on
    static Symmetric from_lanes(const Scalar* raw) {
        Symmetric m;
        for (int k = 0; k < size; ++k) m.of[k] = raw[k];
        return m;
    }
    void to_lanes(Scalar* raw) const {
        for (int k = 0; k < size; ++k) raw[k] = of[k];
    }
    void check() const {
        if (of[0] < 0)
            refuse_value("Symmetric", "its first number", Quantity<Unit, Scalar>::from_value(of[0]),
                         "it is not negative");
    }
    friend bool operator==(const Symmetric&, const Symmetric&) = default;
};
struct SymmetricShape {
    template <class S, class Unit> using Value = Symmetric<typename S::Scalar, S::dimension, Unit>;
    static constexpr std::size_t lanes(int dimension) { return std::size_t(dimension * (dimension + 1) / 2); }
};
struct Inertia {
    using Unit = unit::Mass;
    static constexpr SymmetricShape shape{};
    static constexpr std::string_view name = "inertia";
};
//! [shape]
/// Doubles it in every step.
struct Doubles {
    using role = roles::Effect;
    using writes = Columns<Inertia>;
    static constexpr Place place = Place::end_of_step;
    template <class S> struct In {
        explicit In(const Doubles&) {}
        void apply(auto& inertia, const auto&) const {
            for (auto& x : inertia.of) x *= 2;
        }
    };
};
//! [axial]
/// An axial vector is three numbers in space and one in the plane: quantities of the library are values of a shape,
/// too.
struct AxialShape {
    template <class S, class Unit>
    using Value =
        std::conditional_t<S::dimension == 2, typename S::template ScalarOf<Unit>, typename S::template VectorOf<Unit>>;
    static constexpr std::size_t lanes(int dimension) { return dimension == 2 ? 1 : 3; }
};
struct Spin {
    using Unit = unit::Frequency;
    static constexpr AxialShape shape{};
    static constexpr std::string_view name = "spin";
};
//! [axial]
template <class Scalar, int Dimension> using Value = Symmetric<Scalar, Dimension, unit::Mass>;

} // namespace

TEMPLATE_TEST_CASE_SIG("What a column of one's own shape holds goes in and comes out", "[shapes]",
                       ((class T, int n), T, n), (double, 3), (float, 2)) {
    Value<T, n> m;
    for (int k = 0; k < m.size; ++k) m.of[k] = T(k) + T(0.5);
    World world{Space<T, n>{}, SemiImplicitEuler{}, Doubles{}};
    static_assert(decltype(world)::composition::stored::size == 3); // position, velocity and it
    const auto none = world.add(), one = world.add(with<Inertia>(m));
    CHECK(world.template read<Inertia>(none) == Value<T, n>());
    CHECK(world.template read<Inertia>(one) == m);
    world.step(0.1 * second);
    for (auto& x : m.of) x *= 2;
    CHECK(world.template read<Inertia>(one) == m);
    auto other = world;
    CHECK(other.hash() == world.hash());
    Value<T, n> changed = m;
    changed.of[m.size - 1] = 7;
    other.template write<Inertia>(one, changed);
    CHECK(other.hash() != world.hash());
    CHECK(other.template read<Inertia>(one) == changed);
    std::stringstream file;
    save(world, file);
    load(other, file);
    CHECK(other.hash() == world.hash());
    CHECK(other.template read<Inertia>(one) == m);
}
TEST_CASE("A value that is none is refused at each door, and nothing is changed", "[shapes]") {
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Doubles{}};
    const auto body = world.add();
    const auto before = world.hash();
    Value<double, 2> m;
    m.of[2] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(world.write<Inertia>(body, m), Catch::Contains("World::write") && Catch::Contains("inertia") &&
                                                         Catch::Contains("its number 2") && Catch::Contains("inf"));
    CHECK_THROWS_WITH(world.add(with<Inertia>(m)), Catch::Contains("World::add") && Catch::Contains("its number 2"));
    m.of[2] = 0;
    m.of[0] = -1;
    CHECK_THROWS_WITH(world.write<Inertia>(body, m), Catch::Contains("-1 kg") && Catch::Contains("not negative"));
    CHECK(world.hash() == before);
    std::stringstream file;
    save(world, file);
    for (const auto& [was, is, said] : {std::tuple("\"inertia\": [\n", "\"inertia\": [ 1,\n", "numbers"),
                                        std::tuple("\"inertia\": [\n    0.0", "\"inertia\": [\n    -2.0", "-2 kg")}) {
        auto text = file.str();
        const auto at = text.find(was);
        INFO(text);
        REQUIRE(at != std::string::npos);
        std::stringstream wrong(text.replace(at, std::string(was).size(), is));
        CHECK_THROWS_WITH(load(world, wrong), Catch::Contains("inertia") && Catch::Contains(said));
        CHECK(world.hash() == before);
    }
}
TEMPLATE_TEST_CASE("A quantity of other lanes than the space has is a value of a shape", "[shapes]", (Space<double, 3>),
                   (Space<float, 2>)) {
    using Scalar = typename TestType::Scalar;
    World world{TestType{}, SemiImplicitEuler{}, Keep<Spin>{}};
    const auto spin = [](double x) {
        if constexpr (TestType::dimension == 2) return x / second;
        else return radians_per_second(x, -x, 2 * x);
    };
    const auto body = world.add(with<Spin>(spin(0.1))); // of double, in a world of float, too
    CHECK(world.template read<Spin>(body) == scalar_cast<Scalar>(spin(0.1)));
    CHECK(world.template read<Spin>(world.add()) == scalar_cast<Scalar>(spin(0)));
    CHECK(world.bytes_per_body == (2 * TestType::dimension + (TestType::dimension == 2 ? 1 : 3)) * sizeof(Scalar));
    world.template write<Spin>(body, spin(5));
    auto other = world;
    other.template write<Spin>(body, spin(6));
    CHECK(other.hash() != world.hash());
    std::stringstream file;
    save(world, file);
    load(other, file);
    CHECK(other.hash() == world.hash());
    CHECK(other.template read<Spin>(body) == scalar_cast<Scalar>(spin(5)));
    const auto before = world.hash();
    CHECK_THROWS_WITH(world.template write<Spin>(body, spin(std::numeric_limits<double>::infinity())),
                      Catch::Contains("World::write") && Catch::Contains("spin") && Catch::Contains("inf"));
    CHECK(world.hash() == before);
}
TEST_CASE("A body is not finite if a number of a shape of its own is not", "[shapes]") {
    World world{Space<double, 2>{}, SemiImplicitEuler{}, Doubles{}, Keep<Spin>{}};
    Value<double, 2> m;
    m.of[2] = std::numeric_limits<double>::max();
    world.add(with<Spin>(1.0 / second));
    const auto body = world.add(with<Inertia>(m));
    CHECK(world.status().ok());
    world.step(0.1 * second);
    CHECK(world.status().not_finite == 1);
    CHECK(world.status().first_not_finite == body);
}
