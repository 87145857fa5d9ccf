// Materials as records of the device.
#pragma once

#include "compile/compiled_scene.hpp"

namespace fringe::compile {

// Appends every material of the scene in its order, and what optical discs need beside the record.
void addMaterials(const scene::Scene& scene, SpectralTables& tables, CompiledScene& out);

// Whether it sends light on in single directions.
bool isSpecular(const scene::Material& material);

// A surface that glows: radiance in W/(m^2 sr), its row of spectra.
device::Material emissive(double radiance, device::uint spectrum, bool twoSided);

// The slits of the thesis's discs and gratings.
device::ThesisAperture compileAperture(const scene::Slits& slits, scene::Faults faults);

}  // namespace fringe::compile
