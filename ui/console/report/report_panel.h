// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/platform_model.h"
#include "core/report/error_report.h"
#include "core/session/pose_sequence.h"
#include "ui/common/motion_ids.h"
#include "ui/console/events/event_text.h"

#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace hexapose {

class ReportPreview;
class ReportWriter;
class TextReadOut;

/// The error report: samples of settled poses, from single Runs or from a list that it runs through; a
/// table, a preview, and the files.
class ReportPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ReportPanel(SharedModel model, QWidget* parent = nullptr);

    void setSolver(std::shared_ptr<const ForwardSolver> solver);
    void setConnected(bool connected);
    /// Where the files go unless the operator says otherwise: beside the log.
    void setDefaultFolder(const QString& folder);
    QString folder() const;
    void setFolder(const QString& folder);

    void add(const Snapshot& snapshot);
    void showSnapshot(const Snapshot& snapshot);
    void clearSamples();
    int sampleCount() const { return static_cast<int>(m_samples.size()); }
    const ErrorReport& report() const { return m_report; }

    /// Runs through poses from the beginning. The samples so far are discarded when the loop accepts the
    /// first: a Run that is refused leaves them.
    void runList(std::vector<Pose> poses);
    bool isRunning() const;
    /// How far the list is, or why it ended early.
    QString progressText() const;
    void stopped(); ///< Stop was pressed

public slots:
    void runReport();
    /// Writes the files, on a thread of its own; with no sample yet, as soon as the first pose has
    /// settled.
    void exportReport();

signals:
    void runRequested(const hexapose::Pose& target, hexapose::MotionId id);
    void exported(const QStringList& files);
    void noted(const std::function<hexapose::EventText()>& text);
    void finished(bool complete);

protected:
    void changeEvent(QEvent* event) override;

private:
    void end(const QString& why);
    void build();
    QWidget* buildTop();
    QWidget* buildFolderRow();
    void chooseList();
    void takeSample(const SettledSample& sample);
    void advance(const std::optional<Pose>& next);
    void rebuildReport();
    void write();
    void showWritten(const QStringList& files, const QString& where);
    void showWriteFailure(const QString& reason);
    void showFiles(const QString& text);
    void showProgress();
    void updateRun();
    void retranslate();

    SharedModel m_model;
    std::shared_ptr<const ForwardSolver> m_solver;
    SettledSampler m_sampler;
    std::vector<SettledSample> m_samples;
    ErrorReport m_report;
    MotionIds m_ids{MotionAsker::Report};
    std::optional<PoseSequence> m_sequence;
    QString m_listFile; ///< empty: the default list
    QString m_defaultFolder;
    bool m_folderChosen = false;
    bool m_exportPending = false;
    bool m_connected = false;
    QString m_hindrance; ///< why Run report cannot be pressed, though something is connected
    QStringList m_files;
    ReportWriter* m_writer;

    QLabel* m_listLabel = nullptr;
    QComboBox* m_list = nullptr;
    QPushButton* m_browseList = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_clear = nullptr;
    TextReadOut* m_progress = nullptr;
    QTableWidget* m_table = nullptr;
    ReportPreview* m_preview = nullptr;
    QLabel* m_folderLabel = nullptr;
    QLineEdit* m_folder = nullptr;
    QPushButton* m_browseFolder = nullptr;
    QLabel* m_filesLabel = nullptr;
    TextReadOut* m_filesText = nullptr;
};

} // namespace hexapose
