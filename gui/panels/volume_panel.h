#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace luxdeck::gui {

class VolumeForm;
class VolumeShow;

/// Irradiance volumes: building them, those that there are, and what a view shows of one. Fits a dock of 320 pixels; scrolls
/// nothing by itself.
class VolumePanel : public QWidget {
    Q_OBJECT

public:
    explicit VolumePanel(Session& session, QWidget* parent = nullptr);

    /// The view whose settings are changed here: the active one.
    void setView(std::size_t index);

public slots:
    /// Builds with what the form says.
    void build();
    /// Asks for a .vtu file.
    void openFile();

private:
    QWidget* volumes();
    void saveFile();
    void listVolumes();
    void refresh();
    [[nodiscard]] int chosen() const;

    Session& session_;
    VolumeForm* form_;
    VolumeShow* show_;
    QLabel* empty_;
    QTreeWidget* list_;
    QPushButton *save_, *remove_;
    bool following_ = false;
};

}  // namespace luxdeck::gui
