#include "tonemap/stroke_font.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace luxdeck::tonemap {

namespace {

/// Advance and outline: M move, L line, Q quadratic curve (control, end), in tenths of a capital's height.
struct Glyph {
    std::string_view character;
    double advance;
    const char* path;
};

// clang-format off
constexpr Glyph kGlyphs[] = {
    {"0", 8, "M4 0 Q7 0 7 5 Q7 10 4 10 Q1 10 1 5 Q1 0 4 0"},
    {"1", 8, "M1.8 2.4 L4.8 0 L4.8 10"},
    {"2", 8, "M1.2 2.8 Q1.2 0 4 0 Q6.8 0 6.8 2.8 Q6.8 4.4 5.1 6.1 L1 10 L7 10"},
    {"3", 8, "M1.2 0 L6.6 0 L3.6 3.9 Q7 3.9 7 6.9 Q7 10 4 10 Q1.5 10 1 7.7"},
    {"4", 8, "M5.2 10 L5.2 0 L0.8 7.1 L7.2 7.1"},
    {"5", 8, "M6.4 0 L2 0 L1.6 4.6 Q2.6 3.7 4 3.7 Q7 3.7 7 6.8 Q7 10 3.9 10 Q1.6 10 1 7.9"},
    {"6", 8, "M6.2 1 Q5.4 0 4.2 0 Q1 0 1 6.8 Q1 10 4 10 Q7 10 7 6.9 Q7 3.8 4 3.8 Q1.4 3.8 1.1 6"},
    {"7", 8, "M1 0 L7 0 L3 10"},
    {"8", 8, "M4 0 Q6.6 0 6.6 2.4 Q6.6 4.7 4 4.7 Q1.4 4.7 1.4 2.4 Q1.4 0 4 0 M4 4.7 Q7 4.7 7 7.35 Q7 10 4 10 Q1 10 1 7.35 Q1 4.7 4 4.7"},
    {"9", 8, "M1.8 9 Q2.6 10 3.8 10 Q7 10 7 3.2 Q7 0 4 0 Q1 0 1 3.1 Q1 6.2 4 6.2 Q6.6 6.2 6.9 4"},
    {" ", 3.6, ""},
    {".", 2.6, "M1.3 9.8 L1.3 10"},
    {",", 2.6, "M1.5 9.6 L0.8 11.6"},
    {":", 2.6, "M1.3 4.3 L1.3 4.5 M1.3 9.8 L1.3 10"},
    {"-", 6, "M1 6 L5 6"},
    {"+", 7.4, "M1 6 L6.4 6 M3.7 3.3 L3.7 8.7"},
    {"=", 7.4, "M1 4.6 L6.4 4.6 M1 7.4 L6.4 7.4"},
    {"<", 7.4, "M6 3 L1.2 6 L6 9"},
    {">", 7.4, "M1.4 3 L6.2 6 L1.4 9"},
    {"/", 5.4, "M0.7 11 L4.7 -0.6"},
    {"(", 4, "M3.2 -1 Q1 2 1 5.5 Q1 9 3.2 12"},
    {")", 4, "M0.8 -1 Q3 2 3 5.5 Q3 9 0.8 12"},
    {"[", 4, "M3.2 -1 L1.2 -1 L1.2 12 L3.2 12"},
    {"]", 4, "M0.8 -1 L2.8 -1 L2.8 12 L0.8 12"},
    {"%", 10, "M2.4 0 Q4 0 4 2.2 Q4 4.4 2.4 4.4 Q0.8 4.4 0.8 2.2 Q0.8 0 2.4 0 M7.6 5.6 Q9.2 5.6 9.2 7.8 Q9.2 10 7.6 10 Q6 10 6 7.8 Q6 5.6 7.6 5.6 M8 0 L2 10"},
    {"\u00b2", 5, "M0.9 0.6 Q0.9 -0.9 2.4 -0.9 Q3.9 -0.9 3.9 0.6 Q3.9 1.4 3 2.3 L0.8 4.3 L4.2 4.3"},
    {"\u00b0", 4.6, "M2.3 -0.4 Q3.7 -0.4 3.7 1.2 Q3.7 2.8 2.3 2.8 Q0.9 2.8 0.9 1.2 Q0.9 -0.4 2.3 -0.4"},
    {"a", 7.2, "M1.4 4.2 Q2.2 3 3.8 3 Q6 3 6 5.2 L6 10 M6 6.1 Q1 5.8 1 8.1 Q1 10 3.2 10 Q5.4 10 6 7.9"},
    {"b", 7.4, "M1 0 L1 10 M1 6.5 Q1 3 3.8 3 Q6.4 3 6.4 6.5 Q6.4 10 3.8 10 Q1 10 1 6.5"},
    {"c", 6.8, "M6 4.3 Q5.2 3 3.7 3 Q1 3 1 6.5 Q1 10 3.7 10 Q5.2 10 6 8.7"},
    {"d", 7.4, "M6.4 0 L6.4 10 M6.4 6.5 Q6.4 3 3.6 3 Q1 3 1 6.5 Q1 10 3.6 10 Q6.4 10 6.4 6.5"},
    {"e", 7.2, "M1.1 6.5 L6.3 6.5 Q6.3 3 3.8 3 Q1 3 1 6.5 Q1 10 3.9 10 Q5.4 10 6.1 8.6"},
    {"f", 5, "M5 0.2 Q2.6 -0.4 2.6 2.4 L2.6 10 M0.8 3 L4.6 3"},
    {"g", 7.4, "M6.4 3 L6.4 10.2 Q6.4 13 3.7 13 Q2.2 13 1.4 12 M6.4 6.5 Q6.4 3 3.6 3 Q1 3 1 6.5 Q1 10 3.6 10 Q6.4 10 6.4 6.5"},
    {"h", 7.2, "M1 0 L1 10 M1 5.8 Q1.6 3 3.8 3 Q6.2 3 6.2 5.8 L6.2 10"},
    {"i", 2.6, "M1.3 3 L1.3 10 M1.3 0.3 L1.3 0.5"},
    {"j", 3.2, "M2 3 L2 11 Q2 13 0.2 12.8 M2 0.3 L2 0.5"},
    {"k", 6.6, "M1 0 L1 10 M5.8 3 L1 7.3 M2.9 5.8 L6 10"},
    {"l", 2.6, "M1.3 0 L1.3 10"},
    {"m", 10.6, "M1 3 L1 10 M1 5.6 Q1.6 3 3.4 3 Q5.2 3 5.2 5.6 L5.2 10 M5.2 5.6 Q5.8 3 7.6 3 Q9.4 3 9.4 5.6 L9.4 10"},
    {"n", 7.2, "M1 3 L1 10 M1 5.8 Q1.6 3 3.8 3 Q6.2 3 6.2 5.8 L6.2 10"},
    {"o", 7.4, "M3.7 3 Q6.4 3 6.4 6.5 Q6.4 10 3.7 10 Q1 10 1 6.5 Q1 3 3.7 3"},
    {"p", 7.4, "M1 3 L1 13 M1 6.5 Q1 3 3.8 3 Q6.4 3 6.4 6.5 Q6.4 10 3.8 10 Q1 10 1 6.5"},
    {"q", 7.4, "M6.4 3 L6.4 13 M6.4 6.5 Q6.4 3 3.6 3 Q1 3 1 6.5 Q1 10 3.6 10 Q6.4 10 6.4 6.5"},
    {"r", 5, "M1 3 L1 10 M1 6.2 Q1.5 3 4.6 3.1"},
    {"s", 6.4, "M5.3 4.2 Q4.5 3 3.2 3 Q1.2 3 1.2 4.7 Q1.2 6.2 3.2 6.5 Q5.5 6.9 5.5 8.3 Q5.5 10 3.2 10 Q1.6 10 0.9 8.7"},
    {"t", 5.4, "M2.6 0.8 L2.6 8 Q2.6 10 4.8 9.8 M0.8 3 L4.8 3"},
    {"u", 7.2, "M1 3 L1 7.2 Q1 10 3.4 10 Q5.6 10 6.2 7.2 M6.2 3 L6.2 10"},
    {"v", 7.2, "M0.8 3 L3.6 10 L6.4 3"},
    {"w", 9.8, "M0.8 3 L2.8 10 L4.9 3.6 L7 10 L9 3"},
    {"x", 7, "M1 3 L6 10 M6 3 L1 10"},
    {"y", 7.2, "M0.8 3 L3.6 10 M6.4 3 L3.4 10.8 Q2.6 13 0.9 12.8"},
    {"z", 7, "M1 3 L6 3 L1 10 L6 10"},
    {"A", 8.8, "M0.8 10 L4.4 0 L8 10 M2.1 6.6 L6.7 6.6"},
    {"B", 8, "M1.2 0 L1.2 10 L4.4 10 Q7.2 10 7.2 7.3 Q7.2 4.7 4.4 4.7 L1.2 4.7 M4.4 4.7 Q6.6 4.7 6.6 2.3 Q6.6 0 4.2 0 L1.2 0"},
    {"C", 8.8, "M8 2.2 Q7 0 4.8 0 Q1 0 1 5 Q1 10 4.8 10 Q7 10 8 7.8"},
    {"D", 9, "M1.2 0 L1.2 10 L3.8 10 Q8 10 8 5 Q8 0 3.8 0 L1.2 0"},
    {"E", 7.6, "M6.8 0 L1.2 0 L1.2 10 L6.8 10 M1.2 4.8 L6 4.8"},
    {"F", 7.2, "M6.8 0 L1.2 0 L1.2 10 M1.2 4.8 L6 4.8"},
    {"G", 9.2, "M8 2.2 Q7 0 4.8 0 Q1 0 1 5 Q1 10 4.8 10 Q8.2 10 8.2 5.6 L5 5.6"},
    {"H", 9, "M1.2 0 L1.2 10 M7.8 0 L7.8 10 M1.2 4.8 L7.8 4.8"},
    {"I", 2.8, "M1.4 0 L1.4 10"},
    {"J", 6.2, "M5 0 L5 7.4 Q5 10 2.9 10 Q1.2 10 0.8 8"},
    {"K", 8, "M1.2 0 L1.2 10 M7 0 L1.2 6.2 M3.2 4.2 L7.4 10"},
    {"L", 7, "M1.2 0 L1.2 10 L6.4 10"},
    {"M", 10.4, "M1.2 10 L1.2 0 L5.2 7 L9.2 0 L9.2 10"},
    {"N", 9, "M1.2 10 L1.2 0 L7.8 10 L7.8 0"},
    {"O", 10, "M5 0 Q9 0 9 5 Q9 10 5 10 Q1 10 1 5 Q1 0 5 0"},
    {"P", 8, "M1.2 10 L1.2 0 L4.4 0 Q7.2 0 7.2 2.8 Q7.2 5.6 4.4 5.6 L1.2 5.6"},
    {"Q", 10, "M5 0 Q9 0 9 5 Q9 10 5 10 Q1 10 1 5 Q1 0 5 0 M6 7.4 L9 10.6"},
    {"R", 8, "M1.2 10 L1.2 0 L4.4 0 Q7.2 0 7.2 2.8 Q7.2 5.6 4.4 5.6 L1.2 5.6 M4.2 5.6 L7.4 10"},
    {"S", 8.2, "M6.8 1.8 Q6 0 4 0 Q1.4 0 1.4 2.4 Q1.4 4.4 4 4.9 Q7.2 5.5 7.2 7.6 Q7.2 10 4.2 10 Q1.8 10 1 8"},
    {"T", 8.4, "M0.8 0 L7.6 0 M4.2 0 L4.2 10"},
    {"U", 9, "M1.2 0 L1.2 6.4 Q1.2 10 4.5 10 Q7.8 10 7.8 6.4 L7.8 0"},
    {"V", 8.6, "M0.8 0 L4.3 10 L7.8 0"},
    {"W", 11.6, "M0.8 0 L3.2 10 L5.8 1 L8.4 10 L10.8 0"},
    {"X", 8.4, "M1 0 L7.4 10 M7.4 0 L1 10"},
    {"Y", 8.4, "M0.8 0 L4.2 5.2 L7.6 0 M4.2 5.2 L4.2 10"},
    {"Z", 8.2, "M1 0 L7.2 0 L1 10 L7.2 10"},
};
// clang-format on

constexpr Glyph kMissing{"", 8, "M1 0 L7 0 L7 10 L1 10 L1 0"};
constexpr int kCurveSteps = 6;

void append(StrokeText& text, const char* path) {
    std::istringstream in(path);
    double x = 0, y = 0;
    const auto lineTo = [&](double nx, double ny) {
        text.strokes.push_back({text.width + x, y, text.width + nx, ny});
        x = nx, y = ny;
    };
    for (char command = 0; in >> command;) {
        double cx = 0, cy = 0, nx = 0, ny = 0;
        if (command == 'Q') in >> cx >> cy;
        in >> nx >> ny;
        if (command == 'M') {
            x = nx, y = ny;
        } else if (command == 'L') {
            lineTo(nx, ny);
        } else {
            const double x0 = x, y0 = y;
            for (int i = 1; i <= kCurveSteps; ++i) {
                const double t = static_cast<double>(i) / kCurveSteps, s = 1 - t;
                lineTo(s * s * x0 + 2 * s * t * cx + t * t * nx, s * s * y0 + 2 * s * t * cy + t * t * ny);
            }
        }
    }
}

/// Bytes of the UTF-8 character that begins with this one.
std::size_t characterSize(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0x80 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

}  // namespace

StrokeText strokeText(std::string_view utf8) {
    StrokeText text;
    while (!utf8.empty()) {
        auto character = utf8.substr(0, characterSize(utf8.front()));
        utf8.remove_prefix(character.size());
        if (character == "^" && utf8.starts_with('2')) {
            character = "\u00b2";
            utf8.remove_prefix(1);
        }
        const auto* found = std::ranges::find(kGlyphs, character, &Glyph::character);
        const Glyph& glyph = found != std::end(kGlyphs) ? *found : kMissing;
        append(text, glyph.path);
        text.width += glyph.advance;
    }
    return text;
}

}  // namespace luxdeck::tonemap
