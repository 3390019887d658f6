// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/event_delegate.h"

#include "ui/common/theme.h"

#include <QListView>
#include <QPainter>

namespace hexapose {

namespace {

constexpr int kIndent = 16;
constexpr int kGap = 8; // between two events
constexpr double kDot = 7.0;

QFont smallFont(const QFont& font) {
    QFont smaller = font;
    smaller.setPointSizeF(font.pointSizeF() * 0.9);
    return smaller;
}

int heightOf(const QFont& font, const QString& text, int width) {
    return text.isEmpty()
               ? 0
               : QFontMetrics(font).boundingRect(QRect(0, 0, width, 10000), Qt::TextWordWrap, text).height();
}

/// The dark or light theme is known by its ground; the delegate draws where no style sheet reaches.
QColor toneColor(const QPalette& palette, Tone tone) {
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    const ThemeColors colors = themeColors(dark ? ThemeKind::Dark : ThemeKind::Light);
    switch (tone) {
    case Tone::Good:
        return colors.good;
    case Tone::Warn:
        return colors.warn;
    case Tone::Bad:
        return colors.bad;
    case Tone::Idle:
        break;
    }
    return colors.idle;
}

} // namespace

void EventDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QFont small = smallFont(option.font);
    const int timeHeight = QFontMetrics(small).height();
    painter->setPen(Qt::NoPen);
    painter->setBrush(toneColor(option.palette, static_cast<Tone>(index.data(ToneRole).toInt())));
    painter->drawEllipse(
        QRectF(option.rect.left() + 2.0, option.rect.top() + (timeHeight - kDot) / 2.0, kDot, kDot));

    QRect box = option.rect.adjusted(kIndent, 0, -2, 0);
    const QColor quiet = option.palette.color(QPalette::PlaceholderText);
    painter->setFont(small);
    painter->setPen(quiet);
    painter->drawText(box, Qt::AlignLeft | Qt::AlignTop, index.data(TimeRole).toString());
    box.setTop(box.top() + timeHeight + 1);
    const QString cause = index.data(CauseRole).toString();
    painter->setFont(option.font);
    painter->setPen(option.palette.color(QPalette::WindowText));
    painter->drawText(box, Qt::TextWordWrap, cause);
    box.setTop(box.top() + heightOf(option.font, cause, box.width()));
    painter->setFont(small);
    painter->setPen(quiet);
    painter->drawText(box, Qt::TextWordWrap, index.data(AdviceRole).toString());
    painter->restore();
}

QSize EventDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QListView*>(option.widget);
    const int width = (view != nullptr ? view->viewport()->width() : option.rect.width()) - kIndent - 2;
    const QFont small = smallFont(option.font);
    const int height = QFontMetrics(small).height() + 1 +
                       heightOf(option.font, index.data(CauseRole).toString(), width) +
                       heightOf(small, index.data(AdviceRole).toString(), width);
    return {width, height + kGap};
}

} // namespace hexapose

#include "moc_event_delegate.cpp"
