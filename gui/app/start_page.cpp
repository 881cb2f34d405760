#include "gui/app/start_page.h"

#include "gui/app/sample_projects.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

namespace luxdeck::gui {

namespace {

/// A sample as a picture with its name beneath; the whole of it is a button.
class SampleCard : public QPushButton {
public:
    SampleCard(const SampleProject& sample, QWidget* parent) : QPushButton(parent), sample_(sample), picture_(sample.picture) {
        setObjectName(QStringLiteral("sample_") + QFileInfo(sample.file).dir().dirName());
        setAccessibleName(sample.name);
        setToolTip(sample.file);
        setCursor(Qt::PointingHandCursor);
        setMinimumSize(220, 230);
        setMaximumSize(380, 350);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    }

    [[nodiscard]] QSize sizeHint() const override { return {320, 300}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
        const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
        QPainterPath round;
        round.addRoundedRect(frame, 8, 8);
        painter.fillPath(round, palette().color(QPalette::Base));
        painter.setClipPath(round);
        const double textHeight = 4.4 * fontMetrics().height();
        const QRectF top(frame.left(), frame.top(), frame.width(), frame.height() - textHeight);
        if (!picture_.isNull()) {
            const QSizeF shown = QSizeF(picture_.size()).scaled(top.size(), Qt::KeepAspectRatioByExpanding);
            painter.drawPixmap(QRectF(top.center() - QPointF(shown.width() / 2, shown.height() / 2), shown).toRect(), picture_);
            painter.fillRect(QRectF(frame.left(), top.bottom(), frame.width(), textHeight), palette().color(QPalette::Base));
        }
        const QRectF text = QRectF(frame.left() + 12, top.bottom() + 8, frame.width() - 24, textHeight - 12);
        auto bold = font();
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(text, Qt::AlignTop | Qt::AlignLeft, sample_.name);
        painter.setFont(font());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(text.adjusted(0, 1.25 * fontMetrics().height(), 0, 0), Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap, sample_.description);
        painter.setClipping(false);
        const bool near = underMouse() || hasFocus();
        painter.setPen(QPen(palette().color(near ? QPalette::Highlight : QPalette::Mid), near ? 2 : 1));
        painter.drawPath(round);
    }

private:
    SampleProject sample_;
    QPixmap picture_;
};

QLabel* heading(const QString& text, double scale, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    auto font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    return label;
}

}  // namespace

StartPage::StartPage(Memory& memory, QWidget* parent) : QWidget(parent), memory_(memory), recent_(new QListWidget(this)) {
    setObjectName(QStringLiteral("startPage"));
    setAutoFillBackground(true);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(48, 36, 48, 36);
    outer->setSpacing(14);
    outer->addWidget(heading(tr("Luxdeck"), 2.6, this));
    auto* motto = new QLabel(tr("Lighting design in which every number carries its error and its run time."), this);
    motto->setForegroundRole(QPalette::PlaceholderText);
    outer->addWidget(motto);
    auto* buttons = new QHBoxLayout;
    auto* open = new QPushButton(tr("Open a project…"), this);
    open->setObjectName(QStringLiteral("startOpen"));
    open->setDefault(true);
    auto* begin = new QPushButton(tr("New project from geometry…"), this);
    begin->setObjectName(QStringLiteral("startNew"));
    buttons->addWidget(open);
    buttons->addWidget(begin);
    buttons->addStretch(1);
    outer->addSpacing(6);
    outer->addLayout(buttons);
    outer->addSpacing(14);
    outer->addWidget(heading(tr("Sample projects"), 1.25, this));
    auto* samples = new QHBoxLayout;
    samples->setSpacing(18);
    for (const auto& sample : sampleProjects()) {
        auto* card = new SampleCard(sample, this);
        connect(card, &QPushButton::clicked, this, [this, file = sample.file] { emit chosen(file); });
        samples->addWidget(card, 1);
    }
    samples->addStretch(0);
    outer->addLayout(samples, 3);
    outer->addSpacing(10);
    outer->addWidget(heading(tr("Recent projects"), 1.25, this));
    recent_->setObjectName(QStringLiteral("recentProjects"));
    recent_->setFrameShape(QFrame::NoFrame);
    recent_->viewport()->setAutoFillBackground(false);
    outer->addWidget(recent_, 2);
    connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
    connect(begin, &QPushButton::clicked, this, &StartPage::newWanted);
    connect(recent_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { emit chosen(item->data(Qt::UserRole).toString()); });
    connect(recent_, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        if (item->data(Qt::UserRole).isValid()) emit chosen(item->data(Qt::UserRole).toString());
    });
    refresh();
}

void StartPage::refresh() {
    recent_->clear();
    for (const auto& file : memory_.recent()) {
        const QFileInfo info(file);
        auto* item = new QListWidgetItem(info.exists() ? file : tr("%1 (not there any more)").arg(file), recent_);
        item->setData(Qt::UserRole, file);
        if (!info.exists()) item->setFlags(Qt::NoItemFlags);
    }
    if (recent_->count() == 0) {
        auto* item = new QListWidgetItem(tr("Projects that you open are listed here."), recent_);
        item->setFlags(Qt::NoItemFlags);
    }
}

}  // namespace luxdeck::gui
