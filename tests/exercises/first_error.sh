#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
#
# Which line of a compiler's output a student gets to see, and how it is put (tools/exercises/first_error.awk).
#
#   first_error.sh <the project's folder>
set -u
project=${1:?the project folder}
passed=0
failed=0

# expect <line> <where> <message>: for the log on standard input.
expect() {
    local output
    output=$(awk -v file=/p/exercises/1-a/b/exercise.hpp -v root=/p/ -f "$project/tools/exercises/first_error.awk" -)
    if [ "$output" = "$1"$'\n'"$2"$'\n'"$3" ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: expected\n%s\n%s\n%s\ngot\n%s\n\n' "$1" "$2" "$3" "$output"
    fi
}

expect 12 exercises/1-a/b/exercise.hpp:12:9 "expected ';' before '}' token" << 'LOG'
[1/2] Building CXX object x.o
/p/exercises/1-a/b/exercise.hpp:9:1: warning: unused variable 'x'
/p/exercises/1-a/b/exercise.hpp:12:9: error: expected ';' before '}' token
/p/exercises/1-a/b/exercise.hpp:30:9: error: another
LOG

# Raised in the library, caused by the student's file: g++ says from where before, clang++ after.
expect 17 include/ansatz/x.hpp:5:3 "Ansatz: say it otherwise" << 'LOG'
In file included from /p/exercises/1-a/b/exercise.hpp:3,
/p/include/ansatz/x.hpp: In instantiation of 'f(T) [with T = int]':
/p/exercises/1-a/b/exercise.hpp:17:9:   required from here
/p/include/ansatz/x.hpp:5:3: error: static assertion failed: Ansatz: say it otherwise
LOG
expect 18 include/ansatz/x.hpp:5:3 "Ansatz: say it otherwise" << 'LOG'
/p/include/ansatz/x.hpp:5:3: error: static_assert failed due to requirement 'ok<int>' "Ansatz: say it otherwise"
/p/exercises/1-a/b/exercise.hpp:18:9: note: in instantiation of function template specialization 'f<int>' requested here
LOG
expect 0 exercises/1-a/b/test.cpp:4:1 "'f' is not a member of 'exercise'" << 'LOG'
In file included from /p/exercises/1-a/b/exercise.hpp:3,
/p/exercises/1-a/b/test.cpp:4:1: error: 'f' is not a member of 'exercise'
LOG

# Units as people write them.
expect 8 exercises/1-a/b/exercise.hpp:8:5 "this adds or compares quantities of different units: m and m/s" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:5: error: use of deleted function 'boost::units::Ansatz_units_this_adds_or_compares_quantities_of_different_units boost::units::operator+=(A, B) [with Unit1 = unit<list<dim<length_base_dimension, static_rational<1> >, dimensionless_type>, homogeneous_system<list<si::meter_base_unit, dimensionless_type> >, void>; Unit2 = unit<list<dim<length_base_dimension, static_rational<1> >, list<dim<time_base_dimension, static_rational<-1> >, dimensionless_type> >, homogeneous_system<list<si::meter_base_unit, dimensionless_type> >, void>]'
LOG
expect 8 exercises/1-a/b/exercise.hpp:8:5 "no match for 'operator=' (operand types are 'quantity in kg m/s^2' and 'vector in no unit')" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:5: error: no match for 'operator=' (operand types are 'boost::units::quantity<boost::units::unit<boost::units::list<boost::units::dim<boost::units::length_base_dimension, boost::units::static_rational<1> >, boost::units::list<boost::units::dim<boost::units::mass_base_dimension, boost::units::static_rational<1> >, boost::units::list<boost::units::dim<boost::units::time_base_dimension, boost::units::static_rational<-2> >, boost::units::dimensionless_type> > >, boost::units::homogeneous_system<boost::units::list<boost::units::si::meter_base_unit, boost::units::dimensionless_type> >, void>, double>' and 'boost::units::quantity<boost::units::unit<boost::units::dimensionless_type, boost::units::homogeneous_system<boost::units::list<boost::units::si::meter_base_unit, boost::units::dimensionless_type> >, void>, Eigen::Matrix<double, 3, 1> >')
LOG

# No error, no answer.
if printf 'all is well\n' | awk -v file=x -v root=/ -f "$project/tools/exercises/first_error.awk" - > /dev/null; then
    failed=$((failed + 1))
    echo "FAILED: an error was found in a log without one"
fi
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
