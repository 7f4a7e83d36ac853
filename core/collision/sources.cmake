target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/collision/body_contact.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/box_tree.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/certify.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/closest_point.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/face_pair.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/half_boxes.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/near_points.cpp
  ${CMAKE_CURRENT_LIST_DIR}/self_intersection.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/sorted_boxes.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/spatial_hash.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/star_test.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/vertex_levels.cpp
  ${CMAKE_SOURCE_DIR}/core/collision/vertex_stars.cpp)
