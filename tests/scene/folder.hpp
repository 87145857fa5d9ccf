// A folder for the files that a scene names, gone at the end of the test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace fringe::scene {

class Folder {
public:
    Folder()
        : path_(std::filesystem::path(testing::TempDir()) /
                ("scene_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->test_suite_name()) + "_" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    void write(const std::string& name, std::string_view text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
    }

    // The path of a file in it, or of a scene file that is only talked about.
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

}  // namespace fringe::scene
