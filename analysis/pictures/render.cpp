#include "analysis/pictures/render.h"

#include "analysis/pictures/camera.h"
#include "engine/algorithms/registry.h"
#include "engine/core/parallel.h"
#include "engine/core/stopwatch.h"
#include "engine/core/version.h"
#include "engine/transport/chance_light.h"
#include "engine/transport/surface/surface_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace luxdeck {

namespace {

constexpr std::size_t kPixelsPerTask = 512;
constexpr std::uint32_t kFirstPass = 1;   // paths a pixel: even a short time gives a whole picture
constexpr std::uint32_t kMostPerPass = 16;
constexpr double kMostFailed = 0.01;         // part of a pixel's samples, as of a point's (analysis/grids/measurement.h)
constexpr std::uint32_t kEnoughToJudge = 4;  // paths a pixel before its error is believed

/// The sums of one pixel.
struct Pixel {
    std::array<double, 3> rgb{};
    double squares = 0;          // of the luminance
    double lost = 0;             // the most that failed samples miss of it
    std::uint32_t failed = 0;    // samples of which a part is missing
    float distance = kInfinity;  // of the first sample
    std::uint32_t samples = 0;
};

/// The colour that an eye in the scene takes for white: that of its light sources, weighted by their flux.
Rgb adoptedWhite(const Scene& scene) {
    Rgb sum(0.0F);
    for (const auto& l : scene.luminaires) {
        const auto& type = scene.luminaireTypes[l.type];
        sum += type.colour * static_cast<float>(type.photometry.table.lumens() * l.outputScale());
    }
    if (sum.isBlack() && scene.sky.present()) sum = scene.sky.colour;
    const float y = luminance(sum, scene.weights);
    return y > 0 ? sum * (1 / y) : Rgb(1.0F);
}

/// A picture in the making.
class Rendering {
public:
    Rendering(const Project& project, const View& view, const LitScene& lit, const RadianceEstimator& estimator,
              const RenderSettings& settings, const Progress& progress)
        : project_(project), view_(view), lit_(lit), estimator_(estimator), settings_(settings), progress_(progress),
          camera_(view, project.scene), pixels_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height)) {
        if (algorithmNamed(settings.algorithm)->interreflection) chanceLight_ = chanceLightWarnings(lit.transport());
        state_.stage = settings.stage.empty() ? "rendering " + view.name : settings.stage;
    }

    RenderResult run(const std::function<void(const RenderResult&)>& afterPass) {
        double shown = 0;
        std::uint32_t pass = kFirstPass;
        while (true) {
            if (settings_.samples) pass = std::min(pass, *settings_.samples - done_);
            const bool whole = addPass(pass);
            if (whole) done_ += pass;
            assess();
            if (!whole || reached() || (settings_.samples && done_ >= *settings_.samples)) break;
            if (afterPass && clock_.seconds() - shown > settings_.showEverySeconds) {
                afterPass(result());
                shown = clock_.seconds();
            }
            pass = std::min(std::max(done_, kFirstPass), kMostPerPass);
        }
        return result();
    }

