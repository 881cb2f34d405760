#include "engine/io/pattern_data.h"

#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace luxdeck {

namespace {

constexpr std::size_t kMostAxes = DataTable::kMostAxes;

/// Words between blanks, without comments. An error is kept; numbers are 0 from there on.
class DataReader {
public:
    DataReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    double number(const char* expected) {
        const auto text = word();
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
            fail(text, expected);
            return 0;
        }
        return value;
    }
    std::size_t count(std::size_t least, std::size_t most, const char* what) {
        const auto text = word();
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most) return value;
        fail(text, fmt::format("{}, at least {}{}", what, least,
                               most == kMostAxes ? fmt::format(" and at most {}", most) : ", and as many values"));
        return least;
    }
    void fail(std::string_view seen, const std::string& expected) {
        failWith(fmt::format("{}, expected {}",
                             seen.empty() ? "the file ends" : fmt::format("'{}'", seen.substr(0, 40)), expected));
    }
    void failWith(const std::string& message) {
        if (!failed_) error_ = {ErrorCode::Parse, message, fmt::format("{}:{}", name_, line_)};
        failed_ = true;
    }
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] const Error& error() const { return error_; }
    /// No more numbers than this can follow.
    [[nodiscard]] std::size_t mostLeft() const { return rest_.size() / 2 + 1; }

private:
    static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
    void drop() {
        if (rest_.front() == '\n') ++line_;
        rest_.remove_prefix(1);
    }
    std::string_view word() {
        if (failed_) return {};
        while (!rest_.empty() && (isBlank(rest_.front()) || rest_.front() == '#')) {
            if (rest_.front() == '#')
                while (!rest_.empty() && rest_.front() != '\n') drop();
            else drop();
        }
        std::size_t end = 0;
        while (end < rest_.size() && !isBlank(rest_[end]) && rest_[end] != '#') ++end;
        auto result = rest_.substr(0, end);
        rest_.remove_prefix(end);
        if (result.size() > 1 && result.front() == '+' && result[1] != '-') result.remove_prefix(1);
        return result;
    }

    std::string_view rest_;
    const std::string& name_;
    std::size_t line_ = 1;
    bool failed_ = false;
    Error error_;
};

DataAxis readAxis(DataReader& reader, std::size_t most) {
    DataAxis axis;
    axis.begin = reader.number("where a dimension begins");
    axis.end = reader.number("where a dimension ends");
    axis.count = reader.count(2, most, "the number of points of a dimension");
    if (axis.begin != axis.end || reader.failed()) return axis;
    if (axis.begin != 0) {
        reader.failWith(fmt::format("a dimension from {} to {}, expected two bounds, or 0 0 and a list of points",
                                    axis.begin, axis.end));
        return axis;
    }
    for (std::size_t i = 0; i < axis.count && !reader.failed(); ++i) {
        axis.points.push_back(reader.number("a point of a dimension"));
        const auto& p = axis.points;
        if (i > 0 && (p[i] == p[i - 1] || (p[i] > p[i - 1]) != (p[1] > p[0])))
            reader.failWith(
                fmt::format("the point {} after {}, expected points that only rise or only fall", p[i], p[i - 1]));
    }
    axis.begin = axis.points.front(), axis.end = axis.points.back();
    return axis;
}

}  // namespace

Result<std::shared_ptr<const DataTable>> DataTable::parse(std::string_view text, const std::string& name) {
    auto table = std::make_shared<DataTable>();
    DataReader reader(text, name);
    const std::size_t dimensions = reader.count(1, kMostAxes, "the number of dimensions");
    std::size_t count = 1;
    for (std::size_t i = 0; i < dimensions && !reader.failed(); ++i) {
        // Whatever is asked for must stand in the file, which bounds what it can make us allocate.
        table->axes_.push_back(readAxis(reader, reader.mostLeft() / count));
        count *= table->axes_.back().count;
    }
    for (std::size_t i = 0; i < count && !reader.failed(); ++i) {
        if (i == 0) table->values_.reserve(std::min(count, reader.mostLeft()));
        table->values_.push_back(reader.number("a value"));
    }
    if (reader.failed()) return reader.error();
    table->hash_ = contentHash(text);
    return std::shared_ptr<const DataTable>(std::move(table));
}

double DataTable::value(std::span<const double> at) const {
    std::array<AxisPlace, kMostAxes> places;
    std::array<std::size_t, kMostAxes> strides{};
    std::size_t stride = 1;
    for (std::size_t i = axes_.size(); i-- > 0;) {
        places[i] = axes_[i].place(at[i]);
        strides[i] = stride;
        stride *= axes_[i].count;
    }
    double sum = 0;
    for (std::size_t corner = 0; corner < std::size_t{1} << axes_.size(); ++corner) {
        double weight = 1;
        std::size_t index = 0;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const bool upper = (corner >> i & 1U) != 0;
            weight *= upper ? places[i].upperWeight : places[i].lowerWeight;
            index += (places[i].lower + (upper ? 1 : 0)) * strides[i];
        }
        sum += weight * values_[index];
    }
    return sum;
}

}  // namespace luxdeck
