# The reference of the headers that are installed, where Doxygen is installed: cmake --build build/release --target reference_docs
find_program(CAIRN_DOXYGEN doxygen)
if(CAIRN_DOXYGEN)
  set(CAIRN_DOCS_FOLDER ${PROJECT_BINARY_DIR}/doc)
  set(CAIRN_DOCS_INPUT ${CAIRN_FLOORS} reference cairn.hpp)
  list(TRANSFORM CAIRN_DOCS_INPUT REPLACE "(.+)" "\"${PROJECT_SOURCE_DIR}/src/\\1\"")
  list(APPEND CAIRN_DOCS_INPUT "\"${CMAKE_CURRENT_LIST_DIR}/reference.md\"")
  list(JOIN CAIRN_DOCS_INPUT " " CAIRN_DOCS_INPUT)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(reference_docs
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${CAIRN_DOCS_FOLDER}
    COMMAND ${CAIRN_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
    COMMENT "Writing ${CAIRN_DOCS_FOLDER}/html/index.html" VERBATIM)
endif()
