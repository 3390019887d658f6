// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rules for every control of the window, whatever is added to it: found by a walk over its widgets.
#include "tests/ui/console/synthetic_machine.h"
#include "tests/ui/screen_reader.h"
#include "tests/ui/typing.h"
#include "ui/common/number_field.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/motion/motion_panel.h"
#include "ui/console/motion/target_panel.h"
#include "ui/console/motion/way_point_table.h"
#include "ui/console/motion/way_points_panel.h"
#include "ui/console/report/report_panel.h"
#include "ui/console/window/operator_window.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>

#include <gtest/gtest.h>

namespace hexapose {
namespace {

using namespace hexapose::testing;

class ControlsTest : public ::testing::Test {
protected:
    ControlsTest()
        : geometry(laboratoryPlatform()), window(makeModel(geometry), [] { return QStringList(); }) {
        window.connectionPanel().setAvailable(true);
        box("Connection").setEditText(QStringLiteral("/dev/ttyS7")); // the baud rate is of use there alone
        window.motionPanel().wayPoints().table().setPoses(
            {poseOf(5, 0, 0, 0, 0, 0), poseOf(0, 5, 0, 0, 0, 2)});
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        live();
    }
    void live() {
        window.showSnapshots({std::make_shared<const Snapshot>(
            snapshotAt(geometry, Pose{}, Pose{}, RunState::Enabled, now += 0.01))});
    }
    /// Run waits for the plan of its target.
    static bool isEnabledSoon(const QPushButton& button) {
        return QTest::qWaitFor([&button] { return button.isEnabled(); }, kPatienceMs);
    }
    QPushButton& button(const char* name) {
        return *qobject_cast<QPushButton*>(findByName(window, QString::fromLatin1(name)));
    }
    QComboBox& box(const char* name) {
        QWidget* found = findByName(window, QString::fromLatin1(name));
        auto* itself = qobject_cast<QComboBox*>(found);
        return itself != nullptr ? *itself : *qobject_cast<QComboBox*>(found->parentWidget());
    }

