#include "gui/session/pictures.h"

#include "engine/algorithms/registry.h"
#include "engine/core/file.h"
#include "engine/io/image_files.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr double kPreviewPixels = 24e3;      // one path each: some tenths of a second
constexpr double kShowEverySeconds = 0.7;

View previewOf(const View& view) {
    const double scale = std::sqrt(kPreviewPixels / (static_cast<double>(view.width) * view.height));
    if (scale >= 0.7) return view;
    View small = view;
    small.width = std::max(1, static_cast<int>(std::lround(view.width * scale))), small.height = std::max(1, static_cast<int>(std::lround(view.height * scale)));
    return small;
}

bool sameView(const View& a, const View& b) {
    return a.name == b.name && a.kind == b.kind && a.position == b.position && a.direction == b.direction && a.up == b.up && a.verticalFovDeg == b.verticalFovDeg;
}

/// A view of the project of this name looks elsewhere now.
bool viewHasMoved(const View& view, const Project& project) {
    const auto at = std::find_if(project.views.begin(), project.views.end(), [&](const auto& each) { return each.name == view.name; });
    return at != project.views.end() && !sameView(*at, view);
}

std::shared_ptr<const RenderResult> shared(RenderResult result) { return std::make_shared<const RenderResult>(std::move(result)); }

Result<void> write(const Image& picture, const Look& look, const std::filesystem::path& file) {
    const auto kind = lowerExtension(file);
    if (kind == ".exr") return writeExr(file, picture);
    if (kind == ".hdr") return writeRgbe(file, picture);
    auto developed = develop(picture, look);
    if (!developed) return developed.error();
    const auto complete = picture.text.find("luxdeck:complete");
    if (complete != picture.text.end() && complete->second == "false") developed->image.text["luxdeck:complete"] = "false";
    return writePng(file, developed->image);
}

}  // namespace

std::string PictureState::name() const { return view.name + " · " + algorithm + (current ? "" : " · earlier"); }

Result<void> Pictures::render(const PictureRequest& request) {
    if (!place_.project) return Error{ErrorCode::InvalidArgument, "no project is open", {}};
    if (auto possible = checkRender(request.view, request.settings); !possible) return possible;
    cancel();
    std::erase_if(all_, [&](const auto& each) {
        return each.current && each.algorithm == request.settings.algorithm && sameView(each.view, request.view);
    });
    makeRoom();
    const auto number = next_++;
    all_.push_back({number, request.view, request.settings.algorithm, nullptr, nullptr, place_.project, true, true});
    shown_[0] = number;
    auto settings = request.settings;
    settings.showEverySeconds = kShowEverySeconds;
    place_.jobs.start(JobKind::Render, "Rendering " + request.view.name,
                      [this, number, project = place_.project, view = request.view, settings](const Progress& progress, const Jobs::Tell& tell) -> Jobs::Delivery {
        const auto estimator = makeEstimator(settings.algorithm, project->lit.transport(), settings.algorithmSettings, settings.seed, progress);
        if (!estimator)
            return [this, number, error = estimator.error()] {
                if (error.code != ErrorCode::Cancelled) place_.complain(error);
                remove(number);
            };
        const auto takes = [this, number](const RenderResult& result, bool running) {
            return [this, number, running, kept = shared(result)] { take(number, kept, running); };
        };
        const auto small = previewOf(view);
        auto quick = settings;
        quick.samples = 1;
        const auto preview = luxdeck::render(project->project, project->lit, small, **estimator, quick, progress);
        if (preview.samplesPerPixel > 0) tell(takes(preview, true));
        const auto picture = luxdeck::render(project->project, project->lit, view, **estimator, settings, progress,
                                             [&](const RenderResult& soFar) { tell(takes(soFar, true)); });
        // Stopped before every pixel had a sample: the small picture is what there is.
        if (picture.samplesPerPixel == 0) return [this, number] { take(number, nullptr, false); };
        return takes(picture, false);
    });
    place_.tell(Change::Jobs);
    place_.tell(Change::Pictures);
    return {};
}

void Pictures::take(std::uint64_t number, std::shared_ptr<const RenderResult> result, bool running) {
    const auto at = std::find_if(all_.begin(), all_.end(), [&](const auto& each) { return each.number == number; });
    if (at == all_.end()) return;  // its project was closed
    at->running = running;
    if (result) {
        at->result = std::move(result);
        at->image = std::shared_ptr<const Image>(at->result, &at->result->image);
    } else if (!at->result) {
        return remove(number);  // stopped before there was anything
    }
    at->current = isCurrent(*at);
    if (shown_[0] == number || shown_[1] == number) develop();
    place_.tell(Change::Pictures);
}

const PictureState* Pictures::numbered(std::uint64_t number) const {
    const auto at = std::find_if(all_.begin(), all_.end(), [&](const auto& each) { return each.number == number; });
    return at == all_.end() ? nullptr : &*at;
}

void Pictures::remove(std::uint64_t number) {
    std::erase_if(all_, [&](const auto& each) { return each.number == number; });
    for (auto& side : shown_)
        if (side == number) side = 0;
    if (shown_[0] == 0 && !all_.empty()) shown_[0] = all_.back().number;
    develop();
    place_.tell(Change::Pictures);
}

void Pictures::makeRoom() {
    while (all_.size() >= kMost) {
        auto at = std::find_if(all_.begin(), all_.end(), [](const auto& each) { return !each.current; });
        if (at == all_.end()) at = all_.begin();
        for (auto& side : shown_)
            if (side == at->number) side = 0;
        all_.erase(at);
    }
}

void Pictures::show(std::size_t side, std::uint64_t number) {
    if (shown_[side] == number) return;
    shown_[side] = number;
    develop();
    place_.tell(Change::Pictures);
}

void Pictures::setLook(const Look& look) {
    look_ = look;
    develop();
}

void Pictures::develop() {
    const auto imageOf = [&](std::size_t side) { return numbered(shown_[side]) != nullptr ? numbered(shown_[side])->image : nullptr; };
    const Darkroom::Pictures pictures{imageOf(0), imageOf(1)};
    if (pictures[0] || pictures[1]) darkroom_.develop(pictures, look_);
    else darkroom_.clear();
}

Result<void> Pictures::save(std::uint64_t number, const std::filesystem::path& file) {
    const auto* state = numbered(number);
    if (state == nullptr || !state->image) return Error{ErrorCode::InvalidArgument, "there is no picture to save yet", file.string()};
    const auto kind = lowerExtension(file);
    if (kind != ".exr" && kind != ".hdr" && kind != ".png")
        return Error{ErrorCode::InvalidArgument, "saw \"" + kind + "\", expected a name that ends in .exr, .hdr or .png", file.string()};
    auto look = look_;
    look.legend = true;
    place_.save("Saving " + file.filename().string(), "Saved " + file.string(), [image = state->image, look, file] { return write(*image, look, file); });
    return {};
}

bool Pictures::isCurrent(const PictureState& state) const {
    return place_.project && place_.project->project.scene.hash == state.of->project.scene.hash && !viewHasMoved(state.view, place_.project->project);
}

void Pictures::follow() {
    for (auto& state : all_) state.current = isCurrent(state);
    place_.tell(Change::Pictures);
}

void Pictures::clear() {
    all_.clear();
    shown_ = {};
    darkroom_.clear();
    place_.tell(Change::Pictures);
}

}  // namespace luxdeck::gui
