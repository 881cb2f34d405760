#pragma once

#include "engine/core/result.h"
#include "engine/io/obj_material.h"

#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::obj {

/// The records of an MTL file. Keys that say nothing of light are passed over; others that are not read
/// give a warning.
///
/// name    what messages call the file
/// errors  Parse: file:line, a number that is none
Result<std::vector<MtlRecord>> parseMtl(std::string_view text, const std::string& name, WarningList& warnings);

}  // namespace luxdeck::obj
