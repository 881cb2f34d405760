#pragma once

#include "gui/session/comparing.h"
#include "gui/session/display.h"
#include "gui/session/document.h"
#include "gui/session/furnishing.h"
#include "gui/session/importing.h"
#include "gui/session/pictures.h"
#include "gui/session/reporting.h"
#include "gui/session/selection.h"
#include "gui/session/solving.h"
#include "gui/session/volume_light.h"
#include "gui/session/volumes.h"
#include "gui/session/workplace.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// All that the window shows and does, without the window. One thread (the window's) uses it; long work runs beside it and
/// comes back when deliver() is called.
class Session {
public:
    static constexpr std::size_t kMostViews = 4;

    /// wake  called from any thread: call deliver() soon, on the session's thread
    explicit Session(std::function<void()> wake);
    /// Cancels what runs and waits for it.
    ~Session();

    void observe(Workplace::Observer observer) { place.observe(std::move(observer)); }
    /// Takes up what jobs said since the last time. Returns whether there was anything.
    bool deliver();

    // ---- the project ----
    /// Reads a project (.toml) or a bare scene, in the background; what was open is closed first.
    ///
    /// text  what to take instead of what the file holds (recovered from an autosave)
    void open(const std::filesystem::path& file, std::string text = {});
    void close();
    [[nodiscard]] const std::shared_ptr<const LitProject>& project() const { return place.project; }
    [[nodiscard]] const Document& document() const { return document_; }
    /// A project file that can be changed: bare scenes cannot.
    [[nodiscard]] bool editable() const { return editable_; }

    /// Makes a new text of the present one, and the project of it, in the background. A text that cannot be read is taken
    /// back, with the reason in the log.
    ///
    /// what   for the undo menu
    /// edit   text -> text
    using Edit = std::function<Result<std::string>(const std::string&)>;
    Result<void> edit(const std::string& what, const Edit& edit);
    void undo();
    void redo();
    Result<void> save();
    Result<void> saveAs(const std::filesystem::path& file);
    /// Lets go of what is not saved, and of what was kept of it: the user wants it so.
    void forget();
    /// Keeps what is not saved (Document::autosave); a failure goes to the log, once.
    void autosave();

    // ---- what is shown ----
    [[nodiscard]] const Display& display() const { return display_; }
    void setDisplay(const Display& display);
    [[nodiscard]] const std::vector<ViewSettings>& views() const { return views_; }
    void setView(std::size_t index, const ViewSettings& settings);
    /// 1 .. kMostViews; new ones are copies of the last.
    void setViewCount(std::size_t count);
    [[nodiscard]] const Selection& selection() const { return selection_; }
    void select(const Selection& selection);

    Workplace place;
    Solving solving{place};
    Volumes volumes{place};
    Pictures pictures{place};
    VolumeLight volumeLight{place};
    Furnishing furnishing{place, volumes};
    Importing importing{place};
    Comparing comparing{place, volumes};
    Reporting reporting{place, solving, comparing};

private:
    void load(const std::string& text, bool afterEdit);
    void arrived(std::shared_ptr<const LitProject> project);

    Document document_;
    bool editable_ = false;
    bool autosaveFailed_ = false;
    std::uint64_t loading_ = 0;  // the job that reads the document
    Display display_;
    std::vector<ViewSettings> views_{ViewSettings{}};
    Selection selection_;
};

}  // namespace luxdeck::gui
