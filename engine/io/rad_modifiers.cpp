#include "engine/io/rad_modifiers.h"

#include "engine/io/rad_material.h"

#include <fmt/format.h>

#include <algorithm>

namespace luxdeck::rad {

bool isMixture(const std::string& type) { return type == "mixfunc" || type == "mixdata" || type == "mixpict" || type == "mixtext"; }

namespace {

bool isTexture(const std::string& type) { return type == "texfunc" || type == "texdata"; }

}  // namespace

Result<int> Modifiers::find(const std::string& name, const Place& place) const {
    if (name == "void") return kVoid;
    const auto at = names_.find(name);
    if (at != names_.end()) return at->second;
    return place.error(ErrorCode::Parse, fmt::format("the modifier '{}' is not defined before, expected one that is, or void", name.substr(0, 60)));
}

Result<void> Modifiers::add(const Primitive& p) {
    Known known{&p};
    if (p.type == "alias") {
        const auto reference = find(p.strings[0], p.place);
        if (!reference) return reference.error();
        if (p.modifier == "inherit" || p.modifier == p.strings[0] || *reference == kVoid) {
            names_[p.name] = *reference;
            return {};
        }
        known = known_[static_cast<std::size_t>(*reference)];
    }
    const auto modifier = find(p.modifier, p.place);
    if (!modifier) return modifier.error();
    known.modifier = *modifier;
    if (isMixture(p.type)) {
        if (p.strings.size() < 2) return p.place.error(ErrorCode::Parse, fmt::format("{} {} has {} string arguments, expected two modifiers first", p.type, p.name, p.strings.size()));
        for (std::size_t i = 0; i < 2; ++i) {
            const auto mixed = find(p.strings[i], p.place);
            if (!mixed) return mixed.error();
            known.mixed.push_back(*mixed);
        }
    }
    names_[p.name] = static_cast<int>(known_.size());
    known_.push_back(std::move(known));
    return {};
}

Modifiers::Chain Modifiers::chain(int modifier) const {
    Chain chain;
    for (int at = modifier; at != kVoid; at = known_[static_cast<std::size_t>(at)].modifier) {
        const auto& p = *known_[static_cast<std::size_t>(at)].primitive;
        if (isMaterial(p.type) || isMixture(p.type)) {
            if (chain.material == nullptr) chain.material = &p, chain.materialIndex = at;
        } else if (isTexture(p.type)) {
            chain.textures.push_back(&p);
        } else {
            chain.patterns.push_back(at);
        }
    }
    return chain;
}

}  // namespace luxdeck::rad