    PlatformGeometry geometry;
    OperatorWindow window;
    double now = 0.0;
};

struct Typed {
    QString text;
    std::optional<double> means;
};

const std::vector<Typed> kTyped{{QStringLiteral("1,5"), 1.5},          {QStringLiteral("1e-3"), 1e-3},
                                {QStringLiteral("1e5"), 1e5},          {QString::fromUtf8("\u22125"), -5.0},
                                {QStringLiteral("abc"), std::nullopt}, {QString(), std::nullopt}};

/// Types into a field; it has to understand the text whole, or to refuse it with a reason.
void typeAndJudge(NumberField& field, const Typed& typed) {
    field.setFocus();
    field.selectAll();
    QTest::keyClick(&field, Qt::Key_Delete);
    typeText(field, typed.text);
    const std::string where = field.accessibleName().toStdString() + " <- " + typed.text.toStdString();
    EXPECT_EQ(field.text(), typed.text) << where << ": kept as it is typed";
    if (field.value()) {
        EXPECT_EQ(field.value(), typed.means) << where;
    } else {
        const bool fits = typed.means && *typed.means >= field.bounds().least &&
                          *typed.means <= field.bounds().largest &&
                          (!field.bounds().whole || *typed.means == std::floor(*typed.means));
        EXPECT_FALSE(fits) << where;
        EXPECT_FALSE(field.refusal().isEmpty()) << where;
        EXPECT_EQ(field.accessibleDescription(), field.refusal()) << where;
    }
}

/// A panel of numbers may be added with any widget that Qt has for them; only the shared field is right.
TEST_F(ControlsTest, NumbersAreTypedIntoTheSharedFieldAlone) {
    EXPECT_TRUE(window.findChildren<QAbstractSpinBox*>().isEmpty());
    for (const auto* edit : window.findChildren<QLineEdit*>()) {
        EXPECT_EQ(edit->validator(), nullptr) << edit->accessibleName().toStdString();
        EXPECT_TRUE(edit->inputMask().isEmpty()) << edit->accessibleName().toStdString();
        EXPECT_EQ(edit->completer(), nullptr) << edit->accessibleName().toStdString();
    }
    for (const char* text : {"Connection", "Pose name", "Report folder"}) {
        EXPECT_NE(findByName(window, QString::fromLatin1(text)), nullptr);
    }
    for (const auto* edit : window.findChildren<QLineEdit*>()) {
        const bool free = edit->accessibleName() == QStringLiteral("Connection") ||
                          edit->accessibleName() == QStringLiteral("Pose name") ||
                          edit->accessibleName() == QStringLiteral("Report folder");
        EXPECT_TRUE(free || qobject_cast<const ReadOut*>(edit) != nullptr ||
                    qobject_cast<const NumberField*>(edit) != nullptr)
            << edit->accessibleName().toStdString() << ": a field for text is to be named here";
    }
    EXPECT_GE(window.findChildren<NumberField*>().size(), 7); // the target and the baud rate
}

TEST_F(ControlsTest, EveryNumberIsUnderstoodWholeOrItsButtonIsDisabledWithTheReason) {
    for (NumberField* field : window.findChildren<NumberField*>()) {
        const QString before = field->text();
        const bool baud = field->accessibleName() == QStringLiteral("Baud rate");
        QPushButton& user = button(baud ? "Connect" : "Run");
        EXPECT_TRUE(isEnabledSoon(user));
        for (const Typed& typed : kTyped) {
            typeAndJudge(*field, typed);
            const std::string where =
                field->accessibleName().toStdString() + " <- " + typed.text.toStdString();
            if (field->isRefused()) {
                EXPECT_FALSE(user.isEnabled()) << where;
                EXPECT_TRUE(user.toolTip().contains(field->refusal())) << where;
                EXPECT_EQ(user.accessibleDescription(), user.toolTip()) << where;
                bool beside = false;
                for (const auto* label : field->window()->findChildren<QLabel*>()) {
                    beside = beside || (label->isVisible() && label->text() == field->refusal());
                }
                EXPECT_TRUE(beside) << where << ": the reason stands beside the field";
                if (!baud) {
                    EXPECT_FALSE(button("Add target").isEnabled()) << where;
                }
            }
        }
        field->setText(before);
        live();
        EXPECT_TRUE(isEnabledSoon(user)) << field->accessibleName().toStdString();
    }
}

TEST_F(ControlsTest, EveryCellOfTheWayPointsIsSuchAFieldToo) {
    window.motionPanel().showPage(MotionPanel::WayPoints);
    WayPointTable& table = window.motionPanel().wayPoints().table();
    for (int column = 0; column < table.columnCount(); ++column) {
        for (const Typed& typed : kTyped) {
            const QString before = table.item(1, column)->text();
            table.setCurrentCell(1, column);
            table.editItem(table.item(1, column));
            auto* editor = table.findChild<NumberField*>();
            ASSERT_NE(editor, nullptr);
            typeAndJudge(*editor, typed);
            const QString refusal = editor->refusal();
            QTest::keyClick(editor, Qt::Key_Return);
            QCoreApplication::sendPostedEvents(); // the table closes an editor after the key
            EXPECT_EQ(table.item(1, column)->text(), typed.text);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            EXPECT_EQ(table.findChild<NumberField*>(), nullptr);
            if (refusal.isEmpty()) {
                EXPECT_EQ(table.poseAt(1)->toVector()[column], fromDisplay(column, typed.means.value()));
                EXPECT_TRUE(button("Play").isEnabled());
            } else {
                EXPECT_FALSE(table.poseAt(1));
                EXPECT_FALSE(button("Play").isEnabled());
                EXPECT_FALSE(button("Step").isEnabled());
                EXPECT_TRUE(spokenText(window, QStringLiteral("Way-point progress")).contains(refusal));
                EXPECT_TRUE(table.item(1, column)->toolTip().contains(refusal));
            }
            table.item(1, column)->setText(before);
        }
    }
    // Play with an editor still open takes what stands in it.
    table.setCurrentCell(0, 2);
    table.editItem(table.item(0, 2));
    auto* editor = table.findChild<NumberField*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    typeText(*editor, QStringLiteral("1.2.3"));
    window.motionPanel().wayPoints().play();
    EXPECT_FALSE(window.motionPanel().wayPoints().isRunning());
    EXPECT_EQ(table.item(0, 2)->text(), "1.2.3");
}

/// The state of a control that the wheel might change.
int valueOf(const QWidget& widget) {
    if (const auto* found = qobject_cast<const QComboBox*>(&widget)) {
        return found->currentIndex();
    }
    if (const auto* found = qobject_cast<const QTabBar*>(&widget)) {
        return found->currentIndex();
    }
    if (const auto* found = qobject_cast<const QAbstractSlider*>(&widget)) {
        return found->value();
    }
    return 0;
}

TEST_F(ControlsTest, TheWheelChangesNoControlWithoutTheFocus) {
    int judged = 0;
    for (const int page : {0, 1}) {
        window.showPage(page);
        for (const auto motion :
             {MotionPanel::Target, MotionPanel::Jog, MotionPanel::WayPoints, MotionPanel::Test}) {
            window.motionPanel().showPage(motion);
            window.setFocus();
            for (QWidget* widget : window.findChildren<QWidget*>()) {
                const bool control =
                    qobject_cast<QComboBox*>(widget) || qobject_cast<QTabBar*>(widget) ||
                    qobject_cast<NumberField*>(widget) ||
                    (qobject_cast<QAbstractSlider*>(widget) && !qobject_cast<QScrollBar*>(widget));
                if (!control || !widget->isVisible() || !widget->isEnabled()) {
                    continue;
                }
                const int before = valueOf(*widget);
                const auto* field = qobject_cast<NumberField*>(widget);
                const QString text = field != nullptr ? field->text() : QString();
                for (const int notches : {-1, 1, -3, 3}) {
                    turnWheelOver(*widget, notches);
                    EXPECT_EQ(valueOf(*widget), before) << widget->accessibleName().toStdString();
                    EXPECT_TRUE(field == nullptr || field->text() == text);
                }
                ++judged;
            }
        }
    }
    EXPECT_GE(judged, 70); // eight or more on each of eight pages
}

} // namespace
} // namespace hexapose
