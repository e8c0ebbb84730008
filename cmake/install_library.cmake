# The library that installs: find_package(Pendular) gives Pendular::pendular, whose headers are those
# of include/pendular.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

add_library(pendular_library INTERFACE)
add_library(Pendular::pendular ALIAS pendular_library)
set_target_properties(pendular_library PROPERTIES EXPORT_NAME pendular)
target_compile_features(pendular_library INTERFACE cxx_std_20)
target_include_directories(pendular_library INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
target_link_libraries(pendular_library INTERFACE pendular_workflow)

install(TARGETS pendular_library pendular_workflow pendular_analysis pendular_calib pendular_sim
                pendular_data
        EXPORT PendularTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Pendular)
install(EXPORT PendularTargets NAMESPACE Pendular:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/PendularConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/PendularConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/PendularConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/PendularConfig.cmake
              ${PROJECT_BINARY_DIR}/PendularConfigVersion.cmake DESTINATION ${package}
        COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/pendular DESTINATION include COMPONENT development)
