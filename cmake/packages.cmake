# Debian packages, one for each component of what is installed: `scripts/package.sh` makes them in
# build/packages. Texts that only packages need stand in packaging/.
include(GNUInstallDirs)
set(packaging ${PROJECT_SOURCE_DIR}/packaging)

# In share/pendular, not in share/doc, which small images of Debian leave out.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION share/pendular PATTERN out EXCLUDE)
install(FILES ${packaging}/pendular.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${packaging}/pendular.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(DIRECTORY ${PROJECT_BINARY_DIR}/site/ DESTINATION share/doc/pendular-doc/html
        COMPONENT documentation EXCLUDE_FROM_ALL OPTIONAL)

# pendular_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION): one package, with the files that
# Debian wants in each.
function(pendular_package component name section summary description)
  install(FILES ${packaging}/copyright DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION share/doc/${name} RENAME changelog
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian DESTINATION share/doc/${name}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${packaging}/lintian-overrides DESTINATION share/lintian/overrides RENAME ${name}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${description}" PARENT_SCOPE)
endfunction()

set(same_version "(= ${PROJECT_VERSION}-1)")
pendular_package(program pendular science
  "granular rheometry beside its own discrete-element model"
  "Pendular fits a discrete-element model to recordings of an annular shear cell
with dry or wet beads, shows where the model fails, and finds the physical
effect that is missing from the model.
.
This package contains the program with its atlas of simulations, manual pages,
completion for shells, and examples.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot-qt | gnuplot-x11, fonts-dejavu-core, libudunits2-data")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "pendular-doc, openmpi-bin")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)

pendular_package(development libpendular-dev libdevel
  "granular rheometry with a discrete-element model (C++ library)"
  "Pendular fits a discrete-element model to recordings of an annular shear cell
with dry or wet beads and finds the physical effect that the model lacks.
.
This package contains the header, the static libraries and the CMake package
with which programs in C++ calibrate studies and diagnose them.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "pendular ${same_version}, libboost-filesystem-dev, libboost-iostreams-dev, libboost-system-dev, libcereal-dev, libceres-dev, libeigen3-dev, libfmt-dev, libicu-dev, libmuparser-dev, libopenmpi-dev, libpugixml-dev, libsqlite3-dev, libsqlitecpp-dev, libtomlplusplus-dev, libudunits2-dev, libzip-dev, zlib1g-dev")

pendular_package(documentation pendular-doc doc
  "granular rheometry with a discrete-element model (documentation)"
  "Pendular fits a discrete-element model to recordings of an annular shear cell
with dry or wet beads and finds the physical effect that the model lacks.
.
This package contains tutorials, instructions, the reference of commands and
effects, and explanations, as pages for a browser.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
# Owners of the scripts and fonts that packaging/link_shared_files.sh replaces by links.
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_DEPENDS
  "fonts-font-awesome, fonts-katex, fonts-lato, libjs-jquery, libjs-katex, libjs-lunr, libjs-modernizr, sphinx-rtd-theme-common")

# Whoever builds the module for Python installs it as component `python`. It has an atlas of its own, and
# needs neither the program nor gnuplot.
if(TARGET pendular_python)
  pendular_package(python python3-pendular python
    "granular rheometry with a discrete-element model (Python 3)"
    "Pendular fits a discrete-element model to recordings of an annular shear cell
with dry or wet beads and finds the physical effect that the model lacks.
.
This package contains the module pendular for Python 3, which does what the
program does over numpy arrays and tables of pandas.")
  math(EXPR later_python "${PENDULAR_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (<< 3.${later_python}), python3 (>= 3.${PENDULAR_PYTHON_MINOR}), python3-numpy, libudunits2-data")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "pendular, python3-emcee, python3-scipy, python3-tqdm, python3-xarray")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${packaging}/python3/postinst ${packaging}/python3/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()

# SOURCE_DATE_EPOCH, which scripts/package.sh sets, makes packages of one commit equal.
string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)
# Debian demands an address. Whoever distributes packages states one; a domain that cannot exist (RFC 2606)
# keeps mail from strangers where nobody does.
set(PENDULAR_CONTACT "The Pendular developers <nobody@pendular.invalid>" CACHE STRING
    "Maintainer of the packages, NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${PENDULAR_CONTACT}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/changelog.Debian CONTENT
"pendular (${PROJECT_VERSION}-1) unstable; urgency=medium

  * Packaged with CPack; changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${day}
")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pendular)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # else CPack writes it above the summary of each package
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${packaging}/before_packing.cmake)
include(CPack)
