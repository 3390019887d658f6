// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// The public headers. Who takes one away breaks other people's programs.
#include <hexapose/core/base/input_error.h>
#include <hexapose/core/base/units.h>
#include <hexapose/core/finite_step/drive_path.h>
#include <hexapose/core/finite_step/finite_step_solver.h>
#include <hexapose/core/finite_step/leg_path.h>
#include <hexapose/core/finite_step/mechanism.h>
#include <hexapose/core/finite_step/mechanism_file.h>
#include <hexapose/core/finite_step/motion_tracking.h>
#include <hexapose/core/finite_step/node_path.h>
#include <hexapose/core/finite_step/path_fallback.h>
#include <hexapose/core/finite_step/pose_errors.h>
#include <hexapose/core/finite_step/step_system.h>
#include <hexapose/core/geometry/euler_angles.h>
#include <hexapose/core/geometry/geometry_file.h>
#include <hexapose/core/geometry/leg_lengths.h>
#include <hexapose/core/geometry/platform_geometry.h>
#include <hexapose/core/geometry/pose.h>
#include <hexapose/core/kinematics/catalog/forward_methods.h>
#include <hexapose/core/kinematics/forward_solver.h>
#include <hexapose/core/kinematics/inverse_kinematics.h>
#include <hexapose/core/kinematics/jacobian.h>
#include <hexapose/core/kinematics/newton/newton_raphson.h>
#include <hexapose/core/kinematics/platform_model.h>
#include <hexapose/core/kinematics/pose_accuracy.h>
#include <hexapose/core/kinematics/regression/model_cache.h>
#include <hexapose/core/kinematics/regression/mpr_newton.h>
#include <hexapose/core/kinematics/regression/polynomial_basis.h>
#include <hexapose/core/kinematics/regression/polynomial_file.h>
#include <hexapose/core/kinematics/regression/polynomial_model.h>
#include <hexapose/core/kinematics/regression/polynomial_training.h>
#include <hexapose/core/kinematics/singular_home.h>
#include <hexapose/core/kinematics/singularity.h>
