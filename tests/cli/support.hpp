// What the tests of the program share: a scene, renders of it, and the reading of what comes out.
#pragma once

#include <gtest/gtest.h>
#include <json/json.h>

#include <memory>
#include <string>

#include "cli/program.hpp"
#include "image/pictures.hpp"

namespace fringe::cli {

using image::bytesOf;
using image::putBytes;
using image::TestFolder;

inline std::string roomFile() {
    return FRINGE_SOURCE_DIR "/tests/cli/room.json";
}

inline Arguments operator+(Arguments left, const Arguments& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

// The picture's size from the command line.
inline Arguments sized(int width, int height) {
    return {"--set", "image.width=" + std::to_string(width), "--set",
            "image.height=" + std::to_string(height)};
}

// 40 x 30 pixels, without a Vulkan driver.
inline Arguments smallReferenceRender() {
    return Arguments{"render", roomFile(), "--reference"} + sized(40, 30);
}

// 40 x 30 pixels, on the device.
inline Arguments smallRender() {
    return Arguments{"render", roomFile()} + sized(40, 30);
}

// Null, and a failure of the test, if the text is anything but one JSON value.
inline Json::Value parsedJson(const std::string& text) {
    Json::CharReaderBuilder builder;
    builder["failIfExtra"] = true;
    const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
    Json::Value value;
    std::string problems;
    EXPECT_TRUE(reader->parse(text.data(), text.data() + text.size(), &value, &problems)) << problems << text;
    return value;
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// Done, without a word on standard error.
inline void expectDone(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
}

// Refused with this status and a message that holds these words, and nothing on standard output.
inline void expectRefused(const Outcome& outcome, int status, const std::vector<std::string>& words) {
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.out, "");
    for (const std::string& word : words) EXPECT_TRUE(contains(outcome.err, word)) << outcome.err << word;
}

}  // namespace fringe::cli
