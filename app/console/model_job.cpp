// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/model_job.h"

#include "core/finite_step/finite_step_solver.h"
#include "core/finite_step/path_fallback.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/regression/model_cache.h"

#include <QThread>

#include <exception>

namespace hexapose {

namespace {
constexpr std::string_view kFiniteSteps = "fsi";
/// From one measurement to the next the legs go a millimetre at most, and a tenth of these would do; but as
/// many let a path go on to q = 0.05, where the console's bar turns red. 0.3 ms.
constexpr int kStepsOfACycle = 400;
constexpr std::string_view kMethodWithoutModel = "newton";
} // namespace

ModelJob::ModelJob(const PlatformGeometry& geometry, const std::string& method,
                   const std::filesystem::path& cache, QObject* parent)
    : QObject(parent), m_geometry(geometry), m_method(method), m_cache(cache) {
    qRegisterMetaType<ReadySolver>();
}

ModelJob::~ModelJob() {
    cancel();
    if (m_thread) {
        m_thread->wait();
    }
}

void ModelJob::start() {
    m_thread.reset(QThread::create([this] { work(); }));
    m_thread->setObjectName(QStringLiteral("model training"));
    m_thread->start();
}

// On the job's own thread; a signal is carried over to the receiver's.
void ModelJob::work() {
    try {
        if (m_method == kFiniteSteps) {
            emit ready(
                {std::make_unique<FiniteStepSolver>(m_geometry, FiniteStepOptions{.steps = kStepsOfACycle}),
                 {}});
            return;
        }
        const ForwardMethod* method = findForwardMethod(m_method);
        if (method->modelDegree == 0) {
            emit ready({makeForwardSolver(*method, m_geometry, nullptr, NewtonOptions{}), {}});
            return;
        }
        const TrainingSpec spec = defaultTrainingSpec(m_geometry, method->modelDegree);
        const auto cached = loadOrTrainModel(m_geometry, spec, m_cache, [this](double part) {
            emit progressed(part);
            return !m_cancelled;
        });
        if (!cached || m_cancelled) {
            emit cancelled();
            return;
        }
        const SharedModel platform = makeModel(m_geometry);
        emit ready({withPathFallback(*method, platform,
                                     makeForwardSolver(*method, platform, &cached->model, NewtonOptions{})),
                    cached->model.fingerprint()});
    } catch (const std::exception& error) {
        emit failed(QString::fromUtf8(error.what()));
    }
}

ReadySolver ModelJob::withoutModel() const {
    return {makeForwardSolver(*findForwardMethod(kMethodWithoutModel), m_geometry, nullptr, NewtonOptions{}),
            {}};
}

} // namespace hexapose

#include "moc_model_job.cpp"
