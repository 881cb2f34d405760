#include "engine/io/cal_program.h"

#include "engine/io/cal_code.h"
#include "engine/io/cal_evaluate.h"
#include "engine/io/cal_failure.h"
#include "engine/io/cal_functions.h"
#include "engine/io/cal_module.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace luxdeck {

struct CalProgram::State {
    cal::Scope scope;  // the latest first
    std::map<std::pair<std::string, std::size_t>, cal::Code> compiled;  // by name and number of arguments

    void add(std::shared_ptr<const cal::Module> module) {
        scope.insert(scope.begin(), std::move(module));
        compiled.clear();
    }
    [[nodiscard]] const cal::Definition* find(std::string_view name) const {
        for (const auto& module : scope)
            if (const auto* d = module->find(name)) return d;
        return nullptr;
    }
    /// What evaluates the name: a variable as an expression, a function as a call of it.
    Result<const cal::Code*> code(const std::string& name, std::size_t count) {
        const auto key = std::pair(name, count);
        if (const auto at = compiled.find(key); at != compiled.end()) return &at->second;
        std::shared_ptr<const cal::Module> entry;
        if (count > 0) {
            entry = cal::Module::call(name, count, name);
        } else {
            auto parsed = cal::Module::expression("", {}, name, name);
            if (!parsed) return parsed.error();
            entry = *parsed;
        }
        cal::Bindings bindings;
        bindings.ray = false;
        auto result = cal::compile(scope, {&entry, 1}, bindings);
        if (!result) return result.error();
        return &compiled.emplace(key, *std::move(result)).first->second;
    }
};

CalProgram::CalProgram() : state_(std::make_unique<State>()) {}
CalProgram::~CalProgram() = default;
CalProgram::CalProgram(CalProgram&&) noexcept = default;
CalProgram& CalProgram::operator=(CalProgram&&) noexcept = default;

Result<void> CalProgram::addText(std::string_view text, const std::string& where) {
    auto module = cal::Module::parseAt(text, where);
    if (!module) return module.error();
    state_->add(*std::move(module));
    return {};
}

Result<void> CalProgram::addFile(std::string_view name, const std::filesystem::path& folder, CalLibrary& library) {
    auto module = library.functions(name, folder);
    if (!module) return module.error();
    state_->add(*std::move(module));
    return {};
}

Result<void> CalProgram::define(const std::string& name, const std::vector<std::string>& parameters,
                                std::string_view expression, const std::string& where) {
    auto module = cal::Module::expression(name, parameters, expression, where);
    if (!module) return module.error();
    state_->add(*std::move(module));
    return {};
}

bool CalProgram::defines(std::string_view name) const { return state_->find(name) != nullptr; }

Result<double> CalProgram::evaluate(std::string_view name, std::span<const double> arguments) {
    if (arguments.size() > cal::kMostEntryArguments)
        return Error{
            ErrorCode::InvalidArgument,
            fmt::format("{} arguments for '{}', expected at most {}", arguments.size(), name, cal::kMostEntryArguments),
            ""};
    const auto code = state_->code(std::string(name), arguments.size());
    if (!code) return code.error();
    const cal::Inputs none{};
    const cal::Value value = cal::Evaluation(**code, none).value(0, arguments);
    if (value.failure != cal::Failure::None)
        return Error{ErrorCode::InvalidArgument,
                     fmt::format("{}({}) {}", name, fmt::join(arguments, ", "), cal::meaning(value.failure)), ""};
    return value.number;
}

}  // namespace luxdeck
