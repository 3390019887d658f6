// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/report/report_preview.h"

#include "ui/report/report_export.h"

#include <QPainter>
#include <QPalette>

namespace hexapose {

namespace {
constexpr double kMargin = 10.0;
}

void ReportPreview::setReport(const ErrorReport& report) {
    m_report = report;
    update();
}

void ReportPreview::setEmptyText(const QString& text) {
    m_emptyText = text;
    update();
}

void ReportPreview::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_report.rows.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(Qt::white);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
    paintErrorPanels(painter, QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin), m_report);
}

} // namespace hexapose

#include "moc_report_preview.cpp"
