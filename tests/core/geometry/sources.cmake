target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/geometry/predicates_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/geometry/triangle_distance_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/geometry/triangle_intersection_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/geometry/vertex_distance_test.cpp)
