// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>

class QVBoxLayout;

namespace hexapose {

/// A titled surface that a panel sits on.
class Card : public QFrame {
    Q_OBJECT
public:
    explicit Card(QWidget* parent = nullptr);
    void setTitle(const QString& title);

protected:
    QVBoxLayout* body() const { return m_body; }

private:
    QLabel* m_title;
    QVBoxLayout* m_body;
};

/// The visible name beside a control or read-out. To a screen reader it is "State:", so that "State" is the
/// read-out alone.
void setCaption(QLabel& label, const QString& text);

/// A small round light; its tone is its colour.
QLabel* makeLamp(QWidget* parent);
/// Names what stands beside or below it, for the eye alone: the thing itself carries the name for a screen
/// reader, and a second object of the same name would only be in the way there.
QLabel* makeCaption(QWidget* parent);
/// A label in the quiet colour.
QLabel* makeMutedLabel(QWidget* parent, Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter);

} // namespace hexapose
