target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/active_contour_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/clicked_object_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/contour_reports_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/correction_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/edge_profile_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/history_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/image_doubts_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/level_field_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/motion_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/mutation_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/neck_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/object_boundary_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/object_range_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/region_growth_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/resting_places_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/evolution/shrinking_test.cpp)
