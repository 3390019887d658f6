// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/pose.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QPushButton;

namespace hexapose {

struct NamedPose {
    QString name;
    Pose pose;
};

/// Poses kept under names: one chosen is put into the target's fields, one typed is kept. Moves nothing, and
/// opens no dialog that would stand before Stop.
class NamedPoses final : public QWidget {
    Q_OBJECT
public:
    explicit NamedPoses(QWidget* parent = nullptr);

    void setPoses(std::vector<NamedPose> poses);
    const std::vector<NamedPose>& poses() const { return m_poses; }
    /// Keeps a pose under the name that is typed; one of that name is replaced.
    void keep(const Pose& pose);
    /// Whether the fields hold a pose that can be kept.
    void setTargetWhole(bool whole);

signals:
    void chosen(const hexapose::Pose& pose);
    void keepRequested();
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    QString typedName() const;
    std::vector<NamedPose>::iterator find(const QString& name);
    void fill(const QString& shown);
    void removeTyped();
    void updateButtons();
    void retranslate();

    std::vector<NamedPose> m_poses; ///< in the order of their names
    QComboBox* m_box;
    QPushButton* m_keep;
    QPushButton* m_remove;
    bool m_targetWhole = true;
};

} // namespace hexapose
