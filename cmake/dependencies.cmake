# Every library mien stands on. A parent project must see the targets too, since the core links to them.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

if(MIEN_HEADER_ONLY_DEPENDENCIES)
  include(cmake/header_only.cmake)
else()
  find_package(glm REQUIRED)                    # vectors, in public headers
  find_package(Eigen3 REQUIRED NO_MODULE)       # lib/math, in .cpp files only
  find_package(hwy REQUIRED)                    # SIMD, in -inl.h and _simd.cpp only
  find_package(nlohmann_json REQUIRED)          # JSON, in lib/file only
  find_package(fmt REQUIRED)                    # text
endif()
if(MIEN_WITH_THREADS)
  find_package(TBB REQUIRED)                    # threads, in lib/base/parallel.cpp only
  set(MIEN_THREADS TBB::tbb)
endif()
if(MIEN_BUILD_TEXT)
  find_package(PkgConfig REQUIRED)              # outlines of text, in sdf/from_text only
  pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET GLOBAL freetype2)
endif()
find_path(MIEN_TINYOBJ tiny_obj_loader.h PATHS /usr/include REQUIRED NO_CMAKE_FIND_ROOT_PATH)  # OBJ files, in lib/file only; a header
if(MIEN_BUILD_IMAGE)
  find_package(PkgConfig REQUIRED)              # image files, in render/image only;
  pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET GLOBAL libdeflate)     # PNG, and TIFF's tiles
  pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO>=2.4)  # its find_package is broken in Debian 12
  pkg_check_modules(TIFF REQUIRED IMPORTED_TARGET GLOBAL libtiff-4>=4.5)
endif()
if(MIEN_BUILD_COMMAND)
  find_package(CLI11 REQUIRED)                  # the command line, in tools only
  find_library(MIEN_CSV csv REQUIRED)           # tables, in tools/mien/data only
  if(MIEN_BUILD_SERVER)
    pkg_check_modules(EVENT REQUIRED IMPORTED_TARGET GLOBAL libevent_extra libevent_core)  # HTTP, in tools/mien/http only
  endif()
  pkg_check_modules(GIF REQUIRED IMPORTED_TARGET GLOBAL libgif>=5)  # films, in tools/mien/film only
  pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET GLOBAL libwebp libwebpmux)
  pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET GLOBAL nettle)  # SHA-256, in tools/mien/output only
endif()
if(MIEN_BUILD_SAY)
  pkg_check_modules(ESPEAK REQUIRED IMPORTED_TARGET GLOBAL espeak-ng)  # spoken text, in tools/say only; its licence is the GPL
elseif(MIEN_BUILD_COMMAND AND MIEN_BUILD_TESTS)
  pkg_check_modules(ESPEAK QUIET IMPORTED_TARGET GLOBAL espeak-ng)  # tests only: what is installed does without
endif()
if(MIEN_BUILD_TESTS)
  find_package(GTest REQUIRED)
  if(MIEN_BUILD_IMAGE)
    find_package(ZLIB REQUIRED)                 # unpacks what was packed
    pkg_check_modules(GIF REQUIRED IMPORTED_TARGET GLOBAL libgif>=5)  # and these read films
    pkg_check_modules(LIBWEBP REQUIRED IMPORTED_TARGET GLOBAL libwebpdemux libwebp)
  endif()
endif()
if(MIEN_BUILD_BENCH)
  find_package(benchmark REQUIRED)
endif()
