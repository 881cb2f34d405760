#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace luxdeck {

/// What kind of thing went wrong. The command line turns each into an exit code.
enum class ErrorCode {
    InvalidArgument,  ///< a value out of its range: the caller's or the user's
    FileNotFound,     ///< a named file is not there or cannot be opened
    Parse,            ///< a file's bytes are not what its format says
    Unsupported,      ///< well formed, but a feature that is not read
    OutOfResources,   ///< memory or disk
    Cancelled,        ///< the user asked to stop
    Internal          ///< a bug
};

/// An expected failure. `where` is "file:line" (or "file", or a key path), `message` says what was
/// seen and what was expected.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
    std::string where;

    /// "where: message", or the message alone.
    [[nodiscard]] std::string text() const { return where.empty() ? message : where + ": " + message; }
};

/// A value or an Error. Names follow std::expected, which GCC 12 has only under C++23.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    T& value() & { return std::get<0>(state_); }
    const T& value() const& { return std::get<0>(state_); }
    T&& value() && { return std::get<0>(std::move(state_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    [[nodiscard]] const Error& error() const { return std::get<1>(state_); }

private:
    std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    [[nodiscard]] bool has_value() const { return !error_.has_value(); }
    explicit operator bool() const { return has_value(); }
    [[nodiscard]] const Error& error() const { return *error_; }

private:
    std::optional<Error> error_;
};

}  // namespace luxdeck
