#include "analysis/furniture/triangle_stream.h"

#include "engine/core/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace luxdeck {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

constexpr std::size_t kStlHead = 84, kStlTriangle = 50;

class StlStream final : public TriangleStream {
public:
    StlStream(File file, std::string name, std::uint64_t count) : file_(std::move(file)), name_(std::move(name)), left_(count) {}

    Result<void> next(std::vector<Triangle>& out, std::size_t most) override {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(most, left_));
        bytes_.resize(count * kStlTriangle);
        out.resize(count);
        if (std::fread(bytes_.data(), kStlTriangle, count, file_.get()) != count)
            return Error{ErrorCode::Parse, fmt::format("ends {} triangles early", left_), name_};
        for (std::size_t i = 0; i < count; ++i) {
            std::array<float, 9> xyz{};
            std::memcpy(xyz.data(), bytes_.data() + i * kStlTriangle + 12, sizeof xyz);
            for (std::size_t c = 0; c < 3; ++c) out[i][c] = {xyz[3 * c], xyz[3 * c + 1], xyz[3 * c + 2]};
        }
        left_ -= count;
        return {};
    }

private:
    File file_;
    std::string name_;
    std::uint64_t left_;
    std::vector<char> bytes_;
};

class ObjStream final : public TriangleStream {
public:
    ObjStream(File file, std::string name) : file_(std::move(file)), name_(std::move(name)), window_(1024) {}

    Result<void> next(std::vector<Triangle>& out, std::size_t most) override {
        out.clear();
        std::string_view line;
        while (out.size() < most) {
            if (const auto read = nextLine(line); !read) return read.error();
            else if (!*read) break;
            const bool vertex = line.starts_with("v ") || line.starts_with("v\t");
            const bool face = line.starts_with("f ") || line.starts_with("f\t");
            if (!vertex && !face) continue;
            if (const auto done = vertex ? addVertex(line.substr(2)) : addFace(line.substr(2), out); !done) return done;
        }
        return {};
    }

private:
    static constexpr std::size_t kWindow = std::size_t{1} << 22;
    static constexpr std::size_t kLongestLine = 1 << 16;

    [[nodiscard]] Error wrong(const std::string& what) const { return {ErrorCode::Parse, what, fmt::format("{}:{}", name_, line_)}; }

    Result<bool> nextLine(std::string_view& line) {
        for (;;) {
            if (const auto end = buffer_.find('\n', at_); end != std::string::npos) {
                line = std::string_view(buffer_).substr(at_, end - at_);
                at_ = end + 1, ++line_;
                return true;
            }
            buffer_.erase(0, at_), at_ = 0;
            if (buffer_.size() > kLongestLine) return wrong("a line is longer than 64 KiB");
            const std::size_t had = buffer_.size();
            buffer_.resize(had + kLongestLine);
            const std::size_t got = std::fread(buffer_.data() + had, 1, kLongestLine, file_.get());
            buffer_.resize(had + got);
            if (got > 0) continue;
            if (had == 0) return false;
            buffer_ += '\n';  // the last line may lack it
        }
    }

    static bool skipBlanks(std::string_view& text) {
        const auto first = text.find_first_not_of(" \t\r");
        text.remove_prefix(first == std::string_view::npos ? text.size() : first);
        return !text.empty();
    }

    Result<void> addVertex(std::string_view text) {
        Vec3 p{0, 0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            skipBlanks(text);
            const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), p[axis]);
            if (code != std::errc()) return wrong("a vertex without three numbers");
            text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        }
        if (count_ == window_.size() && window_.size() < kWindow) {  // not yet round: indices stay where they are
            window_.resize(2 * window_.size());
        }
        window_[count_++ % window_.size()] = p;
        return {};
    }

    Result<void> addFace(std::string_view text, std::vector<Triangle>& out) {
        Triangle corners{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)};
        std::size_t count = 0;
        for (; skipBlanks(text); ++count) {
            std::int64_t index = 0;
            const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), index);
            if (code != std::errc()) return wrong("a face whose corner is not a number");
            const auto absolute = index > 0 ? index - 1 : static_cast<std::int64_t>(count_) + index;
            if (index == 0 || absolute < 0 || static_cast<std::uint64_t>(absolute) >= count_) return wrong(fmt::format("a face uses vertex {} of {}", index, count_));
            if (static_cast<std::uint64_t>(absolute) + window_.size() < count_)
                return wrong(fmt::format("a face uses vertex {}, expected one of the last {}", index, window_.size()));
            text.remove_prefix(std::min(text.size(), text.find_first_of(" \t\r", static_cast<std::size_t>(end - text.data()))));
            const Vec3& p = window_[static_cast<std::size_t>(absolute) % window_.size()];
            if (count < 3) corners[count] = p;
            else corners[1] = corners[2], corners[2] = p;
            if (count >= 2) out.push_back(corners);
        }
        if (count < 3) return wrong("a face with fewer than three corners");
        return {};
    }

    File file_;
    std::string name_;
    std::string buffer_;
    std::size_t at_ = 0;
    std::uint64_t line_ = 0;
    std::vector<Vec3> window_;  // the last vertices, round
    std::uint64_t count_ = 0;   // of vertices so far
};

Result<std::unique_ptr<TriangleStream>> openStl(File file, const std::filesystem::path& path) {
    std::array<unsigned char, kStlHead> head{};
    if (std::fread(head.data(), 1, head.size(), file.get()) != head.size()) return Error{ErrorCode::Parse, "shorter than the head of a binary STL", path.string()};
    std::uint32_t count = 0;
    std::memcpy(&count, head.data() + 80, 4);
    std::error_code unknown;
    const auto size = std::filesystem::file_size(path, unknown);
    if (!unknown && size != kStlHead + std::uint64_t{count} * kStlTriangle)
        return Error{ErrorCode::Parse, fmt::format("{} bytes, expected {} of a binary STL of {} triangles", size, kStlHead + std::uint64_t{count} * kStlTriangle, count), path.string()};
    return std::unique_ptr<TriangleStream>(new StlStream(std::move(file), path.string(), count));
}

}  // namespace

Result<std::unique_ptr<TriangleStream>> TriangleStream::open(const std::filesystem::path& path) {
    const auto extension = lowerExtension(path);
    if (extension != ".stl" && extension != ".obj")
        return Error{ErrorCode::Unsupported, fmt::format("\"{}\" files are not streamed, expected .stl (binary) or .obj", extension), path.string()};
    File file(std::filesystem::is_directory(path) ? nullptr : std::fopen(path.c_str(), "rb"));
    if (!file) return Error{ErrorCode::FileNotFound, "cannot be opened", path.string()};
    if (extension == ".stl") return openStl(std::move(file), path);
    return std::unique_ptr<TriangleStream>(new ObjStream(std::move(file), path.string()));
}

}  // namespace luxdeck
