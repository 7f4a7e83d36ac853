# target_sources(handlebody_core PRIVATE ${CMAKE_SOURCE_DIR}/core/evolution/....cpp)
