#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace luxdeck::gui {

/// What the active view shows: surfaces, luminaires, calculation surfaces; where it is cut open; and the legend of all views.
class ShowPanel : public QWidget {
    Q_OBJECT

public:
    explicit ShowPanel(Session& session, QWidget* parent = nullptr);

    /// The view whose settings are changed here.
    void setView(std::size_t index);

private:
    using Switch = bool ViewSettings::*;

    QWidget* surfaces();
    QWidget* light();
    QWidget* section();
    QWidget* legend();
    QCheckBox* addSwitch(const QString& text, const QString& tip, Switch member);
    void change(const std::function<void(ViewSettings&)>& edit);
    void changeLegend(const std::function<void(LegendScale&)>& edit);
    void refresh();
    void refreshLegend();

    Session& session_;
    std::size_t view_ = 0;
    bool following_ = false;
    std::vector<std::pair<QCheckBox*, Switch>> switches_;
    QLabel* title_;
    QComboBox *look_, *part_, *sectionAxis_, *map_;
    QCheckBox *sectionOn_, *automatic_, *logarithmic_;
    QSlider* sectionOffset_;
    QLabel* sectionText_;
    QDoubleSpinBox *low_, *high_;
};

}  // namespace luxdeck::gui
