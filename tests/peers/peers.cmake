# SPDX-License-Identifier: BSL-1.0
# tests/peers/<area>/*.cpp   one program an area, peers_<area>, that times the library beside others; built only when
#                            `./workbook peers` asks for it. What was not found is left out, and the program says so.
find_package(nlohmann_json 3 CONFIG QUIET)
if(NOT nlohmann_json_FOUND)
    ansatz_left_out("the contest with other libraries (./workbook peers)" nlohmann-json nlohmann-json3-dev)
    return()
endif()
find_path(ANSATZ_CGAL_INCLUDE CGAL/box_intersection_d.h)
find_path(ANSATZ_FCL_INCLUDE fcl/broadphase/broadphase_dynamic_AABB_tree_array.h)
find_library(ANSATZ_FCL_LIBRARY fcl)
find_library(ANSATZ_CCD_LIBRARY ccd)
find_path(ANSATZ_BULLET_INCLUDE btBulletCollisionCommon.h PATH_SUFFIXES bullet)
find_library(ANSATZ_BULLET_COLLISION BulletCollision)
find_library(ANSATZ_BULLET_MATH LinearMath)
find_library(ANSATZ_BULLET_DYNAMICS BulletDynamics)
find_library(ANSATZ_BULLET_SOFT_BODY BulletSoftBody)
find_path(ANSATZ_ODE_INCLUDE ode/ode.h)
find_library(ANSATZ_ODE_LIBRARY ode)
find_path(ANSATZ_BOX2D_INCLUDE box2d/box2d.h)
find_library(ANSATZ_BOX2D_LIBRARY box2d)
mark_as_advanced(ANSATZ_ODE_INCLUDE ANSATZ_ODE_LIBRARY ANSATZ_BULLET_DYNAMICS ANSATZ_BULLET_SOFT_BODY ANSATZ_CGAL_INCLUDE ANSATZ_FCL_INCLUDE ANSATZ_FCL_LIBRARY ANSATZ_CCD_LIBRARY ANSATZ_BULLET_INCLUDE
    ANSATZ_BULLET_COLLISION ANSATZ_BULLET_MATH)
mark_as_advanced(ANSATZ_BOX2D_INCLUDE ANSATZ_BOX2D_LIBRARY)

# Every peer is a library of its own, so that its headers and flags are seen by nobody else. Its folder names the area,
# whose program it is a part of.
function(ansatz_peer target source definition include)
    string(REGEX MATCH "^peers/([a-z_]+)/" area "${source}")
    set(program peers_${CMAKE_MATCH_1})
    if(NOT include)
        return()
    endif()
    foreach(library IN LISTS ARGN)
        if(NOT library)
            return()
        endif()
    endforeach()
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${source})
    target_compile_features(${target} PRIVATE cxx_std_20)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    target_include_directories(${target} SYSTEM PRIVATE ${include})
    target_link_libraries(${target} PRIVATE Boost::headers Eigen3::Eigen)
    target_compile_definitions(${program} PRIVATE ${definition})
    target_link_libraries(${program} PRIVATE ${target} ${ARGN})
endfunction()

