#pragma once

#include "engine/core/result.h"
#include "engine/io/rad_primitive.h"

#include <string>
#include <unordered_map>
#include <vector>

namespace luxdeck::rad {

/// The modifiers of a stream, each bound to what its own modifier meant where it stands: a later definition of a
/// name changes nothing before it.
class Modifiers {
public:
    static constexpr int kVoid = -1;

    /// What a name means at this point of the stream.
    ///
    /// errors  Parse: file:line, not defined
    [[nodiscard]] Result<int> find(const std::string& name, const Place& place) const;

    /// Adds a modifier or an alias. `primitive` must outlive this.
    [[nodiscard]] Result<void> add(const Primitive& primitive);

    /// What a surface of that modifier has: its material, and what comes before and after it in the chain.
    struct Chain {
        const Primitive* material = nullptr;  ///< or mixture; null: none, the surface is not seen
        int materialIndex = kVoid;
        std::vector<int> patterns;            ///< factors, in the order of the chain
        std::vector<const Primitive*> textures;
    };
    [[nodiscard]] Chain chain(int modifier) const;

    [[nodiscard]] const Primitive& operator[](int index) const { return *known_[static_cast<std::size_t>(index)].primitive; }
    /// The modifiers that a mixture names, by their place in its string arguments, as they were where it stands.
    [[nodiscard]] const std::vector<int>& mixed(int index) const { return known_[static_cast<std::size_t>(index)].mixed; }

private:
    struct Known {
        const Primitive* primitive = nullptr;
        int modifier = kVoid;
        std::vector<int> mixed{};
    };
    std::vector<Known> known_;
    std::unordered_map<std::string, int> names_;
};

bool isMixture(const std::string& type);

}  // namespace luxdeck::rad
