#include "engine/io/gltf_document.h"

#include "engine/core/file.h"
#include "engine/io/gltf_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <set>
#include <utility>

namespace luxdeck::gltf {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian and read in place");

namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

/// Zeros that no buffer stands for may be claimed up to this count: more must be justified by the file.
constexpr std::uint64_t kFreeZeros = 65536;

std::uint32_t word(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

int componentCount(const std::string& type) {
    static const std::array<std::pair<const char*, int>, 7> kTypes{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, count] : kTypes)
        if (type == name) return count;
    return 0;
}

/// Extensions that a file may require: read, or changing only how a surface looks (told when met).
const std::set<std::string, std::less<>>& knownExtensions() {
    static const std::set<std::string, std::less<>> kKnown{
        "EXT_lights_ies",          "KHR_lights_punctual",          "KHR_mesh_quantization",
        "EXT_mesh_gpu_instancing", "KHR_node_visibility",          "KHR_animation_pointer",
        "KHR_node_selectability",  "KHR_node_hoverability",        "KHR_interactivity",
        "KHR_xmp_json_ld",         "KHR_xmp",                      "MSFT_lod",
        "KHR_texture_transform",   "KHR_materials_clearcoat",      "KHR_materials_emissive_strength",
        "KHR_materials_ior",       "KHR_materials_iridescence",    "KHR_materials_sheen",
        "KHR_materials_specular",  "KHR_materials_transmission",   "KHR_materials_unlit",
        "KHR_materials_volume",    "KHR_materials_anisotropy",     "KHR_materials_dispersion",
        "KHR_materials_variants",  "KHR_materials_diffuse_transmission",
        "KHR_technique_webgl",     "KHR_techniques_webgl",         "KHR_materials_pbrSpecularGlossiness"};
    return kKnown;
}

}  // namespace

std::size_t componentBytes(int componentType) {
    switch (componentType) {
        case 5120: case 5121: return 1;
        case 5122: case 5123: return 2;
        case 5125: case 5126: return 4;
        default: return 0;
    }
}

Result<std::unique_ptr<Document>> Document::open(const std::filesystem::path& file) {
    std::unique_ptr<Document> document(new Document(file));
    auto bytes = readFile(file);
    if (!bytes) return bytes.error();
    document->bytes_ = std::move(*bytes);
    for (const auto step : {&Document::parse, &Document::checkHead, &Document::loadBuffers, &Document::readViews,
                            &Document::readAccessors}) {
        (document.get()->*step)();
        if (document->failure.failed()) return document->failure.error();
    }
    return document;
}

void Document::parse() {
    std::string_view text = bytes_;
    if (text.size() >= 4 && word(text, 0) == kGlbMagic) text = splitGlb();
    if (failure.failed()) return;
    try {
        json_ = nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& e) {
        // "[json.exception.parse_error.101] parse error at line 3, column 7: ..."
        const std::string what = e.what();
        const auto bracket = what.find("] ");
        failure.set("", bracket == std::string::npos ? what : what.substr(bracket + 2));
    }
    if (!failure.failed() && !json_.is_object()) failure.set("", "the document is not a JSON object");
}

std::string_view Document::splitGlb() {
    const std::string_view all = bytes_;
    constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
    if (all.size() < kHeaderBytes + kChunkHeaderBytes) return failure.set("", "GLB header is cut off"), all;
    if (word(all, 4) != 2)
        return failure.set("", fmt::format("is GLB version {}, expected 2", word(all, 4)), ErrorCode::Unsupported), all;
    if (word(all, 8) > all.size())
        return failure.set("", fmt::format("GLB header says {} bytes, the file has {}", word(all, 8), all.size())), all;
    std::string_view json;
    for (std::size_t at = kHeaderBytes; at + kChunkHeaderBytes <= word(all, 8);) {
        const std::uint32_t length = word(all, at), type = word(all, at + 4);
        at += kChunkHeaderBytes;
        if (length > all.size() - at)
            return failure.set("", fmt::format("GLB chunk at byte {} says {} bytes, {} are left", at - kChunkHeaderBytes,
                                               length, all.size() - at)), all;
        if (type == kJsonChunk && json.empty()) json = all.substr(at, length);
        if (type == kBinaryChunk && !binaryChunk_) binaryChunk_ = all.substr(at, length);
        at += length;
    }
    if (json.empty()) failure.set("", "GLB file without a JSON chunk");
    return json;
}

