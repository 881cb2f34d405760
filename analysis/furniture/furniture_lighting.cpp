#include "analysis/furniture/furniture_lighting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck {

namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
constexpr float kQuantile = 1.96F;
// Beyond this part hidden by the object itself, a vertex is covered by a part that lies on it.
constexpr float kCovered = 0.97F;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

bool isKnown(const Rgb& lux) { return !std::isnan(lux.r); }

}  // namespace

const char* verdictText(FurnitureVerdict verdict) {
    switch (verdict) {
        case FurnitureVerdict::Met: return "met";
        case FurnitureVerdict::Under: return "too little light";
        case FurnitureVerdict::Over: return "too much light";
        case FurnitureVerdict::Undecided: return "undecided";
        case FurnitureVerdict::None: break;
    }
    return "";
}

Result<std::unique_ptr<FurnitureLighting>> FurnitureLighting::create(const MovableObject& object, const IrradianceVolume& volume, const Raycaster* room) {
    FieldSettings settings;
    settings.blendBins = true;
    auto field = VolumeField::make(volume, settings);
    if (!field) return field.error();
    auto rays = ObjectRays::create(object);
    if (!rays) return rays.error();
    return std::unique_ptr<FurnitureLighting>(new FurnitureLighting(object, volume, room, *std::move(field), *std::move(rays)));
}

FurnitureLighting::FurnitureLighting(const MovableObject& object, const IrradianceVolume& volume, const Raycaster* room, VolumeField field, ObjectRays rays)
    : object_(&object), volume_(&volume), field_(std::move(field)), rays_(std::move(rays)), shade_(object, rays_), interpolation_(volume), lookup_(volume, room) {
    const std::size_t count = object.positions.size();
    lux_.resize(count), open_.resize(count), halfWidths_.resize(count), blends_.resize(count);
    slots_.assign(volume.vertexCount(), kNone);
    meanWeights_.assign(volume.vertexCount(), 0);
    variances_.resize(volume.vertexCount());
    for (std::size_t v = 0; v < volume.vertexCount(); ++v) {
        const auto& q = volume.quality[v];
        const float n = static_cast<float>(q.samples);
        for (std::size_t axis = 0; axis < 6; ++axis)
            variances_[v][axis] = q.samples > 1 ? q.spread[axis] / (n * (n - 1)) : std::numeric_limits<float>::infinity();
    }
    place_.cosine = 2;  // of no turn: the first update() is one
}

/// What depends on how the object is turned, and not on where it stands.
void FurnitureLighting::turn(const Placement& place) {
    const bool turned = place.cosine != place_.cosine || place.sine != place_.sine;
    place_ = place;
    if (!turned) return;
    const auto bins = volume_->bins();
    for (std::size_t v = 0; v < blends_.size(); ++v) blends_[v] = bins.blend(place.direction(object_->normals[v]));
    const DirectionBins own(SelfShade::kSide);
    ownBin_.resize(volume_->binCount());
    perBin_.fill(0);
    for (std::size_t bin = 0; bin < ownBin_.size(); ++bin) {
        ownBin_[bin] = static_cast<std::uint8_t>(own.binOf(place.back(bins.centre(static_cast<int>(bin)))));
        ++perBin_[ownBin_[bin]];
    }
    for (auto& n : perBin_) n = n > 0 ? 1 / n : 0;
    std::fill(slots_.begin(), slots_.end(), kNone);
    radiance_.clear();
}

void FurnitureLighting::place(const DetailLevel& level) {
    positions_.resize(level.shown.size()), normals_.resize(level.shown.size());
    for (std::size_t i = 0; i < level.shown.size(); ++i) {
        positions_[i] = place_.point(object_->positions[level.shown[i]]);
        normals_[i] = place_.direction(object_->normals[level.shown[i]]);
    }
}

