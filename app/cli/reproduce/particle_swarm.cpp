// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/particle_swarm.h"

#include "core/kinematics/inverse_kinematics.h"

#include <cmath>
#include <random>

namespace hexapose::reproduce {

namespace {

constexpr double kConstriction = 0.7298;
constexpr double kPull = 2.05; ///< to a particle's own best, and to that of all

/// The same with every library, unlike the standard distributions.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : m_random(seed) {}
    double operator()() { return static_cast<double>(m_random() >> 11) * 0x1p-53; } ///< [0, 1)

private:
    std::mt19937_64 m_random;
};

struct Particle {
    PoseVector place, speed, best;
    double bestFitness;
};

} // namespace

double swarmFitness(const PlatformGeometry& platform, const LegLengths& lengths, const Pose& pose) {
    return (legLengths(platform, pose) - lengths).norm() / std::sqrt(static_cast<double>(kLegCount));
}

std::vector<Pose> searchPose(const PlatformGeometry& platform, const LegLengths& lengths,
                             const SwarmOptions& options) {
    Draw draw(options.seed);
    PoseVector range;
    range << Eigen::Vector3d::Constant(options.offsetRange), Eigen::Vector3d::Constant(options.angleRange);
    const auto fitness = [&](const PoseVector& place) {
        return swarmFitness(platform, lengths, Pose::fromVector(place));
    };
    std::vector<Particle> swarm;
    PoseVector best = PoseVector::Zero();
    double bestFitness = HUGE_VAL;
    const auto consider = [&](Particle& particle) {
        if (const double now = fitness(particle.place); now < particle.bestFitness) {
            particle.bestFitness = now;
            particle.best = particle.place;
        }
        if (particle.bestFitness < bestFitness) {
            bestFitness = particle.bestFitness;
            best = particle.best;
        }
    };
    for (int i = 0; i < options.particles; ++i) {
        Particle particle{{}, PoseVector::Zero(), {}, HUGE_VAL};
        for (int k = 0; k < 6; ++k)
            particle.place[k] = (2.0 * draw() - 1.0) * range[k];
        consider(particle);
        swarm.push_back(particle);
    }
    std::vector<Pose> trace{Pose::fromVector(best)};
    for (int i = 0; i < options.iterations; ++i) {
        for (Particle& particle : swarm) {
            for (int k = 0; k < 6; ++k) {
                const double own = draw();
                const double all = draw();
                particle.speed[k] = kConstriction * (particle.speed[k] +
                                                     kPull * own * (particle.best[k] - particle.place[k]) +
                                                     kPull * all * (best[k] - particle.place[k]));
            }
            particle.place += particle.speed;
            consider(particle);
        }
        trace.push_back(Pose::fromVector(best));
    }
    return trace;
}

} // namespace hexapose::reproduce
