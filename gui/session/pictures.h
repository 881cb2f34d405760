#pragma once

#include "analysis/pictures/render.h"
#include "gui/session/darkroom.h"
#include "gui/session/look.h"
#include "gui/session/workplace.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::gui {

/// A rendering of the session.
struct PictureState {
    std::uint64_t number = 0;                  ///< its own, never given again; 0: none
    View view;                                 ///< with the size that was asked for
    std::string algorithm;
    std::shared_ptr<const RenderResult> result;  ///< null: nothing yet; the first one is smaller than asked for
    std::shared_ptr<const Image> image;        ///< of the result
    std::shared_ptr<const LitProject> of;      ///< what was rendered
    bool running = true;
    bool current = true;                       ///< of the project as it is now

    /// "cover · path", and "earlier" where the project has changed since.
    [[nodiscard]] std::string name() const;
};

struct PictureRequest {
    View view;                                 ///< one of the project's, or what a camera sees now; with the picture's size
    RenderSettings settings;
};

/// Pictures of the project's views: rendered in the background, kept by view and algorithm, made visible by tone mapping
/// or false colour, saved. One that the project has grown away from is kept beside its successor, to be compared with it.
class Pictures {
public:
    static constexpr std::size_t kMost = 12;   ///< are kept; the oldest of another state of the project goes first

    explicit Pictures(Workplace& place) : place_(place), darkroom_(place) {}

    /// In the background: a small picture at once, then the whole one, pass after pass. Stops what is being rendered.
    ///
    /// errors  InvalidArgument: no project, no size, nothing that ends the work
    Result<void> render(const PictureRequest& request);
    /// What there is stays, marked incomplete.
    void cancel() { place_.jobs.cancel(JobKind::Render); }

    /// Oldest first.
    [[nodiscard]] const std::vector<PictureState>& all() const { return all_; }
    /// Null: there is none.
    [[nodiscard]] const PictureState* numbered(std::uint64_t number) const;
    void remove(std::uint64_t number);

    /// Which are looked at: on the left (or alone), and right of the divider. 0: none.
    void show(std::size_t side, std::uint64_t number);
    [[nodiscard]] const PictureState* shown(std::size_t side) const { return numbered(shown_[side]); }
    [[nodiscard]] const Look& look() const { return look_; }
    void setLook(const Look& look);
    /// As it is to be seen; null: nothing yet.
    [[nodiscard]] const std::shared_ptr<const Developed>& developed(std::size_t side) const { return darkroom_.shown(side); }
    /// The numbers behind it, the same size (developed() may show a pass less than numbered() has).
    [[nodiscard]] const std::shared_ptr<const Image>& behind(std::size_t side) const { return darkroom_.source(side); }

    /// In the background, whole or not at all: .exr and .hdr hold cd/m², .png what is seen now (false colours with their
    /// legend). What fails on the way goes to the log.
    ///
    /// errors  InvalidArgument: there is nothing to save, another extension
    Result<void> save(std::uint64_t number, const std::filesystem::path& file);

    /// The project has changed.
    void follow();
    void clear();

private:
    void take(std::uint64_t number, std::shared_ptr<const RenderResult> result, bool running);
    void develop();
    void makeRoom();
    [[nodiscard]] bool isCurrent(const PictureState& state) const;

    Workplace& place_;
    Darkroom darkroom_;
    Look look_;
    std::vector<PictureState> all_;
    std::array<std::uint64_t, Darkroom::kSides> shown_{};
    std::uint64_t next_ = 1;
};

}  // namespace luxdeck::gui
