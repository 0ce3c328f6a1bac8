# SPDX-License-Identifier: BSL-1.0
# What is tested by compiling: each header alone, static tests, archetypes; and by not compiling.

# ------------------------------------------------------------------ every public header by itself, twice
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/*.hpp)
# What only some headers need, and a library with a world has not: they are left out where it is not installed.
find_path(ANSATZ_TBB oneapi/tbb/parallel_for.h)
find_package(MPI QUIET COMPONENTS CXX)
find_path(ANSATZ_BOOST_MPI boost/mpi/communicator.hpp)
mark_as_advanced(ANSATZ_TBB ANSATZ_BOOST_MPI)
if(NOT ANSATZ_TBB)
    ansatz_left_out("the headers of execution/ that run threads, alone" oneTBB libtbb-dev)
    list(FILTER headers EXCLUDE REGEX "execution(/threads|/on_threads)?\\.hpp$")
endif()
if(NOT MPI_CXX_FOUND OR NOT ANSATZ_BOOST_MPI)
    ansatz_left_out("execution/on_ranks.hpp, alone" Boost.MPI libboost-mpi-dev)
    list(FILTER headers EXCLUDE REGEX "execution/on_ranks\\.hpp$")
endif()
set(alone)
foreach(header IN LISTS headers)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include <${header}>\n#include <${header}>\n")
    list(APPEND alone ${source})
endforeach()
list(LENGTH alone count)
if(alone)
    add_library(headers_alone OBJECT ${alone})
    target_link_libraries(headers_alone PRIVATE ansatz_quick)
    target_compile_options(headers_alone PRIVATE -Wconversion)
    if(MPI_CXX_FOUND)
        target_include_directories(headers_alone SYSTEM PRIVATE ${MPI_CXX_INCLUDE_DIRS})
    endif()
    ansatz_precompile_third_party(headers_alone)
endif()
ansatz_note("headers compiled alone: ${count}")

# ------------------------------------------------------------------ compiling is the test
foreach(folder static archetypes)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(sources)
        add_library(${folder}_tests OBJECT ${sources})
        target_link_libraries(${folder}_tests PRIVATE ansatz_quick)
        ansatz_precompile_third_party(${folder}_tests)
    endif()
endforeach()

# ------------------------------------------------------------------ not compiling is the test: check.cmake
# With these compilers, whichever one this build uses: a sentence must be readable in all of them. The newest clang has a
# stage of its own, `.ci/run clang-19-mistakes`: what it alone says otherwise is seen there, before a close.
set(ANSATZ_MISTAKES_WITH "g++;clang++" CACHE STRING "The compilers that must refuse tests/must_not_compile")
set(compilers ${ANSATZ_MISTAKES_WITH})
set(found)
foreach(compiler IN LISTS compilers)
    string(MAKE_C_IDENTIFIER "ANSATZ_CHECK_${compiler}" variable)
    find_program(${variable} ${compiler})
    mark_as_advanced(${variable})
    if(${variable})
        list(APPEND found ${compiler})
    else()
        string(REPLACE "++" "" package ${compiler})
        ansatz_left_out("mistakes that must not compile with ${compiler}" ${compiler} ${package})
    endif()
endforeach()

set(boost $<JOIN:$<TARGET_PROPERTY:Boost::headers,INTERFACE_INCLUDE_DIRECTORIES>,|>)
set(eigen $<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,|>)
set(folder ${CMAKE_CURRENT_SOURCE_DIR}/must_not_compile)
file(GLOB_RECURSE mistakes CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.cpp)
foreach(compiler IN LISTS found)
    string(MAKE_C_IDENTIFIER "ANSATZ_CHECK_${compiler}" variable)
    set(call ${CMAKE_COMMAND} -DCOMPILER=${${variable}}
        "-DINCLUDES=${PROJECT_SOURCE_DIR}/include|${PROJECT_SOURCE_DIR}"
        "-DSYSTEM_INCLUDES=${boost}|${eigen}"
        "-DPRECOMPILED=${PROJECT_BINARY_DIR}/scratch/must_not_compile/${compiler}")

    set(fixture precompiled.${compiler})
    list(JOIN ANSATZ_LAUNCHER_IN_PLACE "|" launcher)
    if(mistakes)
        add_test(NAME must_not_compile.${fixture}
            COMMAND ${call} -DLIBRARY=${PROJECT_SOURCE_DIR}/include -DLAUNCHER=${launcher} -P ${folder}/precompile.cmake)
        set_tests_properties(must_not_compile.${fixture} PROPERTIES
            FIXTURES_SETUP ${fixture} LABELS must_not_compile TIMEOUT 600)
        # Half of the compiler's time for them, where all are asked for; one alone does not wait for it.
        if(ANSATZ_PYTHON)
            add_test(NAME must_not_compile.mended.${compiler} COMMAND ${call} -DPYTHON=${ANSATZ_PYTHON}
                -DMENDED=${PROJECT_SOURCE_DIR}/tools/workshop/mended.py -P ${folder}/mended.cmake)
            set_tests_properties(must_not_compile.mended.${compiler} PROPERTIES
                FIXTURES_REQUIRED ${fixture} LABELS must_not_compile TIMEOUT 600)
        endif()
    endif()
    foreach(mistake IN LISTS mistakes)
        string(REGEX REPLACE "\\.cpp$" "" name ${mistake})
        add_test(NAME must_not_compile.${name}.${compiler}
            COMMAND ${call} -DFILE=${folder}/${mistake} -P ${folder}/check.cmake)
        set_tests_properties(must_not_compile.${name}.${compiler} PROPERTIES
            FIXTURES_REQUIRED ${fixture} LABELS must_not_compile TIMEOUT 120
            DEPENDS must_not_compile.mended.${compiler})
    endforeach()
endforeach()
list(LENGTH mistakes count)
list(JOIN found ", " found)
ansatz_note("mistakes that must not compile: ${count}, each with ${found}")
