// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/view_bar.h"

#include "core/base/number_text.h"
#include "ui/common/card.h"
#include "ui/common/labelled.h"
#include "ui/common/number_field.h"
#include "ui/viewer/chart_sheet.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

namespace hexapose {

namespace {

constexpr int kCursorWidth = 108;
constexpr double kZoom = 0.5;
constexpr NumberBounds kAnyTime{-1e18, 1e18, false};

} // namespace

ViewBar::ViewBar(QWidget* parent)
    : QFrame(parent), m_open(new QPushButton(this)), m_back(new QPushButton(this)),
      m_forward(new QPushButton(this)), m_zoomOut(new QPushButton(this)), m_zoomIn(new QPushButton(this)),
      m_fit(new QPushButton(this)), m_captionA(makeMutedLabel(this)), m_captionB(makeMutedLabel(this)),
      m_cursorA(new QLineEdit(this)), m_cursorB(new QLineEdit(this)), m_export(new QPushButton(this)) {
    setObjectName(QStringLiteral("header"));
    build();
    connect(m_open, &QPushButton::clicked, this, &ViewBar::openRequested);
    connect(m_export, &QPushButton::clicked, this, &ViewBar::exportRequested);
    const auto ask = [this](QPushButton* button, auto what) {
        connect(button, &QPushButton::clicked, this, [this, what] {
            if (m_sheet != nullptr)
                what(*m_sheet);
        });
    };
    ask(m_back, [](ChartSheet& sheet) { sheet.goBack(); });
    ask(m_forward, [](ChartSheet& sheet) { sheet.goForward(); });
    ask(m_zoomIn, [](ChartSheet& sheet) { sheet.zoom(kZoom); });
    ask(m_zoomOut, [](ChartSheet& sheet) { sheet.zoom(1.0 / kZoom); });
    ask(m_fit, [](ChartSheet& sheet) { sheet.fit(); });
    connect(m_cursorA, &QLineEdit::textChanged, this, [this] { takeCursor(*m_cursorA, true); });
    connect(m_cursorB, &QLineEdit::textChanged, this, [this] { takeCursor(*m_cursorB, false); });
    retranslate();
    enable();
}

void ViewBar::build() {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 5, 10, 5);
    row->setSpacing(5);
    row->addWidget(m_open);
    row->addSpacing(8);
    for (QPushButton* button : {m_back, m_forward, m_zoomOut, m_zoomIn}) {
        button->setProperty("compact", true);
        row->addWidget(button);
    }
    row->addWidget(m_fit);
    row->addStretch(1);
    for (QLineEdit* field : {m_cursorA, m_cursorB}) {
        field->setProperty("number", true);
        field->setProperty("wrong", false);
        field->setAlignment(Qt::AlignRight);
        field->setFixedWidth(kCursorWidth);
        row->addWidget(field == m_cursorA ? m_captionA : m_captionB);
        row->addWidget(field);
    }
    row->addSpacing(8);
    row->addWidget(m_export);
}

void ViewBar::follow(ChartSheet* sheet) {
    if (m_sheet != nullptr)
        disconnect(m_sheet, nullptr, this, nullptr);
    m_sheet = sheet;
    if (m_sheet != nullptr) {
        connect(m_sheet, &ChartSheet::viewChanged, this, &ViewBar::enable);
        connect(m_sheet, &ChartSheet::cursorsChanged, this, &ViewBar::showCursors);
        connect(m_sheet, &QObject::destroyed, this, [this] {
            m_sheet = nullptr;
            enable();
        });
    }
    showCursors();
    enable();
}

void ViewBar::setExporting(bool isExporting) {
    m_isExporting = isExporting;
    enable();
}

void ViewBar::enable() {
    const bool any = m_sheet != nullptr && m_sheet->table()->rowCount() > 0;
    m_back->setEnabled(any && m_sheet->canGoBack());
    m_forward->setEnabled(any && m_sheet->canGoForward());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_zoomIn, m_zoomOut, m_fit, m_cursorA, m_cursorB})
        widget->setEnabled(any);
    m_export->setEnabled(any && !m_isExporting);
}

/// Also that of the other field, and not over what is being typed.
void ViewBar::showCursors() {
    const Cursors cursors = m_sheet != nullptr ? m_sheet->cursors() : Cursors();
    const auto show = [](QLineEdit& field, const std::optional<double>& time) {
        const auto typed = readNumber(field.text(), kAnyTime).value;
        if (typed == time)
            return;
        const QSignalBlocker quiet(&field);
        field.setText(time ? QString::fromStdString(formatNumber(*time)) : QString());
        setStyleProperty(field, "wrong", false);
    };
    show(*m_cursorA, cursors.a);
    show(*m_cursorB, cursors.b);
}

void ViewBar::takeCursor(QLineEdit& field, bool isA) {
    if (m_sheet == nullptr)
        return;
    const NumberReading reading = readNumber(field.text(), kAnyTime);
    const bool isWrong = !field.text().trimmed().isEmpty() && !reading.value;
    setStyleProperty(field, "wrong", isWrong);
    field.setAccessibleDescription(isWrong ? reading.refusal : QString());
    if (isWrong)
        return;
    Cursors cursors = m_sheet->cursors();
    (isA ? cursors.a : cursors.b) = reading.value;
    m_sheet->setCursors(cursors);
}

void ViewBar::retranslate() {
    label(*m_open, tr("Open log"), tr("Open one or several logs or CSV files"));
    label(*m_back, QStringLiteral("\u2190"), tr("Back"), tr("The view before (Backspace)"));
    label(*m_forward, QStringLiteral("\u2192"), tr("Forward"), tr("The view after (Alt+Right)"));
    label(*m_zoomOut, QStringLiteral("\u2212"), tr("Zoom out"), tr("Show twice the time (-)"));
    label(*m_zoomIn, QStringLiteral("+"), tr("Zoom in"), tr("Show half the time (+)"));
    label(*m_fit, tr("Everything"), tr("Show everything"), tr("The whole log (Home)"));
    label(*m_export, tr("Export"), tr("The charts as PNG, SVG or PDF, or the rows shown as CSV"));
    setCaption(*m_captionA, tr("Cursor A"));
    setCaption(*m_captionB, tr("Cursor B"));
    m_cursorA->setAccessibleName(tr("Cursor A"));
    m_cursorB->setAccessibleName(tr("Cursor B"));
    const QString tip = tr("Time in s; a click into a chart sets A, with Ctrl B; the keys A and B too");
    m_cursorA->setToolTip(tip);
    m_cursorB->setToolTip(tip);
}

void ViewBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QFrame::changeEvent(event);
}

} // namespace hexapose

#include "moc_view_bar.cpp"
