target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/surgery/closing.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/collision_groups.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/event.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/face_blocks.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/fold_smoothing.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/front_gathering.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/handle_fitting.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/opening.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/plan.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/mesh_edits.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/tunnel_closing.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/smooth_cap.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/predicted_change.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/topology_adaptation.cpp
  ${CMAKE_SOURCE_DIR}/core/surgery/trace.cpp)
