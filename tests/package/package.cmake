# SPDX-License-Identifier: BSL-1.0
# Ansatz used from outside: installed into a folder of this build and found by CMake and by pkg-config, and as a folder
# of somebody's project. The consumers are the same programs each time, those of the README (tests/tools/readme.sh holds
# them against it).
set(package_prefix ${PROJECT_BINARY_DIR}/scratch/package/prefix)
# How the consumers are compiled here: with ccache where it is, and without what only a debugger reads.
set(package_cache ${PROJECT_BINARY_DIR}/scratch/package/cache.cmake)
file(CONFIGURE OUTPUT ${package_cache} CONTENT [[
set(CMAKE_CXX_COMPILER_LAUNCHER "@CMAKE_CXX_COMPILER_LAUNCHER@" CACHE STRING "" FORCE)
set(CMAKE_BUILD_TYPE Debug CACHE STRING "" FORCE)
set(CMAKE_CXX_FLAGS_DEBUG -O0 CACHE STRING "" FORCE)
]] @ONLY)

add_test(NAME package.install COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR}
    -D PREFIX=${package_prefix} -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
set_tests_properties(package.install PROPERTIES FIXTURES_SETUP installed LABELS package)

foreach(way find_package add_subdirectory)
    set(consumer_build ${PROJECT_BINARY_DIR}/scratch/package/${way})
    add_test(NAME package.${way} COMMAND ${CMAKE_CTEST_COMMAND}
        --build-and-test ${CMAKE_CURRENT_LIST_DIR}/${way} ${consumer_build}
        --build-generator ${CMAKE_GENERATOR} --build-noclean
        --build-options -C ${package_cache} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
            -DCMAKE_PREFIX_PATH=${package_prefix} -DANSATZ_SOURCE=${PROJECT_SOURCE_DIR}
        --test-command ${consumer_build}/consumer)
    set_tests_properties(package.${way} PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 300 COST 1000
        # It must have run to its end, and after a second on the moon still be in flight.
        PASS_REGULAR_EXPRESSION "2 s: \\([0-9.]+, -?[0-9.]+, 0\\) m, [0-9.]+ J")
endforeach()

# One policy of a user's own of each kind.
set(models_build ${PROJECT_BINARY_DIR}/scratch/package/models)
add_test(NAME package.models COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_LIST_DIR}/models ${models_build}
    --build-generator ${CMAKE_GENERATOR} --build-noclean
    --build-options -C ${package_cache} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
        -DCMAKE_PREFIX_PATH=${package_prefix}
    --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
set_tests_properties(package.models PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 600
    COST 1000)    # begun among the first, like the scripts (modules.cmake)

find_program(ANSATZ_PKG_CONFIG pkg-config)
mark_as_advanced(ANSATZ_PKG_CONFIG)
if(ANSATZ_PKG_CONFIG AND ANSATZ_BASH)
    add_test(NAME package.pkg_config COMMAND ${ANSATZ_BASH} ${CMAKE_CURRENT_LIST_DIR}/pkg_config.sh
        ${CMAKE_CXX_COMPILER} ${package_prefix} ${PROJECT_BINARY_DIR}/scratch/package)
    set_tests_properties(package.pkg_config PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 300 COST 1000)
    list(JOIN CMAKE_CXX_COMPILER_LAUNCHER "|" launcher)
    set_tests_properties(package.pkg_config PROPERTIES ENVIRONMENT "ANSATZ_LAUNCHER=${launcher}")
else()
    ansatz_left_out("test package.pkg_config" pkg-config pkg-config)
endif()
