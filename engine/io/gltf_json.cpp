#include "engine/io/gltf_json.h"

#include <fmt/format.h>

#include <cmath>

namespace luxdeck::gltf {

namespace {

constexpr std::size_t kMostOfAValueShown = 40;

std::string shown(const nlohmann::json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    // Bytes that are not UTF-8 must not throw while another error is being told.
    std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text.size() > kMostOfAValueShown) text = text.substr(0, kMostOfAValueShown) + "...";
    return text;
}

}  // namespace

void JsonView::unexpected(const std::string& expected) const {
    fail(present() ? fmt::format("is {}, expected {}", shown(*value_), expected)
                   : fmt::format("is missing, expected {}", expected));
}

JsonView JsonView::operator[](const char* key) const {
    std::string path = path_.empty() ? key : path_ + "." + key;
    if (!present()) return {nullptr, std::move(path), *failure_};
    if (!value_->is_object()) {
        unexpected("an object");
        return {nullptr, std::move(path), *failure_};
    }
    const auto found = value_->find(key);
    return {found == value_->end() ? nullptr : &*found, std::move(path), *failure_};
}

JsonView JsonView::at(std::size_t i) const { return {&(*value_)[i], fmt::format("{}[{}]", path_, i), *failure_}; }

std::size_t JsonView::size() const {
    if (!present()) return 0;
    if (value_->is_array()) return value_->size();
    unexpected("an array");
    return 0;
}

bool JsonView::hasLength(std::size_t n) const {
    if (value_->is_array() && value_->size() == n) return true;
    unexpected(fmt::format("an array of {} numbers", n));
    return false;
}

double JsonView::number(std::optional<double> fallback) const {
    if (!present() && fallback) return *fallback;
    if (present() && value_->is_number()) {
        const double result = value_->get<double>();
        if (std::isfinite(result)) return result;
    }
    unexpected("a finite number");
    return 0;
}

std::uint64_t JsonView::count(std::optional<std::uint64_t> fallback) const {
    if (!present() && fallback) return *fallback;
    if (present() && value_->is_number_unsigned()) return value_->get<std::uint64_t>();
    if (present() && value_->is_number_float()) {  // 3.0, as some writers put it
        const double number = value_->get<double>();
        if (number >= 0 && number <= 0x1p53 && number == std::floor(number)) return static_cast<std::uint64_t>(number);
    }
    unexpected("a whole number >= 0");
    return 0;
}

std::int64_t JsonView::index(std::size_t size, const char* what, bool required) const {
    if (!present() && !required) return -1;
    const std::uint64_t value = count();
    if (failure_->failed()) return -1;
    if (value < size) return static_cast<std::int64_t>(value);
    unexpected(size == 0 ? fmt::format("no index, as the file has no {}", what)
                         : fmt::format("an index into the {} {}", size, what));
    return -1;
}

std::string JsonView::text(const std::string& fallback) const {
    if (!present()) return fallback;
    if (value_->is_string()) return value_->get_ref<const std::string&>();
    unexpected("a string");
    return fallback;
}

bool JsonView::flag(bool fallback) const {
    if (!present()) return fallback;
    if (value_->is_boolean()) return value_->get<bool>();
    unexpected("true or false");
    return fallback;
}

const nlohmann::json::object_t* JsonView::object() const {
    if (!present()) return nullptr;
    if (value_->is_object()) return value_->get_ptr<const nlohmann::json::object_t*>();
    unexpected("an object");
    return nullptr;
}

}  // namespace luxdeck::gltf
