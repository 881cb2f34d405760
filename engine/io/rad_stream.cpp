#include "engine/io/rad_stream.h"

#include "engine/core/file.h"
#include "engine/io/rad_curves.h"
#include "engine/io/rad_generators.h"
#include "engine/io/rad_sky.h"
#include "engine/io/rad_transform.h"
#include "engine/io/xform.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

namespace luxdeck::rad {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostBytes = 1ULL << 30;

}  // namespace

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

Result<void> Stream::append(Primitives& target, Primitives source, const Place& place) const {
    if (target.size() + source.size() > limits_.primitives)
        return place.error(ErrorCode::OutOfResources, fmt::format("makes more than {} primitives, expected fewer", limits_.primitives));
    target.insert(target.end(), std::make_move_iterator(source.begin()), std::make_move_iterator(source.end()));
    return {};
}

Result<Stream::Shared> Stream::readFile(const fs::path& path) {
    std::error_code ec;
    const auto canonical = fs::weakly_canonical(path, ec);
    if (const auto at = known_.find(canonical); at != known_.end()) return at->second;
    if (std::find(open_.begin(), open_.end(), canonical) != open_.end())
        return Error{ErrorCode::Parse, fmt::format("'{}' includes itself, expected an end", path.string()), {}};
    if (open_.size() >= limits_.depth)
        return Error{ErrorCode::Parse, fmt::format("files include each other deeper than {}, expected fewer levels", limits_.depth), {}};
    const auto bytes = luxdeck::readFile(path, kMostBytes);
    if (!bytes) return bytes.error();
    if (bytes->find('\0') != std::string::npos)
        return Error{ErrorCode::Parse, "holds zero bytes, expected the text of a Radiance scene (an octree is not read)", path.string()};
    open_.push_back(canonical);
    auto primitives = readText(*bytes, path);
    open_.pop_back();
    if (!primitives) return primitives.error();
    auto shared = std::make_shared<const Primitives>(*std::move(primitives));
    known_.emplace(canonical, shared);
    return Shared(shared);
}

Result<Primitives> Stream::readText(const std::string& text, const fs::path& path) {
    TextReader reader(text, std::make_shared<const std::string>(path.string()));
    Primitives all;
    while (true) {
        auto item = reader.next();
        if (!item) return item.error();
        if (!*item) return all;
        if (auto* primitive = std::get_if<Primitive>(&**item)) {
            all.push_back(std::move(*primitive));
            continue;
        }
        const auto& command = std::get<Command>(**item);
        auto made = run(command, folderOf(path));
        if (!made) return made.error();
        if (auto added = append(all, *std::move(made), command.place); !added) return added.error();
    }
}

Result<Primitives> Stream::run(const Command& command, const fs::path& folder) {
    const auto programs = splitCommand(command);
    if (!programs) return programs.error();
    Primitives made;
    for (std::size_t i = 0; i < programs->size(); ++i) {
        auto next = runProgram((*programs)[i], command.place, folder, i > 0 ? &made : nullptr);
        if (!next) return next.error();
        made = *std::move(next);
    }
    return made;
}

Result<Primitives> Stream::runProgram(const CommandWords& words, const Place& place, const fs::path& folder, const Primitives* piped) {
    const auto program = fs::path(words[0]).filename().string();
    const std::span<const std::string> arguments(words.data() + 1, words.size() - 1);
    if (program == "xform") return runXform({arguments.begin(), arguments.end()}, place, folder, piped);
    if (program == "cat") return inputs({arguments.begin(), arguments.end()}, place, folder, piped);
    if (program == "genbox") return genbox(arguments, place);
    if (program == "genprism") return genprism(arguments, place);
    const CurveContext context{place, folder, library_};
    if (program == "gensurf") return gensurf(arguments, context);
    if (program == "genrev") return genrev(arguments, context);
    if (program == "genworm") return genworm(arguments, context);
    if (program == "gensky" || program == "gendaylit") return generateSky(program, arguments, place, warnings_);
    return place.error(ErrorCode::Unsupported,
                       fmt::format("the command '{}', expected one that is built in (xform, cat, genbox, genprism, gensurf, genrev, genworm, gensky, gendaylit): commands are not given to a shell",
                                   program.substr(0, 60)));
}

