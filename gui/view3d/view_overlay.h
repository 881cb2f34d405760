#pragma once

#include "gui/session/camera_motion.h"
#include "gui/view3d/annotation.h"
#include "gui/view3d/view_colours.h"

#include <QWidget>

#include <cstdint>
#include <functional>
#include <vector>

namespace luxdeck::gui {

/// What is drawn flat over a view: texts at places of the scene, axes, hints, the frame of the active view. Lets all mouse
/// events through.
class ViewOverlay : public QWidget {
    Q_OBJECT

public:
    explicit ViewOverlay(QWidget* parent);

    /// seen  which annotations nothing hides, #annotations
    void setAnnotations(std::vector<Annotation> annotations, std::vector<std::uint8_t> seen);
    void setPose(const CameraPose& pose);
    void setColours(const ViewColours& colours);
    void setFramed(bool framed);
    /// A line at the bottom: how to move, how fast. Empty: none.
    void setHint(const QString& hint);
    /// A reading beside the cursor; empty: none.
    void setReading(const QString& reading, QPoint at);
    /// More to be painted, by who has put it there (handles of what is selected).
    void setPainter(std::function<void(QPainter&)> painter) { painter_ = std::move(painter); }

    [[nodiscard]] const std::vector<Annotation>& annotations() const { return annotations_; }
    /// Where a point of the scene is painted, in pixels; none: behind the camera.
    [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3d& point) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintAnnotations(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintHint(QPainter& painter) const;
    void paintReading(QPainter& painter) const;

    std::vector<Annotation> annotations_;
    std::vector<std::uint8_t> seen_;
    CameraPose pose_;
    ViewColours colours_;
    bool framed_ = false;
    QString hint_, reading_;
    QPoint readingAt_;
    std::function<void(QPainter&)> painter_;
};

}  // namespace luxdeck::gui
