// Edits of a project file's text: the content is what was wanted, and whatever else was written stays as it was.
#include "engine/io/project_edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace luxdeck {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kText = R"(# A room.
schema = "luxdeck-project/1" # do not change

[project]
name = 'It"s'  # "quoted" comment

# --- lamps [[luminaire]] ---

[[luminaire]] # the first
type = "A"
position = [1, 2,   # east
            3]      # up
# its own remark

# comment of the second
[[luminaire]]
  type = "B"
  position = [4, 5, 6]
[luminaire.array]
count = [2, 1]
spacing = [1, 1]

[sky]
kind = "none"
)";

ProjectEdit of(const std::string& text) {
    auto edit = ProjectEdit::of(text);
    EXPECT_TRUE(edit) << edit.error().text();
    return *edit;
}

/// The text after a change, and what is wrong with it.
template <class Change>
std::string changed(const std::string& text, const Change& change) {
    auto edit = of(text);
    change(edit);
    auto out = edit.text();
    return out ? *out : "error: " + out.error().text();
}

std::string replacedIn(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(ProjectEdit, ReadsWhatIsThere) {
    const auto edit = of(kText);
    EXPECT_EQ(edit.count("luminaire"), 2U);
    EXPECT_EQ(edit.count("sky"), 1U);
    EXPECT_EQ(edit.count("grid"), 0U);
    EXPECT_EQ(edit.string({"luminaire", 1}, "type"), "B");
    EXPECT_THAT(edit.numbers({"luminaire", 1}, "array.count"), ElementsAre(2, 1));
    EXPECT_EQ(edit.find("luminaire", "type", "B"), 1U);
    EXPECT_FALSE(edit.has({"luminaire", 2}, "type"));
}

TEST(ProjectEdit, SetsAValueWhereItStands) {
    const auto out = changed(kText, [](ProjectEdit& e) { e.set({"luminaire", 0}, "position", Vec3d(1, 2.5, -0.0)); });
    EXPECT_EQ(out, replacedIn(kText, "[1, 2,   # east\n            3]", "[1, 2.5, 0]"));
}

TEST(ProjectEdit, AddsAKeyAfterTheLastAndIndentsIt) {
    const auto out = changed(kText, [](ProjectEdit& e) {
        e.set({"luminaire", 1}, "dimming", 0.25);
        e.set({"luminaire", 1}, "name", "Hänge \"1\"\\");
    });
    EXPECT_EQ(out, replacedIn(kText, "[4, 5, 6]\n", "[4, 5, 6]\n  dimming = 0.25\n  name = \"Hänge \\\"1\\\"\\\\\"\n"));
    EXPECT_EQ(of(out).string({"luminaire", 1}, "name"), "Hänge \"1\"\\");
}

TEST(ProjectEdit, AddsToTheTopLevelAndMakesSections) {
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.set({"", 0}, "requirements_file", "r.toml"); }),
              replacedIn(kText, "# do not change\n", "# do not change\nrequirements_file = \"r.toml\"\n"));
    EXPECT_EQ(changed("a = 1", [](ProjectEdit& e) { e.set({"project", 0}, "name", "N"); }), "a = 1\n\n[project]\nname = \"N\"\n");
    EXPECT_EQ(changed("", [](ProjectEdit& e) { e.set({"", 0}, "a", 2); }), "a = 2\n");
    EXPECT_EQ(changed("[b]", [](ProjectEdit& e) { e.set({"", 0}, "a", true); }), "a = true\n[b]");
}

TEST(ProjectEdit, RemovesAKeyHoweverItIsWritten) {
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.remove({"luminaire", 0}, "position"); }),
              replacedIn(kText, "position = [1, 2,   # east\n            3]      # up\n", ""));
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.remove({"luminaire", 1}, "array"); }),
              replacedIn(kText, "[luminaire.array]\ncount = [2, 1]\nspacing = [1, 1]\n", ""));
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.remove({"luminaire", 1}, "not there"); }), kText);
    EXPECT_EQ(changed("[a]\nb.c = 1\nd = 2\nb.e = 3", [](ProjectEdit& e) { e.remove({"a", 0}, "b"); }), "[a]\nd = 2\n");
}

