target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/handles/handle_enumeration_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/homology_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/smith_normal_form_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/handles/two_front_handle_test.cpp)
