#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"
#include "engine/io/cal_library.h"
#include "engine/io/rad_modifiers.h"
#include "engine/io/warning_list.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace luxdeck::rad {

/// From the file's coordinates to the scene's.
struct FileSpace {
    Matrix4d toScene;          ///< row vectors, user coordinates [m]
    double metresPerUnit = 1;  ///< of lengths
};

/// Puts the materials that surfaces use into the scene, each once, with their patterns.
class MaterialTable {
public:
    MaterialTable(const Modifiers& modifiers, CalLibrary& library, const FileSpace& space, Scene& scene, WarningList& warnings)
        : modifiers_(modifiers), library_(library), space_(space), scene_(scene), warnings_(warnings) {}

    /// The scene's material for a surface of that modifier; nothing: the surface is not seen.
    ///
    /// errors  those of mapMaterial() and makePattern(): file:line
    Result<std::optional<std::uint32_t>> find(int modifier);

    /// The product of a chain's patterns and perhaps a spotlight's cone; null: there are none.
    Result<std::shared_ptr<const Pattern>> factor(const std::vector<int>& patterns, const std::shared_ptr<const Pattern>& cone);

private:
    Result<std::uint32_t> addMixture(const Modifiers::Chain& chain);
    Result<std::uint32_t> addPlain(const Modifiers::Chain& chain);
    Result<std::uint32_t> mixedMaterial(int modifier, const Primitive& mixture);
    Result<std::shared_ptr<const Pattern>> pattern(int index);
    std::int32_t store(std::shared_ptr<const Pattern> pattern);
    std::uint32_t clear();

    const Modifiers& modifiers_;
    CalLibrary& library_;
    FileSpace space_;
    Scene& scene_;
    WarningList& warnings_;
    std::map<int, std::optional<std::uint32_t>> byModifier_;
    std::map<std::string, std::uint32_t> byContent_;  ///< definitions that are repeated word for word are one material
    std::map<int, std::shared_ptr<const Pattern>> patterns_;
    std::optional<std::uint32_t> clear_;
};

}  // namespace luxdeck::rad
