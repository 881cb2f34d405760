// Data files: interpolation, and that nothing in a file can do worse than be refused.
#include "engine/io/cal_module.h"
#include "engine/io/pattern_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

namespace luxdeck {
namespace {

using testing::HasSubstr;

std::shared_ptr<const DataTable> table(const std::string& text) {
    const auto result = DataTable::parse(text, "t.dat");
    EXPECT_TRUE(result) << result.error().text();
    return result ? *result : nullptr;
}

std::string error(const std::string& text) {
    const auto result = DataTable::parse(text, "t.dat");
    return result ? "no error" : result.error().text();
}

TEST(CalData, MultilinearFunctionsAreExact) {
    // Three dimensions: even, listed rising, listed falling; f is linear in each, so interpolation has no error.
    const double xs[] = {0, 2.5, 5, 7.5, 10}, ys[] = {0, 1, 10}, zs[] = {4, 1, 0};
    const auto f = [](double x, double y, double z) {
        return 3 + x - 2 * y + 0.5 * z + x * y - x * z + 0.25 * x * y * z;
    };
    std::string text = "3 # dimensions\n0 10 5\n0 0 3 0 1 10\n0 0 3\n4 1 0\n";
    for (const double x : xs)
        for (const double y : ys)
            for (const double z : zs) text += std::to_string(f(x, y, z)) + " ";
    const auto t = table(text);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const std::array at{10 * unit(random), 10 * unit(random), 4 * unit(random)};
        // The file has 6 digits after the point: 5e-7; a weighted mean adds nothing to that.
        EXPECT_NEAR(t->value(at), f(at[0], at[1], at[2]), 1e-6);
    }
}

TEST(CalData, GoesOnForOneDivisionAndThenFades) {
    const auto t = table("1\n0 2 3\n1 3 7\n");
    const auto at = [&](double x) { return t->value(std::array{x}); };
    EXPECT_DOUBLE_EQ(at(0), 1);
    EXPECT_DOUBLE_EQ(at(1.5), 5);
    EXPECT_DOUBLE_EQ(at(2), 7);
    EXPECT_DOUBLE_EQ(at(3), 11);           // the line through the last two
    EXPECT_DOUBLE_EQ(at(-1), -1);
    EXPECT_DOUBLE_EQ(at(5), (2 * 7 - 3) / 5.0);  // then what it was there, over the distance
    EXPECT_DOUBLE_EQ(at(-4), (2 * 1 - 3) / 4.0);
    EXPECT_NEAR(at(1e300), 0, 1e-290);
    EXPECT_TRUE(std::isnan(at(std::nan(""))));
    EXPECT_TRUE(std::isnan(at(INFINITY)));
}

TEST(CalData, WhatIsWrongIsNamed) {
    EXPECT_EQ(error(""), "t.dat:1: the file ends, expected the number of dimensions, at least 1 and at most 5");
    EXPECT_EQ(error("9\n"), "t.dat:1: '9', expected the number of dimensions, at least 1 and at most 5");
    EXPECT_EQ(error("1\n0 1 2\n3 x\n"), "t.dat:3: 'x', expected a value");
    EXPECT_THAT(error("1\n0 1 2\n3\n"), HasSubstr("the file ends, expected a value"));
    EXPECT_THAT(error("1\n0 1 1\n3\n"), HasSubstr("t.dat:2: '1', expected the number of points"));
    EXPECT_THAT(error("1\n0 1 4000000000\n3\n"), HasSubstr("number of points"));
    EXPECT_THAT(error("5\n0 1 90 0 1 90 0 1 90 0 1 90 0 1 90\n1 2 3\n"), HasSubstr("number of points"));
    EXPECT_THAT(error("1\n0 0 3 1 2 2\n1 2 3\n"), HasSubstr("only rise or only fall"));
    EXPECT_THAT(error("1\n0 0 3 1 2 0\n1 2 3\n"), HasSubstr("only rise or only fall"));
    EXPECT_THAT(error("1\n5 5 3 1 2 3\n1 2 3\n"), HasSubstr("two bounds"));
    EXPECT_THAT(error("1\n0 1 2\nnan 1\n"), HasSubstr("expected a value"));
    EXPECT_EQ(error("1 0 1 2 +3 4 and more"), "no error");
}

/// Every beginning of a text, and copies with bytes changed.
template <class Read>
void mutate(const std::string& text, Read read) {
    for (std::size_t size = 0; size <= text.size(); ++size) read(text.substr(0, size));
    std::mt19937 random(5);
    for (int i = 0; i < 5000; ++i) {
        std::string changed = text;
        for (unsigned n = 1 + random() % 3; n > 0; --n)
            changed[random() % changed.size()] = static_cast<char>(random());
        read(changed);
    }
}

TEST(CalData, SurvivesEveryBeginningAndThousandsOfChanges) {
    mutate("# made up\n2\n0 90 3\n0 0 2 0 180\n1 2 3\n4 5 6e-1\n", [](const std::string& text) {
        const auto result = DataTable::parse(text, "t.dat");
        if (!result) {
            EXPECT_FALSE(result.error().message.empty());
        } else {
            (void)(*result)->value(std::array{1.0, 2.0, 3.0, 4.0, 5.0});
        }
    });
}

TEST(CalModules, SurviveEveryBeginningAndThousandsOfChanges) {
    const std::string text =
        "{ a {nested} comment }\nPIH : 3.14159/2;\nf(x,y) = if(x-.5, f(x-1,y)*y, -y^2e0);\n"
        "v`P = f(3,A1) + select(2,Dx,`max(Dy,1)) / arg(2);\n";
    mutate(text, [](const std::string& changed) {
        const auto result = cal::Module::parse(changed, "t.cal");
        if (!result) {
            EXPECT_THAT(result.error().where, testing::StartsWith("t.cal:"));
            EXPECT_THAT(result.error().message, testing::AnyOf(HasSubstr("expected"), HasSubstr("levels")));
        }
    });
}

}  // namespace
}  // namespace luxdeck
