#include "gui/app/start.h"

#include "engine/core/parallel.h"
#include "engine/core/version.h"
#include "gui/app/main_window.h"
#include "gui/view3d/graphics.h"
#include "gui/view3d/graphics.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QTimer>

namespace luxdeck::gui {

int run(int argc, char** argv) {
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    prepareGraphics();
    prepareGraphics();
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("luxdeck"));
    QApplication::setApplicationDisplayName(QStringLiteral("Luxdeck"));
    QApplication::setApplicationVersion(QString::fromLatin1(kVersion));
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("The desktop program of Luxdeck."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("PROJECT"), QStringLiteral("project.toml or a bare scene; nothing: the start page"));
    parser.process(application);

    const YieldingWorkers quick;  // the window before the light
    Memory memory;
    applyTheme(application, memory.theme());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/luxdeck/luxdeck.svg")));
    MainWindow window(memory);
    window.show();
    if (const auto files = parser.positionalArguments(); !files.isEmpty()) QTimer::singleShot(0, &window, [&] { window.open(files.front()); });
    return QApplication::exec();
}

}  // namespace luxdeck::gui
