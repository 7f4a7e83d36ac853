target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/solid/blurred_mask.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/cell_cases.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/comparison.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/guarded_mesh.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/label_mesh.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/label_mesh_warnings.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/mask.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/mask_surface.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/overlap.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/rasterize.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/simplify.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/smooth_surface.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/solid.cpp
  ${CMAKE_SOURCE_DIR}/core/solid/surface_distance.cpp)
