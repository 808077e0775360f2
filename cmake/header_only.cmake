# The libraries that mien's core stands on, as headers alone (MIEN_HEADER_ONLY_DEPENDENCIES): for systems that have
# no builds of theirs, such as WebAssembly and an ARM board of which this machine only has the compiler.
#
# Their headers are linked into a folder of their own: the compiler must see nothing else of the building machine's
# include folder, whose C library is another.
set(headers "${PROJECT_BINARY_DIR}/dependencies")
file(MAKE_DIRECTORY "${headers}")

function(mien_link_header name)
  find_path(from ${name} PATHS ${ARGN} /usr/local/include /usr/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE REQUIRED)
  if(NOT EXISTS "${headers}/${name}")
    file(CREATE_LINK "${from}/${name}" "${headers}/${name}" SYMBOLIC)
  endif()
endfunction()

function(mien_header_library target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${headers}")
endfunction()

mien_link_header(glm)
mien_link_header(Eigen /usr/include/eigen3)
mien_link_header(nlohmann)
mien_link_header(fmt)
mien_link_header(hwy)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  mien_link_header(fast_float)  # libc++ reads no floating-point numbers before version 20
endif()
mien_link_header(tiny_obj_loader.h)

mien_header_library(glm::glm)
mien_header_library(Eigen3::Eigen)
mien_header_library(nlohmann_json::nlohmann_json)
# Streams and locales would be a twentieth of mien.wasm, and mien uses neither.
target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NO_IO)
mien_header_library(fmt::fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY FMT_STATIC_THOUSANDS_SEPARATOR=',')
mien_header_library(hwy::hwy)
