# What `cmake --install` leaves behind: libraries, public headers, a CMake package and two pkg-config files.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# mien_public_headers(OUT HEADER…): these headers and every own header they pull in, so that the installed set
# is what a user's compiler needs, and no list has to be kept.
function(mien_public_headers out)
  set(found "")
  set(todo ${ARGN})
  while(todo)
    list(POP_FRONT todo header)
    if(header IN_LIST found)
      continue()
    endif()
    list(APPEND found ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${header}")
    file(STRINGS "${PROJECT_SOURCE_DIR}/${header}" lines REGEX "^#include <mien/")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include <mien/([^>]+)>.*" "\\1" included "${line}")
      list(APPEND todo "${included}")
    endforeach()
  endwhile()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# mien_install_headers(COMPONENT HEADER…): into include/mien/, in the tree's own layout.
function(mien_install_headers component)
  mien_public_headers(headers ${ARGN})
  foreach(header IN LISTS headers)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mien/${folder}
            COMPONENT ${component})
  endforeach()
endfunction()

set(MIEN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/mien)

# mien_install_library(TARGET NAME): TARGET becomes mien::NAME for users, in its own component.
function(mien_install_library target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT mien-${name}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name} NAMELINK_COMPONENT ${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT mien-${name} NAMESPACE mien:: DESTINATION ${MIEN_PACKAGE_DIR} FILE mien-${name}-targets.cmake
          COMPONENT ${name})
endfunction()

# The .pc files state where they are relative to themselves, so that a prefix may be moved.
file(RELATIVE_PATH MIEN_PC_TO_PREFIX "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")

# mien_install_pc(NAME COMPONENT): cmake/NAME.pc.in becomes lib/pkgconfig/NAME.pc.
# A static library's user links what it stands on; a shared library has done so itself.
function(mien_install_pc name component)
  if(BUILD_SHARED_LIBS)
    set(requires Requires.private)
  else()
    set(requires Requires)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT ${component})
endfunction()

# Public headers that mien.h does not pull in, one per line.
set(MIEN_MORE_PUBLIC_HEADERS
  lib/file/facemotion.h
  lib/file/morph_file.h
  lib/file/npy.h
  lib/file/npy_basis.h
  lib/file/obj.h
  lib/file/obj_map.h
  lib/math/pca.h
  lib/rig/mesh_morph.h
  lib/rig/morph.h
  lib/rig/poser.h
  render/debug_picture.h
  render/effect/effect_chain.h
  render/error_map.h
  sdf/distance.h
  sdf/from_face/morph_heat.h
  sdf/from_mesh/scene_from_mesh.h
  sdf/scene/effects.h
)

mien_install_library(mien mien)
mien_install_headers(mien mien.h ${MIEN_MORE_PUBLIC_HEADERS})
mien_install_pc(mien mien)
if(MIEN_BUILD_TEXT)
  mien_install_library(mien_text text)
  mien_install_headers(text sdf/from_text/text_path.h)
  mien_install_pc(mien-text text)
  install(FILES sdf/from_text/font/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.DejaVuSans COMPONENT text)
endif()
if(MIEN_BUILD_IMAGE)
  mien_install_library(mien_image image)
  mien_install_headers(image image.h)
  mien_install_pc(mien-image image)
endif()
if(MIEN_BUILD_COMMAND)
  install(TARGETS mien_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
endif()

set(MIEN_IS_SHARED OFF)
if(BUILD_SHARED_LIBS)
  set(MIEN_IS_SHARED ON)
endif()
configure_package_config_file(cmake/mien-config.cmake.in ${PROJECT_BINARY_DIR}/package/mien-config.cmake
                              INSTALL_DESTINATION ${MIEN_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/mien-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/mien-config.cmake ${PROJECT_BINARY_DIR}/package/mien-config-version.cmake
        DESTINATION ${MIEN_PACKAGE_DIR} COMPONENT mien)
install(FILES LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT mien)
