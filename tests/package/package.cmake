# SPDX-License-Identifier: BSL-1.0
# Ansatz used from outside: installed into a folder of this build and found by CMake and by pkg-config, and as a folder
# of somebody's project. The consumers are the same programs each time, those of the README (tests/tools/readme.sh holds
# them against it).
set(package_prefix ${PROJECT_BINARY_DIR}/scratch/package/prefix)

add_test(NAME package.install COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR}
    -D PREFIX=${package_prefix} -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
set_tests_properties(package.install PROPERTIES FIXTURES_SETUP installed LABELS package)

foreach(way find_package add_subdirectory)
    set(consumer_build ${PROJECT_BINARY_DIR}/scratch/package/${way})
    add_test(NAME package.${way} COMMAND ${CMAKE_CTEST_COMMAND}
        --build-and-test ${CMAKE_CURRENT_LIST_DIR}/${way} ${consumer_build}
        --build-generator ${CMAKE_GENERATOR} --build-noclean
        --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Debug
            -DCMAKE_PREFIX_PATH=${package_prefix} -DANSATZ_SOURCE=${PROJECT_SOURCE_DIR}
        --test-command ${consumer_build}/consumer)
    set_tests_properties(package.${way} PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 300
        # It must have run to its end, and after a second on the moon still be in flight.
        PASS_REGULAR_EXPRESSION "2 s: \\([0-9.]+, -?[0-9.]+, 0\\) m, [0-9.]+ J")
endforeach()

# One policy of a user's own of each kind.
set(models_build ${PROJECT_BINARY_DIR}/scratch/package/models)
add_test(NAME package.models COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${CMAKE_CURRENT_LIST_DIR}/models ${models_build}
    --build-generator ${CMAKE_GENERATOR} --build-noclean
    --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=Debug
        -DCMAKE_PREFIX_PATH=${package_prefix}
    --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
set_tests_properties(package.models PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 600)

find_program(ANSATZ_PKG_CONFIG pkg-config)
mark_as_advanced(ANSATZ_PKG_CONFIG)
if(ANSATZ_PKG_CONFIG AND ANSATZ_BASH)
    add_test(NAME package.pkg_config COMMAND ${ANSATZ_BASH} ${CMAKE_CURRENT_LIST_DIR}/pkg_config.sh
        ${CMAKE_CXX_COMPILER} ${package_prefix} ${PROJECT_BINARY_DIR}/scratch/package)
    set_tests_properties(package.pkg_config PROPERTIES FIXTURES_REQUIRED installed LABELS package TIMEOUT 300)
else()
    ansatz_left_out("test package.pkg_config" pkg-config pkg-config)
endif()
