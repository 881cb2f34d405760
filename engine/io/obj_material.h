#pragma once

#include "engine/core/result.h"
#include "engine/io/obj_files.h"
#include "engine/io/warning_list.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace luxdeck::obj {

/// What an MTL file says of one material, as it says it.
struct MtlRecord {
    struct Map {
        std::string file;
        TextureSlot slot;
        bool clamp = false;
    };
    std::string name;
    std::string where;           ///< file:line
    std::optional<Rgb> kd, ks, ke, tf;
    double ns = 0;               ///< Phong exponent
    double dissolve = 1;         ///< d, or 1 - Tr
    double ior = 1.5;
    int illum = -1;              ///< -1: not given
    std::optional<double> pr, pm;///< roughness and metalness of the PBR extension
    std::optional<Map> mapKd, mapKe;
};

/// The materials of an OBJ file, by name.
class MaterialLibrary {
public:
    MaterialLibrary(Scene& scene, WarningList& warnings) : scene_(scene), warnings_(warnings) {}

    /// Reads an MTL file. One that is missing is a warning: its materials become grey.
    Result<void> read(const std::filesystem::path& file);
    [[nodiscard]] bool describes(const std::string& name) const { return described_.contains(name); }
    /// The index of a material in the scene; a grey one for names that no library has.
    std::uint32_t find(const std::string& name);

private:
    Material convert(const MtlRecord& record);
    void chooseKind(const MtlRecord& record, Material& material);
    void limitSpecular(Material& material);
    TextureSlot loadMap(const std::optional<MtlRecord::Map>& map, const Material& material);
    Rgb reflectance(const Rgb& value, const char* key, const Material& material);
    void warn(const Material& material, const std::string& text);

    Scene& scene_;
    WarningList& warnings_;
    FileFinder files_;
    std::filesystem::path folder_;
    std::map<std::string, std::uint32_t, std::less<>> indices_;
    std::set<std::string, std::less<>> described_;  // by a library
    std::map<std::tuple<std::string, bool>, std::int32_t> textures_;  // file, clamped -> scene texture; -1: cannot be read
};

}  // namespace luxdeck::obj
