#include "engine/io/project_edit.h"
#include "tests/fuzz/fuzz_input.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <string>

namespace {

using luxdeck::ProjectEdit;
using luxdeck::TomlPlace;

const std::string kNew = "new \"name\" \xC3\xA4\n";

/// An edit gives a text that parses, or an error that says something.
template <class Change>
std::optional<ProjectEdit> after(const std::string& text, const Change& change) {
    auto edit = ProjectEdit::of(text);
    if (!edit) std::abort();
    change(*edit);
    const auto out = edit->text();
    luxdeck::fuzz::expectValueOrMessage(out);
    if (!out) return std::nullopt;
    auto again = ProjectEdit::of(*out);
    if (!again) std::abort();
    return *again;
}

void require(bool holds) {
    if (!holds) std::abort();
}

/// A value that is set is there; a key that is removed is not; and tables are as many as they have to be.
void editTable(const std::string& text, const ProjectEdit& was, const TomlPlace& place) {
    for (const std::string key : {"name", "position", "array", "a-b.c"}) {
        if (const auto now = after(text, [&](ProjectEdit& e) { e.set(place, key, kNew); }); now && key != "a-b.c") require(now->string(place, key) == kNew);
        if (const auto now = after(text, [&](ProjectEdit& e) { e.remove(place, key); })) require(key == "a-b.c" || !now->has(place, key));
    }
    const auto count = was.count(place.section);
    if (const auto now = after(text, [&](ProjectEdit& e) { e.removeTable(place); })) require(now->count(place.section) + 1 == count);
    if (const auto now = after(text, [&](ProjectEdit& e) { e.appendCopy(place, {{"name", kNew}}); })) require(now->string({place.section, count}, "name") == kNew);
    if (const auto now = after(text, [&](ProjectEdit& e) { e.replaceTable(place, {{{"name", kNew}}, {{"name", {}}}}); })) {
        require(now->count(place.section) == count + 1);
        require(now->string(place, "name") == kNew);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(luxdeck::fuzz::text(bytes, size));
    const auto edit = ProjectEdit::of(text);
    luxdeck::fuzz::expectValueOrMessage(edit);
    if (!edit) return 0;
    for (const std::string section : {"luminaire", "grid", "project"}) {
        for (std::size_t i = 0; i < std::min<std::size_t>(edit->count(section), 2); ++i) editTable(text, *edit, {section, i});
        const auto count = edit->count(section);
        if (const auto now = after(text, [&](ProjectEdit& e) { e.append(section, {{"name", kNew}}); })) require(now->string({section, count}, "name") == kNew);
    }
    if (const auto now = after(text, [](ProjectEdit& e) { e.set({"", 0}, "schema", kNew); })) require(now->string({"", 0}, "schema") == kNew);
    return 0;
}
