// What a profile found, as text and as JSON.
#pragma once

#include <json/json.h>

#include <string>
#include <vector>

#include "profile/report.hpp"

namespace fringe::cli {

struct ProfileReport : profile::Report {
    std::string device;
    std::vector<std::string> notes;
    std::vector<std::string> outputs;  // files written
};

Json::Value toJson(const ProfileReport& report);
void print(const ProfileReport& report);

}  // namespace fringe::cli
