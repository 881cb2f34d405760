#pragma once

#include "engine/core/result.h"
#include "engine/io/cal_library.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck {

/// Definitions given as text and files, and functions of them asked for by name: what gensurf, genrev and
/// genworm do. The functions that every Radiance program knows are there; rays (Dx, Px ...) are not.
///
///     CalProgram program;
///     program.addText("r(t) = 1 + 0.2*sin(2*PI*t)", "scene.rad:4");   // -e
///     program.addFile("shape.cal", folder, library);                  // -f
///     auto x = program.evaluate("r", std::array{0.5});
///
/// Later definitions replace earlier ones. Not for concurrent use; evaluate() compiles a name at its first use.
class CalProgram {
public:
    CalProgram();
    ~CalProgram();
    CalProgram(CalProgram&&) noexcept;
    CalProgram& operator=(CalProgram&&) noexcept;

    /// Definitions "f(s,t) = ...; a : 2;".
    /// errors  Parse, at `where`
    Result<void> addText(std::string_view text, const std::string& where);
    /// errors  those of CalLibrary::functions()
    Result<void> addFile(std::string_view name, const std::filesystem::path& folder, CalLibrary& library);
    /// An expression of parameters, as a function of that name: define("x", {"s", "t"}, "cos(2*PI*s)", where).
    /// errors  Parse, at `where`
    Result<void> define(const std::string& name, const std::vector<std::string>& parameters,
                        std::string_view expression, const std::string& where);

    /// Whether a function or variable of that name is defined by text or file.
    [[nodiscard]] bool defines(std::string_view name) const;

    /// The value of a function (or of a variable, with no arguments).
    /// errors  InvalidArgument: not defined, another number of parameters, no value (division by zero ...),
    ///         recursion without end
    Result<double> evaluate(std::string_view name, std::span<const double> arguments);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace luxdeck
