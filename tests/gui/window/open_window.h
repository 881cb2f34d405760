#pragma once

#include "gui/app/main_window.h"
#include "tests/gui/open_session.h"

#include <QAction>
#include <QApplication>
#include <QMessageBox>
#include <QAbstractButton>
#include <QTest>
#include <QTimer>

#include <functional>
#include <memory>
#include <string>

namespace luxdeck::gui::test {

/// The program's window on the tests' display, and hands for it.
class OpenWindow {
public:
    OpenWindow() {
        window->show();
        (void)QTest::qWaitForWindowExposed(window.get());
    }
    ~OpenWindow() { window->session().forget(); }  // no question at the end
    OpenWindow(const OpenWindow&) = delete;
    OpenWindow& operator=(const OpenWindow&) = delete;

    Memory memory;
    std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>(memory);

    [[nodiscard]] Session& session() const { return window->session(); }

    /// Lets the program work until it is so; false: not within two minutes.
    static bool until(const std::function<bool()>& so) { return QTest::qWaitFor(so, 120'000); }
    [[nodiscard]] bool untilIdle() const {
        return until([this] { return session().place.jobs.idle(); });
    }
    [[nodiscard]] bool open(const fs::path& file) const {
        window->open(QString::fromStdString(file.string()));
        return untilIdle() && session().project() != nullptr;
    }

    /// A widget by its name; the test ends in a segmentation fault without it, after saying which.
    template <class Widget = QWidget>
    [[nodiscard]] Widget* find(const char* name) const {
        auto* widget = window->findChild<Widget*>(QString::fromLatin1(name));
        if (widget == nullptr) qFatal("no widget \"%s\"", name);
        return widget;
    }
    void click(const char* name) const { QTest::mouseClick(find(name), Qt::LeftButton); }
    /// A menu's command.
    void command(const char* name) const { find<QAction>(name)->trigger(); }

    /// The text of a message that is shown now, which is then closed; empty: none.
    [[nodiscard]] std::string message() const {
        QMessageBox* box = nullptr;
        if (!QTest::qWaitFor([&] { return (box = window->findChild<QMessageBox*>()) != nullptr && box->isVisible(); }, 20'000)) return {};
        const auto text = box->text().toStdString();
        box->close();
        (void)QTest::qWaitFor([&] { return window->findChild<QMessageBox*>() == nullptr; }, 5000);
        return text;
    }
    /// The next question is answered with the button of that text.
    static void answer(const QString& button) {
        QTimer::singleShot(300, qApp, [button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr) return;
            for (auto* b : box->buttons())
                if (b->text().remove(QLatin1Char('&')).contains(button)) QTest::mouseClick(b, Qt::LeftButton);
        });
    }
    /// A picture of the window, for people.
    void picture(const char* file) const { window->grab().save(QString::fromLatin1(file)); }
};

}  // namespace luxdeck::gui::test
