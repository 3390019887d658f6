// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/way_point_table.h"

#include "core/base/number_text.h"
#include "ui/common/number_field.h"
#include "ui/common/status_text.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace hexapose {

namespace {

constexpr int kCoordinates = 6;
constexpr int kWrittenDecimals = 6;
constexpr int kRowHeight = 24;
constexpr int kLeastColumn = 28;

/// As short as it can be written to a millionth of a mm or degree.
QString shortNumber(double value) {
    std::string text = formatFixed(value, kWrittenDecimals);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
        text.pop_back();
    }
    return text == "-0" ? QStringLiteral("0") : QString::fromStdString(text);
}

/// A cell is edited in the field that all numbers are typed into; its text is carried over as it is.
class CellEditor final : public QStyledItemDelegate {
public:
    CellEditor(std::function<void(NumberField*)> opened, QObject* parent)
        : QStyledItemDelegate(parent), m_opened(std::move(opened)) {}
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                          const QModelIndex& index) const override {
        auto* field = new NumberField(coordinateBounds(index.column()), parent);
        field->setFrame(false);
        field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_opened(field);
        return field;
    }
    /// Wider than most cells: what is typed is to be seen whole.
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& /*index*/) const override {
        const int width = editor->fontMetrics().horizontalAdvance(QStringLiteral("-0000.000000")) + 16;
        QRect place = option.rect;
        place.setLeft(std::max(std::min(place.left(), place.right() - width), 0));
        place.setWidth(std::max(place.width(), width));
        editor->setGeometry(place);
    }

private:
    std::function<void(NumberField*)> m_opened;
};

} // namespace

WayPointTable::WayPointTable(QWidget* parent) : QTableWidget(0, kCoordinates, parent) {
    setItemDelegate(new CellEditor([this](NumberField* field) { m_editor = field; }, this));
    QStringList heads;
    for (const CoordinateText& text : coordinateTexts()) {
        heads << text.symbol;
    }
    setHorizontalHeaderLabels(heads);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(20);
    horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setDefaultSectionSize(kRowHeight);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setTabKeyNavigation(false); // Tab leaves the table
    setShowGrid(false);
    connect(this, &QTableWidget::cellChanged, this, [this](int row, int /*column*/) {
        paintRow(row);
        emit edited();
    });
    connect(this, &WayPointTable::edited, this, &WayPointTable::fitColumns);
}

/// Each as wide as what it holds; what is left over is shared out.
void WayPointTable::fitColumns() {
    std::array<int, kCoordinates> widths{};
    int left = viewport()->width();
    for (int i = 0; i < kCoordinates; ++i) {
        widths[static_cast<std::size_t>(i)] = std::max(sizeHintForColumn(i), kLeastColumn);
        left -= widths[static_cast<std::size_t>(i)];
    }
    for (int i = 0; i < kCoordinates; ++i) {
        setColumnWidth(i, widths[static_cast<std::size_t>(i)] + std::max(left, 0) / kCoordinates);
    }
}

void WayPointTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitColumns();
}

void WayPointTable::setPoses(const std::vector<Pose>& poses) {
    {
        const QSignalBlocker quiet(this);
        m_marked = -1;
        setRowCount(0);
        for (const Pose& pose : poses) {
            insertRow(rowCount());
            writeRow(rowCount() - 1, pose);
        }
    }
    emit edited();
}

void WayPointTable::append(const Pose& pose) {
    {
        const QSignalBlocker quiet(this);
        insertRow(rowCount());
        writeRow(rowCount() - 1, pose);
    }
    setCurrentCell(rowCount() - 1, 0);
    emit edited();
}

void WayPointTable::writeRow(int row, const Pose& pose) {
    const PoseVector si = pose.toVector();
    for (int i = 0; i < kCoordinates; ++i) {
        auto* item = new QTableWidgetItem(shortNumber(toDisplay(i, si[i])));
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        setItem(row, i, item);
    }
    paintRow(row);
}

