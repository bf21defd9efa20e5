# What whoever links the libraries has to find as well: the build includes this file, and so does manylightConfig.cmake.
set(MANYLIGHT_PACKAGES Threads Vulkan fmt glm nlohmann_json OpenEXR TinyGLTF TBB)

# Packages of some systems lack these targets.
macro(manylight_complete_targets)
  if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
  endif()
endmacro()
