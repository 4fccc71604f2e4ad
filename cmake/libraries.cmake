# Every library from outside, found once. A missing one names its Debian package here, not later.

find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
find_package(embree REQUIRED CONFIG)
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(hwy REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(NLopt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)

# find_package(OpenCV) wants all of libopencv-dev (1 GB of drivers); the two modules used here do not.
find_path(INK_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
find_library(INK_OPENCV_CORE opencv_core REQUIRED)
find_library(INK_OPENCV_IMGPROC opencv_imgproc REQUIRED)
add_library(ink_opencv INTERFACE)
target_include_directories(ink_opencv SYSTEM INTERFACE ${INK_OPENCV_INCLUDE})
target_link_libraries(ink_opencv INTERFACE ${INK_OPENCV_CORE} ${INK_OPENCV_IMGPROC})

# XXH3: a library without a CMake package.
find_path(INK_XXHASH_INCLUDE xxhash.h REQUIRED)
find_library(INK_XXHASH xxhash REQUIRED)

# The Python module: an option, on where these are found (Debian: pybind11-dev, python3-dev, python3-numpy).
set(PYBIND11_FINDPYTHON ON)
set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is for")
find_package(Python COMPONENTS Interpreter Development.Module NumPy QUIET)
find_package(pybind11 QUIET)

# The charts of the page: d3.min.js becomes part of the program and is never copied into the tree.
# Debian: node-d3.
find_file(INK_D3 d3.min.js PATHS /usr/share/nodejs/d3/dist /usr/share/javascript/d3 REQUIRED)

# Kernels are compiled for the scalar target, which every other must equal bit for bit, and for what runs
# on today's x86: AVX2 and AVX-512. The targets below (SSE2 to SSE4) would only lengthen the build, and so would those
# above, for which kernels compile to the same instructions as for the first AVX-512, and AVX-512 where nothing is
# measured: other presets have AVX2 alone beside the scalar target.
add_library(ink_highway INTERFACE)
target_link_libraries(ink_highway INTERFACE hwy::hwy)
target_compile_definitions(ink_highway INTERFACE
    HWY_COMPILE_ALL_ATTAINABLE
    "HWY_DISABLED_TARGETS=((1LL<<11)|(1LL<<12)|(1LL<<13)|(1LL<<14)|0xD0$<$<NOT:$<CONFIG:Release>>:|0x100>)")

if(NOT TARGET glm::glm)
    add_library(glm::glm INTERFACE IMPORTED)
endif()
