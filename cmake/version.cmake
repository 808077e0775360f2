# MIEN_VERSION, read from the one place that states it.
set(MIEN_VERSION "")
cmake_path(SET version_header NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../version.h")
foreach(part MAJOR MINOR PATCH)
  file(STRINGS "${version_header}" line REGEX "^#define MIEN_VERSION_${part} [0-9]+$")
  string(REGEX MATCH "[0-9]+$" number "${line}")
  list(APPEND MIEN_VERSION ${number})
endforeach()
list(JOIN MIEN_VERSION "." MIEN_VERSION)
# An edit of version.h makes the build configure itself anew.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${version_header}")
