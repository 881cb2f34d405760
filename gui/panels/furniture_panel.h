#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <string>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace luxdeck::gui {

/// Furniture that is moved while its light follows: taken in hand here or in the view, placed by handles or by numbers; its
/// verdict at once, the room's change when it is asked for.
class FurniturePanel : public QWidget {
    Q_OBJECT

public:
    explicit FurniturePanel(Session& session, QWidget* parent = nullptr);

public slots:
    /// Takes the selected object in hand, else the one that is named here.
    void begin();

private:
    QWidget* chooser();
    QWidget* hand();
    void fillObjects();
    void refresh();
    void refreshHand();
    void refreshRoom();
    void moveByNumbers();
    void require();

    Session& session_;
    bool following_ = false;
    std::string inHand_;
    QComboBox* object_;
    QPushButton *begin_, *leave_, *back_, *estimate_, *solve_;
    QLabel *state_, *verdict_, *from_, *roomState_;
    QWidget* hand_;
    QDoubleSpinBox *x_, *y_, *turn_, *required_, *limit_;
    QTableWidget* room_;
};

}  // namespace luxdeck::gui
