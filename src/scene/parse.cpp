#include "scene/parse.hpp"

#include <fmt/format.h>

#include <cassert>
#include <filesystem>
#include <utility>

#include "scene/extract.hpp"
#include "scene/findings.hpp"
#include "scene/json_text.hpp"
#include "scene/overrides.hpp"
#include "scene/schema.hpp"
#include "scene/validate.hpp"

namespace fringe::scene {
namespace {

std::string joined(const std::vector<Problem>& problems) {
    std::string lines;
    for (const Problem& problem : problems) {
        if (!lines.empty()) lines += '\n';
        lines += fmt::format("{}: {}", problem.place, problem.message);
    }
    return lines;
}

}  // namespace

SceneError::SceneError(std::vector<Problem> problems)
    : std::runtime_error(joined(problems)), problems_(std::move(problems)) {
    assert(!problems_.empty());
}

Scene parseScene(std::string_view text, const std::string& fileName, std::span<const Override> overrides) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());

    Findings findings;
    const auto requireNone = [&] {
        if (!findings.empty()) throw SceneError(placed(std::move(findings), text, fileName, overrides));
    };
    JsonText json = readJson(text, findings);
    requireNone();  // nothing can be said about a text that is not JSON

    applyOverrides(overrides, sceneSchema(), json.root, findings);
    const Unsound unsound = validate(json.root, sceneSchema(), json.keys, findings);
    Surroundings surroundings{findings, std::filesystem::path(fileName).parent_path()};
    Scene scene = extractScene(json.root, unsound, surroundings);
    requireNone();
    return scene;
}

}  // namespace fringe::scene
