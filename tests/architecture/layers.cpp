// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "tests/architecture/source_rules.h"

namespace hexapose::architecture {
namespace {

constexpr bool withQt = true;
using Folders = std::vector<std::string_view>;

Folders join(Folders first, const Folders& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

const Folders kinematics{"core/base",
                         "core/geometry",
                         "core/kinematics",
                         "core/kinematics/catalog",
                         "core/kinematics/newton",
                         "core/kinematics/regression",
                         "core/kinematics/vector"};
/// What a picture may know: numbers, poses, records and reports, never a device or the loop.
const Folders values = join(kinematics, {"core/record", "core/report"});
const Folders control{"core/motion", "core/tracking", "core/machine", "core/session"};
const Folders device{"core/device", "core/device/line", "core/device/simulation"};
const Folders wholeCore = join(join(join(values, control), device),
                               {"core/finite_step", "core/device/serial", "core/table", "core/analysis"});
/// A page of the console is given the names of the ports; what is behind a port it does not know.
const Folders page = join(join(values, control), {"ui/common", "ui/plot", "ui/charts", "ui/report"});
const Folders console{"ui/console/window", "ui/console/motion", "ui/console/status", "ui/console/events",
                      "ui/console/report"};

} // namespace

const std::vector<Layer>& layers() {
    static const std::vector<Layer> table{
        {"core/base", {}},
        {"core/geometry", {"core/base"}},
        {"core/kinematics", {"core/base", "core/geometry"}},
        {"core/kinematics/vector", {"core/base", "core/geometry", "core/kinematics"}},
        {"core/kinematics/newton",
         {"core/base", "core/geometry", "core/kinematics", "core/kinematics/vector"}},
        {"core/kinematics/regression",
         {"core/base", "core/geometry", "core/kinematics", "core/kinematics/vector",
          "core/kinematics/newton"}},
        {"core/kinematics/catalog",
         {"core/base", "core/geometry", "core/kinematics", "core/kinematics/newton",
          "core/kinematics/regression"}},
        {"core/finite_step", kinematics},
        {"core/device", join(kinematics, {"core/motion", "core/record"})},
        {"core/device/line", join(kinematics, {"core/record", "core/device"})},
        {"core/device/simulation", join(kinematics, {"core/record", "core/device", "core/device/line"})},
        {"core/device/serial", {"core/base", "core/geometry", "core/record", "core/device"}, withQt},
        {"core/table", {"core/base"}},
        {"core/analysis", join(kinematics, {"core/table"})},
        {"core/record", join(kinematics, {"core/motion"})},
        {"core/motion", kinematics},
        {"core/tracking", join(kinematics, {"core/record", "core/motion"})},
        {"core/machine", join(kinematics, {"core/device", "core/record", "core/motion", "core/tracking"})},
        {"core/report", join(kinematics, {"core/record"})},
        {"core/session", join(join(values, {"core/device"}), control)},

        {"ui/common", values, withQt},
        {"ui/plot", {"core/base"}, withQt},
        {"ui/charts", join(values, {"ui/common", "ui/plot"}), withQt},
        {"ui/viewer", join(values, {"core/table", "ui/common", "ui/plot", "ui/charts"}), withQt},
        {"ui/report", join(values, {"ui/common", "ui/plot"}), withQt},
        {"ui/console/events", page, withQt},
        {"ui/console/status", join(page, {"ui/console/events"}), withQt},
        {"ui/console/motion", join(page, {"ui/console/events"}), withQt},
        {"ui/console/report", join(page, {"ui/console/events"}), withQt},
        {"ui/console/window", join(page, console), withQt},

        {"app/common", wholeCore, withQt},
        {"app/describe", {"app/common"}, withQt},
        {"app/cli", join(wholeCore, {"app/common", "app/describe", "ui/report", "ui/plot"}), withQt},
        {"app/viewer",
         join(values,
              {"core/table", "app/common", "app/describe", "ui/common", "ui/plot", "ui/charts", "ui/viewer"}),
         withQt},
        {"app/console",
         join(join(wholeCore, console),
              {"app/common", "app/describe", "ui/common", "ui/plot", "ui/charts", "ui/report"}),
         withQt},
    };
    return table;
}

} // namespace hexapose::architecture
