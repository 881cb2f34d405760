#pragma once

#include "engine/io/gltf_json.h"
#include "engine/io/obj_files.h"
#include "engine/io/warning_list.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luxdeck::gltf {

/// The numbers an accessor or a sparse part of it stands for; the range is checked to lie in `bytes`.
struct ElementRange {
    std::string_view bytes;      ///< from the first element on; empty: all zeros
    std::size_t strideBytes = 0;
};

struct SparseRange {
    std::uint64_t count = 0;
    int indexType = 0;           ///< glTF component type code
    ElementRange indices;
    ElementRange values;
};

/// A checked accessor: every element it claims is there.
struct Accessor {
    std::uint64_t count = 0;
    int componentType = 0;       ///< 5120 BYTE .. 5126 FLOAT
    int components = 0;          ///< 1 SCALAR .. 4 VEC4, 9, 16
    bool normalized = false;
    bool zeros = false;          ///< no bufferView
    ElementRange elements;
    std::optional<SparseRange> sparse;
};

/// A glTF file with its buffers, whose sizes and ranges have been checked. Not movable: views point into it.
///
/// Protocol: open(), then anything; after each step ask failure.failed().
class Document {
public:
    /// errors  FileNotFound, Parse, Unsupported
    static Result<std::unique_ptr<Document>> open(const std::filesystem::path& file);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    [[nodiscard]] JsonView root() { return {&json_, "", failure}; }
    [[nodiscard]] const std::vector<Accessor>& accessors() const { return accessors_; }
    [[nodiscard]] std::size_t bufferViewCount() const { return views_.size(); }
    /// The bytes of a bufferView, index in range.
    [[nodiscard]] std::string_view viewBytes(std::size_t index) const { return views_[index].bytes; }
    /// What a "uri" names: embedded data, or a file in the folder of this one or below it.
    Result<std::string> load(const JsonView& uri);

    Failure failure;
    WarningList warnings;

private:
    struct BufferView {
        std::string_view bytes;
        std::size_t strideBytes = 0;  ///< 0: elements lie one after the other
    };

    explicit Document(std::filesystem::path file) : failure(file.string()), file_(std::move(file)) {}
    void parse();
    std::string_view splitGlb();
    void checkHead();  ///< version, scene, required extensions
    void loadBuffers();
    void readViews();
    void readAccessors();
    Accessor readAccessor(const JsonView& json);
    SparseRange readSparse(const JsonView& json, const Accessor& accessor);
    ElementRange range(const JsonView& owner, std::size_t view, std::uint64_t offset, std::uint64_t count,
                       std::size_t elementBytes);

    std::filesystem::path file_;
    obj::FileFinder files_;
    std::string bytes_;               ///< the file itself; the GLB's binary chunk is read in place
    std::optional<std::string_view> binaryChunk_;
    nlohmann::json json_;
    std::vector<std::string> storage_;
    std::vector<std::string_view> buffers_;
    std::vector<BufferView> views_;
    std::vector<Accessor> accessors_;
};

/// Bytes of one component of a glTF type code; 0: no such type.
std::size_t componentBytes(int componentType);

}  // namespace luxdeck::gltf
