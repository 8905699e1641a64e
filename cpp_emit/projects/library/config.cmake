# find_package(@CLASS@): the controller of the RoboChart @ELEMENT@.
@DEPENDENCIES@include("${CMAKE_CURRENT_LIST_DIR}/@CLASS@Targets.cmake")
