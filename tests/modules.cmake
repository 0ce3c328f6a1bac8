# SPDX-License-Identifier: BSL-1.0
# The test cases of the modules: Catch2, 3 where found, else 2.13.
find_package(Catch2 3 CONFIG QUIET)
if(NOT Catch2_FOUND)
    find_package(Catch2 2.13 CONFIG QUIET)
endif()
if(NOT Catch2_FOUND)
    ansatz_left_out("the tests of the modules" Catch2 catch2)
    return()
endif()
include(${Catch2_DIR}/Catch.cmake)

# What only some tests need: its name, its Debian package, its target, and the includes by which such a test is known.
find_package(nlohmann_json 3 CONFIG QUIET)
find_package(benchmark CONFIG QUIET)
find_package(pugixml CONFIG QUIET)
find_package(Threads QUIET)
find_package(TBB CONFIG QUIET)
set(wanted
    "nlohmann-json|nlohmann-json3-dev|nlohmann_json::nlohmann_json|<nlohmann/,<ansatz/states/save.hpp>,<ansatz/paths/goap/save.hpp>,\"tools/costs.hpp,\"tools/costs/json.hpp"
    "Threads|libc6-dev|Threads::Threads|<thread>"
    "oneTBB|libtbb-dev|TBB::tbb|<ansatz/execution.hpp>,<ansatz/execution/threads.hpp>,<ansatz/execution/on_threads.hpp>"
    "pugixml|libpugixml-dev|pugixml::pugixml|<ansatz/states/scxml.hpp>"
    "Google Benchmark|libbenchmark-dev|benchmark::benchmark|<benchmark/,\"tools/costs.hpp,\"tools/costs/measure.hpp")

# One main, compiled once: Debian's own has no benchmarks, and it must not see the precompiled header.
add_library(test_main OBJECT main.cpp)
target_link_libraries(test_main PRIVATE ansatz_development Catch2::Catch2)
# It alone knows where this checkout lies (project.hpp): no other object may depend on that.
target_compile_definitions(test_main PRIVATE "ANSATZ_PROJECT_FOLDER=\"${PROJECT_SOURCE_DIR}\"")

# What every test is compiled with.
add_library(test_options INTERFACE)
target_link_libraries(test_options INTERFACE ansatz_development Catch2::Catch2)

# Compiling a test costs a hundred times what running it does, so a release is optimised for the debugger here (-Og: 45 % of
# the compiler's time with -O3, measured on five files). What measures time, the module `performance`, and a file that says so
# keep the optimiser, and with ANSATZ_TESTS_OPTIMISED all do: .ci/run optimised.
add_library(test_quick INTERFACE)
target_link_libraries(test_quick INTERFACE test_options)
set(optimised_modules performance)
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT ANSATZ_TESTS_OPTIMISED)
    target_compile_options(test_quick INTERFACE -Og)
    set(quick ON)
else()
    set(quick OFF)
endif()

# With sanitizers it is the other way round for a test that runs long and says so: where all others are compiled without the
# optimiser, which takes a third of the time, these are compiled with this. They are a program of their own, test_<module>_long:
# of a function that two files have, the linker takes either, and where it took the one without the optimiser these would run
# fifty times as long.
set(ANSATZ_TESTS_THAT_RUN_LONG "" CACHE STRING "What tests that run long are compiled with, e.g. -O1; nothing, if there is nothing")

# A test that hangs is ended, not one that a busy machine or the sanitizers make slow.
set(hangs_after 300)    # s
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}" MATCHES "-fsanitize=")
    set(hangs_after 900)
endif()

# One precompiled header for all of them; named by its place in the project, for the same header in every checkout.
add_library(test_precompiled OBJECT precompiled.cpp)
target_link_libraries(test_precompiled PRIVATE test_quick)
set(precompiled \"tests/catch.hpp\" <Eigen/Core> <algorithm> <array> <cmath> <complex> <cstdint>
    <functional> <iomanip> <iostream> <limits> <map> <memory> <numeric> <optional> <random> <span> <sstream> <string>
    <string_view> <tuple> <type_traits> <utility> <variant> <vector>)