/// Mean luminance of the directions of each of the object's bins, as a vertex of the volume sees it.
const float* FurnitureLighting::vertexRadiance(std::uint32_t latticeVertex) {
    constexpr std::size_t kBins = SelfShade::kBins;
    if (slots_[latticeVertex] == kNone) {
        slots_[latticeVertex] = static_cast<std::uint32_t>(radiance_.size() / kBins);
        radiance_.resize(radiance_.size() + kBins, 0.0F);
        float* row = radiance_.data() + radiance_.size() - kBins;
        const auto direct = volume_->directAt(latticeVertex), indirect = volume_->indirectAt(latticeVertex);
        for (std::size_t bin = 0; bin < direct.size(); ++bin) row[ownBin_[bin]] += luminance(direct[bin] + indirect[bin], volume_->weights);
        const auto bins = volume_->bins();
        const auto perSr = static_cast<float>(1 / bins.solidAngleSr());
        for (const auto& source : volume_->sources[latticeVertex])
            row[ownBin_[static_cast<std::size_t>(bins.binOf(source.direction.normalized()))]] += luminance(source.lux, volume_->weights) * perSr;
        for (std::size_t bin = 0; bin < kBins; ++bin) row[bin] *= perBin_[bin];
    }
    return radiance_.data() + slots_[latticeVertex] * kBins;
}

/// The same where a group of vertices is: shared by all of them.
std::span<const float> FurnitureLighting::groupRadiance(std::uint32_t group, const GroupLookup::Corners& corners) {
    constexpr std::size_t kBins = SelfShade::kBins;
    if (groupSlots_[group] == kNone) {
        groupSlots_[group] = static_cast<std::uint32_t>(groupRadiance_.size() / kBins);
        groupRadiance_.resize(groupRadiance_.size() + kBins, 0.0F);
        for (std::size_t c = 0; c < 8; ++c) {
            if (corners.weights[c] == 0) continue;
            const float* from = vertexRadiance(corners.vertices[c]);
            float* to = groupRadiance_.data() + groupRadiance_.size() - kBins;
            for (std::size_t bin = 0; bin < kBins; ++bin) to[bin] += corners.weights[c] * from[bin];
        }
    }
    return {groupRadiance_.data() + groupSlots_[group] * kBins, kBins};
}

/// Part of the irradiance that comes from where the object does not hide the world.
float FurnitureLighting::openPart(const SelfShade::Row& row, std::span<const float> radiance) const {
    float all = 0, hidden = 0;
    for (std::size_t bin = 0; bin < radiance.size(); ++bin) {
        all += radiance[bin] * static_cast<float>(row.all[bin]);
        hidden += radiance[bin] * static_cast<float>(row.hidden[bin]);
    }
    return all > 0 ? 1 - hidden / all : 1 - row.hiddenPart;
}

void FurnitureLighting::lightVertices(const DetailLevel& level) {
    groupSlots_.assign(lookup_.groupCount(), kNone);
    groupRadiance_.clear();
    for (std::size_t i = 0; i < level.shown.size(); ++i) {
        const auto v = level.shown[i];
        const auto corners = lookup_.weights(i);
        if (!corners.known) {
            open_[v] = Rgb(kUnknown), halfWidths_[v] = kUnknown;
            continue;
        }
        Rgb lux;
        float noise2 = 0;
        for (std::size_t c = 0; c < 8; ++c) {
            const float w = corners.weights[c];
            if (w == 0) continue;
            lux += field_.atVertex(corners.vertices[c], blends_[v]) * w;
            noise2 += w * w * variance(corners.vertices[c], normals_[i]);
        }
        const float between = interpolation_.halfWidth(lookup_.cell(i), normals_[i]);
        float width2 = kQuantile * kQuantile * noise2 + between * between;
        if (const auto* row = shade_.row(v)) {
            const auto group = lookup_.group(i);
            const float open = openPart(*row, groupRadiance(group, groupSlots_[group] == kNone ? lookup_.weights(lookup_.representative(group)) : corners));
            // The rays' own noise, as if they were not stratified.
            const float shading = kQuantile * luminance(lux, volume_->weights) * std::sqrt(open * (1 - open) / static_cast<float>(SelfShade::kRays));
            lux *= open;
            width2 = open > 0 ? width2 * open * open + shading * shading : 0;
        }
        open_[v] = lux, halfWidths_[v] = std::sqrt(width2);
    }
}

