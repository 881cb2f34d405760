#pragma once

#include "engine/scene/candela_table.h"

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::photometry {

/// The text of an LM-63 file up to its TILT= line.
struct Labels {
    int year = 1986;                            // edition whose rules apply
    std::string format;                         // "LM-63-2002"
    std::map<std::string, std::string> values;  // by upper-case keyword without brackets
    std::string freeText;                       // first label without a keyword (1986)
    std::size_t tiltLine = 0;                   // index into the lines
    std::string tilt;                           // what follows TILT=, trimmed
};

/// Reads the edition and the labels; an unknown edition is read by the rules of 1986, with a warning.
///
/// errors  Parse: no TILT= line
Result<Labels> readLabels(const std::vector<std::string_view>& lines, const std::filesystem::path& name,
                          Photometry& photometry);

/// The value of the first of these keywords that has one; else empty.
std::string firstOf(const Labels& labels, std::initializer_list<const char*> keys);

}  // namespace luxdeck::photometry
