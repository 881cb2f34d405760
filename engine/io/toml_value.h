#pragma once

#include "engine/core/vec.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace luxdeck {

/// A value as it is written in a TOML file. Numbers are written so that they read back as the same.
class TomlValue {
public:
    TomlValue(bool value) : text_(value ? "true" : "false") {}
    TomlValue(int value) : text_(std::to_string(value)) {}
    TomlValue(double value);
    TomlValue(const char* value) : TomlValue(std::string_view(value)) {}
    TomlValue(const std::string& value) : TomlValue(std::string_view(value)) {}
    TomlValue(std::string_view value);           ///< UTF-8
    TomlValue(const Vec3d& value);
    TomlValue(const std::vector<double>& values);
    TomlValue(const std::vector<int>& values);
    TomlValue(const std::vector<std::string>& values);
    TomlValue(const std::vector<std::vector<double>>& rows);
    /// An inline table.
    explicit TomlValue(const std::vector<std::pair<std::string, TomlValue>>& entries);

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A key as it is written: quoted where it must be.
std::string tomlKey(std::string_view key);

}  // namespace luxdeck
