#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace luxdeck::cal {

/// Functions that the evaluator must know, since they look at no more of their arguments than they need.
enum class Special : std::uint8_t { None, If, Select, RealArgument };

/// A function that is always there: the language's library, and the most used ones of Radiance's rayinit.cal,
/// which are faster this way. `evaluate` is null for special ones.
struct NativeFunction {
    std::string_view name;
    std::size_t leastArguments = 1;
    bool anyNumber = false;  ///< min, max: it takes all arguments that there are
    double (*evaluate)(const double* arguments, std::size_t count) = nullptr;
    Special special = Special::None;
};

/// At most so many arguments are kept for a native function.
inline constexpr std::size_t kMostNativeArguments = 16;

std::span<const NativeFunction> nativeFunctions();

/// Its index; -1 when there is none of that name.
int nativeFunction(std::string_view name);

}  // namespace luxdeck::cal
