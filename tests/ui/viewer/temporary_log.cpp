// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewer/temporary_log.h"

#include <QApplication>
#include <QDropEvent>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace hexapose::testing {

TemporaryLog::TemporaryLog(const std::string& text, const std::string& name)
    : m_file(m_folder.filePath(QString::fromStdString(name)).toStdString()) {
    std::ofstream(m_file, std::ios::binary) << text;
}

std::string bytesOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string logText(int rows) {
    std::string text = "time_s,a,state,event\n";
    for (int i = 0; i < rows; ++i) {
        const double time = 0.01 * i;
        const double value = i == 5000 ? 100.0 : std::sin(time);
        const bool isMoving = time >= 10.0 && time < 20.0;
        text += std::to_string(time) + "," + std::to_string(value) + "," + (isMoving ? "moving" : "enabled") +
                "," +
                (i == 1000   ? "motion started"
                 : i == 2000 ? "in position"
                             : "") +
                "\n";
    }
    return text;
}

void drop(QWidget& widget, const QMimeData& data) {
    const QPoint place(100, 50);
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

bool waitUntil(const std::function<bool()>& isSo) {
    constexpr int kLongestMs = 20000;
    return QTest::qWaitFor(isSo, kLongestMs);
}

} // namespace hexapose::testing
