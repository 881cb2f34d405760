#include "engine/io/xform.h"

#include "engine/io/rad_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace luxdeck::rad {

namespace {

constexpr double kMostRepeats = 100'000;

Error wrong(std::string message) { return {ErrorCode::InvalidArgument, std::move(message), {}}; }

Result<double> argument(std::span<const std::string> words, std::size_t at, const std::string& option) {
    if (at >= words.size()) return wrong(fmt::format("xform {} ends, expected a number", option));
    const auto value = numberOf(words[at]);
    if (!value) return wrong(fmt::format("xform {} has '{}', expected a number", option, words[at]));
    return *value;
}

Matrix4d rotation(int axis, double degrees) {
    const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Matrix4d m;
    m[u][u] = m[v][v] = c;
    m[u][v] = s, m[v][u] = -s;
    return m;
}

/// One step of a transform: -t, -r, -s or -m with its numbers.
struct Step {
    Matrix4d matrix;
    double scale = 1;  ///< negative: it mirrors
};

bool isAxisOption(const std::string& word, char letter) {
    return word.size() == 3 && word[1] == letter && word[2] >= 'x' && word[2] <= 'z';
}

/// The step at words[at], which is moved past it; nothing when no step stands there.
Result<std::optional<Step>> parseStep(std::span<const std::string> words, std::size_t& at) {
    const auto& word = words[at];
    Step step;
    if (word == "-t") {
        for (int i = 0; i < 3; ++i) {
            const auto x = argument(words, at + 1 + static_cast<std::size_t>(i), word);
            if (!x) return x.error();
            step.matrix[3][i] = *x;
        }
        at += 4;
    } else if (isAxisOption(word, 'r')) {
        const auto degrees = argument(words, at + 1, word);
        if (!degrees) return degrees.error();
        step.matrix = rotation(word[2] - 'x', *degrees);
        at += 2;
    } else if (word == "-s") {
        const auto factor = argument(words, at + 1, word);
        if (!factor) return factor.error();
        if (!(std::abs(*factor) > 1e-12 && std::abs(*factor) < 1e12))
            return wrong(fmt::format("xform -s has {}, expected a factor that is not 0", *factor));
        for (int i = 0; i < 3; ++i) step.matrix[i][i] = *factor;
        step.scale = *factor;
        at += 2;
    } else if (isAxisOption(word, 'm')) {
        const int axis = word[2] - 'x';
        step.matrix[axis][axis] = -1;
        step.scale = -1;
        at += 1;
    } else {
        return std::optional<Step>{};
    }
    return std::optional(step);
}

void multiply(Step& total, const Step& by) {
    total.matrix = total.matrix * by.matrix;
    total.scale *= by.scale;
}

/// -n and -m and the flags that come before the transform.
struct Heading {
    std::string prefix, modifier;
    bool hasPrefix = false, invert = false;
};

Result<bool> parseHeading(std::span<const std::string> words, std::size_t& at, Heading& heading) {
    const auto& word = words[at];
    if (word == "-c" || word == "-e") return ++at, true;  // about the text that xform writes: nothing here
    if (word == "-I") return heading.invert = !heading.invert, ++at, true;
    if (word != "-n" && word != "-m") return false;
    if (at + 1 >= words.size()) return wrong(fmt::format("xform {} ends, expected a name", word));
    if (word == "-m" && heading.modifier.empty()) heading.modifier = words[at + 1];
    if (word == "-n") heading.prefix += (heading.hasPrefix ? "." : "") + words[at + 1], heading.hasPrefix = true;
    at += 2;
    return true;
}

/// An option of a transform with its arguments, in words.
std::size_t wordsOf(std::string_view option) {
    static constexpr std::string_view kOneArgument[] = {"-a", "-i", "-s", "-rx", "-ry", "-rz"};
    if (option == "-t") return 4;
    return std::find(std::begin(kOneArgument), std::end(kOneArgument), option) != std::end(kOneArgument) ? 2 : 1;
}

/// The words between the heading and the files: the transform, with its arrays.
std::size_t transformEnd(std::span<const std::string> words, std::size_t at) {
    while (at < words.size() && words[at].starts_with('-') && words[at].size() > 1) at += wordsOf(words[at]);
    return std::min(at, words.size());
}

}  // namespace

