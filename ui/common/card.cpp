// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/common/card.h"

#include "ui/common/theme.h"

#include <QVBoxLayout>

namespace hexapose {

Card::Card(QWidget* parent) : QFrame(parent), m_title(makeCaption(this)), m_body(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("card"));
    m_title->setObjectName(QStringLiteral("cardTitle"));
    m_body->setContentsMargins(12, 8, 12, 10);
    m_body->setSpacing(6);
    m_body->addWidget(m_title);
}

void Card::setTitle(const QString& title) {
    setCaption(*m_title, title);
}

void setCaption(QLabel& label, const QString& text) {
    label.setText(text);
    label.setAccessibleName(text + QLatin1Char(':'));
}

QLabel* makeLamp(QWidget* parent) {
    auto* lamp = new QLabel(parent);
    lamp->setObjectName(QStringLiteral("lamp"));
    setTone(*lamp, Tone::Idle);
    return lamp;
}

QLabel* makeCaption(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setAccessibleName(QStringLiteral(" ")); // an empty one would mean the label's text
    return label;
}

QLabel* makeMutedLabel(QWidget* parent, Qt::Alignment alignment) {
    QLabel* label = makeCaption(parent);
    label->setProperty("muted", true);
    label->setAlignment(alignment);
    return label;
}

} // namespace hexapose

#include "moc_card.cpp"
