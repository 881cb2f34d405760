#include "gui/app/start.h"

#include <QApplication>
#include <QMainWindow>

namespace luxdeck::gui {

int run(int argc, char** argv) {
    QApplication application(argc, argv);
    QMainWindow window;
    window.show();
    return QApplication::exec();
}

}  // namespace luxdeck::gui