// Bug that must not be: the new key was put behind the line that the same edit removes.
TEST(ProjectEdit, RemovesTheLastKeyAndAddsAnother) {
    EXPECT_EQ(changed("[[view]]\nname = \"a\"\ndirection = [1, 0, 0]\n",
                      [](ProjectEdit& e) { e.remove({"view", 0}, "direction"), e.set({"view", 0}, "target", Vec3d(1, 2, 3)); }),
              "[[view]]\nname = \"a\"\ntarget = [1, 2, 3]\n");
}

TEST(ProjectEdit, AppendsAfterTheLastOfItsKindWithAllThatBelongsToIt) {
    const auto out = changed(kText, [](ProjectEdit& e) { e.append("luminaire", {{"type", "C"}, {"position", Vec3d(0, 0, 1)}}); });
    EXPECT_EQ(out, replacedIn(kText, "spacing = [1, 1]\n", "spacing = [1, 1]\n\n[[luminaire]]\ntype = \"C\"\nposition = [0, 0, 1]\n"));
    EXPECT_EQ(changed("x = 1", [](ProjectEdit& e) { e.append("grid", {{"name", "g"}}), e.append("grid", {{"name", "h"}}); }),
              "x = 1\n\n[[grid]]\nname = \"g\"\n\n[[grid]]\nname = \"h\"\n");
}

// A sub-table that stands far from its table would go to the new one if that came between them.
TEST(ProjectEdit, AppendsBehindSubtablesThatStandFarAway) {
    const auto out = changed("[[l]]\na = 1\n[sky]\nb = 2\n[l.array]\nc = 3\n# end\n", [](ProjectEdit& e) { e.append("l", {{"a", 2}}); });
    EXPECT_EQ(out, "[[l]]\na = 1\n[sky]\nb = 2\n[l.array]\nc = 3\n# end\n\n[[l]]\na = 2\n");
}

TEST(ProjectEdit, RemovesATableWithItsOwnCommentsAlone) {
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.removeTable({"luminaire", 0}); }),
              replacedIn(kText, "[[luminaire]] # the first\ntype = \"A\"\nposition = [1, 2,   # east\n            3]      # up\n# its own remark\n\n", ""));
    EXPECT_EQ(changed(kText, [](ProjectEdit& e) { e.removeTable({"luminaire", 1}); }),
              replacedIn(kText, "# comment of the second\n[[luminaire]]\n  type = \"B\"\n  position = [4, 5, 6]\n[luminaire.array]\ncount = [2, 1]\nspacing = [1, 1]\n\n", ""));
    EXPECT_EQ(changed("a = 1\n\n[[g]]\nb = 1\n\n[[g]]\nb = 2", [](ProjectEdit& e) { e.removeTable({"g", 0}), e.removeTable({"g", 1}); }), "a = 1\n");
}

TEST(ProjectEdit, PutsCopiesInATablesPlace) {
    const auto out = changed(kText, [](ProjectEdit& e) {
        e.replaceTable({"luminaire", 1}, {{{"array", {}}, {"name", "B1"}}, {{"array", {}}, {"name", "B2"}, {"position", Vec3d(5, 5, 6)}}});
    });
    EXPECT_EQ(out, replacedIn(kText, "  position = [4, 5, 6]\n[luminaire.array]\ncount = [2, 1]\nspacing = [1, 1]\n",
                              "  position = [4, 5, 6]\n  name = \"B1\"\n\n[[luminaire]]\n  type = \"B\"\n  position = [5, 5, 6]\n  name = \"B2\"\n"));
}

TEST(ProjectEdit, AppendsCopies) {
    const auto out = changed(kText, [](ProjectEdit& e) { e.appendCopy({"luminaire", 0}, {{"type", "Z"}}); });
    const auto edit = of(out);
    ASSERT_EQ(edit.count("luminaire"), 3U);
    EXPECT_EQ(edit.string({"luminaire", 2}, "type"), "Z");
    EXPECT_THAT(edit.numbers({"luminaire", 2}, "position"), ElementsAre(1, 2, 3));
    EXPECT_THAT(edit.numbers({"luminaire", 1}, "array.count"), ElementsAre(2, 1));
}

