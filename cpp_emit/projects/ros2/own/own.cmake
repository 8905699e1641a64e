# Sources of your own in the package @PACKAGE@: robochart-verify wrote this file once and does not overwrite it, nor
# other files in this folder. The package's CMakeLists.txt includes it. For example, a program with a robot that does
# operations in C++:
#
# add_executable(my_robot own/my_robot.cpp)
# target_link_libraries(my_robot ${PROJECT_NAME}_node)
# install(TARGETS my_robot DESTINATION lib/${PROJECT_NAME})
