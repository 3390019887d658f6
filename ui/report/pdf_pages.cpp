// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/pdf_pages.h"

#include "core/base/input_error.h"
#include "ui/plot/plot.h"
#include "ui/report/report_words.h"

#include <QFontMetricsF>
#include <QPageLayout>
#include <QPageSize>
#include <QTextOption>

#include <algorithm>

namespace hexapose {

namespace {

constexpr double kPageWidth = 210.0; // A4, mm
constexpr double kPageHeight = 297.0;
constexpr double kMargin = 17.0;
constexpr double kFooterHeight = 8.0;
constexpr double kMmInInch = 25.4;
constexpr double kPointsInInch = 72.0;
constexpr int kDotsPerInch = 600;

constexpr double kTextPoints = 9.0;
constexpr double kTablePoints = 8.0;
constexpr double kLineHeight = 4.8;
constexpr double kRowHeight = 4.3;
constexpr double kParagraphGap = 1.5;

const QColor kTextInk(0x22, 0x22, 0x22);
const QColor kQuiet(0x66, 0x66, 0x66);
const QColor kRule(0xB8, 0xB8, 0xB8);

} // namespace

PdfPages::PdfPages(QIODevice& device, const QString& title, const QString& footer, int pageCount)
    : m_writer(&device), m_footer(footer), m_pageCount(pageCount) {
    m_writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait,
                                       QMarginsF(kMargin, kMargin, kMargin, kMargin),
                                       QPageLayout::Millimeter));
    m_writer.setResolution(kDotsPerInch);
    m_writer.setTitle(title);
    m_writer.setCreator(QStringLiteral("Hexapose"));
    if (!m_painter.begin(&m_writer))
        throw InputError(title.toStdString(), "cannot be drawn");
    paintFooter();
}

double PdfPages::width() const {
    return kPageWidth - 2.0 * kMargin;
}

double PdfPages::pageHeight() {
    return kPageHeight - 2.0 * kMargin - kFooterHeight;
}

double PdfPages::remaining() const {
    return pageHeight() - m_y;
}

double PdfPages::px(double mm) const {
    return mm / kMmInInch * kDotsPerInch;
}

QFont PdfPages::font(double points, bool bold) const {
    return paperFont(points / kPointsInInch * kDotsPerInch, bold);
}

void PdfPages::newPage() {
    m_writer.newPage();
    ++m_page;
    m_y = 0.0;
    paintFooter();
}

QRectF PdfPages::take(double height) {
    const QRectF area(0.0, px(m_y), px(width()), px(height));
    m_y += height;
    return area;
}

void PdfPages::paintFooter() {
    const QRectF area(0.0, px(kPageHeight - 2.0 * kMargin - kRowHeight), px(width()), px(kRowHeight));
    m_painter.setFont(font(kTablePoints));
    m_painter.setPen(kQuiet);
    const QString number = ReportWords::tr("page %1 of %2").arg(m_page).arg(m_pageCount);
    const QFontMetricsF metrics(m_painter.font(), &m_writer);
    const double room = area.width() - metrics.horizontalAdvance(number) - px(5.0);
    m_painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                       metrics.elidedText(m_footer, Qt::ElideRight, room));
    m_painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter, number);
}

void PdfPages::heading(const QString& text, double pointSize) {
    m_painter.setFont(font(pointSize, true));
    m_painter.setPen(kTextInk);
    m_painter.drawText(take(pointSize / kPointsInInch * kMmInInch * 1.6), Qt::AlignLeft | Qt::AlignVCenter,
                       text);
}

void PdfPages::line(const QString& label, double labelWidth, const QString& text) {
    const QRectF area = take(kLineHeight);
    m_painter.setPen(kTextInk);
    m_painter.setFont(font(kTextPoints, true));
    m_painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter, label);
    m_painter.setFont(font(kTextPoints));
    const QRectF rest = area.adjusted(px(labelWidth), 0.0, 0.0, 0.0);
    const QString shown =
        QFontMetricsF(m_painter.font(), &m_writer).elidedText(text, Qt::ElideRight, rest.width());
    m_painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter, shown);
}

