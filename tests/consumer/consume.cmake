# Installs the engine into a folder of its own, builds the example there and looks at what it prints.
cmake_minimum_required(VERSION 3.22)
set(prefix ${FOLDER}/prefix)
file(REMOVE_RECURSE ${prefix} ${FOLDER}/build)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component Development --prefix ${prefix})

# Every header that a header names is there, and none that the engine keeps to itself.
set(include_folder ${prefix}/include/handlebody)
file(GLOB_RECURSE headers RELATIVE ${include_folder} ${include_folder}/*.h)
if(NOT "core/evolution/active_contour.h" IN_LIST headers)
  message(FATAL_ERROR "No headers were installed in ${include_folder}")
endif()
foreach(header IN LISTS headers)
  file(STRINGS ${include_folder}/${header} lines REGEX "^#include \"")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" name "${line}")
    if(NOT name IN_LIST headers)
      message(FATAL_ERROR "${header} includes ${name}, which is not installed")
    endif()
  endforeach()
  if(header MATCHES "^core/io/|precompiled")
    message(FATAL_ERROR "${header} is installed")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${BUILD_TYPE} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${FOLDER}/build/grow)
message(STATUS "${output}")
# A ball of 10 mm holds 4189 mm3: within 2 %.
if(NOT output MATCHES "^converged after [0-9]+ iterations: [0-9]+ vertices, genus 0, ([0-9]+)")
  message(FATAL_ERROR "It prints: ${output}")
endif()
if(CMAKE_MATCH_1 LESS 4105 OR CMAKE_MATCH_1 GREATER 4272)
  message(FATAL_ERROR "The ball has ${CMAKE_MATCH_1} mm3 instead of 4189")
endif()
