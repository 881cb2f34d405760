#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/io/ies_labels.h"
#include "engine/io/photometry_text.h"
#include "engine/scene/candela_table.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace luxdeck {

/// How a lamp's output depends on the tilt of its luminaire (LM-63's TILT); linear between the angles, constant beyond.
struct LampTilt {
    std::vector<double> degrees;   ///< of the luminaire from straight down, strictly increasing; none: no dependence
    std::vector<double> factors;   ///< one for each, >= 0

    /// frame  of the placed luminaire
    [[nodiscard]] double factor(const Frame& frame) const;
};

/// The TILT table of an IES LM-63 file; none where it has none. Its photometry is not looked at.
///
/// name  resolves a TILT file beside it
Result<LampTilt> readLampTilt(std::string_view bytes, const std::filesystem::path& name);

namespace photometry {

/// The table from TILT=INCLUDE, or from the file that TILT names, folders ignored, so a photometric file cannot make us
/// read elsewhere. What is missing or depends on the tilt is told among the warnings. Leaves `tokens` behind it.
Result<LampTilt> readTilt(const Labels& labels, const std::filesystem::path& name, TokenReader& tokens, Photometry& p);

}  // namespace photometry

}  // namespace luxdeck
