#pragma once

#include "engine/scene/scene.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

namespace luxdeck::gui {

/// Luminaires' openings as bodies in the colour of their light, grey by as much as they are dimmed. Point data "colours",
/// RGB as shown. Re-based coordinates [m].
vtkSmartPointer<vtkPolyData> luminaireBodies(const Scene& scene, const std::vector<std::uint32_t>& luminaires);
/// Their outlines.
vtkSmartPointer<vtkPolyData> luminaireOutlines(const Scene& scene, const std::vector<std::uint32_t>& luminaires);

/// Their photometric solids: in each direction as far from the luminaire as its intensity says.
///
/// metresPerCandela  of the candela that leave the luminaire as it is dimmed
/// fine              for a few: every angle of the file up to a hundred
vtkSmartPointer<vtkPolyData> candelaSolids(const Scene& scene, const std::vector<std::uint32_t>& luminaires, double metresPerCandela, bool fine);

/// The largest intensity of a luminaire as it is dimmed [cd].
double largestIntensity(const Scene& scene, const Luminaire& luminaire);

}  // namespace luxdeck::gui
