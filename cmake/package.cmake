# Debian packages out of the install components, by CPack: tools/package makes them and tries them.
# docs/packages.md says what is in which. A build for packages has the prefix /usr and shared libraries.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mien)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(MIEN_PACKAGE_CONTACT "the mien authors <authors@mien.example>" CACHE STRING "Who keeps the packages: NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${MIEN_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")      # each package has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}/sdf/from_text ${PROJECT_BINARY_DIR}/sdf/distance
    ${PROJECT_BINARY_DIR}/sdf ${PROJECT_BINARY_DIR}/render/image)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY =)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish.cmake)
set(CPACK_MIEN_SOURCE_DIR ${PROJECT_SOURCE_DIR})
set(CPACK_MIEN_PACKAGES "")
set(CPACK_COMPONENTS_ALL "")

set(trigger ${PROJECT_SOURCE_DIR}/cmake/debian/libs/triggers)  # of ldconfig
set(exactly "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(so ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# mien_package(NAME COMPONENTS … SUMMARY … TEXT … [DEPENDS …] [SUGGESTS …] [SECTION …] [ARCHITECTURE …] [CONTROL FILE …])
# The extended description: what it is for, in lines as `apt show` prints them.
macro(mien_package name)
  cmake_parse_arguments(PKG "" "SUMMARY;TEXT;DEPENDS;SUGGESTS;SECTION;ARCHITECTURE" "COMPONENTS;CONTROL" ${ARGN})
  list(APPEND CPACK_MIEN_PACKAGES ${name})
  list(APPEND CPACK_COMPONENTS_ALL ${PKG_COMPONENTS})
  foreach(component IN LISTS PKG_COMPONENTS)
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENT_${upper}_GROUP ${name})
  endforeach()
  string(TOUPPER ${name} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${PKG_SUMMARY}\n${PKG_TEXT}")
  set(CPACK_COMPONENT_GROUP_${upper}_DESCRIPTION "${PKG_SUMMARY}\n${PKG_TEXT}")
  foreach(field DEPENDS SUGGESTS SECTION ARCHITECTURE)
    if(PKG_${field})
      set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${PKG_${field}}")
    endif()
  endforeach()
  if(PKG_CONTROL)
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${PKG_CONTROL}")
  endif()
endmacro()

if(MIEN_BUILD_COMMAND)
  mien_package(mien COMPONENTS command SUGGESTS "mien-formats, mien-say, ffmpeg"
               SUMMARY "draws vector faces exactly"
               TEXT "A face described by numbers becomes an exact, antialiased picture, at any size.
This is the command: it draws stills, animations and people, poses faces by
emotions, muscles and gaze, and writes PNG. TIFF, EXR and JPEG are written
where mien-formats is installed, animations as APNG, WebP and GIF always, and
as MP4 and WebM where ffmpeg is.")
endif()
if(MIEN_BUILD_SAY)
  mien_package(mien-say COMPONENTS say
               SUMMARY "speaks the texts of mien say, by eSpeak NG"
               TEXT "Text becomes sound and the times of its sounds, in the languages of eSpeak NG,
for faces of mien to speak. A package apart, since this program is linked to
eSpeak NG and so under the GPL, version 3 or later.")
endif()
if(MIEN_BUILD_IMAGE AND (MIEN_BUILD_COMMAND OR MIEN_BUILD_C))
  mien_package(mien-formats COMPONENTS formats
               SUMMARY "writes the faces of mien as TIFF, EXR and JPEG"
               TEXT "mien and libmien_image_c load these modules when they are asked for such a
file. They stand on OpenImageIO and libtiff, which the rest of mien does
without.")
endif()
if(BUILD_SHARED_LIBS)
  mien_package(libmien${so} COMPONENTS mien-runtime distance-runtime text-runtime SECTION libs CONTROL ${trigger}
               SUMMARY "vector faces and exact distances: C++ libraries"
               TEXT "Faces, scenes and pixels (libmien), distances to curves alone
(libmien-distance), and lines of text as paths (libmien_text), for programs
that were built with them.")
  mien_package(libmien-image${so} COMPONENTS image-runtime SECTION libs CONTROL ${trigger} DEPENDS "libmien${so} ${exactly}"
               SUMMARY "writes vector faces as image files: C++ library"
               TEXT "PNG, TIFF, EXR and JPEG, drawn and written piece by piece, for programs that
were built with it.")
endif()
if(MIEN_BUILD_C AND MIEN_BUILD_IMAGE)
  mien_package(libmien-c0 COMPONENTS c-runtime image_c-runtime SECTION libs CONTROL ${trigger} SUGGESTS mien-formats
               SUMMARY "vector faces and exact distances: C libraries"
               TEXT "The C interface of mien, with the whole core inside, on which other languages
stand: libmien_c draws into memory, libmien_image_c writes files. TIFF, EXR and
JPEG are written where mien-formats is installed.")
  mien_package(libmien-c-dev COMPONENTS c image_c SECTION libdevel DEPENDS "libmien-c0 ${exactly}"
               SUMMARY "vector faces and exact distances: for building, in C"
               TEXT "The headers <mien_c.h> and <mien_image_c.h>, which need no C++ compiler, and
what CMake and pkg-config need to find the libraries.")
  mien_package(python3-mien COMPONENTS python SECTION python ARCHITECTURE all SUGGESTS "mien, mien-formats, mien-accuracy, python3-pil"
               DEPENDS "libmien-c0 (>= ${PROJECT_VERSION}), python3, python3-numpy"
               CONTROL ${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm
               SUMMARY "vector faces and exact distances in Python"
               TEXT "Reads, poses and draws faces into NumPy arrays, makes people by code,
measures distances to curves by SIMD kernels, and judges such solvers of one's
own.")
endif()
if(BUILD_SHARED_LIBS AND MIEN_BUILD_C)
  mien_package(libmien-dev COMPONENTS mien distance text SECTION libdevel
               DEPENDS "libmien${so} ${exactly}, libmien-c-dev ${exactly}, libglm-dev"
               SUMMARY "vector faces and exact distances: for building, in C++"
               TEXT "The headers (<mien/mien.h>) and what CMake and pkg-config need to find the
libraries.")
  mien_package(libmien-image-dev COMPONENTS image SECTION libdevel DEPENDS "libmien-image${so} ${exactly}, libmien-dev ${exactly}"
               SUMMARY "writes vector faces as image files: for building, in C++"
               TEXT "The header <mien/write.h> and what CMake and pkg-config need to find
mien::image.")
endif()
if(MIEN_BUILD_ACCURACY)
  mien_package(mien-accuracy COMPONENTS accuracy SECTION science
               SUMMARY "judges solvers of the distance from a point to a curve"
               TEXT "Draws cases from fifty families that are hard to solve, and compares mien's
kernels, published methods and a solver of one's own with answers of 113 bits.")
endif()

include(CPack)
