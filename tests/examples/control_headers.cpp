// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
// The public headers of devices, records and control. Who takes one away breaks other people's programs.
#include <hexapose/core/device/byte_channel.h>
#include <hexapose/core/device/line/line_device.h>
#include <hexapose/core/device/platform_device.h>
#include <hexapose/core/device/reconnecting_device.h>
#include <hexapose/core/device/simulation/simulated_machine.h>
#include <hexapose/core/device/simulation/virtual_platform_server.h>
#include <hexapose/core/machine/command.h>
#include <hexapose/core/machine/control_loop.h>
#include <hexapose/core/machine/control_options.h>
#include <hexapose/core/machine/planner.h>
#include <hexapose/core/motion/limits.h>
#include <hexapose/core/motion/motion_planner.h>
#include <hexapose/core/record/event.h>
#include <hexapose/core/record/event_codec.h>
#include <hexapose/core/record/log_reader.h>
#include <hexapose/core/record/log_writer.h>
#include <hexapose/core/record/pose_list.h>
#include <hexapose/core/record/snapshot.h>
#include <hexapose/core/report/error_report.h>
#include <hexapose/core/session/session.h>
