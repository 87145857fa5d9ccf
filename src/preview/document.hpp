// The scene file as it is edited: its JSON with the changes made so far, which are overrides
// (scene/parse.hpp), and the whole as a Source and as the text of a new file. No checks of its own: whoever
// parses the Source finds what is wrong.
#pragma once

#include <json/value.h>

#include <memory>
#include <string>
#include <vector>

#include "preview/wish.hpp"

namespace fringe::preview {

class Document {
public:
    // Precondition: the schema takes the text.
    explicit Document(Source source);

    const Json::Value& root() const { return root_; }

    // Another pointer after every change.
    const std::shared_ptr<const Source>& source() const { return source_; }

    // By set(), since the file was read.
    bool isChanged() const { return isChanged_; }

    // Sets the value at keys and indices with dots between them: "lights.2.beam.power".
    void set(const std::string& path, const Json::Value& value);

    // Takes the text of the file as it is now; changes made so far are gone, but those that the Source came
    // with stay. A text that the schema refuses leaves root() as it was.
    void reload(std::string text);

private:
    std::shared_ptr<const Source> source_;
    Json::Value root_;
    std::vector<scene::Override> given_;  // that the Source came with
    bool isChanged_ = false;
};

// As it stands in an override, and in a file.
std::string jsonText(const Json::Value& value);
std::string fileText(const Json::Value& value);

}  // namespace fringe::preview