add_executable(peers_collision EXCLUDE_FROM_ALL peers/collision/main.cpp peers/collision/piles.cpp)
target_link_libraries(peers_collision PRIVATE ansatz_compared nlohmann_json::nlohmann_json)
target_include_directories(peers_collision PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_collision PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
ansatz_peer(peer_cgal peers/collision/cgal.cpp ANSATZ_PEER_CGAL "${ANSATZ_CGAL_INCLUDE}")
ansatz_peer(peer_fcl peers/collision/fcl.cpp ANSATZ_PEER_FCL "${ANSATZ_FCL_INCLUDE}" "${ANSATZ_FCL_LIBRARY}" "${ANSATZ_CCD_LIBRARY}")
ansatz_peer(peer_bullet peers/collision/bullet.cpp ANSATZ_PEER_BULLET "${ANSATZ_BULLET_INCLUDE}" "${ANSATZ_BULLET_COLLISION}" "${ANSATZ_BULLET_MATH}")
ansatz_peer(peer_bullet_pile peers/collision/bullet_pile.cpp ANSATZ_PEER_BULLET_PILE "${ANSATZ_BULLET_INCLUDE}" "${ANSATZ_BULLET_DYNAMICS}"
    "${ANSATZ_BULLET_COLLISION}" "${ANSATZ_BULLET_MATH}")
ansatz_peer(peer_ode_pile peers/collision/ode_pile.cpp ANSATZ_PEER_ODE "${ANSATZ_ODE_INCLUDE}" "${ANSATZ_ODE_LIBRARY}")

# Path finding is held against Boost.Graph, which is there.
add_executable(peers_paths EXCLUDE_FROM_ALL peers/paths/main.cpp)
target_link_libraries(peers_paths PRIVATE ansatz_measured nlohmann_json::nlohmann_json)
target_compile_definitions(peers_paths PRIVATE "ANSATZ_PROJECT_FOLDER=\"${PROJECT_SOURCE_DIR}\"")
target_include_directories(peers_paths PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_paths PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# Water is held against loops that are written by hand.
add_executable(peers_water EXCLUDE_FROM_ALL peers/water/main.cpp)
target_link_libraries(peers_water PRIVATE ansatz_measured nlohmann_json::nlohmann_json)
target_include_directories(peers_water PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_water PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# The library is held against itself, with a hundred times as many bodies.
add_executable(peers_scale EXCLUDE_FROM_ALL peers/scale/main.cpp)
target_link_libraries(peers_scale PRIVATE ansatz_measured nlohmann_json::nlohmann_json)
target_include_directories(peers_scale PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_scale PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# The library is held against itself, with several threads.
find_package(TBB CONFIG QUIET)
add_executable(peers_threads EXCLUDE_FROM_ALL peers/threads/main.cpp)
target_link_libraries(peers_threads PRIVATE ansatz_measured nlohmann_json::nlohmann_json $<TARGET_NAME_IF_EXISTS:TBB::tbb>)
target_include_directories(peers_threads PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_threads PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# Soft bodies are held against Eigen's matrices, a loop that is written by hand, and Bullet where it was found.
add_executable(peers_soft_bodies EXCLUDE_FROM_ALL peers/soft_bodies/main.cpp)
target_link_libraries(peers_soft_bodies PRIVATE ansatz_measured nlohmann_json::nlohmann_json)
target_include_directories(peers_soft_bodies PRIVATE ${PROJECT_SOURCE_DIR}/tools)
set_target_properties(peers_soft_bodies PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
ansatz_peer(peer_bullet_sheet peers/soft_bodies/bullet.cpp ANSATZ_PEER_BULLET_SOFT "${ANSATZ_BULLET_INCLUDE}"
    "${ANSATZ_BULLET_SOFT_BODY}" "${ANSATZ_BULLET_DYNAMICS}" "${ANSATZ_BULLET_COLLISION}" "${ANSATZ_BULLET_MATH}")

# The hard cases, played by other engines as well: what is measured is errors and not time.
add_executable(peers_cases EXCLUDE_FROM_ALL peers/cases/main.cpp peers/cases/table.cpp peers/cases/bounces.cpp
    peers/cases/heaps.cpp peers/cases/sleep.cpp peers/cases/springs.cpp peers/cases/broadphases.cpp
    peers/cases/ansatz_double.cpp peers/cases/ansatz_float.cpp)
target_link_libraries(peers_cases PRIVATE ansatz_compared nlohmann_json::nlohmann_json)
target_include_directories(peers_cases PRIVATE ${PROJECT_SOURCE_DIR}/tools)
target_compile_definitions(peers_cases PRIVATE "ANSATZ_PEERS_VERSION=\"${PROJECT_VERSION}\"")
set_target_properties(peers_cases PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
ansatz_peer(peer_bullet_cases peers/cases/bullet.cpp ANSATZ_PEER_BULLET_CASES "${ANSATZ_BULLET_INCLUDE}"
    "${ANSATZ_BULLET_DYNAMICS}" "${ANSATZ_BULLET_COLLISION}" "${ANSATZ_BULLET_MATH}")
ansatz_peer(peer_ode_cases peers/cases/ode.cpp ANSATZ_PEER_ODE_CASES "${ANSATZ_ODE_INCLUDE}" "${ANSATZ_ODE_LIBRARY}")
ansatz_peer(peer_box2d_cases peers/cases/box2d.cpp ANSATZ_PEER_BOX2D_CASES "${ANSATZ_BOX2D_INCLUDE}"
    "${ANSATZ_BOX2D_LIBRARY}")
