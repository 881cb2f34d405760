#pragma once

#include "engine/core/vec.h"
#include "gui/session/units.h"

#include <QFormLayout>
#include <QString>
#include <QWidget>

#include <functional>
#include <string>

class QPushButton;
class QLabel;

namespace luxdeck::gui {

/// Fields under each other, each with what is to be done when its value has been changed (Enter, or leaving it).
class PropertyForm : public QWidget {
public:
    PropertyForm(const QString& title, const QString& kind, const Units& units, QWidget* parent);

    struct Range {
        double low = -1e6, high = 1e6, step = 0.1;
        int decimals = 3;
        QString unit;
        QString least{};  ///< what the lowest value is called
    };
    /// A field's label and the name that tests and shortcuts know it by.
    struct Field {
        QString label;
        const char* name;
    };

    void heading(const QString& text);
    QLabel* fact(const QString& label, const QString& value);
    QLabel* note(const QString& text);
    void text(const Field& field, const std::string& value, std::function<void(const std::string&)> changed);
    void number(const Field& field, double value, const Range& range, std::function<void(double)> changed);
    /// In metres, shown in the units' length; each axis is a field "nameX" ...
    void place(const Field& field, const Vec3d& metres, std::function<void(const Vec3d&)> changed);
    void direction(const Field& field, const Vec3d& value, std::function<void(const Vec3d&)> changed);
    /// 0 .. 1 with a switch: off is 0.
    void dimming(double value, const std::function<void(double)>& changed);
    void flag(const Field& field, bool value, std::function<void(bool)> changed);
    void choice(const Field& field, const QStringList& choices, const QString& value, std::function<void(const QString&)> changed);
    QPushButton* button(const Field& field, const QString& tip, std::function<void()> pressed);
    void widget(QWidget* widget) { rows_->addRow(widget); }

private:
    void axes(const Field& field, const Vec3d& shown, const Range& range, const std::function<void(const Vec3d&)>& changed);

    Units units_;
    QFormLayout* rows_;
};

}  // namespace luxdeck::gui
