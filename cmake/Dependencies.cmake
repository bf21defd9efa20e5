# Every library comes from the system's packages (packages.txt); nothing is downloaded here.
include(LibraryDependencies)
foreach(package IN LISTS MANYLIGHT_PACKAGES)
  find_package(${package} REQUIRED)
endforeach()
manylight_complete_targets()

# Embree 4 where the system has it, 3 otherwise: the builder and rtcOccluded1 exist in both.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()

# Only the build itself needs these.
find_package(CLI11 REQUIRED)
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_path(STB_INCLUDE_DIR NAMES stb_image.h PATH_SUFFIXES stb REQUIRED)
find_path(VOLK_INCLUDE_DIR NAMES volk.h PATH_SUFFIXES volk REQUIRED)

# The viewer's window.
if(MANYLIGHT_BUILD_APPS)
  find_package(glfw3 3.3 REQUIRED)
  find_path(IMGUI_INCLUDE_DIR NAMES imgui.h PATH_SUFFIXES imgui REQUIRED)
  find_library(IMGUI_LIBRARY imgui REQUIRED)
  find_library(STB_LIBRARY stb REQUIRED)  # the system's imgui leaves its fonts and text fields to it
  add_library(imgui::imgui UNKNOWN IMPORTED)
  set_target_properties(imgui::imgui PROPERTIES
    IMPORTED_LOCATION ${IMGUI_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${IMGUI_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${STB_LIBRARY})
endif()