/// What a vertex sees of the object instead of the world, lit as that is.
void FurnitureLighting::reflectWithin(const DetailLevel& level) {
    for (const auto v : level.shown) {
        lux_[v] = open_[v];
        const auto* row = shade_.row(v);
        if (row == nullptr || !isKnown(open_[v])) continue;
        Rgb seen;
        for (std::size_t k = 0; k < row->linkCount; ++k) {
            const auto from = row->links[k];
            if (from != SelfShade::kOpen && isKnown(open_[from])) seen += open_[from] * object_->reflectance[from];
        }
        lux_[v] += seen * (row->hiddenPart / static_cast<float>(row->linkCount));
    }
}

void FurnitureLighting::update(const Pose& pose, std::size_t level) {
    level_ = std::min(level, object_->levels.size() - 1);
    const auto& detail = object_->levels[level_];
    const auto spread = [&](auto& values) {
        if (level_ > 0)
            for (std::size_t v = 0; v < values.size(); ++v) values[v] = values[detail.shown[detail.standsFor[v]]];
    };
    turn(object_->placed(pose));
    place(detail);
    lookup_.find(positions_, normals_);
    lightVertices(detail);
    spread(open_), spread(halfWidths_);
    reflectWithin(detail);
    spread(lux_);
}

void FurnitureLighting::addToMean(std::size_t shown, double area) {
    const auto corners = lookup_.weights(shown);
    for (std::size_t c = 0; c < 8; ++c) {
        auto& sum = meanWeights_[corners.vertices[c]];
        if (sum == 0) touched_.push_back(corners.vertices[c]);
        sum += area * corners.weights[c];
    }
}

/// Vertices of the object share those of the volume, and their noise with them.
double FurnitureLighting::varianceOfMean(double knownM2) {
    double sum = 0;
    for (const auto v : touched_) {
        const double w = std::exchange(meanWeights_[v], 0.0) / knownM2;
        if (w > 0) sum += w * w * variance(v, {0, 0, 1});
    }
    touched_.clear();
    return sum;
}

WorkingSurfaceLight FurnitureLighting::workingSurface(const LightRequirement& requirement) {
    const auto& level = object_->levels[level_];
    areas_.assign(level.shown.size(), 0);
    double area = 0;
    for (std::size_t v = 0; v < level.standsFor.size(); ++v) {
        const auto* row = shade_.row(static_cast<std::uint32_t>(v));
        if (row != nullptr && row->hiddenPart > kCovered) continue;
        areas_[level.standsFor[v]] += object_->workingAreaM2[v], area += object_->workingAreaM2[v];
    }
    WorkingSurfaceLight out;
    double known = 0, sum = 0, between = 0;
    out.minimum.value = std::numeric_limits<double>::infinity(), out.maximum.value = -out.minimum.value;
    for (std::size_t i = 0; i < level.shown.size(); ++i) {
        const auto v = level.shown[i];
        if (areas_[i] == 0 || !isKnown(lux_[v])) continue;
        const double y = luminance(lux_[v], volume_->weights);
        known += areas_[i], sum += areas_[i] * y, between += areas_[i] * interpolation_.halfWidth(lookup_.cell(i), normals_[i]);
        addToMean(i, areas_[i]);
        if (y < out.minimum.value) out.minimum = {y, halfWidths_[v]}, out.minimumAt = positions_[i];
        if (y > out.maximum.value) out.maximum = {y, halfWidths_[v]}, out.maximumAt = positions_[i];
    }
    out.unknownPart = area > 0 ? std::clamp(1 - known / area, 0.0, 1.0) : 1;
    if (out.unknownPart < 1e-5) out.unknownPart = 0;  // sums of floats
    if (known == 0) {
        out.minimum = out.maximum = out.mean = {0, std::numeric_limits<double>::infinity()};
        return out;
    }
    // Interpolation errs the same way across a cell: not averaged out.
    out.mean = {sum / known, std::hypot(kQuantile * std::sqrt(varianceOfMean(known)), between / known)};
    const auto& [least, limit] = requirement;
    if (!least && !limit) return out;
    if (least && out.mean.high() < *least) out.verdict = FurnitureVerdict::Under;
    else if (limit && out.maximum.low() > *limit) out.verdict = FurnitureVerdict::Over;
    else if ((!least || out.mean.low() >= *least) && (!limit || out.maximum.high() <= *limit) && out.unknownPart <= 0.5) out.verdict = FurnitureVerdict::Met;
    else out.verdict = FurnitureVerdict::Undecided;  // also where an interval is not known
    return out;
}

}  // namespace luxdeck
