#include "engine/io/pattern_expressions.h"

#include "engine/io/cal_failure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace luxdeck {

Error askedFor(Error error, const PatternSource& source) {
    if (error.where.empty() || error.where == source.where) error.where = source.where;
    else error.message += fmt::format(" (asked for by {})", source.where);
    return error;
}

Result<CompiledExpressions> compileExpressions(const std::string& functionFile,
                                               std::span<const std::shared_ptr<const cal::Module>> entries,
                                               const PatternSource& source, CalLibrary& library, bool material) {
    const auto frame = PatternFrame::create(source.toWorld, source.where);
    if (!frame) return frame.error();
    const auto file = library.functions(functionFile, source.folder);
    if (!file) return askedFor(file.error(), source);
    const cal::Bindings bindings{source.reals, frame->constants(), true, material};
    auto code = cal::compile({*file}, entries, bindings);
    if (!code) return askedFor(code.error(), source);
    return CompiledExpressions{*frame, *std::move(code), (*file)->hash()};
}

PatternPoint trialPoint() {
    PatternPoint at;
    at.position = {0.31, 0.47, 0.59};
    at.normal = Vec3(-0.36F, -0.48F, 0.8F);
    at.direction = Vec3(0.48F, 0.6F, -0.64F);
    at.distance = 1.7;
    return at;
}

Result<void> checkTrial(cal::Failure worst, const PatternSource& source) {
    if (worst == cal::Failure::None || worst == cal::Failure::NoValue) return {};
    return Error{ErrorCode::Parse,
                 fmt::format("an expression of the function file {} ({} real arguments are given)", cal::meaning(worst),
                             source.reals.size()),
                 source.where};
}

namespace {

class CompiledRayExpressions final : public RayExpressions {
public:
    explicit CompiledRayExpressions(CompiledExpressions expressions) : expressions_(std::move(expressions)) {}

    void evaluate(const PatternPoint& at, const Rgb& materialColour, std::span<double> values) const override {
        (void)evaluated(at, materialColour, values);
    }
    /// The worst failure.
    cal::Failure evaluated(const PatternPoint& at, const Rgb& materialColour, std::span<double> values) const {
        const cal::Inputs inputs = expressions_.frame.inputs(at, materialColour);
        cal::Evaluation evaluation(expressions_.code, inputs);
        auto worst = cal::Failure::None;
        for (std::size_t i = 0; i < std::min(values.size(), expressions_.code.entries.size()); ++i) {
            const auto value = evaluation.value(static_cast<std::uint32_t>(i));
            worst = std::max(worst, value.failure);
            values[i] = std::isfinite(value.number) ? value.number : std::numeric_limits<double>::quiet_NaN();
        }
        return worst;
    }
    [[nodiscard]] Vec3d toWorld(const Vec3d& local) const override { return expressions_.frame.toWorld(local); }

private:
    CompiledExpressions expressions_;
};

}  // namespace

Result<std::shared_ptr<const RayExpressions>> makeRayExpressions(std::span<const std::string> expressions,
                                                                 const std::string& functionFile,
                                                                 const PatternSource& source, CalLibrary& library) {
    std::vector<std::shared_ptr<const cal::Module>> entries;
    for (const auto& text : expressions) {
        auto module = cal::Module::expression("", {}, text, source.where);
        if (!module) return module.error();
        entries.push_back(*std::move(module));
    }
    auto compiled = compileExpressions(functionFile, entries, source, library, true);
    if (!compiled) return compiled.error();
    auto result = std::make_shared<CompiledRayExpressions>(*std::move(compiled));
    std::vector<double> values(expressions.size());
    if (auto ok = checkTrial(result->evaluated(trialPoint(), Rgb{0.5F}, values), source); !ok) return ok.error();
    return std::shared_ptr<const RayExpressions>(std::move(result));
}

}  // namespace luxdeck
