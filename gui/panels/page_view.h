#pragma once

#include <QImage>
#include <QScrollArea>

namespace luxdeck::gui {

/// A page of paper, as wide as there is room or zoomed. What it shows may be coarse: it says at which resolution it would
/// be sharp.
class PageView : public QScrollArea {
    Q_OBJECT

public:
    explicit PageView(QWidget* parent = nullptr);

    /// picture  in any resolution; null: an empty page
    void setPage(const QImage& picture);
    /// Screen dots for a millimetre of paper.
    [[nodiscard]] double dotsPerMm() const;
    [[nodiscard]] bool fits() const { return fits_; }

public slots:
    void fit();
    void zoomIn();
    void zoomOut();

signals:
    /// The page is wanted in another resolution.
    void resolutionChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    class Sheet;
    void zoomBy(double factor);
    void place();

    Sheet* sheet_;
    bool fits_ = true;
    double unitsPerMm_ = 3;
};

}  // namespace luxdeck::gui