Result<Xform> parseXform(std::span<const std::string> words, std::size_t& used) {
    Step total, repeated;
    double repeats = 1;
    const auto close = [&] {
        for (int i = 0; i < static_cast<int>(repeats); ++i) multiply(total, repeated);
        repeated = {};
    };
    used = 0;
    while (used < words.size()) {
        if (words[used] == "-i") {
            const auto count = argument(words, used + 1, "-i");
            if (!count) return count.error();
            if (!(*count >= 0 && *count <= kMostRepeats && *count == std::floor(*count)))
                return wrong(fmt::format("xform -i has {}, expected a whole number from 0 to {}", *count, kMostRepeats));
            close();
            repeats = *count;
            used += 2;
            continue;
        }
        const auto step = parseStep(words, used);
        if (!step) return step.error();
        if (!*step) break;
        multiply(repeated, **step);
    }
    close();
    Xform result{total.matrix, std::abs(total.scale), total.scale < 0};
    for (int i = 0; i < 4; ++i)
        if (!isFinite(Vec3d(result.matrix[i][0], result.matrix[i][1], result.matrix[i][2])))
            return wrong("xform goes beyond the range of numbers");
    return result;
}

Result<XformCommand> parseXformCommand(std::span<const std::string> words, std::size_t mostCopies) {
    Heading heading;
    std::size_t start = 0;
    for (bool more = true; more && start < words.size();) {
        const auto read = parseHeading(words, start, heading);
        if (!read) return read.error();
        more = *read;
    }
    const auto end = transformEnd(words, start);
    // An array of n is n transforms in which `-i k` stands for `-a n`, k = 0 .. n - 1; its first goes slowest.
    struct Pending {
        std::vector<std::string> words;
        std::string prefix;
    };
    std::vector<Pending> pending{{{words.begin() + static_cast<std::ptrdiff_t>(start), words.begin() + static_cast<std::ptrdiff_t>(end)}, heading.prefix}};
    bool named = heading.hasPrefix;
    for (std::size_t at = 0; at < end - start; at += wordsOf(words[start + at])) {  // an argument may look like an option
        if (words[start + at] != "-a") continue;
        const auto count = argument(words, start + at + 1, "-a");
        if (!count) return count.error();
        if (!(*count >= 1 && *count == std::floor(*count) && *count * static_cast<double>(pending.size()) <= static_cast<double>(mostCopies)))
            return wrong(fmt::format("xform -a has {}, expected a whole number, and at most {} copies in all", *count, mostCopies));
        std::vector<Pending> copies;
        for (const auto& one : pending)
            for (int k = 0; k < static_cast<int>(*count); ++k) {
                copies.push_back({one.words, named ? fmt::format("{}.{}", one.prefix, k) : fmt::format("a{}", k)});
                copies.back().words[at] = "-i";
                copies.back().words[at + 1] = std::to_string(k);
            }
        pending = std::move(copies);
        named = true;
    }
    XformCommand command;
    for (auto& one : pending) {
        std::size_t used = 0;
        auto xform = parseXform(one.words, used);
        if (!xform) return xform.error();
        if (used < one.words.size())
            return Error{ErrorCode::Unsupported, fmt::format("xform has '{}', expected -n -m -I -c -e -f before -t -rx -ry -rz -s -mx -my -mz -i -a", one.words[used]), {}};
        command.copies.push_back({*xform, std::move(one.words), std::move(one.prefix), heading.modifier, heading.invert});
    }
    command.files.assign(words.begin() + static_cast<std::ptrdiff_t>(end), words.end());
    return command;
}

}  // namespace luxdeck::rad