TEST(ProjectEdit, KeepsLineBreaksOfWindowsAndAByteOrderMark) {
    const std::string text = "\xEF\xBB\xBFschema = \"\xC3\xA4\xE2\x82\xAC\" # \"x\r\nn = \"\"\"a\r\nb\"\"\" # c\r\n[[g]]\r\nname = \"\xF0\x9F\x92\xA1 lamp\" # lit\r\n";
    const auto out = changed(text, [](ProjectEdit& e) {
        e.set({"", 0}, "schema", "s"), e.set({"", 0}, "n", 1), e.set({"g", 0}, "name", "y"), e.set({"g", 0}, "z", 0.1), e.append("g", {{"name", "t"}});
    });
    EXPECT_EQ(out, "\xEF\xBB\xBFschema = \"s\" # \"x\r\nn = 1 # c\r\n[[g]]\r\nname = \"y\" # lit\r\nz = 0.1\r\n\r\n[[g]]\r\nname = \"t\"\r\n");
}

TEST(ProjectEdit, EditsInlineTables) {
    const std::string text = "g = [{a = 1, b = [2]}, {}]\np = { x = 'a#}', y = 2 } # {\n";
    EXPECT_EQ(changed(text, [](ProjectEdit& e) { e.set({"g", 0}, "b", 3); }), replacedIn(text, "[2]", "3"));
    EXPECT_EQ(changed(text, [](ProjectEdit& e) { e.set({"g", 1}, "b", 3); }), replacedIn(text, "{}", "{ b = 3}"));
    EXPECT_EQ(changed(text, [](ProjectEdit& e) { e.set({"p", 0}, "z", 3); }), replacedIn(text, "y = 2 }", "y = 2, z = 3 }"));
    EXPECT_EQ(changed(text, [](ProjectEdit& e) { e.remove({"p", 0}, "x"); }), replacedIn(text, "x = 'a#}', ", ""));
    EXPECT_EQ(changed(text, [](ProjectEdit& e) { e.remove({"p", 0}, "y"); }), replacedIn(text, ", y = 2", ""));
    EXPECT_EQ(changed("[a]\ni = {}", [](ProjectEdit& e) { e.set({"a", 0}, "i", TomlValue({{"count", std::vector<int>{1, 2}}})); }), "[a]\ni = { count = [1, 2] }");
}

TEST(ProjectEdit, SaysWhereALayoutCannotBeFollowed) {
    EXPECT_THAT(changed("x = 1\ng = [{a = 1}]", [](ProjectEdit& e) { e.append("g", {{"a", 2}}); }), HasSubstr("error: line 2: g is not written as [[g]] tables"));
    EXPECT_THAT(changed("x = 1\ng = [{a = 1}]", [](ProjectEdit& e) { e.removeTable({"g", 0}); }), HasSubstr("error: line 2"));
    EXPECT_THAT(changed("p.a = 1", [](ProjectEdit& e) { e.set({"p", 0}, "b", 2); }), HasSubstr("line 1: p is written by keys with dots, expected [p]"));
    EXPECT_THAT(changed(kText, [](ProjectEdit& e) { e.set({"luminaire", 1}, "array", 2); }), HasSubstr("array is written as a table of its own"));
    EXPECT_THAT(changed(kText, [](ProjectEdit& e) { e.set({"luminaire", 7}, "array", 2); }), HasSubstr("there is no [[luminaire]] 8, expected one of 2"));
    EXPECT_THAT(changed(kText, [](ProjectEdit& e) { e.set({"sky", 0}, "kind", "\xFF"); }), HasSubstr("error: kind: "));
    EXPECT_THAT(changed(kText, [](ProjectEdit& e) { e.set({"sky", 0}, "kind", 1), e.removeTable({"sky", 0}); }), HasSubstr("error: "));
}

TEST(ProjectEdit, RefusesWhatIsNotToml) {
    const auto edit = ProjectEdit::of("a = 1\nb = \n");
    ASSERT_FALSE(edit);
    EXPECT_EQ(edit.error().where, "line 2");
}

TEST(ProjectEdit, NumbersReadBackAsTheyWere) {
    for (const double value : {0.1, -3e-7, 1e300, 123456789.0, 1e17, 2.0 / 3, 1e15}) {
        const auto out = changed("a = 0", [&](ProjectEdit& e) { e.set({"", 0}, "a", value); });
        EXPECT_EQ(of(out).number({"", 0}, "a"), value) << out;
    }
}

}  // namespace
}  // namespace luxdeck
