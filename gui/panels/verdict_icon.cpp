#include "gui/panels/verdict_icon.h"

#include "analysis/report/canvas.h"

#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>

#include <algorithm>

namespace luxdeck::gui {

namespace {

QIcon iconOf(const QPixmap& picture) {
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);  // else styles tint it in selected rows: its colour has a meaning
    return icon;
}

}  // namespace

QIcon verdictIcon(Verdict verdict) {
    if (verdict == Verdict::None) return {};
    const QString key = QStringLiteral("luxdeck verdict %1").arg(static_cast<int>(verdict));
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return iconOf(picture);
    constexpr int kSize = 32;
    picture = QPixmap(kSize, kSize);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    report::Canvas canvas(painter, 1, {});
    canvas.verdictSymbol(kSize / 2.0, kSize / 2.0, 0.8 * kSize, verdict);
    painter.end();
    QPixmapCache::insert(key, picture);
    return iconOf(picture);
}

Verdict worstVerdict(const GridResult& grid) {
    const Verdict all[] = {grid.mean.verdict, grid.minimum.verdict, grid.uniformity.verdict};
    for (const auto verdict : {Verdict::NotMet, Verdict::Undecided, Verdict::Met})
        if (std::find(std::begin(all), std::end(all), verdict) != std::end(all)) return verdict;
    return Verdict::None;
}

}  // namespace luxdeck::gui
