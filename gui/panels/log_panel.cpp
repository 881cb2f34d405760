#include "gui/panels/log_panel.h"

#include "gui/panels/text.h"

#include <QStyle>

namespace luxdeck::gui {

namespace {

QStyle::StandardPixmap iconOf(Severity severity) {
    switch (severity) {
        case Severity::Note: return QStyle::SP_MessageBoxInformation;
        case Severity::Warning: return QStyle::SP_MessageBoxWarning;
        case Severity::Error: return QStyle::SP_MessageBoxCritical;
    }
    return QStyle::SP_MessageBoxInformation;
}

}  // namespace

LogPanel::LogPanel(Session& session, QWidget* parent) : QListWidget(parent), session_(session) {
    setWordWrap(true);
    setSelectionMode(ExtendedSelection);
    session_.observe([this](Change change) {
        if (change == Change::Log) catchUp();
    });
    catchUp();
}

void LogPanel::catchUp() {
    const auto& log = session_.place.log();
    for (auto i = static_cast<std::size_t>(count()); i < log.size(); ++i)
        addItem(new QListWidgetItem(style()->standardIcon(iconOf(log[i].severity)), qt(log[i].text)));
    scrollToBottom();
}

}  // namespace luxdeck::gui
