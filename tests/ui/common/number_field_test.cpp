// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screen_reader.h"
#include "tests/ui/typing.h"
#include "ui/common/number_field.h"
#include "ui/common/wheel_guard.h"

#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

void type(NumberField& field, const QString& keys) {
    field.show();
    field.selectAll();
    testing::typeText(field, keys);
}

TEST(NumberField, KeepsWhatIsTypedAndUnderstandsItWhole) {
    const std::pair<QString, double> understood[] = {{QStringLiteral("-4.25"), -4.25},
                                                     {QStringLiteral("1,5"), 1.5},
                                                     {QStringLiteral("1e-3"), 1e-3},
                                                     {QStringLiteral("1e5"), 1e5},
                                                     {QStringLiteral("0.1234567891"), 0.1234567891},
                                                     {QString::fromUtf8("\u22125"), -5.0}};
    for (const auto& [text, value] : understood) {
        NumberField field;
        type(field, text);
        EXPECT_EQ(field.text(), text);
        ASSERT_TRUE(field.value()) << text.toStdString();
        EXPECT_EQ(*field.value(), value);
        EXPECT_TRUE(field.refusal().isEmpty());
    }
}

TEST(NumberField, RefusesTheWholeTextWithItsReason) {
    for (const char* text :
         {"abc", "1,234.5", "1.2.3", "1 2", "0x10", "nan", "inf", "--1", "-", "1e7", "-1e7"}) {
        NumberField field;
        QSignalSpy edited(&field, &NumberField::edited);
        type(field, QString::fromLatin1(text));
        EXPECT_EQ(field.text(), text) << "nothing is filtered";
        EXPECT_FALSE(field.value()) << text;
        EXPECT_FALSE(field.refusal().isEmpty()) << text;
        EXPECT_EQ(field.accessibleDescription(), field.refusal());
        EXPECT_TRUE(field.property("wrong").toBool());
        EXPECT_GE(edited.count(), 1);
        type(field, QStringLiteral("7"));
        EXPECT_EQ(field.value(), 7.0);
        EXPECT_FALSE(field.property("wrong").toBool());
        EXPECT_TRUE(field.accessibleDescription().isEmpty());
    }
}

/// An emptied field stayed empty to the eye only: leaving it wrote its old number back.
TEST(NumberField, AnEmptiedFieldStaysRefusedWhenItIsLeft) {
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* field = new NumberField({}, &window);
    auto* other = new NumberField({}, &window);
    column->addWidget(field);
    column->addWidget(other);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    field->setFocus();
    field->selectAll();
    QTest::keyClick(field, Qt::Key_Delete);
    other->setFocus();
    EXPECT_TRUE(field->text().isEmpty());
    EXPECT_TRUE(field->isRefused());
}

TEST(NumberField, IsOutsideItsRangeOrNotWhole) {
    NumberField field(NumberBounds{50.0, 1000000.0, true});
    EXPECT_EQ(field.value(), 50.0);
    type(field, QStringLiteral("49"));
    EXPECT_EQ(field.refusal(), "not in 50 .. 1000000");
    type(field, QStringLiteral("57600.5"));
    EXPECT_EQ(field.refusal(), "not a whole number");
    type(field, QStringLiteral("1e5"));
    EXPECT_EQ(field.value(), 100000.0);
}

TEST(NumberField, WritesNumbersWithTwoToSixDecimals) {
    NumberField field;
    QSignalSpy edited(&field, &NumberField::edited);
    const std::pair<double, const char*> shown[] = {{0.0, "0.00"},
                                                    {12.0, "12.00"},
                                                    {-4.5, "-4.50"},
                                                    {1.23456789, "1.234568"},
                                                    {98765.4321, "98765.4321"}};
    for (const auto& [value, text] : shown) {
        field.showValue(value);
        EXPECT_EQ(field.text(), text);
    }
    EXPECT_EQ(edited.count(), 0);
    type(field, QStringLiteral("x"));
    field.showValue(98765.4321); // the value it had before
    EXPECT_FALSE(field.isRefused());
    EXPECT_FALSE(field.property("wrong").toBool());
}

TEST(NumberField, ArrowKeysStepAndNeverOverTheEnd) {
    NumberField field(NumberBounds{0.0, 12.0});
    field.show();
    field.showValue(1.25);
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(field.value(), 2.25);
    QTest::keyClick(&field, Qt::Key_PageUp);
    EXPECT_EQ(field.text(), "2.25") << "12.25 is beyond its range, and 12 was not asked for";
    QTest::keyClick(&field, Qt::Key_Down);
    QTest::keyClick(&field, Qt::Key_Down);
    EXPECT_EQ(field.value(), 0.25);
    QTest::keyClick(&field, Qt::Key_Down);
    EXPECT_EQ(field.value(), 0.25);
    type(field, QStringLiteral("-"));
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(field.text(), "-");
}

TEST(NumberField, CanBeWrittenThroughAScreenReader) {
    NumberField field;
    field.setAccessibleName(QStringLiteral("Target x"));
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&field);
    ASSERT_NE(accessible->editableTextInterface(), nullptr);
    accessible->editableTextInterface()->replaceText(0, accessible->textInterface()->characterCount(),
                                                     QStringLiteral("12.5"));
    EXPECT_EQ(field.value(), 12.5);
    EXPECT_EQ(testing::spokenText(&field), "12.5");
}

TEST(WheelGuard, ScrollsWhatIsAroundAControlWithoutTheFocus) {
    const WheelGuard guard;
    QScrollArea area;
    auto* content = new QWidget;
    content->setMinimumHeight(2000);
    auto* box = new QComboBox(content);
    box->addItems({QStringLiteral("a"), QStringLiteral("b")});
    auto* slider = new QSlider(Qt::Horizontal, content);
    slider->move(0, 100);
    area.setWidget(content);
    area.resize(200, 200);
    area.show();
    area.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&area));
    area.setFocus();
    int scrolled = area.verticalScrollBar()->value();
    for (QWidget* widget : std::initializer_list<QWidget*>{box, slider}) {
        testing::turnWheelOver(*widget);
        EXPECT_GT(area.verticalScrollBar()->value(), scrolled);
        scrolled = area.verticalScrollBar()->value();
    }
    EXPECT_EQ(box->currentIndex(), 0);
    EXPECT_EQ(slider->value(), 0);
    box->setFocus();
    testing::turnWheelOver(*box);
    EXPECT_EQ(box->currentIndex(), 1) << "with the focus it is meant";
}

} // namespace
} // namespace hexapose
