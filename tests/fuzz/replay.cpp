/// Runs a libFuzzer target without libFuzzer: `<reader>_fuzz CORPUS [SECONDS [BYTES]]` over every file of the corpus, its
/// beginnings, copies with a byte changed, and then for so long over random mutations of them. What is changed is fixed
/// (of the mutations a faster machine tries more), so a failure repeats; the input at hand is written to a file before it
/// is tried, and the file stays when the process dies. A block of memory of more than BYTES times the input ends it.

#include "tests/fuzz/fuzz_input.h"

#include "engine/core/rng.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

/// A reader takes no block of memory that the input does not justify: this many bytes for one of it, and what it needs
/// whatever the input is (tables, buffers of libraries, the bounded results of generators in Radiance's scenes).
std::size_t mostPerByte = 100;
constexpr std::size_t kAlways = 8U << 20;

std::atomic<std::size_t> largestBlock{SIZE_MAX};  // allowed now

void* allocate(std::size_t size) {
    if (size > largestBlock) {
        std::fprintf(stderr, "a block of %zu bytes, expected at most %zu for this input\n", size, largestBlock.load());
        std::abort();
    }
    void* block = std::malloc(size > 0 ? size : 1);
    if (block == nullptr) throw std::bad_alloc();
    return block;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t) noexcept { std::free(block); }

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// At most this many beginnings and this many changed copies of each file: a dense sample of small files,
/// and an even one of larger files.
constexpr std::size_t kMostVariants = 400;

Bytes bytesOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// One to eight changes of the kinds that readers stumble over: bytes, pieces moved, doubled, left out or of another file.
Bytes mutated(Bytes bytes, const Bytes& other, luxdeck::RandomStream& random) {
    constexpr const char* kWords[] = {"-1", "0", "nan", "1e308", "99999999999999999999", "\n", "\"", "{", "[", "\xFF\xFF\xFF\xFF", "\x7F\xFF\xFF\xFF"};
    const auto at = [&](const Bytes& b) { return static_cast<std::ptrdiff_t>(random.below(b.size() + 1)); };
    for (auto changes = 1 + random.below(8); changes > 0; --changes) {
        auto from = at(bytes), to = at(bytes);
        if (from > to) std::swap(from, to);
        to = std::min(to, from + 64);
        const Bytes piece(bytes.begin() + from, bytes.begin() + to);
        switch (random.below(5)) {
            case 0: if (from < to) bytes[static_cast<std::size_t>(from)] = static_cast<std::uint8_t>(random.below(256)); break;
            case 1: bytes.erase(bytes.begin() + from, bytes.begin() + to); break;
            case 2: bytes.insert(bytes.begin() + at(bytes), piece.begin(), piece.end()); break;
            case 3: {
                const std::string_view word = kWords[random.below(std::size(kWords))];
                bytes.insert(bytes.begin() + from, word.begin(), word.end());
                break;
            }
            default: {
                auto first = at(other), last = std::min<std::ptrdiff_t>(first + 64, static_cast<std::ptrdiff_t>(other.size()));
                bytes.insert(bytes.begin() + from, other.begin() + first, other.begin() + last);
            }
        }
    }
    return bytes;
}

class Replay {
public:
    explicit Replay(const std::string& reader)
        : lastInput_(fs::temp_directory_path() / ("luxdeck-replay-" + reader + "-" + std::to_string(::getpid()))) {}
    ~Replay() { fs::remove(lastInput_.path()); }
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    void file(const fs::path& path) {
        const Bytes bytes = bytesOf(path);
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

    /// Mutations of the files, in turn.
    void mutations(const std::vector<fs::path>& paths, double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        std::vector<Bytes> files;
        for (const auto& path : paths) files.push_back(bytesOf(path));
        luxdeck::RandomStream random(1);
        for (std::size_t i = 0; std::chrono::steady_clock::now() < end; ++i)
            input(mutated(files[i % files.size()], files[random.below(files.size())], random));
    }

    [[nodiscard]] std::size_t count() const { return count_; }

private:
    void input(const Bytes& bytes) {
        lastInput_.write(luxdeck::fuzz::text(bytes.data(), bytes.size()));
        largestBlock = kAlways + mostPerByte * bytes.size();
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        largestBlock = SIZE_MAX;
        ++count_;
    }

    luxdeck::fuzz::InputFile lastInput_;
    std::size_t count_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 4) {
        std::fprintf(stderr, "usage: %s CORPUS [SECONDS [BYTES]]\n", argv[0]);
        return 2;
    }
    if (argc == 4) mostPerByte = std::strtoull(argv[3], nullptr, 10);
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
    if (argc > 2 && !files.empty()) replay.mutations(files, std::atof(argv[2]));
    std::printf("%zu inputs made of %zu files\n", replay.count(), files.size());
    return files.empty() ? 1 : 0;
}
