// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/report/report_panel.h"

#include "core/base/input_error.h"
#include "core/record/pose_list.h"
#include "ui/common/file_dialog.h"
#include "ui/common/read_out.h"
#include "ui/common/status_text.h"
#include "ui/console/events/input_fault_text.h"
#include "ui/console/events/sequence_end_text.h"
#include "ui/console/report/report_preview.h"
#include "ui/console/report/report_writer.h"
#include "ui/console/report/sample_table.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

namespace hexapose {

namespace {

// The list of Figure 8: 10 poses ("attitudes" there) within +-10 mm and +-10 degrees.
constexpr int kPoses = 10;
constexpr std::uint64_t kSeed = 1;

} // namespace

ReportPanel::ReportPanel(SharedModel model, QWidget* parent)
    : QWidget(parent), m_model(std::move(model)), m_writer(new ReportWriter(this)) {
    connect(m_writer, &ReportWriter::written, this, &ReportPanel::showWritten);
    connect(m_writer, &ReportWriter::failed, this, &ReportPanel::showWriteFailure);
    build();
    retranslate();
    setConnected(false);
}

void ReportPanel::setSolver(std::shared_ptr<const ForwardSolver> solver) {
    m_solver = std::move(solver);
    rebuildReport();
}

void ReportPanel::setConnected(bool connected) {
    m_connected = connected;
    updateRun();
    if (!connected && m_sequence) {
        end(tr("the connection was closed"));
    }
}

void ReportPanel::showSnapshot(const Snapshot& snapshot) {
    m_hindrance = runInhibit(snapshot);
    updateRun();
}

void ReportPanel::updateRun() {
    m_run->setEnabled(m_connected && m_hindrance.isEmpty() && !isRunning());
    const QString tip = tr("Move to each pose in turn and measure it; the platform moves");
    m_run->setToolTip(m_hindrance.isEmpty() ? tip : m_hindrance);
    m_run->setAccessibleDescription(m_run->toolTip());
}

void ReportPanel::setDefaultFolder(const QString& folder) {
    m_defaultFolder = folder;
    if (!m_folderChosen) {
        m_folder->setText(folder);
    }
}

QString ReportPanel::folder() const {
    return m_folder->text().trimmed();
}

void ReportPanel::setFolder(const QString& folder) {
    m_folder->setText(folder);
    m_folderChosen = true;
}

bool ReportPanel::isRunning() const {
    return m_sequence && m_sequence->phase() != PoseSequence::Phase::Done &&
           m_sequence->phase() != PoseSequence::Phase::Failed;
}

QString ReportPanel::progressText() const {
    return m_progress->toPlainText();
}

void ReportPanel::add(const Snapshot& snapshot) {
    const bool accepted = m_sequence && m_sequence->accepted() > 0;
    const auto next = m_sequence ? m_sequence->add(snapshot) : std::nullopt;
    if (!accepted && m_sequence && m_sequence->accepted() > 0) {
        clearSamples();
    }
    if (const auto sample = m_sampler.add(snapshot)) {
        takeSample(*sample);
    }
    if (m_sequence) {
        advance(next);
    }
}

void ReportPanel::takeSample(const SettledSample& sample) {
    m_samples.push_back(sample);
    rebuildReport();
    const int number = sampleCount();
    emit noted([number] { return eventText({EventCode::ReportSample, static_cast<double>(number)}); });
    if (m_exportPending) {
        m_exportPending = false;
        write();
    }
}

void ReportPanel::advance(const std::optional<Pose>& next) {
    if (next) {
        emit runRequested(*next, m_sequence->id());
    }
    showProgress();
    if (!isRunning()) {
        const bool complete = m_sequence->phase() == PoseSequence::Phase::Done;
        m_sequence.reset();
        updateRun();
        emit finished(complete);
    }
}

void ReportPanel::runReport() {
    try {
        runList(m_listFile.isEmpty() ? defaultPoses(m_model->geometry(), kPoses, kSeed)
                                     : readPoseList(m_listFile.toStdString()));
    } catch (const InputError& error) {
        m_progress->showText(inputFaultText(error));
        emit noted([error] {
            return EventText{tr("The list of poses cannot be used: %1").arg(inputFaultText(error)),
                             tr("Correct the file, or choose another."), Tone::Warn};
        });
    }
}

void ReportPanel::runList(std::vector<Pose> poses) {
    const MotionId first = m_ids.take(poses.size());
    m_sequence.emplace(std::move(poses), kSampleDwell, first);
    updateRun();
    showProgress();
}

void ReportPanel::stopped() {
    if (isRunning()) {
        end(tr("Stop was pressed"));
    }
}

void ReportPanel::end(const QString& why) {
    m_sequence.reset();
    updateRun();
    m_progress->showText(tr("Ended early: %1").arg(why));
    emit finished(false);
}

void ReportPanel::clearSamples() {
    m_samples.clear();
    m_sampler = SettledSampler();
    m_exportPending = false;
    rebuildReport();
}

void ReportPanel::rebuildReport() {
    m_report = m_solver ? makeErrorReport(m_model->geometry(), *m_solver, m_samples) : ErrorReport{};
    m_preview->setReport(m_report);
    fillSampleTable(*m_table, m_report);
    m_clear->setEnabled(!m_samples.empty());
}

void ReportPanel::exportReport() {
    if (m_samples.empty()) {
        // For an export that is asked for now, half of the time at rest is enough.
        SettledSampler ended = m_sampler;
        if (const auto sample = ended.finish()) {
            m_sampler = SettledSampler();
            m_exportPending = true;
            takeSample(*sample);
            return;
        }
        m_exportPending = true;
        emit noted([] {
            return EventText{tr("There is no settled pose to report yet"),
                             tr("Press Run or Run report; the files are written once the first has settled."),
                             Tone::Idle};
        });
        return;
    }
    write();
}

void ReportPanel::write() {
    const QString where = folder(); // a relative one is where the program was started: say where that is
    m_writer->write(m_report, where.isEmpty() ? where : QDir::current().absoluteFilePath(where));
}

void ReportPanel::showWritten(const QStringList& files, const QString& where) {
    m_files = files;
    showFiles(m_files.join(QLatin1Char('\n')));
    emit noted([where] { return EventText{tr("Report written to %1").arg(where), {}, Tone::Good}; });
    emit exported(m_files);
}

void ReportPanel::showWriteFailure(const QString& reason) {
    showFiles(reason);
    emit noted([reason] {
        return EventText{tr("The report cannot be written: %1").arg(reason), tr("Choose another folder."),
                         Tone::Bad};
    });
}

void ReportPanel::showFiles(const QString& text) {
    m_filesText->showText(text);
    m_filesText->show();
    m_filesLabel->show();
}

void ReportPanel::chooseList() {
    askForFile(*this, {tr("List of poses"), tr("Poses (*.csv);;All files (*)")}, [this](const QString& file) {
        m_listFile = file;
        retranslate();
        m_list->setCurrentIndex(1);
    });
}

void ReportPanel::showProgress() {
    if (m_sequence) {
        m_progress->showText(
            tr("%1 of %2 poses done")
                .arg(QString::number(m_sequence->finished()), QString::number(m_sequence->count())));
        if (m_sequence->phase() == PoseSequence::Phase::Failed && m_sequence->failure()) {
            m_progress->showText(tr("Ended early: %1").arg(sequenceEndText(*m_sequence)));
        }
    } else {
        m_progress->showText(tr("Each settled Run becomes a sample too: 1 s of lengths, averaged, solved and "
                                "compared with its target."));
    }
}

void ReportPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
    QWidget::changeEvent(event);
}

} // namespace hexapose

#include "moc_report_panel.cpp"
