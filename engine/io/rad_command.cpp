#include "engine/io/rad_command.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace luxdeck::rad {

namespace {

constexpr std::string_view kShell = ";&<>`$()*?[]{}~";

/// A command line as a shell would take it apart.
class Splitter {
public:
    Splitter(std::string_view text, const Place& place) : text_(text), place_(place) {}

    Result<std::vector<CommandWords>> split() {
        for (at_ = 0; at_ < text_.size(); ++at_)
            if (auto taken = take(text_[at_]); !taken) return taken.error();
        endWord();
        endProgram();
        return std::move(programs_);
    }

private:
    Result<void> take(char c) {
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
            endWord();
        } else if (c == '|') {
            endWord();
            endProgram();
        } else if (c == '\'' || c == '"') {
            const auto end = text_.find(c, at_ + 1);
            if (end == std::string_view::npos) return place_.error(ErrorCode::Parse, fmt::format("a command with an open {}, expected its end on the same line", c));
            const auto inside = text_.substr(at_ + 1, end - at_ - 1);
            if (c == '"' && inside.find_first_of("$`") != std::string_view::npos) return refused(inside);
            word_ += inside;
            inWord_ = true;
            at_ = end;
        } else if (c == '\\' && at_ + 1 < text_.size()) {
            word_ += text_[++at_];
            inWord_ = true;
        } else if (c == '#' && !inWord_) {
            at_ = text_.size();
        } else if (kShell.find(c) != std::string_view::npos) {
            return refused(std::string_view(&text_[at_], 1));
        } else {
            word_ += c;
            inWord_ = true;
        }
        return {};
    }

    [[nodiscard]] Error refused(std::string_view what) const {
        return place_.error(ErrorCode::Unsupported, fmt::format("a command with '{}', which is a shell's: commands are not given to a shell; expected quotes around it or another command", what.substr(0, 60)));
    }
    void endWord() {
        if (inWord_) words_.push_back(std::move(word_));
        word_.clear();
        inWord_ = false;
    }
    void endProgram() {
        programs_.push_back(std::move(words_));
        words_.clear();
    }

    std::string_view text_;
    const Place& place_;
    std::size_t at_ = 0;
    std::string word_;
    bool inWord_ = false;
    CommandWords words_;
    std::vector<CommandWords> programs_;
};

}  // namespace

Result<std::vector<CommandWords>> splitCommand(const Command& command) {
    auto programs = Splitter(command.text, command.place).split();
    if (!programs) return programs;
    for (const auto& words : *programs)
        if (words.empty()) return command.place.error(ErrorCode::Parse, "a command without a program, expected xform, genbox ...");
    return programs;
}

Result<CommandWords> splitWords(const std::string& line, const Place& place) {
    auto programs = Splitter(line, place).split();
    if (!programs) return programs.error();
    if (programs->size() != 1) return place.error(ErrorCode::Parse, "a line of arguments with '|', expected arguments alone");
    return std::move(programs->front());
}

}  // namespace luxdeck::rad
