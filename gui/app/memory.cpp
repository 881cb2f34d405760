#include "gui/app/memory.h"

namespace luxdeck::gui {

namespace {
constexpr int kMostRecent = 10;
const QString kRecent = QStringLiteral("recent");
}  // namespace

QStringList Memory::recent() const { return settings_.value(kRecent).toStringList(); }

void Memory::opened(const QString& file) {
    auto files = recent();
    files.removeAll(file);
    files.prepend(file);
    while (files.size() > kMostRecent) files.removeLast();
    settings_.setValue(kRecent, files);
}

void Memory::forget(const QString& file) {
    auto files = recent();
    files.removeAll(file);
    settings_.setValue(kRecent, files);
}

void Memory::keepWindow(const QByteArray& geometry, const QByteArray& docks) {
    settings_.setValue(QStringLiteral("window/geometry"), geometry);
    settings_.setValue(QStringLiteral("window/docks"), docks);
}

Theme Memory::theme() const { return settings_.value(QStringLiteral("theme")).toString() == QLatin1String("dark") ? Theme::Dark : Theme::Light; }

void Memory::keepTheme(Theme theme) { settings_.setValue(QStringLiteral("theme"), theme == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light")); }

Display Memory::display() const {
    Display display;
    if (settings_.value(QStringLiteral("units/light")).toString() == QLatin1String("fc")) display.units.light = LightUnit::Footcandle;
    if (settings_.value(QStringLiteral("units/length")).toString() == QLatin1String("ft")) display.units.length = LengthUnit::Feet;
    const int navigation = settings_.value(QStringLiteral("navigation"), 0).toInt();
    if (navigation >= 0 && navigation <= static_cast<int>(Navigation::Holodeck)) display.navigation = static_cast<Navigation>(navigation);
    return display;
}

void Memory::keepDisplay(const Display& display) {
    settings_.setValue(QStringLiteral("units/light"), QString::fromUtf8(display.units.illuminanceUnit()));
    settings_.setValue(QStringLiteral("units/length"), QString::fromUtf8(display.units.lengthUnit()));
    settings_.setValue(QStringLiteral("navigation"), static_cast<int>(display.navigation));
}

}  // namespace luxdeck::gui
