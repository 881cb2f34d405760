#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <string>
#include <vector>

class QCheckBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace luxdeck::gui {

/// Switches and dimmers, one for each luminaire type. While a dimmer moves, the results follow at once where the light of
/// each luminaire is known apart; letting it go is the edit.
class LightingPanel : public QWidget {
    Q_OBJECT

public:
    explicit LightingPanel(Session& session, QWidget* parent = nullptr);

private:
    struct Row {
        QCheckBox* on;
        QSlider* dimmer;
        QLabel* percent;
    };

    void rebuild();
    void showDimmings();
    void preview(std::size_t type, double dimming);
    void commit(std::size_t type, double dimming);
    void explain();

    Session& session_;
    QGridLayout* grid_;
    QLabel* note_;
    std::vector<Row> rows_;
    std::vector<std::string> types_;  // ids of the rows, to see when they change
    bool following_ = false;
};

}  // namespace luxdeck::gui
