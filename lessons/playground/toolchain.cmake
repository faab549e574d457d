# Cairn for browsers: emscripten's toolchain, and of this machine the libraries of which headers are enough.
# `cmake --preset web`.
execute_process(COMMAND em-config EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND em-config CACHE OUTPUT_VARIABLE cache OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include(${emscripten}/cmake/Modules/Platform/Emscripten.cmake)

# The system's include folder has the headers of this machine's C library beside those of the libraries that are wanted:
# links to these alone.
set(libraries ${CMAKE_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${libraries}/GL)
foreach(library eigen3/Eigen fmt nlohmann stb toml++ KHR GL/glcorearb.h)
  string(REPLACE "eigen3/" "" name ${library})
  file(CREATE_LINK /usr/include/${library} ${libraries}/${name} SYMBOLIC)
endforeach()
# Eigen asks for the headers of MMX, which browsers do not have, and uses none of them.
file(CONFIGURE OUTPUT ${libraries}/mmintrin.h CONTENT "")
# SSE2, as emscripten has it in the browsers' vectors: Eigen then adds in the order that it has on other machines. Its
# headers have to be found before those of clang.
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${libraries} ${cache}/sysroot/include/compat)
set(CMAKE_CXX_FLAGS_INIT "-fexceptions -msimd128 -msse2 -fgnuc-version=5.13 -include ${CMAKE_CURRENT_LIST_DIR}/missing.hpp")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fexceptions -sALLOW_MEMORY_GROWTH=1")
set(STB_INCLUDE_DIR ${libraries} CACHE PATH "Where stb is")
set(CMAKE_PROJECT_INCLUDE ${CMAKE_CURRENT_LIST_DIR}/packages.cmake)
