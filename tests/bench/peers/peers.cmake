# A program that steps the same scenes with Cairn and with every peer that is installed.
add_executable(cairn_peers EXCLUDE_FROM_ALL bench/peers/adapter_check.cpp bench/peers/benchmark_scenes.cpp
  bench/peers/cairn_engine.cpp bench/peers/edit_table.cpp bench/peers/errors.cpp bench/peers/peer_list.cpp
  bench/peers/peer_scenes.cpp bench/peers/peer_tables.cpp bench/peers/peers_main.cpp bench/peers/phase_table.cpp
  bench/peers/runs.cpp)
target_link_libraries(cairn_peers PRIVATE cairn_study cairn_bench_base)

# cairn_add_peer(NAME FILE INCLUDES LIBRARIES): the adapter in FILE alone sees the peer's headers, so that two peers may
# have headers of the same name.
function(cairn_add_peer name file includes libraries)
  string(TOLOWER cairn_peer_${name} target)
  add_library(${target} STATIC EXCLUDE_FROM_ALL bench/peers/${file})
  target_include_directories(${target} SYSTEM PRIVATE ${includes})
  target_link_libraries(${target} PRIVATE cairn_scenes fmt::fmt)
  target_link_libraries(cairn_peers PRIVATE ${target} ${libraries})
  target_compile_definitions(cairn_peers PRIVATE CAIRN_PEER_${name})
endfunction()

if(TARGET cairn_reference)
  cairn_add_peer(BOX2D_2 box2d_2_engine.cpp "" box2d::box2d)
  target_link_libraries(cairn_peer_box2d_2 PRIVATE cairn_reference box2d::box2d)
  # By its own words 2.4.1 is 2.4.0.
  target_compile_definitions(cairn_peers PRIVATE CAIRN_BOX2D_2_VERSION="${box2d_VERSION}")
endif()
# Not by find_package: its package and its target have the names of those of 2.4.1.
find_path(BOX2D_3_INCLUDE_DIR box2d/id.h)
find_library(BOX2D_3_LIBRARY box2d HINTS ${BOX2D_3_INCLUDE_DIR}/../lib ${BOX2D_3_INCLUDE_DIR}/../lib64 NO_DEFAULT_PATH)
if(BOX2D_3_INCLUDE_DIR AND BOX2D_3_LIBRARY)
  cairn_add_peer(BOX2D_3 box2d_3_engine.cpp ${BOX2D_3_INCLUDE_DIR} ${BOX2D_3_LIBRARY})
endif()
find_path(CHIPMUNK_INCLUDE_DIR chipmunk/chipmunk.h)
find_library(CHIPMUNK_LIBRARY chipmunk)
if(CHIPMUNK_INCLUDE_DIR AND CHIPMUNK_LIBRARY)
  cairn_add_peer(CHIPMUNK chipmunk_engine.cpp ${CHIPMUNK_INCLUDE_DIR} ${CHIPMUNK_LIBRARY})
endif()
if(PkgConfig_FOUND)
  pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet)
  if(BULLET_FOUND)
    cairn_add_peer(BULLET bullet_engine.cpp "${BULLET_INCLUDE_DIRS}" PkgConfig::BULLET)
  endif()
endif()
