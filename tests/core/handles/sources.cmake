target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/handles/handle_enumeration_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/handle_database_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/homology_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/listed_handles_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/smith_normal_form_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/shortest_handles_test.cpp)
add_test(NAME "The handle database is what its program makes"
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:make_handles> -DOUTPUT=${CMAKE_BINARY_DIR}/handles_again.txt
    -DEXPECTED=${CMAKE_SOURCE_DIR}/resources/handles/handles.txt
    -P ${CMAKE_SOURCE_DIR}/tests/core/handles/compare_output.cmake)
