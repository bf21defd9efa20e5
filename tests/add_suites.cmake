# CTest reads this when it starts, with `program`, `label`, `properties` and `apart` set: one entry for each suite of a
# GoogleTest program. Its tests run in one process, so that they share a device and what is compiled for it. Suites that
# `apart` names have an entry for each test, which CTest reports as skipped where the test says so.
cmake_minimum_required(VERSION 3.25)

if(NOT EXISTS ${program})
  get_filename_component(name ${program} NAME)
  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
  return()
endif()
execute_process(COMMAND ${program} --gtest_list_tests
  OUTPUT_VARIABLE listing RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} --gtest_list_tests: ${status}")
endif()

# A suite's line ends in a dot, the lines of its tests are indented; comments tell the values of parameters.
string(REGEX REPLACE "[ \t]*#[^\n]*" "" listing "${listing}")
string(REPLACE ";" "_" listing "${listing}")
string(REPLACE "\n" ";" listing "${listing}")

set(suite "")
set(suites "")
foreach(line IN LISTS listing)
  if(line MATCHES "^ +(.+)$")
    if(suite IN_LIST apart)
      set(test ${suite}.${CMAKE_MATCH_1})
      add_test(${label}.${test} ${program} --gtest_filter=${test})
      set_tests_properties(${label}.${test} PROPERTIES LABELS ${label} ${properties}
        SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
    else()
      math(EXPR count_${suite} "${count_${suite}} + 1")
    endif()
  elseif(line MATCHES "^([^ ]+)\\.$")
    set(suite ${CMAKE_MATCH_1})
    set(count_${suite} 0)
    if(NOT suite IN_LIST apart)
      list(APPEND suites ${suite})
    endif()
  endif()
endforeach()

# Two programs may have suites of one name, hence the label. Where no earlier run has told how long a suite takes, those
# with many tests come first.
foreach(suite IN LISTS suites)
  add_test(${label}.${suite} ${program} --gtest_filter=${suite}.*)
  set_tests_properties(${label}.${suite} PROPERTIES LABELS ${label} ${properties} COST ${count_${suite}})
endforeach()
