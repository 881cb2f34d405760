#include "gui/panels/run_picture_box.h"

#include "gui/panels/colour_bar.h"
#include "gui/panels/qimage_of.h"
#include "gui/panels/text.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace luxdeck::gui {

namespace {

constexpr int kMostHeight = 190;

/// Keeps the picture's shape at any width, and leaves room for the next one.
class Fitted : public QWidget {
public:
    explicit Fitted(const QImage& image) : image_(image) {
        auto policy = sizePolicy();
        policy.setHeightForWidth(true);
        policy.setHorizontalPolicy(QSizePolicy::Expanding);
        setSizePolicy(policy);
    }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override { return image_.isNull() ? 0 : std::min(kMostHeight, width * image_.height() / image_.width()); }
    [[nodiscard]] QSize sizeHint() const override { return {240, heightForWidth(240)}; }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        const auto size = image_.size().scaled(this->size(), Qt::KeepAspectRatio);
        painter.drawImage(QRect(QPoint((width() - size.width()) / 2, 0), size), image_);
    }

private:
    QImage image_;
};

}  // namespace

RunPictureBox::RunPictureBox(const RunPicture& picture, QWidget* parent) : QWidget(parent) {
    auto* title = new QLabel(qt(picture.title), this);
    title->setForegroundRole(QPalette::PlaceholderText);
    auto* image = new Fitted(qimageOf(picture.image));
    image->setAccessibleName(title->text());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->setSpacing(3);
    layout->addWidget(title);
    layout->addWidget(image);
    if (picture.unit.empty()) return;
    auto* bar = new ColourBar(this);
    bar->show(picture.map, picture.range, false, qt(picture.unit == "%" ? "error in %: blue too dark, red too bright" : picture.unit));
    layout->addWidget(bar);
}

}  // namespace luxdeck::gui
