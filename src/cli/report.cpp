#include "cli/report.hpp"

#include <fmt/format.h>

namespace fringe::cli {

std::string formatJson(const Json::Value& value) {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = 9;
    builder["useSpecialFloats"] = false;
    return Json::writeString(builder, value) + "\n";
}

void printJson(const Json::Value& value) {
    fmt::print("{}", formatJson(value));
}

}  // namespace fringe::cli