private:
    [[nodiscard]] bool outOfTime() const {
        return settings_.timeSeconds && clock_.seconds() >= *settings_.timeSeconds;
    }

    /// Adds samples to every pixel. A first pass is finished even when the time is up: a picture with
    /// holes would be none.
    bool addPass(std::uint32_t count) {
        const std::size_t tasks = (pixels_.size() + kPixelsPerTask - 1) / kPixelsPerTask;
        const std::size_t slice = std::max<std::size_t>(64, static_cast<std::size_t>(threadCount()) * 8);
        for (std::size_t first = 0; first < tasks; first += slice) {
            if (progress_.cancelled() || (done_ > 0 && outOfTime())) return false;
            const std::size_t n = std::min(slice, tasks - first);
            std::vector<TransportCounters> counters(n);
            parallelFor(n, [&](std::size_t t) {
                const std::size_t begin = (first + t) * kPixelsPerTask;
                addSamples(begin, std::min(begin + kPixelsPerTask, pixels_.size()), count, counters[t]);
            });
            for (const auto& c : counters) counters_ += c;
            tell(static_cast<double>(first + n) / static_cast<double>(tasks), count);
        }
        return true;
    }

    void tell(double partOfPass, std::uint32_t pass) {
        const double elapsed = clock_.seconds();
        state_.rate = static_cast<double>(counters_.rays) / std::max(elapsed, 1e-9) * 1e-6;
        state_.rateUnit = "Mray/s";
        const double samples = done_ + partOfPass * pass;
        if (settings_.timeSeconds) state_.fraction = std::min(1.0, elapsed / *settings_.timeSeconds);
        if (settings_.samples) state_.fraction = std::max(state_.fraction, samples / *settings_.samples);
        if (state_.errorPercent > 0 && settings_.targetError > 0 && !settings_.samples) {
            const double needed = std::pow(state_.errorPercent / 100 / settings_.targetError, 2) * std::max(1U, done_);
            state_.fraction = std::max(state_.fraction, std::min(1.0, samples / needed));
        }
        if (state_.fraction > 0.01) state_.secondsLeft = elapsed * (1 - state_.fraction) / state_.fraction;
        progress_.report(state_);
    }

    /// `count` more samples of each of a run of pixels, one sample of all at a time.
    void addSamples(std::size_t begin, std::size_t end, std::uint32_t count, TransportCounters& counters) {
        std::vector<RadianceQuery> queries;
        std::vector<std::size_t> owners;
        for (std::uint32_t s = 0; s < count; ++s) {
            queries.clear(), owners.clear();
            for (std::size_t p = begin; p < end; ++p) {
                SamplePath numbers(streamSeed(settings_.seed, p, 0x9c7), pixels_[p].samples);
                const Vec2 jitter = numbers.next2D();
                const auto width = static_cast<std::size_t>(view_.width);
                const auto ray = camera_.ray(static_cast<float>(p % width) + jitter.x, static_cast<float>(p / width) + jitter.y);
                ++pixels_[p].samples;
                if (!ray) continue;
                RadianceQuery query;
                query.ray = *ray;
                query.numbers = numbers;
                queries.push_back(query);
                owners.push_back(p);
            }
            if (settings_.quantity == Quantity::Luminance) addLuminance(queries, owners, counters);
            else addIlluminance(queries, owners, counters);
        }
    }

    void addLuminance(std::span<const RadianceQuery> queries, std::span<const std::size_t> owners, TransportCounters& counters) {
        std::vector<RadianceSample> samples(queries.size());
        counters += estimator_.radiance(queries, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            add(owners[i], samples[i].total(), samples[i].distance);
            addLost(owners[i], samples[i].failure, samples[i].lost);
        }
    }

    void addIlluminance(std::span<const RadianceQuery> queries, std::span<const std::size_t> owners, TransportCounters& counters) {
        std::vector<Ray> rays;
        for (const auto& q : queries) rays.push_back(q.ray);
        std::vector<Hit> hits(rays.size());
        lit_.raycaster().closestHits(rays, hits, Targets::Opaque);
        counters.rays += rays.size();
        std::vector<SensorQuery> sensors;
        std::vector<std::size_t> sensorOwners, sensorHits;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (!hits[i].surface()) continue;
            const auto point = surfacePoint(project_.scene, lit_.needs(), rays[i], hits[i]);
            sensors.push_back({point.position, point.geometricNormal, SensorKind::Planar, queries[i].numbers});
            sensorOwners.push_back(owners[i]), sensorHits.push_back(i);
        }
        std::vector<SensorSample> samples(sensors.size());
        counters += estimator_.irradiance(sensors, samples);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            add(sensorOwners[i], samples[i].total(), hits[sensorHits[i]].distance);
            addLost(sensorOwners[i], samples[i].failure, samples[i].lost);
        }
    }

    void addLost(std::size_t p, RayFailure failure, const Rgb& lost) {
        pixels_[p].failed += failure != RayFailure::None ? 1 : 0;
        pixels_[p].lost += lost.isBlack() ? 0 : luminance(lost, project_.scene.weights);
    }

    void add(std::size_t p, const Rgb& value, float distance) {
        auto& pixel = pixels_[p];
        pixel.rgb[0] += value.r, pixel.rgb[1] += value.g, pixel.rgb[2] += value.b;
        const double y = luminance(value, project_.scene.weights);
        pixel.squares += y * y;
        pixel.distance = std::min(pixel.distance, distance);
    }

    /// Mean luminance and its variance of one pixel.
    [[nodiscard]] std::array<double, 2> estimate(const Pixel& pixel) const {
        const double n = std::max(1U, pixel.samples);
        const auto& w = project_.scene.weights;
        const double mean = (w.r * pixel.rgb[0] + w.g * pixel.rgb[1] + w.b * pixel.rgb[2]) / n;
        const double noise = n > 1 ? std::max(0.0, pixel.squares / n - mean * mean) / (n - 1) : 0.0;
        const double lost = pixel.lost / n;  // its truth lies evenly likely anywhere from nothing to all of it: 95 % below 0.95
        return {mean, noise + lost * lost * (0.95 * 0.95 / (1.96 * 1.96))};
    }

    void assess() {
        double sum = 0, variance = 0;
        for (const auto& pixel : pixels_) {
            const auto [mean, var] = estimate(pixel);
            sum += mean, variance += var;
        }
        const auto n = static_cast<double>(pixels_.size());
        const double ofBlack = chanceLight_.empty() ? 0 : double{kInfinity};  // there are lights that no path has met
        relativeError_ = sum > 0 ? 1.96 * std::sqrt(variance / n) / (sum / n) : ofBlack;
        state_.errorPercent = 100 * relativeError_;
    }

    [[nodiscard]] bool reached() const {
        return !settings_.samples && settings_.targetError > 0 && done_ >= kEnoughToJudge && relativeError_ <= settings_.targetError;
    }

    [[nodiscard]] RenderResult result() const {
        RenderResult r;
        r.image = image();
        r.seconds = clock_.seconds();
        r.samplesPerPixel = done_;
        r.relativeError = relativeError_;
        r.valuelessPixels = static_cast<std::size_t>(std::ranges::count_if(
            pixels_, [](const Pixel& p) { return p.failed > kMostFailed * p.samples; }));
        r.complete = !progress_.cancelled() && r.valuelessPixels == 0;
        r.warnings = chanceLight_;
        if (r.valuelessPixels > 0)
            r.warnings.push_back(fmt::format("{} pixels show something without a value: they hold what was found before it, "
                                             "their error what may be missing", r.valuelessPixels));
        r.targetReached = settings_.samples || !(settings_.targetError > 0) || relativeError_ <= settings_.targetError;
        r.counters = counters_;
        describe(r);
        return r;
    }

    [[nodiscard]] Image image() const {
        Image picture(view_.width, view_.height, {"R", "G", "B", "stderr.Y", "Z"});
        picture.weights = project_.scene.weights;
        auto &r = picture.channel("R"), &g = picture.channel("G"), &b = picture.channel("B");
        auto &error = picture.channel("stderr.Y"), &z = picture.channel("Z");
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            const auto& pixel = pixels_[i];
            const double n = std::max(1U, pixel.samples);
            r[i] = static_cast<float>(pixel.rgb[0] / n), g[i] = static_cast<float>(pixel.rgb[1] / n);
            b[i] = static_cast<float>(pixel.rgb[2] / n);
            error[i] = static_cast<float>(std::sqrt(estimate(pixel)[1]));
            z[i] = pixel.distance;
        }
        return picture;
    }

    void describe(RenderResult& r) const {
        auto& text = r.image.text;
        text["luxdeck:quantity"] = settings_.quantity == Quantity::Luminance ? "luminance" : "illuminance";
        text["luxdeck:unit"] = settings_.quantity == Quantity::Luminance ? "cd/m^2" : "lx";
        text["luxdeck:project"] = project_.info.name;
        text["luxdeck:view"] = view_.name;
        text["luxdeck:algorithm"] = settings_.algorithm;
        text["luxdeck:sceneHash"] = project_.scene.hash;
        text["luxdeck:version"] = kVersion;
        text["luxdeck:kernel"] = lit_.raycaster().kernel();
        text["luxdeck:complete"] = r.complete ? "true" : "false";
        text["luxdeck:colourSpace"] = project_.scene.weights == kRec709 ? "linear Rec.709" : "scene RGB";
        const Rgb white = adoptedWhite(project_.scene);
        text["luxdeck:adoptedWhite"] = fmt::format("{} {} {}", white.r, white.g, white.b);
        text["VIEW"] = radianceView();
        auto& numbers = r.image.numbers;
        numbers["whiteLuminance"] = 1;
        numbers["luxdeck:seed"] = static_cast<double>(settings_.seed);
        numbers["luxdeck:seconds"] = r.seconds;
        numbers["luxdeck:samplesPerPixel"] = done_;
        numbers["luxdeck:relativeError"] = relativeError_;
        numbers["luxdeck:rejectedSamples"] = static_cast<double>(counters_.rejected);
    }

    /// The view as Radiance's tools write it, so that they and our tone mapper know its geometry.
    [[nodiscard]] std::string radianceView() const {
        const auto& p = view_.position;
        const auto& d = view_.direction;
        const auto& u = view_.up;
        const bool perspective = view_.kind == ViewKind::Perspective;
        const double horizontal = 2 * std::atan(std::tan(view_.verticalFovDeg * kDegree / 2) * view_.width / view_.height) / kDegree;
        return fmt::format("{} -vp {} {} {} -vd {} {} {} -vu {} {} {} -vh {} -vv {}", perspective ? "-vtv" : "-vta", p.x, p.y, p.z,
                           d.x, d.y, d.z, u.x, u.y, u.z, perspective ? horizontal : 180.0, perspective ? view_.verticalFovDeg : 180.0);
    }

    const Project& project_;
    const View& view_;
    const LitScene& lit_;
    const RadianceEstimator& estimator_;
    RenderSettings settings_;
    const Progress& progress_;
    Camera camera_;
    std::vector<Pixel> pixels_;
    Stopwatch clock_;
    ProgressState state_;
    TransportCounters counters_;
    std::uint32_t done_ = 0;
    double relativeError_ = 0;
    std::vector<std::string> chanceLight_;  // lights that paths meet by chance alone, for people
};

}  // namespace

