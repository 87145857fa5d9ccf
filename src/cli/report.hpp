// JSON to standard output and to files, as every command prints it.
#pragma once

#include <json/json.h>

#include <string>

namespace fringe::cli {

std::string formatJson(const Json::Value& value);
void printJson(const Json::Value& value);

}  // namespace fringe::cli
