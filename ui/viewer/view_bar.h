// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace hexapose {

struct Cursors;
class ChartSheet;

/// Above the charts: open a log, go through its views, and where the cursors are.
class ViewBar final : public QFrame {
    Q_OBJECT
public:
    explicit ViewBar(QWidget* parent = nullptr);
    /// Null for none.
    void follow(ChartSheet* sheet);
    /// One at a time.
    void setExporting(bool isExporting);

signals:
    void openRequested();
    void exportRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showCursors();
    void takeCursor(QLineEdit& field, bool isA);
    void enable();
    void retranslate();

    ChartSheet* m_sheet = nullptr;
    bool m_isExporting = false;
    QPushButton* m_open;
    QPushButton* m_back;
    QPushButton* m_forward;
    QPushButton* m_zoomOut;
    QPushButton* m_zoomIn;
    QPushButton* m_fit;
    QLabel* m_captionA;
    QLabel* m_captionB;
    QLineEdit* m_cursorA;
    QLineEdit* m_cursorB;
    QPushButton* m_export;
};

} // namespace hexapose
