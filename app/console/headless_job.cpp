// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/headless_job.h"

#include "app/common/visit_words.h"
#include "core/base/input_error.h"
#include "core/report/error_report.h"
#include "ui/report/report_export.h"

#include <cstdio>
#include <utility>

namespace hexapose {

namespace {

constexpr int kLookEveryMs = 20;
constexpr double kSamePose = 1e-9; // m and rad

} // namespace

HeadlessJob::HeadlessJob(const std::vector<Pose>& targets, Output output, QObject* parent)
    : QObject(parent), m_first(targets.front()), m_job(targets, {}), m_output(std::move(output)) {
    m_timer.setInterval(kLookEveryMs);
    connect(&m_timer, &QTimer::timeout, this, &HeadlessJob::look);
}

void HeadlessJob::start(Session& session) {
    m_session = &session;
    m_reader = session.reader();
    m_timer.start();
}

void HeadlessJob::interrupt() {
    m_job.interrupt();
    complete();
}

void HeadlessJob::look() {
    advance(m_job, m_reader, *m_session);
    if (m_job.isOver()) {
        complete();
    }
}

void HeadlessJob::complete() {
    if (std::exchange(m_ended, true)) {
        return;
    }
    m_timer.stop();
    const bool done = !m_job.failure();
    const QPixmap picture = done ? m_output.picture() : QPixmap(); // of the window while connected
    emit over();
    int status = done ? write(picture) : 1;
    if (m_session != nullptr) {
        advance(m_job, m_reader, *m_session); // the closing may have something to report
    }
    const std::string failure = failureWords(m_job);
    if (!failure.empty()) {
        const bool moved = m_job.failure() && m_job.failure()->reason == VisitFailure::Reason::Ended;
        std::fprintf(stderr, "hexapose: %s%s\n", moved ? "the move ended early: " : "", failure.c_str());
        status = 1;
    }
    emit finished(status);
}

bool HeadlessJob::isMove(const SettledSample& sample) const {
    return (sample.target.toVector() - m_first.toVector()).norm() < kSamePose;
}

int HeadlessJob::write(const QPixmap& picture) {
    const std::filesystem::path log = m_session->logFile();
    const std::filesystem::path folder = std::filesystem::absolute(
        m_output.folder.empty() ? log.parent_path() / (log.stem().string() + "-report") : m_output.folder);
    const std::filesystem::path pictureFile = folder / "console.png";
    std::vector<std::filesystem::path> files;
    try {
        std::vector<SettledSample> samples = m_job.samples();
        std::erase_if(samples, [this](const SettledSample& sample) { return isMove(sample); });
        const ErrorReport report =
            makeErrorReport(m_session->setup().model->geometry(), *m_session->solver(), samples);
        files = exportErrorReport(report, folder);
        if (!picture.save(QString::fromStdString(pictureFile.string()))) {
            throw InputError(pictureFile.string(), "cannot be written");
        }
    } catch (const InputError& error) {
        std::fprintf(stderr, "hexapose: %s\n", error.what());
        return 1;
    }
    std::printf("log: %s\n", log.c_str());
    for (const std::filesystem::path& file : files) {
        std::printf("report: %s\n", file.c_str());
    }
    std::printf("picture: %s\n", pictureFile.c_str());
    return 0;
}

void HeadlessJob::fail(const std::string& reason) {
    m_ended = true;
    m_timer.stop();
    std::fprintf(stderr, "hexapose: %s\n", reason.c_str());
    emit over();
    emit finished(1);
}

} // namespace hexapose

#include "moc_headless_job.cpp"
