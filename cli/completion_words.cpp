#include "cli/completion_words.h"

#include <algorithm>
#include <utility>

namespace luxdeck::cli {

namespace {

/// "human" and "camera" of "TEXT:{human,camera}": how CLI11 describes a choice.
std::vector<std::string> choicesOf(const std::string& typeName) {
    std::vector<std::string> out;
    const auto open = typeName.find('{'), close = typeName.rfind('}');
    if (open == std::string::npos || close == std::string::npos || close < open) return out;
    for (const auto& word : CLI::detail::split(typeName.substr(open + 1, close - open - 1), ','))
        if (!word.empty()) out.push_back(CLI::detail::trim_copy(word));
    return out;
}

CompletionValue valueOf(const CLI::Option& option) {
    CompletionValue value;
    if (option.get_type_size() == 0) return value;
    const auto type = option.get_type_name();
    value.choices = choicesOf(type);
    const auto is = [&](const char* start) { return type.rfind(start, 0) == 0; };
    // Names of types are what --help shows: IN, OUT.png, F.exr, FILE, PROJECT, SCENE are files.
    const bool file = is("FILE") || is("PROJECT") || is("SCENE") || is("IN") || is("OUT") || is("F.");
    if (!value.choices.empty()) value.kind = CompletionValue::Kind::Choice;
    else if (is("DIR")) value.kind = CompletionValue::Kind::Folder;
    else value.kind = file && !is("INT") ? CompletionValue::Kind::File : CompletionValue::Kind::Text;
    return value;
}

/// Up to the first stop: a list of words in a shell has no room for more.
std::string firstSentence(const std::string& text) {
    const auto end = std::min({text.find(". "), text.find(": "), text.find("; ")});
    return text.substr(0, end);
}

CompletionCommand wordsOf(const CLI::App& app, const std::string& name) {
    CompletionCommand out{name, firstSentence(app.get_description()), {}, {}, {}};
    for (const auto* option : app.get_options()) {
        if (option->get_positional()) {
            out.argument = valueOf(*option);
            continue;
        }
        CompletionOption one;
        for (const auto& s : option->get_snames()) one.names.push_back("-" + s);
        for (const auto& l : option->get_lnames()) one.names.push_back("--" + l);
        one.description = firstSentence(option->get_description());
        one.value = valueOf(*option);
        out.options.push_back(std::move(one));
    }
    return out;
}

void addSubcommand(CompletionCommand& command, CompletionCommand sub) {
    command.subcommands.push_back(std::move(sub.name));
    if (command.argument.kind == CompletionValue::Kind::None) command.argument = std::move(sub.argument);
    for (auto& option : sub.options)
        if (std::none_of(command.options.begin(), command.options.end(), [&](const auto& known) { return known.names == option.names; }))
            command.options.push_back(std::move(option));
}

constexpr auto kAll = [](const CLI::App*) { return true; };

}  // namespace

std::vector<CompletionCommand> completionWords(const CLI::App& program) {
    std::vector<CompletionCommand> out{wordsOf(program, "")};
    for (const auto* command : program.get_subcommands(kAll)) {
        out.push_back(wordsOf(*command, command->get_name()));
        for (const auto* sub : command->get_subcommands(kAll)) addSubcommand(out.back(), wordsOf(*sub, sub->get_name()));
    }
    return out;
}

}  // namespace luxdeck::cli
