#include "engine/io/pattern_radiance.h"

#include "engine/io/cal_builtin.h"
#include "engine/io/cal_evaluate.h"
#include "engine/io/cal_functions.h"
#include "engine/io/pattern_data.h"
#include "engine/io/pattern_expressions.h"
#include "engine/io/pattern_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

using Entry = std::shared_ptr<const cal::Module>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Where a kind has what among its string arguments.
struct Layout {
    PatternKind kind;
    std::string_view type;
    std::size_t first = 0;         ///< of the functions or expressions; mixtures have two modifiers before
    std::size_t channels = 1;      ///< how many of them
    std::size_t data = 0;          ///< how many names of data or picture files follow
    bool picture = false;

    [[nodiscard]] std::size_t functionFile() const { return first + channels + data; }
    [[nodiscard]] bool procedural() const { return data == 0; }
    [[nodiscard]] bool mixture() const { return first == 2; }
};

constexpr std::array kLayouts{Layout{PatternKind::BrightFunc, "brightfunc", 0, 1, 0, false},
                              Layout{PatternKind::ColorFunc, "colorfunc", 0, 3, 0, false},
                              Layout{PatternKind::BrightData, "brightdata", 0, 1, 1, false},
                              Layout{PatternKind::ColorData, "colordata", 0, 3, 3, false},
                              Layout{PatternKind::ColorPict, "colorpict", 0, 3, 1, true},
                              Layout{PatternKind::MixFunc, "mixfunc", 2, 1, 0, false},
                              Layout{PatternKind::MixData, "mixdata", 2, 1, 1, false},
                              Layout{PatternKind::MixPict, "mixpict", 2, 1, 1, true}};

const Layout& layoutOf(PatternKind kind) {
    return *std::find_if(kLayouts.begin(), kLayouts.end(), [kind](const Layout& l) { return l.kind == kind; });
}

/// How many arguments a function of the file or the library takes; 0 for none of that name.
std::size_t parameterCount(const std::string& name, const cal::Module& file) {
    for (const cal::Module* module : {&file, cal::standardLibrary().get()})
        if (const auto* d = module->find(name); d != nullptr && d->isFunction()) return d->parameters.size();
    const int native = cal::nativeFunction(name);
    return native < 0 ? 0 : cal::nativeFunctions()[static_cast<std::size_t>(native)].leastArguments;
}

/// Any of Radiance's patterns: coordinates from expressions, data at these coordinates, functions of the data; or
/// expressions alone.
class RadiancePattern final : public Pattern {
public:
    struct Parts {
        Layout layout;
        CompiledExpressions expressions;  // coordinates first, if there is data; then channels
        std::vector<std::shared_ptr<const DataTable>> tables;
        std::shared_ptr<const PatternPicture> picture;
        std::array<bool, 3> ownChannel{};  // the function takes its own channel alone
        std::size_t coordinates = 0;
        std::string identity;
    };
    explicit RadiancePattern(Parts parts) : parts_(std::move(parts)) {}

    [[nodiscard]] Rgb value(const PatternPoint& at) const override {
        cal::Failure worst = cal::Failure::None;
        return value(at, worst);
    }
    Rgb value(const PatternPoint& at, cal::Failure& worst) const {
        const cal::Inputs inputs = parts_.expressions.frame.inputs(at, Rgb{1.0F});
        cal::Evaluation evaluation(parts_.expressions.code, inputs);
        std::array<double, 3> data{};
        const auto entry = [&](std::size_t index, std::span<const double> arguments) {
            const auto value = evaluation.value(static_cast<std::uint32_t>(index), arguments);
            worst = std::max(worst, value.failure);
            return value.number;
        };
        if (!parts_.layout.procedural()) {
            std::array<double, DataTable::kMostAxes> place{};
            for (std::size_t i = 0; i < parts_.coordinates; ++i) place[i] = entry(i, {});
            data = looked(place);
        }
        std::array<double, 3> result{};
        for (std::size_t c = 0; c < parts_.layout.channels; ++c) {
            const std::span<const double> all = data;
            const auto arguments = parts_.layout.procedural() ? all.first(0)
                                   : parts_.ownChannel[c]     ? all.subspan(c, 1)
                                                              : all;
            result[c] = limited(entry(parts_.coordinates + c, arguments));
        }
        if (parts_.layout.channels == 1) return Rgb{static_cast<float>(result[0])};
        return {static_cast<float>(result[0]), static_cast<float>(result[1]), static_cast<float>(result[2])};
    }

    [[nodiscard]] std::string identity() const override { return parts_.identity; }

private:
    [[nodiscard]] std::array<double, 3> looked(const std::array<double, DataTable::kMostAxes>& place) const {
        if (parts_.picture) {
            const Rgb c = parts_.picture->value(place[0], place[1]);
            return {c.r, c.g, c.b};
        }
        std::array<double, 3> result{};
        for (std::size_t i = 0; i < parts_.tables.size(); ++i) result[i] = parts_.tables[i]->value(place);
        return result;
    }
    [[nodiscard]] double limited(double value) const {
        if (parts_.layout.mixture()) return std::isnan(value) ? kNaN : std::clamp(value, 0.0, 1.0);
        return value >= 0 && value <= double(std::numeric_limits<float>::max()) ? value : kNaN;
    }

