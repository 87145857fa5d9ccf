# How each dependency is found. All are Debian packages (debian-packages.txt says which and why).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Vulkan 1.3.239 REQUIRED COMPONENTS glslangValidator)  # headers; the program asks the device for 1.2
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR 3 REQUIRED)
pkg_check_modules(JSONCPP REQUIRED IMPORTED_TARGET jsoncpp)
if(FRINGE_TESTS)
    find_package(GTest REQUIRED)
endif()
