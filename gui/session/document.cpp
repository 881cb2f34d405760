#include "gui/session/document.h"

#include "engine/core/file.h"

#include <system_error>
#include <utility>

namespace luxdeck::gui {

namespace fs = std::filesystem;

namespace {
constexpr std::uint64_t kMostBytes = 8U << 20U;  // as the project reader's
}

Result<Document> Document::open(const fs::path& file) {
    auto text = readFile(file, kMostBytes);
    if (!text) return text.error();
    Document document(file, *std::move(text));
    document.saved_ = 0;
    return document;
}

Document::Document(fs::path file, std::string text) : file_(std::move(file)), states_{State{"", std::move(text)}}, saved_(kNever) {}

void Document::change(std::string what, std::string text) {
    if (text == states_[at_].text) return;
    states_.resize(at_ + 1);
    if (saved_ != kNever && saved_ > at_) saved_ = kNever;
    states_.push_back({std::move(what), std::move(text)});
    ++at_;
}

void Document::undo() {
    if (canUndo()) --at_;
}

void Document::redo() {
    if (canRedo()) ++at_;
}

void Document::withdraw() {
    if (!canUndo()) return;
    if (saved_ == at_) saved_ = kNever;
    states_.resize(at_);
    --at_;
}

Result<void> Document::save() { return saveAs(file_); }

Result<void> Document::saveAs(const fs::path& file) {
    if (auto written = writeFileAtomically(file, text()); !written) return written;
    std::error_code ignored;
    fs::remove(autosaveFile(), ignored);
    file_ = file;
    saved_ = at_;
    return {};
}

fs::path Document::autosaveFile() const { return file_.parent_path() / ("." + file_.filename().string() + ".autosave"); }

Result<void> Document::autosave() const {
    if (modified()) return writeFileAtomically(autosaveFile(), text());
    std::error_code ignored;
    fs::remove(autosaveFile(), ignored);
    return {};
}

std::string Document::recoverable() const {
    auto kept = readFile(autosaveFile(), kMostBytes);
    return kept && *kept != text() ? *std::move(kept) : std::string();
}

}  // namespace luxdeck::gui
