#include "preview/instrument.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <glm/geometric.hpp>

namespace fringe::preview {
namespace {

using glm::dvec3;

constexpr double kDiode = 2e-5;  // metres that a point stands for
constexpr std::uint32_t kSamples = 1000;

constexpr std::array<KeyHelp, 4> kInstrumentKeys{
    {{"I", "instrument on and off; while it is on:"},
     {"  click on a surface", "irradiance and spectrum there, orders of the gratings"},
     {"  left button, drag", "the profile along a line on a surface"},
     {"  X", "write what was measured, as CSV, PNG and SVG"}}};

bool isReady(const auto& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

// A direction in a plane, as much to the right of the picture as can be.
dvec3 acrossIn(const scene::Camera& camera, const dvec3& normal) {
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 within = right - glm::dot(right, normal) * normal;
    return glm::normalize(glm::length(within) > 0.1 ? within : glm::cross(normal, forward));
}

}  // namespace

Instrument::~Instrument() {
    for (const ClosedFormTask& task : tasks_) *task.cancelled = true;
}

void Instrument::toggle() {
    isOn_ = !isOn_;
    forget();
    probe_.reset();
}

void Instrument::forget() {
    found_.reset();
    sightings_.clear();
    drawn_.reset();
    isDragged_ = false;
    pressed_.reset();
    complaint_.clear();
    for (const ClosedFormTask& task : tasks_) *task.cancelled = true;
}

bool Instrument::followMouse(const scene::Scene& scene, const scene::Camera& camera, const Rectangle& place) {
    if (!isOn_) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 inPicture((double{io.MousePos.x} - place.x) * scene.image.width / place.width,
                               (double{io.MousePos.y} - place.y) * scene.image.height / place.height);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.WantCaptureMouse && !io.KeyShift) {
        begin(scene, camera, inPicture);
        return false;
    }
    if (!pressed_) return false;
    isDragged_ = isDragged_ || ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    if (isDragged_) {
        // Elsewhere than on the surface where it began, the line ends where it was last on it.
        const auto end = pickAt(scene, camera, inPicture);
        if (end && end->object == pressed_->object) drawn_ = Line{pressed_->point, end->point};
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return false;
    return finish(camera);
}

void Instrument::begin(const scene::Scene& scene, const scene::Camera& camera, glm::dvec2 place) {
    forget();
    pressed_ = pickAt(scene, camera, place);
    if (!pressed_) complaint_ = "there is no surface; click one that lights shine on";
}

bool Instrument::finish(const scene::Camera& camera) {
    if (isDragged_ && !drawn_) {
        pressed_.reset();
        complaint_ = "the line left the surface at once; draw it on one surface";
        return false;
    }
    Probe probe{++number_, {}, {}, camera.position, 1};
    if (drawn_) {
        probe.from = drawn_->from;
        probe.to = drawn_->to;
        probe.samples = kSamples;
    } else {
        const dvec3 half = 0.5 * kDiode * acrossIn(camera, pressed_->normal);
        probe.from = pressed_->point - half;
        probe.to = pressed_->point + half;
    }
    probe_ = probe;
    pressed_.reset();
    drawn_.reset();
    return true;
}

void Instrument::take(Measured measured) {
    if (!probe_ || measured.probe != probe_->number) return;
    found_ = std::move(measured);
    if (!found_->report) return;
    chart_ = profile::chartOf(*found_->report);
    sightings_ = profile::sightingsFrom(*found_->scene, found_->report->line.at(0.5));
    computeClosedForm();
}

// In a thread of its own, since white light takes a second or two.
void Instrument::computeClosedForm() {
    for (const ClosedFormTask& task : tasks_) *task.cancelled = true;
    auto cancelled = std::make_shared<std::atomic<bool>>(false);
    const auto compute = [cancelled, scene = found_->scene, report = found_->report] {
        return profile::closedFormAlong(*scene, report->line, report->samples.points, *cancelled);
    };
    tasks_.push_back({cancelled, found_->report, std::async(std::launch::async, compute)});
}

void Instrument::lookAtClosedForm() {
    std::erase_if(tasks_, [&](ClosedFormTask& task) {
        if (!isReady(task.result)) return false;
        const auto form = task.result.get();
        if (form && found_ && task.of == found_->report) {
            auto report = std::make_shared<profile::Report>(*found_->report);
            report->closedForm = form;
            found_->report = std::move(report);
            chart_ = profile::chartOf(*found_->report);
        }
        return true;
    });
}

bool Instrument::isComputing() const {
    return !tasks_.empty() && found_ && tasks_.back().of == found_->report;
}

std::optional<Instrument::Export> Instrument::exported() const {
    if (!found_ || !found_->report) return std::nullopt;
    const std::string name = std::filesystem::path(found_->report->scene).stem().string() +
                             (probe_->isPoint() ? "-point" : "-profile");
    return Export{found_->report, {name + ".csv", name + ".png", name + ".svg"}};
}

std::span<const KeyHelp> instrumentHelp() {
    return kInstrumentKeys;
}

}  // namespace fringe::preview
