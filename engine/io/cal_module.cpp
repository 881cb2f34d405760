#include "engine/io/cal_module.h"

#include "engine/core/file.h"
#include "engine/io/cal_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

namespace luxdeck::cal {

namespace {

/// "name`" says that this file's is meant, which is where names are looked for first anyway.
std::string ownName(std::string_view name) {
    if (name.size() > 1 && name.ends_with('`')) name.remove_suffix(1);
    return std::string(name);
}

}  // namespace

/// Recursive descent over calcomp's grammar: E1 sums, E2 products, E3 powers, E4 signs, E5 the rest.
/// An error is kept, and parsing goes on with nothing to see: every loop then ends.
class Parser {
public:
    Parser(std::string_view text, Module& module) : scan_(text), module_(module) {}

    Result<void> definitions() {
        while (!failed_ && !scan_.atEnd()) {
            if (scan_.takeIf(';')) continue;
            definition();
            if (!failed_ && !scan_.atEnd() && !scan_.takeIf(';')) fail("';' after a definition, or an operator");
        }
        return finish();
    }

    Result<void> expression(const std::string& name, const std::vector<std::string>& parameters) {
        Definition result{name, parameters, 0, scan_.line()};
        parameters_ = &result.parameters;
        result.root = sum();
        if (!failed_ && !scan_.atEnd()) fail("an operator, or the end of the expression");
        module_.definitions_.insert_or_assign(name, std::move(result));
        return finish();
    }

private:
    void definition() {
        Definition result;
        result.line = scan_.line();
        if (scan_.next() == '$') return fail("a definition (channels are for rcalc, not for scenes)");
        if (!isLetter(scan_.next())) return fail("the name of a variable or function to define");
        result.name = ownName(scan_.name());
        if (scan_.next() == '(') parameterList(result);
        if (failed_) return;
        if (!scan_.takeIf('=') && !scan_.takeIf(':')) return fail(fmt::format("'=' or ':' after '{}'", result.name));
        parameters_ = &result.parameters;
        result.root = sum();
        parameters_ = nullptr;
        if (!failed_) module_.definitions_.insert_or_assign(result.name, std::move(result));
    }

    void parameterList(Definition& result) {
        do {
            scan_.take();
            if (!isLetter(scan_.next())) return fail("the name of a parameter");
            result.parameters.emplace_back(scan_.name());
        } while (scan_.next() == ',');
        if (!scan_.takeIf(')')) fail("',' or ')' in a list of parameters");
    }

    std::uint32_t sum() {
        const Nested nested(*this);
        std::uint32_t left = product();
        while (!failed_ && (scan_.next() == '+' || scan_.next() == '-')) {
            const auto kind = scan_.next() == '+' ? SyntaxKind::Add : SyntaxKind::Subtract;
            scan_.take();
            left = add(kind, {left, product()});
        }
        return left;
    }

    std::uint32_t product() {
        std::uint32_t left = power();
        while (!failed_ && (scan_.next() == '*' || scan_.next() == '/')) {
            const auto kind = scan_.next() == '*' ? SyntaxKind::Multiply : SyntaxKind::Divide;
            scan_.take();
            left = add(kind, {left, power()});
        }
        return left;
    }

    std::uint32_t power() {
        const Nested nested(*this);
        const std::uint32_t base = sign();
        if (failed_ || !scan_.takeIf('^')) return base;
        return add(SyntaxKind::Power, {base, power()});
    }

    std::uint32_t sign() {
        if (scan_.takeIf('-')) return add(SyntaxKind::Negate, {primary()});
        scan_.takeIf('+');
        return primary();
    }

    std::uint32_t primary() {
        if (failed_) return 0;
        const char c = scan_.next();
        if (scan_.takeIf('(')) {
            const std::uint32_t inner = sum();
            if (!failed_ && !scan_.takeIf(')')) fail("')' or an operator");
            return inner;
        }
        if (isLetter(c) || c == '`') return named();
        if (isDigit(c) || c == '.') return number();
        if (c == '$') fail("a value (input channels such as '$1' are for rcalc, not for scenes)");
        else fail("a number, a name or '('");
        return 0;
    }

    std::uint32_t number() {
        const auto text = scan_.number();
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) {
            failAt(scan_.line(), fmt::format("'{}', expected a number such as 1.5e-3", text));
            return 0;
        }
        SyntaxNode node;
        node.number = value;
        return add(std::move(node));
    }

    std::uint32_t named() {
        SyntaxNode node;
        node.line = scan_.line();
        const auto name = scan_.name();
        const auto parameter = parameterIndex(name);
        if (parameter) node.parameter = *parameter;
        else node.name = ownName(name);
        if (scan_.next() != '(') {
            node.kind = parameter ? SyntaxKind::Parameter : SyntaxKind::Name;
            return add(std::move(node));
        }
        node.kind = parameter ? SyntaxKind::CallParameter : SyntaxKind::Call;
        do {
            scan_.take();
            node.kids.push_back(sum());
        } while (!failed_ && scan_.next() == ',');
        if (!failed_ && !scan_.takeIf(')')) fail(fmt::format("',' or ')' in the arguments of '{}'", name));
        return add(std::move(node));
    }

