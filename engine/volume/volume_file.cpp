#include "engine/volume/volume_file.h"

#include "engine/core/file.h"
#include "engine/volume/volume_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <optional>

namespace luxdeck {

namespace {

constexpr std::string_view kRawData = "<AppendedData encoding=\"raw\">\n_";
constexpr std::string_view kHashMark = "<!-- luxdeck-volume/1 xxh3 ";
constexpr std::uint64_t kMostFileBytes = 1ULL << 36;

// Of a vertex' statistics, as the file has them.
struct StatisticsRow {
    std::array<float, 6> lux, spread;
    float backFaces, nearestM;
};
struct SourceRow {
    float direction[3], lux[3], direct;
};

/// The arrays of a file: their headers as XML, their bytes behind each other.
class Arrays {
public:
    template <class T>
    std::string add(const char* type, const char* name, std::size_t components, std::span<const T> values) {
        return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type, name, components,
                           append({reinterpret_cast<const char*>(values.data()), values.size_bytes()}));
    }
    template <class T>
    std::string add(const char* type, const char* name, std::size_t components, const std::vector<T>& values) {
        return add(type, name, components, std::span<const T>(values));
    }
    std::string addText(const char* name, const std::string& text) {
        const std::string offset = append({text.c_str(), text.size() + 1});
        return fmt::format("<DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"1\" format=\"appended\" offset=\"{}\"/>\n", name, offset);
    }
    /// An array of the data set as a whole, which says its own length.
    template <class T>
    std::string addField(const char* type, const char* name, std::size_t components, const std::vector<T>& values) {
        const std::size_t tuples = values.size() * sizeof(T) / (sizeOf(type) * components);
        const std::string offset = append({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
        return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type, name,
                           components, tuples, offset);
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    static std::size_t sizeOf(std::string_view type) { return type == "UInt8" ? 1 : type == "Float64" || type == "Int64" ? 8 : 4; }

    /// returns the offset
    std::string append(std::string_view bytes) {
        const auto offset = fmt::format("{}", bytes_.size());
        const std::uint64_t size = bytes.size();
        bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
        bytes_.append(bytes);
        return offset;
    }

    std::string bytes_;
};

std::string fieldData(const IrradianceVolume& v, Arrays& arrays) {
    std::vector<std::uint32_t> children, starts{0};
    for (const auto& cell : v.lattice.cells()) children.push_back(cell.firstChild);
    std::vector<SourceRow> rows;
    for (const auto& list : v.sources) {
        for (const auto& s : list) rows.push_back({{s.direction.x, s.direction.y, s.direction.z}, {s.lux.r, s.lux.g, s.lux.b}, s.direct ? 1.0F : 0.0F});
        starts.push_back(static_cast<std::uint32_t>(rows.size()));
    }
    return "<FieldData>\n" + arrays.addText("luxdeck", headerText(v)) + arrays.addField("UInt32", "firstChild", 1, children) +
           arrays.addField("UInt8", "occupied", 1, v.occupied) + arrays.addField("UInt32", "sourceStart", 1, starts) +
           arrays.addField("Float32", "sources", 7, rows) + "</FieldData>\n";
}

std::string pointData(const IrradianceVolume& v, Arrays& arrays) {
    std::vector<std::array<float, 6>> lux;
    std::vector<float> mean, error;
    std::vector<std::uint8_t> usable;
    std::vector<StatisticsRow> statistics;
    std::vector<std::array<std::uint32_t, 3>> samples;
    for (const auto& q : v.quality) {
        lux.push_back(q.lux), mean.push_back(static_cast<float>(q.meanLux()));
        error.push_back(static_cast<float>(1.96 * q.standardError()));
        usable.push_back(q.usable() ? 1 : 0);
        statistics.push_back({q.lux, q.spread, q.backFaces, q.nearestM});
        samples.push_back({q.samples, q.rejected, q.inside ? 1U : 0U});
    }
    const std::size_t bins = v.binCount();
    return "<PointData Scalars=\"mean illuminance [lx]\">\n" + arrays.add("Float32", "mean illuminance [lx]", 1, mean) +
           arrays.add("Float32", "illuminance facing +x -x +y -y +z -z [lx]", 6, lux) + arrays.add("Float32", "ci95 [lx]", 1, error) +
           arrays.add("UInt8", "usable", 1, usable) + arrays.add("Float32", "statistics", 14, statistics) +
           arrays.add("UInt32", "samples, rejected, inside", 3, samples) + arrays.add("Float32", "direct radiance [cd/m2]", 3 * bins, v.direct) +
           arrays.add("Float32", "indirect radiance [cd/m2]", 3 * bins, v.indirect) + "</PointData>\n";
}

std::string geometry(const IrradianceVolume& v, Arrays& arrays, std::size_t& cellCount) {
    constexpr std::array<int, 8> kOrder{0, 1, 3, 2, 4, 5, 7, 6};  // VTK goes round a face
    std::vector<std::array<double, 3>> points;
    for (const auto& p : v.lattice.vertices()) points.push_back({p.x + v.origin.x, p.y + v.origin.y, p.z + v.origin.z});
    std::vector<std::int64_t> corners, ends;
    std::vector<std::uint8_t> types, levels, occupied;
    for (std::uint32_t i = 0; i < v.lattice.cells().size(); ++i) {
        if (v.lattice.divided(i)) continue;
        for (const int corner : kOrder) corners.push_back(v.lattice.cells()[i].vertices[static_cast<std::size_t>(corner)]);
        ends.push_back(static_cast<std::int64_t>(corners.size()));
        types.push_back(12);  // hexahedron
        levels.push_back(static_cast<std::uint8_t>(v.lattice.levelOf(i))), occupied.push_back(v.occupied[i]);
    }
    cellCount = types.size();
    return "<CellData>\n" + arrays.add("UInt8", "level", 1, levels) + arrays.add("UInt8", "holds geometry", 1, occupied) + "</CellData>\n<Points>\n" +
           arrays.add("Float64", "position [m]", 3, points) + "</Points>\n<Cells>\n" + arrays.add("Int64", "connectivity", 1, corners) +
           arrays.add("Int64", "offsets", 1, ends) + arrays.add("UInt8", "types", 1, types) + "</Cells>\n";
}

/// One array as a file has it.
struct Found {
    std::string type;
    std::size_t components = 1;
    std::string_view bytes;
};

std::optional<std::string> attribute(std::string_view tag, std::string_view name) {
    const auto at = tag.find(fmt::format(" {}=\"", name));
    if (at == std::string_view::npos) return std::nullopt;
    const auto begin = at + name.size() + 3, end = tag.find('"', begin);
    if (end == std::string_view::npos) return std::nullopt;
    return std::string(tag.substr(begin, end - begin));
}

class Reader {
public:
    Reader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    Result<IrradianceVolume> read(Checksum checksum) {
        if (const auto found = findArrays(checksum); !found) return found.error();
        IrradianceVolume volume;
        const auto text = take<char>("luxdeck", "String", 1);
        if (!text) return text.error();
        const auto shape = readHeader(std::string_view(text->data(), text->empty() ? 0 : text->size() - 1), name_, volume);
        if (!shape) return shape.error();
        if (const auto done = readLattice(*shape, volume); !done) return done.error();
        if (const auto done = readVertices(volume); !done) return done.error();
        if (const auto done = readSources(volume); !done) return done.error();
        return volume;
    }

private:
    [[nodiscard]] Error bad(const std::string& what) const { return {ErrorCode::Parse, what, name_}; }

    Result<void> findArrays(Checksum checksum) {
        const auto raw = bytes_.find(kRawData);
        const auto mark = bytes_.substr(0, 512).find(kHashMark);
        if (raw == std::string_view::npos || mark == std::string_view::npos || mark + kHashMark.size() > raw)
            return bad("is not a volume that Luxdeck wrote, expected a .vtu file with \"luxdeck-volume/1\" at its beginning");
        const std::string_view head = bytes_.substr(0, raw);
        data_ = bytes_.substr(raw + kRawData.size());
        const auto hash = head.substr(mark + kHashMark.size(), 16);
        const auto size = attribute(head.substr(0, head.find("<UnstructuredGrid>")), "bytes");
        std::uint64_t expected = 0;
        if (size) std::from_chars(size->data(), size->data() + size->size(), expected);
        if (expected > data_.size()) return bad(fmt::format("is cut off: {} bytes of data, expected {}", data_.size(), expected));
        data_ = data_.substr(0, expected);
        if (checksum == Checksum::Checked && contentHash(data_) != hash)
            return bad(fmt::format("its data was changed or damaged: hash {}, expected {}", contentHash(data_), hash));
        for (std::size_t at = head.find("<DataArray"); at != std::string_view::npos; at = head.find("<DataArray", at + 1))
            if (const auto found = findArray(head.substr(at, head.find("/>", at) - at)); !found) return found;
        return {};
    }

    Result<void> findArray(std::string_view tag) {
        const auto name = attribute(tag, "Name"), type = attribute(tag, "type"), offset = attribute(tag, "offset");
        if (!name || !type || !offset) return bad("an array without name, type or offset");
        std::uint64_t at = 0, size = 0, components = 1;
        std::from_chars(offset->data(), offset->data() + offset->size(), at);
        if (const auto n = attribute(tag, "NumberOfComponents")) std::from_chars(n->data(), n->data() + n->size(), components);
        if (data_.size() < sizeof size || at > data_.size() - sizeof size) return bad(fmt::format("array \"{}\" begins behind the end of the data", *name));
        std::memcpy(&size, data_.data() + at, sizeof size);
        if (size > data_.size() - at - sizeof size) return bad(fmt::format("array \"{}\" has {} bytes, more than there are", *name, size));
        arrays_[*name] = {*type, components, data_.substr(at + sizeof size, size)};
        return {};
    }

    /// The values of an array, `Row` being one tuple or a part of one.
    template <class Row>
    Result<std::vector<Row>> take(const std::string& name, const char* type, std::size_t components) {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return bad(fmt::format("no array \"{}\"", name));
        const auto& a = found->second;
        if (a.type != type || a.components != components || a.bytes.size() % sizeof(Row) != 0)
            return bad(fmt::format("array \"{}\" is {} x {} with {} bytes, expected {} x {}", name, a.type, a.components, a.bytes.size(), type, components));
        std::vector<Row> out(a.bytes.size() / sizeof(Row));
        std::memcpy(static_cast<void*>(out.data()), a.bytes.data(), a.bytes.size());
        return out;
    }
    template <class Row>
    Result<void> takeInto(std::vector<Row>& out, const std::string& name, const char* type, std::size_t components, std::size_t count) {
        auto values = take<Row>(name, type, components);
        if (!values) return values.error();
        if (values->size() != count) return bad(fmt::format("array \"{}\" has {} rows, expected {}", name, values->size(), count));
        out = *std::move(values);
        return {};
    }

    Result<void> readLattice(const VolumeShape& shape, IrradianceVolume& volume) {
        const auto children = take<std::uint32_t>("firstChild", "UInt32", 1);
        if (!children) return children.error();
        double firstLevel = 1;
        for (const int n : shape.cells) firstLevel *= n;
        if (firstLevel > static_cast<double>(children->size()))
            return bad(fmt::format("{:.0f} cells in the first level, but {} in all", firstLevel, children->size()));
        auto lattice = Lattice::restore(shape.bounds, shape.cells, shape.split, shape.depth, *children);
        if (!lattice) return bad(lattice.error().message);
        volume.lattice = *std::move(lattice);
        return takeInto(volume.occupied, "occupied", "UInt8", 1, children->size());
    }

    Result<void> readVertices(IrradianceVolume& volume) {
        const std::size_t count = volume.vertexCount(), bins = volume.binCount();
        std::vector<StatisticsRow> statistics;
        std::vector<std::array<std::uint32_t, 3>> samples;
        if (const auto done = takeInto(statistics, "statistics", "Float32", 14, count); !done) return done;
        if (const auto done = takeInto(samples, "samples, rejected, inside", "UInt32", 3, count); !done) return done;
        volume.quality.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& s = statistics[i];
            volume.quality[i] = {samples[i][0], s.lux, s.spread, s.backFaces, s.nearestM, samples[i][1], samples[i][2] != 0};
        }
        if (const auto done = takeInto(volume.direct, "direct radiance [cd/m2]", "Float32", 3 * bins, count * bins); !done) return done;
        return takeInto(volume.indirect, "indirect radiance [cd/m2]", "Float32", 3 * bins, count * bins);
    }

    Result<void> readSources(IrradianceVolume& volume) {
        std::vector<std::uint32_t> starts;
        if (const auto done = takeInto(starts, "sourceStart", "UInt32", 1, volume.vertexCount() + 1); !done) return done;
        const auto rows = take<SourceRow>("sources", "Float32", 7);
        if (!rows) return rows.error();
        if (starts.front() != 0 || starts.back() != rows->size() || !std::is_sorted(starts.begin(), starts.end()))
            return bad(fmt::format("the rays to sources do not fit their vertices: {} rays", rows->size()));
        volume.sources.resize(volume.vertexCount());
        for (std::size_t v = 0; v < volume.sources.size(); ++v)
            for (auto i = starts[v]; i < starts[v + 1]; ++i) {
                const auto& r = (*rows)[i];
                volume.sources[v].push_back({{r.direction[0], r.direction[1], r.direction[2]}, {r.lux[0], r.lux[1], r.lux[2]}, r.direct != 0});
            }
        return {};
    }

    std::string_view bytes_, data_;
    std::string name_;
    std::map<std::string, Found> arrays_;
};

}  // namespace

Result<void> writeVolume(const std::filesystem::path& path, const IrradianceVolume& v) {
    Arrays arrays;
    std::size_t cells = 0;
    const std::string field = fieldData(v, arrays), points = pointData(v, arrays), rest = geometry(v, arrays, cells);
    std::string file = fmt::format("<?xml version=\"1.0\"?>\n{}{} bytes=\"{}\" -->\n", kHashMark, contentHash(arrays.bytes()), arrays.bytes().size());
    file += "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    file += field + fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", v.vertexCount(), cells) + points + rest +
            "</Piece>\n</UnstructuredGrid>\n";
    file += kRawData;
    file += arrays.bytes();
    file += "\n</AppendedData>\n</VTKFile>\n";
    return writeFileAtomically(path, file);
}

