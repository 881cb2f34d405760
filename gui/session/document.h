#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// The text of a project file, and every state it went through: undo and redo are other states of it. What the user wrote by
/// hand (comments, order) stays.
class Document {
public:
    Document() = default;
    /// errors  FileNotFound, Parse (too large), OutOfResources
    static Result<Document> open(const std::filesystem::path& file);
    /// A new text, which has never been saved.
    Document(std::filesystem::path file, std::string text);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const std::string& text() const { return states_[at_].text; }
    /// The text differs from what is on disk.
    [[nodiscard]] bool modified() const { return at_ != saved_; }

    /// A new state after the present one; what had been undone is gone. The same text again changes nothing.
    ///
    /// what  for the menu: "Move Desk 03"
    void change(std::string what, std::string text);
    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ + 1 < states_.size(); }
    /// Of the edit that undo() would take back, redo() do again.
    [[nodiscard]] const std::string& undoName() const { return states_[at_].what; }
    [[nodiscard]] const std::string& redoName() const { return states_[at_ + 1].what; }
    void undo();
    void redo();
    /// Takes back the last change as if it had never been: an edit that turned out impossible.
    void withdraw();

    /// Whole or not at all. errors  OutOfResources (disk), InvalidArgument (folder): the file is as it was
    Result<void> save();
    Result<void> saveAs(const std::filesystem::path& file);

    /// Where the text is kept while it is not saved: beside the file, ".NAME.autosave".
    [[nodiscard]] std::filesystem::path autosaveFile() const;
    /// Keeps a modified text there; removes the file when there is nothing to keep. errors  as save()
    Result<void> autosave() const;
    /// What a session that ended without closing left; empty: nothing, or the same as the file.
    [[nodiscard]] std::string recoverable() const;

private:
    struct State {
        std::string what, text;
    };
    static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

    std::filesystem::path file_;
    std::vector<State> states_{State{}};
    std::size_t at_ = 0;
    std::size_t saved_ = 0;  // state that is on disk; kNever: none
};

}  // namespace luxdeck::gui
