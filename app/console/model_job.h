// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kinematics/forward_solver.h"
#include "core/kinematics/platform_model.h"
#include "ui/common/job.h"

#include <QObject>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace hexapose {

/// A solver that is ready to be used, and the regression model in it.
struct ReadySolver {
    std::shared_ptr<const ForwardSolver> solver;
    std::string modelFingerprint; ///< empty: no model
};

/// Makes the solver: reads or trains the model of a platform, where the method needs one, on a thread of its
/// own; the signals come on the thread of this object.
class ModelJob final : public QObject {
    Q_OBJECT
public:
    /// method: its word on the command line, one of those that refine (mpr3-nr, mpr2-nr, newton) or fsi.
    ModelJob(SharedModel platform, const std::string& method, const std::filesystem::path& cache,
             QObject* parent = nullptr);
    void start();
    void cancel() { m_job.cancel(); }
    /// Newton alone, which needs no model: what remains when the training was cancelled or failed.
    ReadySolver withoutModel() const;

signals:
    void progressed(double part);
    void ready(const hexapose::ReadySolver& solver);
    void cancelled();
    void failed(const QString& reason);

private:
    /// Nothing when it was cancelled.
    std::optional<ReadySolver> make(const Job& job);

    SharedModel m_platform;
    std::string m_method;
    std::filesystem::path m_cache;
    Job m_job; ///< last, so that it is waited for first
};

} // namespace hexapose
