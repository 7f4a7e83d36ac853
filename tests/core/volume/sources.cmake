target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/volume/anatomy_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/volume/border_region_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/volume/field_of_view_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/volume/intensity_statistics_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/volume/smoothed_volume_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/volume/voxel_walk_test.cpp)
