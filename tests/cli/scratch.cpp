#include "tests/cli/scratch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace luxdeck::test {

namespace fs = std::filesystem;

Scratch::Scratch() {
    auto name = (fs::temp_directory_path() / "luxdeck_cli_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void Scratch::write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
}

std::string fileBytes(const fs::path& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

std::string Scratch::read(const std::string& name) const { return fileBytes(path(name)); }

std::vector<std::string> Scratch::leftovers() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_))
        if (entry.path().extension() == ".part") found.push_back(entry.path().filename().string());
    return found;
}

std::string Scratch::roomProject(const std::string& requirement, const std::string& extra) {
    std::string text = R"(schema = "luxdeck-project/1"
[project]
name = "Room"
[[geometry]]
file = "room.obj"
unit = "m"
[[luminaire_type]]
id = "A"
file = "lamp.ies"
[[luminaire]]
type = "A"
position = [2, 2.5, 2.8]
)";
    if (!requirement.empty()) text += "[[requirement]]\nid = \"task\"\n" + requirement + "\n";
    text += R"([[grid]]
name = "floor"
origin = [0.5, 0.5, 0.8]
u = [3, 0, 0]
v = [0, 4, 0]
counts = [3, 4]
)";
    if (!requirement.empty()) text += "requirement = \"task\"\n";
    text += R"([[view]]
name = "door"
position = [0.3, 0.3, 1.6]
target = [3, 4, 1]
size = [64, 48]
)";
    return text + extra;
}

void Scratch::writeRoom(const std::string& requirement) const {
    write("room.obj", "mtllib room.mtl\no room\nv 0 0 0\nv 4 0 0\nv 4 5 0\nv 0 5 0\nv 0 0 3\nv 4 0 3\nv 4 5 3\nv 0 5 3\n"
                      "usemtl grey\nf 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
    write("room.mtl", "newmtl grey\nKd 0.5 0.5 0.5\n");
    // Lambertian downwards, 1000 cd: pi * 1000 lm.
    write("lamp.ies", "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] nobody\n[LUMCAT] Lamp\nTILT=NONE\n"
                      "1 -1 1 7 1 1 2 0.2 0.2 0\n1 1 30\n0 15 30 45 60 75 90\n0\n1000 966 866 707 500 259 0\n");
    write("project.toml", roomProject(requirement));
}

ProcessSettings Scratch::command(std::vector<std::string> arguments) const {
    ProcessSettings settings;
    settings.arguments = std::move(arguments);
    settings.arguments.insert(settings.arguments.begin(), LUXDECK_PROGRAM);
    settings.folder = folder_;
    settings.environment = {{"OCIO", ""}, {"XDG_RUNTIME_DIR", folder_.string()}};
    return settings;
}

ProcessResult Scratch::run(std::vector<std::string> arguments, std::string_view input) const {
    return runProcess(command(std::move(arguments)), input);
}

ProcessResult Scratch::run(std::vector<std::string> arguments, const std::map<std::string, std::string>& environment) const {
    auto settings = command(std::move(arguments));
    for (const auto& [name, value] : environment) settings.environment[name] = value;
    return runProcess(settings);
}

nlohmann::ordered_json Scratch::json(std::vector<std::string> arguments) const {
    const auto result = run(std::move(arguments));
    EXPECT_NE(result.exitStatus, -1) << "signal " << result.signal;
    return nlohmann::ordered_json::parse(result.out, nullptr, false);
}

fs::path sharedData() {
    const auto folder = fs::path(LUXDECK_SOURCE_DIR) / ".." / "shared" / "data";
    return fs::is_directory(folder) ? folder.lexically_normal() : fs::path{};
}

}  // namespace luxdeck::test
