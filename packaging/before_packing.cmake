# CPack calls this script when the files of all packages are in place: Debian wants manual pages and
# changelogs compressed, static libraries without notes of the compiler, and no copies of its fonts.
file(GLOB_RECURSE texts ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/man/*.1
                        ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*/changelog
                        ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*/changelog.Debian)
foreach(text IN LISTS texts)
  execute_process(COMMAND gzip -9n ${text} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB_RECURSE libraries ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/lib/*.a)
foreach(library IN LISTS libraries)
  execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note
                          --enable-deterministic-archives ${library} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
set(documentation ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/documentation)
if(EXISTS ${documentation})
  execute_process(COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/link_shared_files.sh ${documentation}
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
