#include "gui/app/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QStyleFactory>

/// The arrows lie in a static library, whose resources nobody else asks for.
static void readyIcons() { Q_INIT_RESOURCE(icons); }

namespace luxdeck::gui {

namespace {

struct Colours {
    QColor window, base, alternate, text, quiet, button, line, accent, onAccent, tip;
};

const Colours kLight{{"#f4f5f7"}, {"#ffffff"}, {"#f7f8fa"}, {"#1d232b"}, {"#68727f"}, {"#ffffff"}, {"#d5d9e0"}, {"#0f6e84"}, {"#ffffff"}, {"#ffffff"}};
const Colours kDark{{"#1f2329"}, {"#16191e"}, {"#1b1f25"}, {"#e3e7ec"}, {"#97a1ae"}, {"#2a2f37"}, {"#3a414b"}, {"#3fb0c6"}, {"#0b1316"}, {"#2a2f37"}};

QPalette paletteOf(const Colours& c) {
    QPalette p;
    p.setColor(QPalette::Window, c.window);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.base);
    p.setColor(QPalette::AlternateBase, c.alternate);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::PlaceholderText, c.quiet);
    p.setColor(QPalette::Button, c.button);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::BrightText, c.onAccent);
    p.setColor(QPalette::ToolTipBase, c.tip);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::Highlight, c.accent);
    p.setColor(QPalette::HighlightedText, c.onAccent);
    p.setColor(QPalette::Link, c.accent);
    p.setColor(QPalette::Mid, c.line);
    p.setColor(QPalette::Midlight, c.line);
    p.setColor(QPalette::Dark, c.quiet);
    p.setColor(QPalette::Light, c.base);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) p.setColor(QPalette::Disabled, role, c.quiet);
    p.setColor(QPalette::Disabled, QPalette::Highlight, c.line);
    return p;
}

/// What palettes cannot say: room around text, thin lines, round corners.
QString sheetOf(const Colours& c, Theme theme) {
    auto sheet = QStringLiteral(R"(
QToolTip { border: 1px solid @line; padding: 4px; }
QMainWindow::separator { background: @line; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: @accent; }
QDockWidget { font-weight: 600; }
QDockWidget::title { padding: 6px 8px; background: @window; border-bottom: 1px solid @line; }
QMenuBar { padding: 2px; border-bottom: 1px solid @line; }
QToolBar { border: none; padding: 1px 6px; spacing: 2px; }
QStatusBar { border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QTabWidget::pane { border: none; border-top: 1px solid @line; }
QTabBar::tab { padding: 7px 9px; border: none; border-bottom: 2px solid transparent; color: @quiet; }
QTabBar::tab:selected { border-bottom-color: @accent; color: @text; }
QTabBar::tab:hover { color: @text; }
QHeaderView::section { background: @window; border: none; border-bottom: 1px solid @line; padding: 5px 8px; color: @quiet; }
QTreeView, QTableView, QListView { border: none; }
QTreeView::item, QListView::item { padding: 3px 2px; }
QPushButton, QToolButton, QComboBox, QSpinBox, QDoubleSpinBox, QLineEdit { border: 1px solid @line; border-radius: 5px; padding: 4px 8px; background: @button; }
QToolButton { background: transparent; border-color: transparent; }
QToolButton:hover, QPushButton:hover, QComboBox:hover { border-color: @accent; }
QToolButton:checked { background: @line; }
QToolBar QToolButton { padding: 2px 8px; }
QPushButton:default { background: @accent; border-color: @accent; color: @onAccent; }
QPushButton:disabled, QComboBox:disabled { color: @quiet; background: @window; }
QLineEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QComboBox:focus { border-color: @accent; }
QSpinBox::up-button, QDoubleSpinBox::up-button, QSpinBox::down-button, QDoubleSpinBox::down-button { width: 18px; border: none; }
QSpinBox::up-arrow, QDoubleSpinBox::up-arrow { image: url(:/luxdeck/up-@theme.svg); width: 10px; height: 10px; }
QSpinBox::down-arrow, QDoubleSpinBox::down-arrow { image: url(:/luxdeck/down-@theme.svg); width: 10px; height: 10px; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/luxdeck/down-@theme.svg); width: 12px; height: 12px; }
QComboBox QAbstractItemView { border: 1px solid @line; selection-background-color: @accent; }
QScrollBar:vertical { width: 11px; background: transparent; margin: 0; }
QScrollBar:horizontal { height: 11px; background: transparent; margin: 0; }
QScrollBar::handle { background: @line; border-radius: 4px; margin: 2px; min-height: 28px; min-width: 28px; }
QScrollBar::handle:hover { background: @quiet; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QProgressBar { border: none; border-radius: 3px; background: @line; max-height: 6px; text-align: center; }
QProgressBar::chunk { border-radius: 3px; background: @accent; }
QGroupBox { border: none; margin-top: 18px; font-weight: 600; }
QGroupBox::title { subcontrol-origin: margin; left: 0; padding: 2px 0; }
QScrollArea { border: none; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
)");
    sheet.replace(QLatin1String("@theme"), theme == Theme::Dark ? QLatin1String("dark") : QLatin1String("light"));
    const std::pair<const char*, QColor> names[] = {{"@line", c.line}, {"@window", c.window}, {"@accent", c.accent}, {"@onAccent", c.onAccent},
                                                    {"@quiet", c.quiet}, {"@text", c.text}, {"@button", c.button}};
    for (const auto& [name, colour] : names) sheet.replace(QString::fromLatin1(name) + QLatin1Char(';'), colour.name() + QLatin1Char(';'));
    return sheet;
}

}  // namespace

void applyTheme(QApplication& application, Theme theme) {
    readyIcons();
    const auto& colours = theme == Theme::Dark ? kDark : kLight;
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QFont font = QApplication::font();
    if (QFontDatabase().families().contains(QStringLiteral("Inter"))) font.setFamily(QStringLiteral("Inter"));
    font.setPointSizeF(9.5);
    QApplication::setFont(font);
    QApplication::setPalette(paletteOf(colours));
    application.setStyleSheet(sheetOf(colours, theme));
}

Theme themeOf(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128 ? Theme::Dark : Theme::Light; }

}  // namespace luxdeck::gui
