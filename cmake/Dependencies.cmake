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
