# The first entry of CHANGELOG.md is the version in version.hpp.
cmake_minimum_required(VERSION 3.25)

file(STRINGS ${ROOT}/CHANGELOG.md entries REGEX "^## ")
list(GET entries 0 first)
if(NOT first MATCHES "^## ([0-9.]+)" OR NOT CMAKE_MATCH_1 STREQUAL VERSION)
    message(FATAL_ERROR "version.hpp says ${VERSION}, but CHANGELOG.md begins with '${first}'")
endif()
