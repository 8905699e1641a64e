# ament_cmake as far as generated packages use it, for tests: the last command of a package.
macro(ament_package)
  set_property(GLOBAL PROPERTY STUB_AMENT_PACKAGE ON)
endmacro()
