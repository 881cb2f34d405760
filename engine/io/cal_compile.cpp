#include "engine/io/cal_builtin.h"
#include "engine/io/cal_code.h"
#include "engine/io/cal_functions.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <optional>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace luxdeck::cal {

namespace {

std::optional<Input> inputNamed(std::string_view name) {
    static const std::unordered_map<std::string_view, Input> kInputs{
        {"Dx", Input::Dx},
        {"Dy", Input::Dy},
        {"Dz", Input::Dz},
        {"Nx", Input::Nx},
        {"Ny", Input::Ny},
        {"Nz", Input::Nz},
        {"Px", Input::Px},
        {"Py", Input::Py},
        {"Pz", Input::Pz},
        {"T", Input::T},
        {"Ts", Input::Ts},
        {"Rdot", Input::Rdot},
        {"Lu", Input::Lu},
        {"Lv", Input::Lv},
        {"CrP", Input::CrP},
        {"CgP", Input::CgP},
        {"CbP", Input::CbP},
        // A pattern's surface is not perturbed by textures here.
        {"NxP", Input::Nx},
        {"NyP", Input::Ny},
        {"NzP", Input::Nz},
        {"RdotP", Input::Rdot}};
    const auto at = kInputs.find(name);
    return at == kInputs.end() ? std::nullopt : std::optional(at->second);
}

/// The n of "An"; none for other names.
std::optional<double> realArgumentNamed(std::string_view name) {
    if (name == "AC") return 0;
    if (name.size() < 2 || name.size() > 7 || name[0] != 'A' || name[1] == '0') return std::nullopt;
    int number = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (error != std::errc() || end != name.data() + name.size() || number < 1) return std::nullopt;
    return number;
}

Op arithmetic(SyntaxKind kind) {
    switch (kind) {
        case SyntaxKind::Add: return Op::Add;
        case SyntaxKind::Subtract: return Op::Subtract;
        case SyntaxKind::Multiply: return Op::Multiply;
        case SyntaxKind::Divide: return Op::Divide;
        case SyntaxKind::Power: return Op::Power;
        default: return Op::Negate;
    }
}

/// Compiles one definition after another, beginning with the entries; a definition that is referred to joins
/// the queue. Only expressions are walked by recursion, and these are at most kMostNesting deep.
class Compiler {
public:
    Compiler(const Scope& scope, const Bindings& bindings) : scope_(scope), bindings_(bindings) {
        code_.realArguments = bindings.realArguments;
    }

    Result<Code> run(std::span<const std::shared_ptr<const Module>> entries) {
        for (const auto& module : entries) {
            module_ = module.get();
            code_.entries.push_back(step(module->find("")->root));
        }
        while (!failed_ && !queue_.empty()) {
            const Pending pending = queue_.front();
            queue_.pop_front();
            module_ = pending.module;
            current_ = pending.place;
            const std::uint32_t root = step(pending.definition->root);
            if (pending.definition->isFunction()) code_.functions[definitions_[pending.place].index].root = root;
            else code_.variables[definitions_[pending.place].index].root = root;
        }
        if (!failed_) checkCircles();
        if (failed_) return error_;
        foldConstants(code_);
        return std::move(code_);
    }

private:
    struct Pending {
        const Module* module;
        const Definition* definition;
        std::size_t place;  // in definitions_
    };
    struct Known {
        const Module* module;
        const Definition* definition;
        std::uint32_t index;                  // of functions or variables
        std::vector<std::size_t> references;  // to other definitions_
    };
    struct Found {
        const Module* module = nullptr;
        const Definition* definition = nullptr;
        explicit operator bool() const { return definition != nullptr; }
    };

