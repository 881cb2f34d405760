#include "cli/completions.h"

#include "cli/completion_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace luxdeck::cli {

namespace {

using Kind = CompletionValue::Kind;

std::string joined(const std::vector<std::string>& words, const char* between) { return fmt::format("{}", fmt::join(words, between)); }

/// Inside single quotes of a shell.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::vector<std::string> namesOf(const CompletionCommand& command) {
    std::vector<std::string> out;
    for (const auto& option : command.options) out.insert(out.end(), option.names.begin(), option.names.end());
    return out;
}

std::string bashReply(const CompletionValue& value) {
    switch (value.kind) {
        case Kind::File: return "_luxdeck_files -f";
        case Kind::Folder: return "_luxdeck_files -d";
        case Kind::Choice: return fmt::format("_luxdeck_words {}", quoted(joined(value.choices, " ")));
        case Kind::None:
        case Kind::Text: return ":";
    }
    return ":";
}

/// The values of a command's options, then what else may stand there.
std::string bashCommand(const CompletionCommand& command, const std::string& otherwise) {
    std::string out = fmt::format("        {})\n            case $previous in\n", command.name.empty() ? "''" : command.name);
    for (const auto& option : command.options)
        if (option.value.kind != Kind::None)
            out += fmt::format("                {}) {}; return;;\n", joined(option.names, "|"), bashReply(option.value));
    out += fmt::format("            esac\n            if [[ $current == -* ]]; then _luxdeck_words {}\n            else {}\n            fi;;\n",
                       quoted(joined(namesOf(command), " ")), otherwise);
    return out;
}

constexpr const char* kBashStart = R"(# Completion of luxdeck for bash; made by `luxdeck --completions bash`.
_luxdeck_words() {
    local IFS=$' \t\n'
    COMPREPLY=($(compgen -W "$1" -- "$current"))
}
_luxdeck_files() {
    local IFS=$'\n'
    COMPREPLY=($(compgen "$1" -- "$current"))
    compopt -o filenames 2>/dev/null
}
_luxdeck() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' word
    COMPREPLY=()
    # bash makes three words of --option=value
    if [[ $current == '=' ]]; then current=
    elif [[ $previous == '=' ]]; then previous=${COMP_WORDS[COMP_CWORD-2]}
    fi
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        case $word in
)";

std::string bashScript(const std::vector<CompletionCommand>& all) {
    std::vector<std::string> commands;
    for (std::size_t i = 1; i < all.size(); ++i) commands.push_back(all[i].name);
    std::string out = kBashStart;
    out += fmt::format("            {}) command=$word; break;;\n        esac\n    done\n    case $command in\n", joined(commands, "|"));
    out += bashCommand(all[0], "_luxdeck_words " + quoted(joined(commands, " ")));
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto reply = bashReply(all[i].argument);
        const auto& subs = all[i].subcommands;
        out += bashCommand(all[i], subs.empty() ? reply : fmt::format("if [[ $COMP_CWORD == 2 ]]; then _luxdeck_words {}; else {}; fi", quoted(joined(subs, " ")), reply));
    }
    return out + "    esac\n}\ncomplete -F _luxdeck luxdeck\n";
}

/// Inside the [...] of a specification for _arguments.
std::string zshText(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
        out += c;
    }
    return out;
}

std::string zshAction(const CompletionValue& value) {
    switch (value.kind) {
        case Kind::File: return ":file:_files";
        case Kind::Folder: return ":folder:_files -/";
        case Kind::Choice: return fmt::format(":value:({})", joined(value.choices, " "));
        case Kind::Text: return ":value: ";
        case Kind::None: return "";
    }
    return "";
}

std::string zshArguments(const CompletionCommand& command) {
    std::string out;
    for (const auto& option : command.options)
        for (const auto& name : option.names)
            out += fmt::format(" \\\n                {}", quoted(fmt::format("{}[{}]{}", name, zshText(option.description), zshAction(option.value))));
    if (!command.subcommands.empty()) out += fmt::format(" \\\n                {}", quoted(fmt::format("1:command:({})", joined(command.subcommands, " "))));
    if (command.argument.kind != Kind::None) out += fmt::format(" \\\n                {}", quoted("*" + zshAction(command.argument)));
    return out;
}

std::string zshScript(const std::vector<CompletionCommand>& all) {
    std::string out = "#compdef luxdeck\n# Completion of luxdeck for zsh; made by `luxdeck --completions zsh`.\n_luxdeck() {\n"
                      "    local state\n    local -a commands\n    commands=(\n";
    for (std::size_t i = 1; i < all.size(); ++i)
        out += fmt::format("        {}\n", quoted(all[i].name + ":" + zshText(all[i].description)));
    out += fmt::format("    )\n    _arguments -C{} \\\n                '1:command:->command' '*::argument:->argument'\n", zshArguments(all[0]));
    out += "    case $state in\n    command) _describe command commands;;\n    argument)\n        case $words[1] in\n";
    for (std::size_t i = 1; i < all.size(); ++i)
        out += fmt::format("            {}) _arguments{};;\n", all[i].name, zshArguments(all[i]));
    // As a file of fpath it is run as the function; sourced, it registers itself.
    return out + "        esac;;\n    esac\n}\nif [[ $funcstack[1] == _luxdeck ]]; then _luxdeck \"$@\"; else compdef _luxdeck luxdeck; fi\n";
}

/// Inside single quotes of fish, which knows the escapes \\ and \'.
std::string fishQuoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "'";
}

std::string fishValue(const CompletionValue& value) {
    switch (value.kind) {
        case Kind::File: return " -r -F";
        case Kind::Folder: return " -x -a '(__fish_complete_directories)'";
        case Kind::Choice: return fmt::format(" -x -a {}", fishQuoted(joined(value.choices, " ")));
        case Kind::Text: return " -x";
        case Kind::None: return "";
    }
    return "";
}

std::string fishOptions(const CompletionCommand& command, const std::string& condition) {
    std::string out;
    for (const auto& option : command.options) {
        out += fmt::format("complete -c luxdeck -n {}", quoted(condition));
        for (const auto& name : option.names) out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        out += fishValue(option.value) + " -d " + fishQuoted(option.description) + "\n";
    }
    return out;
}

std::string fishScript(const std::vector<CompletionCommand>& all) {
    std::string out = "# Completion of luxdeck for fish; made by `luxdeck --completions fish`.\ncomplete -c luxdeck -f\n";
    out += fishOptions(all[0], "__fish_use_subcommand");
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto inside = "__fish_seen_subcommand_from " + all[i].name;
        out += fmt::format("complete -c luxdeck -n __fish_use_subcommand -a {} -d {}\n", all[i].name, fishQuoted(all[i].description));
        if (all[i].argument.kind == Kind::File) out += fmt::format("complete -c luxdeck -n {} -F\n", quoted(inside));
        if (!all[i].subcommands.empty()) out += fmt::format("complete -c luxdeck -n {} -a {}\n", quoted(inside), quoted(joined(all[i].subcommands, " ")));
        out += fishOptions(all[i], inside);
    }
    return out;
}

}  // namespace

std::string completions(const CLI::App& program, Shell shell) {
    const auto words = completionWords(program);
    switch (shell) {
        case Shell::Bash: return bashScript(words);
        case Shell::Zsh: return zshScript(words);
        case Shell::Fish: return fishScript(words);
    }
    return {};
}

}  // namespace luxdeck::cli
