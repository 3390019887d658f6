// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/report/error_report.h"

#include <QWidget>

namespace hexapose {

/// The report as it will be printed: a white sheet in either theme.
class ReportPreview final : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    void setReport(const ErrorReport& report);
    /// Shown while there is nothing to draw.
    void setEmptyText(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    ErrorReport m_report;
    QString m_emptyText;
};

} // namespace hexapose
