#pragma once

#include "tonemap/falsecolor.h"

#include <QString>
#include <QWidget>

namespace luxdeck::gui {

/// The scale of a picture in false colour: a bar with round numbers beneath and its unit.
class ColourBar : public QWidget {
    Q_OBJECT

public:
    explicit ColourBar(QWidget* parent = nullptr);
    /// range  as it is to be written, in `unit`
    void show(tonemap::ColourMap map, const tonemap::ScaleRange& range, bool logarithmic, const QString& unit);

    [[nodiscard]] QSize sizeHint() const override { return {260, 46}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 44}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    tonemap::ColourMap map_ = tonemap::ColourMap::Dusk;
    tonemap::ScaleRange range_;
    bool logarithmic_ = false;
    QString unit_;
};

}  // namespace luxdeck::gui
