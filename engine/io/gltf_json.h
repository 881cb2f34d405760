#pragma once

#include "engine/core/result.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace luxdeck::gltf {

/// The first thing found wrong in a file. Reading goes on with harmless values until the next step asks.
class Failure {
public:
    explicit Failure(std::string file) : file_(std::move(file)) {}

    /// path  of the value in the document: "accessors[3].count"
    void set(const std::string& path, const std::string& message, ErrorCode code = ErrorCode::Parse) {
        if (!error_) error_ = Error{code, path.empty() ? message : path + ": " + message, file_};
    }
    void set(const Error& error) {
        if (!error_) error_ = error;
    }
    [[nodiscard]] bool failed() const { return error_.has_value(); }
    [[nodiscard]] const Error& error() const { return *error_; }
    [[nodiscard]] const std::string& file() const { return file_; }

private:
    std::string file_;
    std::optional<Error> error_;
};

/// A value of the document that knows where it stands, so that every wrong type, missing field and index
/// out of range is named. Absent values read as the fallback; wrong ones set the Failure and read as zero.
/// The document and the Failure must outlive it.
class JsonView {
public:
    JsonView(const nlohmann::json* value, std::string path, Failure& failure)
        : value_(value), path_(std::move(path)), failure_(&failure) {}

    [[nodiscard]] bool present() const { return value_ != nullptr; }
    [[nodiscard]] const std::string& path() const { return path_; }

    /// A member of an object; absent when there is none.
    JsonView operator[](const char* key) const;
    /// An element of an array, i < size().
    [[nodiscard]] JsonView at(std::size_t i) const;
    /// Elements of an array; 0 when absent.
    [[nodiscard]] std::size_t size() const;
    /// A member of "extensions".
    [[nodiscard]] JsonView extension(const char* name) const { return (*this)["extensions"][name]; }

    [[nodiscard]] double number(std::optional<double> fallback = std::nullopt) const;
    [[nodiscard]] std::uint64_t count(std::optional<std::uint64_t> fallback = std::nullopt) const;
    /// An index into an array of `size` things called `what`; -1 when absent and not required.
    [[nodiscard]] std::int64_t index(std::size_t size, const char* what, bool required = true) const;
    [[nodiscard]] std::string text(const std::string& fallback = "") const;
    [[nodiscard]] bool flag(bool fallback) const;
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> numbers(const std::array<double, N>& fallback) const {
        std::array<double, N> result = fallback;
        if (!present() || !hasLength(N)) return result;
        for (std::size_t i = 0; i < N; ++i) result[i] = at(i).number();
        return result;
    }
    /// Members of an object, for maps whose keys are names.
    [[nodiscard]] const nlohmann::json::object_t* object() const;

    /// Notes that this value is wrong.
    void fail(const std::string& message, ErrorCode code = ErrorCode::Parse) const { failure_->set(path_, message, code); }

private:
    [[nodiscard]] bool hasLength(std::size_t n) const;
    /// Notes "is VALUE, expected WHAT".
    void unexpected(const std::string& expected) const;

    const nlohmann::json* value_;
    std::string path_;
    Failure* failure_;
};

}  // namespace luxdeck::gltf
