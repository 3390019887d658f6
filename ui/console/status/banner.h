// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/record/snapshot.h"
#include "ui/common/theme.h"

#include <QFrame>

class QLabel;
class QProgressBar;
class QPushButton;

namespace hexapose {

class ReadOut;

/// One line across the window for what must not be missed: a lost link, old data, an unprotected sender, a
/// log that cannot be written, or the training of the model. Never a box in the way.
class Banner final : public QFrame {
    Q_OBJECT
public:
    explicit Banner(QWidget* parent = nullptr);
    /// open: a connection is wanted.
    void showSnapshot(const Snapshot& snapshot, bool open);
    void showClosed();
    void showLogFailure(const std::optional<LogFailure>& failure);
    void showTraining(double part);           ///< 0..1
    void endTraining(const QString& failure); ///< empty: done

signals:
    void cancelRequested(); ///< of the training

protected:
    void changeEvent(QEvent* event) override;

private:
    QString lossText() const;
    void refresh();

    Snapshot m_snapshot;
    bool m_open = false;
    bool m_training = false;
    QString m_trainingFailure;
    std::optional<LogFailure> m_logFailure;
    std::optional<Event> m_lossCause; ///< of the connection: the latest that was reported
    QLabel* m_lamp;
    ReadOut* m_text;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
};

} // namespace hexapose
