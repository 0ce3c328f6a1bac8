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

# A wrong unit in a return: what is there and what belongs there, and nothing of how it came to be.
expect 8 exercises/1-a/b/exercise.hpp:8:9 "this is a quantity in 1/s^2, where a quantity in 1/s belongs" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: could not convert ‘boost::units::operator*(const quantity<Unit1, X>&, const quantity<Unit2, Y>&) [with Unit1 = unit<list<dim<time_base_dimension, static_rational<-1> >, dimensionless_type>, homogeneous_system<list<si::meter_base_unit, dimensionless_type> >, void>; X = double; typename multiply_typeof_helper<quantity<Unit1, X>, quantity<Unit2, Y> >::type = quantity<unit<list<dim<time_base_dimension, static_rational<-2> >, dimensionless_type>, homogeneous_system<list<si::meter_base_unit, dimensionless_type> >, void>, double>](f)’ from ‘quantity<unit<list<dim<time_base_dimension,static_rational<-2>>,dimensionless_type>,homogeneous_system<list<si::meter_base_unit,dimensionless_type>>,void>,double>’ to ‘quantity<unit<list<dim<time_base_dimension,static_rational<-1>>,dimensionless_type>,homogeneous_system<list<si::meter_base_unit,dimensionless_type>>,void>,double>’
LOG
expect 8 exercises/1-a/b/exercise.hpp:8:9 "this is a quantity in m, where a plain number belongs" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: cannot convert 'exercise::Length' {aka 'boost::units::quantity<boost::units::unit<boost::units::list<boost::units::dim<boost::units::length_base_dimension, boost::units::static_rational<1> >, boost::units::dimensionless_type>, boost::units::homogeneous_system<boost::units::list<boost::units::si::meter_base_unit, boost::units::dimensionless_type> >, void>, double>'} to 'double' in return
LOG
expect 8 exercises/1-a/b/exercise.hpp:8:9 "this is a plain number, where a quantity in m belongs" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: could not convert 'a' from 'double' to 'exercise::Length' {aka 'quantity<unit<list<dim<length_base_dimension, static_rational<1> >, dimensionless_type>, homogeneous_system<list<si::meter_base_unit, dimensionless_type> >, void>, double>'}
LOG
expect 8 exercises/1-a/b/exercise.hpp:8:9 "this is a vector in m/s, where a vector in m belongs" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: no viable conversion from returned value of type 'quantity<unit<list<dim<length_base_dimension, static_rational<1>>, list<dim<time_base_dimension, static_rational<-1>>, dimensionless_type>>, homogeneous_system<list<si::meter_base_unit, dimensionless_type>>, void>, Eigen::Matrix<double, 3, 1>>' to function return type 'Place' (aka 'quantity<unit<list<dim<length_base_dimension, static_rational<1>>, dimensionless_type>, homogeneous_system<list<si::meter_base_unit, dimensionless_type>>, void>, Matrix<double, 3, 1>>')
LOG
expect 8 exercises/1-a/b/exercise.hpp:8:9 "this is a quantity in m, where a quantity in s belongs" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: conversion from 'quantity<unit<list<dim<length_base_dimension,static_rational<1>>,dimensionless_type>,homogeneous_system<list<si::meter_base_unit,dimensionless_type>>,void>,double>' to non-scalar type 'quantity<unit<list<dim<time_base_dimension,static_rational<1>>,dimensionless_type>,homogeneous_system<list<si::meter_base_unit,dimensionless_type>>,void>,double>' requested
LOG
# What has no unit keeps the compiler's words.
expect 8 exercises/1-a/b/exercise.hpp:8:9 "cannot convert 'std::string' to 'double' in return" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:9: error: cannot convert 'std::string' to 'double' in return
LOG

# clang++ names the deleted operator first.
expect 8 exercises/1-a/b/exercise.hpp:8:11 "this adds or compares quantities of different units" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:8:11: error: overload resolution selected deleted operator '+='
/p/include/ansatz/units/x.hpp:3:1: note: candidate function [with Unit1 = a, Unit2 = b] has been explicitly deleted
Ansatz_units_this_adds_or_compares_quantities_of_different_units operator+=(quantity<Unit1, X>&, const quantity<Unit2, Y>&) = delete;
LOG

# The linker's errors name the symbol, not the program that called the linker.
expect 0 linking "exercise::other(double) is declared and used, but it is defined nowhere" << 'LOG'
/usr/bin/ld: test.cpp.o: in function `probe':
test.cpp:(.text+0x4e7): undefined reference to `exercise::other(double)'
collect2: error: ld returned 1 exit status
LOG
expect 0 linking "exercise::other(double) is declared and used, but it is defined nowhere" << 'LOG'
ld.lld: error: undefined symbol: exercise::other(double)
clang: error: linker command failed with exit code 1 (use -v to see invocation)
LOG
expect 0 linking "there are two of main: the tests have their own, so that an answer has none" << 'LOG'
/usr/bin/ld: test.cpp:(.text+0x3c): multiple definition of `main'; main.cpp.o:main.cpp:(.text+0x1fe46): first defined here
collect2: error: ld returned 1 exit status
LOG

# Something is open at the end of the file: whoever is included next is not to blame, nor is the last line.
expect 0 end "something is open at the end of the file: most often a closing brace } is missing" << 'LOG'
/p/build/exercises/subjects/a.b/student/subject.hpp:3:20: error: specialization of 'template<class> struct NothingIsOpen' in different namespace
/p/tools/exercises/expect.hpp:14:1: error: expected '}' at end of input
LOG
expect 0 end "something is open at the end of the file: most often a closing brace } is missing" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:31:2: error: expected ';' after struct definition
/p/build/exercises/subjects/a.b/student/subject.hpp:3:20: error: specialization of 'template<class> struct NothingIsOpen' in different namespace
LOG

expect 22 exercises/1-a/b/exercise.hpp:22:1 "the function ends without return" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:22:1: error: no return statement in function returning non-void [-Werror=return-type]
LOG
expect 22 exercises/1-a/b/exercise.hpp:22:1 "the function ends without return" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:22:1: error: non-void function does not return a value [-Werror,-Wreturn-type]
LOG
expect 21 exercises/1-a/b/exercise.hpp:21:9 "'q' is used uninitialized" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:21:9: error: 'q' is used uninitialized [-Werror=uninitialized]
LOG
expect 0 disk "no space is left on the disk: make room and give the same command again" << 'LOG'
/p/exercises/1-a/b/exercise.hpp:3:9: fatal error: error writing to /x.s: No space left on device
LOG

# No error, no answer.
if printf 'all is well\n' | awk -v file=x -v root=/ -f "$project/tools/exercises/first_error.awk" - > /dev/null; then
    failed=$((failed + 1))
    echo "FAILED: an error was found in a log without one"
fi
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
