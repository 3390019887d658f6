// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPdfWriter>
#include <QString>
#include <QStringList>

#include <vector>

namespace hexapose {

/// Text and tables on A4, from the top of each page down. All sizes in mm.
class PdfPages {
public:
    /// The footer of every page: its text on the left, "page 2 of 5" on the right.
    PdfPages(QIODevice& device, const QString& title, const QString& footer, int pageCount);

    QPainter& painter() { return m_painter; }
    double width() const;     ///< between the margins
    double remaining() const; ///< down to the footer
    int page() const { return m_page; }
    static double pageHeight(); ///< what remaining() is on a new page
    void newPage();
    void skip(double height) { m_y += height; }
    /// The next `height` of the page as a rectangle in device pixels.
    QRectF take(double height);

    void heading(const QString& text, double pointSize);
    /// A bold word and a line of text after it, cut where the line ends.
    void line(const QString& label, double labelWidth, const QString& text);
    /// Small print, wrapped within so many lines.
    void note(const QString& text, int lines);
    /// Text, wrapped within as many lines as it takes.
    void paragraph(const QString& text);
    double paragraphHeight(const QString& text);
    void rule();
    static double lineHeight();

    struct Table {
        std::vector<double> widths;  ///< of the columns, mm; the first is set left, the others right
        std::vector<int> headerSpan; ///< columns under each group name, the first column not counted
        QStringList groups;
        QStringList header;
        std::vector<QStringList> rows;
        std::vector<int> headerRows{}; ///< rows that are set as another header
    };
    void table(const Table& table);
    static double tableHeight(const Table& table);

private:
    double px(double mm) const;
    QFont font(double points, bool bold = false) const;
    void tableRow(const Table& table, const QStringList& cells, bool bold);
    void groupRow(const Table& table);
    void paintFooter();

    QPdfWriter m_writer;
    QPainter m_painter;
    QString m_footer;
    int m_pageCount;
    int m_page = 1;
    double m_y = 0.0;
};

} // namespace hexapose
