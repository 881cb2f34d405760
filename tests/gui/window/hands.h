#pragma once

#include "gui/view3d/scene_view.h"
#include "gui/view3d/view_area.h"
#include "tests/gui/window/open_window.h"

#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QTabBar>
#include <QTableView>
#include <QUrl>
#include <QWheelEvent>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// What the window's stories have in common: a designer's hands, and the command line beside the window.
namespace luxdeck::gui::test {

/// What a command of the shell prints, however it ends (`luxdeck solve` tells by its status that a requirement is not met).
inline std::string outputOf(const std::string& command) {
    std::string out;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    char buffer[65536];
    for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
    pclose(pipe);
    return out;
}

/// What `luxdeck solve --json` says with these options.
inline nlohmann::json solveByCommandLine(const fs::path& project, const std::string& options) {
    const auto out = outputOf(std::string(LUXDECK_PROGRAM) + " solve '" + project.string() + "' --json --quiet " + options);
    return nlohmann::json::parse(out, nullptr, false);
}

inline QString cell(const QAbstractItemView* table, int row, int column) { return table->model()->index(row, column).data().toString(); }

inline std::string contents(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The first of `what` in a file becomes `by`; nothing happens to a file without it but a failed test later.
inline void replaceInFile(const fs::path& file, const std::string& what, const std::string& by) {
    auto text = contents(file);
    if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
    std::ofstream(file, std::ios::binary) << text;
}

/// Types a number over what the box holds, and leaves it.
inline void type(QDoubleSpinBox* box, const QString& number) {
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    QTest::keyClick(box, Qt::Key_Return);
}

/// A box is clicked at its left: room right of its text does nothing.
inline void clickBox(QCheckBox* box) { QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2)); }

/// Brings a tab to the front, of docks or of workspaces, by a click. False: there is none of that name.
inline bool clickTab(const OpenWindow& open, const QString& title) {
    for (auto* bar : open.window->findChildren<QTabBar*>())
        for (int i = 0; i < bar->count(); ++i)
            if (bar->isVisible() && bar->tabText(i).remove(QLatin1Char('&')) == title) {
                QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
                QTest::qWait(50);
                return true;
            }
    return false;
}

/// A wheel's click toward what is under the cursor.
inline void wheelIn(SceneView& view, QPoint at) {
    QWheelEvent wheel(QPointF(at), view.mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);
}

/// The mouse moves there, whether or not it was there before.
inline void moveTo(QWidget& widget, QPoint at, Qt::MouseButtons held = Qt::NoButton) {
    QMouseEvent move(QEvent::MouseMove, QPointF(at), widget.mapToGlobal(at), Qt::NoButton, held, Qt::NoModifier);
    QApplication::sendEvent(&widget, &move);
}

/// The left button goes down at one place, and up at another after some steps.
inline void dragBy(QWidget& widget, QPoint from, QPoint by, Qt::MouseButton button = Qt::LeftButton) {
    constexpr int kSteps = 5;
    QTest::mousePress(&widget, button, {}, from);
    for (int i = 1; i <= kSteps; ++i) moveTo(widget, from + by * i / kSteps, button);
    QTest::mouseRelease(&widget, button, {}, from + by);
}

/// Files are dropped on the window, as a file manager does it.
inline void drop(QWidget& window, const std::vector<fs::path>& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& file : files) urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
    data.setUrls(urls);
    const QPoint at = window.rect().center();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent event(QPointF(at), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
}

/// The next dialog that asks for a file is given this one, by its keyboard.
inline void answerFile(const fs::path& file) {
    QTimer::singleShot(500, qApp, [name = QString::fromStdString(file.string())] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr) return;
        auto* edit = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        edit->selectAll();
        QTest::keyClicks(edit, name);
        QTest::keyClick(edit, Qt::Key_Return);
    });
}

/// The place of an object in the scene's list; the list's size: there is none of that name.
inline std::size_t objectNamed(const Session& session, const std::string& name) {
    const auto& objects = session.project()->project.scene.objects;
    return static_cast<std::size_t>(std::find_if(objects.begin(), objects.end(), [&](const SceneObject& o) { return o.name == name; }) - objects.begin());
}

}  // namespace luxdeck::gui::test
