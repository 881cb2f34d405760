#include "gui/app/shortcuts_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace luxdeck::gui {

namespace {

/// What the views themselves answer to, beside the menus' commands.
struct ViewKey {
    const char *keys, *what;
};
const ViewKey kViewKeys[] = {
    {QT_TR_NOOP("Left click"), QT_TR_NOOP("Select what is under the pointer")},
    {QT_TR_NOOP("Left drag on a handle"), QT_TR_NOOP("Move or turn the selected luminaire or furniture (Ctrl: without snapping)")},
    {QT_TR_NOOP("F, Home"), QT_TR_NOOP("Fit all, from a corner")},
    {QT_TR_NOOP("7, 1, 3"), QT_TR_NOOP("From above, from the south, from the east")},
    {QT_TR_NOOP("L"), QT_TR_NOOP("The next named view")},
    {QT_TR_NOOP("Left or middle drag"), QT_TR_NOOP("Orbit about the point under the pointer (CAD navigation)")},
    {QT_TR_NOOP("Right drag, Shift+drag"), QT_TR_NOOP("Pan (CAD navigation)")},
    {QT_TR_NOOP("Wheel"), QT_TR_NOOP("Zoom to the pointer; pace of walking (walk navigation)")},
    {QT_TR_NOOP("W A S D or arrows, Q E"), QT_TR_NOOP("Walk, down and up; drag to look around; Shift: faster (walk navigation)")},
    {QT_TR_NOOP("Left, right button held"), QT_TR_NOOP("Nearer to what is under the pointer, further away (holodeck navigation)")},
    {QT_TR_NOOP("Middle drag, Shift+drag"), QT_TR_NOOP("Turn about the point under the pointer, look around (holodeck navigation)")},
};

QTreeWidgetItem* section(QTreeWidget* list, const QString& name) {
    auto* item = new QTreeWidgetItem(list, {name});
    auto font = item->font(0);
    font.setBold(true);
    item->setFont(0, font);
    item->setFirstColumnSpanned(true);
    return item;
}

void filter(QTreeWidget* list, const QString& text) {
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        auto* group = list->topLevelItem(i);
        int shown = 0;
        for (int k = 0; k < group->childCount(); ++k) {
            const auto* row = group->child(k);
            const bool fits = row->text(0).contains(text, Qt::CaseInsensitive) || row->text(1).contains(text, Qt::CaseInsensitive);
            group->child(k)->setHidden(!fits);
            shown += fits ? 1 : 0;
        }
        group->setHidden(shown == 0);
    }
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const std::vector<QAction*>& commands, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("shortcutsDialog"));
    setWindowTitle(tr("Keyboard shortcuts"));
    resize(560, 640);
    auto* search = new QLineEdit(this);
    search->setPlaceholderText(tr("Search"));
    search->setClearButtonEnabled(true);
    auto* list = new QTreeWidget(this);
    list->setColumnCount(2);
    list->setHeaderHidden(true);
    list->setRootIsDecorated(false);
    list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    QString menu;
    QTreeWidgetItem* group = nullptr;
    for (const auto* action : commands) {
        if (action->shortcut().isEmpty()) continue;
        const auto name = action->property("menu").toString();
        if (group == nullptr || name != menu) group = section(list, menu = name);
        new QTreeWidgetItem(group, {action->text().remove(QLatin1Char('&')), action->shortcut().toString(QKeySequence::NativeText)});
    }
    group = section(list, tr("In the views"));
    for (const auto& key : kViewKeys) new QTreeWidgetItem(group, {tr(key.what), tr(key.keys)});
    list->expandAll();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(search);
    layout->addWidget(list);
    layout->addWidget(buttons);
    connect(search, &QLineEdit::textChanged, this, [list](const QString& text) { filter(list, text); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

}  // namespace luxdeck::gui
