#pragma once

#include "gui/app/theme.h"
#include "gui/session/display.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

namespace luxdeck::gui {

/// What the program remembers of its user from one day to the next: recent projects, where docks were, units, theme.
class Memory {
public:
    [[nodiscard]] QStringList recent() const;
    /// To the front of the recent ones; at most ten are kept.
    void opened(const QString& file);
    void forget(const QString& file);

    [[nodiscard]] QByteArray geometry() const { return settings_.value(QStringLiteral("window/geometry")).toByteArray(); }
    [[nodiscard]] QByteArray docks() const { return settings_.value(QStringLiteral("window/docks")).toByteArray(); }
    void keepWindow(const QByteArray& geometry, const QByteArray& docks);

    [[nodiscard]] Theme theme() const;
    void keepTheme(Theme theme);
    /// Units and navigation; the legend begins anew with each project.
    [[nodiscard]] Display display() const;
    void keepDisplay(const Display& display);

private:
    mutable QSettings settings_{QSettings::IniFormat, QSettings::UserScope, QStringLiteral("luxdeck"), QStringLiteral("luxdeck-gui")};
};

}  // namespace luxdeck::gui
