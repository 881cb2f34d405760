#pragma once

#include "gui/session/session.h"

#include <QWidget>

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;
class QStackedWidget;

namespace luxdeck::gui {

class ColourBar;
class ToneHistogram;

/// How the pictures are made visible: tone mapping with each of its parts, or false colour; and what was decided.
class LookControls : public QWidget {
    Q_OBJECT

public:
    explicit LookControls(Session& session, QWidget* parent = nullptr);

    /// As the widgets say.
    [[nodiscard]] Look look() const;
    /// Shows what was decided on the picture that is seen.
    void refresh();
    /// A luminance under the cursor [cd/m²]; 0: none.
    void mark(double cdM2);

private:
    QWidget* makeTonePage();
    QWidget* makeColourPage();
    void fillDisplays();
    void fillOcioViews();
    void changed();
    void tellDecisions(const tonemap::ToneMapRecord& record);

    Session& session_;
    QButtonGroup* kind_;
    QStackedWidget* pages_;
    QComboBox *operator_, *ocioDisplay_, *ocioView_, *map_;
    QFormLayout* toneForm_ = nullptr;
    QWidget* exposure_;
    QSlider* exposureSlider_;
    QDoubleSpinBox *exposureValue_, *white_, *black_, *low_, *high_;
    struct EffectRow {
        QComboBox* choice;
        QLabel* why;
    };
    EffectRow effects_[3];
    QCheckBox *whiteBalance_, *logarithmic_, *automatic_, *isolines_;
    QLabel* adaptation_;
    ColourBar* bar_;
    ToneHistogram* histogram_;
};

}  // namespace luxdeck::gui
