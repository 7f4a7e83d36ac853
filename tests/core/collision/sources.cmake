target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/collision/marked_cells_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/closest_point_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/detection_phases_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/moved_faces_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/vertex_levels_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/vertex_pairs_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/star_test_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/broad_phase_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/collision/self_intersection_test.cpp)
