#pragma once

#include "gui/session/session.h"
#include "gui/view3d/light_colours.h"

#include <QDoubleSpinBox>
#include <QWidget>

namespace luxdeck::gui {

/// The one scale of colours beside the views: title, unit, round ticks. A click on one of its ends edits that end, anywhere
/// else opens a menu: automatic range, logarithmic, colours.
class LegendBar : public QWidget {
    Q_OBJECT

public:
    explicit LegendBar(Session& session, QWidget* parent = nullptr);

    /// radiance  the colours are of radiance (cd/m²), not of illuminance
    void show(const ResolvedScale& scale, bool radiance);
    /// "lx", "fc", "cd/m²" or "fL".
    [[nodiscard]] QString unit() const;
    /// The numbers beside the bar, from the lowest.
    [[nodiscard]] QStringList numbers() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct Tick {
        double position;   // 0 .. 1 upwards
        QString number;
    };
    [[nodiscard]] std::vector<Tick> ticks() const;
    [[nodiscard]] QRect bar() const;
    [[nodiscard]] double shown(double value) const;
    [[nodiscard]] double meant(double shown) const;
    void openMenu(QPoint at);
    void edit(bool high);
    void finishEdit();

    Session& session_;
    ResolvedScale scale_;
    bool radiance_ = false;
    QDoubleSpinBox* end_;      // over the end that is edited
    bool editsHigh_ = false;
};

}  // namespace luxdeck::gui
