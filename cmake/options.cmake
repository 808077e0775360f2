# What a builder may choose. A parent project gets the core and nothing else unless it asks.
option(MIEN_BUILD_IMAGE "Build mien::image (needs OpenImageIO)" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_COMMAND "Build the mien command" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_BENCH "Build the benches" OFF)
option(MIEN_WARNINGS "Warn, and treat warnings as errors, in mien's own files" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_INSTALL "Install headers, libraries and package files" ${PROJECT_IS_TOP_LEVEL})

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()
