#include "engine/io/rad_material_table.h"

#include "engine/io/pattern_radiance.h"
#include "engine/io/rad_material.h"
#include "engine/io/rad_sky.h"
#include "engine/io/xform.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>
#include <utility>

namespace luxdeck::rad {

namespace {

/// Patterns of a chain multiply.
class ProductPattern final : public Pattern {
public:
    explicit ProductPattern(std::vector<std::shared_ptr<const Pattern>> factors) : factors_(std::move(factors)) {}
    [[nodiscard]] Rgb value(const PatternPoint& at) const override {
        Rgb product(1.0F);
        for (const auto& factor : factors_) product *= factor->value(at);
        return product;
    }
    [[nodiscard]] std::string identity() const override {
        std::string text = "product";
        for (const auto& factor : factors_) {
            const auto one = factor->identity();
            text += fmt::format(" {}:{}", one.size(), one);
        }
        return text;
    }

private:
    std::vector<std::shared_ptr<const Pattern>> factors_;
};

/// Equal exactly when two materials are: what they say and what modifies them.
std::string contentKey(const Primitive& p, const std::vector<int>& patterns) {
    std::string key = fmt::format("{} {}", p.type, p.name);
    for (const auto& s : p.strings) key += fmt::format(" {}:{}", s.size(), s);
    for (const double x : p.numbers) key += fmt::format(" {}", x);
    for (const int i : patterns) key += fmt::format(" @{}", i);
    return key;
}

std::filesystem::path folderOf(const Place& place) {
    const std::filesystem::path file(*place.file);
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

std::int32_t MaterialTable::store(std::shared_ptr<const Pattern> pattern) {
    const auto at = std::find(scene_.patterns.begin(), scene_.patterns.end(), pattern);
    if (at != scene_.patterns.end()) return static_cast<std::int32_t>(at - scene_.patterns.begin());
    scene_.patterns.push_back(std::move(pattern));
    return static_cast<std::int32_t>(scene_.patterns.size() - 1);
}

Result<std::shared_ptr<const Pattern>> MaterialTable::pattern(int index) {
    using Shared = std::shared_ptr<const Pattern>;
    if (const auto known = patterns_.find(index); known != patterns_.end()) return known->second;
    const auto& p = modifiers_[index];
    const auto kind = patternKind(p.type);
    Shared made;
    if (p.sky) {
        made = patternOf(*p.sky, space_.toScene);
    } else if (!kind) {
        warnings_.add("pattern " + p.type, fmt::format("{}: the pattern {} {} is not read: taken as 1", p.place.text(), p.type, p.name));
    } else {
        const auto first = firstTransformArgument(*kind, p.strings);
        const auto begin = p.strings.begin(), end = begin + static_cast<std::ptrdiff_t>(first);
        std::size_t used = 0;
        const auto xform = parseXform(std::span(p.strings).subspan(first), used);
        if (!xform) return p.place.error(xform.error().code, xform.error().message);
        auto pattern = makePattern(*kind, {{begin, end}, p.numbers, folderOf(p.place), xform->matrix * space_.toScene, p.place.text()}, library_);
        if (!pattern) return pattern.error().where.empty() ? p.place.error(pattern.error().code, pattern.error().message) : pattern.error();
        made = *std::move(pattern);
    }
    patterns_.emplace(index, made);
    return made;
}

Result<std::shared_ptr<const Pattern>> MaterialTable::factor(const std::vector<int>& patterns, const std::shared_ptr<const Pattern>& cone) {
    std::vector<std::shared_ptr<const Pattern>> factors;
    if (cone) factors.push_back(cone);
    for (const int index : patterns) {
        auto one = pattern(index);
        if (!one) return one.error();
        if (*one) factors.push_back(*std::move(one));
    }
    if (factors.empty()) return std::shared_ptr<const Pattern>();
    if (factors.size() == 1) return factors.front();
    return std::shared_ptr<const Pattern>(std::make_shared<const ProductPattern>(std::move(factors)));
}

Result<std::uint32_t> MaterialTable::addPlain(const Modifiers::Chain& chain) {
    const auto& p = *chain.material;
    auto mapped = mapMaterial(p, space_.metresPerUnit, space_.toScene, warnings_);
    if (!mapped) return mapped.error();
    auto& m = mapped->material;
    const auto product = factor(chain.patterns, mapped->cone);
    if (!product) return product.error();
    if (*product) {
        const bool solid = m.kind == MaterialKind::ThinGlass || m.kind == MaterialKind::Dielectric;
        if (solid) warnings_.add("pattern on " + p.type, fmt::format("{}: the pattern on {} {} is left out: it would have to vary what passes through", p.place.text(), p.type, p.name));
        else (m.emits() ? m.emissionPattern : m.reflectancePattern) = store(*product);
    }
    scene_.materials.push_back(std::move(m));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t MaterialTable::clear() {
    if (clear_) return *clear_;
    Material m;  // a pane of air: all light passes, none is turned or reflected
    m.name = "void";
    m.kind = MaterialKind::ThinGlass;
    m.ior = 1;
    m.transmittance = Rgb(1.0F);
    scene_.materials.push_back(std::move(m));
    clear_ = static_cast<std::uint32_t>(scene_.materials.size() - 1);
    return *clear_;
}

Result<std::uint32_t> MaterialTable::mixedMaterial(int modifier, const Primitive& mixture) {
    const auto found = find(modifier);
    if (!found) return found.error();
    if (!*found) return clear();
    if (scene_.materials[**found].kind == MaterialKind::Mix)
        return mixture.place.error(ErrorCode::Unsupported, fmt::format("{} {} mixes a mixture, expected materials", mixture.type, mixture.name));
    return **found;
}

Result<std::uint32_t> MaterialTable::addMixture(const Modifiers::Chain& chain) {
    const auto& p = *chain.material;
    if (!patternKind(p.type)) return p.place.error(ErrorCode::Unsupported, fmt::format("the mixture {} {} is not read, expected mixfunc, mixdata or mixpict", p.type, p.name));
    if (!chain.patterns.empty()) warnings_.add("pattern on mixture", fmt::format("{}: the patterns on the mixture {} are left out", p.place.text(), p.name));
    const auto& mixed = modifiers_.mixed(chain.materialIndex);
    const auto first = mixedMaterial(mixed[0], p);
    if (!first) return first.error();
    const auto second = mixedMaterial(mixed[1], p);
    if (!second) return second.error();
    const auto fraction = pattern(chain.materialIndex);
    if (!fraction) return fraction.error();
    Material m;
    m.name = p.name;
    m.kind = MaterialKind::Mix;
    m.mixFirst = *first, m.mixSecond = *second;
    m.mixPattern = store(*fraction);
    m.source = fmt::format("{} of {}", p.type, p.place.text());
    scene_.materials.push_back(std::move(m));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

Result<std::optional<std::uint32_t>> MaterialTable::find(int modifier) {
    using Found = std::optional<std::uint32_t>;
    if (const auto known = byModifier_.find(modifier); known != byModifier_.end()) return known->second;
    const auto chain = modifiers_.chain(modifier);
    Found found;
    if (chain.material != nullptr) {
        const bool mixture = isMixture(chain.material->type);
        const auto key = mixture ? fmt::format("mixture {}", chain.materialIndex) : contentKey(*chain.material, chain.patterns);
        if (const auto same = byContent_.find(key); same != byContent_.end()) {
            found = same->second;
        } else {
            const auto added = mixture ? addMixture(chain) : addPlain(chain);
            if (!added) return added.error();
            byContent_.emplace(key, *added);
            found = *added;
        }
    }
    byModifier_.emplace(modifier, found);
    return found;
}

}  // namespace luxdeck::rad
