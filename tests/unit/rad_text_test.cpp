#include "engine/io/rad_command.h"
#include "engine/io/rad_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

namespace luxdeck::rad {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const std::string> fileName() { return std::make_shared<const std::string>("a.rad"); }

Primitive onlyPrimitive(const std::string& text) {
    TextReader reader(text, fileName());
    const auto item = reader.next();
    EXPECT_TRUE(item) << item.error().text();
    return std::get<Primitive>(**item);
}

Error errorOf(const std::string& text) {
    TextReader reader(text, fileName());
    for (;;) {
        const auto item = reader.next();
        if (!item) return item.error();
        if (!*item) return {ErrorCode::Internal, "no error", ""};
    }
}

std::string commandError(const std::string& text) {
    const auto programs = splitCommand({text, {fileName(), 3}});
    return programs ? "" : programs.error().text();
}

TEST(RadText, ReadsAPrimitiveWithItsCounts) {
    const auto p = onlyPrimitive("# comment\nvoid plastic\twhite  # again\n1 a\n0\n5 .7 .7 +.7 0 1e-1\n");
    EXPECT_EQ(p.modifier, "void");
    EXPECT_EQ(p.type, "plastic");
    EXPECT_EQ(p.name, "white");
    EXPECT_THAT(p.strings, ElementsAre("a"));
    EXPECT_THAT(p.numbers, ElementsAre(0.7, 0.7, 0.7, 0, 0.1));
    EXPECT_EQ(p.place.text(), "a.rad:2");
}

TEST(RadText, QuotesHoldBlanks) {
    EXPECT_THAT(onlyPrimitive("void brightfunc 'my pattern' 2 \"a + b\" x.cal 0 0").strings, ElementsAre("a + b", "x.cal"));
    EXPECT_EQ(onlyPrimitive("void brightfunc 'my pattern' 2 \"a + b\" x.cal 0 0").name, "my pattern");
}

TEST(RadText, AnAliasHasAReferenceAndNoCounts) {
    const auto p = onlyPrimitive("void alias new old void plastic x 0 0 0");
    EXPECT_THAT(p.strings, ElementsAre("old"));
    EXPECT_THAT(p.numbers, ElementsAre());
}

TEST(RadText, CommandsReachToTheEndOfTheirLine) {
    const std::string text = "!xform -t 1 0 0 \\\n a.rad\nvoid light l 0 0 3 1 1 1";
    TextReader reader(text, fileName());
    const auto first = reader.next();
    ASSERT_TRUE(first);
    EXPECT_EQ(std::get<Command>(**first).text, "xform -t 1 0 0   a.rad");
    const auto second = reader.next();
    ASSERT_TRUE(second);
    EXPECT_EQ(std::get<Primitive>(**second).place.line, 3U);
    const auto third = reader.next();
    ASSERT_TRUE(third);
    EXPECT_FALSE(third->has_value());
}

TEST(RadText, ErrorsSayWhereWhatAndWhatElse) {
    EXPECT_THAT(errorOf("\n\nvoid plastik x").text(), HasSubstr("a.rad:3: 'void plastik'"));
    EXPECT_THAT(errorOf("void plastic x 0 0 5 1 2 3        ").text(), HasSubstr("expected 4 of 5 real arguments of plastic x"));
    EXPECT_THAT(errorOf("void plastic x 0 0 3 1 two 3").text(), HasSubstr("'two', expected a finite number (2 of 3"));
    EXPECT_THAT(errorOf("void plastic x 0 0 3 1 nan 3").text(), HasSubstr("expected a finite number"));
    EXPECT_THAT(errorOf("void plastic x 0 1 7 0").text(), HasSubstr("1 integer arguments of plastic x, expected 0"));
    EXPECT_THAT(errorOf("void plastic x -1 0 0").text(), HasSubstr("expected the number of string arguments"));
    EXPECT_THAT(errorOf("void plastic").text(), HasSubstr("the file ends, expected the name of the plastic"));
}

// A count beyond what the file can hold must not become an allocation.
TEST(RadText, AHugeCountIsRefusedBeforeMemoryIsAskedFor) {
    EXPECT_THAT(errorOf("void plastic x 0 0 4000000000000 1 1 1").text(), HasSubstr("are announced, the file ends before"));
}

TEST(RadCommand, SplitsPipesAndQuotes) {
    const auto programs = splitCommand({"genbox 'my mat' b 1 2 3|xform -n \"a b\" -t 1 0 0", {fileName(), 1}});
    ASSERT_TRUE(programs);
    EXPECT_THAT(*programs, ElementsAre(ElementsAre("genbox", "my mat", "b", "1", "2", "3"), ElementsAre("xform", "-n", "a b", "-t", "1", "0", "0")));
}

TEST(RadCommand, WhatAShellWouldActUponIsRefused) {
    for (const auto* text : {"cat a.rad; rm x", "cat a.rad > b", "cat $HOME/x", "cat `x`", "cat *.rad", "genbox a b 1 1 1 && x", "cat \"$(x)\""})
        EXPECT_THAT(commandError(text), HasSubstr("not given to a shell")) << text;
    EXPECT_EQ(commandError("genrev m n 'sin(PI*t)' 't*(1-t)' 8"), "");
    EXPECT_THAT(commandError("genrev m n 'sin"), HasSubstr("a.rad:3: a command with an open '"));
    EXPECT_THAT(commandError("genbox a b 1 1 1 | | xform"), HasSubstr("without a program"));
}

}  // namespace
}  // namespace luxdeck::rad
