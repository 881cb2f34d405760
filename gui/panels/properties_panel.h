#pragma once

#include "gui/session/edits.h"
#include "gui/session/session.h"

#include <QScrollArea>

#include <string>

class QLabel;
class QVBoxLayout;

namespace luxdeck::gui {

class PropertyForm;

/// What is selected, with fields that change it: a luminaire, its type, a calculation surface, a view, an object, a material,
/// a volume, or the project's cover. Put it into a dock: it follows session.selection() by itself.
class PropertiesPanel : public QScrollArea {
    Q_OBJECT

public:
    explicit PropertiesPanel(Session& session, QWidget* parent = nullptr);

    /// Gives a luminaire type another photometric file: the button's work, and that of a file dropped on the panel's type.
    void exchange(std::size_t type, const std::string& file);

private:
    void giveRoom();
    void resizeEvent(QResizeEvent* event) override;
    void rebuild();
    void soon();
    PropertyForm* form(const QString& title, const QString& kind);
    PropertyForm* projectForm(const Project& project);
    PropertyForm* luminaireForm(const Project& project, std::size_t index);
    PropertyForm* typeForm(const Project& project, std::size_t index);
    PropertyForm* gridForm(const Project& project, std::size_t index);
    PropertyForm* viewForm(const Project& project, std::size_t index);
    PropertyForm* objectForm(const Project& project, std::size_t index);
    PropertyForm* materialForm(const Project& project, std::size_t index);
    PropertyForm* volumeForm(std::size_t index);
    PropertyForm* chosenForm();
    void addFurnishing(PropertyForm& form, const std::string& object);
    void addResults(PropertyForm& form, const std::string& grid);

    void change(const QString& what, const edits::Edit& edit);
    void say(const QString& message);

    Session& session_;
    QVBoxLayout* layout_;
    QLabel* message_;
    QWidget* shown_ = nullptr;
    bool waiting_ = false;       // to be rebuilt when control returns
    std::size_t logSeen_ = 0;
};

}  // namespace luxdeck::gui
