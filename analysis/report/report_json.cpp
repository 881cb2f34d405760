#include "analysis/report/report_json.h"

#include "analysis/report/report_fields.h"

#include <QByteArray>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

namespace luxdeck {

namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kSchema = "luxdeck-report/1";

/// Archive of report_fields.h that builds JSON.
class JsonWriter {
public:
    explicit JsonWriter(Json& object) : object_(object) { object_ = Json::object(); }

    template <class T>
    void operator()(const char* key, const T& value) { object_[key] = json(value); }
    template <class T>
    void operator()(const char* key, const std::optional<T>& value) {
        if (value) object_[key] = json(*value);
    }
    void bytes(const char* key, const std::string& value) {
        object_[key] = QByteArray(value.data(), static_cast<int>(value.size())).toBase64().toStdString();
    }

private:
    static Json json(double value) {
        if (std::isfinite(value)) return value;
        if (std::isnan(value)) return "NaN";
        return value > 0 ? Json(nullptr) : Json("-Infinity");
    }
    static Json json(const Vec3d& v) { return Json::array({json(v.x), json(v.y), json(v.z)}); }
    template <class T>
    static Json json(const std::vector<T>& list) {
        auto out = Json::array();
        for (const auto& item : list) out.push_back(json(item));
        return out;
    }
    template <class T>
    static Json json(const T& value) {
        if constexpr (std::is_enum_v<T>) {
            return fields::name(value);
        } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
            Json out;
            JsonWriter writer(out);
            fields::visit(writer, const_cast<T&>(value));  // visit() serves reading too; a writer changes nothing
            return out;
        } else {
            return value;
        }
    }

    Json& object_;
};

/// Archive of report_fields.h that reads JSON; keeps the first error and its place.
class JsonReader {
public:
    JsonReader(const Json& object, std::string place, std::optional<Error>& error)
        : object_(object), place_(std::move(place)), error_(error) {
        if (!object.is_object()) fail(place_, object, "an object");
    }

    template <class T>
    void operator()(const char* key, T& value) {
        if (error_) return;
        const auto at = object_.find(key);
        if (at == object_.end()) return void(error_ = Error{ErrorCode::Parse, "is missing", placeOf(key)});
        read(*at, placeOf(key), value);
    }
    template <class T>
    void operator()(const char* key, std::optional<T>& value) {
        value.reset();
        if (error_ || !object_.contains(key)) return;
        read(object_.at(key), placeOf(key), value.emplace());
    }
    void bytes(const char* key, std::string& value) {
        std::string text;
        (*this)(key, text);
        if (error_) return;
        const auto decoded = QByteArray::fromBase64Encoding(QByteArray::fromStdString(text), QByteArray::AbortOnBase64DecodingErrors);
        if (!decoded) return void(error_ = Error{ErrorCode::Parse, "is not base64", placeOf(key)});
        value = decoded.decoded.toStdString();
    }

private:
    [[nodiscard]] std::string placeOf(const char* key) const { return place_.empty() ? key : place_ + "." + key; }

    void fail(const std::string& place, const Json& seen, const char* expected) {
        if (error_) return;
        auto text = seen.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (text.size() > 40) text = text.substr(0, 40) + "...";
        error_ = Error{ErrorCode::Parse, fmt::format("saw {}, expected {}", text, expected), place};
    }

    static bool isText(const Json& json, const char* text) {
        return json.is_string() && json.get_ref<const std::string&>() == text;
    }

    void read(const Json& json, const std::string& place, double& value) {
        if (json.is_number()) value = json.get<double>();
        else if (json.is_null()) value = std::numeric_limits<double>::infinity();
        else if (isText(json, "NaN")) value = std::numeric_limits<double>::quiet_NaN();
        else if (isText(json, "-Infinity")) value = -std::numeric_limits<double>::infinity();
        else fail(place, json, "a number");
    }
    void read(const Json& json, const std::string& place, bool& value) {
        json.is_boolean() ? void(value = json.get<bool>()) : fail(place, json, "true or false");
    }
    void read(const Json& json, const std::string& place, std::string& value) {
        json.is_string() ? void(value = json.get<std::string>()) : fail(place, json, "text");
    }
    void read(const Json& json, const std::string& place, Vec3d& value) {
        if (!json.is_array() || json.size() != 3) return fail(place, json, "three numbers");
        for (int i = 0; i < 3; ++i) read(json[static_cast<std::size_t>(i)], place, value[i]);
    }
    template <class T>
    void read(const Json& json, const std::string& place, std::vector<T>& list) {
        if (!json.is_array()) return fail(place, json, "a list");
        list.assign(json.size(), T{});
        for (std::size_t i = 0; i < list.size() && !error_; ++i) read(json[i], fmt::format("{}[{}]", place, i), list[i]);
    }
    template <class T>
    void read(const Json& json, const std::string& place, T& value) {
        if constexpr (std::is_enum_v<T>) {
            std::string text;
            read(json, place, text);
            if (!error_ && !fields::fromName(text, value)) fail(place, json, fields::namesOf<T>());
        } else if constexpr (std::is_unsigned_v<T>) {
            json.is_number_unsigned() ? void(value = json.get<T>()) : fail(place, json, "a whole number >= 0");
        } else if constexpr (std::is_integral_v<T>) {
            json.is_number_integer() && std::abs(json.get<double>()) < 1e9 ? void(value = json.get<T>())
                                                                          : fail(place, json, "a whole number");
        } else {
            JsonReader reader(json, place, error_);
            fields::visit(reader, value);
        }
    }

    const Json& object_;
    std::string place_;
    std::optional<Error>& error_;
};

/// Counts that do not fit their points would be read beyond their ends.
Result<void> checkShapes(const ReportContents& contents) {
    for (std::size_t i = 0; i < contents.solve.grids.size(); ++i) {
        const auto& grid = contents.solve.grids[i];
        const bool free = grid.columns == 0 && grid.rows == 0;
        const auto cells = static_cast<long long>(grid.columns) * grid.rows;
        if (grid.columns < 0 || grid.rows < 0 || (!free && cells != static_cast<long long>(grid.points.size())))
            return Error{ErrorCode::Parse,
                         fmt::format("{} x {} points, but {} are listed", grid.columns, grid.rows, grid.points.size()),
                         fmt::format("solve.grids[{}]", i)};
    }
    return {};
}

}  // namespace

Result<std::string> toJson(const ReportContents& contents) {
    Json body;
    JsonWriter writer(body);
    writer("schema", std::string(kSchema));
    fields::visit(writer, const_cast<ReportContents&>(contents));  // a writer changes nothing
    return body.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<ReportContents> fromJson(std::string_view text) {
    const auto json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return Error{ErrorCode::Parse, "is not JSON", "report"};
    std::optional<Error> error;
    JsonReader reader(json, "", error);
    std::string schema;
    reader("schema", schema);
    if (!error && schema != kSchema)
        error = Error{ErrorCode::Parse, fmt::format("saw \"{}\", expected \"{}\"", schema, kSchema), "schema"};
    ReportContents contents;
    fields::visit(reader, contents);
    if (error) return *error;
    if (auto shapes = checkShapes(contents); !shapes) return shapes.error();
    return contents;
}

}  // namespace luxdeck
