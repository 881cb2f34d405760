#pragma once

#include "analysis/grids/solve_result.h"
#include "engine/volume/volume.h"
#include "gui/session/units.h"
#include "gui/view3d/light_colours.h"

#include <QColor>

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace luxdeck::gui {

/// A corner and the two edges of a surface, re-based [m].
struct SurfaceFrame {
    Vec3d origin, u, v;
};

/// The rectangle with the texture coordinates that fieldTexture() is made for.
vtkSmartPointer<vtkPolyData> surfaceQuad(const SurfaceFrame& frame);
vtkSmartPointer<vtkPolyData> surfaceOutline(const SurfaceFrame& frame);

/// A surface's values as colours, fine enough to be smooth. `old` ones have most of their colour taken out.
vtkSmartPointer<vtkImageData> fieldTexture(const std::vector<double>& values, int columns, int rows, const LightColours& colours, bool old);
QRgb shownColour(const tonemap::Colour8& colour, bool old);

/// A line of equal illuminance where it may carry its level.
struct LevelMark {
    Vec3d at;
    double lux;
};
/// Lines of equal illuminance at levels that are round in the unit shown. Point data "colours", RGB.
///
/// marks  one for the longest line of each level is added
vtkSmartPointer<vtkPolyData> isolineShapes(const std::vector<double>& values, int columns, int rows, const SurfaceFrame& frame, const LightColours& colours, const Units& units, std::vector<LevelMark>& marks);

/// Points that are shown by themselves.
struct PointSet {
    GridKind kind = GridKind::Planar;
    std::vector<Vec3d> points, normals;  ///< re-based
    std::vector<double> lux;             ///< #points; empty: not solved yet, grey
    double radiusM = 0.05;
};
/// Small discs across their normals (planar), or upright cylinders (cylindrical). Point data "colours", RGB.
vtkSmartPointer<vtkPolyData> pointShapes(const std::vector<PointSet>& sets, const LightColours& colours, bool old);

}  // namespace luxdeck::gui
