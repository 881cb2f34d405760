#include "tests/support/json_schema.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace luxdeck::test {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 19> kKeywords{"$schema", "$id", "$defs", "$ref", "title", "description", "type", "const", "enum", "properties",
                                                     "required", "additionalProperties", "items", "minItems", "maxItems", "minimum", "maximum", "oneOf", "anyOf"};

bool hasType(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "null") return value.is_null();
    if (type == "integer") return value.is_number_integer();
    return type == "number" && value.is_number();
}

/// Checks values against one schema document and gathers what is wrong.
class Checker {
public:
    explicit Checker(const Json& root) : root_(root) {}

    void check(const Json& value, const Json& schema, const std::string& place) {
        if (const auto ref = schema.find("$ref"); ref != schema.end()) return check(value, resolved(*ref), place);
        for (const auto& [key, unused] : schema.items())
            if (std::find(kKeywords.begin(), kKeywords.end(), key) == kKeywords.end()) say(place, "keyword " + key + " that the test does not know");
        checkValue(value, schema, place);
        if (value.is_object()) checkObject(value, schema, place);
        if (value.is_array()) checkArray(value, schema, place);
        if (const auto any = schema.find("anyOf"); any != schema.end()) checkAlternatives(value, *any, place, false);
        if (const auto one = schema.find("oneOf"); one != schema.end()) checkAlternatives(value, *one, place, true);
    }

    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

private:
    void say(const std::string& place, const std::string& what) { complaints_.push_back((place.empty() ? "/" : place) + ": " + what); }

    [[nodiscard]] const Json& resolved(const Json& reference) const {
        return root_.at(Json::json_pointer(reference.get<std::string>().substr(1)));  // of "#/$defs/name"
    }

    void checkValue(const Json& value, const Json& schema, const std::string& place) {
        if (const auto type = schema.find("type"); type != schema.end()) {
            const auto types = type->is_array() ? type->get<std::vector<std::string>>() : std::vector<std::string>{type->get<std::string>()};
            if (std::none_of(types.begin(), types.end(), [&](const auto& t) { return hasType(value, t); }))
                say(place, "saw " + value.dump().substr(0, 60) + ", expected " + type->dump());
        }
        if (schema.contains("const") && value != schema["const"]) say(place, "saw " + value.dump().substr(0, 60) + ", expected " + schema["const"].dump());
        if (const auto all = schema.find("enum"); all != schema.end() && std::find(all->begin(), all->end(), value) == all->end())
            say(place, "saw " + value.dump().substr(0, 60) + ", expected one of " + all->dump());
        if (!value.is_number()) return;
        if (schema.contains("minimum") && value < schema["minimum"]) say(place, value.dump() + " is below " + schema["minimum"].dump());
        if (schema.contains("maximum") && value > schema["maximum"]) say(place, value.dump() + " is above " + schema["maximum"].dump());
    }

    void checkObject(const Json& value, const Json& schema, const std::string& place) {
        static const Json kNone = Json::object();
        const auto& properties = schema.contains("properties") ? schema["properties"] : kNone;
        for (const auto& [key, each] : value.items()) {
            if (properties.contains(key)) check(each, properties[key], place + "/" + key);
            else if (const auto more = schema.find("additionalProperties"); more == schema.end()) continue;
            else if (more->is_object()) check(each, *more, place + "/" + key);
            else if (!more->get<bool>()) say(place, "key \"" + key + "\" that the schema lacks");
        }
        if (!schema.contains("required")) return;
        for (const auto& key : schema["required"])
            if (!value.contains(key.get<std::string>())) say(place, "key " + key.dump() + " is missing");
    }

    void checkArray(const Json& value, const Json& schema, const std::string& place) {
        if (schema.contains("minItems") && value.size() < schema["minItems"]) say(place, "too few items");
        if (schema.contains("maxItems") && value.size() > schema["maxItems"]) say(place, "too many items");
        if (!schema.contains("items")) return;
        for (std::size_t i = 0; i < value.size(); ++i) check(value[i], schema["items"], place + "/" + std::to_string(i));
    }

    void checkAlternatives(const Json& value, const Json& alternatives, const std::string& place, bool exactlyOne) {
        std::vector<std::string> nearest;
        int fitting = 0;
        for (const auto& schema : alternatives) {
            Checker each(root_);
            each.check(value, schema, place);
            if (each.complaints().empty()) ++fitting;
            else if (nearest.empty() || each.complaints().size() < nearest.size()) nearest = each.complaints();
        }
        if (fitting == 1 || (fitting > 1 && !exactlyOne)) return;
        if (fitting > 1) return say(place, "fits several alternatives, expected one");
        complaints_.insert(complaints_.end(), nearest.begin(), nearest.end());
    }

    const Json& root_;
    std::vector<std::string> complaints_;
};

void gapsIn(const Json& schema, const std::string& place, std::vector<std::string>& gaps) {
    if (!schema.is_object()) return;
    if (schema.contains("properties")) {
        if (!schema.contains("additionalProperties")) gaps.push_back(place + ": allows keys that it does not know");
        for (const auto& [key, each] : schema["properties"].items()) {
            if (!each.contains("description") && !each.contains("$ref")) gaps.push_back(place + "/" + key + ": has no description");
            gapsIn(each, place + "/" + key, gaps);
        }
    }
    if (schema.contains("items")) gapsIn(schema["items"], place + "[]", gaps);
    if (schema.contains("$defs"))
        for (const auto& [name, each] : schema["$defs"].items()) gapsIn(each, place + "#" + name, gaps);
}

}  // namespace

std::vector<std::string> complaintsOf(const Json& document, const Json& schema) {
    Checker checker(schema);
    checker.check(document, schema, "");
    return checker.complaints();
}

std::vector<std::string> schemaGaps(const Json& schema) {
    std::vector<std::string> gaps;
    gapsIn(schema, "", gaps);
    return gaps;
}

}  // namespace luxdeck::test
