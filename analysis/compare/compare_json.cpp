#include "analysis/compare/compare_fields.h"
#include "analysis/compare/compare_output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kSchema = "luxdeck-compare/1";

constexpr std::array<std::pair<Reached, const char*>, 3> kReached{
    {{Reached::Interpolated, "interpolated"}, {Reached::AtOnce, "at once"}, {Reached::NotReached, "not reached"}}};

/// Archive of compare_fields.h that builds JSON.
class Writer {
public:
    explicit Writer(Json& object) : object_(object) {}

    template <class T>
    void operator()(const char* key, const T& value) { object_[key] = json(value); }

private:
    static Json json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
    static Json json(const std::optional<double>& value) { return value ? json(*value) : Json(nullptr); }
    static Json json(Reached how) {
        for (const auto& [each, text] : kReached)
            if (each == how) return text;
        return nullptr;
    }
    /// Errors and places of many points: six digits are more than noise leaves meaning.
    static Json json(const std::vector<double>& list) {
        auto out = Json::array();
        for (const double x : list) out.push_back(std::isfinite(x) ? Json(std::stod(fmt::format("{:.6g}", x))) : Json(nullptr));
        return out;
    }
    template <class T>
    static Json json(const std::vector<T>& list) {
        auto out = Json::array();
        for (const auto& item : list) out.push_back(json(item));
        return out;
    }
    template <class T>
    static Json json(const T& value) {
        if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
            Json out = Json::object();
            Writer writer(out);
            compare_fields::visit(writer, const_cast<T&>(value));  // visit() serves reading too; a writer changes nothing
            return out;
        } else {
            return value;
        }
    }

    Json& object_;
};

/// Archive that reads; throws std::runtime_error or nlohmann's exceptions with what was seen.
class Reader {
public:
    explicit Reader(const Json& object) : object_(object) {}

    template <class T>
    void operator()(const char* key, T& value) { read(object_.at(key), value); }

private:
    static void read(const Json& json, double& value) { value = json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>(); }
    static void read(const Json& json, std::optional<double>& value) {
        if (!json.is_null()) value = json.get<double>();
    }
    static void read(const Json& json, Reached& how) {
        for (const auto& [each, text] : kReached)
            if (json.get<std::string>() == text) return void(how = each);
        throw std::runtime_error(fmt::format("reached is \"{}\", expected interpolated, at once or not reached", json.get<std::string>()));
    }
    template <class T>
    static void read(const Json& json, std::vector<T>& list) {
        for (const auto& item : json) read(item, list.emplace_back());
    }
    template <class T>
    static void read(const Json& json, T& value) {
        if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
            Reader reader(json);
            compare_fields::visit(reader, value);
        } else {
            value = json.get<T>();
        }
    }

    const Json& object_;
};

bool holds(int columns, int rows, std::size_t count) {
    return columns >= 0 && rows >= 0 && static_cast<double>(columns) * rows == static_cast<double>(count);
}

/// What whoever draws a comparison relies on; empty: all is well.
std::string whatIsWrong(const Comparison& c) {
    for (const auto& map : c.maps)
        if (!holds(map.columns, map.rows, map.errors.size())) return fmt::format("a map of {} x {} has {} errors", map.columns, map.rows, map.errors.size());
    for (const auto& grid : c.grids)
        for (const auto* places : {&grid.x, &grid.y, &grid.z})
            if (!holds(grid.columns, grid.rows, places->size()))
                return fmt::format("grid \"{}\" of {} x {} points has {} x, {} y and {} z", grid.name, grid.columns, grid.rows, grid.x.size(), grid.y.size(), grid.z.size());
    for (const auto& run : c.runs)
        for (const auto& [name, value] : {std::pair{"seconds", run.seconds}, {"rmsAtMost", run.rmsAtMost}, {"rms", run.rms.value_or(0)}})
            if (!(value >= 0 && std::isfinite(value)))
                return fmt::format("{} of {} on {}, rung {}, is {}, expected a finite number of at least 0", name, run.algorithm, run.subject, run.rung, value);
    return {};
}

}  // namespace

std::string compareJson(const Comparison& comparison) {
    Json out{{"schema", kSchema}};
    Writer writer(out);
    compare_fields::visit(writer, const_cast<Comparison&>(comparison));
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Comparison> readCompareJson(const std::string& text, const std::string& where) {
    try {
        const auto json = Json::parse(text);
        if (const auto schema = json.at("schema").get<std::string>(); schema != kSchema)
            return Error{ErrorCode::Parse, fmt::format("schema is \"{}\", expected \"{}\"", schema, kSchema), where};
        Comparison out;
        Reader reader(json);
        compare_fields::visit(reader, out);
        if (const auto wrong = whatIsWrong(out); !wrong.empty()) return Error{ErrorCode::Parse, wrong, where};
        return out;
    } catch (const std::exception& e) {
        return Error{ErrorCode::Parse, fmt::format("not a comparison: {}", e.what()), where};
    }
}

}  // namespace luxdeck
