/// Runs a libFuzzer target without libFuzzer: `<reader>_fuzz CORPUS` over every file of the corpus, its beginnings,
/// and copies with a byte changed. What is changed is fixed, so a failure repeats; the input at hand is
/// written to a file before it is tried, and the file stays when the process dies.

#include "tests/fuzz/fuzz_input.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// At most this many beginnings and this many changed copies of each file: a dense sample of small files,
/// and an even one of larger files.
constexpr std::size_t kMostVariants = 400;

class Replay {
public:
    explicit Replay(const std::string& reader)
        : lastInput_(fs::temp_directory_path() / ("luxdeck-replay-" + reader + "-" + std::to_string(::getpid()))) {}
    ~Replay() { fs::remove(lastInput_.path()); }
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    void file(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        const Bytes bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        input(bytes);
        const auto step = std::max<std::size_t>(1, bytes.size() / kMostVariants);
        for (std::size_t size = 0; size < bytes.size(); size += step)
            input(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
        constexpr std::uint8_t kReplacements[] = {0x00, 0xFF, 0x7F, '-', '9', '\n', '"', ' '};
        std::size_t next = 0;
        for (std::size_t at = 0; at < bytes.size(); at += step) {
            Bytes changed = bytes;
            changed[at] = kReplacements[next++ % std::size(kReplacements)];
            input(changed);
        }
    }

    [[nodiscard]] std::size_t count() const { return count_; }

private:
    void input(const Bytes& bytes) {
        lastInput_.write(luxdeck::fuzz::text(bytes.data(), bytes.size()));
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        ++count_;
    }

    luxdeck::fuzz::InputFile lastInput_;
    std::size_t count_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s CORPUS\n", argv[0]);
        return 2;
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(argv[1]))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    Replay replay(fs::path(argv[1]).filename().string());
    for (const auto& path : files) {
        std::printf("%s\n", path.filename().c_str());
        std::fflush(stdout);
        replay.file(path);
    }
    std::printf("%zu inputs made of %zu files\n", replay.count(), files.size());
    return files.empty() ? 1 : 0;
}
