#include "engine/io/toml_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace luxdeck {

namespace {

std::string quoted(std::string_view value) {
    std::string out = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') out += fmt::format("\\{}", c);
        else if (c == '\n') out += "\\n";
        else if (c == '\t') out += "\\t";
        else if (c == '\r') out += "\\r";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else out += c;
    }
    return out + '"';
}

/// A whole number is written as people do, without a point; beyond 2^53 it would not be an integer that TOML knows.
std::string number(double value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    if (value == 0) return "0";
    if (value == std::round(value) && std::abs(value) < 9e15) return fmt::format("{:.0f}", value);
    auto text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

template <class Values>
std::string list(const Values& values) {
    std::string out;
    for (const auto& value : values) out += (out.empty() ? "" : ", ") + TomlValue(value).text();
    return "[" + out + "]";
}

}  // namespace

TomlValue::TomlValue(double value) : text_(number(value)) {}
TomlValue::TomlValue(std::string_view value) : text_(quoted(value)) {}
TomlValue::TomlValue(const Vec3d& value) : text_(list(std::vector<double>{value.x, value.y, value.z})) {}
TomlValue::TomlValue(const std::vector<double>& values) : text_(list(values)) {}
TomlValue::TomlValue(const std::vector<int>& values) : text_(list(values)) {}
TomlValue::TomlValue(const std::vector<std::string>& values) : text_(list(values)) {}
TomlValue::TomlValue(const std::vector<std::vector<double>>& rows) : text_(list(rows)) {}

TomlValue::TomlValue(const std::vector<std::pair<std::string, TomlValue>>& entries) {
    std::string out;
    for (const auto& [key, value] : entries) out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", tomlKey(key), value.text());
    text_ = out.empty() ? "{}" : "{ " + out + " }";
}

std::string tomlKey(std::string_view key) {
    const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '_' || c == '-'); });
    return bare ? std::string(key) : quoted(key);
}

}  // namespace luxdeck
