# SPDX-License-Identifier: BSL-1.0
# The whole library, read once by a compiler for all the mistakes that it is to find; five times faster than reading it
# for each. A test that those need, and not a part of the build: so it is never older than the library.
#
#   cmake -D COMPILER=... [what compiler.cmake reads] -D PRECOMPILED=<folder> -D LIBRARY=<include> -P precompile.cmake
#
# One header for each group of modules that mistakes take together: what templates a precompiled header has begun, g++
# finishes again in every file that reads it, 0.9 s for all that has to do with bodies and 0.2 s without soft bodies and water.
# For clang++, which keeps them finished, one.
#
# LAUNCHER, with | between its words, is what goes before the compiler: ccache, which knows a header by the contents of all that
# it includes. It must be one that leaves paths as they are; the headers keep them.
set(MAKES_PRECOMPILED ON)
include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)

file(REMOVE_RECURSE ${PRECOMPILED}/mended)    # it was found with an older library
file(GLOB umbrellas RELATIVE ${LIBRARY}/ansatz ${LIBRARY}/ansatz/*.hpp)
list(REMOVE_ITEM umbrellas execution.hpp)    # it needs oneTBB, which a machine may not have; no mistake is about it
list(REMOVE_ITEM flags -fsyntax-only)
set(groups bodies paths soft_bodies states water)
set(suffix gch)
string(REPLACE "|" ";" LAUNCHER "${LAUNCHER}")
set(reproducible -fpch-preprocess)    # for ccache
if(family STREQUAL "clang++")
    set(suffix pch)
    set(reproducible -Xclang -fno-pch-timestamp)
    # What the library's own inline functions instantiate is kept with it: else every mistake instantiates it again.
    list(APPEND flags -fpch-instantiate-templates)
    list(REMOVE_ITEM groups soft_bodies water)    # see compiler.cmake
endif()
foreach(group IN LISTS groups)
    set(text "")
    foreach(umbrella IN LISTS umbrellas)
        set(of bodies)
        if(umbrella MATCHES "^(paths|soft_bodies|states|water)")
            set(of ${CMAKE_MATCH_1})
        endif()
        if(group STREQUAL of)
            string(APPEND text "#include <ansatz/${umbrella}>\n")
        endif()
    endforeach()
    set(header ${PRECOMPILED}/${group}.hpp)
    file(WRITE ${header} "${text}")
    execute_process(COMMAND ${LAUNCHER} ${COMPILER} ${flags} ${reproducible} -MD -MF ${header}.d -x c++-header -c ${header}
        -o ${header}.${suffix} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
