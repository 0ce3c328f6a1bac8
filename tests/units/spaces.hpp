// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// What the tests of units share: the scalars and dimensions that everything must work for, and
/// vectors of small binary fractions, whose sums and products are exact in all of them.

#include <ansatz/units.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <random>
#include <type_traits>

namespace ansatz::test {

/// The scalar that accuracy is measured against.
using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class S, int D> struct In {
    using Scalar = S;
    static constexpr int dim = D;
};

template <class A, class B> inline constexpr bool same = std::is_same_v<A, B>;

/// Numbers k/4 with k from -20 to 20: every product of three of them is exact in a float.
class Numbers {
public:
    template <class S> S number() { return S(std::uniform_int_distribution<int>(-20, 20)(engine_)) / S(4); }

    template <class S> S not_zero() {
        const S n = number<S>();
        return n == S(0) ? S(1) : n;
    }
    template <class Unit, class S> Quantity<Unit, S> scalar() { return Quantity<Unit, S>::from_value(not_zero<S>()); }

    template <class S, int D> Vector<S, D> plain() {
        Vector<S, D> v;
        for (int i = 0; i < D; ++i) v[i] = number<S>();
        return v;
    }
    template <class Unit, class S, int D> VectorQuantity<Unit, D, S> vector() {
        return VectorQuantity<Unit, D, S>::from_value(plain<S, D>());
    }

    template <class Unit, class S, int D> MatrixQuantity<Unit, D, S> matrix() {
        Eigen::Matrix<S, D, D> m;
        for (int i = 0; i < D * D; ++i) m.data()[i] = number<S>();
        return MatrixQuantity<Unit, D, S>::from_value(m);
    }

private:
    std::mt19937 engine_{20240229};
};

} // namespace ansatz::test

#define ANSATZ_TEST_SPACES                                                                                             \
    (ansatz::test::In<float, 2>), (ansatz::test::In<float, 3>), (ansatz::test::In<double, 2>),                         \
        (ansatz::test::In<double, 3>), (ansatz::test::In<ansatz::test::Precise, 2>),                                   \
        (ansatz::test::In<ansatz::test::Precise, 3>)
