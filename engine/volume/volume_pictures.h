#pragma once

#include "engine/core/image.h"
#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/io/panorama_nodes.h"
#include "engine/volume/volume.h"

namespace luxdeck {

/// A volume of a place that is known from pictures alone (thesis 5.3): each node's panorama becomes the sphere of a vertex.
/// The nodes must form a regular grid; along an axis where all have the same coordinate the light is taken to be the same
/// half a metre to either side. Every pixel counts in the bin it lies in, so that no lamp is missed; directions without a
/// pixel have the default. A picture does not tell direct light from reflected: all of it is in the indirect part.
///
/// side    of the directional bins
/// errors  those of reading; InvalidArgument: nodes that form no regular grid, a picture whose sides are not those of a
///         panorama, pictures of different primaries; Cancelled
Result<IrradianceVolume> buildVolumeFromPictures(const PanoramaNodes& nodes, int side, const Progress& progress);

/// Radiance in bins from one picture, #B.
std::vector<Rgb> binsOfPanorama(const Image& picture, double lowestDeg, double highestDeg, double defaultCdM2, const DirectionBins& bins);

}  // namespace luxdeck
