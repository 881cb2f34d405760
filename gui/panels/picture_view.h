#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <array>

namespace luxdeck::gui {

/// A picture to look at: fits the widget or is zoomed by the wheel and dragged; a second one is seen right of a divider
/// that is dragged over them.
class PictureView : public QWidget {
    Q_OBJECT

public:
    explicit PictureView(QWidget* parent = nullptr);

    /// picture  null: nothing on that side. It may be coarser than the size that both are shown at
    void setPicture(int side, const QImage& picture, const QString& name);
    /// In pixels: what a zoom of 1 shows.
    void setNominalSize(QSize size);
    [[nodiscard]] bool compares() const { return !pictures_[0].isNull() && !pictures_[1].isNull(); }
    [[nodiscard]] bool fits() const { return fits_; }
    /// Screen dots for a pixel.
    [[nodiscard]] double zoom() const { return scale_ * devicePixelRatioF(); }
    /// Where the divider is, 0 left .. 1 right.
    [[nodiscard]] double divider() const { return divider_; }
    void setDivider(double at);

    [[nodiscard]] QSize sizeHint() const override { return {720, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }

public slots:
    void fit();
    /// One dot of the screen for each pixel, about the middle of what is seen.
    void oneToOne();

signals:
    /// The cursor is over this place of the picture on that side, 0..1 from its top left.
    void hovered(int side, QPointF place);
    void left();
    void zoomChanged();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { None, Pan, Divider };
    void zoomTo(double scale, QPointF about);
    void place();
    [[nodiscard]] QRectF target() const;
    [[nodiscard]] double dividerX() const;
    [[nodiscard]] bool onDivider(QPointF at) const;
    void drawSide(QPainter& painter, int side);
    void drawDivider(QPainter& painter);
    void drawName(QPainter& painter, int side);
    void tellHover(QPointF at);

    std::array<QImage, 2> pictures_;
    std::array<QPixmap, 2> scaled_;  // for the present zoom, while the whole is not larger than the picture
    std::array<QString, 2> names_;
    QSize nominal_{1, 1};
    bool fits_ = true;
    double scale_ = 1;               // widget units for a pixel
    QPointF corner_;                 // of the picture in the widget
    double divider_ = 0.5;
    Drag drag_ = Drag::None;
    QPointF dragged_;
};

}  // namespace luxdeck::gui
