target_sources(core_tests PRIVATE
  ${CMAKE_SOURCE_DIR}/tests/core/solid/comparison_by_force_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/solid/comparison_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/solid/label_mesh_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/solid/label_meshes_test.cpp
  ${CMAKE_SOURCE_DIR}/tests/core/solid/mask_surface_test.cpp)
