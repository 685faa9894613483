// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// Text to value, strictly: each gap that Teuchos leaves open is a case here.

#include <limits>

#include "SampleDeck.hpp"
#include "stroma/deck/Value.hpp"

namespace stroma::deck {
namespace {

const ValueType number{Scalar::number, false, 0};
const ValueType integer{Scalar::integer, false, 0};
const ValueType long_integer{Scalar::long_integer, false, 0};
const ValueType boolean{Scalar::boolean, false, 0};
const ValueType text{Scalar::text, false, 0};

tree::Parameter written(const std::string& value, const std::string& type = "") {
  tree::Parameter parameter;
  parameter.name = "P";
  parameter.form = type.empty() ? tree::Form::untyped_text : tree::Form::typed_text;
  parameter.type = type;
  parameter.text = value;
  return parameter;
}

std::string problem(const std::string& value, const ValueType& type) {
  const Interpretation read = interpret(written(value), type);
  return read.value ? "read as " + print(*read.value) : read.problem;
}

template <class T>
T value(const std::string& given, const ValueType& type) {
  const Interpretation read = interpret(written(given), type);
  if (!read.value) throw std::runtime_error(read.problem);
  return std::get<T>(*read.value);
}

TEST(DeckValue, NumbersAreKeptToTheLastDigit) {
  EXPECT_EQ(value<double>("0.1", number), 0.1);
  EXPECT_EQ(value<double>("1.7976931348623157e308", number), std::numeric_limits<double>::max());
  EXPECT_EQ(value<double>("5e-324", number), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(value<double>("0.1000000000000000055511151231257827021181583404541015625", number),
            0.1);
  EXPECT_EQ(value<double>("-3", number), -3.0);
  EXPECT_EQ(value<double>("+.5", number), 0.5);
  EXPECT_EQ(value<double>("5.", number), 5.0);
  EXPECT_EQ(value<double>(" 2E+3 ", number), 2000.0);
}

TEST(DeckValue, WhatIsNotWhollyANumberIsNoNumber) {
  for (const char* wrong :
       {"soft", "",    " ",   "1,5",   "2kPa",     "2 kPa", "1d3",   "0x1p3", "0x10",
        "nan",  "NaN", "inf", "-inf",  "Infinity", "1e",    "1e+",   ".",     "-",
        "+",    "--1", "+-1", "1.2.3", "1e5.5",    "{1}",   "1_000", "1'000", "\xC2\xBD"}) {
    EXPECT_EQ(problem(wrong, number), "\"" + std::string(wrong) + "\" is not a number");
  }
  EXPECT_EQ(problem("1e400", number),
            "1e400 is too large or too small for a double-precision number");
  EXPECT_EQ(problem("-1e400", number),
            "-1e400 is too large or too small for a double-precision number");
  EXPECT_EQ(problem("1e-400", number),
            "1e-400 is too large or too small for a double-precision number");
}

TEST(DeckValue, IntegersFitTheirType) {
  EXPECT_EQ(value<std::int64_t>("2147483647", integer), 2147483647);
  EXPECT_EQ(value<std::int64_t>("-2147483648", integer), -2147483648LL);
  EXPECT_EQ(value<std::int64_t>("+7", integer), 7);
  EXPECT_EQ(value<std::int64_t>("007", integer), 7);
  EXPECT_EQ(value<std::int64_t>("9223372036854775807", long_integer),
            std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(problem("2147483648", integer),
            "2147483648 is too large an integer (it must lie from -2147483648 to 2147483647)");
  EXPECT_NE(problem("-2147483649", integer).find("too large an integer"), std::string::npos);
  EXPECT_NE(problem("9223372036854775808", long_integer).find("too large an integer"),
            std::string::npos);
  for (const char* wrong : {"", "1.0", "1e3", "ten", "0x10", "1 2", "-", "+-1", "3.", "true"}) {
    EXPECT_EQ(problem(wrong, integer), "\"" + std::string(wrong) + "\" is not an integer");
  }
}

TEST(DeckValue, TrueAndFalseOnly) {
  EXPECT_TRUE(value<bool>("true", boolean));
  EXPECT_FALSE(value<bool>(" false ", boolean));
  for (const char* wrong : {"", "True", "TRUE", "yes", "no", "on", "1", "0", "t"}) {
    EXPECT_EQ(problem(wrong, boolean), "\"" + std::string(wrong) + "\" is not true or false");
  }
}

TEST(DeckValue, StringsAreKeptAsTheyAre) {
  EXPECT_EQ(value<std::string>("  10 % {a, b} ", text), "  10 % {a, b} ");
  EXPECT_EQ(value<std::string>("", text), "");
}

TEST(DeckValue, Arrays) {
  const ValueType three{Scalar::number, true, 3};
  const ValueType some{Scalar::number, true, 0};
  const ValueType words{Scalar::text, true, 0};
  EXPECT_EQ(value<std::vector<double>>("{1, 2.5 ,3e0}", three), (std::vector<double>{1, 2.5, 3}));
  EXPECT_EQ(value<std::vector<double>>("[1,2,3]", three), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(value<std::vector<double>>("{}", some), std::vector<double>());
  EXPECT_EQ(value<std::vector<std::string>>("{a, b c}", words),
            (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(problem("{1, 2}", three), "has 2 entries instead of 3");
  EXPECT_EQ(problem("{1, 2, 3, 4}", three), "has 4 entries instead of 3");
  EXPECT_EQ(problem("{}", three), "has 0 entries instead of 3");
  EXPECT_EQ(problem("{1}", three), "has 1 entry instead of 3");
  EXPECT_EQ(problem("{1, soft, 3}", three), "entry 2: \"soft\" is not a number");
  EXPECT_EQ(problem("{1,, 3}", three), "entry 2: \"\" is not a number");
  EXPECT_EQ(problem("{1, 2,}", some), "entry 3: \"\" is not a number");
  EXPECT_EQ(problem("{a, , c}", words), "entry 2: is empty");
  EXPECT_EQ(problem("1, 2, 3", three), "\"1, 2, 3\" is not a list; write {a, b, c}");
  EXPECT_EQ(problem("{1, 2, 3", three), "\"{1, 2, 3\" is not a list; write {a, b, c}");
  EXPECT_EQ(problem("2", three), "\"2\" is not a list; write {a, b, c}");
  EXPECT_EQ(problem("{1.5}", {Scalar::integer, true, 0}), "entry 1: \"1.5\" is not an integer");
}

// Where the length is free, a number is a list of one, whatever XML calls it.
TEST(DeckValue, ANumberIsAListOfOne) {
  const ValueType some{Scalar::number, true, 0};
  EXPECT_EQ(value<std::vector<double>>("2.5", some), std::vector<double>{2.5});
  for (const char* type : {"double", "int"})
    EXPECT_TRUE(interpret(written("3", type), some).value.has_value()) << type;
  EXPECT_FALSE(interpret(written("3", "string"), some).value.has_value());
  EXPECT_FALSE(interpret(written("3", "Array(double)"), some).value.has_value());
  EXPECT_EQ(problem("soft", some), "\"soft\" is not a list; write {a, b}");
  EXPECT_EQ(problem("3", {Scalar::integer, true, 0}), "\"3\" is not a list; write {a, b}");
}

// XML uses Teuchos's own brackets only, so that Teuchos would read the same deck.
TEST(DeckValue, XmlArraysAreWrittenAsTeuchosDoes) {
  const ValueType some{Scalar::integer, true, 0};
  EXPECT_TRUE(interpret(written("{1, 2}", "Array(int)"), some).value.has_value());
  EXPECT_EQ(interpret(written("[1, 2]", "Array(int)"), some).problem,
            "\"[1, 2]\" is not a list; write {a, b}");
}

TEST(DeckValue, TheDeclaredTypeMustBeTheRightOne) {
  struct Case {
    const char* declared;
    ValueType wanted;
    std::string value;
    bool is_right;
  };
  const ValueType numbers{Scalar::number, true, 0};
  const ValueType integers{Scalar::integer, true, 0};
  const ValueType words{Scalar::text, true, 0};
  for (const Case& c : {Case{"double", number, "1", true},
                        {"int", number, "1", true},
                        {"long long", number, "1", true},
                        {"string", number, "1", false},
                        {"bool", number, "true", false},
                        {"Array(double)", number, "{1}", false},
                        {"int", integer, "1", true},
                        {"double", integer, "1", false},
                        {"long long", integer, "1", false},
                        {"int", long_integer, "1", true},
                        {"long long", long_integer, "1", true},
                        {"bool", boolean, "true", true},
                        {"int", boolean, "1", false},
                        {"string", boolean, "true", false},
                        {"string", text, "a", true},
                        {"int", text, "1", false},
                        {"Array(string)", text, "{a}", false},
                        {"Array(double)", numbers, "{1}", true},
                        {"Array(int)", numbers, "{1}", true},
                        {"double", numbers, "{1}", false},
                        {"Array(string)", numbers, "{1}", false},
                        {"Array(int)", integers, "{1}", true},
                        {"Array(double)", integers, "{1}", false},
                        {"Array(string)", words, "{a}", true},
                        {"Array(int)", words, "{1}", false}}) {
    const Interpretation read = interpret(written(c.value, c.declared), c.wanted);
    EXPECT_EQ(read.value.has_value(), c.is_right) << c.declared << " for " << type_name(c.wanted);
    if (c.is_right) continue;
    EXPECT_EQ(read.problem, "type=\"" + std::string(c.declared) +
                                "\" is the wrong type; write type=\"" + type_name(c.wanted) + "\"");
  }
  EXPECT_EQ(interpret(written("1", "real"), number).problem,
            "type=\"real\" is no type of a deck; write type=\"double\"");
}

TEST(DeckValue, AdmissibleRanges) {
  const auto allows = [](const Admissible& rule, double x) { return rule.allows(Value(x)); };
  const double above_zero = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(allows(positive(), above_zero));
  EXPECT_FALSE(allows(positive(), 0.0));
  EXPECT_TRUE(allows(not_negative(), 0.0));
  EXPECT_FALSE(allows(not_negative(), -above_zero));
  EXPECT_TRUE(allows(at_least(2), 2.0));
  EXPECT_FALSE(allows(at_least(2), 1.9));
  EXPECT_TRUE(allows(at_most(2), 2.0));
  EXPECT_FALSE(allows(at_most(2), 2.1));
  EXPECT_FALSE(allows(greater_than(2), 2.0));
  EXPECT_FALSE(allows(less_than(2), 2.0));
  EXPECT_TRUE(allows(less_than(2), 1.9));
  EXPECT_TRUE(allows(between(0, 1), 0.0) && allows(between(0, 1), 1.0));
  EXPECT_FALSE(allows(between(0, 1), 1.1) || allows(between(0, 1), -0.1));
  EXPECT_FALSE(allows(strictly_between(0, 1), 0.0) || allows(strictly_between(0, 1), 1.0));
  EXPECT_TRUE(allows(strictly_between(0, 1), 0.5));
  EXPECT_FALSE(positive().allows(Value(std::vector<double>{1, 0})));
  EXPECT_FALSE(positive().allows(Value(std::vector<std::int64_t>{1, -1})));
  EXPECT_FALSE(each(positive()).allows(Value(std::int64_t{0})));
  EXPECT_FALSE(not_empty().allows(Value(std::string())));
  EXPECT_FALSE(not_empty().allows(Value(std::vector<double>())));
  EXPECT_TRUE(not_empty().allows(Value(std::string("a"))));
  EXPECT_FALSE(one_of({"a", "b"}).allows(Value(std::string("c"))));
  EXPECT_FALSE(one_of({"a", "b"}).allows(Value(std::vector<std::string>{"a", "c"})));
  EXPECT_TRUE(one_of({"a", "b"}).allows(Value(std::vector<std::string>{"a", "b"})));
  const Admissible short_word =
      text_that("a word of 3 letters", [](const std::string& word) { return word.size() == 3; });
  EXPECT_TRUE(short_word.allows(Value(std::string("abc"))));
  EXPECT_FALSE(short_word.allows(Value(std::string("ab"))));
}

TEST(DeckValue, AdmissibleInWords) {
  EXPECT_EQ(any().describe(number), "a number");
  EXPECT_EQ(positive().describe(integer), "an integer > 0");
  EXPECT_EQ(positive().describe({Scalar::number, true, 3}), "3 numbers, each > 0");
  EXPECT_EQ(at_least(1).describe({Scalar::integer, true, 0}), "a list of integers, each >= 1");
  EXPECT_EQ(not_empty().describe({Scalar::number, true, 0}), "a list of one or more numbers");
  EXPECT_EQ(between(0.25, 1e-9).describe(number), "a number from 0.25 to 1e-09");
  EXPECT_EQ(strictly_between(-1, 0.5).describe(number), "a number > -1 and < 0.5");
  EXPECT_EQ(one_of({"a", "b", "c"}).describe(text), "\"a\", \"b\" or \"c\"");
  EXPECT_EQ(any().describe(boolean), "true or false");
  EXPECT_EQ(number_that("that is even", [](double x) { return static_cast<int>(x) % 2 == 0; })
                .describe(integer),
            "an integer that is even");
}

}  // namespace
}  // namespace stroma::deck
