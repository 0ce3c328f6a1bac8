# SPDX-License-Identifier: BSL-1.0
# The mended forms of all mistakes, many in one run of the compiler: what is found clean so need not be compiled alone.
# It follows precompile.cmake, which takes away what an earlier run found.
#
#   cmake -D COMPILER=... [what compiler.cmake reads] -D PYTHON=<python3> -D MENDED=<mended.py> -P mended.cmake

file(GLOB mistakes ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
set(groups)
foreach(FILE IN LISTS mistakes)    # by the precompiled header that it gets
    include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)
    list(APPEND groups ${group})
    list(APPEND files_${group} ${FILE})
    set(flags_${group} ${flags})
endforeach()
list(REMOVE_DUPLICATES groups)
foreach(group IN LISTS groups)
    execute_process(COMMAND ${PYTHON} ${MENDED} ${PRECOMPILED}/mended ${files_${group}} -- ${COMPILER} ${flags_${group}}
        COMMAND_ERROR_IS_FATAL ANY)
endforeach()