QString WayPointTable::textAt(int row, int column) const {
    const QTableWidgetItem* cell = item(row, column);
    return cell != nullptr ? cell->text() : QString();
}

std::optional<WayPointTable::Refusal> WayPointTable::refusal() const {
    for (int row = 0; row < rowCount(); ++row) {
        for (int i = 0; i < kCoordinates; ++i) {
            if (const NumberReading read = readNumber(textAt(row, i), coordinateBounds(i)); !read.value) {
                return Refusal{row, i, read.refusal};
            }
        }
    }
    return std::nullopt;
}

void WayPointTable::finishEditing() {
    if (m_editor) {
        NumberField* editor = std::exchange(m_editor, nullptr);
        commitData(editor);
        closeEditor(editor, QAbstractItemDelegate::NoHint);
    }
}

std::optional<Pose> WayPointTable::poseAt(int row) const {
    PoseVector si;
    for (int i = 0; i < kCoordinates; ++i) {
        const auto number = readNumber(textAt(row, i), coordinateBounds(i)).value;
        if (!number) {
            return std::nullopt;
        }
        si[i] = fromDisplay(i, *number);
    }
    return Pose::fromVector(si);
}

void WayPointTable::removeCurrent() {
    if (currentRow() >= 0) {
        removeRow(currentRow());
        numberRows();
        emit edited();
    }
}

void WayPointTable::moveCurrent(int by) {
    const int from = currentRow();
    const int to = from + by;
    if (from < 0 || to < 0 || to >= rowCount()) {
        return;
    }
    {
        const QSignalBlocker quiet(this);
        for (int i = 0; i < kCoordinates; ++i) {
            QTableWidgetItem* one = takeItem(from, i);
            QTableWidgetItem* other = takeItem(to, i);
            setItem(to, i, one);
            setItem(from, i, other);
        }
        paintRow(from);
        paintRow(to);
    }
    setCurrentCell(to, std::max(currentColumn(), 0));
    emit edited();
}

void WayPointTable::mark(int row) {
    if (row == m_marked) {
        return;
    }
    const int before = m_marked;
    m_marked = row;
    paintRow(before);
    paintRow(row);
    if (row >= 0 && row < rowCount()) {
        clearSelection();
        scrollToItem(item(row, 0));
    }
}

void WayPointTable::paintRow(int row) {
    if (row < 0 || row >= rowCount()) {
        return;
    }
    const QSignalBlocker quiet(this);
    QColor ground = palette().color(QPalette::Highlight);
    ground.setAlphaF(0.28F);
    for (int i = 0; i < kCoordinates; ++i) {
        QTableWidgetItem* cell = item(row, i);
        if (cell == nullptr) {
            continue;
        }
        const QString refusal = readNumber(cell->text(), coordinateBounds(i)).refusal;
        QFont font = this->font();
        font.setBold(row == m_marked);
        font.setStrikeOut(!refusal.isEmpty());
        cell->setFont(font);
        cell->setBackground(row == m_marked ? QBrush(ground) : QBrush());
        cell->setToolTip(refusal.isEmpty() ? cell->text() : cell->text() + QStringLiteral(": ") + refusal);
        cell->setData(Qt::AccessibleDescriptionRole, refusal);
    }
    auto* head = new QTableWidgetItem((row == m_marked ? QString::fromUtf8("\u25b6 ") : QString()) +
                                      QString::number(row + 1));
    setVerticalHeaderItem(row, head);
    viewport()->update();
}

/// A head goes with its row, and would keep the number that the row had.
void WayPointTable::numberRows() {
    for (int row = 0; row < rowCount(); ++row) {
        paintRow(row);
    }
}

void WayPointTable::setEditable(bool editable) {
    setEditTriggers(editable ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                                   QAbstractItemView::AnyKeyPressed
                             : QAbstractItemView::NoEditTriggers);
}

void WayPointTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        paintRow(m_marked);
    }
}

} // namespace hexapose

#include "moc_way_point_table.cpp"
