#pragma once

#include "gui/panels/render_controls.h"
#include "gui/session/session.h"

#include <QPointF>
#include <QWidget>

#include <array>
#include <cstdint>
#include <filesystem>

class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace luxdeck::gui {

class LookControls;
class PictureView;

/// Pictures of the project: rendered while one watches, tone mapped or in false colour, read under the cursor, compared
/// by a divider, saved.
///
/// In the window: `new PicturePanel(session)` as a page of its own (it wants 800 x 500 or more); setCamera() makes the 3D
/// view's camera a view to render; render() is what a menu calls.
class PicturePanel : public QWidget {
    Q_OBJECT

public:
    explicit PicturePanel(Session& session, QWidget* parent = nullptr);
    void setCamera(RenderControls::Camera camera);

public slots:
    /// As the button does.
    void render();
    /// Asks for a name (.exr, .hdr or .png) and saves there.
    void saveAs();

signals:
    /// Something could not be done; the window says it.
    void failed(const QString& why);

private:
    void refresh();
    void fillChoice(QComboBox* choice, std::size_t side);
    void showSide(std::size_t side);
    void readUnder(int side, QPointF place);
    void describe();

    Session& session_;
    QStackedWidget* stage_;
    PictureView* view_;
    QComboBox *picture_, *other_;
    QToolButton *fit_, *oneToOne_;
    QPushButton* save_;
    QLabel *about_, *under_;
    RenderControls* render_;
    LookControls* look_;
    std::array<const Developed*, 2> seen_{};  // what the view shows
    std::array<QString, 2> names_;
};

}  // namespace luxdeck::gui