void Document::checkHead() {
    const auto asset = root()["asset"];
    if (!asset.present()) return asset.fail("is missing, expected an object with the glTF version");
    const std::string version = asset["version"].text();
    if (!version.starts_with("2."))
        asset["version"].fail(fmt::format("is '{}', expected 2.0", version), ErrorCode::Unsupported);
    // Before the buffers: a broken document is told as such even when its buffers are missing too.
    (void)root()["scene"].index(root()["scenes"].size(), "scenes", false);
    const auto used = root()["extensionsUsed"];
    for (std::size_t i = 0; i < used.size(); ++i) {
        const std::string name = used.at(i).text();
        if (!knownExtensions().contains(name)) warnings.add(name + " is left out: what the file gives without it is read");
        if (name.find("technique") != std::string::npos)
            warnings.add(name + ": shader programs are left out, materials keep their plain factors");
    }
    const auto required = root()["extensionsRequired"];
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string name = required.at(i).text();
        if (!knownExtensions().contains(name))
            required.at(i).fail(fmt::format("the file cannot be read without {}, which is not supported", name),
                                ErrorCode::Unsupported);
    }
}

Result<std::string> Document::load(const JsonView& uri) {
    const std::string reference = uri.text();
    const auto at = [&](Error error) {
        error.where = failure.file();
        error.message = uri.path() + ": " + error.message;
        return error;
    };
    if (auto embedded = decodeDataUri(reference)) {
        if (!*embedded) return at(embedded->error());
        return std::move(*embedded);
    }
    const auto file = files_.find(file_.parent_path(), percentDecoded(reference));
    if (!file) return at(file.error());
    if (!file->note.empty()) warnings.add(fmt::format("{} {}", uri.path(), file->note));
    auto bytes = readFile(file->path);
    if (!bytes) return at({bytes.error().code, fmt::format("'{}' {}", file->path.string(), bytes.error().message), ""});
    return bytes;
}

void Document::loadBuffers() {
    const auto list = root()["buffers"];
    storage_.reserve(list.size());  // buffers_ points into its strings, which must not move
    for (std::size_t i = 0; i < list.size() && !failure.failed(); ++i) {
        const auto buffer = list.at(i);
        const std::uint64_t declared = buffer["byteLength"].count();
        std::string_view bytes;
        if (buffer["uri"].present()) {
            auto loaded = load(buffer["uri"]);
            if (!loaded) return failure.set(loaded.error());
            bytes = storage_.emplace_back(std::move(*loaded));
        } else if (i == 0 && binaryChunk_) {
            bytes = *binaryChunk_;
        } else {
            return buffer.fail("has no uri, and is not a GLB file's first buffer");
        }
        if (declared > bytes.size())
            return buffer["byteLength"].fail(fmt::format("is {}, but only {} bytes are there", declared, bytes.size()));
        buffers_.push_back(bytes.substr(0, declared));
    }
}

void Document::readViews() {
    const auto list = root()["bufferViews"];
    for (std::size_t i = 0; i < list.size() && !failure.failed(); ++i) {
        const auto view = list.at(i);
        const auto buffer = view["buffer"].index(buffers_.size(), "buffers");
        const std::uint64_t offset = view["byteOffset"].count(0), length = view["byteLength"].count();
        const std::uint64_t stride = view["byteStride"].count(0);
        if (failure.failed()) return;
        const auto bytes = buffers_[static_cast<std::size_t>(buffer)];
        if (offset > bytes.size() || length > bytes.size() - offset)
            return view.fail(fmt::format("bytes {} + {} lie outside buffer {} of {} bytes", offset, length, buffer,
                                         bytes.size()));
        if (view["byteStride"].present() && (stride < 4 || stride > 252))
            return view["byteStride"].fail(fmt::format("is {}, expected 4 .. 252", stride));
        views_.push_back({bytes.substr(offset, length), stride});
    }
}

