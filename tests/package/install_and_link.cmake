# Run by CTest: installs BUILD_DIR into an empty prefix, then configures, builds and runs CONSUMER_DIR against it.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix ${WORK_DIR}/prefix)
set(consumer ${WORK_DIR}/build)
file(REMOVE_RECURSE ${WORK_DIR})

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${consumer} -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} -D CMAKE_CXX_FLAGS=${CXX_FLAGS}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D EXPECTED_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${consumer})
run(${consumer}/consumer)

set(expected "manylight ${VERSION}: 2 triangles\n")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the consumer printed\n${output}instead of\n${expected}")
endif()

# Nothing that was installed may lead back to the folder that it was built in.
file(GLOB package_files ${prefix}/lib*/cmake/manylight/*.cmake ${prefix}/lib*/*/cmake/manylight/*.cmake)
foreach(package_file IN LISTS package_files)
  file(STRINGS ${package_file} leaks REGEX "${BUILD_DIR}")
  if(leaks)
    message(FATAL_ERROR "${package_file} names the build folder:\n${leaks}")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK_DIR})
