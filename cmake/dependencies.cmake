# Debian's liblcm-dev has no CMake package, and its lcm.pc wants libglib2.0-dev.
find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp REQUIRED)
find_library(LCM_LIBRARY lcm REQUIRED)
find_program(LCM_GEN lcm-gen REQUIRED)
add_library(lcm::lcm UNKNOWN IMPORTED)
set_target_properties(lcm::lcm PROPERTIES IMPORTED_LOCATION ${LCM_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${LCM_INCLUDE_DIR})

# Nor have these.
set(xxhash_header xxhash.h)
set(lodepng_header lodepng.h)
set(systemd_header systemd/sd-daemon.h)
set(turbojpeg_header turbojpeg.h)
set(zstd_header zstd.h)
foreach(name xxhash lodepng systemd turbojpeg zstd)
  find_path(${name}_INCLUDE_DIR ${${name}_header} REQUIRED)
  find_library(${name}_LIBRARY ${name} REQUIRED)
  add_library(${name}::${name} UNKNOWN IMPORTED)
  set_target_properties(${name}::${name} PROPERTIES
    IMPORTED_LOCATION ${${name}_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${${name}_INCLUDE_DIR})
endforeach()

# libmujoco-dev's own package wants OpenGL's headers and names a missing folder.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h REQUIRED)
find_library(MUJOCO_LIBRARY mujoco REQUIRED)
add_library(mujoco::mujoco UNKNOWN IMPORTED)
set_target_properties(mujoco::mujoco PROPERTIES
  IMPORTED_LOCATION ${MUJOCO_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${MUJOCO_INCLUDE_DIR})

# libpcl-dev's own package wants all that any part of PCL can use, VTK's too.
find_path(PCL_INCLUDE_DIR pcl/io/pcd_io.h PATH_SUFFIXES pcl-1.13 REQUIRED)
find_library(PCL_IO_LIBRARY pcl_io REQUIRED)
find_library(PCL_COMMON_LIBRARY pcl_common REQUIRED)
add_library(pcl::io UNKNOWN IMPORTED)
set_target_properties(pcl::io PROPERTIES IMPORTED_LOCATION ${PCL_IO_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${PCL_INCLUDE_DIR}
  INTERFACE_LINK_LIBRARIES "${PCL_COMMON_LIBRARY};Eigen3::Eigen")

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(SQLiteCpp REQUIRED)
find_package(embree 3 REQUIRED)
find_package(fcl REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)

# Optional: Java makes the jar of message types for `cell spy` (deploy/spy).
find_program(JAVAC javac)
find_program(JAR jar)
find_file(LCM_JAR lcm.jar PATHS /usr/share/java NO_DEFAULT_PATH)
