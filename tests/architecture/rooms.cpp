// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "tests/architecture/source_rules.h"

namespace hexapose::architecture {
namespace {

constexpr bool withQt = true;

std::vector<std::string_view> join(std::vector<std::string_view> first,
                                   const std::vector<std::string_view>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// What a picture may know: numbers, poses, records and reports, never a device or the loop.
const std::vector<std::string_view> values{"core/geometry", "core/kinematics", "core/record", "core/report"};
const std::vector<std::string_view> wholeCore =
    join(values, {"core/finite_step", "core/device", "core/device/serial", "core/control"});

} // namespace

const std::vector<Room>& rooms() {
    static const std::vector<Room> table{
        {"core/geometry", {}},
        {"core/kinematics", {"core/geometry"}},
        {"core/finite_step", {"core/geometry", "core/kinematics"}},
        {"core/device", {"core/geometry", "core/kinematics"}},
        {"core/device/serial", {"core/geometry", "core/device"}, withQt},
        {"core/record", {"core/geometry", "core/kinematics", "core/device"}},
        {"core/report", {"core/geometry", "core/kinematics", "core/device", "core/record"}},
        {"core/control", {"core/geometry", "core/kinematics", "core/device", "core/record"}},

        {"ui/common", values, withQt},
        {"ui/charts", join(values, {"ui/common"}), withQt},
        {"ui/models", join(values, {"ui/common"}), withQt},
        {"ui/report", join(values, {"ui/common"}), withQt},
        {"ui/session", join(values, {"core/control", "core/device/platform_device.h", "ui/common"}), withQt},
        // A panel offers the list of ports; what is behind a port it does not know.
        {"ui/panels",
         join(values, {"core/control", "core/device/platform_device.h", "core/device/serial/serial_ports.h",
                       "ui/common", "ui/charts", "ui/models", "ui/report", "ui/session"}),
         withQt},

        {"app/common", wholeCore, withQt},
        {"app/cli", join(wholeCore, {"app/common", "ui/report"}), withQt},
        {"app/operator",
         join(wholeCore,
              {"app/common", "ui/common", "ui/charts", "ui/models", "ui/report", "ui/session", "ui/panels"}),
         withQt},
    };
    return table;
}

} // namespace hexapose::architecture
