target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/geometry/closest_points.cpp
  ${CMAKE_SOURCE_DIR}/core/geometry/predicates.cpp
  ${CMAKE_SOURCE_DIR}/core/geometry/flat_intersection.cpp
  ${CMAKE_SOURCE_DIR}/core/geometry/triangle_angles.cpp
  ${CMAKE_SOURCE_DIR}/core/geometry/triangle_intersection.cpp
  ${CMAKE_SOURCE_DIR}/core/geometry/triangle_distance.cpp)
