# The generated classes; see controller/@CLASS@.hpp.
add_library(@CLASS@ STATIC controller/@CLASS@.cpp)
add_library(@CLASS@::@CLASS@ ALIAS @CLASS@)
target_include_directories(@CLASS@ PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/controller>
                                          $<INSTALL_INTERFACE:include/@HEADERS@>)
target_compile_features(@CLASS@ PUBLIC cxx_std_17)
set_target_properties(@CLASS@ PROPERTIES POSITION_INDEPENDENT_CODE ON)
option(ROBOCHART_TRACE "The controller can tell a tracer what it does (robochart/trace_file.hpp)" @TRACE@)
target_compile_definitions(@CLASS@ PUBLIC ROBOCHART_TRACE=$<BOOL:${ROBOCHART_TRACE}>)
