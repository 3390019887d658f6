// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/reproduction_pdf.h"

#include "app/cli/reproduce/exhibit_text.h"
#include "app/cli/reproduce/explanations.h"
#include "ui/report/pdf_pages.h"

#include <QBuffer>

#include <algorithm>
#include <iterator>
#include <numeric>

namespace hexapose::reproduce {

namespace {

constexpr double kBetween = 4.0; // mm
constexpr double kHeadingPoints = 13.0;
constexpr double kLeastPart = 0.8; ///< of its size, to which a picture shrinks to stay on its page

/// What is said once, on the first page.
constexpr const char* kFirstPage[] = {kWhyLinear,      kOneStepMore, kTable3Misprint,
                                      kTable5Misprint, kFewDigits,   kAboutTimes};

bool isOnFirstPage(const std::string& note) {
    return std::find(std::begin(kFirstPage), std::end(kFirstPage), note) != std::end(kFirstPage);
}

QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}

/// Columns as wide as what stands in them needs.
std::vector<double> columnWidths(const Block& block, double width) {
    constexpr double kGapCharacters = 2.0;
    std::vector<double> widths(block.header.size(), 0.0);
    const auto widen = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i)
            widths[i] = std::max(widths[i], static_cast<double>(cells[i].size()) + kGapCharacters);
    };
    widen(block.header);
    for (const Block::Row& row : block.rows)
        if (!row.heading)
            widen(row.cells);
    const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
    for (double& one : widths)
        one *= width / sum;
    return widths;
}

PdfPages::Table tableOf(const Block& block, double width) {
    PdfPages::Table table;
    table.widths = columnWidths(block, width);
    for (const Block::Group& group : block.groups) {
        table.groups << text(group.name);
        table.headerSpan.push_back(group.columns);
    }
    for (const std::string& name : block.header)
        table.header << text(name);
    for (std::size_t i = 0; i < block.rows.size(); ++i) {
        QStringList cells;
        for (const std::string& cell : block.rows[i].cells)
            cells << text(cell);
        if (block.rows[i].heading)
            table.headerRows.push_back(static_cast<int>(i));
        table.rows.push_back(cells);
    }
    return table;
}

class Document {
public:
    Document(QIODevice& device, std::span<const Exhibit> exhibits, const PdfTitles& titles, int pageCount)
        : m_exhibits(exhibits), m_pages(device, titles.title, titles.footer, pageCount) {}

    /// Returns the number of pages.
    int paint(bool withFirstPage) {
        if (withFirstPage)
            paintFirstPage();
        for (const Exhibit& exhibit : m_exhibits) {
            if (withFirstPage || &exhibit != &m_exhibits.front())
                m_pages.newPage();
            paintExhibit(exhibit);
        }
        return m_pages.page();
    }

private:
    void paintFirstPage() {
        m_pages.heading(QStringLiteral("Reproduction of the published tables"), 17.0);
        m_pages.rule();
        m_pages.skip(2.5);
        m_pages.line(QStringLiteral("Papers"), 34.0,
                     QStringLiteral("Applied Sciences 2023, 13, 3082 (MPR-NR)"));
        m_pages.line(
            QString(), 34.0,
            QStringLiteral("Front. Mech. Eng. 2025, 20(1):7 (finite-step integration): Figures 13 to 16"));
        m_pages.line(QStringLiteral("Platform"), 34.0,
                     QStringLiteral("the laboratory platform, Table 1 of the first paper"));
        m_pages.skip(kBetween);
        m_pages.heading(QStringLiteral("What was checked"), kHeadingPoints);
        for (const Exhibit& exhibit : m_exhibits)
            if (!exhibit.checks.empty())
                paintParagraph(exhibit.title + ". " + checksText(exhibit));
        std::vector<std::string> failed;
        for (const Exhibit& exhibit : m_exhibits)
            for (const Check& check : exhibit.checks)
                if (!check.holds())
                    failed.push_back(exhibit.name + ": " + check.text() + ".");
        if (!failed.empty())
            m_pages.heading(QStringLiteral("What does not hold"), kHeadingPoints);
        for (const std::string& line : failed)
            paintParagraph(line);
        m_pages.skip(kBetween);
        m_pages.heading(QStringLiteral("How to read the paper's numbers"), kHeadingPoints);
        for (const char* paragraph : kFirstPage)
            paintParagraph(paragraph);
        m_pages.skip(kBetween / 2.0);
        for (const Exhibit& exhibit : m_exhibits)
            paintTimes(exhibit);
    }

    void paintExhibit(const Exhibit& exhibit) {
        m_pages.heading(text(exhibit.title), kHeadingPoints);
        paintParagraph(exhibit.what);
        m_pages.skip(kBetween / 2.0);
        for (const Block& block : exhibit.blocks)
            paintTable(block);
        for (const std::string& note : exhibit.notes)
            if (!isOnFirstPage(note))
                paintParagraph(note);
        if (!exhibit.checks.empty())
            paintParagraph(checksText(exhibit));
        if (const std::optional<Block> checks = checksBlock(exhibit))
            paintTable(*checks);
        paintFigure(exhibit.picture);
    }

    void paintTimes(const Exhibit& exhibit) {
        for (Block block : exhibit.times) {
            block.header.front() = exhibit.title.substr(0, exhibit.title.find(':')) + ", seconds";
            paintTable(block);
        }
    }

    void makeRoom(double height) {
        if (m_pages.remaining() < height)
            m_pages.newPage();
    }

    void paintParagraph(const std::string& paragraph) {
        makeRoom(m_pages.paragraphHeight(text(paragraph)));
        m_pages.paragraph(text(paragraph));
    }

    void paintTable(const Block& block) {
        const PdfPages::Table table = tableOf(block, m_pages.width());
        makeRoom(PdfPages::tableHeight(table));
        m_pages.table(table);
        m_pages.skip(kBetween);
    }

    void paintFigure(const Picture& picture) {
        const QSizeF size = picture.size();
        const double height = m_pages.width() * size.height() / size.width();
        makeRoom(std::min(kLeastPart * height, PdfPages::pageHeight()));
        paintPicture(m_pages.painter(), m_pages.take(std::min(height, m_pages.remaining())), picture);
        m_pages.skip(kBetween);
    }

    std::span<const Exhibit> m_exhibits;
    PdfPages m_pages;
};

QByteArray paintTwice(std::span<const Exhibit> exhibits, const PdfTitles& titles, bool withFirstPage) {
    int pages = 0;
    for (;;) { // once to count the pages, once to number them
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        int painted = 0;
        {
            Document document(buffer, exhibits, titles, pages);
            painted = document.paint(withFirstPage);
        }
        if (painted == pages)
            return buffer.data();
        pages = painted;
    }
}

} // namespace

QByteArray reproductionPdf(std::span<const Exhibit> exhibits) {
    return paintTwice(
        exhibits,
        {QStringLiteral("Reproduction of the published tables"),
         QStringLiteral(
             "Reproduction of Applied Sciences 2023, 13, 3082, and Front. Mech. Eng. 2025, 20(1):7")},
        true);
}

QByteArray exhibitsPdf(std::span<const Exhibit> exhibits, const PdfTitles& titles) {
    return paintTwice(exhibits, titles, false);
}

} // namespace hexapose::reproduce
