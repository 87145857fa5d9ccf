// Texts that are not JSON, and JSON that is out of the ordinary.
#include <gtest/gtest.h>

#include "scene/support.hpp"

namespace fringe::scene {
namespace {

constexpr std::string_view kRest = R"("camera": {"position": [0, 0, 3], "target": [0, 0, 0]}})";

std::string smallScene(std::string_view start) {
    return std::string(start) + std::string(kRest);
}

TEST(SceneSyntax, NothingThere) {
    const std::string expected =
        R"(s:1:1: there is no scene here; the smallest begins {"fringe": 1, "camera": ...)";
    EXPECT_EQ(problemsOf(""), expected);
    EXPECT_EQ(problemsOf(" \n// nothing\n"), expected);
    EXPECT_EQ(problemsOf("\xEF\xBB\xBF"), expected);
}

TEST(SceneSyntax, MissingCommaAndBrace) {
    EXPECT_EQ(problemsOf("{\"fringe\": 1\n \"camera\": {}}"),
              "s:2:2: missing ',' or '}' in object declaration");
    EXPECT_EQ(problemsOf("{\"fringe\": 1,"), "s:1:14: missing '}' or object member name");
}

TEST(SceneSyntax, TextAfterTheScene) {
    EXPECT_EQ(problemsOf(smallScene("{\"fringe\": 1, ") + " 1"),
              "s:1:71: extra non-whitespace after JSON value");
}

TEST(SceneSyntax, TrailingComma) {
    EXPECT_EQ(problemsOf("{\"fringe\": [1,]}"), "s:1:15: syntax error: value, object or array expected");
}

TEST(SceneSyntax, DuplicateKey) {
    EXPECT_EQ(problemsOf(smallScene("{\"fringe\": 1,\n  \"fringe\": 1, ")),
              R"(s:2:3: duplicate key "fringe"; keep one of them)");
}

TEST(SceneSyntax, NumberThatIsNotFinite) {
    EXPECT_EQ(problemsOf(smallScene("{\"fringe\": 1e999, ")),
              "s:1:12: 1e999 is not a finite number; write one such as 12.5 or 1.2e-3");
    EXPECT_EQ(problemsOf(smallScene("{\"fringe\": NaN, ")),
              "s:1:12: syntax error: value, object or array expected");
}

TEST(SceneSyntax, UnclosedString) {
    EXPECT_EQ(problemsOf("{\"fringe: 1,\n}"),
              "s:1:13: a line break, tab or control character inside a string; write \\n or \\t, or close "
              "the string with \"");
}

TEST(SceneSyntax, DeepNestingIsRefusedWhereItGoesTooDeep) {
    const std::string deep = smallScene("{\"fringe\": " + std::string(100'000, '['));
    EXPECT_EQ(problemsOf(deep), "s:1:75: nested deeper than 64 levels; a scene needs 6");
}

TEST(SceneSyntax, NotUtf8) {
    EXPECT_EQ(problemsOf("{\"fringe\": 1,\n\"caf\xE9\": 1}"),
              "s:2:5: byte 0xE9 is not UTF-8 text; save the file as UTF-8");
    EXPECT_EQ(problemsOf("\xFF\xFE{"), "s:1:1: byte 0xFF is not UTF-8 text; save the file as UTF-8");
    for (const std::string_view bad : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                                       "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\x80", "\xE2\x82", "\xC3"}) {
        EXPECT_NE(problemsOf(std::string("// ") + std::string(bad)).find("s:1:4: byte 0x"),
                  std::string::npos);
    }
    for (const std::string_view good : {"\u00e9", "\u20ac", "\U0001F600", "\uFFFD"}) {
        EXPECT_EQ(problemsOf(smallScene("{\"fringe\": 1, \"description\": \"" + std::string(good) + "\", ")),
                  "no problem");
    }
}

TEST(SceneSyntax, ByteOrderMarkIsNoCharacter) {
    EXPECT_EQ(problemsOf("\xEF\xBB\xBF" + smallScene("{\"fringe\": 1, ")), "no problem");
    EXPECT_EQ(problemsOf("\xEF\xBB\xBF" + smallScene("{\"fringe\": 2, ")),
              R"(s:1:12: "fringe" is 2; write 1)");
}

TEST(SceneSyntax, CommentsAreAllowed) {
    EXPECT_EQ(problemsOf(smallScene("// one: \"{\n{/* two\n */\"fringe\": /* three */ 1, // \"four\": {\n")),
              "no problem");
}

TEST(SceneSyntax, LinesEndWithLfCrLfOrCr) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        EXPECT_EQ(problemsOf(smallScene("{" + end + "// comment" + end + end + " \"fringe\": 2, ")),
                  R"(s:4:12: "fringe" is 2; write 1)");
        EXPECT_EQ(problemsOf("{" + end + end + "\"fringe\": x"),
                  "s:3:11: syntax error: value, object or array expected");
    }
}

TEST(SceneSyntax, ColumnsCountCharacters) {
    EXPECT_EQ(problemsOf(smallScene("{\"description\": \"\u20ac\u20ac\U0001F600\", \"fringe\": 2, ")),
              R"(s:1:34: "fringe" is 2; write 1)");
    EXPECT_EQ(problemsOf("{\"description\": \"\u20ac\u20ac\", \"fringe\": x"),
              "s:1:33: syntax error: value, object or array expected");
}

TEST(SceneSyntax, OnlyTheSyntaxIsReportedWhenItIsWrong) {
    EXPECT_EQ(problemsOf("{\"fringe\": 2, \"blob\": 1"), "s:1:24: missing ',' or '}' in object declaration");
}

}  // namespace
}  // namespace fringe::scene
