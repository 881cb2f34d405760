#pragma once

#include "gui/session/session.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QVBoxLayout;

namespace luxdeck::gui {

/// What files that were dropped are, what the doctor found in them, and what is to be done with each. Nothing is changed
/// until a button is pressed.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// Looks at the files (session.importing) and shows what is found when it is there.
    ImportDialog(Session& session, const std::vector<std::filesystem::path>& files, QWidget* parent);

private:
    void showFound();
    QWidget* card(const ImportedFile& file);
    void offerPhotometry(const ImportedFile& file, QVBoxLayout* into);
    void offerGeometry(const ImportedFile& file, QVBoxLayout* into);
    void offerVolume(const ImportedFile& file, QVBoxLayout* into);
    /// As the project will name the file; empty: it cannot.
    std::string takeIn(const std::filesystem::path& file);
    bool edited(const std::string& what, const Session::Edit& edit);
    /// True: the edit was taken up. What hinders it is complained of.
    bool exchange(const std::filesystem::path& file, const std::string& type);
    bool addType(const ImportedFile& file);
    void done(const Result<void>& result, QWidget* button);

    Session& session_;
    QLabel* wait_;
    QVBoxLayout* cards_;
    std::size_t shown_ = 0;  // of what was found
};

}  // namespace luxdeck::gui
