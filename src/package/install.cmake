# What `cmake --install` gives: the library for programs outside of this tree, and the programs that were built.
# Components: library (headers, archives, and how CMake and pkg-config find them) and programs.
include(CMakePackageConfigHelpers)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/cairn)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/cairn)

# Before anything is copied: what was not built cannot be installed. CMake breaks no line that begins with a space.
set(installed_archives "")
foreach(archive cairn cairn_world cairn_reference)
  if(TARGET ${archive})
    string(APPEND installed_archives " \"$<TARGET_FILE:${archive}>\"")
  endif()
endforeach()
install(CODE "foreach(archive${installed_archives})
  if(NOT EXISTS \"\${archive}\")
    message(FATAL_ERROR \" \${archive} is not built, and nothing was installed.\\n First: cmake --build ${PROJECT_BINARY_DIR}\")
  endif()
endforeach()" COMPONENT library)

# cairn_install_room(TARGET NAME EXPORT folders of src...): an archive with its headers, found as cairn::NAME.
function(cairn_install_room target name export)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  install(TARGETS ${target} EXPORT ${export} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
  install(EXPORT ${export} NAMESPACE cairn:: DESTINATION ${package_folder} COMPONENT library)
  foreach(folder IN LISTS ARGN)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${folder} DESTINATION ${header_folder} COMPONENT library
            FILES_MATCHING PATTERN "*.hpp")
  endforeach()
endfunction()

# A user's numbers are to be those of Cairn's own programs; an archive with sanitizers asks for their libraries.
target_compile_options(cairn INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
# Who uses what is installed names one library, and has both archives.
target_link_libraries(cairn INTERFACE $<INSTALL_INTERFACE:Eigen3::Eigen> $<INSTALL_INTERFACE:cairn::world>)
set(pkg_config_libraries "-lcairn_world -lcairn -pthread")
if(CAIRN_SANITIZE)
  target_link_options(cairn INTERFACE $<INSTALL_INTERFACE:-fsanitize=${CAIRN_SANITIZE}>)
  string(APPEND pkg_config_libraries " -fsanitize=${CAIRN_SANITIZE}")
endif()
set(CAIRN_PUBLIC_ROOMS ${CAIRN_FLOORS})
set_target_properties(cairn_world PROPERTIES EXPORT_NAME world)
install(TARGETS cairn_world EXPORT cairnTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
cairn_install_room(cairn cairn cairnTargets ${CAIRN_FLOORS})
install(FILES ${PROJECT_SOURCE_DIR}/src/cairn.hpp DESTINATION ${header_folder} COMPONENT library)
if(TARGET cairn_reference)
  list(APPEND CAIRN_PUBLIC_ROOMS reference)
  cairn_install_room(cairn_reference reference cairnReferenceTargets reference)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cairnConfig.cmake.in ${PROJECT_BINARY_DIR}/cairnConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cairnConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cairnConfig.cmake ${PROJECT_BINARY_DIR}/cairnConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT library)

# From the folder of cairn.pc back to the prefix: what is installed may be moved, and --prefix be chosen late.
set(pkg_config_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pkg_config_to_prefix /prefix/${pkg_config_folder} /prefix)
string(REGEX REPLACE "/$" "" pkg_config_to_prefix "${pkg_config_to_prefix}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/cairn.pc.in ${PROJECT_BINARY_DIR}/cairn.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cairn.pc DESTINATION ${pkg_config_folder} COMPONENT library)

# What the programs read (data_folder() finds it): scenes, recommendations, and the texts of the lessons. In the build
# links stand in its place, so that what is edited is what is read.
set(data_folder ${CMAKE_INSTALL_DATADIR}/cairn)
if(TARGET cairn_sandbox)
  install(DIRECTORY lessons/scenes DESTINATION ${data_folder} COMPONENT programs FILES_MATCHING PATTERN "*.toml")
  install(FILES lessons/sandbox/recommended.json DESTINATION ${data_folder} COMPONENT programs)
endif()
if(TARGET lessons)
  install(DIRECTORY lessons DESTINATION ${data_folder} COMPONENT programs
          FILES_MATCHING REGEX "/[0-9][0-9]_[a-z_]+/(README|teaching)\\.md$"
          REGEX "/[0-9][0-9]_[a-z_]+/(exercise\\.cpp|model\\.txt|covers\\.txt)$"
          REGEX "/lessons/(conclusion|glossary|prerequisites)\\.md$" REGEX "/your_solver/(README\\.md|stages/[0-9]+\\.txt)$"
          REGEX "/driver/book(_[a-z]+)?\\.(css|html|js|lua|md)$"
          REGEX "/(sandbox|scenes|template)$" EXCLUDE)
  install(FILES src/NOTATION.md DESTINATION ${data_folder}/src COMPONENT programs)
endif()
set(built_data ${PROJECT_BINARY_DIR}/share/cairn)
file(MAKE_DIRECTORY ${built_data})
foreach(data lessons/scenes lessons/sandbox/recommended.json lessons src)
  get_filename_component(name ${data} NAME)
  file(RELATIVE_PATH target ${built_data} ${PROJECT_SOURCE_DIR}/${data})
  file(CREATE_LINK ${target} ${built_data}/${name} SYMBOLIC)
endforeach()
# The driver starts the lessons that it finds beside it.
foreach(program cairn_sandbox lessons ${CAIRN_LESSONS})
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs OPTIONAL)
  endif()
endforeach()
