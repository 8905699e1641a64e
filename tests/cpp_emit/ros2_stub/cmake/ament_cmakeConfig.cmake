# SPDX-License-Identifier: Apache-2.0
# A test stub of ament_cmake with the last command of a generated package.
macro(ament_package)
  set_property(GLOBAL PROPERTY STUB_AMENT_PACKAGE ON)
endmacro()
