// The instrument: measures at the point of a surface that is clicked, or along a line that is drawn on one,
// and sets beside it what the textbook says. Input, what is to be measured, and what came of it; drawn by
// instrument_panel.hpp.
#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "preview/navigation.hpp"
#include "preview/picking.hpp"
#include "preview/probe.hpp"
#include "profile/sighting.hpp"

namespace fringe::preview {

class Instrument {
public:
    ~Instrument();

    bool isOn() const { return isOn_; }
    void toggle();

    // The left button over the picture, as Dear ImGui has it. True when there is something else to measure.
    bool followMouse(const scene::Scene& scene, const scene::Camera& camera, const Rectangle& place);

    // What is to be measured.
    const std::optional<Probe>& probe() const { return probe_; }

    // What of the line is drawn already.
    struct Line {
        glm::dvec3 from, to;
    };
    const std::optional<Line>& drawn() const { return drawn_; }

    // What has been found. Answers to other probes than the last are of no use.
    void take(Measured measured);

    // Takes the closed form when it is there. Call it once a frame.
    void lookAtClosedForm();

    const Measured* found() const { return found_ ? &*found_ : nullptr; }
    const plot::Chart& chart() const { return chart_; }
    const std::vector<profile::Sighting>& sightings() const { return sightings_; }
    bool isComputing() const;

    // Why nothing could be picked; empty: something was.
    const std::string& complaint() const { return complaint_; }

    // NAME-profile.csv, .png and .svg of a line, NAME-point of a point, in the working folder. Null while
    // there is nothing to write.
    struct Export {
        std::shared_ptr<const profile::Report> report;
        std::vector<std::filesystem::path> files;
    };
    std::optional<Export> exported() const;

private:
    struct ClosedFormTask {
        std::shared_ptr<std::atomic<bool>> cancelled;
        std::shared_ptr<const profile::Report> of;
        std::future<std::optional<profile::ClosedFormProfile>> result;
    };

    void begin(const scene::Scene& scene, const scene::Camera& camera, glm::dvec2 place);
    bool finish(const scene::Camera& camera);
    void computeClosedForm();
    void forget();

    bool isOn_ = false;
    std::uint64_t number_ = 0;
    std::optional<Pick> pressed_;  // where the button went down
    bool isDragged_ = false;
    std::optional<Line> drawn_;
    std::optional<Probe> probe_;
    std::optional<Measured> found_;
    plot::Chart chart_;
    std::vector<profile::Sighting> sightings_;
    std::vector<ClosedFormTask> tasks_;  // the last, and earlier ones that have not ended yet
    std::string complaint_;
};

std::span<const KeyHelp> instrumentHelp();

}  // namespace fringe::preview
