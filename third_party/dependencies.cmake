# How each dependency is found. All are Debian packages (debian-packages.txt says which and why).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Vulkan 1.3.239 REQUIRED COMPONENTS glslangValidator)  # headers; the program asks the device for 1.2
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR 3 REQUIRED)
pkg_check_modules(LCMS2 REQUIRED IMPORTED_TARGET lcms2)
pkg_check_modules(JSONCPP REQUIRED IMPORTED_TARGET jsoncpp)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo cairo-svg)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3f)

# The window of `fringe preview`: built only where both are found.
find_package(glfw3 3.3 QUIET)
pkg_check_modules(IMGUI QUIET IMPORTED_TARGET imgui)
if(glfw3_FOUND AND IMGUI_FOUND)
    set(FRINGE_PREVIEW ON CACHE INTERNAL "whether there is a preview")
else()
    set(FRINGE_PREVIEW OFF CACHE INTERNAL "whether there is a preview")
    message(STATUS "No preview: it needs GLFW 3.3 and Dear ImGui (libglfw3-dev and libimgui-dev)")
endif()

if(FRINGE_TESTS)
    find_package(GTest REQUIRED)
endif()
