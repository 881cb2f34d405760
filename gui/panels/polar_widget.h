#pragma once

#include "analysis/photometry/photometric_facts.h"
#include "engine/scene/candela_table.h"

#include <QWidget>

namespace luxdeck::gui {

/// The polar curve of a luminaire type, drawn as on its data sheet: on paper, in the dark theme, too.
class PolarWidget : public QWidget {
public:
    PolarWidget(const CandelaTable& table, QWidget* parent);

    [[nodiscard]] QSize sizeHint() const override { return {240, 240}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    PolarCurve curve_;
};

}  // namespace luxdeck::gui