ElementRange Document::range(const JsonView& owner, std::size_t view, std::uint64_t offset, std::uint64_t count,
                             std::size_t elementBytes) {
    const BufferView& source = views_[view];
    const std::size_t stride = source.strideBytes != 0 ? source.strideBytes : elementBytes;
    const std::uint64_t size = source.bytes.size();
    // Written so that no claimed number can overflow: the last element must end inside the view.
    const bool fits = offset <= size && elementBytes <= size - offset &&
                      (count == 0 || count - 1 <= (size - offset - elementBytes) / stride);
    if (!fits && count > 0) {
        owner.fail(fmt::format("claims {} elements of {} bytes every {} bytes from byte {}, but bufferView {} has {} bytes",
                               count, elementBytes, stride, offset, view, size));
        return {};
    }
    return {count > 0 ? source.bytes.substr(offset) : std::string_view{}, stride};
}

SparseRange Document::readSparse(const JsonView& json, const Accessor& accessor) {
    SparseRange sparse;
    sparse.count = json["count"].count();
    const auto indices = json["indices"], values = json["values"];
    sparse.indexType = static_cast<int>(std::min<std::uint64_t>(indices["componentType"].count(), 65535));
    const auto indexView = indices["bufferView"].index(views_.size(), "bufferViews");
    const auto valueView = values["bufferView"].index(views_.size(), "bufferViews");
    const std::uint64_t indexOffset = indices["byteOffset"].count(0), valueOffset = values["byteOffset"].count(0);
    if (failure.failed()) return sparse;
    if (sparse.indexType != 5121 && sparse.indexType != 5123 && sparse.indexType != 5125)
        return indices["componentType"].fail(fmt::format("is {}, expected 5121, 5123 or 5125", sparse.indexType)), sparse;
    if (sparse.count > accessor.count)
        return json["count"].fail(fmt::format("is {}, expected at most the accessor's {}", sparse.count, accessor.count)),
               sparse;
    sparse.indices = range(indices, static_cast<std::size_t>(indexView), indexOffset, sparse.count,
                           componentBytes(sparse.indexType));
    sparse.values = range(values, static_cast<std::size_t>(valueView), valueOffset, sparse.count,
                          componentBytes(accessor.componentType) * static_cast<std::size_t>(accessor.components));
    return sparse;
}

Accessor Document::readAccessor(const JsonView& json) {
    Accessor accessor;
    accessor.count = json["count"].count();
    accessor.componentType = static_cast<int>(std::min<std::uint64_t>(json["componentType"].count(), 65535));
    accessor.components = componentCount(json["type"].text());
    accessor.normalized = json["normalized"].flag(false);
    const auto view = json["bufferView"].index(views_.size(), "bufferViews", false);
    const std::uint64_t offset = json["byteOffset"].count(0);
    if (failure.failed()) return accessor;
    if (componentBytes(accessor.componentType) == 0)
        return json["componentType"].fail(fmt::format("is {}, expected 5120 .. 5123, 5125 or 5126", accessor.componentType)),
               accessor;
    if (accessor.components == 0)
        return json["type"].fail(fmt::format("is '{}', expected SCALAR, VEC2 .. VEC4 or MAT2 .. MAT4",
                                             json["type"].text())), accessor;
    if (view >= 0) {
        accessor.elements = range(json, static_cast<std::size_t>(view), offset, accessor.count,
                                  componentBytes(accessor.componentType) * static_cast<std::size_t>(accessor.components));
    } else {
        accessor.zeros = true;
        std::uint64_t bytesThere = kFreeZeros;
        for (const auto& buffer : buffers_) bytesThere += buffer.size();
        if (accessor.count > bytesThere)
            json["count"].fail(fmt::format("is {} without a bufferView, more than the file's bytes justify", accessor.count));
    }
    if (json["sparse"].present() && !failure.failed()) accessor.sparse = readSparse(json["sparse"], accessor);
    return accessor;
}

void Document::readAccessors() {
    const auto list = root()["accessors"];
    for (std::size_t i = 0; i < list.size() && !failure.failed(); ++i) accessors_.push_back(readAccessor(list.at(i)));
}

}  // namespace luxdeck::gltf
