#include "cli/man_page.h"

#include "engine/core/version.h"

#include <fmt/format.h>

namespace luxdeck::cli {

namespace {

/// Text as troff takes it literally.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') out += "\\e";
        else if (c == '-') out += "\\-";
        else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += std::string("\\&") + c;
        else out += c;
    }
    return out;
}

std::string options(const CLI::App& app) {
    std::string out;
    for (const auto* option : app.get_options()) {
        std::string name = option->get_name(option->get_positional(), true);
        if (option->get_type_size() != 0 && !option->get_positional()) name += " " + option->get_type_name();
        std::string text = option->get_description();
        if (!option->get_default_str().empty()) text += fmt::format(" (default {})", option->get_default_str());
        out += fmt::format(".TP\n.B {}\n{}\n", escaped(name), escaped(text));
    }
    return out;
}

std::string section(const std::string& name, const CLI::App& command) {
    return fmt::format(".SS luxdeck {}\n{}\n{}", escaped(name), escaped(command.get_description()), options(command));
}

constexpr auto kAll = [](const CLI::App*) { return true; };

}  // namespace

std::string manPage(const CLI::App& program) {
    std::string page = fmt::format(".TH LUXDECK 1 \"\" \"luxdeck {}\" \"User Commands\"\n.SH NAME\nluxdeck \\- lighting design with honest numbers\n"
                                   ".SH SYNOPSIS\n.B luxdeck\n.I COMMAND\n[options]\n.SH DESCRIPTION\n{}\n.SH OPTIONS\n{}",
                                   kVersion, escaped(program.get_description()), options(program));
    page += ".SH COMMANDS\n";
    for (const auto* command : program.get_subcommands(kAll)) {
        const auto subs = command->get_subcommands(kAll);
        if (subs.empty()) page += section(command->get_name(), *command);
        for (const auto* sub : subs) page += section(command->get_name() + " " + sub->get_name(), *sub);
    }
    page += fmt::format(".SH EXIT STATUS\n{}\n", escaped(program.get_footer()));
    return page;
}

}  // namespace luxdeck::cli
