# SPDX-License-Identifier: BSL-1.0
# The whole library, read once by a compiler for all the mistakes that it is to find; five times faster than reading it
# for each. A test that those need, and not a part of the build: so it is never older than the library.
#
#   cmake -D COMPILER=... [what compiler.cmake reads] -D PRECOMPILED=<folder>/ansatz.hpp -D LIBRARY=<include> -P precompile.cmake
set(MAKES_PRECOMPILED ON)
include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)

file(GLOB umbrellas RELATIVE ${LIBRARY} ${LIBRARY}/ansatz/*.hpp)
set(text "")
foreach(umbrella IN LISTS umbrellas)
    string(APPEND text "#include <${umbrella}>\n")
endforeach()
file(WRITE ${PRECOMPILED} "${text}")

set(result ${PRECOMPILED}.gch)
if(family STREQUAL "clang++")
    set(result ${PRECOMPILED}.pch)
endif()
list(REMOVE_ITEM flags -fsyntax-only)
if(family STREQUAL "clang++")
    # What the library's own inline functions instantiate is kept with it: else every mistake instantiates it again.
    list(APPEND flags -fpch-instantiate-templates)
endif()
execute_process(COMMAND ${COMPILER} ${flags} -x c++-header ${PRECOMPILED} -o ${result} COMMAND_ERROR_IS_FATAL ANY)
