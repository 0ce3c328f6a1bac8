// SPDX-License-Identifier: BSL-1.0
// BroadphaseIn and InsideIn: archetypes, two models, near misses.

#include <ansatz/collision.hpp>

#include "tests/archetypes/archetype.hpp"

namespace ansatz::archetypes {

using S = Space<>;

struct Finds : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Broadphase;
    template <class Sp> struct In : NothingMore {
        explicit In(const Finds&) : NothingMore(0) {}
        template <class F> void find(const Boxes<Sp>& boxes, F&& found) {
            if (boxes.size() > 1) found(std::size_t(0), std::size_t(1));
        }
    };
};
static_assert(BroadphaseIn<Finds, S> && BroadphaseIn<Finds, Space<float, 2>> && !InsideIn<Finds, S>);
auto of_broadphase() { return use(World{SemiImplicitEuler{}, Finds(1), Narrowphase<Sphere>{}, Impulse<>{}}); }

struct FindsInPieces : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Broadphase;
    template <class Sp> struct In : NothingMore {
        explicit In(const FindsInPieces&) : NothingMore(0) {}
        template <class F> void find(const Boxes<Sp>&, F&&) {}
        void prepare(const Boxes<Sp>&, const auto& run) {
            run(std::size_t(1), std::size_t(1), [](std::size_t, std::size_t) {});
        }
        std::size_t pieces() const { return 1; }
        template <class F> void find(const Boxes<Sp>& boxes, std::size_t, std::size_t, F&& found) const {
            if (boxes.size() > 1) found(std::size_t(0), std::size_t(1));
        }
    };
};
static_assert(DividedBroadphaseIn<FindsInPieces, S> && !DividedBroadphaseIn<Finds, S>);
struct AsTheyCome {
    using role = roles::Execution;
    void execute(std::size_t count, std::size_t, const auto& loop) const { loop(std::size_t(0), count); }
};
auto of_broadphase_in_pieces() {
    return use(World{SemiImplicitEuler{}, FindsInPieces(1), Narrowphase<Sphere>{}, Impulse<>{}, AsTheyCome{}});
}

struct FindsInside : NothingMore {
    using NothingMore::NothingMore;
    using role = roles::Broadphase;
    template <class Sp> struct In : NothingMore {
        explicit In(const FindsInside&) : NothingMore(0) {}
        template <class F> void find(const Boxes<Sp>&, F&&) {}
        const std::uint32_t* order(const Boxes<Sp>&) { return nullptr; }
        void arrange(Lot<Sp>&, std::size_t, std::size_t) {}
        template <class F> void among(const Lot<Sp>&, std::size_t, std::size_t, F&&) const {}
        template <class F>
        void between(const Lot<Sp>&, std::size_t, std::size_t, std::size_t, std::size_t, F&&) const {}
    };
};
static_assert(InsideIn<FindsInside, S>);
auto of_inside() {
    return use(
        World{SemiImplicitEuler{}, UniformGrid<FindsInside>{{}, FindsInside(1)}, Narrowphase<Sphere>{}, Impulse<>{}});
}

// Models: the library's, and one that refuses a parameter and is a final class.
struct Nearest final {
    using role = roles::Broadphase;
    void check() const {}
    template <class Sp> class In {
    public:
        explicit In(Nearest) {}
        void find(auto&& boxes, auto&& found) {
            for (std::size_t i = 1; i < boxes.size(); ++i) found(i - 1, i);
        }
    };
};
static_assert(BroadphaseIn<AllPairs, S> && BroadphaseIn<Octree<SortAndSweep>, S> && BroadphaseIn<Nearest, S>);
static_assert(InsideIn<BoundingBoxes, S> && InsideIn<SortAndSweep, Space<float, 2>> && !InsideIn<AllPairs, S> &&
              !InsideIn<Octree<>, S>);
static_assert(DividedBroadphaseIn<UniformGrid<>, S> && DividedBroadphaseIn<Coherent<Octree<>>, S> &&
              !DividedBroadphaseIn<Octree<>, S>);
static_assert(detail::BroadphaseFacts<Octree<SortAndSweep>, S>::ok &&
              !detail::BroadphaseFacts<Octree<AllPairs>, S>::ok);
static_assert(!detail::BroadphaseFacts<UniformGrid<Octree<>>, S>::inside &&
              !detail::BroadphaseFacts<BinarySplit<Gravity>, S>::inside);
auto of_nearest() { return use(World{Verlet{}, Nearest{}, Narrowphase<Sphere, Plane>{}, Projection{}}); }

// Near misses.
struct WithoutFunction {
    using role = roles::Broadphase;
    template <class Sp> struct In {
        explicit In(const WithoutFunction&);
        void find(const Boxes<Sp>&);
    };
};
struct NotMadeFromIt {
    using role = roles::Broadphase;
    template <class Sp> struct In {
        template <class F> void find(const Boxes<Sp>&, F&&);
    };
};
struct AsAFilter {
    using role = roles::Filter;
    template <class Sp> struct In {
        explicit In(const AsAFilter&);
        template <class F> void find(const Boxes<Sp>&, F&&);
    };
};
struct ChangesTheBoxes {
    using role = roles::Broadphase;
    template <class Sp> struct In {
        explicit In(const ChangesTheBoxes&);
        template <class F> void find(Boxes<Sp>&, F&&);
    };
};
/// Its pieces are searched by a function that changes it, which threads cannot do at the same time.
struct ChangesWhereItSearches {
    using role = roles::Broadphase;
    template <class Sp> struct In {
        explicit In(const ChangesWhereItSearches&);
        template <class F> void find(const Boxes<Sp>&, F&&);
        void prepare(const Boxes<Sp>&, const auto&);
        std::size_t pieces() const;
        template <class F> void find(const Boxes<Sp>&, std::size_t, std::size_t, F&&);
    };
};
/// What is derived from a divided one and finds pairs in its own way is asked for nothing else.
struct FindsItsOwnWay : Coherent<> {
    template <class Sp> class In : public Coherent<>::In<Sp> {
    public:
        explicit In(const FindsItsOwnWay& policy) : Coherent<>::In<Sp>(policy) {}
        template <class F> void find(const Boxes<Sp>&, F&&) {}
    };
};
static_assert(BroadphaseIn<ChangesWhereItSearches, S> && !DividedBroadphaseIn<ChangesWhereItSearches, S>);
static_assert(BroadphaseIn<FindsItsOwnWay, S> && !DividedBroadphaseIn<FindsItsOwnWay, S>);
static_assert(!BroadphaseIn<WithoutFunction, S> && !BroadphaseIn<NotMadeFromIt, S> && !BroadphaseIn<AsAFilter, S> &&
              !BroadphaseIn<ChangesTheBoxes, S>);
static_assert(!BroadphaseIn<Gravity, S> && !BroadphaseIn<int, S>);

} // namespace ansatz::archetypes