void PdfPages::note(const QString& text, int lines) {
    m_painter.setFont(font(kTablePoints));
    m_painter.setPen(kQuiet);
    QTextOption wrapped(Qt::AlignLeft | Qt::AlignTop);
    wrapped.setWrapMode(QTextOption::WordWrap);
    m_painter.drawText(take(lines * kRowHeight), text, wrapped);
}

double PdfPages::paragraphHeight(const QString& text) {
    const QFontMetricsF metrics(font(kTextPoints), &m_writer);
    const QRectF room(0.0, 0.0, px(width()), px(pageHeight()));
    return metrics.boundingRect(room, Qt::TextWordWrap, text).height() / px(1.0) + kParagraphGap;
}

void PdfPages::paragraph(const QString& text) {
    m_painter.setFont(font(kTextPoints));
    m_painter.setPen(kTextInk);
    m_painter.drawText(take(paragraphHeight(text)), Qt::TextWordWrap, text);
}

double PdfPages::lineHeight() {
    return kLineHeight;
}

void PdfPages::rule() {
    m_painter.setPen(QPen(kRule, px(0.2)));
    m_painter.drawLine(QPointF(0.0, px(m_y)), QPointF(px(width()), px(m_y)));
}

double PdfPages::tableHeight(const Table& table) {
    return kRowHeight * (static_cast<double>(table.rows.size()) + (table.groups.isEmpty() ? 1.0 : 2.0));
}

void PdfPages::table(const Table& table) {
    rule();
    if (!table.groups.isEmpty())
        groupRow(table);
    tableRow(table, table.header, true);
    rule();
    for (int i = 0; i < static_cast<int>(table.rows.size()); ++i) {
        const bool isHeader =
            std::find(table.headerRows.begin(), table.headerRows.end(), i) != table.headerRows.end();
        if (isHeader)
            rule();
        tableRow(table, table.rows[static_cast<std::size_t>(i)], isHeader);
        if (isHeader)
            rule();
    }
    rule();
}

void PdfPages::tableRow(const Table& table, const QStringList& cells, bool bold) {
    constexpr int kLeft = int{Qt::AlignLeft} | int{Qt::AlignVCenter};
    constexpr int kRight = int{Qt::AlignRight} | int{Qt::AlignVCenter};
    const QRectF row = take(kRowHeight);
    m_painter.setPen(kTextInk);
    double x = 0.0;
    for (int i = 0; i < cells.size() && i < static_cast<int>(table.widths.size()); ++i) {
        const double columnWidth = px(table.widths[static_cast<std::size_t>(i)]);
        m_painter.setFont(font(kTablePoints, bold || i == 0));
        m_painter.drawText(QRectF(x, row.top(), columnWidth, row.height()), i == 0 ? kLeft : kRight,
                           cells[i]);
        x += columnWidth;
    }
}

/// The names over several columns, with a rule below each.
void PdfPages::groupRow(const Table& table) {
    const QRectF row = take(kRowHeight);
    std::size_t column = 1;
    double x = px(table.widths.front());
    for (int i = 0; i < table.groups.size(); ++i) {
        double span = 0.0;
        for (int k = 0; k < table.headerSpan[static_cast<std::size_t>(i)]; ++k)
            span += px(table.widths[column++]);
        m_painter.setFont(font(kTablePoints, true));
        m_painter.setPen(kTextInk);
        const double inset = px(4.0);
        m_painter.drawText(QRectF(x + inset, row.top(), span - inset, row.height()), Qt::AlignCenter,
                           table.groups[i]);
        m_painter.setPen(QPen(kRule, px(0.2)));
        m_painter.drawLine(QPointF(x + inset, row.bottom()), QPointF(x + span, row.bottom()));
        x += span;
    }
}

} // namespace hexapose
