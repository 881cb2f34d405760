#pragma once

#include "tests/support/process.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::test {

/// A folder of one test's own, with the program at hand; it goes with the object.
class Scratch {
public:
    Scratch();
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, std::string_view bytes) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    /// Names of files that an unfinished write has left.
    [[nodiscard]] std::vector<std::string> leftovers() const;

    /// A room of 4 m x 5 m x 3 m with one luminaire, one grid of 3 x 4 points ("floor") and one view ("door").
    void writeRoom(const std::string& requirement = {}) const;
    /// Its project.toml alone, with `extra` behind it.
    static std::string roomProject(const std::string& requirement = {}, const std::string& extra = {});

    /// `luxdeck arguments...` in this folder.
    [[nodiscard]] ProcessSettings command(std::vector<std::string> arguments) const;
    [[nodiscard]] ProcessResult run(std::vector<std::string> arguments, std::string_view input = {}) const;
    [[nodiscard]] ProcessResult run(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment) const;
    /// The JSON it prints; discarded JSON when it fails.
    [[nodiscard]] nlohmann::ordered_json json(std::vector<std::string> arguments) const;

private:
    std::filesystem::path folder_;
};

/// The folder of test data outside the repository; empty when it is not there.
std::filesystem::path sharedData();

/// A file of any content, as it is.
std::string fileBytes(const std::filesystem::path& path);

}  // namespace luxdeck::test
