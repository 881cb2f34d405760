#pragma once

#include "gui/session/session.h"

#include <QWidget>

#include <functional>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace luxdeck::gui {

/// What is rendered: view, size, algorithm, how exact; and how far it has come.
class RenderControls : public QWidget {
    Q_OBJECT

public:
    /// What the 3D view's camera sees now; none: no view is open.
    using Camera = std::function<std::optional<View>()>;

    explicit RenderControls(Session& session, QWidget* parent = nullptr);
    /// Offers "What the 3D view shows" beside the project's views.
    void setCamera(Camera camera);

public slots:
    void start();

signals:
    void failed(const QString& why);

private:
    void fillViews();
    void takeSize();
    void refresh();
    [[nodiscard]] std::optional<View> view() const;

    Session& session_;
    Camera camera_;
    QComboBox *view_, *algorithm_;
    QLabel *summary_, *state_;
    QSpinBox *width_, *height_;
    QDoubleSpinBox *target_, *time_;
    QPushButton *render_, *stop_;
    QProgressBar* bar_;
};

}  // namespace luxdeck::gui
