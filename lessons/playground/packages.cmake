# What find_package finds for browsers: libraries of which headers are enough, where the toolchain has them.
foreach(package Eigen3=Eigen3::Eigen fmt=fmt::fmt=FMT_HEADER_ONLY nlohmann_json=nlohmann_json::nlohmann_json
                tomlplusplus=tomlplusplus::tomlplusplus=TOML_HEADER_ONLY=1)
  string(REGEX MATCH "^([^=]+)=([^=]+)=?(.*)$" parts ${package})
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${CMAKE_MATCH_1}Config.cmake
       "include_guard(GLOBAL)
add_library(${CMAKE_MATCH_2} INTERFACE IMPORTED)
target_include_directories(${CMAKE_MATCH_2} INTERFACE ${PROJECT_BINARY_DIR}/include)
target_compile_definitions(${CMAKE_MATCH_2} INTERFACE ${CMAKE_MATCH_3})\n")
endforeach()