target_precompile_headers(test_precompiled PRIVATE ${precompiled})
if(ANSATZ_TESTS_THAT_RUN_LONG)
    add_library(test_precompiled_long OBJECT precompiled.cpp)
    target_link_libraries(test_precompiled_long PRIVATE test_quick)
    target_compile_options(test_precompiled_long PRIVATE ${ANSATZ_TESTS_THAT_RUN_LONG})
    target_precompile_headers(test_precompiled_long PRIVATE ${precompiled})
endif()

# Takes out of a list of sources those that need what is not here, and reports each as a skipped test; for the others,
# the libraries that they need.
function(sort_out sources_variable libraries_variable module)
    set(kept)
    set(libraries)
    foreach(source IN LISTS ${sources_variable})
        set(missing)
        foreach(entry IN LISTS wanted)
            string(REPLACE "|" ";" entry "${entry}")
            list(POP_FRONT entry name package target includes)
            string(REPLACE "," "|" includes "${includes}")
            string(REPLACE "." "\\." includes "${includes}")
            file(STRINGS ${source} uses REGEX "^#include (${includes})" LIMIT_COUNT 1)
            if(uses AND TARGET ${target})
                list(APPEND libraries ${target})
            elseif(uses)
                set(missing "no ${name} (on Debian: apt install ${package})")
            endif()
        endforeach()
        if(missing)
            cmake_path(GET source STEM LAST_ONLY name)
            add_test(NAME "${module}.${name}" COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${missing}")
            set_tests_properties("${module}.${name}" PROPERTIES SKIP_REGULAR_EXPRESSION "^skipped: " LABELS ${module})
        else()
            list(APPEND kept ${source})
        endif()
    endforeach()
    set(${sources_variable} ${kept} PARENT_SCOPE)
    set(${libraries_variable} ${libraries} PARENT_SCOPE)
endfunction()

# A test that skips itself, and has failed nothing before, is reported as skipped: SKIP("reason") of Catch2 3, or ours
# of catch.hpp.
set(skipped "test cases: 1 \\| 1 skipped|test skipped: .*All tests passed")

# A race is run for its time on an idle machine, by name, and for its instructions everywhere else, by valgrind, which does
# not know AVX-512: so it is compiled for the step before that. Where it is only counted, AVX2 is taken as it is: some processors
# prefer half of its vectors, and would count twice as much.
add_custom_target(races)
option(ANSATZ_TIMED_TESTS "Tests that measure time, for an idle machine" OFF)
find_program(ANSATZ_VALGRIND valgrind)
find_path(ANSATZ_VALGRIND_HEADERS valgrind/callgrind.h)
mark_as_advanced(ANSATZ_VALGRIND ANSATZ_VALGRIND_HEADERS)
add_library(ansatz_raced INTERFACE)
set(wide)
set(avx2)
if(ANSATZ_NATIVE AND EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo wide REGEX "^flags.* avx512" LIMIT_COUNT 1)
    file(STRINGS /proc/cpuinfo avx2 REGEX "^flags.* avx2 " LIMIT_COUNT 1)
endif()
if(wide)
    set(machine -march=x86-64-v3 -mtune=native)
elseif(avx2 AND NOT ANSATZ_TIMED_TESTS)
    set(machine -march=x86-64-v3)
else()
    set(machine)
endif()
if(machine)
    list(JOIN machine " " raced)
    string(REPLACE "-march=native" "${raced}" raced "${flags}")
    target_link_libraries(ansatz_raced INTERFACE ansatz_development)
    target_compile_options(ansatz_raced INTERFACE ${machine})
    target_compile_definitions(ansatz_raced INTERFACE ANSATZ_FLAGS="${raced}")
else()
    target_link_libraries(ansatz_raced INTERFACE ansatz_measured)
endif()
set(counting OFF)
if(NOT ANSATZ_VALGRIND OR NOT ANSATZ_VALGRIND_HEADERS)
    ansatz_left_out("counting the instructions of races" valgrind valgrind)
elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(counting ON)
endif()
if(NOT ANSATZ_TIMED_TESTS)
    ansatz_note("tests that measure time: switched off (.ci/run times), their instructions are counted")
endif()

# Files of a module are compiled several at a time (cmake/Together.cmake). Each stays a file that compiles by itself: the program
# test_<module> of them is built when it is asked for, and by `./workbook test --touched`.
option(ANSATZ_TESTS_TOGETHER "Compile the tests of a module several files at a time: quicker in all, slower for one" ON)

# A program of test cases, each a test of its own: with the precompiled header of this target, and further options.
function(ansatz_tests target module libraries precompiled options)
    set(programs ${target})
    set(sources_of_${target} ${ARGN})
    if(ANSATZ_TESTS_TOGETHER)
        list(APPEND programs ${target}_together)
        set(sources_of_${target}_together ${ARGN})
        ansatz_together(${target} sources_of_${target}_together BYTES 100000)
    endif()
    foreach(program IN LISTS programs)
        add_executable(${program} ${sources_of_${program}})
        target_link_libraries(${program} PRIVATE test_main test_quick ${libraries})
        target_compile_options(${program} PRIVATE ${options})
        target_precompile_headers(${program} REUSE_FROM ${precompiled})
    endforeach()
    list(GET programs -1 tested)
    if(ANSATZ_TESTS_TOGETHER)
        set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL TRUE)
        set_target_properties(${tested} PROPERTIES JOB_POOL_COMPILE together)
    endif()
    catch_discover_tests(${tested} TEST_PREFIX "${module}."
        PROPERTIES LABELS ${module} TIMEOUT ${hangs_after} SKIP_REGULAR_EXPRESSION "${skipped}")