    Parts parts_;
};

std::string identityText(const RadiancePattern::Parts& parts, const PatternSource& source) {
    std::string text = fmt::format("{}|{}|{}|{}", parts.layout.type, fmt::join(source.strings, "\n"),
                                   fmt::join(source.reals, " "), parts.expressions.functionHash);
    for (const auto& table : parts.tables) text += "|" + table->hash();
    if (parts.picture) text += "|" + parts.picture->hash();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) text += fmt::format(" {}", source.toWorld[i][j]);
    return text;
}

Result<void> readData(RadiancePattern::Parts& parts, const PatternSource& source, CalLibrary& library) {
    const Layout& layout = parts.layout;
    for (std::size_t i = 0; i < layout.data; ++i) {
        const auto& name = source.strings[layout.first + layout.channels + i];
        if (layout.picture) {
            auto picture = library.picture(name, source.folder);
            if (!picture) return askedFor(picture.error(), source);
            parts.picture = *std::move(picture);
            parts.coordinates = 2;
            continue;
        }
        auto table = library.data(name, source.folder);
        if (!table) return askedFor(table.error(), source);
        if (i > 0 && (*table)->axes().size() != parts.coordinates)
            return Error{ErrorCode::InvalidArgument,
                         fmt::format("'{}' has {} dimensions, expected {} as the data before it", name,
                                     (*table)->axes().size(), parts.coordinates),
                         source.where};
        parts.coordinates = (*table)->axes().size();
        parts.tables.push_back(*std::move(table));
    }
    const std::size_t given = source.strings.size() - layout.functionFile() - 1;
    if (!layout.procedural() && given != parts.coordinates)
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("{} has {} variables for data of {} dimensions, expected as many", layout.type, given,
                                 parts.coordinates),
                     source.where};
    return {};
}

/// The expressions and calls that make the pattern, coordinates first.
Result<std::vector<Entry>> entriesOf(RadiancePattern::Parts& parts, const PatternSource& source, CalLibrary& library) {
    const Layout& layout = parts.layout;
    std::vector<Entry> entries;
    const auto expression = [&](const std::string& text) -> Result<void> {
        auto module = cal::Module::expression("", {}, text, source.where);
        if (!module) return module.error();
        entries.push_back(*std::move(module));
        return {};
    };
    for (std::size_t i = 0; i < parts.coordinates; ++i)
        if (auto ok = expression(source.strings[layout.functionFile() + 1 + i]); !ok) return ok.error();
    const auto file = library.functions(source.strings[layout.functionFile()], source.folder);
    if (!file) return askedFor(file.error(), source);
    for (std::size_t c = 0; c < layout.channels; ++c) {
        const auto& text = source.strings[layout.first + c];
        if (layout.procedural()) {
            if (auto ok = expression(text); !ok) return ok.error();
            continue;
        }
        const bool several = layout.channels == 3 || layout.picture;
        const std::size_t takes = parameterCount(text, **file);
        parts.ownChannel[c] = !several || (layout.channels == 3 && takes < 3);
        entries.push_back(cal::Module::call(text, parts.ownChannel[c] ? 1 : 3, source.where));
    }
    return entries;
}

}  // namespace

std::optional<PatternKind> patternKind(std::string_view type) {
    for (const auto& layout : kLayouts)
        if (layout.type == type) return layout.kind;
    return std::nullopt;
}

std::size_t firstTransformArgument(PatternKind kind, std::span<const std::string> strings) {
    const Layout& layout = layoutOf(kind);
    // The variables of data follow the function file; the first of them may itself begin with a minus.
    return firstTransformArgument(layout.functionFile() + (layout.picture ? 2 : layout.procedural() ? 0 : 1), strings);
}

std::size_t firstTransformArgument(std::size_t functionFile, std::span<const std::string> strings) {
    std::size_t at = std::min(functionFile + 1, strings.size());
    while (at < strings.size() && !strings[at].starts_with('-')) ++at;
    return at;
}

Result<std::shared_ptr<const Pattern>> makePattern(PatternKind kind, const PatternSource& source, CalLibrary& library) {
    const Layout& layout = layoutOf(kind);
    const std::size_t least = layout.functionFile() + 1 + (layout.picture ? 2 : layout.procedural() ? 0 : 1);
    if (source.strings.size() < least)
        return Error{
            ErrorCode::InvalidArgument,
            fmt::format("{} has {} string arguments, expected at least {}", layout.type, source.strings.size(), least),
            source.where};
    RadiancePattern::Parts parts;
    parts.layout = layout;
    if (auto ok = readData(parts, source, library); !ok) return ok.error();
    const auto entries = entriesOf(parts, source, library);
    if (!entries) return entries.error();
    auto expressions = compileExpressions(source.strings[layout.functionFile()], *entries, source, library, false);
    if (!expressions) return expressions.error();
    parts.expressions = *std::move(expressions);
    parts.identity = identityText(parts, source);
    auto pattern = std::make_shared<RadiancePattern>(std::move(parts));
    cal::Failure trial = cal::Failure::None;
    (void)pattern->value(trialPoint(), trial);
    if (auto ok = checkTrial(trial, source); !ok) return ok.error();
    return std::shared_ptr<const Pattern>(std::move(pattern));
}

}  // namespace luxdeck
