// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/base/typed_number.h"

#include <gtest/gtest.h>

#include <string_view>
#include <utility>

namespace hexapose {
namespace {

TEST(TypedNumber, IsUnderstoodAsItIsCommonlyWritten) {
    const std::pair<const char*, double> understood[] = {{"0", 0.0},
                                                         {"-0", 0.0},
                                                         {"12", 12.0},
                                                         {"+12", 12.0},
                                                         {"-4.25", -4.25},
                                                         {"1,5", 1.5},
                                                         {"-1,5", -1.5},
                                                         {".5", 0.5},
                                                         {",5", 0.5},
                                                         {"5.", 5.0},
                                                         {"1e-3", 1e-3},
                                                         {"1E5", 1e5},
                                                         {"1e+05", 1e5},
                                                         {"-2,5e2", -250.0},
                                                         {"  7\t", 7.0},
                                                         {"\u22125", -5.0},
                                                         {"\u20135", -5.0},
                                                         {"\uFF0D5", -5.0},
                                                         {"1e\u22123", 1e-3},
                                                         {"\u00A03.5\u3000", 3.5},
                                                         {"\uFF11\uFF12\uFF0E\uFF15", 12.5},
                                                         {"\uFF0B\uFF19\uFF0C\uFF10", 9.0},
                                                         {"1e308", 1e308},
                                                         {"0e999", 0.0}};
    for (const auto& [text, value] : understood) {
        const TypedNumber number = readTypedNumber(text);
        EXPECT_TRUE(number.ok()) << text;
        EXPECT_EQ(number.value, value) << text;
    }
}

TEST(TypedNumber, IsRefusedWholeWithItsReason) {
    using Fault = TypedNumberFault;
    const std::pair<const char*, Fault> refused[] = {
        {"", Fault::Empty},
        {"  \t ", Fault::Empty},
        {"-", Fault::Unfinished},
        {"+", Fault::Unfinished},
        {".", Fault::Unfinished},
        {"-,", Fault::Unfinished},
        {"1e", Fault::Unfinished},
        {"1e-", Fault::Unfinished},
        {"1 2", Fault::BlankInside},
        {"1 000", Fault::BlankInside},
        {"\u2013 5", Fault::BlankInside},
        {"1\u202F000,5", Fault::BlankInside},
        {"1,234.5", Fault::TwoDecimalMarks},
        {"1.234,5", Fault::TwoDecimalMarks},
        {"1.2.3", Fault::TwoDecimalMarks},
        {"1,,5", Fault::TwoDecimalMarks},
        {"--1", Fault::NotANumber},
        {"+-1", Fault::NotANumber},
        {"1-", Fault::NotANumber},
        {"0x10", Fault::NotANumber},
        {"nan", Fault::NotANumber},
        {"inf", Fault::NotANumber},
        {"-infinity", Fault::NotANumber},
        {"abc", Fault::NotANumber},
        {"e5", Fault::NotANumber},
        {"1e5.5", Fault::NotANumber},
        {"1e5e5", Fault::NotANumber},
        {"5 mm", Fault::NotANumber},
        {"1'000", Fault::NotANumber},
        {"1\u00B2", Fault::NotANumber},
        {"\uFF1A", Fault::NotANumber},   // the character after the full-width nine
        {"\xE2\x88", Fault::NotANumber}, // a minus sign cut off
        {"\xFF", Fault::NotANumber},
        {"1e999", Fault::NoSuchSize},
        {"-1e999", Fault::NoSuchSize},
        {"1e-999", Fault::NoSuchSize}};
    for (const auto& [text, fault] : refused) {
        const TypedNumber number = readTypedNumber(text);
        EXPECT_EQ(number.fault, fault) << text;
        EXPECT_EQ(number.value, 0.0) << text;
    }
    EXPECT_EQ(readTypedNumber(std::string_view("1\0002", 3)).fault, Fault::NotANumber);
}

} // namespace
} // namespace hexapose
