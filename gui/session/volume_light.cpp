#include "gui/session/volume_light.h"

#include "engine/core/parallel.h"
#include "engine/volume/visible_lookup.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace luxdeck::gui {

namespace {

/// Lamps and their bins outshine everything else: so much of the values may lie beyond the range. Radiance is seen as it is,
/// irradiance and moments spread it.
double brightPart(int order) { return order == 0 ? 0.05 : 0.01; }

Result<LightSpheres> makeSpheres(std::shared_ptr<const IrradianceVolume> volume, LightPart part, int order) {
    FieldSettings settings;
    settings.part = part, settings.order = order;
    const auto field = VolumeField::make(*volume, settings);
    if (!field) return field.error();
    const std::size_t bins = volume->binCount();
    std::vector<VolumeField::Look> looks;
    for (std::size_t bin = 0; bin < bins; ++bin) looks.push_back(field->look(volume->bins().centre(static_cast<int>(bin))));
    LightSpheres out{volume, std::vector<float>(volume->vertexCount() * bins), 0, 0};
    parallelFor(volume->vertexCount(), [&](std::size_t v) {
        for (std::size_t bin = 0; bin < bins; ++bin)
            out.values[v * bins + bin] = luminance(field->atVertex(static_cast<std::uint32_t>(v), looks[bin]), volume->weights);
    });
    std::vector<float> shown;
    for (std::size_t v = 0; v < volume->vertexCount(); ++v)
        if (volume->quality[v].usable()) shown.insert(shown.end(), &out.values[v * bins], &out.values[v * bins] + bins);
    if (shown.empty()) return out;
    const auto bright = shown.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(shown.size() - 1) * (1 - brightPart(order)));
    std::nth_element(shown.begin(), bright, shown.end());
    out.high = *bright;
    out.low = *std::min_element(shown.begin(), shown.end());
    return out;
}

Result<LightField> makeField(std::shared_ptr<const IrradianceVolume> volume, std::shared_ptr<const LitProject> room, LightPart part) {
    FieldSettings settings;
    settings.part = part, settings.blendBins = true;
    auto field = VolumeField::make(*volume, settings);
    if (!field) return field.error();
    return LightField{std::move(volume), std::move(room), *std::move(field)};
}

LightSamples makeSamples(const LightField& field, const SampleGrid& grid, const Vec3& facing) {
    LightSamples out{grid, facing, std::vector<float>(grid.size())};
    std::vector<Vec3> positions;
    positions.reserve(grid.size());
    for (int z = 0; z < grid.counts[2]; ++z)
        for (int y = 0; y < grid.counts[1]; ++y)
            for (int x = 0; x < grid.counts[0]; ++x) positions.push_back(grid.at(x, y, z));
    field.illuminance(positions, facing, out.lux);
    // The field goes on beyond its lattice as it was at the edge: there nothing is known.
    const Box3& bounds = field.volume->lattice.bounds();
    const float hair = 1e-5F * bounds.size().length();
    for (std::size_t i = 0; i < positions.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            if (positions[i][axis] < bounds.min[axis] - hair || positions[i][axis] > bounds.max[axis] + hair) out.lux[i] = std::numeric_limits<float>::quiet_NaN();
    return out;
}

}  // namespace

void LightField::illuminance(std::span<const Vec3> positions, const Vec3& facing, std::span<float> values) const {
    constexpr std::size_t kBatch = 256;
    parallelFor((positions.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
        const auto first = batch * kBatch, count = std::min(kBatch, positions.size() - first);
        const auto some = positions.subspan(first, count);
        const std::vector<Vec3> directions(count, facing);
        std::vector<Rgb> lux(count);
        if (room) VisibleLookup(field, room->lit.raycaster()).at(some, directions, {}, lux);
        else field.at(some, directions, lux);
        for (std::size_t i = 0; i < count; ++i) values[first + i] = luminance(lux[i], volume->weights);
    });
}

template <class T>
std::shared_ptr<const T> VolumeLight::get(Recent<T>& recent, const Key& key, std::function<Result<T>()> make) const {
    auto& made = recent.made;
    const auto at = std::find_if(made.begin(), made.end(), [&](const auto& m) { return m.first == key; });
    if (at != made.end()) {
        std::rotate(made.begin(), at, at + 1);
        return made.front().second;
    }
    if (making_) return nullptr;  // who still wants it then asks again
    making_ = true;
    place_.jobs.start(JobKind::Look, "Light of the volume", [this, &recent, key, make = std::move(make)](const Progress&, const Jobs::Tell&) -> Jobs::Delivery {
        auto result = std::make_shared<Result<T>>(make());
        return [this, &recent, key, result] {
            making_ = false;
            recent.made.insert(recent.made.begin(), {key, *result ? std::make_shared<const T>(*std::move(*result)) : nullptr});
            if (recent.made.size() > Recent<T>::kMost) recent.made.pop_back();
            if (!*result) place_.complain(result->error());
            place_.tell(Change::Volumes);
        };
    });
    return nullptr;
}

std::shared_ptr<const LightField> VolumeLight::field(const VolumeState& volume, LightPart part) const {
    return get<LightField>(fields_, {volume.volume, part}, [v = volume.volume, room = volume.of, part] { return makeField(v, room, part); });
}

std::shared_ptr<const LightSpheres> VolumeLight::spheres(const VolumeState& volume, LightPart part, int order) const {
    return get<LightSpheres>(spheres_, {volume.volume, part, order}, [v = volume.volume, part, order] { return makeSpheres(v, part, order); });
}

std::shared_ptr<const LightSamples> VolumeLight::samples(const VolumeState& volume, LightPart part, const SampleGrid& grid, const Vec3& facing) const {
    const auto source = field(volume, part);
    if (!source) return nullptr;
    return get<LightSamples>(samples_, {volume.volume, part, 1, grid, facing}, [source, grid, facing]() -> Result<LightSamples> { return makeSamples(*source, grid, facing); });
}

std::shared_ptr<const InterpolationError> VolumeLight::interpolation(const VolumeState& volume) const {
    if (interpolation_.first != volume.volume) interpolation_ = {volume.volume, std::make_shared<const InterpolationError>(*volume.volume)};
    return interpolation_.second;
}

void VolumeLight::clear() {
    making_ = false;
    interpolation_ = {};
    fields_.made.clear();
    spheres_.made.clear();
    samples_.made.clear();
}

}  // namespace luxdeck::gui
