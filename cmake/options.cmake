# What a builder may choose. A parent project gets the core and nothing else unless it asks.
option(MIEN_BUILD_IMAGE "Build mien::image (needs OpenImageIO)" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_TEXT "Build mien::text (needs FreeType)" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_C "Build libmien_c, the C interface" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_COMMAND "Build the mien command" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_BUILD_SERVER "mien serve and mien studio have their server (needs libevent)" ON)
option(MIEN_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_LONG_TESTS "Tests that take hours, too: ctest -L long" OFF)
option(MIEN_BUILD_BENCH "Build the benches (needs Google Benchmark)" OFF)
option(MIEN_BUILD_ACCURACY "Build mien-accuracy, the laboratory of the distance kernels" OFF)
option(MIEN_BUILD_SAY "Build mien-say, which mien say runs (needs eSpeak NG, and the binary is under its GPL)" OFF)
option(MIEN_WITH_THREADS "Draw on several threads, by oneTBB; else on the caller's alone, and its executor" ON)
option(MIEN_HEADER_ONLY_DEPENDENCIES "Of fmt and Highway take the headers alone, as for WebAssembly, which has no libraries of theirs" OFF)
option(MIEN_SAME_BITS_WITHOUT_FMA "Float batches give the same bits on processors without fused multiply-add too, slowly" OFF)
set(MIEN_FORMATS_PACKAGE "" CACHE STRING "The package that users are told to install where the modules for TIFF, EXR and JPEG are missing")
set(MIEN_WEB_PACKAGE "" CACHE PATH "The web package, made by tools/portable web: installed for mien studio")
set(MIEN_INSTRUCTION_SETS all CACHE STRING "all: kernels for every instruction set; few: for the compiler's own and AVX2")
option(MIEN_BUILD_FUZZ "Build the fuzzers (needs clang)" OFF)
option(MIEN_WARNINGS "Warn, and treat warnings as errors, in mien's own files" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_INSTALL "Install headers, libraries and package files" ${PROJECT_IS_TOP_LEVEL})
option(MIEN_COVERAGE "Count which lines the tests reach (gcov)" OFF)
set(MIEN_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize= takes them: address,undefined or thread")

if(MIEN_BUILD_SAY AND NOT MIEN_BUILD_COMMAND)
  message(FATAL_ERROR "MIEN_BUILD_SAY needs MIEN_BUILD_COMMAND: mien say runs it")
endif()
if(MIEN_BUILD_COMMAND AND NOT MIEN_BUILD_TEXT)
  message(FATAL_ERROR "MIEN_BUILD_COMMAND needs MIEN_BUILD_TEXT: the command writes labels")
endif()

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

# Each instruction set compiles every kernel once more. Rules of the folder, too: Highway has to see one value.
if(MIEN_INSTRUCTION_SETS STREQUAL few)
  add_compile_definitions(HWY_DISABLED_TARGETS=6640)  # SSSE3, SSE4, AVX3 and its kinds
endif()

if(MIEN_SAME_BITS_WITHOUT_FMA)
  add_compile_definitions(MIEN_SAME_BITS_WITHOUT_FMA)  # every room has lanes
endif()

# A sanitizer or a line counter has to see every file, so these are rules of the folder, not of a target.
if(MIEN_SANITIZE)
  add_compile_options(-fsanitize=${MIEN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${MIEN_SANITIZE})
  # The sanitizers call dlopen from their own library: only the old tag lets the command's search path count there.
  add_link_options(-Wl,--disable-new-dtags)
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # GCC warns of the sanitizers' own code
endif()
if(MIEN_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()
