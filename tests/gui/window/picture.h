#pragma once

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <string>

namespace luxdeck::gui::test {

/// A renderer whose pictures can be looked at pixel by pixel.
class Picture {
public:
    using Colour = std::array<int, 3>;

    explicit Picture(int width = 400, int height = 300) {
        window_->SetOffScreenRendering(1);
        window_->SetMultiSamples(0);
        window_->SetSize(width, height);
        window_->AddRenderer(renderer);
        renderer->SetBackground(0, 0, 0);
    }

    vtkNew<vtkRenderer> renderer;

    /// From `eye` at `target`, z up.
    void look(const std::array<double, 3>& eye, const std::array<double, 3>& target, double angleDeg = 30) {
        auto* camera = renderer->GetActiveCamera();
        camera->SetPosition(eye.data());
        camera->SetFocalPoint(target.data());
        camera->SetViewUp(0, 0, 1);
        camera->SetViewAngle(angleDeg);
        renderer->ResetCameraClippingRange();
    }
    void render() { window_->Render(); }
    /// Of the last picture, from its lower left corner.
    Colour at(int x, int y) {
        vtkNew<vtkUnsignedCharArray> pixel;
        window_->GetPixelData(x, y, x, y, 1, pixel);
        return {pixel->GetValue(0), pixel->GetValue(1), pixel->GetValue(2)};
    }
    void save(const std::string& file) {
        vtkNew<vtkWindowToImageFilter> image;
        image->SetInput(window_);
        vtkNew<vtkPNGWriter> writer;
        writer->SetFileName(file.c_str());
        writer->SetInputConnection(image->GetOutputPort());
        writer->Write();
    }

private:
    vtkNew<vtkRenderWindow> window_;
};

}  // namespace luxdeck::gui::test