    /// The definition that a name of the module at hand means: the library sees only itself; "`name" is looked
    /// for there first.
    [[nodiscard]] Found find(const std::string& name) const {
        const Module* library = standardLibrary().get();
        const bool global = name.size() > 1 && name.front() == '`';
        const std::string key = global ? name.substr(1) : name;
        if (module_ == library || global) {
            if (const auto* d = library->find(key)) return {library, d};
            if (module_ == library) return {};
        }
        for (const auto& module : scope_)
            if (const auto* d = module->find(key)) return {module.get(), d};
        return {};
    }
    [[nodiscard]] Found findInLibrary(const std::string& name) const {
        const auto* d = standardLibrary()->find(name);
        return d == nullptr ? Found{} : Found{standardLibrary().get(), d};
    }

    std::size_t place(const Found& found) {
        const auto [at, isNew] = places_.try_emplace(found.definition, definitions_.size());
        if (isNew) {
            const bool function = found.definition->isFunction();
            const std::size_t index = function ? code_.functions.size() : code_.variables.size();
            if (!function && index >= kMostVariables)
                fail(found.definition->line,
                     fmt::format("more than {} variables lead to this expression", kMostVariables));
            if (function)
                code_.functions.push_back(
                    {found.definition->name, 0, static_cast<std::uint32_t>(found.definition->parameters.size())});
            else code_.variables.push_back({found.definition->name, 0});
            definitions_.push_back({found.module, found.definition, static_cast<std::uint32_t>(index), {}});
            queue_.push_back({found.module, found.definition, at->second});
        }
        if (current_) definitions_[*current_].references.push_back(at->second);
        return at->second;
    }

    std::uint32_t add(Op op, std::uint32_t index, const std::vector<std::uint32_t>& kids, double number = 0) {
        Step result{op, index, static_cast<std::uint32_t>(code_.operands.size()),
                    static_cast<std::uint32_t>(kids.size()), number};
        code_.operands.insert(code_.operands.end(), kids.begin(), kids.end());
        code_.steps.push_back(result);
        return static_cast<std::uint32_t>(code_.steps.size() - 1);
    }

    std::uint32_t step(std::uint32_t syntax) {
        if (failed_) return 0;
        const SyntaxNode& node = module_->node(syntax);
        switch (node.kind) {
            case SyntaxKind::Number: return add(Op::Number, 0, {}, node.number);
            case SyntaxKind::Name: return named(node);
            case SyntaxKind::Parameter: return add(Op::Argument, node.parameter, {});
            case SyntaxKind::Call: return call(node);
            case SyntaxKind::CallParameter: return add(Op::CallArgument, node.parameter, kids(node, true));
            default: return add(arithmetic(node.kind), 0, kids(node, false));
        }
    }

    std::vector<std::uint32_t> kids(const SyntaxNode& node, bool mayBeFunctions) {
        std::vector<std::uint32_t> result;
        for (const auto kid : node.kids) {
            result.push_back(step(kid));
            if (failed_) break;
            const Op op = code_.steps[result.back()].op;
            if (!mayBeFunctions && (op == Op::FunctionName || op == Op::NativeName))
                fail(node.line, fmt::format("'{}' is a function, expected its arguments in parentheses after it",
                                            module_->node(kid).name));
        }
        return result;
    }

    std::uint32_t named(const SyntaxNode& node) {
        if (const auto found = find(node.name)) return definition(found);
        const std::string_view plain = withoutMark(node.name);
        if (const auto number = realArgumentNamed(plain))
            return add(Op::CallNative, static_cast<std::uint32_t>(nativeFunction("arg")),
                       {add(Op::Number, 0, {}, *number)});
        if (const auto at = bindings_.constants.find(plain); at != bindings_.constants.end())
            return add(Op::Number, 0, {}, at->second);
        if (const auto input = inputNamed(plain)) {
            const bool colour = *input >= Input::CrP;
            if (bindings_.ray && (!colour || bindings_.material))
                return add(Op::Input, static_cast<std::uint32_t>(*input), {});
            fail(node.line, fmt::format("'{}' is not known here: {}", plain,
                                        colour ? "only materials have a colour" : "there is no ray"));
            return 0;
        }
        if (const auto found = findInLibrary(std::string(plain))) return definition(found);
        if (const int native = nativeFunction(plain); native >= 0)
            return add(Op::NativeName, static_cast<std::uint32_t>(native), {});
        fail(node.line, fmt::format("'{}' is not defined", node.name));
        return 0;
    }

