#include "profile/sighting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "profile/spectrometer.hpp"

namespace fringe::profile {
namespace {

constexpr std::size_t kMostLines = 4;
constexpr std::size_t kMostOrders = 4;

void addOrders(const scene::Light& light, dvec3 point, Sighting& sighting) {
    const Spectrometer spectrometer(light);
    sighting.u = spectrometer.sine(point);
    sighting.v = 0.0;
    sighting.isUndeviated =
        std::abs(sighting.u) < 0.5 * spectrometer.diffraction(optics::kShortestVisible_nm);
    std::vector<optics::Line> lines = light.spectrum.lines;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.power > b.power; });
    lines.resize(std::min(lines.size(), kMostLines));
    for (const optics::Line& line : lines) {
        const double wavelength_nm = line.wavelength / units::nm;
        sighting.lines.push_back({wavelength_nm, spectrometer.wavelength_nm(sighting.u, 1) / wavelength_nm});
    }
    if (light.spectrum.density.empty() || sighting.isUndeviated) return;
    const int sign = sighting.u < 0.0 ? -1 : 1;
    for (int order = sign; std::abs(order) <= 1000; order += sign) {
        const double wavelength_nm = spectrometer.wavelength_nm(sighting.u, order);
        if (wavelength_nm < optics::kShortestVisible_nm || sighting.orders.size() == kMostOrders) break;
        if (wavelength_nm <= optics::kLongestVisible_nm) sighting.orders.push_back({order, wavelength_nm});
    }
}

}  // namespace

std::vector<Sighting> sightingsFrom(const scene::Scene& scene, dvec3 point) {
    std::vector<Sighting> sightings;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating == nullptr) continue;
        const dvec3 way = point - grating->position;
        const double distance = glm::length(way), height = glm::dot(way, grating->normal);
        if (height <= 0.0) continue;
        const dvec3 change = way / distance - grating->beam.direction;
        Sighting sighting{light.name.empty() ? fmt::format("lights[{}]", i) : light.name,
                          distance,
                          glm::degrees(std::acos(std::min(1.0, height / distance))),
                          glm::dot(change, glm::cross(grating->slitDirection, grating->normal)),
                          glm::dot(change, grating->slitDirection),
                          {},
                          {},
                          false};
        const auto* slits = std::get_if<optics::Slits>(&grating->aperture);
        if (slits != nullptr && slits->count > 1) addOrders(light, point, sighting);
        sightings.push_back(std::move(sighting));
    }
    return sightings;
}

}  // namespace fringe::profile
