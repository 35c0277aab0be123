# The library for programs of others, Velum::velum: all modules but those of our programs, by the headers in include/velum.
include(CMakePackageConfigHelpers)
add_library(velum_velum INTERFACE)
target_include_directories(velum_velum INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
target_link_libraries(velum_velum INTERFACE velum_session)
set_target_properties(velum_velum PROPERTIES EXPORT_NAME velum)
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Velum")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/VelumConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(TARGETS velum_velum EXPORT Velum COMPONENT library)
install(EXPORT Velum NAMESPACE Velum:: FILE VelumTargets.cmake DESTINATION "${package}" COMPONENT library)
install(FILES "${PROJECT_SOURCE_DIR}/cmake/VelumConfig.cmake" "${PROJECT_BINARY_DIR}/VelumConfigVersion.cmake"
  DESTINATION "${package}" COMPONENT library)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/velum" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT library)
