# SPDX-License-Identifier: BSL-1.0
# ccache, by itself: where it is installed, whatever is compiled goes through it. Tested by tests/tools/ccache.sh.

find_program(ANSATZ_CCACHE ccache)
mark_as_advanced(ANSATZ_CCACHE)
set(ANSATZ_LAUNCHER_IN_PLACE ${CMAKE_CXX_COMPILER_LAUNCHER})
if(ANSATZ_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # The sloppiness is what ccache asks for to work with precompiled headers. As it comes, it takes a second of processor time
    # for a file that it does not know (it runs the preprocessor, which reads the precompiled header of 140 MB, and hashes that
    # header) and 0.75 s for one that it knows. The compiler's own list of dependencies names the same files, and what has not
    # changed since it was hashed needs no second look: half a second, and 0.03 s.
    set(settings CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_DEPEND=1 CCACHE_INODECACHE=1)
    # With the project's folder as its base, paths inside it are handed to the compiler relative to the build folder, so that
    # another checkout finds what this one has compiled; errors are still said with whole paths.
    # g++ does not write a precompiled header twice with the same bytes, and what is compiled with it is known by them: two
    # checkouts that compile one for the first time at once have a header each, and from then on share nothing behind it.
    # Not where that path has a space, #, $ or the like: ccache 4.7 overlooks such paths in the compiler's list of dependencies
    # and would hand the list of one checkout to another, which then waits for changes in the first one's files.
    set(shared "")
    if(PROJECT_SOURCE_DIR MATCHES "^[A-Za-z0-9_./+,@~=:-]+$")
        set(shared CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_ABSSTDERR=1)
        # A debugger must find the sources of this checkout, the trace of a sanitizer need not.
        string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" flags_of_type)
        if(NOT "${CMAKE_CXX_FLAGS} ${${flags_of_type}}" MATCHES " -g( |$)")
            list(APPEND shared CCACHE_NOHASHDIR=1)
        endif()
    endif()
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${settings} ${shared} ${ANSATZ_CCACHE})
    # For a program that asks where its own source lies (__FILE__) while it runs.
    set(ANSATZ_LAUNCHER_IN_PLACE ${CMAKE_COMMAND} -E env ${settings} ${ANSATZ_CCACHE})
endif()
