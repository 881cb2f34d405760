#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/io/rad_primitive.h"
#include "engine/io/rad_text.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace luxdeck::rad {

/// Takes a program's arguments one by one.
class Arguments {
public:
    Arguments(std::string program, std::span<const std::string> words, const Place& place)
        : program_(std::move(program)), words_(words), place_(place) {}

    [[nodiscard]] bool atEnd() const { return at_ >= words_.size(); }
    Result<std::string> word(const std::string& what) {
        if (atEnd()) return wrong(fmt::format("ends, expected {}", what));
        return words_[at_++];
    }
    Result<double> number(const std::string& what) {
        const auto text = word(what);
        if (!text) return text.error();
        const auto value = numberOf(*text);
        if (!value) return wrong(fmt::format("has '{}', expected {}", *text, what));
        return *value;
    }
    Result<std::vector<double>> numbers(std::size_t count, const std::string& what) {
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) {
            const auto x = number(what);
            if (!x) return x.error();
            values.push_back(*x);
        }
        return values;
    }
    [[nodiscard]] Error wrong(const std::string& message) const {
        return place_.error(ErrorCode::InvalidArgument, program_ + " " + message);
    }

private:
    std::string program_;
    std::span<const std::string> words_;
    const Place& place_;
    std::size_t at_ = 0;
};

/// What a generator writes: primitives of one material, named name.suffix.
class Made {
public:
    Made(std::string material, std::string name, const Place& place)
        : material_(std::move(material)), name_(std::move(name)), place_(place) {}

    void polygon(const std::string& suffix, const std::vector<Vec3d>& corners, std::vector<Vec3d> normals = {}) {
        std::vector<double> numbers;
        for (const auto& c : corners) numbers.insert(numbers.end(), {c.x, c.y, c.z});
        add("polygon", suffix, std::move(numbers));
        made_.back().normals = std::move(normals);
    }
    void sphere(const std::string& suffix, const Vec3d& c, double radius) { add("sphere", suffix, {c.x, c.y, c.z, radius}); }
    void cylinder(const std::string& suffix, const Vec3d& a, const Vec3d& b, double radius) {
        add("cylinder", suffix, {a.x, a.y, a.z, b.x, b.y, b.z, radius});
    }
    /// A cylinder, tube, cone, cup or ring by its numbers.
    void round(const char* type, const std::string& suffix, std::vector<double> numbers) { add(type, suffix, std::move(numbers)); }
    [[nodiscard]] std::size_t count() const { return made_.size(); }
    Primitives take() { return std::move(made_); }

private:
    void add(const char* type, const std::string& suffix, std::vector<double> numbers) {
        made_.push_back({material_, type, name_ + "." + suffix, {}, std::move(numbers), {}, place_, nullptr});
    }

    std::string material_, name_;
    Place place_;
    Primitives made_;
};

}  // namespace luxdeck::rad