Result<IrradianceVolume> parseVolume(std::string_view bytes, const std::filesystem::path& name, Checksum checksum) {
    try {
        return Reader(bytes, name.string()).read(checksum);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfResources, "not enough memory for the volume", name.string()};
    }
}

Result<IrradianceVolume> readVolume(const std::filesystem::path& path) {
    const auto bytes = readFile(path, kMostFileBytes);
    if (!bytes) return bytes.error();
    return parseVolume(*bytes, path);
}

std::vector<std::string> sceneChanges(const IrradianceVolume& volume, const Scene& scene) {
    std::vector<std::string> changes;
    const auto now = contentParts(scene);
    std::map<std::string, std::vector<std::string>> before, after;  // names may occur more than once
    for (const auto& part : volume.parts) before[part.name].push_back(part.hash);
    for (const auto& part : now) after[part.name].push_back(part.hash);
    for (const auto& [name, hashes] : before) {
        const auto found = after.find(name);
        if (found == after.end()) changes.push_back(name + " is gone");
        else if (found->second != hashes) changes.push_back(name + " changed");
    }
    for (const auto& [name, hashes] : after)
        if (!before.contains(name)) changes.push_back(name + " is new");
    if (changes.empty() && volume.sceneHash != sceneHash(scene)) changes.emplace_back("the order of its parts changed");
    return changes;
}

Result<void> checkVolumeIsOf(const IrradianceVolume& volume, const Scene& scene) {
    const auto changes = sceneChanges(volume, scene);
    if (changes.empty()) return {};
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, changes.size()); ++i) text += (i > 0 ? ", " : "") + changes[i];
    if (changes.size() > kShown) text += fmt::format(" and {} more", changes.size() - kShown);
    return Error{ErrorCode::InvalidArgument, fmt::format("the volume is of another state of the scene: {}; build it again (volume build --update keeps what can be kept)", text)};
}

}  // namespace luxdeck
