# The places that state the version agree: project() in CMakeLists.txt, CITATION.cff, and the first heading of
# CHANGELOG.md, which is "## VERSION, DATE" or, between two versions, "## Unreleased".
#   cmake -DROOT=FOLDER [-DTAG=v0.3.0] -P tests/check_release.cmake
# With TAG, the sources are those of a version that can get this tag: nothing is unreleased.
function(find_in file pattern result)
  file(READ ${ROOT}/${file} text)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${file}: nothing there is like '${pattern}'")
  endif()
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

find_in(CMakeLists.txt "project\\(pendular VERSION ([0-9.]+)" version)
find_in(CITATION.cff "\nversion: ([^\n]+)" cited)
find_in(CITATION.cff "\ndate-released: ([^\n]+)" date)
find_in(CHANGELOG.md "\n## ([^\n]+)" heading)
if(NOT cited STREQUAL version)
  message(FATAL_ERROR "CITATION.cff: the version is ${cited}; in CMakeLists.txt it is ${version}")
endif()
if(NOT heading STREQUAL "${version}, ${date}" AND (TAG OR NOT heading STREQUAL "Unreleased"))
  message(FATAL_ERROR "CHANGELOG.md: the first heading is '${heading}'; '${version}, ${date}' is needed, "
                      "with the version of CMakeLists.txt and the date of CITATION.cff")
endif()
if(TAG AND NOT TAG STREQUAL "v${version}")
  message(FATAL_ERROR "The tag ${TAG} does not fit version ${version}: name it v${version}")
endif()
