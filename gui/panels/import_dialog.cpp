#include "gui/panels/import_dialog.h"

#include "analysis/report/photometric_sheet.h"
#include "gui/panels/text.h"
#include "gui/session/edits.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSvgRenderer>
#include <QVBoxLayout>

namespace luxdeck::gui {

namespace {

constexpr int kSheetWidth = 720;

QLabel* text(const QString& words, QWidget* parent, const char* style = "") {
    auto* label = new QLabel(words, parent);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setStyleSheet(QString::fromLatin1(style));
    return label;
}

/// The A4 sheet of a luminaire: polar curve, planes, what was measured.
QLabel* sheet(const CheckedFile& checked, QWidget* parent) {
    const auto svg = photometricSheet(checked, SheetFormat::Svg);
    if (!svg) return nullptr;
    QSvgRenderer drawing(QByteArray::fromStdString(*svg));
    const double ratio = parent->devicePixelRatioF();
    QImage picture(QSize(kSheetWidth, static_cast<int>(kSheetWidth * drawing.defaultSize().height() / std::max(1.0, double(drawing.defaultSize().width())))) * ratio, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    drawing.render(&painter);
    painter.end();
    auto* label = new QLabel(parent);
    auto pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(ratio);
    label->setPixmap(pixmap);
    label->setAlignment(Qt::AlignTop);
    return label;
}

}  // namespace

ImportDialog::ImportDialog(Session& session, const std::vector<std::filesystem::path>& files, QWidget* parent)
    : QDialog(parent), session_(session), wait_(new QLabel(tr("Reading …"), this)) {
    setObjectName(QStringLiteral("importDialog"));
    setWindowTitle(tr("Import"));
    resize(800, 860);
    auto* content = new QWidget;
    cards_ = new QVBoxLayout(content);
    cards_->addWidget(wait_);
    cards_->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidget(content);
    area->setWidgetResizable(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    // The session outlives the dialog, and so would its observer: a shared flag tells it.
    const auto alive = std::make_shared<bool>(true);
    connect(this, &QObject::destroyed, [alive] { *alive = false; });
    session_.observe([this, alive](Change change) {
        if (*alive && change == Change::Import) showFound();
    });
    session_.importing.look(files, session_.display().units);
}

void ImportDialog::showFound() {
    const auto& found = session_.importing.found();
    wait_->setVisible(found.empty());
    for (; shown_ < found.size(); ++shown_) cards_->insertWidget(cards_->count() - 1, card(found[shown_]));
}

QWidget* ImportDialog::card(const ImportedFile& file) {
    auto* box = new QWidget(this);
    auto* words = new QVBoxLayout(box);
    words->addWidget(text(qt(file.file.filename().string()), box, "font-weight: 600; font-size: 12pt"));
    words->addWidget(text(qt(file.what), box));
    if (file.refused) {
        auto* why = text(tr("Cannot be used: %1").arg(qt(file.refused->text())), box, "border: none; border-left: 4px solid #c8202c; padding: 4px 8px");
        why->setObjectName(QStringLiteral("importRefused"));
        words->addWidget(why);
        words->addWidget(text(tr("Nothing was changed."), box));
        return box;
    }
    for (const auto& fact : file.facts) words->addWidget(text(qt(fact), box));
    for (const auto& repair : file.repairs) words->addWidget(text(tr("Put right: %1").arg(qt(repair)), box, "border: none; border-left: 4px solid #c47a00; padding: 2px 8px"));
    for (const auto& warning : file.warnings) words->addWidget(text(tr("Look at this: %1").arg(qt(warning)), box, "border: none; border-left: 4px solid #c47a00; padding: 2px 8px"));
    words->addSpacing(8);
    if (file.kind == ImportKind::Photometry) offerPhotometry(file, words);
    if (file.kind == ImportKind::Geometry) offerGeometry(file, words);
    if (file.kind == ImportKind::Volume) offerVolume(file, words);
    if (file.photometry)
        if (auto* drawing = sheet(*file.photometry, box)) words->addWidget(drawing);
    words->addStretch(1);
    return box;
}

void ImportDialog::done(const Result<void>& result, QWidget* button) {
    if (!result) return session_.place.complain(result.error());
    button->setEnabled(false);
}

std::string ImportDialog::takeIn(const std::filesystem::path& file) {
    const auto named = edits::photometryForProject(session_.document().file(), file);
    if (!named) {
        session_.place.complain(named.error());
        return {};
    }
    if (named->copied) session_.place.note(file.filename().string() + " was copied into the project: " + named->shown);
    return named->shown;
}

bool ImportDialog::edited(const std::string& what, const Session::Edit& edit) {
    const auto done = session_.edit(what, edit);
    if (!done) session_.place.complain(done.error());
    return static_cast<bool>(done);
}

bool ImportDialog::exchange(const std::filesystem::path& file, const std::string& type) {
    const auto shown = takeIn(file);
    return !shown.empty() && edited("Exchange photometry of " + type, edits::exchangePhotometry(type, shown));
}

bool ImportDialog::addType(const ImportedFile& file) {
    const auto shown = takeIn(file.file);
    return !shown.empty() && edited("Add luminaire type", edits::addLuminaireType(shown, file.file.stem().string()));
}

void ImportDialog::offerPhotometry(const ImportedFile& file, QVBoxLayout* into) {
    if (!session_.editable()) return;
    auto* add = new QPushButton(tr("Add as a luminaire type"), this);
    add->setObjectName(QStringLiteral("importAddType"));
    connect(add, &QPushButton::clicked, this, [this, add, file] {
        if (addType(file)) add->setEnabled(false);
    });
    into->addWidget(add);
    const auto& types = session_.project()->project.scene.luminaireTypes;
    if (types.empty()) return;
    auto* row = new QHBoxLayout;
    auto* choice = new QComboBox(this);
    choice->setObjectName(QStringLiteral("importType"));
    for (const auto& type : types) choice->addItem(qt(type.id + "  " + type.description), qt(type.id));
    const auto& selection = session_.selection();
    if (selection.thing == Thing::LuminaireType) choice->setCurrentIndex(static_cast<int>(selection.index));
    if (selection.thing == Thing::Luminaire) choice->setCurrentIndex(static_cast<int>(session_.project()->project.scene.luminaires[selection.index].type));
    auto* exchangeButton = new QPushButton(tr("Exchange the file of"), this);
    exchangeButton->setObjectName(QStringLiteral("importExchange"));
    connect(exchangeButton, &QPushButton::clicked, this, [this, exchangeButton, choice, path = file.file] {
        if (exchange(path, choice->currentData().toString().toStdString())) exchangeButton->setEnabled(false);
    });
    row->addWidget(exchangeButton);
    row->addWidget(choice, 1);
    into->addLayout(row);
}

void ImportDialog::offerGeometry(const ImportedFile& file, QVBoxLayout* into) {
    if (!session_.editable()) return;
    auto* unit = new QComboBox(this);
    for (const char* name : {"m", "cm", "mm", "in", "ft"}) unit->addItem(QString::fromLatin1(name));
    auto* up = new QComboBox(this);
    up->addItems({tr("y is up"), tr("z is up")});
    const bool ask = file.needsUnit;
    if (ask) {
        auto* row = new QHBoxLayout;
        row->addWidget(new QLabel(tr("Its numbers are in"), this));
        row->addWidget(unit);
        row->addWidget(up);
        row->addStretch(1);
        into->addLayout(row);
    } else {
        unit->hide();
        up->hide();
    }
    const auto modelUnit = [=] { return ask ? edits::ModelUnit{unit->currentText().toStdString(), up->currentIndex() == 0 ? "y" : "z"} : edits::ModelUnit{}; };
    auto* room = new QPushButton(tr("Add to the room"), this);
    auto* furniture = new QPushButton(tr("Add as furniture that can be moved"), this);
    room->setObjectName(QStringLiteral("importGeometry"));
    furniture->setObjectName(QStringLiteral("importFurniture"));
    const auto path = file.file;
    connect(room, &QPushButton::clicked, this, [=, this] {
        done(session_.edit("Add geometry", edits::addGeometry(edits::geometryForProject(session_.document().file(), path).shown, modelUnit())), room);
    });
    connect(furniture, &QPushButton::clicked, this, [=, this] {
        const auto& scene = session_.project()->project.scene;
        const auto box = scene.bounds();
        const Vec3d middle = box.isEmpty() ? Vec3d(0, 0, 0) : Vec3d(scene.toUser(box.center()).x, scene.toUser(box.center()).y, scene.toUser(box.min).z);
        done(session_.edit("Add furniture", edits::addFurniture(edits::geometryForProject(session_.document().file(), path).shown, modelUnit(), middle)), furniture);
    });
    auto* row = new QHBoxLayout;
    row->addWidget(room);
    row->addWidget(furniture);
    row->addStretch(1);
    into->addLayout(row);
}

void ImportDialog::offerVolume(const ImportedFile& file, QVBoxLayout* into) {
    auto* open = new QPushButton(tr("Show this volume"), this);
    open->setObjectName(QStringLiteral("importVolume"));
    connect(open, &QPushButton::clicked, this, [this, open, path = file.file] { done(session_.volumes.open(path), open); });
    into->addWidget(open);
}

}  // namespace luxdeck::gui
