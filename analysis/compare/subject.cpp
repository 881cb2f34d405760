#include "analysis/compare/subject.h"

#include "analysis/grids/grid_targets.h"
#include "analysis/grids/sampling_run.h"
#include "analysis/grids/solver.h"
#include "analysis/pictures/render.h"
#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace luxdeck {

namespace {

/// The scale of a run of values that are judged together.
void addScale(const Field& truth, std::size_t first, std::size_t count, Field& scale) {
    const auto begin = truth.begin() + static_cast<std::ptrdiff_t>(first);
    const double mean = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(count), 0.0) / static_cast<double>(count);
    // Where all is dark there is no relative error: then errors are told in the unit itself.
    const double least = mean > 0 ? kDarkPoint * mean : 1;
    for (std::size_t i = first; i < first + count; ++i) scale[i] = std::max(truth[i], least);
}

class GridsSubject : public Subject {
public:
    GridsSubject(const Project& project, std::vector<GridLayout> layouts)
        : project_(project), layouts_(std::move(layouts)), targets_(gridTargets(project, layouts_)) {}

    [[nodiscard]] const std::string& name() const override { return name_; }
    [[nodiscard]] std::size_t size() const override { return targets_.size(); }
    [[nodiscard]] std::uint32_t leastSamples() const override { return kReplicates; }

    [[nodiscard]] Field scaleOf(const Field& truth) const override {
        Field scale(truth.size());
        std::size_t first = 0;
        for (const auto& layout : layouts_) {
            addScale(truth, first, layout.points.size(), scale);
            first += layout.points.size();
        }
        return scale;
    }

    [[nodiscard]] Place placeOf(std::size_t index) const override {
        std::size_t g = 0;
        for (; index >= layouts_[g].points.size(); ++g) index -= layouts_[g].points.size();
        const auto& layout = layouts_[g];
        const int columns = std::max(layout.columns, 1), at = static_cast<int>(index);
        return {project_.grids[g].name, layout.points[index], layout.columns > 0 ? at % columns : at, layout.columns > 0 ? at / columns : 0};
    }

    [[nodiscard]] std::string key() const override {
        std::string text;
        for (const auto& layout : layouts_)
            for (std::size_t i = 0; i < layout.points.size(); ++i) {
                const auto &p = layout.points[i], &n = layout.normals[i];
                text += fmt::format("{} {} {} {} {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z);
            }
        for (const auto& grid : project_.grids) text += grid.kind == GridKind::Planar ? 'p' : 'c';
        return contentHash(text);
    }

    [[nodiscard]] Measured measure(const RadianceEstimator& estimator, std::uint32_t samples, std::uint64_t seed, const std::string& stage,
                                   const Progress& progress) const override {
        SamplingRun run(estimator, project_.scene.weights, targets_, seed);
        ProgressState state;
        state.stage = stage;
        Measured out;
        out.whole = run.round(std::vector<std::uint32_t>(targets_.size(), std::max(1U, samples / kReplicates)), progress, state, std::nullopt);
        out.seconds = run.seconds();
        out.paths = run.counters().paths, out.rejected = run.counters().rejected;
        for (const auto& sums : run.sums()) out.values.push_back(sums.perReplicate > 0 ? sums.total().value : 0.0);
        return out;
    }

private:
    const std::string name_ = "grids";
    const Project& project_;
    std::vector<GridLayout> layouts_;
    std::vector<Target> targets_;
};

class ViewSubject : public Subject {
public:
    ViewSubject(const Project& project, const LitScene& lit, View view) : project_(project), lit_(lit), view_(std::move(view)) {}

    [[nodiscard]] const std::string& name() const override { return view_.name; }
    [[nodiscard]] bool isPicture() const override { return true; }
    [[nodiscard]] std::size_t size() const override { return static_cast<std::size_t>(view_.width) * static_cast<std::size_t>(view_.height); }
    [[nodiscard]] std::uint32_t leastSamples() const override { return 1; }

    [[nodiscard]] Field scaleOf(const Field& truth) const override {
        Field scale(truth.size());
        addScale(truth, 0, truth.size(), scale);
        return scale;
    }
    [[nodiscard]] Place placeOf(std::size_t index) const override {
        return {"", {0, 0, 0}, static_cast<int>(index) % view_.width, static_cast<int>(index) / view_.width};
    }
    [[nodiscard]] std::string key() const override {
        const auto &p = view_.position, &d = view_.direction, &u = view_.up;
        return contentHash(fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}", static_cast<int>(view_.kind), p.x, p.y, p.z, d.x, d.y, d.z,
                                       u.x, u.y, u.z, view_.verticalFovDeg, view_.width, view_.height));
    }

    [[nodiscard]] Measured measure(const RadianceEstimator& estimator, std::uint32_t samples, std::uint64_t seed, const std::string& stage,
                                   const Progress& progress) const override {
        RenderSettings settings;
        settings.seed = seed;
        settings.samples = samples;
        settings.stage = stage;
        const auto picture = render(project_, lit_, view_, estimator, settings, progress);
        Measured out;
        out.whole = picture.samplesPerPixel == samples;
        out.seconds = picture.seconds;
        out.paths = picture.counters.paths, out.rejected = picture.counters.rejected;
        const auto pixels = colours(picture.image);
        for (const auto& pixel : pixels) out.values.push_back(luminance(pixel, picture.image.weights));
        return out;
    }

private:
    const Project& project_;
    const LitScene& lit_;
    View view_;
};

}  // namespace

Result<std::unique_ptr<Subject>> gridsSubject(const Project& project) {
    auto layouts = layOutAll(project);
    if (!layouts) return layouts.error();
    return std::unique_ptr<Subject>(std::make_unique<GridsSubject>(project, *std::move(layouts)));
}

std::unique_ptr<Subject> viewSubject(const Project& project, const LitScene& lit, const View& view, int height) {
    return std::make_unique<ViewSubject>(project, lit, shrunk(view, height));
}

View shrunk(const View& view, int height) {
    View out = view;
    out.width = std::max(1, static_cast<int>(std::lround(static_cast<double>(view.width) * height / view.height)));
    out.height = height;
    return out;
}

}  // namespace luxdeck
