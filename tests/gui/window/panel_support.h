#pragma once

#include "gui/app/theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QTest>
#include <QWidget>

#include <cstdlib>
#include <string>

namespace luxdeck::gui::test {

/// The widget of that name within another; fails the test where there is none.
template <class T>
T* found(QWidget& in, const char* name) {
    auto* widget = in.findChild<T*>(QString::fromLatin1(name));
    if (widget == nullptr) qFatal("no widget is called %s", name);
    return widget;
}

inline void click(QWidget& in, const char* name) {
    auto* button = found<QAbstractButton>(in, name);
    // A box is clicked at its left: room right of its text does nothing.
    const auto at = qobject_cast<QCheckBox*>(button) != nullptr ? QPoint(10, button->height() / 2) : button->rect().center();
    QTest::mouseClick(button, Qt::LeftButton, {}, at);
}

/// What a widget looks like, in light and dark at two sizes, into the folder that LUXDECK_PICTURES names: to be looked at.
inline void picture(QWidget& widget, const std::string& name) {
    const char* folder = std::getenv("LUXDECK_PICTURES");
    if (folder == nullptr) return;
    const auto before = widget.size();
    for (const auto theme : {Theme::Light, Theme::Dark})
        for (const QSize size : {QSize(1280, 800), QSize(1600, 1000)}) {
            applyTheme(*qApp, theme);
            widget.resize(size);
            QTest::qWait(120);
            widget.grab().save(QString::fromStdString(std::string(folder) + "/" + name + (theme == Theme::Light ? "_light_" : "_dark_") + std::to_string(size.width()) + ".png"));
        }
    widget.resize(before);
    QTest::qWait(50);
}

}  // namespace luxdeck::gui::test
