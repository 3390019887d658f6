// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/model_job.h"

#include "core/finite_step/finite_step_solver.h"
#include "core/finite_step/path_fallback.h"
#include "core/kinematics/catalog/forward_methods.h"
#include "core/kinematics/regression/model_cache.h"

namespace hexapose {

namespace {
constexpr std::string_view kFiniteSteps = "fsi";
/// From one measurement to the next the legs go a millimetre at most, and a tenth of these would do; but as
/// many let a path go on to q = 0.05, where the console's bar turns red. 0.3 ms.
constexpr int kStepsOfACycle = 400;
constexpr std::string_view kMethodWithoutModel = "newton";
} // namespace

ModelJob::ModelJob(SharedModel platform, const std::string& method, const std::filesystem::path& cache,
                   QObject* parent)
    : QObject(parent), m_platform(std::move(platform)), m_method(method), m_cache(cache),
      m_job(QStringLiteral("model training")) {}

void ModelJob::start() {
    m_job.start([this](const Job& job) { return make(job); },
                [this](const Job::Outcome<std::optional<ReadySolver>>& outcome) {
                    if (!outcome.result) {
                        emit failed(outcome.error);
                    } else if (!*outcome.result) {
                        emit cancelled();
                    } else {
                        emit ready(**outcome.result);
                    }
                });
}

std::optional<ReadySolver> ModelJob::make(const Job& job) {
    if (m_method == kFiniteSteps) {
        return ReadySolver{
            std::make_unique<FiniteStepSolver>(m_platform, FiniteStepOptions{.steps = kStepsOfACycle}), {}};
    }
    const ForwardMethod* method = findForwardMethod(m_method);
    if (method->modelDegree == 0) {
        return ReadySolver{makeForwardSolver(*method, m_platform, nullptr, NewtonOptions{}), {}};
    }
    const TrainingSpec spec = defaultTrainingSpec(m_platform->geometry(), method->modelDegree);
    const auto cached = loadOrTrainModel(m_platform->geometry(), spec, m_cache, [this, &job](double part) {
        job.deliver([this, part] { emit progressed(part); });
        return !job.isCancelled();
    });
    if (!cached || job.isCancelled()) {
        return std::nullopt;
    }
    return ReadySolver{
        withPathFallback(*method, m_platform,
                         makeForwardSolver(*method, m_platform, &cached->model, NewtonOptions{})),
        cached->model.fingerprint()};
}

ReadySolver ModelJob::withoutModel() const {
    return {makeForwardSolver(*findForwardMethod(kMethodWithoutModel), m_platform, nullptr, NewtonOptions{}),
            {}};
}

} // namespace hexapose

#include "moc_model_job.cpp"
