# What whoever links the libraries has to find as well: the build includes this file, and so does manylightConfig.cmake.
set(MANYLIGHT_PACKAGES Threads Vulkan fmt glm nlohmann_json OpenEXR TinyGLTF tinyobjloader TBB SPIRV-Tools-opt)

# Packages of some systems lack these targets.
macro(manylight_complete_targets)
  if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
  endif()
  if(NOT TARGET tinyobjloader::tinyobjloader_double)
    find_library(TINYOBJLOADER_DOUBLE_LIBRARY tinyobjloader_double REQUIRED)
    add_library(tinyobjloader::tinyobjloader_double UNKNOWN IMPORTED)
    set_target_properties(tinyobjloader::tinyobjloader_double PROPERTIES
      IMPORTED_LOCATION ${TINYOBJLOADER_DOUBLE_LIBRARY}
      INTERFACE_COMPILE_DEFINITIONS TINYOBJLOADER_USE_DOUBLE)
  endif()
endmacro()
