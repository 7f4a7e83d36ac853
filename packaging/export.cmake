# The engine for other projects: find_package(Handlebody), Handlebody::core. docs/examples/grow is such a project.
# Component Development, which the programs' package leaves out.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Handlebody)
set_target_properties(handlebody_core PROPERTIES EXPORT_NAME core)
set_target_properties(handlebody_options PROPERTIES EXPORT_NAME options)
install(TARGETS handlebody_core handlebody_options EXPORT HandlebodyTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development)
# As they are included: "core/mesh/mesh.h".
install(DIRECTORY ${CMAKE_SOURCE_DIR}/core DESTINATION ${HANDLEBODY_INCLUDE_FOLDER} COMPONENT Development
  FILES_MATCHING PATTERN "*.h" PATTERN "io" EXCLUDE PATTERN "precompiled.h" EXCLUDE)
install(FILES ${CMAKE_BINARY_DIR}/generated/core/version.h DESTINATION ${HANDLEBODY_INCLUDE_FOLDER}/core
  COMPONENT Development)
install(EXPORT HandlebodyTargets NAMESPACE Handlebody:: DESTINATION ${package_folder} COMPONENT Development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/HandlebodyConfig.cmake.in HandlebodyConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# Below 1.0 another minor version may have another interface.
write_basic_package_version_file(HandlebodyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/HandlebodyConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/HandlebodyConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT Development)
