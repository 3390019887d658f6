// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/named_poses.h"

#include "ui/common/labelled.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <initializer_list>

namespace hexapose {

namespace {
constexpr int kLongestName = 60;
}

NamedPoses::NamedPoses(QWidget* parent)
    : QWidget(parent), m_box(new QComboBox(this)), m_keep(new QPushButton(this)),
      m_remove(new QPushButton(this)) {
    m_box->setEditable(true);
    m_box->setInsertPolicy(QComboBox::NoInsert);
    m_box->setCompleter(nullptr); // a name is kept as it is typed
    // A box takes typed text that is among its items for a choice when the focus leaves it or Return is
    // pressed. As the focus moves to Run or Save pose, the fields would get another pose: only the list and
    // the arrows choose.
    for (const auto signal : {&QLineEdit::editingFinished, &QLineEdit::returnPressed}) {
        disconnect(m_box->lineEdit(), signal, m_box, nullptr);
    }
    m_box->lineEdit()->setMaxLength(kLongestName);
    m_box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(m_box, 1);
    row->addWidget(m_keep);
    row->addWidget(m_remove);
    connect(m_box, &QComboBox::activated, this, [this](int index) {
        if (index >= 0 && index < static_cast<int>(m_poses.size())) {
            emit chosen(m_poses[static_cast<std::size_t>(index)].pose);
        }
    });
    connect(m_box, &QComboBox::editTextChanged, this, &NamedPoses::updateButtons);
    connect(m_keep, &QPushButton::clicked, this, &NamedPoses::keepRequested);
    connect(m_remove, &QPushButton::clicked, this, &NamedPoses::removeTyped);
    retranslate();
    fill({});
}

QString NamedPoses::typedName() const {
    return m_box->currentText().simplified();
}

std::vector<NamedPose>::iterator NamedPoses::find(const QString& name) {
    return std::find_if(m_poses.begin(), m_poses.end(),
                        [&name](const NamedPose& one) { return one.name == name; });
}

void NamedPoses::setPoses(std::vector<NamedPose> poses) {
    m_poses = std::move(poses);
    std::sort(m_poses.begin(), m_poses.end(),
              [](const NamedPose& a, const NamedPose& b) { return a.name < b.name; });
    fill({});
}

void NamedPoses::keep(const Pose& pose) {
    const QString name = typedName();
    if (name.isEmpty()) {
        return;
    }
    if (const auto same = find(name); same != m_poses.end()) {
        same->pose = pose;
    } else {
        const auto next = std::find_if(m_poses.begin(), m_poses.end(),
                                       [&name](const NamedPose& one) { return name < one.name; });
        m_poses.insert(next, {name, pose});
    }
    fill(name);
    emit changed();
}

void NamedPoses::removeTyped() {
    if (const auto same = find(typedName()); same != m_poses.end()) {
        m_poses.erase(same);
        fill({});
        emit changed();
    }
}

void NamedPoses::setTargetWhole(bool whole) {
    m_targetWhole = whole;
    updateButtons();
}

void NamedPoses::fill(const QString& shown) {
    {
        const QSignalBlocker quiet(m_box);
        m_box->clear();
        for (const NamedPose& one : m_poses) {
            m_box->addItem(one.name);
        }
        m_box->setCurrentIndex(shown.isEmpty() ? -1 : m_box->findText(shown, Qt::MatchFixedString));
        m_box->setEditText(shown);
    }
    updateButtons();
}

void NamedPoses::updateButtons() {
    const QString name = typedName();
    m_keep->setEnabled(m_targetWhole && !name.isEmpty());
    m_remove->setEnabled(find(name) != m_poses.end());
}

void NamedPoses::retranslate() {
    // On Linux a box with text in it gives that text for its name; its editor is where a screen reader finds
    // it.
    for (QWidget* widget : std::initializer_list<QWidget*>{m_box, m_box->lineEdit()}) {
        widget->setAccessibleName(tr("Pose name"));
    }
    m_box->lineEdit()->setPlaceholderText(tr("Named poses"));
    m_box->setToolTip(tr("Choose a pose to load it into the fields, or type a name to save them under"));
    label(*m_keep, tr("Save pose"), tr("Save pose"), tr("Save the fields under this name (no motion)"));
    label(*m_remove, tr("Remove"), tr("Remove pose"), tr("Delete this pose"));
}

void NamedPoses::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_named_poses.cpp"
