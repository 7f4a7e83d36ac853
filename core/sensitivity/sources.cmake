target_sources(handlebody_core PRIVATE
  ${CMAKE_SOURCE_DIR}/core/sensitivity/perturbation.cpp
  ${CMAKE_SOURCE_DIR}/core/sensitivity/sensitivity.cpp)
