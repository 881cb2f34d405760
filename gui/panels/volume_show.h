#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace luxdeck::gui {

/// What one view shows of a volume: spheres, grids, a slice, an iso-surface; and views side by side.
class VolumeShow : public QWidget {
    Q_OBJECT

public:
    explicit VolumeShow(Session& session, QWidget* parent = nullptr);

    /// The view whose settings are changed here.
    void setView(std::size_t index);

private:
    using Switch = bool ViewSettings::*;

    QWidget* whose();
    QWidget* spheres();
    QWidget* slices();
    QWidget* sideBySide();
    QCheckBox* addSwitch(const QString& text, const char* name, const QString& tip, Switch member);
    void change(const std::function<void(ViewSettings&)>& edit);
    void switchSlice(bool on);
    void directAgainstIndirect();
    void twoVolumes();
    void refresh();
    void refreshNames(const ViewSettings& view);

    Session& session_;
    std::size_t view_ = 0;
    bool following_ = false;
    std::vector<std::pair<QCheckBox*, Switch>> switches_;
    QLabel *title_, *orderText_, *radiusText_, *offsetText_;
    QComboBox *volume_, *part_, *axis_, *facing_;
    QSlider *order_, *radius_, *offset_;
    QCheckBox* slice_;
    QDoubleSpinBox* level_;
    QPushButton *parts_, *volumes_;
};

}  // namespace luxdeck::gui
