# One static library per engine folder: manylight_<name>, so that the linker line is the dependency arrow.
function(manylight_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
    $<$<CXX_COMPILER_ID:GNU>:-Werror>)  # clang, which builds the fuzzers, warns of other things
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR})
endfunction()

# The heavy headers that nearly every file meets, parsed once per target; further ones may be named.
function(manylight_precompile target)
  target_precompile_headers(${target} PRIVATE <nlohmann/json.hpp> <glm/glm.hpp> <fmt/format.h> <fmt/ranges.h>
    <algorithm> <filesystem> <functional> <map> <memory> <optional> <string> <vector> ${ARGN})
endfunction()

# For code that calls the engine and computes little itself: a third of the time to compile it.
function(manylight_quick_to_compile target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

function(manylight_library name)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  add_library(manylight_${name} STATIC ${sources})
  add_library(manylight::${name} ALIAS manylight_${name})
  set_target_properties(manylight_${name} PROPERTIES EXPORT_NAME ${name})
  manylight_compile_options(manylight_${name})
  target_include_directories(manylight_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/manylight>)
  target_link_libraries(manylight_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  if(NOT name STREQUAL core)
    manylight_precompile(manylight_${name})
  endif()
endfunction()

function(manylight_program name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*/*.cpp)
  add_executable(manylight-${name} ${sources})
  manylight_compile_options(manylight-${name})
  manylight_quick_to_compile(manylight-${name})
  manylight_precompile(manylight-${name} <CLI/CLI.hpp>)
  target_link_libraries(manylight-${name} PRIVATE ${ARG_LINK})
  target_compile_definitions(manylight-${name} PRIVATE MANYLIGHT_VERSION="${PROJECT_VERSION}")
  install(TARGETS manylight-${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()
