# SPDX-License-Identifier: BSL-1.0
# What only the people who work on Ansatz need. Everything here is found by itself: a new header, test, section or
# exercise needs no edit of a CMake file. What cannot be built is left out with a sentence, never with an error.

option(ANSATZ_COMPILE_TIME_TESTS "Headers alone, tests/static, tests/archetypes, tests/must_not_compile" ON)
option(ANSATZ_NATIVE "Compile what measures time for this very machine (-march=native)" ON)

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
enable_testing()

# ------------------------------------------------------------------ what was found, what is left out (printed at the end)
function(ansatz_note text)
    set_property(GLOBAL APPEND PROPERTY ansatz_notes "${text}")
endfunction()
function(ansatz_left_out what missing debian_package)
    set_property(GLOBAL APPEND PROPERTY ansatz_left_out
        "${what}, for want of ${missing} (on Debian: apt install ${debian_package})")
endfunction()

include(cmake/Ccache.cmake)

# g++ looks for garbage whenever its heap has doubled, from 128 MB on. For the sources that are several files together that is a
# sixth of the compiler's time, for the programs of a large exercise a twelfth (measured). Without it until 2 GB the largest of them
# take 6 GB (measured), so that is for machines with 8 GB a processor. What it writes is the same.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # MiB
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory_of_each "${memory} / ${processors}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND memory_of_each GREATER 8000)
    add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:--param ggc-min-heapsize=2000000>")
endif()

# ------------------------------------------------------------------ warnings
# Errors with the compilers that we test with; another one may know warnings that we have not seen, and a student's
# build must not break on those.
set(known_compilers GNU-12 Clang-14 Clang-19)
string(REGEX MATCH "^[0-9]+" compiler_major "${CMAKE_CXX_COMPILER_VERSION}")
if("${CMAKE_CXX_COMPILER_ID}-${compiler_major}" IN_LIST known_compilers)
    set(known_compiler ON)
else()
    set(known_compiler OFF)
endif()
option(ANSATZ_WARNINGS_AS_ERRORS "-Werror in tests and chapters" ${known_compiler})

# What every program of ours is compiled with. Its own helpers are included by their place in the project:
# "tests/catch.hpp", "tools/plot.hpp".
add_library(ansatz_development INTERFACE)
target_link_libraries(ansatz_development INTERFACE ansatz)
target_include_directories(ansatz_development INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(ansatz_development INTERFACE -Wall -Wextra -Wpedantic -Wshadow
    $<$<BOOL:${ANSATZ_WARNINGS_AS_ERRORS}>:-Werror>
    # What g++ 12 guesses while it optimises is mostly wrong, inside std::string (GCC 105329) and, with the sanitizers,
    # inside <regex> (GCC 105616); what it guesses right the sanitizers find.
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-maybe-uninitialized;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>"
    # g++ tries to evaluate every lambda that could be constexpr, a test's loop of a million steps too, and gives up late.
    "$<$<CXX_COMPILER_ID:GNU>:-fconstexpr-ops-limit=1000000>"
    # ccache can keep a precompiled header only if the compiler makes it reproducible.
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang,AppleClang>:SHELL:-Xclang -fno-pch-timestamp>")

# What measures time besides; it knows the flags it is measured with, to print them beside its table.
add_library(ansatz_measured INTERFACE)
target_link_libraries(ansatz_measured INTERFACE ansatz_development)
string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags_of_type)
list(JOIN ANSATZ_COMPILE_OPTIONS " " flags)
string(STRIP "${CMAKE_CXX_FLAGS} ${${flags_of_type}} ${flags}" flags)
# Beside libraries that were compiled for every machine it is compiled so, too.
add_library(ansatz_compared INTERFACE)
target_link_libraries(ansatz_compared INTERFACE ansatz_development)
target_compile_definitions(ansatz_compared INTERFACE ANSATZ_FLAGS="${flags}")
if(ANSATZ_NATIVE)
    target_compile_options(ansatz_measured INTERFACE -march=native)
    string(APPEND flags " -march=native")
endif()
target_compile_definitions(ansatz_measured INTERFACE ANSATZ_FLAGS="${flags}")

include(cmake/ThirdParty.cmake)
include(cmake/Together.cmake)

foreach(tree tests chapters exercises)
    if(EXISTS ${PROJECT_SOURCE_DIR}/${tree}/CMakeLists.txt)
        add_subdirectory(${tree})
    endif()
endforeach()

# ------------------------------------------------------------------ the report
set(with_ccache "")
if(ANSATZ_CCACHE)
    set(with_ccache " with ccache")
endif()
set(warnings "warnings are errors")
if(NOT ANSATZ_WARNINGS_AS_ERRORS)
    set(warnings "warnings are no errors")
endif()
message(STATUS "Ansatz ${PROJECT_VERSION}: ${CMAKE_BUILD_TYPE}, ${CMAKE_CXX_COMPILER_ID} "
    "${CMAKE_CXX_COMPILER_VERSION}${with_ccache}, ${warnings}")
message(STATUS "  stands on: Boost ${Boost_VERSION_STRING}, Eigen ${Eigen3_VERSION}")
get_property(notes GLOBAL PROPERTY ansatz_notes)
foreach(note IN LISTS notes)
    message(STATUS "  ${note}")
endforeach()
get_property(left_out GLOBAL PROPERTY ansatz_left_out)
foreach(text IN LISTS left_out)
    message(STATUS "  left out: ${text}")
endforeach()
