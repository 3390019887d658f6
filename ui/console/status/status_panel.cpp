// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/status/status_panel.h"

#include "core/base/units.h"
#include "ui/common/card.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include <cmath>

namespace hexapose {

namespace {

QString residualText(double metres) {
    const double mm = mmFromMetres(metres);
    return std::isfinite(mm) ? QString::asprintf("%.1e", mm) : ReadOut::dash();
}

} // namespace

StatusPanel::StatusPanel(QWidget* parent) : QWidget(parent), m_lamp(makeLamp(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 2, 10, 2);
    row->setSpacing(5);
    row->addWidget(m_lamp);
    m_state = makeItem({}, 14);
    m_rate = makeItem(QStringLiteral("Hz"), 5);
    m_age = makeItem(QStringLiteral("ms"), 6);
    m_solver = makeItem({}, 9);
    m_iterations = makeItem({}, 4); // steps of FSI
    m_residual = makeItem(QStringLiteral("mm"), 7);
    m_dropped = makeItem({}, 5);
    m_platform = makeItem({}, 18);
    row->addStretch(1);
    for (ReadOut* text : {m_state.value, m_solver.value, m_platform.value}) {
        text->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    }
    showSnapshot({});
    retranslate();
}

StatusPanel::Item StatusPanel::makeItem(const QString& unit, int digits) {
    auto* row = qobject_cast<QHBoxLayout*>(layout());
    const Item item{makeMutedLabel(this), new ReadOut(this), unit.isEmpty() ? nullptr : makeMutedLabel(this)};
    item.value->setDigits(digits);
    item.value->setMaximumWidth(item.value->minimumWidth());
    row->addWidget(item.label);
    row->addWidget(item.value);
    if (item.unit != nullptr) {
        item.unit->setText(unit);
        row->addWidget(item.unit);
    }
    row->addSpacing(8);
    return item;
}

void StatusPanel::setPlatform(const QString& name) {
    m_platform.value->setMaximumWidth(QWIDGETSIZE_MAX);
    m_platform.value->showText(name);
    m_platform.value->setToolTip(name);
}

void StatusPanel::setSolver(std::string_view word) {
    m_solver.value->showText(solverTitle(word));
}

void StatusPanel::showSnapshot(const Snapshot& snapshot) {
    m_snapshot = snapshot;
    m_state.value->showText(stateText(snapshot));
    setTone(*m_lamp, stateTone(snapshot));
    const bool measured = snapshot.measuredLengths.has_value();
    const auto known = [&](double value) { return measured ? std::optional(value) : std::nullopt; };
    m_rate.value->showNumber(snapshot.feedbackRate, 1);
    m_age.value->showNumber(known(std::chrono::duration<double, std::milli>(snapshot.age).count()), 0);
    m_age.value->setStale(snapshot.stale);
    const bool solved = measured && snapshot.status != SolveStatus::InvalidInput;
    m_iterations.value->showNumber(solved ? std::optional<double>(snapshot.iterations) : std::nullopt, 0);
    m_residual.value->showText(solved ? residualText(snapshot.residual) : ReadOut::dash());
    const bool usable = snapshot.measuredPose.has_value();
    setTone(*m_residual.value, measured && !usable ? Tone::Bad : Tone::Idle);
    m_residual.value->setToolTip(measured ? solveStatusText(snapshot.status) : QString());
    m_iterations.value->setStale(snapshot.stale);
    m_residual.value->setStale(snapshot.stale);
    const auto dropped = snapshot.counters.dropped();
    m_dropped.value->showText(QString::number(dropped));
    setTone(*m_dropped.value, dropped > 0 ? Tone::Warn : Tone::Idle);
}

void StatusPanel::retranslate() {
    const auto name = [](const Item& item, const QString& text) {
        setCaption(*item.label, text);
        item.value->setAccessibleName(text);
    };
    name(m_state, tr("State"));
    name(m_rate, tr("Rate"));
    name(m_age, tr("Age"));
    name(m_solver, tr("Solver"));
    name(m_iterations, tr("Iterations"));
    name(m_residual, tr("Residual"));
    name(m_dropped, tr("Dropped frames"));
    name(m_platform, tr("Platform"));
    showSnapshot(Snapshot(m_snapshot));
}

void StatusPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_status_panel.cpp"
