# cmake --install: programs (ManylightTargets.cmake says where), headers, libraries and the CMake package `manylight`.
include(CMakePackageConfigHelpers)

set(manylight_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/manylight)

# The order of the dependency arrow; manylight_shaders carries no file but is on gpu's link line.
set(MANYLIGHT_LIBRARIES core math image metrics scene accel gpu graph passes techniques)
list(TRANSFORM MANYLIGHT_LIBRARIES PREPEND manylight_ OUTPUT_VARIABLE manylight_library_targets)

install(TARGETS ${manylight_library_targets} manylight_shaders EXPORT manylight
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT manylight NAMESPACE manylight:: FILE manylightTargets.cmake DESTINATION ${manylight_package_dir})

# The headers keep their folders, as their own #include lines name them.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/engine DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/manylight
  FILES_MATCHING PATTERN *.h)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/shaders/shared DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/manylight/shaders
  FILES_MATCHING PATTERN *.h)

configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/manylightConfig.cmake.in
  ${CMAKE_BINARY_DIR}/generated/manylightConfig.cmake INSTALL_DESTINATION ${manylight_package_dir})
# Before 1.0 a new minor version may change any interface.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/manylightConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_BINARY_DIR}/generated/manylightConfig.cmake
  ${CMAKE_BINARY_DIR}/generated/manylightConfigVersion.cmake
  ${CMAKE_SOURCE_DIR}/cmake/LibraryDependencies.cmake
  DESTINATION ${manylight_package_dir})
