# How Asperity's own targets are built: C++20, warnings are errors, includes from the top folder.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

if(ASPERITY_SANITIZE)
  add_compile_options(-fsanitize=${ASPERITY_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ASPERITY_SANITIZE})
endif()

function(asperity_compile_options target)
  # -ffp-contract=off: a recorded run replays to the same bits whatever the optimiser fuses.
  # -Wno-missing-field-initializers: designated initialisers leave defaults to the members.
  # -Wno-restrict: GCC 12 sees overlaps in std::string's own operator+ (GCC bug 105651).
  target_compile_options(
    ${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                      -Wno-missing-field-initializers -Werror
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -ffp-contract=off)
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
endfunction()

# asperity_library(NAME SOURCES ... [DEPENDS ...]): one folder's static library.
function(asperity_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC ${ARG_DEPENDS})
  asperity_compile_options(${name})
endfunction()

# asperity_test(NAME LABEL core|io|vtk|... SOURCES ... DEPENDS ...): one GoogleTest program.
function(asperity_test name)
  cmake_parse_arguments(ARG "" "LABEL" "SOURCES;DEPENDS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} asperity_test_support GTest::gtest_main)
  asperity_compile_options(${name})
  gtest_discover_tests(${name} PROPERTIES LABELS ${ARG_LABEL} DISCOVERY_TIMEOUT 60)
endfunction()
