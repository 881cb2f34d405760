#include "gui/session/probe.h"

#include "analysis/furniture/interpolation_error.h"
#include "engine/volume/group_lookup.h"
#include "gui/session/surface_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace luxdeck::gui {

namespace {

constexpr double kQuantile = 1.96;
constexpr double kAlike = 0.9;  // cosine: normals of the surface and the sensor
constexpr double kUnevenM = 0.15;  // calculation surfaces lie that far above what they stand for

/// Irradiance of surfaces at a point that face a direction, of one part, where the corners count as told.
double lux(const LightField& field, const GroupLookup::Corners& corners, const DirectionBins::Blend& blend) {
    Rgb sum;
    for (std::size_t i = 0; i < 8; ++i)
        if (corners.weights[i] > 0) sum += field.field.atVertex(corners.vertices[i], blend) * corners.weights[i];
    return luminance(sum, field.volume->weights);
}

/// Half-width (95 %) of the total at a point: noise of the vertices and what interpolation leaves out, as for furniture.
double halfWidth(const IrradianceVolume& volume, const InterpolationError& interpolation, const GroupLookup& lookup, const GroupLookup::Corners& corners, const Vec3& normal) {
    double variance = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        if (!(corners.weights[i] > 0)) continue;
        const auto& quality = volume.quality[corners.vertices[i]];
        std::array<float, 6> axes{};
        for (std::size_t axis = 0; axis < 6; ++axis)
            axes[axis] = quality.samples > 1 ? static_cast<float>(quality.variance(axis)) : std::numeric_limits<float>::infinity();
        variance += double{corners.weights[i]} * corners.weights[i] * alongAxes(axes, normal);
    }
    const double between = interpolation.halfWidth(lookup.cell(0), normal);
    return std::sqrt(kQuantile * kQuantile * variance + between * between);
}

void readVolume(const Session& session, const VolumeState& state, const Vec3& point, const Vec3& normal, ProbeReading& out) {
    const auto direct = session.volumeLight.field(state, LightPart::Direct);
    const auto indirect = session.volumeLight.field(state, LightPart::Indirect);
    if (!direct || !indirect) {
        out.why = "the volume's light is being prepared";
        return;
    }
    const auto& volume = *state.volume;
    if (!volume.lattice.bounds().intersects(point)) {
        out.why = "outside the volume";
        return;
    }
    GroupLookup lookup(volume, state.of ? &state.of->lit.raycaster() : nullptr);
    lookup.find({&point, 1}, {&normal, 1});
    const auto corners = lookup.weights(0);
    if (!corners.known) {
        out.why = "no vertex of the volume sees this place";
        return;
    }
    const auto blend = volume.bins().blend(normal);
    const double d = lux(*direct, corners, blend), i = lux(*indirect, corners, blend);
    const double half = halfWidth(volume, *session.volumeLight.interpolation(state), lookup, corners, normal);
    // How the error falls on the parts is not kept: each may hold all of it.
    out.total = {d + i, half}, out.direct = {d, half}, out.indirect = {i, half};
    out.old = !state.current;
    out.fromVolume = true;
}

/// The solved point nearest by, of surfaces that look the same way.
std::optional<ProbeReading::GridPoint> nearestPoint(const Session& session, LightPart part, const Vec3d& user, const Vec3d& normal) {
    const auto result = session.solving.result();
    if (!result) return std::nullopt;
    std::optional<ProbeReading::GridPoint> best;
    for (const auto& grid : result->grids) {
        const double reach = std::max({grid.spacingU, grid.spacingV, kUnevenM});
        for (const auto& point : grid.points) {
            const double distance = (point.position - user).length();
            if (distance > reach || (best && distance >= best->distanceM) || grid.kind != GridKind::Planar || point.normal.dot(normal) < kAlike) continue;
            best = ProbeReading::GridPoint{grid.name, lightOf(point, part), distance, !session.solving.current()};
        }
    }
    return best;
}

}  // namespace

ProbeReading probe(const Session& session, const ViewSettings& view, const Vec3d& point, const Vec3d& normal, std::optional<double> reflectance) {
    ProbeReading out;
    if (const auto* state = session.volumes.named(view.volume)) readVolume(session, *state, Vec3(point), Vec3(normal), out);
    else out.why = "no volume yet";
    if (session.project()) out.nearest = nearestPoint(session, view.part, point + session.project()->project.scene.origin, normal);
    if (out.fromVolume && reflectance) {
        const double scale = *reflectance / kPiD;
        out.luminance = Interval{out.total.value * scale, out.total.ci95 * scale};
    }
    return out;
}

std::string ProbeReading::text(const Units& units) const {
    const auto shown = [&](const Interval& lux) { return intervalText(units.illuminance(lux.value), units.illuminance(lux.ci95)) + " " + units.illuminanceUnit(); };
    std::string out;
    const auto add = [&](const std::string& more) { out += (out.empty() ? "" : "  ·  ") + more; };
    if (nearest) add(fmt::format("{}: {}{}", nearest->grid, shown(nearest->lux), nearest->old ? " (old)" : ""));
    if (!fromVolume) {
        if (!nearest) add("illuminance unknown: " + why);
        return out;
    }
    add(fmt::format("volume{}: {}, direct {}, indirect {}", old ? " (old)" : "", shown(total), units.illuminanceText(direct.value), units.illuminanceText(indirect.value)));
    if (luminance) add(fmt::format("luminance about {}, if matt", units.luminanceText(luminance->value)));
    return out;
}

}  // namespace luxdeck::gui
