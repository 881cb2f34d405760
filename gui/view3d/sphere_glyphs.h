#pragma once

#include "gui/session/volume_light.h"
#include "gui/view3d/light_colours.h"

#include <vtkNew.h>

#include <cstdint>
#include <vector>

class vtkActor;
class vtkObject;
class vtkOpenGLPolyDataMapper;
class vtkRenderer;
class vtkTextureObject;

namespace luxdeck::gui {

/// Spheres whose colour differs by direction, thousands of them: each is one square that faces the camera, in which a shader
/// finds the sphere, and looks its bin up in a picture of all bins of all spheres. A sphere costs as many pixels as it covers,
/// whatever its bins; all bins are always shown.
class SphereGlyphs {
public:
    explicit SphereGlyphs(vtkRenderer& renderer);
    ~SphereGlyphs();
    SphereGlyphs(const SphereGlyphs&) = delete;
    SphereGlyphs& operator=(const SphereGlyphs&) = delete;

    /// Where spheres are: at the volume's usable vertices; as many as a picture of all their bins can hold, evenly taken, if
    /// there are more.
    void place(const IrradianceVolume& volume);
    /// What they show. Of the volume that was placed.
    void colour(const LightSpheres& spheres, const LightColours& colours);
    void setRadius(double metres);
    void setVisible(bool visible);

    [[nodiscard]] std::size_t count() const { return vertices_.size(); }

private:
    void addShaders();
    void bind(vtkObject* mapper, unsigned long event, void* program);

    vtkRenderer& renderer_;
    vtkNew<vtkActor> actor_;
    vtkNew<vtkOpenGLPolyDataMapper> mapper_;
    vtkNew<vtkTextureObject> texture_;
    std::vector<std::uint32_t> vertices_;   // of the volume
    int side_ = 1, tilesAcross_ = 1;        // a tile holds a sphere's bins: 2 side x side
    int width_ = 0, height_ = 0;            // of the picture
    std::vector<std::uint8_t> picture_;     // RGB rows
    bool uploaded_ = false;
};

}  // namespace luxdeck::gui
