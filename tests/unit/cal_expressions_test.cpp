// The function language: what expressions are worth, and how what is wrong with them is said.
#include "engine/io/cal_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace luxdeck {
namespace {

using testing::HasSubstr;

double value(const std::string& definitions, const std::string& name = "x") {
    CalProgram program;
    const auto added = program.addText(definitions, "t.rad:7");
    EXPECT_TRUE(added) << added.error().text();
    const auto result = program.evaluate(name, {});
    EXPECT_TRUE(result) << result.error().text();
    return result ? *result : std::nan("");
}

std::string error(const std::string& definitions) {
    CalProgram program;
    if (const auto added = program.addText(definitions, "t.rad:7"); !added) return added.error().text();
    const auto result = program.evaluate("x", {});
    return result ? "no error: " + std::to_string(*result) : result.error().text();
}

TEST(CalExpressions, BindAsCalcompDoes) {
    const struct {
        const char* text;
        double value;
    } cases[] = {
        {"x = 1 + 2*3", 7},
        {"x = 7-2-1", 4},
        {"x = 8/4/2", 1},
        {"x = 2^3^2", 512},
        {"x = -2^2", 4},  // the sign binds closer than the power
        {"x = 2^-1", 0.5},
        {"x = 2*-3", -6},
        {"x = 2--3", 5},
        {"x = +4 - +1", 3},
        {"x = (1+2)*3", 9},
        {"x = .5e1 + 1.E-1", 5.1},
        {"x = {a {nested} one} 2 {b}+{c}3", 5},
        {"a : 3; x = a*a", 9},
        {"x = b; b = 2*c; c : 4", 8},
        {"x = 1; x = 2", 2},
        {";;x = 1;;", 1},
        {"a.b_2 = 3; x = a.b_2", 3},
        {"p`q = 5; x = p`q", 5},
        {"y` = 6; x = y + y`", 12},
    };
    for (const auto& c : cases) EXPECT_DOUBLE_EQ(value(c.text), c.value) << c.text;
}

TEST(CalExpressions, FunctionsTakeValuesAndFunctions) {
    EXPECT_EQ(value("f(a,b) = a - b; x = f(5,3)"), 2);
    EXPECT_EQ(value("twice(g,v) = g(g(v)); h(v) = 3*v; x = twice(h,2)"), 18);
    EXPECT_EQ(value("twice(g,v) = g(g(v)); x = twice(sqrt,16)"), 2);
    // A function handed on through another one's parameter.
    EXPECT_EQ(value("in(g,v) = g(v); out(k,v) = in(k,v+1); sq3(v) = v*v*v; x = out(sq3,1)"), 8);
    // Parameters hide definitions, and arguments are those of the call, not of the callee.
    EXPECT_EQ(value("v = 100; f(v) = g(v+1)*v; g(v) = 10*v; x = f(2)"), 60);
    EXPECT_EQ(value("v1(i) = i; v2(i) = i*i; x = dot(v1,v2)"), 36);
    EXPECT_EQ(value("v1(i) = select(i,1,0,0); v2(i) = select(i,0,1,0); x = cross(3,v1,v2) + 10*cross(1,v1,v2)"), 1);
    // More arguments than kept values, and more than are needed.
    EXPECT_EQ(value("f(a,b,c,d,e,g,h,i,j,k) = j*10 + k; x = f(1,2,3,4,5,6,7,8,9,10,11)"), 100);
    EXPECT_EQ(value("x = max(1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18) + min(4,2,8)"), 20);
}

TEST(CalExpressions, LookOnlyAtWhatIsChosen) {
    EXPECT_EQ(value("x = if(1, 2, 1/0)"), 2);
    EXPECT_EQ(value("x = if(0, log(-1), 3)"), 3);  // zero is not positive
    EXPECT_EQ(value("x = if(-1, log(-1), 3)"), 3);
    EXPECT_EQ(value("x = select(2, 1/0, 5, 1/0)"), 5);
    EXPECT_EQ(value("x = select(0, 1, 1, 1)"), 3);
    EXPECT_EQ(value("f(a,b) = if(a, a, b); x = f(1, 1/0)"), 1);  // an argument that nothing asks for
    EXPECT_EQ(value("x = or(1, 1/0) + and(-2, 1/0)"), -1);
    EXPECT_THAT(error("x = select(3, 1, 2)"), HasSubstr("has no value"));
    EXPECT_THAT(error("x = 1/0"), HasSubstr("has no value"));
    EXPECT_THAT(error("x = if(0/0, 1, 2)"), HasSubstr("has no value"));
    EXPECT_THAT(error("x = sqrt(-1)*0"), HasSubstr("has no value"));
    EXPECT_THAT(error("x = (-8)^(1/3)"), HasSubstr("has no value"));
    EXPECT_THAT(error("x = noise3(1e300,0,0)"), HasSubstr("has no value"));
}

TEST(CalExpressions, RecursionEndsOrIsRefused) {
    EXPECT_EQ(value("f(n) = if(n-.5, n*f(n-1), 1); x = f(10)"), 3628800);
    EXPECT_EQ(value("s(n) = if(n-.5, n + s(n-1), 0); x = s(200)"), 20100);
    EXPECT_THAT(error("f(n) = f(n+1); x = f(0)"), HasSubstr("without end"));
    EXPECT_THAT(error("f(n) = n + f(n+1); x = f(0)"), HasSubstr("without end"));
    // Twice as many calls at each level: ends by the number of steps, not after 2^60 of them.
    EXPECT_THAT(error("f(n) = if(n, f(n-1) + f(n-1), 1); x = f(60)"), HasSubstr("1000000 steps"));
    EXPECT_THAT(error("f(g) = g(g); x = f(f)"), HasSubstr("does not end"));
    // An argument that is asked for twice is computed once: 2^60 steps otherwise.
    EXPECT_EQ(value("f(n,v) = if(n-.5, f(n-1,v+v), v); x = f(60,1)"), std::ldexp(1.0, 60));
}

TEST(CalExpressions, CirclesAreNamed) {
    EXPECT_THAT(error("x = x + 1"), HasSubstr("'x' is defined by itself: x -> x"));
    EXPECT_THAT(error("x = a; a = b; b = c*2; c = a"), HasSubstr("defined by itself"));
    EXPECT_THAT(error("x = f(1); f(v) = v + a; a = f(2)"),
                testing::ContainsRegex("'a' is defined by itself: a -> f -> a"));
    EXPECT_EQ(value("x = 1; unused = unused"), 1);  // what nothing asks for is left alone
}

TEST(CalExpressions, ErrorsSayWhereAndWhatWasExpected) {
    EXPECT_EQ(error("x = "), "t.rad:7: the end, expected a number, a name or '('");
    EXPECT_EQ(error("x = (1 + 2"), "t.rad:7: the end, expected ')' or an operator");
    EXPECT_EQ(error("x = 1 2"), "t.rad:7: '2', expected ';' after a definition, or an operator");
    EXPECT_EQ(error("x 1"), "t.rad:7: '1', expected '=' or ':' after 'x'");
    EXPECT_EQ(error("= 1"), "t.rad:7: '=', expected the name of a variable or function to define");
    EXPECT_EQ(error("x = f(1,"), "t.rad:7: the end, expected a number, a name or '('");
    EXPECT_EQ(error("f(1) = 2"), "t.rad:7: '1', expected the name of a parameter");
    EXPECT_EQ(error("x = 1e+"), "t.rad:7: '1e+', expected a number such as 1.5e-3");
    EXPECT_EQ(error("x = ."), "t.rad:7: '.', expected a number such as 1.5e-3");
    EXPECT_EQ(error("x = 1 {open"), "t.rad:7: '{' opens a comment that is not closed, expected '}'");
    EXPECT_THAT(error("x = $1"), HasSubstr("channels"));
    EXPECT_THAT(error("$1 = 3"), HasSubstr("channels"));
    EXPECT_EQ(error("x = nothing"), "t.rad:7: 'nothing' is not defined");
    EXPECT_EQ(error("x = nothing(1)"), "t.rad:7: the function 'nothing' is not defined");
    EXPECT_EQ(error("a = 1; x = a(1)"), "t.rad:7: 'a' is a variable, expected a function");
    EXPECT_EQ(error("f(a,b) = 1; x = f(1)"), "t.rad:7: 'f' has 1 arguments, expected 2");
    EXPECT_EQ(error("x = atan2(1)"), "t.rad:7: 'atan2' has 1 arguments, expected 2");
    EXPECT_EQ(error("x = 1 + sin"), "t.rad:7: 'sin' is a function, expected its arguments in parentheses after it");
    EXPECT_EQ(error("x = Dx"), "t.rad:7: 'Dx' is not known here: there is no ray");
    EXPECT_THAT(error("f(g) = g(1); a = 2; x = f(a)"), HasSubstr("for which no function is given"));
    EXPECT_THAT(error("x = A3"), HasSubstr("real argument"));
    EXPECT_THAT(error("x = \x01"), HasSubstr("byte 1, expected"));
}

TEST(CalExpressions, DeepAndLongTextIsRefusedNotFatal) {
    const std::string open(100000, '('), close(100000, ')');
    EXPECT_THAT(error("x = " + open + "1" + close), HasSubstr("more than 1000 levels"));
    std::string sum = "x = 1", power = "x = 1", minus = "x = ";
    for (int i = 0; i < 100000; ++i) sum += "+1", power += "^1", minus += "-(";
    EXPECT_THAT(error(sum), HasSubstr("more than 1000 levels"));
    EXPECT_THAT(error(power), HasSubstr("more than 1000 levels"));
    EXPECT_THAT(error(minus), HasSubstr("more than 1000 levels"));
    EXPECT_THAT(error("x = " + std::string(100000, '{')), HasSubstr("not closed"));
    std::string chain = "x = v0; ";
    for (int i = 0; i < 500; ++i) chain += "v" + std::to_string(i) + " = v" + std::to_string(i + 1) + "; ";
    EXPECT_EQ(value(chain + "v500 = 3"), 3);
    for (int i = 500; i < 600; ++i) chain += "v" + std::to_string(i) + " = v" + std::to_string(i + 1) + "; ";
    EXPECT_THAT(error(chain + "v600 = 3"), HasSubstr("more than 512 variables"));
}

TEST(CalExpressions, ProgramsOfGeneratorsTakeArguments) {
    CalProgram program;
    ASSERT_TRUE(program.addText("r(t) = 1 + a*t; a : 2", "t.rad:1"));
    ASSERT_TRUE(program.define("z", {"s", "t"}, "r(s) - r(t)", "t.rad:2"));
    EXPECT_TRUE(program.defines("r"));
    EXPECT_FALSE(program.defines("q"));
    EXPECT_EQ(*program.evaluate("r", std::array{0.5}), 2);
    EXPECT_EQ(*program.evaluate("z", std::array{2.0, 1.0}), 2);
    ASSERT_TRUE(program.addText("a : 10", "t.rad:3"));  // later ones replace, also within what came before
    EXPECT_EQ(*program.evaluate("r", std::array{0.5}), 6);
    EXPECT_FALSE(program.evaluate("q", std::array{0.5}));
    EXPECT_FALSE(program.evaluate("z", std::array{0.5}));
    EXPECT_FALSE(program.evaluate("r", std::array<double, 9>{}));
}

TEST(CalFunctions, HaveTheirKnownValues) {
    const struct {
        const char* text;
        double value;
    } cases[] = {
        {"sin(PI/6)", 0.5},
        {"cos(60*DEGREE)", 0.5},
        {"tan(PI/4)", 1},
        {"asin(1)", std::numbers::pi / 2},
        {"acos(-1)", std::numbers::pi},
        {"atan(1)", std::numbers::pi / 4},
        {"atan2(1,-1)", 0.75 * std::numbers::pi},
        {"exp(1)", std::numbers::e},
        {"log(exp(2))", 2},
        {"log10(1000)", 3},
        {"sqrt(9)", 3},
        {"floor(-1.5)", -2},
        {"ceil(-1.5)", -1},
        {"erf(0) + erfc(0)", 1},
        {"Acos(2)", 0},
        {"Asin(-2)", -std::numbers::pi / 2},
        {"Atan2(0,0)", 0},
        {"Exp(-1000)", 0},
        {"Sqrt(-4)", 0},
        {"abs(-3)", 3},
        {"sgn(-3)", -1},
        {"sgn(0)", 0},
        {"sq(3)", 9},
        {"bound(1,5,3)", 3},
        {"mod(-1,3)", 2},
        {"frac(-0.25)", 0.75},
        {"tri(350,180)", 10},
        {"tri(190,90)", 10},
        {"linterp(.25,4,8)", 5},
        {"clip(1.5)", 1},
        {"noneg(-1)", 0},
        {"noop(-1)", -1},
        {"red(1,2,3) + green(1,2,3) + blue(1,2,3)", 6},
        {"clipgrey(2,2,2)", 1},
        {"xor(1,-1)", 1},
        {"xor(1,1)", -1},
        {"not(0)", 1},
        {"inside(0,1,2)", 1},
        {"inside(0,3,2)", -1},
        {"fade(1,3,1)", 2},
        {"fade(1,3,16)", 3},
        {"hermite(1,5,9,9,0)", 1},
        {"hermite(1,5,9,9,1)", 5},
        {"hermite(0,1,1,1,.3)", 0.3},
        {"bezier(1,9,9,4,0)", 1},
        {"bezier(1,9,9,4,1)", 4},
        {"bezier(1,2,3,4,.5)", 2.5},
        {"bspline(2,2,2,2,.4)", 2},
        {"bspline(1,2,3,4,.25)", 2.25},
        {"unif2norm(.5)", 0},
    };
    for (const auto& c : cases) {
        // unif2norm is good to 0.00045 by its source; the others to some roundings.
        const double tolerance = std::string(c.text).starts_with("unif") ? 4.5e-4 : 1e-12;
        EXPECT_NEAR(value(std::string("x = ") + c.text), c.value, tolerance) << c.text;
    }
    EXPECT_NEAR(value("x = unif2norm(.975)"), 1.959964, 4.5e-4);
    EXPECT_NEAR(value("x = unif2norm(.025)"), -1.959964, 4.5e-4);
    EXPECT_NEAR(value("x = grey(1,1,1)"), 1, 1e-6);  // Radiance's weights add up to 0.999999998
}

}  // namespace
}  // namespace luxdeck
