#include "gui/app/job_bar.h"

#include "gui/panels/job_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace luxdeck::gui {

struct JobBar::Row : QWidget {
    Row(Session& session, std::uint64_t job, QWidget* parent)
        : QWidget(parent), id(job), text(new QLabel(this)), bar(new QProgressBar(this)), stop(new QToolButton(this)) {
        bar->setTextVisible(false);
        bar->setFixedWidth(110);
        stop->setText(QObject::tr("Stop"));
        stop->setObjectName(QStringLiteral("stopJob"));
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(6, 0, 6, 0);
        row->addWidget(text);
        row->addWidget(bar);
        row->addWidget(stop);
        QObject::connect(stop, &QToolButton::clicked, this, [&session, job] { session.place.jobs.cancel(job); });
    }

    std::uint64_t id;
    QLabel* text;
    QProgressBar* bar;
    QToolButton* stop;
};

JobBar::JobBar(Session& session, QWidget* parent) : QWidget(parent), session_(session), layout_(new QHBoxLayout(this)) {
    layout_->setContentsMargins(0, 0, 0, 0);
    session_.observe([this](Change change) {
        if (change == Change::Jobs) refresh();
    });
    auto* clock = new QTimer(this);  // seconds go on between what jobs say
    connect(clock, &QTimer::timeout, this, [this] {
        if (!session_.place.jobs.idle()) refresh();
    });
    clock->start(500);
}

void JobBar::refresh() {
    auto states = session_.place.jobs.states();
    // Over before one could read its name, many times a second.
    states.erase(std::remove_if(states.begin(), states.end(), [](const auto& job) { return job.kind == JobKind::Look; }), states.end());
    const auto gone = [&](const Row* row) { return std::none_of(states.begin(), states.end(), [&](const auto& job) { return job.id == row->id; }); };
    for (auto* row : rows_)
        if (gone(row)) row->deleteLater();
    rows_.erase(std::remove_if(rows_.begin(), rows_.end(), gone), rows_.end());
    for (const auto& job : states) {
        auto at = std::find_if(rows_.begin(), rows_.end(), [&](const Row* row) { return row->id == job.id; });
        if (at == rows_.end()) {
            at = rows_.insert(rows_.end(), new Row(session_, job.id, this));
            layout_->addWidget(*at);
        }
        (*at)->text->setText(jobText(job));
        showProgress(*(*at)->bar, job);
        (*at)->stop->setEnabled(!job.cancelled);
    }
}

}  // namespace luxdeck::gui