    std::uint32_t definition(const Found& found) {
        const auto index = definitions_[place(found)].index;
        return add(found.definition->isFunction() ? Op::FunctionName : Op::Variable, index, {});
    }

    std::uint32_t call(const SyntaxNode& node) {
        Found found = find(node.name);
        const bool variable = found && !found.definition->isFunction();
        const std::string plain(withoutMark(node.name));
        if (!found || variable) found = findInLibrary(plain);
        if (found && found.definition->isFunction()) {
            const auto needed = found.definition->parameters.size();
            if (node.kids.size() < needed) return tooFew(node, needed);
            const auto index = definitions_[place(found)].index;
            return add(Op::Call, index, kids(node, true));
        }
        const int native = nativeFunction(plain);
        if (native < 0) {
            fail(node.line, variable ? fmt::format("'{}' is a variable, expected a function", node.name)
                                     : fmt::format("the function '{}' is not defined", node.name));
            return 0;
        }
        const auto needed = nativeFunctions()[static_cast<std::size_t>(native)].leastArguments;
        if (node.kids.size() < needed) return tooFew(node, needed);
        return add(Op::CallNative, static_cast<std::uint32_t>(native), kids(node, false));
    }

    static std::string_view withoutMark(std::string_view name) {
        if (name.size() > 1 && name.front() == '`') name.remove_prefix(1);
        return name;
    }

    std::uint32_t tooFew(const SyntaxNode& node, std::size_t needed) {
        fail(node.line, fmt::format("'{}' has {} arguments, expected {}", node.name, node.kids.size(), needed));
        return 0;
    }

    /// Functions may call themselves; a variable that needs itself has no value.
    void checkCircles() {
        for (std::size_t start = 0; start < definitions_.size() && !failed_; ++start) {
            if (definitions_[start].definition->isFunction()) continue;
            std::vector<std::size_t> cameFrom(definitions_.size(), definitions_.size());
            std::vector<std::size_t> open{start};
            while (!open.empty() && !failed_) {
                const std::size_t from = open.back();
                open.pop_back();
                for (const std::size_t to : definitions_[from].references) {
                    if (to == start) {
                        circle(start, from, cameFrom);
                        break;
                    }
                    if (cameFrom[to] != definitions_.size()) continue;
                    cameFrom[to] = from;
                    open.push_back(to);
                }
            }
        }
    }

    void circle(std::size_t start, std::size_t last, const std::vector<std::size_t>& cameFrom) {
        std::vector<std::string> names{definitions_[start].definition->name};
        for (std::size_t at = last; at != start; at = cameFrom[at]) names.push_back(definitions_[at].definition->name);
        names.push_back(names.front());
        std::reverse(names.begin(), names.end());
        module_ = definitions_[start].module;
        fail(definitions_[start].definition->line,
             fmt::format("'{}' is defined by itself: {}", names.front(), fmt::join(names, " -> ")));
    }

    void fail(std::uint32_t line, const std::string& message) {
        if (!failed_) error_ = {ErrorCode::Parse, message, module_->where(line)};
        failed_ = true;
    }

    const Scope& scope_;
    const Bindings& bindings_;
    Code code_;
    std::deque<Pending> queue_;
    std::vector<Known> definitions_;
    std::unordered_map<const Definition*, std::size_t> places_;
    const Module* module_ = nullptr;                   // that is being compiled
    std::optional<std::size_t> current_;               // definition that is being compiled; none: an entry
    bool failed_ = false;
    Error error_;
};

}  // namespace

Result<Code> compile(const Scope& scope, std::span<const std::shared_ptr<const Module>> entries,
                     const Bindings& bindings) {
    return Compiler(scope, bindings).run(entries);
}

}  // namespace luxdeck::cal
