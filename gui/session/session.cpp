#include "gui/session/session.h"

#include "engine/core/file.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace luxdeck::gui {

namespace fs = std::filesystem;

Session::Session(std::function<void()> wake) : place(std::move(wake)) {}

Session::~Session() { place.jobs.cancelAll(); }

bool Session::deliver() {
    const bool any = place.jobs.deliver();
    if (any) place.tell(Change::Jobs);
    return any;
}

void Session::open(const fs::path& file, std::string text) {
    close();
    editable_ = lowerExtension(file) == ".toml";
    if (editable_) {
        auto document = Document::open(file);
        if (!document) return place.complain(document.error());
        document_ = *std::move(document);
        if (!text.empty()) document_.change("Recovered", std::move(text));
    } else {
        document_ = Document(file, {});
    }
    place.tell(Change::Document);
    load(document_.text(), false);
}

void Session::close() {
    place.jobs.abandonAll();
    document_ = Document();
    editable_ = false;
    place.project.reset();
    selection_ = {};
    solving.clear();
    volumes.clear();
    pictures.clear();
    volumeLight.clear();
    furnishing.clear();
    importing.clear();
    comparing.clear();
    reporting.clear();
    place.tell(Change::Document);
    place.tell(Change::Project);
}

void Session::load(const std::string& text, bool afterEdit) {
    place.jobs.abandon(loading_);
    const auto file = document_.file();
    const bool asText = editable_;
    loading_ = place.jobs.start(JobKind::Load, "Reading " + file.filename().string(), [=, this](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        auto read = asText ? loadLit(file, text) : loadLit(std::vector<fs::path>{file});
        auto made = read ? std::make_shared<Result<std::shared_ptr<const LitProject>>>(std::shared_ptr<const LitProject>(*std::move(read)))
                         : std::make_shared<Result<std::shared_ptr<const LitProject>>>(read.error());
        return [this, made, afterEdit] {
            if (*made) return arrived(**made);
            place.complain(made->error());
            if (!afterEdit) return;
            document_.withdraw();
            place.tell(Change::Document);
            if (place.project && place.project->project.fileHash != contentHash(document_.text())) load(document_.text(), true);
        };
    });
    place.tell(Change::Jobs);
}

void Session::arrived(std::shared_ptr<const LitProject> project) {
    const bool first = place.project == nullptr;
    const std::vector<std::string> known = first ? std::vector<std::string>{} : place.project->project.scene.warnings;
    place.project = std::move(project);
    for (const auto& warning : place.project->project.scene.warnings)
        if (std::find(known.begin(), known.end(), warning) == known.end()) place.warn(warning);
    solving.follow();
    volumes.follow();
    furnishing.follow();
    pictures.follow();
    reporting.follow();
    place.tell(Change::Project);
}

Result<void> Session::edit(const std::string& what, const Edit& edit) {
    if (!editable_)
        return Error{ErrorCode::InvalidArgument, "a bare scene cannot be changed: save it as a project first", document_.file().string()};
    auto text = edit(document_.text());
    if (!text) return text.error();
    if (*text == document_.text()) return {};
    document_.change(what, *std::move(text));
    place.tell(Change::Document);
    load(document_.text(), true);
    return {};
}

void Session::undo() {
    if (!document_.canUndo()) return;
    document_.undo();
    place.tell(Change::Document);
    load(document_.text(), false);
}

void Session::redo() {
    if (!document_.canRedo()) return;
    document_.redo();
    place.tell(Change::Document);
    load(document_.text(), false);
}

Result<void> Session::save() { return saveAs(document_.file()); }

Result<void> Session::saveAs(const fs::path& file) {
    auto saved = document_.saveAs(file);
    if (saved) place.tell(Change::Document);
    return saved;
}

void Session::forget() {
    std::error_code ignored;
    fs::remove(document_.autosaveFile(), ignored);
    document_ = Document(document_.file(), document_.text());
    editable_ = false;
}

void Session::autosave() {
    if (!editable_) return;
    const auto kept = document_.autosave();
    if (!kept && !autosaveFailed_) place.complain(kept.error());
    autosaveFailed_ = !kept;
}

void Session::setDisplay(const Display& display) {
    if (display == display_) return;
    display_ = display;
    place.tell(Change::Display);
}

void Session::setView(std::size_t index, const ViewSettings& settings) {
    if (index >= views_.size() || views_[index] == settings) return;
    views_[index] = settings;
    place.tell(Change::Display);
}

void Session::setViewCount(std::size_t count) {
    views_.resize(std::clamp<std::size_t>(count, 1, kMostViews), views_.back());
    place.tell(Change::Display);
}

void Session::select(const Selection& selection) {
    if (selection == selection_) return;
    selection_ = selection;
    place.tell(Change::Selection);
}

}  // namespace luxdeck::gui
