#include "gui/session/volume_estimate.h"

namespace luxdeck::gui {

Result<VolumeEstimate> estimateVolume(const Scene& scene, const VolumeSettings& settings) {
    const auto lattice = volumeLattice(scene, settings);
    if (!lattice) return lattice.error();
    VolumeEstimate out;
    out.vertices = lattice->vertices().size();
    out.bins = static_cast<std::size_t>(DirectionBins(settings.side).count());
    out.bytes = out.vertices * (out.bins * 2 * sizeof(Rgb) + sizeof(VertexQuality) + sizeof(Vec3)) + lattice->cells().size() * sizeof(Lattice::Cell);
    out.least = settings.refineBelow > 0;
    return out;
}

}  // namespace luxdeck::gui
