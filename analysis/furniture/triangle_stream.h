#pragma once

#include "engine/core/result.h"
#include "engine/core/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace luxdeck {

/// The triangles of a file of any size, some at a time, in bounded memory.
///
/// .stl  binary STL: 80 bytes of anything, the number of triangles (32 bits), then 50 bytes each: a normal (not used), three
///       vertices, two bytes; little-endian
/// .obj  its `v` and `f` lines, one after the other; polygons as fans. A face may use the last 4 million vertices before it.
class TriangleStream {
public:
    using Triangle = std::array<Vec3, 3>;  // in the file's coordinates

    virtual ~TriangleStream() = default;
    /// Replaces `out` by the next triangles, at most that many; none: the end.
    ///
    /// errors  Parse: cut off, or not what the format says
    virtual Result<void> next(std::vector<Triangle>& out, std::size_t most) = 0;

    /// errors  FileNotFound; Unsupported: another extension; Parse: a text STL, or its size and number do not agree
    static Result<std::unique_ptr<TriangleStream>> open(const std::filesystem::path& path);
};

}  // namespace luxdeck