Result<void> checkRender(const View& view, const RenderSettings& settings) {
    if (view.width < 1 || view.height < 1)
        return Error{ErrorCode::InvalidArgument, fmt::format("view \"{}\" is {} x {} pixels", view.name, view.width, view.height), view.where};
    if (!(settings.targetError > 0) && !settings.timeSeconds && !settings.samples)
        return Error{ErrorCode::InvalidArgument, "neither a target error, a time nor a number of samples: rendering would never end"};
    return {};
}

Result<RenderResult> render(const Project& project, const LitScene& lit, const View& view, const RenderSettings& settings,
                            const Progress& progress, const std::function<void(const RenderResult&)>& afterPass) {
    auto estimator = makeEstimator(settings.algorithm, lit.transport(), settings.algorithmSettings, settings.seed, progress);
    if (!estimator) return estimator.error();
    if (const auto possible = checkRender(view, settings); !possible) return possible.error();
    return render(project, lit, view, **estimator, settings, progress, afterPass);
}

RenderResult render(const Project& project, const LitScene& lit, const View& view, const RadianceEstimator& estimator, const RenderSettings& settings,
                    const Progress& progress, const std::function<void(const RenderResult&)>& afterPass) {
    return Rendering(project, view, lit, estimator, settings, progress).run(afterPass);
}

}  // namespace luxdeck
