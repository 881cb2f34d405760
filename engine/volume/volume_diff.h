#pragma once

#include "engine/core/result.h"
#include "engine/volume/field.h"
#include "engine/volume/volume.h"

namespace luxdeck {

/// How far two volumes' irradiances lie apart, over all directions of all vertices that both know.
struct FieldDifference {
    double rmsLux = 0, maxLux = 0;  // [lx]
    double rms = 0, p99 = 0, max = 0;  // relative to the first's rms irradiance [-]
    double noise = 0;               // what the noise of both explains of `rms` [-]; infinite when it is not known
    double meanFirst = 0, meanSecond = 0;  // mean irradiances [lx]
    std::size_t vertices = 0;       // that both know
};

struct VolumeDifferences {
    FieldDifference total, direct, indirect;
};

/// order   of the moment compared; 1 is irradiance
/// errors  InvalidArgument: another lattice or other bins, naming what differs
Result<VolumeDifferences> compareVolumes(const IrradianceVolume& first, const IrradianceVolume& second, int order = 1);

/// A volume that holds first - second, to be looked at: light may be negative in it.
///
/// errors  as compareVolumes()
Result<IrradianceVolume> volumeDifference(const IrradianceVolume& first, const IrradianceVolume& second);

}  // namespace luxdeck