endfunction()

file(GLOB folders CONFIGURE_DEPENDS LIST_DIRECTORIES true RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *)
list(REMOVE_ITEM folders static archetypes must_not_compile package peers)
set(ANSATZ_TEST_MODULES "" CACHE STRING "The modules whose tests are built, e.g. world;collision; all of them, if there is nothing")
if(ANSATZ_TEST_MODULES)
    list(JOIN ANSATZ_TEST_MODULES "|" wished)
    list(FILTER folders INCLUDE REGEX "^(${wished})$")
    ansatz_note("tests of other modules than ${ANSATZ_TEST_MODULES}: switched off")
endif()
set(modules)
foreach(module IN LISTS folders)
    if(NOT IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${module})
        continue()
    endif()

    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${module}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/(planted|programs)/")    # what scripts compile; the planted ones have faults
    include(${module}/sources.cmake OPTIONAL)    # adds those that are made
    sort_out(sources libraries ${module})
    set(measuring ${sources})
    list(FILTER measuring INCLUDE REGEX "\\.perf\\.cpp$")
    if(NOT counting AND NOT ANSATZ_TIMED_TESTS)
        set(measuring)
    endif()
    list(FILTER sources EXCLUDE REGEX "\\.perf\\.cpp$")

    # A test may say so in a line of its own: then it is long to optimise and nothing in it is measured, or it runs long,
    # or is one of those that show that the optimiser changes nothing. Neither can read the others' precompiled header.
    set(running_long)
    foreach(source IN LISTS sources)
        file(STRINGS ${source} said REGEX "^// Compiled with(out)? optimisation" LIMIT_COUNT 1)
        if(said MATCHES "without")
            set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -O0 SKIP_PRECOMPILE_HEADERS ON)
        elseif(quick AND (said OR module IN_LIST optimised_modules))
            set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -O3 SKIP_PRECOMPILE_HEADERS ON)
        endif()
        file(STRINGS ${source} long REGEX "^// Runs long with the sanitizers" LIMIT_COUNT 1)
        if(long AND ANSATZ_TESTS_THAT_RUN_LONG)
            list(APPEND running_long ${source})
        endif()
    endforeach()
    list(REMOVE_ITEM sources ${running_long})
    if(sources OR running_long)
        list(APPEND modules ${module})
    endif()
    if(sources)
        ansatz_tests(test_${module} ${module} "${libraries}" test_precompiled "" ${sources})
    endif()
    if(running_long)
        ansatz_tests(test_${module}_long ${module} "${libraries}" test_precompiled_long "${ANSATZ_TESTS_THAT_RUN_LONG}"
            ${running_long})
    endif()
    if(measuring)
        add_executable(test_${module}_perf ${measuring})
        target_link_libraries(test_${module}_perf PRIVATE test_main test_options ansatz_raced ${libraries})
        add_dependencies(races test_${module}_perf)
        if(ANSATZ_TIMED_TESTS)
            catch_discover_tests(test_${module}_perf TEST_PREFIX "${module}.perf."
                PROPERTIES LABELS perf RUN_SERIAL TRUE TIMEOUT 300 SKIP_REGULAR_EXPRESSION "${skipped}")
        endif()
        if(counting)
            set(counts ${PROJECT_BINARY_DIR}/scratch/${module}.counts)
            add_test(NAME ${module}.counted COMMAND ${ANSATZ_VALGRIND} --quiet --tool=callgrind --instr-atstart=no
                --callgrind-out-file=${counts} $<TARGET_FILE:test_${module}_perf>)
            set_tests_properties(${module}.counted PROPERTIES LABELS "${module};counted" TIMEOUT 600
                ENVIRONMENT "ANSATZ_COUNTS=${counts}" FAIL_REGULAR_EXPRESSION "test cases: [0-9]+ .*skipped")
        endif()
    endif()

    file(GLOB scripts CONFIGURE_DEPENDS ${module}/*.sh)
    list(JOIN CMAKE_CXX_COMPILER_LAUNCHER "|" launcher)    # for what scripts compile (programs.bash)
    if(ANSATZ_BASH)
        foreach(script IN LISTS scripts)
            cmake_path(GET script STEM name)
            # A script may say so in a line of its own: then one build on a machine is enough, or it measures time, which is
            # for an idle machine, like the races.
            file(STRINGS ${script} said REGEX "^# (Looks at every compiler|Measures time)")
            if(said MATCHES "Measures time" AND NOT ANSATZ_TIMED_TESTS)
                continue()
            endif()
            add_test(NAME "${module}.${name}" COMMAND ${ANSATZ_BASH} ${script} ${PROJECT_SOURCE_DIR})
            # What hangs is ended, not what a busy machine makes slow: the longest takes ten minutes on one.
            set_tests_properties("${module}.${name}" PROPERTIES LABELS ${module} TIMEOUT 1500
                SKIP_REGULAR_EXPRESSION "^skipped: " ENVIRONMENT
                "ANSATZ_SCRATCH=${PROJECT_BINARY_DIR}/scratch/${module}.${name};CXX=${CMAKE_CXX_COMPILER};CMAKE=${CMAKE_COMMAND}")
            set_property(TEST "${module}.${name}" APPEND PROPERTY ENVIRONMENT "ANSATZ_LAUNCHER=${launcher}")
            # They are the longest of the tests: begun last, one of them would run while the other cores have nothing to do.
            set_property(TEST "${module}.${name}" PROPERTY COST 1000)
            if(said MATCHES "Looks at every compiler")
                set_tests_properties("${module}.${name}" PROPERTIES LABELS "${module};every_compiler")
            elseif(said MATCHES "Measures time")
                set_tests_properties("${module}.${name}" PROPERTIES LABELS "${module};perf" RUN_SERIAL TRUE)
            endif()
            # What compiles on all cores itself is not run beside others.
            file(STRINGS ${script} on_all_cores REGEX "^all_done" LIMIT_COUNT 1)
            if(on_all_cores)
                set_tests_properties("${module}.${name}" PROPERTIES RUN_SERIAL TRUE)
            endif()
        endforeach()
    endif()
endforeach()

list(JOIN modules " " modules)
ansatz_note("tests: ${modules} (Catch2 ${Catch2_VERSION})")
foreach(entry IN LISTS wanted)
    string(REPLACE "|" ";" entry "${entry}")
    list(POP_FRONT entry name package target)
    if(NOT TARGET ${target})
        ansatz_left_out("tests" ${name} ${package})
    endif()
endforeach()
