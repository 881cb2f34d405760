#include "engine/io/obj_mtl.h"

#include "engine/io/obj_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace luxdeck::obj {

namespace {

class MtlParser {
public:
    MtlParser(const std::string& name, WarningList& warnings) : name_(name), warnings_(warnings) {}

    Result<std::vector<MtlRecord>> parse(std::string_view text) {
        Lines lines(text);
        while (lines.next()) {
            number_ = lines.number();
            Words words(lines.line());
            const auto key = words.next();
            if (key.empty()) continue;
            if (key == "newmtl") {
                records_.emplace_back();
                records_.back().name = words.remainder();
                records_.back().where = where();
            } else if (records_.empty()) {
                return Error{ErrorCode::Parse, fmt::format("'{}' before the first newmtl", key), where()};
            } else {
                readKey(key, words, records_.back());
            }
            if (error_) return *error_;
        }
        return std::move(records_);
    }

private:
    [[nodiscard]] std::string where() const { return fmt::format("{}:{}", name_, number_); }

    double number(std::string_view key, Words& words) {
        const auto value = words.number();
        if (value && std::isfinite(*value)) return *value;
        if (!error_) error_ = Error{ErrorCode::Parse, fmt::format("'{}' without a finite number after it", key), where()};
        return 0;
    }

    std::optional<Rgb> colour(std::string_view key, Words& words) {
        Words look = words;
        const auto first = look.next();
        if (first == "spectral" || first == "xyz") {
            warnings_.add(fmt::format("{}: '{} {}' is left out, expected three numbers", where(), key, first));
            return std::nullopt;
        }
        const double r = number(key, words);
        if (words.atEnd()) return Rgb{static_cast<float>(r)};  // one number stands for all three
        const double g = number(key, words), b = number(key, words);
        return Rgb{static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
    }

    /// -s u v w, -o u v w, -clamp on|off, and options that say nothing of colour; then the file's name.
    MtlRecord::Map map(std::string_view key, Words& words) {
        MtlRecord::Map map;
        std::array<double, 2> scale{1, 1}, offset{0, 0};
        for (;;) {
            Words look = words;
            const auto option = look.next();
            if (option == "-s" || option == "-o" || option == "-t") {
                auto& target = option == "-s" ? scale : offset;
                std::array<double, 2> ignored{};
                auto& values = option == "-t" ? ignored : target;
                words = look;
                values[0] = number(key, words);
                for (int i = 1; i < 3; ++i) {
                    look = words;
                    const auto value = look.number();
                    if (!value) break;
                    if (i == 1) values[1] = *value;
                    words = look;
                }
            } else if (option == "-clamp") {
                map.clamp = look.next() == "on";
                words = look;
            } else if (option == "-mm") {
                (void)look.next(), (void)look.next();
                words = look;
            } else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-bm" ||
                       option == "-boost" || option == "-texres" || option == "-imfchan" || option == "-type") {
                (void)look.next();
                words = look;
            } else {
                break;
            }
        }
        map.file = words.remainder();
        std::replace(map.file.begin(), map.file.end(), '\\', '/');
        // The file's v runs up, ours down: v' = 1 - (s (1 - v) + o).
        map.slot.scale = {static_cast<float>(scale[0]), static_cast<float>(scale[1])};
        map.slot.offset = {static_cast<float>(offset[0]), static_cast<float>(1 - scale[1] - offset[1])};
        return map;
    }

    void readKey(std::string_view key, Words& words, MtlRecord& record) {
        if (key == "Kd") record.kd = colour(key, words);
        else if (key == "Ks") record.ks = colour(key, words);
        else if (key == "Ke") record.ke = colour(key, words);
        else if (key == "Tf") record.tf = colour(key, words);
        else if (key == "Ns") record.ns = number(key, words);
        else if (key == "Ni") record.ior = number(key, words);
        else if (key == "Tr") record.dissolve = 1 - number(key, words);
        else if (key == "d") readDissolve(words, record);
        else if (key == "illum") record.illum = static_cast<int>(std::clamp(number(key, words), 0.0, 10.0));
        else if (key == "Pr") record.pr = number(key, words);
        else if (key == "Pm") record.pm = number(key, words);
        else if (key == "map_Kd") record.mapKd = map(key, words);
        else if (key == "map_Ke") record.mapKe = map(key, words);
        else if (key != "Ka" && key != "map_Ka" && key != "sharpness" && key != "map_aat")
            warnings_.add(fmt::format("mtl {}", key), fmt::format("{}: '{}' is left out", where(), key));
    }

    void readDissolve(Words& words, MtlRecord& record) {
        Words look = words;
        if (look.next() == "-halo") words = look;
        record.dissolve = number("d", words);
    }

    const std::string& name_;
    WarningList& warnings_;
    std::vector<MtlRecord> records_;
    std::optional<Error> error_;
    std::size_t number_ = 0;
};

}  // namespace

Result<std::vector<MtlRecord>> parseMtl(std::string_view text, const std::string& name, WarningList& warnings) {
    return MtlParser(name, warnings).parse(text);
}

}  // namespace luxdeck::obj
