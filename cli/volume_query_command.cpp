#include "cli/json_text.h"
#include "cli/line_reader.h"
#include "cli/ray_lines.h"
#include "cli/streams.h"
#include "cli/volume_commands.h"
#include "engine/volume/visible_lookup.h"
#include "engine/volume/volume_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace luxdeck::cli {

namespace {

constexpr std::size_t kMostLines = 4096;

struct Options {
    std::string volume;
    std::vector<std::string> scene;
    FieldOptions field;
};

std::string answer(const Rgb& c, const LuminanceWeights& weights, bool json) {
    const double y = luminance(c, weights);
    if (json) {
        const auto number = [](double x) { return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr); };
        return jsonText({{"schema", "luxdeck-volume-query/1"}, {"r", number(c.r)}, {"g", number(c.g)}, {"b", number(c.b)}, {"y", number(y)}}, -1);
    }
    return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", c.r, c.g, c.b, y);
}

/// Answers lines in their order, batch by batch.
class Query {
public:
    Query(const VolumeField& field, const Raycaster* raycaster, bool json) : field_(field), json_(json) {
        if (raycaster != nullptr) visible_ = std::make_unique<VisibleLookup>(field, *raycaster);
    }

    std::string answerLines(const std::vector<std::string>& lines) {
        std::vector<Vec3> positions, directions;
        std::vector<int> kinds;  // of the lines: good, bad, blank
        for (const auto& line : lines) {
            ++number_;
            const auto ray = parseRayLine(line, field_.volume().origin);
            kinds.push_back(isBlank(line) ? 2 : ray ? 0 : 1);
            if (kinds.back() == 1) bad_ = true, complainOfRayLine(line, number_);
            if (kinds.back() == 0) positions.push_back(ray->position), directions.push_back(ray->direction);
        }
        std::vector<Rgb> values(positions.size());
        if (visible_) counters_ += visible_->at(positions, directions, {}, values);
        else field_.at(positions, directions, values);
        std::string out;
        std::size_t next = 0;
        const Rgb unknown(std::numeric_limits<float>::quiet_NaN());
        for (const int kind : kinds) out += kind == 2 ? "\n" : answer(kind == 0 ? values[next++] : unknown, field_.volume().weights, json_);
        return out;
    }

    [[nodiscard]] bool badLine() const { return bad_; }
    [[nodiscard]] const LookupCounters& counters() const { return counters_; }

private:
    const VolumeField& field_;
    std::unique_ptr<VisibleLookup> visible_;
    LookupCounters counters_;
    std::uint64_t number_ = 0;
    bool json_, bad_ = false;
};

Exit runQuery(const Options& o, Context& context) {
    const auto volume = readVolume(o.volume);
    if (!volume) return complain(volume.error());
    std::unique_ptr<Loaded> loaded;
    if (!o.scene.empty()) {
        auto read = load(o.scene, context.common.quiet);
        if (!read) return complain(read.error());
        loaded = *std::move(read);
        if (const auto fits = checkVolumeIsOf(*volume, loaded->project.scene); !fits) return complain({fits.error().code, fits.error().message, o.volume});
    }
    const auto field = VolumeField::make(*volume, o.field.field());
    if (!field) return complain(field.error());
    if (field->basisErrorRms() > 0 && !context.common.quiet)
        say(fmt::format("luxdeck: harmonics of degree {} leave out {:.2g} % (rms), {:.2g} % at most, of the volume's rms\n", o.field.settings.degree, 100 * field->basisErrorRms(),
                        100 * field->basisErrorMax()));
    Query query(*field, loaded ? &loaded->lit.raycaster() : nullptr, context.common.json);
    LineReader reader(0, context.progress);
    std::vector<std::string> lines;
    while (reader.next(lines, kMostLines) && !context.progress.cancelled())
        if (const auto written = writeOutput("-", query.answerLines(lines)); !written) return complain(written.error());
    if (context.progress.cancelled()) return Exit::Interrupted;
    if (reader.failed()) return complain({ErrorCode::Parse, "a line is longer than 64 KiB, expected six numbers", "stdin"});
    const auto& c = query.counters();
    if (c.nothing > 0) say(fmt::format("luxdeck: {} points are seen by no vertex near them: answered by nan\n", c.nothing));
    return query.badLine() ? Exit::BadInput : Exit::Ok;
}

}  // namespace

FieldSettings FieldOptions::field() const {
    auto out = settings;
    if (out.order == 0) out.blendBins = false;  // radiance blended between bins would light surfaces otherwise than the volume does
    if (thesis) out.quadrature = Quadrature::Midpoint, out.blendBins = false;
    return out;
}

const std::map<std::string, LightPart>& lightParts() {
    static const std::map<std::string, LightPart> parts{{"total", LightPart::Total}, {"direct", LightPart::Direct}, {"indirect", LightPart::Indirect}};
    return parts;
}

void addFieldOptions(CLI::App& app, FieldOptions& o) {
    o.settings.blendBins = true;
    app.add_option("--moment", o.settings.order, "Order of the moment: 1 is irradiance in lx, more is narrower, 0 is radiance in cd/m²")
        ->check(CLI::Range(0, 1000000))->capture_default_str();
    app.add_option_function<std::string>("--part", [&o](const std::string& name) { o.settings.part = lightParts().at(name); },
        "Light straight from sources, reflected light, or both: total (the default), direct, indirect")->check(CLI::IsMember({"total", "direct", "indirect"}))->type_name("PART");
    app.add_flag("--thesis", o.thesis, "As Greger 1996 did it: the nearest bin, integrated at bin centres");
    app.add_option_function<int>("--harmonics", [&o](int degree) { o.settings.basis = Basis::Harmonics, o.settings.degree = degree; },
        "Spherical harmonics of this degree instead of bins, 0 .. 8")->check(CLI::Range(0, 8))->type_name("DEGREE");
}

Command addVolumeQuery(CLI::App& volume) {
    const auto o = std::make_shared<Options>();
    auto* app = volume.add_subcommand("query", "Light from a volume: reads `x y z dx dy dz` a line (m; a surface facing dx dy dz), answers `R G B Y` a line in lx. "
        "A line that is not six numbers is answered by nan (exit status 3 at the end). Without --scene interpolation knows of no walls (the thesis' way)");
    app->add_option("volume", o->volume, "The volume")->required()->type_name("F.vtu");
    app->add_option("--scene", o->scene, "The project or scene that the volume is of: points take nothing from vertices that a wall hides from them")->type_name("PROJECT");
    addFieldOptions(*app, o->field);
    return {app, [o](Context& context) { return runQuery(*o, context); }};
}

}  // namespace luxdeck::cli
