#pragma once

#include "gui/view3d/annotation.h"
#include "gui/view3d/view_colours.h"

#include <QFont>
#include <QPointF>
#include <QRect>

#include <vector>

class QPainter;

namespace luxdeck::gui {

/// Writes annotations where there is room: one that would touch an earlier one is left out.
class AnnotationPainter {
public:
    AnnotationPainter(QPainter& painter, const QRect& area, const ViewColours& colours);
    /// Returns whether there was room.
    bool paint(const Annotation& annotation, QPointF at);

private:
    [[nodiscard]] QSizeF sizeOf(const Annotation& annotation) const;
    /// Marks a box as taken; false when part of it already was.
    bool take(const QRectF& box);
    void paintNumber(const Annotation& annotation, const QRectF& box);
    void paintPill(const Annotation& annotation, const QRectF& box);
    void paintSurface(const Annotation& annotation, const QRectF& box);

    QPainter& painter_;
    QRectF area_;
    ViewColours colours_;
    QFont value_, small_, strong_;
    int columns_ = 0;
    std::vector<std::vector<QRectF>> taken_;   // by cells of the area, so that crowds are quick
};

}  // namespace luxdeck::gui
