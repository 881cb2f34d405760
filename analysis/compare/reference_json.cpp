#include "analysis/compare/reference.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <iterator>
#include <stdexcept>

namespace luxdeck {

namespace {

constexpr const char* kSchema = "luxdeck-reference/1";

/// Throws std::runtime_error or nlohmann's exceptions with what was seen.
Reference referenceOf(const nlohmann::json& json) {
    Reference out;
    out.key = json.at("key").get<std::string>(), out.algorithm = json.at("algorithm").get<std::string>();
    out.samples = json.at("samples").get<std::uint64_t>(), out.seconds = json.at("seconds").get<double>();
    out.parts = json.at("parts").get<std::vector<Field>>();
    if (out.parts.size() != kReferenceParts)
        throw std::runtime_error(fmt::format("{} parts, expected {}", out.parts.size(), kReferenceParts));
    for (auto& part : out.parts) {
        if (part.size() != out.parts.front().size() || part.empty()) throw std::runtime_error("parts of different sizes, or empty");
        for (double& x : part) {
            if (!(x >= 0 && x < 1e30)) throw std::runtime_error(fmt::format("a value is {}, expected 0 .. 1e30", x));
            x = static_cast<float>(x);  // nine digits name a float, not a double
        }
    }
    out.reused = true;
    return out;
}

}  // namespace

std::string referenceJson(const ReferenceFile& file) {
    std::string text = fmt::format("{{\"schema\":\"{}\",\"sceneHash\":\"{}\",\"projectHash\":\"{}\",\n\"references\":[", kSchema, file.sceneHash, file.projectHash);
    bool first = true;
    for (const auto& [key, r] : file.references) {
        text += fmt::format("{}\n{{\"key\":\"{}\",\"algorithm\":\"{}\",\"samples\":{},\"seconds\":{:.3f},\"parts\":[", first ? "" : ",", key, r.algorithm, r.samples, r.seconds);
        first = false;
        for (std::size_t p = 0; p < r.parts.size(); ++p) {
            text += p > 0 ? ",\n[" : "\n[";
            for (std::size_t i = 0; i < r.parts[p].size(); ++i) fmt::format_to(std::back_inserter(text), "{}{:.9g}", i > 0 ? "," : "", r.parts[p][i]);
            text += "]";
        }
        text += "]}";
    }
    return text + "]}\n";
}

Result<ReferenceFile> readReferenceJson(const std::string& text, const std::string& where) {
    try {
        const auto json = nlohmann::json::parse(text);
        if (const auto schema = json.at("schema").get<std::string>(); schema != kSchema)
            return Error{ErrorCode::Parse, fmt::format("schema is \"{}\", expected \"{}\"", schema, kSchema), where};
        ReferenceFile out{json.at("sceneHash").get<std::string>(), json.at("projectHash").get<std::string>(), {}};
        for (const auto& one : json.at("references")) {
            auto reference = referenceOf(one);
            out.references.emplace(reference.key, std::move(reference));
        }
        return out;
    } catch (const std::exception& e) {
        return Error{ErrorCode::Parse, fmt::format("not a file of references: {}", e.what()), where};
    }
}

}  // namespace luxdeck
