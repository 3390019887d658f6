// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/cursor_table.h"

#include "core/base/number_text.h"
#include "ui/common/card.h"
#include "ui/common/read_out.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace hexapose {

namespace {

constexpr int kDelayMs = 40; ///< of the statistics, while cursors and view are on the move
constexpr int kDigits = 8;
constexpr int kDifferenceDigits = 10;
constexpr int kMostDigits = 15;
constexpr int kReadOutDigits = 10; ///< at least

QString rounded(double value, int digits = kDigits) {
    return std::isfinite(value) ? QString::number(value, 'g', digits) : ReadOut::dash();
}

/// As the file has it; what was worked out from columns ends in digits that are none.
QString exact(double value, const CurveSpec& curve) {
    if (!curve.minus.isEmpty())
        return rounded(value, kDifferenceDigits);
    return std::isfinite(value) ? QString::fromStdString(formatNumber(value)) : ReadOut::dash();
}

/// With as many digits as its scatter makes sense of.
QString meanText(const Statistics& statistics) {
    int digits = kDigits;
    if (statistics.sigma > 0.0 && std::isfinite(statistics.mean) && statistics.mean != 0.0)
        digits += std::max(0, static_cast<int>(std::log10(std::abs(statistics.mean) / statistics.sigma)));
    return rounded(statistics.mean, std::min(digits, kMostDigits));
}

/// Each once, in the order of the charts.
std::vector<CurveSpec> shownCurves(ChartSheet& sheet, std::vector<std::size_t>& places) {
    std::vector<CurveSpec> curves;
    for (const ChartSpec& chart : sheet.chartLayout().charts) {
        std::size_t place = 0;
        for (const CurveSpec& curve : chart.curves) {
            if (!sheet.curve(curve))
                continue;
            if (std::find(curves.begin(), curves.end(), curve) == curves.end()) {
                curves.push_back(curve);
                places.push_back(place);
            }
            ++place;
        }
    }
    return curves;
}

} // namespace

