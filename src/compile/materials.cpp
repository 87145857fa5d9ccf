#include "compile/materials.hpp"

#include "compile/discs.hpp"
#include "compile/number.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;

device::Material material(device::uint kind, double value, device::uint row) {
    device::Material packed{};
    packed.kind = kind;
    packed.value = toFloat(value);
    packed.row = row;
    return packed;
}

// The listing of the disc runs once per light and takes nothing of it but its colour.
dvec3 sumOfLightColors(const scene::Scene& scene) {
    dvec3 sum{0.0};
    for (const scene::Light& light : scene.lights) {
        if (!std::holds_alternative<scene::EnvironmentLight>(light.model)) sum += light.color;
    }
    return sum;
}

struct MaterialCompiler {
    const scene::Scene& scene;
    SpectralTables& tables;
    CompiledScene& out;

    device::Material operator()(const scene::Diffuse& m) const {
        const SpectralTables::Reflector reflector = tables.reflector(m.reflectance);
        return material(device::DIFFUSE, reflector.factor, reflector.row);
    }
    device::Material operator()(const scene::Conductor& m) const {
        return material(device::CONDUCTOR, 0.0, tables.metal(m.metal));
    }
    device::Material operator()(const scene::Dielectric& m) const {
        return material(device::DIELECTRIC, m.ior, 0);
    }
    device::Material operator()(const scene::Emissive& m) const {
        return emissive(m.radiance / units::W_per_m2_sr, tables.spectrum(m.spectrum), m.twoSided);
    }
    device::Material operator()(const scene::ThesisDisc& m) const {
        device::Material packed = material(device::THESIS_DISC, m.mirrorReflectance, 0);
        packed.color = toFloat(sumOfLightColors(scene));
        packed.aperture = compileAperture(m.slits, m.faults);
        return packed;
    }
    device::Material operator()(const scene::OpticalDisc& m) const {
        const SpectralTables::Reflector label = tables.reflector(m.labelReflectance);
        out.opticalDiscs.push_back(compileOpticalDisc(m, tables, out.tables));
        out.opticalDiscs.back().label = label.row;
        return material(device::OPTICAL_DISC, label.factor, count(out.opticalDiscs.size() - 1));
    }
};

}  // namespace

device::ThesisAperture compileAperture(const scene::Slits& slits, scene::Faults faults) {
    return {
        .width_um = toFloat(slits.width / units::um),
        .period_um = toFloat(slits.period / units::um),
        .count = slits.count,
        .asPrinted = faults == scene::Faults::asPrinted,
    };
}

device::Material emissive(double radiance, device::uint spectrum, bool twoSided) {
    device::Material packed = material(device::EMISSIVE, radiance, spectrum);
    packed.twoSided = twoSided ? 1 : 0;
    return packed;
}

bool isSpecular(const scene::Material& material) {
    return !std::holds_alternative<scene::Diffuse>(material.model) &&
           !std::holds_alternative<scene::Emissive>(material.model);
}

void addMaterials(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out) {
    for (const scene::Material& each : scene.materials) {
        out.materials.push_back(std::visit(MaterialCompiler{scene, tables, out}, each.model));
    }
}

}  // namespace fringe::compile
