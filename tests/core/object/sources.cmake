target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/object/candidates_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/click_balls_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/cells_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/centrality_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/click_correction_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/closure_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/displacement_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/distance_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/expected_overlap_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/intensity_scale_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/object_model_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/relabel_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/star_surface_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/object/tube_surface_test.cpp)