CursorTable::CursorTable(QWidget* parent)
    : QScrollArea(parent), m_job(new NumbersJob(this)), m_content(new QFrame(this)),
      m_grid(new QGridLayout(m_content)), m_curve(makeMutedLabel(m_content)) {
    m_digits.fill(kReadOutDigits);
    setWidget(m_content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    m_content->setObjectName(QStringLiteral("card"));
    m_grid->setContentsMargins(8, 4, 8, 4);
    m_grid->setHorizontalSpacing(2);
    m_grid->setVerticalSpacing(1);
    m_grid->addWidget(m_curve, 0, 0);
    for (int i = 0; i < kNumbers; ++i) {
        m_heads[static_cast<std::size_t>(i)] = makeMutedLabel(m_content, Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(m_heads[static_cast<std::size_t>(i)], 0, i + 1);
        m_grid->setColumnStretch(i + 1, 1);
    }
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMs);
    connect(&m_delay, &QTimer::timeout, this, [this] {
        std::vector<Curve> curves;
        for (const Line& line : m_lines)
            if (auto curve = m_sheet != nullptr ? m_sheet->curve(line.spec) : std::nullopt)
                curves.push_back(std::move(*curve));
        if (m_sheet != nullptr && !curves.empty())
            m_job->ask(m_sheet->table(), curves, measuredSpan(m_sheet->cursors(), m_sheet->time()));
    });
    connect(m_job, &NumbersJob::ready, this, &CursorTable::showStatistics);
    retranslate();
}

void CursorTable::follow(ChartSheet* sheet) {
    if (m_sheet != nullptr)
        disconnect(m_sheet, nullptr, this, nullptr);
    m_sheet = sheet;
    if (m_sheet != nullptr) {
        connect(m_sheet, &ChartSheet::viewChanged, this, &CursorTable::refresh);
        connect(m_sheet, &ChartSheet::cursorsChanged, this, &CursorTable::refresh);
        connect(m_sheet, &ChartSheet::layoutChanged, this, &CursorTable::refresh);
        connect(m_sheet, &QObject::destroyed, this, [this] { m_sheet = nullptr; });
    }
    refresh();
}

void CursorTable::setColors(ThemeKind theme) {
    m_theme = theme;
    makeLines({}); // so that they are made anew
    refresh();
}

void CursorTable::makeLines(const std::vector<CurveSpec>& curves) {
    for (const Line& line : m_lines) {
        delete line.name;
        for (ReadOut* number : line.numbers)
            delete number;
    }
    m_lines.clear();
    for (std::size_t i = 0; i < curves.size(); ++i) {
        Line line{curves[i], makeCaption(m_content), {}};
        setCaption(*line.name, curves[i].name());
        line.name->setTextFormat(Qt::RichText);
        line.name->setText(QStringLiteral("<span style='color:%1'>\u25a0</span> %2")
                               .arg(m_colours[i].name(), curves[i].name().toHtmlEscaped()));
        const int row = static_cast<int>(i) + 1;
        m_grid->addWidget(line.name, row, 0);
        for (int n = 0; n < kNumbers; ++n) {
            auto* readOut = new ReadOut(m_content);
            readOut->setDigits(m_digits[static_cast<std::size_t>(n)]);
            line.numbers[static_cast<std::size_t>(n)] = readOut;
            m_grid->addWidget(readOut, row, n + 1);
        }
        m_lines.push_back(line);
    }
    const int lastRow = static_cast<int>(curves.size()) + 1;
    for (int row = 0; row < m_grid->rowCount(); ++row)
        m_grid->setRowStretch(row, 0);
    m_grid->setRowStretch(lastRow, 1); // the rest of the room
    retranslate();
}

void CursorTable::refresh() {
    std::vector<CurveSpec> curves;
    std::vector<std::size_t> places;
    if (m_sheet != nullptr)
        curves = shownCurves(*m_sheet, places);
    const bool isSame = std::equal(m_lines.begin(), m_lines.end(), curves.begin(), curves.end(),
                                   [](const Line& line, const CurveSpec& spec) { return line.spec == spec; });
    if (!isSame) {
        m_colours.clear();
        for (const std::size_t place : places)
            m_colours.push_back(curveColour(place, m_theme));
        makeLines(curves);
    }
    if (m_sheet == nullptr)
        return;
    const Cursors& cursors = m_sheet->cursors();
    for (const Line& line : m_lines) {
        const auto curve = m_sheet->curve(line.spec);
        const auto at = [&](const std::optional<double>& time) {
            return curve && time ? valueAt(*m_sheet->table(), *curve->column, *time) : std::nullopt;
        };
        const auto a = at(cursors.a), b = at(cursors.b);
        line.numbers[0]->showText(a ? exact(*a, line.spec) : ReadOut::dash());
        line.numbers[1]->showText(b ? exact(*b, line.spec) : ReadOut::dash());
        line.numbers[2]->showText(a && b ? rounded(*b - *a) : ReadOut::dash());
    }
    widen();
    if (!m_delay.isActive()) // not put off for ever by a steady movement
        m_delay.start();
}

void CursorTable::showStatistics(const std::vector<Statistics>& statistics,
                                 const std::vector<Curve>& curves) {
    const bool isSame =
        std::equal(m_lines.begin(), m_lines.end(), curves.begin(), curves.end(),
                   [](const Line& line, const Curve& curve) { return line.spec == curve.spec; });
    for (std::size_t i = 0; isSame && i < m_lines.size(); ++i) {
        const Statistics& of = statistics[i];
        const auto& numbers = m_lines[i].numbers;
        numbers[3]->showText(meanText(of));
        numbers[4]->showText(rounded(of.sigma));
        numbers[5]->showText(rounded(of.rms));
        numbers[6]->showText(exact(of.min, m_lines[i].spec));
        numbers[7]->showText(exact(of.max, m_lines[i].spec));
        numbers[8]->showText(QString::number(of.count));
    }
    widen();
}

/// No number is cut: the longest one of a column has room.
void CursorTable::widen() {
    for (std::size_t i = 0; i < m_digits.size(); ++i) {
        int digits = m_digits[i];
        for (const Line& line : m_lines)
            digits = std::max(digits, static_cast<int>(line.numbers[i]->text().size()));
        if (digits == m_digits[i])
            continue;
        m_digits[i] = digits;
        for (const Line& line : m_lines)
            line.numbers[i]->setDigits(digits);
    }
}

void CursorTable::retranslate() {
    const std::array<QString, kNumbers> heads{tr("A"),       tr("B"),       tr("Difference"),
                                              tr("Mean"),    tr("Sigma"),   tr("RMS"),
                                              tr("Minimum"), tr("Maximum"), tr("Count")};
    setAccessibleName(tr("Cursor table"));
    setCaption(*m_curve, tr("Curve"));
    for (std::size_t i = 0; i < heads.size(); ++i) {
        setCaption(*m_heads[i], heads[i]);
        for (const Line& line : m_lines)
            line.numbers[i]->setAccessibleName(heads[i] + QLatin1Char(' ') + line.spec.name());
    }
}

void CursorTable::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QScrollArea::changeEvent(event);
}

} // namespace hexapose

#include "moc_cursor_table.cpp"
