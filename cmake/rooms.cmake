# A room is a folder of the house, compiled once into an object library; libraries, tests, benches and fuzzers
# are composed from rooms.

# Users write <mien/face.h>; cmake/public_headers.txt says where it lives. The build folder gets headers of those
# names, each of which includes the real one; an installed mien has the real ones.
set(MIEN_INCLUDE_DIR "${PROJECT_BINARY_DIR}/public_headers")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/cmake/public_headers.txt")
file(STRINGS "${PROJECT_SOURCE_DIR}/cmake/public_headers.txt" MIEN_PUBLIC_HEADERS REGEX "^[a-z]")
set(names "")
foreach(line IN LISTS MIEN_PUBLIC_HEADERS)
  string(REGEX REPLACE " +" ";" line "${line}")
  list(GET line 1 name)
  list(GET line 2 path)
  file(RELATIVE_PATH real "${MIEN_INCLUDE_DIR}/mien" "${PROJECT_SOURCE_DIR}/${path}")
  file(CONFIGURE OUTPUT "${MIEN_INCLUDE_DIR}/mien/${name}" CONTENT "#include \"${real}\"\n" @ONLY)
  list(APPEND names ${name})
endforeach()
file(GLOB there RELATIVE "${MIEN_INCLUDE_DIR}/mien" "${MIEN_INCLUDE_DIR}/mien/*")
foreach(name IN LISTS there)
  if(NOT name IN_LIST names)
    file(REMOVE "${MIEN_INCLUDE_DIR}/mien/${name}")  # it is public no more
  endif()
endforeach()

# What every target of mien's own is compiled with.
function(mien_house_rules target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Public headers are <mien/face.h>; the house's own are "lib/rig/eye/lid.h".
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR} ${MIEN_INCLUDE_DIR})
  # One rule for fused multiply-add: only where the source says fma. Else bits differ between compilers.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # Where files are compiled together (CMAKE_UNITY_BUILD), those of the SIMD kernels stand alone: each is compiled
  # once for every instruction set; and what replaces operator new.
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "(_simd|lit_places_test|near_squares_test|shipped_font|allocations)\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
                        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(BUILD_SHARED_LIBS)
    target_compile_definitions(${target} PRIVATE MIEN_SHARED)  # see lib/base/api.h
  endif()
  if(MIEN_WARNINGS)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                           -Wno-missing-field-initializers -Werror
                           $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
  endif()
endfunction()

# mien_room(NAME SOURCES … LIBRARIES …): the object library mien_NAME.
function(mien_room name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(mien_${name} OBJECT ${ARG_SOURCES})
  mien_house_rules(mien_${name})
  # No value depends on these: square roots without a way to errno, and choices without branches.
  target_compile_options(mien_${name} PRIVATE -fno-math-errno -fno-trapping-math)
  target_link_libraries(mien_${name} PUBLIC glm::glm PRIVATE ${ARG_LIBRARIES})
endfunction()

# mien_library(TARGET): what every installed library of mien's has in common.
function(mien_library target)
  mien_house_rules(${target})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${MIEN_INCLUDE_DIR}> $<INSTALL_INTERFACE:include>)
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
                        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endfunction()

# mien_compose(TARGET ROOM…): one library out of rooms.
function(mien_compose target)
  mien_library(${target})
  foreach(room IN LISTS ARGN)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:mien_${room}>)
  endforeach()
  target_link_libraries(${target} PUBLIC glm::glm PRIVATE ${MIEN_THREADS} fmt::fmt hwy::hwy)
endfunction()
