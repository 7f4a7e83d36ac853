target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/measure/centre_line_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/measure/measure_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/measure/measurement_test.cpp)
