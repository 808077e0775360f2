# What `cmake --install` leaves behind: libraries, public headers, a CMake package and two pkg-config files.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# mien_install_headers(COMPONENT LIBRARY…): the libraries' lines of cmake/public_headers.txt, into include/mien/.
function(mien_install_headers component)
  foreach(line IN LISTS MIEN_PUBLIC_HEADERS)
    string(REGEX REPLACE " +" ";" line "${line}")
    list(GET line 0 whose)
    list(GET line 1 name)
    list(GET line 2 path)
    if(whose IN_LIST ARGN)
      install(FILES ${PROJECT_SOURCE_DIR}/${path} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mien RENAME ${name}
              COMPONENT ${component})
    endif()
  endforeach()
endfunction()

set(MIEN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/mien)

# mien_install_library(TARGET NAME): TARGET becomes mien::NAME for users, in a component of its own. What programs that
# were linked to a shared library need, the component NAME-runtime has.
function(mien_install_library target name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT mien-${name}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}-runtime NAMELINK_COMPONENT ${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name})
  install(EXPORT mien-${name} NAMESPACE mien:: DESTINATION ${MIEN_PACKAGE_DIR} FILE mien-${name}-targets.cmake
          COMPONENT ${name})
endfunction()

# The .pc files state where they are relative to themselves, so that a prefix may be moved.
file(RELATIVE_PATH MIEN_PC_TO_PREFIX "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")

# mien_install_pc(NAME COMPONENT): cmake/NAME.pc.in becomes lib/pkgconfig/NAME.pc.
# A static library's user links what it stands on; a shared library has done so itself, and its user need not have it.
function(mien_install_pc name component)
  set(requires Requires)
  if(BUILD_SHARED_LIBS)
    set(requires "# Linked already")
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT ${component})
endfunction()

mien_install_library(mien_distance distance)
mien_install_headers(distance distance)
mien_install_pc(mien-distance distance)
mien_install_library(mien mien)
mien_install_headers(mien distance mien)
mien_install_pc(mien mien)
if(MIEN_BUILD_TEXT)
  mien_install_library(mien_text text)
  mien_install_headers(text text)
  mien_install_pc(mien-text text)
  install(FILES sdf/from_text/font/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME LICENSE.DejaVuSans COMPONENT text)
endif()
if(MIEN_BUILD_IMAGE)
  mien_install_library(mien_image image)
  mien_install_headers(image image)
  mien_install_pc(mien-image image)
endif()
if(MIEN_BUILD_C)
  mien_install_library(mien_c c)
  install(FILES bind/c/mien_c.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT c)
  mien_install_pc(mien-c c)
  if(MIEN_BUILD_IMAGE)
    mien_install_library(mien_image_c image_c)
    install(FILES bind/c/image/mien_image_c.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT image_c)
    mien_install_pc(mien-image-c image_c)
  endif()
endif()
if(MIEN_BUILD_C)
  install(DIRECTORY bind/python/mien DESTINATION lib/python3/dist-packages COMPONENT python
          FILES_MATCHING PATTERN *.py PATTERN *.js PATTERN py.typed PATTERN __pycache__ EXCLUDE)
endif()
if(MIEN_BUILD_IMAGE AND (MIEN_BUILD_COMMAND OR MIEN_BUILD_C))
  install(TARGETS mien_oiio_module mien_tiff_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/mien COMPONENT formats)
endif()
if(MIEN_BUILD_ACCURACY)
  install(TARGETS mien-accuracy RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT accuracy)
  install(FILES tools/accuracy/mien-accuracy.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT accuracy)
endif()
if(MIEN_BUILD_SAY)
  install(TARGETS mien-say RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT say)
  install(FILES tools/say/mien-say.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT say)
endif()
if(MIEN_BUILD_COMMAND)
  install(TARGETS mien_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
  install(TARGETS mien_film_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/mien COMPONENT command)
endif()

set(MIEN_IS_SHARED OFF)
if(BUILD_SHARED_LIBS)
  set(MIEN_IS_SHARED ON)
endif()
configure_package_config_file(cmake/mien-config.cmake.in ${PROJECT_BINARY_DIR}/package/mien-config.cmake
                              INSTALL_DESTINATION ${MIEN_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/mien-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
set(alone distance mien)
if(MIEN_BUILD_C)
  list(APPEND alone c)
endif()
foreach(component IN LISTS alone)
  install(FILES ${PROJECT_BINARY_DIR}/package/mien-config.cmake ${PROJECT_BINARY_DIR}/package/mien-config-version.cmake
          DESTINATION ${MIEN_PACKAGE_DIR} COMPONENT ${component})
  install(FILES LICENSE THIRD_PARTY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT ${component})
endforeach()
