#include "engine/io/rad_view.h"

#include "engine/core/file.h"
#include "engine/io/rad_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace luxdeck {

namespace {

constexpr std::uint64_t kMostBytes = 1U << 20U;
constexpr int kWidest = 16384;

/// The options of a view as they add up.
struct ViewOptions {
    char type = 'v';
    Vec3d position{0, 0, 0}, direction{0, 1, 0}, up{0, 0, 1};
    double horizontalDeg = 45, verticalDeg = 45, shift = 0, lift = 0, fore = 0, aft = 0;
    bool any = false;
};

/// What takes one number, and where it goes.
double* scalar(ViewOptions& o, const std::string& word) {
    if (word == "-vh") return &o.horizontalDeg;
    if (word == "-vv") return &o.verticalDeg;
    if (word == "-vs") return &o.shift;
    if (word == "-vl") return &o.lift;
    if (word == "-vo") return &o.fore;
    if (word == "-va") return &o.aft;
    return nullptr;
}

Vec3d* vector(ViewOptions& o, const std::string& word) {
    if (word == "-vp") return &o.position;
    if (word == "-vd") return &o.direction;
    if (word == "-vu") return &o.up;
    return nullptr;
}

Result<void> readOptions(const std::vector<std::string>& words, const std::string& where, ViewOptions& o) {
    const auto number = [&](std::size_t i, const std::string& option) -> Result<double> {
        const auto value = i < words.size() ? rad::numberOf(words[i]) : std::nullopt;
        if (value) return *value;
        return Error{ErrorCode::Parse, fmt::format("{} has {}, expected a number", option, i < words.size() ? "'" + words[i].substr(0, 40) + "'" : "nothing behind it"), where};
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto& word = words[i];
        if (word.size() == 4 && word.starts_with("-vt")) {
            o.type = word[3];
            o.any = true;
        } else if (auto* v = vector(o, word)) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto x = number(i + 1 + static_cast<std::size_t>(axis), word);
                if (!x) return x.error();
                (*v)[axis] = *x;
            }
            i += 3;
            o.any = true;
        } else if (auto* s = scalar(o, word)) {
            const auto x = number(++i, word);
            if (!x) return x.error();
            *s = *x;
            o.any = true;
        }
    }
    return {};
}

Result<View> perspective(const ViewOptions& o, View view, const std::string& where) {
    for (const auto& [option, degrees] : {std::pair{"-vh", o.horizontalDeg}, std::pair{"-vv", o.verticalDeg}})
        if (!(degrees >= 0.1 && degrees <= 170))
            return Error{ErrorCode::InvalidArgument, fmt::format("{} is {} degrees, expected 0.1 to 170 for a perspective view", option, degrees), where};
    view.verticalFovDeg = o.verticalDeg;
    const double aspect = std::tan(o.horizontalDeg * kDegree / 2) / std::tan(o.verticalDeg * kDegree / 2);
    view.width = std::clamp(static_cast<int>(std::lround(std::min(view.height * aspect, 1.0 * kWidest))), 1, kWidest);
    return view;
}

Result<View> viewOf(const ViewOptions& o, const std::string& where) {
    View view;
    view.where = where;
    view.position = o.position;
    if (o.shift != 0 || o.lift != 0)
        return Error{ErrorCode::Unsupported, fmt::format("-vs {} -vl {}: a picture beside the direction of view is not made, expected 0", o.shift, o.lift), where};
    if (o.fore != 0 || o.aft != 0)
        return Error{ErrorCode::Unsupported, fmt::format("-vo {} -va {}: clipping planes are not made, expected 0", o.fore, o.aft), where};
    if (!(o.direction.length() > 0)) return Error{ErrorCode::InvalidArgument, "-vd is 0 0 0, expected a direction", where};
    view.direction = o.direction.normalized();
    view.up = o.up;
    if (!(view.direction.cross(view.up).length() > 1e-6 * view.up.length()))
        return Error{ErrorCode::InvalidArgument, "-vu is 0 0 0 or along -vd, expected another direction", where};
    if (o.type == 'v') return perspective(o, view, where);
    if (o.type == 'a') {
        if (o.horizontalDeg != 180 || o.verticalDeg != 180)
            return Error{ErrorCode::Unsupported, fmt::format("an angular fisheye of {} x {} degrees, expected 180 x 180", o.horizontalDeg, o.verticalDeg), where};
        view.kind = ViewKind::Fisheye;
        view.verticalFovDeg = 180;
        view.width = view.height = 1000;
        return view;
    }
    static constexpr std::pair<char, const char*> kOthers[] = {{'h', "hemispherical fisheye"}, {'l', "parallel"}, {'c', "cylindrical"}, {'s', "planisphere"}};
    for (const auto& [letter, name] : kOthers)
        if (letter == o.type)
            return Error{ErrorCode::Unsupported, fmt::format("-vt{}, a {} view, expected -vtv (perspective) or -vta (angular fisheye)", letter, name), where};
    return Error{ErrorCode::Parse, fmt::format("-vt{}, expected -vtv or -vta", o.type), where};
}

}  // namespace

Result<View> parseView(std::string_view text, const std::string& where) {
    std::istringstream in{std::string(text)};
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(std::move(word));
    ViewOptions options;
    if (auto read = readOptions(words, where, options); !read) return read.error();
    if (!options.any) return Error{ErrorCode::Parse, "has no view, expected options such as -vtv -vp x y z -vd x y z", where};
    return viewOf(options, where);
}

Result<View> readView(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMostBytes);
    if (!bytes) return bytes.error();
    auto view = parseView(*bytes, file.string());
    if (view) view->name = file.stem().string();
    return view;
}

std::string viewLine(const View& v) {
    const bool fisheye = v.kind == ViewKind::Fisheye;
    const double vertical = fisheye ? 180 : v.verticalFovDeg;
    const double horizontal = fisheye ? 180 : 2 * std::atan(std::tan(vertical * kDegree / 2) * v.width / v.height) / kDegree;
    return fmt::format("rvu -vt{} -vp {} {} {} -vd {} {} {} -vu {} {} {} -vh {} -vv {} -vo 0 -va 0 -vs 0 -vl 0\n", fisheye ? 'a' : 'v', v.position.x,
                       v.position.y, v.position.z, v.direction.x, v.direction.y, v.direction.z, v.up.x, v.up.y, v.up.z, horizontal, vertical);
}

}  // namespace luxdeck
