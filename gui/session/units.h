#pragma once

#include <optional>
#include <string>

namespace luxdeck::gui {

enum class LightUnit { Lux, Footcandle };
enum class LengthUnit { Metres, Feet };

/// What numbers are shown in. What is computed and kept is always lx, cd/m² and m.
struct Units {
    LightUnit light = LightUnit::Lux;
    LengthUnit length = LengthUnit::Metres;

    [[nodiscard]] double illuminance(double lux) const;
    [[nodiscard]] double lux(double shown) const;
    [[nodiscard]] double luminance(double cdM2) const;
    [[nodiscard]] double lengthOf(double metres) const;
    [[nodiscard]] double metres(double shown) const;
    [[nodiscard]] const char* illuminanceUnit() const;  ///< "lx", "fc"
    [[nodiscard]] const char* luminanceUnit() const;    ///< "cd/m²", "fL"
    [[nodiscard]] const char* lengthUnit() const;       ///< "m", "ft"

    /// "512 lx"
    [[nodiscard]] std::string illuminanceText(double lux) const;
    [[nodiscard]] std::string luminanceText(double cdM2) const;
    [[nodiscard]] std::string lengthText(double metres) const;

    friend bool operator==(const Units&, const Units&) = default;
};

/// As many digits as mean something: three, no exponent between 0.001 and 10^6; "-" for what is not a number.
std::string numberText(double value);
/// "512 ± 6": as many digits as the interval leaves; "not known" without a bound of the error.
std::string intervalText(double value, double ci95);

}  // namespace luxdeck::gui
