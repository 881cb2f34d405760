#pragma once

#include "analysis/compare/comparison.h"
#include "gui/session/comparing.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace luxdeck::gui {

/// Error against run time of every algorithm on one subject, as the report draws it, in the window's colours. A run under the
/// cursor tells its figures; a click picks it.
class ErrorPlot : public QWidget {
    Q_OBJECT

public:
    explicit ErrorPlot(QWidget* parent = nullptr);
    void show(std::shared_ptr<const Comparison> comparison, const std::string& subject);
    void pick(const RunKey& run);
    /// Where a run is drawn; none: it is not.
    [[nodiscard]] std::optional<QPointF> placeOf(const RunKey& run) const;

    [[nodiscard]] QSize sizeHint() const override { return {640, 380}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {420, 240}; }

signals:
    void picked(const RunKey& run);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] const ComparedReference* reference() const;
    [[nodiscard]] const ComparedRun* under(QPointF at) const;
    [[nodiscard]] QRectF areaMm() const;
    [[nodiscard]] double dotsPerMm() const;

    std::shared_ptr<const Comparison> comparison_;
    std::string subject_;
    RunKey picked_;
};

}  // namespace luxdeck::gui
