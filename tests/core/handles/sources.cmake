target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/handles/handle_enumeration_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/homology_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/smith_normal_form_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/shortest_handles_test.cpp)
