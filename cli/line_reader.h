#pragma once

#include "engine/core/progress.h"

#include <cstddef>
#include <string>
#include <vector>

namespace luxdeck::cli {

/// Reads lines from a descriptor as they come: waits for one, then takes whatever else has arrived, so that
/// a program that waits for each answer gets it and a file is read in large batches. Memory is bounded.
class LineReader {
public:
    LineReader(int descriptor, const Progress& progress) : descriptor_(descriptor), progress_(progress) {}

    /// Replaces `lines` by the next 1 .. most lines; false at the end, when interrupted, or when failed().
    bool next(std::vector<std::string>& lines, std::size_t most);
    /// A line was longer than 64 KiB.
    [[nodiscard]] bool failed() const { return failed_; }

private:
    bool fill(bool wait);
    bool take(std::string& line);

    int descriptor_;
    const Progress& progress_;
    std::string buffer_;
    std::size_t start_ = 0;  // of what is unread in buffer_
    bool ended_ = false;
    bool failed_ = false;
};

}  // namespace luxdeck::cli