    [[nodiscard]] std::optional<std::uint32_t> parameterIndex(std::string_view name) const {
        if (parameters_ == nullptr) return std::nullopt;
        const auto at = std::find(parameters_->begin(), parameters_->end(), name);
        if (at == parameters_->end()) return std::nullopt;
        return static_cast<std::uint32_t>(at - parameters_->begin());
    }

    std::uint32_t add(SyntaxKind kind, std::vector<std::uint32_t> kids) {
        SyntaxNode node;
        node.kind = kind;
        node.kids = std::move(kids);
        return add(std::move(node));
    }
    std::uint32_t add(SyntaxNode node) {
        if (failed_) return 0;
        if (node.line == 0) node.line = scan_.line();
        std::size_t depth = 0;
        for (const auto kid : node.kids) depth = std::max<std::size_t>(depth, module_.nodes_[kid].depth);
        if (depth >= kMostNesting) tooDeep();
        node.depth = static_cast<std::uint16_t>(depth + 1);
        module_.nodes_.push_back(std::move(node));
        return static_cast<std::uint32_t>(module_.nodes_.size() - 1);
    }

    /// Counts how deep the parser itself has gone: four calls a level.
    struct Nested {
        explicit Nested(Parser& p) : parser(p) {
            if (++parser.depth_ > kMostNesting) parser.tooDeep();
        }
        ~Nested() { --parser.depth_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;
        Parser& parser;
    };

    void tooDeep() { failAt(scan_.line(), fmt::format("an expression of more than {} levels", kMostNesting)); }
    void fail(const std::string& expected) { failAt(scan_.line(), scan_.seen() + ", expected " + expected); }
    void failAt(std::uint32_t line, const std::string& message) {
        if (!failed_) error_ = {ErrorCode::Parse, message, module_.where(line)};
        failed_ = true;
        if (module_.nodes_.empty()) module_.nodes_.emplace_back();  // what failed parts refer to
    }
    Result<void> finish() {
        if (const auto line = scan_.openComment(); line != 0)
            return Error{ErrorCode::Parse, "'{' opens a comment that is not closed, expected '}'", module_.where(line)};
        if (failed_) return error_;
        return {};
    }

    Scanner scan_;
    Module& module_;
    const std::vector<std::string>* parameters_ = nullptr;
    std::size_t depth_ = 0;
    bool failed_ = false;
    Error error_;
};

Result<std::shared_ptr<const Module>> Module::parse(std::string_view text, const std::string& name) {
    auto module = std::make_shared<Module>();
    module->name_ = name;
    module->hash_ = contentHash(text);
    if (auto ok = Parser(text, *module).definitions(); !ok) return ok.error();
    return std::shared_ptr<const Module>(std::move(module));
}

Result<std::shared_ptr<const Module>> Module::parseAt(std::string_view text, const std::string& where) {
    auto module = std::make_shared<Module>();
    module->name_ = where;
    module->ownLines_ = false;
    module->hash_ = contentHash(text);
    if (auto ok = Parser(text, *module).definitions(); !ok) return ok.error();
    return std::shared_ptr<const Module>(std::move(module));
}

Result<std::shared_ptr<const Module>> Module::expression(const std::string& name,
                                                         const std::vector<std::string>& parameters,
                                                         std::string_view text, const std::string& where) {
    auto module = std::make_shared<Module>();
    module->name_ = where;
    module->ownLines_ = false;
    module->hash_ = contentHash(text);
    if (auto ok = Parser(text, *module).expression(name, parameters); !ok) {
        Error error = ok.error();
        error.message = fmt::format("in the expression '{}': {}", text.substr(0, 200), error.message);
        return error;
    }
    return std::shared_ptr<const Module>(std::move(module));
}

std::shared_ptr<const Module> Module::call(const std::string& function, std::size_t count, const std::string& where) {
    auto module = std::make_shared<Module>();
    module->name_ = where;
    module->ownLines_ = false;
    Definition definition;
    SyntaxNode call;
    call.kind = SyntaxKind::Call;
    call.name = function;
    call.depth = 2;
    for (std::size_t i = 0; i < count; ++i) {
        definition.parameters.push_back(std::to_string(i + 1));
        SyntaxNode parameter;
        parameter.kind = SyntaxKind::Parameter;
        parameter.parameter = static_cast<std::uint32_t>(i);
        call.kids.push_back(static_cast<std::uint32_t>(module->nodes_.size()));
        module->nodes_.push_back(std::move(parameter));
    }
    definition.root = static_cast<std::uint32_t>(module->nodes_.size());
    module->nodes_.push_back(std::move(call));
    module->definitions_.emplace("", std::move(definition));
    return module;
}

const Definition* Module::find(std::string_view name) const {
    const auto at = definitions_.find(std::string(name));
    return at == definitions_.end() ? nullptr : &at->second;
}

std::string Module::where(std::uint32_t line) const { return ownLines_ ? fmt::format("{}:{}", name_, line) : name_; }

}  // namespace luxdeck::cal
