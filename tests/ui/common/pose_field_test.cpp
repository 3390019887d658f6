// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screen_reader.h"
#include "ui/common/pose_field.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

QString typed(const char* keys) {
    PoseField field;
    field.show();
    field.selectAll();
    QTest::keyClicks(&field, QString::fromLatin1(keys));
    return field.text();
}

TEST(PoseField, TakesNumbersWithAPointInEveryLanguage) {
    EXPECT_EQ(typed("-4.25"), "-4.25");
    EXPECT_EQ(typed("0.123456"), "0.123456");
    EXPECT_EQ(typed("4,25"), "425"); // the comma is not taken at all, so 4.25 is not read for 4,25
    EXPECT_EQ(typed("1e3"), "13");
    EXPECT_EQ(typed("nan"), "0.00"); // no letter is taken
    PoseField field;
    const std::pair<double, const char*> shown[] = {
        {0.0, "0.00"}, {12.0, "12.00"}, {-4.5, "-4.50"}, {1.23456789, "1.234568"}, {12345.5, "12345.50"}};
    for (const auto& [value, text] : shown) {
        field.setValue(value);
        EXPECT_EQ(field.text(), text);
    }
}

TEST(PoseField, TellsAnUnfinishedNumberAndEveryKeystroke) {
    PoseField field;
    field.show();
    EXPECT_TRUE(field.isComplete());
    QSignalSpy edited(&field, &PoseField::edited);
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("-"));
    EXPECT_FALSE(field.isComplete());
    EXPECT_TRUE(field.property("wrong").toBool());
    QTest::keyClicks(&field, QStringLiteral("7"));
    EXPECT_TRUE(field.isComplete());
    EXPECT_DOUBLE_EQ(field.value(), -7.0);
    EXPECT_EQ(edited.count(), 2);
}

TEST(PoseField, NothingWithinAnyMachineIsClamped) {
    PoseField field;
    field.setValue(98765.4321);
    EXPECT_DOUBLE_EQ(field.value(), 98765.4321);
}

TEST(PoseField, WheelOverAFieldWithoutFocusChangesNothing) {
    PoseField field;
    field.show();
    const auto turn = [&field] {
        QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&field, &wheel);
    };
    field.clearFocus();
    turn();
    EXPECT_DOUBLE_EQ(field.value(), 0.0);
}

TEST(PoseField, CanBeWrittenThroughAScreenReader) {
    PoseField field;
    field.setAccessibleName(QStringLiteral("Target x"));
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&field);
    ASSERT_NE(accessible->editableTextInterface(), nullptr);
    accessible->editableTextInterface()->replaceText(0, accessible->textInterface()->characterCount(),
                                                     QStringLiteral("12.5"));
    EXPECT_DOUBLE_EQ(field.value(), 12.5);
    EXPECT_EQ(testing::spokenText(&field), "12.5");
}

} // namespace
} // namespace hexapose
