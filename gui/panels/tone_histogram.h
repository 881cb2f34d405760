#pragma once

#include "gui/session/look.h"
#include "gui/session/units.h"

#include <QWidget>

#include <memory>

namespace luxdeck::gui {

/// How much of a picture has which luminance, and over it the curve that maps it to the display. Both axes are logarithmic.
class ToneHistogram : public QWidget {
    Q_OBJECT

public:
    explicit ToneHistogram(QWidget* parent = nullptr);
    void show(std::shared_ptr<const Developed> picture, const Units& units);
    /// A line at a luminance [cd/m²]; 0: none.
    void mark(double cdM2);

    [[nodiscard]] QSize sizeHint() const override { return {290, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 130}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Frame;
    void drawBars(QPainter& painter, const Frame& frame) const;
    void drawAxes(QPainter& painter, const Frame& frame) const;
    void drawCurve(QPainter& painter, const Frame& frame) const;

    std::shared_ptr<const Developed> picture_;
    Units units_;
    double marked_ = 0;
};

}  // namespace luxdeck::gui
