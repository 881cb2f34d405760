#include "cli/line_reader.h"

#include <poll.h>
#include <unistd.h>

namespace luxdeck::cli {

namespace {
constexpr std::size_t kLongestLine = 65536;
constexpr int kStepMs = 100;
}

bool LineReader::fill(bool wait) {
    // A signal just before a read would be missed by it: wait in short steps, and look for one between them.
    pollfd waiting{descriptor_, POLLIN, 0};
    while (!ended_ && ::poll(&waiting, 1, wait ? kStepMs : 0) <= 0) {
        if (!wait) return false;
        ended_ = progress_.cancelled();
    }
    if (ended_) return false;
    if (start_ > 0) buffer_.erase(0, start_), start_ = 0;
    char block[65536];
    const auto got = ::read(descriptor_, block, sizeof block);
    if (got <= 0) {
        ended_ = true;
        return false;
    }
    buffer_.append(block, static_cast<std::size_t>(got));
    return true;
}

bool LineReader::take(std::string& line) {
    const auto end = buffer_.find('\n', start_);
    if (end == std::string::npos) {
        if (!ended_ || start_ >= buffer_.size()) return false;
        line = buffer_.substr(start_);  // the last line may lack its end
        start_ = buffer_.size();
        return true;
    }
    line = buffer_.substr(start_, end - start_);
    start_ = end + 1;
    return true;
}

bool LineReader::next(std::vector<std::string>& lines, std::size_t most) {
    lines.clear();
    std::string line;
    while (lines.size() < most) {
        if (take(line)) {
            lines.push_back(line);
            continue;
        }
        if (buffer_.size() - start_ > kLongestLine) {
            failed_ = lines.empty();  // what came before it is answered first
            break;
        }
        if (!fill(lines.empty()) && !(ended_ && start_ < buffer_.size())) break;
    }
    return !lines.empty();
}

}  // namespace luxdeck::cli
