#include "gui/panels/project_tree.h"

#include "gui/panels/text.h"
#include "gui/panels/verdict_icon.h"

#include <QHeaderView>
#include <QTreeWidgetItemIterator>

#include <map>

namespace luxdeck::gui {

namespace {

constexpr int kThing = Qt::UserRole, kIndex = Qt::UserRole + 1;

QTreeWidgetItem* entry(QTreeWidgetItem* parent, const QString& text, Thing thing, std::size_t index, const QString& detail = {}) {
    auto* item = new QTreeWidgetItem(parent, {text, detail});
    item->setData(0, kThing, static_cast<int>(thing));
    item->setData(0, kIndex, static_cast<qulonglong>(index));
    item->setToolTip(0, detail.isEmpty() ? text : text + QStringLiteral("\n") + detail);
    return item;
}

QTreeWidgetItem* group(QTreeWidget* tree, const QString& text, std::size_t count) {
    auto* item = new QTreeWidgetItem(tree, {text, QString::number(count)});
    auto font = item->font(0);
    font.setBold(true);
    item->setFont(0, font);
    item->setFlags(Qt::ItemIsEnabled);
    return item;
}

Selection selectionOf(const QTreeWidgetItem* item) {
    return {static_cast<Thing>(item->data(0, kThing).toInt()), static_cast<std::size_t>(item->data(0, kIndex).toULongLong())};
}

void addObjects(QTreeWidget* tree, const Scene& scene) {
    std::size_t movable = 0;
    for (const auto& object : scene.objects) movable += object.movable ? 1 : 0;
    if (movable > 0) {
        auto* parent = group(tree, QObject::tr("Furniture"), movable);
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (scene.objects[i].movable) entry(parent, qt(scene.objects[i].name), Thing::Object, i);
    }
    if (scene.objects.size() == movable) return;
    auto* parent = group(tree, QObject::tr("Geometry"), scene.objects.size() - movable);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (!scene.objects[i].movable) entry(parent, qt(scene.objects[i].name), Thing::Object, i);
}

void addLuminaires(QTreeWidget* tree, const Scene& scene) {
    if (scene.luminaireTypes.empty()) return;
    auto* parent = group(tree, QObject::tr("Luminaires"), scene.luminaires.size());
    std::vector<QTreeWidgetItem*> types;
    for (std::size_t i = 0; i < scene.luminaireTypes.size(); ++i) {
        const auto& type = scene.luminaireTypes[i];
        types.push_back(entry(parent, qt(type.description.empty() ? type.id : type.id + "  " + type.description), Thing::LuminaireType, i));
    }
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const auto& luminaire = scene.luminaires[i];
        const auto dimming = luminaire.dimming >= 1 ? QString() : luminaire.dimming <= 0 ? QObject::tr("off") : QObject::tr("%1 %").arg(100 * luminaire.dimming, 0, 'g', 3);
        entry(types[luminaire.type], qt(luminaire.name), Thing::Luminaire, i, dimming);
    }
    for (auto* item : types) item->setText(1, QString::number(item->childCount()));
}

}  // namespace

ProjectTree::ProjectTree(Session& session, QWidget* parent) : QTreeWidget(parent), session_(session) {
    setObjectName(QStringLiteral("projectTree"));
    setAccessibleName(tr("Project"));
    setColumnCount(2);
    setHeaderHidden(true);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    setUniformRowHeights(true);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &ProjectTree::pick);
    connect(this, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        if (item->data(0, kThing).isValid()) emit opened(selectionOf(item));
    });
    session_.observe([this](Change change) {
        if (change == Change::Project || change == Change::Volumes) rebuild();
        if (change == Change::Solve) showVerdicts();
        if (change == Change::Selection) showSelection();
    });
    rebuild();
}

void ProjectTree::rebuild() {
    std::map<QString, bool> closed;
    for (int i = 0; i < topLevelItemCount(); ++i) closed[topLevelItem(i)->text(0)] = !topLevelItem(i)->isExpanded();
    following_ = true;
    clear();
    if (const auto loaded = session_.project()) {
        const auto& project = loaded->project;
        auto* root = entry(nullptr, qt(project.info.name), Thing::Project, 0);
        auto font = root->font(0);
        font.setBold(true);
        root->setFont(0, font);
        addTopLevelItem(root);
        addLuminaires(this, project.scene);
        if (!project.grids.empty()) {
            auto* parent = group(this, tr("Calculation surfaces"), project.grids.size());
            for (std::size_t i = 0; i < project.grids.size(); ++i) entry(parent, qt(project.grids[i].name), Thing::Grid, i);
        }
        if (!project.views.empty()) {
            auto* parent = group(this, tr("Views"), project.views.size());
            for (std::size_t i = 0; i < project.views.size(); ++i) entry(parent, qt(project.views[i].name), Thing::View, i);
        }
        const auto& volumes = session_.volumes.all();
        if (!volumes.empty()) {
            auto* parent = group(this, tr("Volumes"), volumes.size());
            for (std::size_t i = 0; i < volumes.size(); ++i) entry(parent, qt(volumes[i].name), Thing::Volume, i, volumes[i].current ? QString() : tr("old"));
        }
        addObjects(this, project.scene);
    }
    for (int i = 0; i < topLevelItemCount(); ++i) {
        const auto name = topLevelItem(i)->text(0);
        const bool many = topLevelItem(i)->childCount() > 30;
        topLevelItem(i)->setExpanded(closed.count(name) > 0 ? !closed[name] : !many);
    }
    following_ = false;
    showVerdicts();
    showSelection();
}

void ProjectTree::showVerdicts() {
    const auto result = session_.solving.result();
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it) {
        if (selectionOf(*it).thing != Thing::Grid || !(*it)->data(0, kThing).isValid()) continue;
        const auto index = selectionOf(*it).index;
        const bool known = result != nullptr && index < result->grids.size();
        (*it)->setIcon(1, known ? verdictIcon(worstVerdict(result->grids[index])) : QIcon());
    }
}

void ProjectTree::showSelection() {
    if (following_) return;
    following_ = true;
    clearSelection();
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it)
        if ((*it)->data(0, kThing).isValid() && selectionOf(*it) == session_.selection() && session_.selection().thing != Thing::None) {
            setCurrentItem(*it);
            scrollToItem(*it);
            break;
        }
    following_ = false;
}

void ProjectTree::pick() {
    if (following_) return;
    const auto picked = selectedItems();
    if (picked.isEmpty() || !picked.front()->data(0, kThing).isValid()) return;
    following_ = true;
    session_.select(selectionOf(picked.front()));
    following_ = false;
}

}  // namespace luxdeck::gui
