#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <vector>

namespace luxdeck::test {

/// Intensity by plane angle and vertical angle, degrees.
using Distribution = std::function<double(double planeDegrees, double verticalDegrees)>;

inline std::vector<double> steps(double first, double last, double step) {
    std::vector<double> out;
    for (double a = first; a <= last + 1e-9; a += step) out.push_back(a);
    return out;
}

/// An LM-63 file to be written as text; change a field, then ask for text().
struct IesFile {
    std::string firstLine = "IESNA:LM-63-2002";
    std::string tilt = "TILT=NONE";
    double lamps = 1;
    double lumens = 1000;
    double multiplier = 1;
    int type = 1;
    int units = 2;
    double width = 0;
    double length = 0;
    double height = 0;
    double ballast = 1;
    double twelfth = 1;
    double watts = 100;
    std::vector<double> vertical = {0, 45, 90};
    std::vector<double> horizontal = {0};
    Distribution candela = [](double, double) { return 100.0; };

    [[nodiscard]] std::string text() const {
        std::string out = firstLine + "\n[LUMINAIRE] Test\n[MANUFAC] Maker\n[LAMP] Lamp\n" + tilt + "\n";
        out += fmt::format("{} {} {} {} {} {} {} {} {} {}\n{} {} {}\n", lamps, lumens, multiplier, vertical.size(),
                           horizontal.size(), type, units, width, length, height, ballast, twelfth, watts);
        out += fmt::format("{}\n{}\n", fmt::join(vertical, " "), fmt::join(horizontal, " "));
        for (const double h : horizontal) {
            for (const double v : vertical) out += fmt::format("{} ", candela(h, v));
            out += "\n";
        }
        return out;
    }
};

/// An EULUMDAT file to be written as text. `stored` are the planes whose intensities follow, in order.
struct LdtFile {
    int symmetry = 1;
    std::vector<double> planes = {0};
    std::vector<double> stored = {0};
    std::vector<double> gammas = {0, 45, 90};
    std::string name = "Test";
    double luminousLength = 0;
    double luminousWidth = 0;
    double luminousHeights[4] = {0, 0, 0, 0};
    double downwardPercent = 100;
    double outputPercent = 100;
    std::string conversion = "1";
    std::vector<std::string> lampSets = {"1\nLamp\n1000\n3000\n80\n50"};
    std::string lineEnd = "\r\n";
    Distribution candelaPer1000lm = [](double, double) { return 100.0; };

    [[nodiscard]] std::string text() const {
        std::string out = fmt::format("Maker\n1\n{}\n{}\n0\n{}\n0\nReport\n{}\nNumber\nfile.ldt\ndate\n", symmetry,
                                      planes.size(), gammas.size(), name);
        out += fmt::format("1\n1\n1\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n0\n", luminousLength, luminousWidth,
                           luminousHeights[0], luminousHeights[1], luminousHeights[2], luminousHeights[3],
                           downwardPercent, outputPercent, conversion);
        out += fmt::format("{}\n{}\n0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n", lampSets.size(), fmt::join(lampSets, "\n"));
        out += fmt::format("{}\n{}\n", fmt::join(planes, "\n"), fmt::join(gammas, "\n"));
        for (const double c : stored) {
            for (const double g : gammas) out += fmt::format("{}\n", candelaPer1000lm(c, g));
        }
        std::string ended;
        for (const char c : out) ended += c == '\n' ? lineEnd : std::string(1, c);
        return ended;
    }
};

/// Whether any of the notes contains the words.
inline bool mentions(const std::vector<std::string>& notes, const std::string& words) {
    for (const auto& note : notes) {
        if (note.find(words) != std::string::npos) return true;
    }
    return false;
}

/// `text` with the first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace luxdeck::test