Result<Primitives> Stream::inputs(const std::vector<std::string>& names, const Place& place, const fs::path& folder, const Primitives* piped) {
    Primitives all;
    if (names.empty()) {
        if (piped == nullptr) return place.error(ErrorCode::Parse, "the command names no file and stands behind no pipe, expected one of them");
        return *piped;
    }
    for (const auto& name : names) {
        if (name == "-" && piped != nullptr) {
            if (auto added = append(all, *piped, place); !added) return added.error();
            continue;
        }
        const auto path = library_.find(name, folder);
        if (!path) return place.error(path.error().code, path.error().text());
        const auto read = readFile(*path);
        if (!read) return read.error().where.empty() ? place.error(read.error().code, read.error().message) : read.error();
        if (auto added = append(all, **read, place); !added) return added.error();
    }
    return all;
}

Result<Primitives> Stream::runXform(std::vector<std::string> words, const Place& place, const fs::path& folder, const Primitives* piped) {
    const auto list = std::find(words.begin(), words.end(), "-f");
    if (list != words.end()) return runXformList(words, static_cast<std::size_t>(list - words.begin()), place, folder, piped);
    const auto command = parseXformCommand(words, limits_.primitives);
    if (!command) return place.error(command.error().code, command.error().message);
    const auto input = inputs(command->files, place, folder, piped);
    if (!input) return input.error();
    if (input->size() > 0 && command->copies.size() > limits_.primitives / input->size())
        return place.error(ErrorCode::OutOfResources, fmt::format("{} copies of {} primitives are more than {}, expected fewer", command->copies.size(), input->size(), limits_.primitives));
    Primitives all;
    all.reserve(input->size() * command->copies.size());
    for (const auto& copy : command->copies)
        for (const auto& primitive : *input) {
            auto moved = transformed(primitive, copy);
            if (!moved) return moved.error();
            all.push_back(*std::move(moved));
        }
    return all;
}

Result<Primitives> Stream::runXformList(const std::vector<std::string>& words, std::size_t option, const Place& place, const fs::path& folder,
                                        const Primitives* piped) {
    if (option + 1 >= words.size()) return place.error(ErrorCode::Parse, "xform -f ends, expected a file of arguments");
    if (listDepth_ >= 4) return place.error(ErrorCode::Parse, "xform has more than 4 argument files, expected fewer");
    const auto path = library_.find(words[option + 1], folder);
    if (!path) return place.error(path.error().code, path.error().text());
    const auto bytes = luxdeck::readFile(*path, 1U << 24U);
    if (!bytes) return bytes.error();
    Primitives all;
    int row = 0;
    for (std::size_t at = 0; at < bytes->size();) {
        const auto end = std::min(bytes->find('\n', at), bytes->size());
        auto line = bytes->substr(at, end - at);
        at = end + 1;
        if (line.starts_with("!")) line.erase(0, 1);
        auto arguments = splitWords(line, place);
        if (!arguments) return arguments.error();
        if (!arguments->empty() && arguments->front() == "xform") arguments->erase(arguments->begin());
        if (arguments->empty()) continue;
        std::vector<std::string> full{"-n", fmt::format("i{}", row++)};
        full.insert(full.end(), words.begin(), words.begin() + static_cast<std::ptrdiff_t>(option));
        full.insert(full.end(), arguments->begin(), arguments->end());
        full.insert(full.end(), words.begin() + static_cast<std::ptrdiff_t>(option) + 2, words.end());
        ++listDepth_;
        auto made = runXform(std::move(full), place, folder, piped);
        --listDepth_;
        if (!made) return made.error();
        if (auto added = append(all, *std::move(made), place); !added) return added.error();
    }
    return all;
}

}  // namespace luxdeck::rad
