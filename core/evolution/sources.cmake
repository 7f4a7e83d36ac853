target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/evolution/active_contour.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/edge_profile.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/growth_level.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/history.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/image_doubts.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/level_field.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/object_boundary.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/motion.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/neck.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/object_image.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/object_range.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/object_region.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/region_growth.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/resting_places.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/seed_statistics.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/seeds.cpp
  ${CMAKE_SOURCE_DIR}/core/evolution/thickness_map.cpp)
