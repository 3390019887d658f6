// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/event_list.h"

#include "core/record/event_codec.h"
#include "ui/console/events/event_delegate.h"

#include <QDateTime>
#include <QEvent>
#include <QListWidget>
#include <QVBoxLayout>

namespace hexapose {

namespace {

constexpr std::size_t kMost = 500;

QString timeText(EventList::Time time) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(ms).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

} // namespace

EventList::EventList(QWidget* parent) : Card(parent), m_list(new QListWidget(this)) {
    m_list->setItemDelegate(new EventDelegate(m_list));
    m_list->setResizeMode(QListView::Adjust);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setSelectionMode(QAbstractItemView::NoSelection);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->viewport()->setAutoFillBackground(false);
    m_list->setMinimumHeight(80);
    body()->addWidget(m_list, 1);
    retranslate();
}

void EventList::add(const Event& event, Time time) {
    put({[event] { return eventText(event); }, time, 1, formatEvent(event)});
}

void EventList::addNote(const Text& text, Time time) {
    put({text, time, 1, {}});
}

void EventList::put(Entry entry) {
    if (!m_entries.empty() && !entry.key.empty() && m_entries.front().key == entry.key) {
        entry.times = m_entries.front().times + 1;
        m_entries.front() = entry;
        write(*m_list->item(0), m_entries.front());
        return;
    }
    m_entries.push_front(std::move(entry));
    auto* item = new QListWidgetItem;
    write(*item, m_entries.front());
    m_list->insertItem(0, item);
    if (m_entries.size() > kMost) {
        m_entries.pop_back();
        delete m_list->takeItem(m_list->count() - 1);
    }
}

void EventList::write(QListWidgetItem& item, const Entry& entry) {
    const EventText text = entry.text();
    QString head = timeText(entry.time);
    if (entry.times > 1) {
        head += QString::fromUtf8("  \u00d7%1").arg(entry.times);
    }
    item.setData(EventDelegate::TimeRole, head);
    item.setData(EventDelegate::CauseRole, text.cause);
    item.setData(EventDelegate::AdviceRole, text.advice);
    item.setData(EventDelegate::ToneRole, static_cast<int>(text.tone));
    const QString whole = text.advice.isEmpty() ? text.cause : text.cause + QLatin1Char('\n') + text.advice;
    item.setData(Qt::AccessibleTextRole, QString(head + QLatin1Char(' ') + whole));
    item.setToolTip(whole);
}

int EventList::count() const {
    return m_list->count();
}

QString EventList::textAt(int row) const {
    const QListWidgetItem* item = m_list->item(row);
    return item == nullptr ? QString() : item->data(Qt::AccessibleTextRole).toString();
}

void EventList::retranslate() {
    setTitle(tr("Events"));
    m_list->setAccessibleName(tr("Events"));
    for (int i = 0; i < m_list->count(); ++i) {
        write(*m_list->item(i), m_entries[static_cast<std::size_t>(i)]);
    }
}

void EventList::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    Card::changeEvent(event);
}

} // namespace hexapose

#include "moc_event_list.cpp"
