// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/command.h"
#include "app/cli/number_rows.h"
#include "app/common/arguments.h"
#include "app/common/platform_check.h"
#include "core/base/unit_text.h"
#include "core/base/units.h"
#include "core/kinematics/inverse_kinematics.h"
#include "core/motion/limits.h"
#include "core/record/motion_check_words.h"

#include <cstdio>
#include <limits>
#include <string>

namespace hexapose {

Usage inverseUsage() {
    return {"hexapose-cli inverse", {QStringLiteral("POSES.csv")}, {}};
}

int inverseCommand(const Arguments& arguments) {
    const PlatformGeometry platform = arguments.platform();
    warnUnlessMovable(platform, arguments.text("platform", "laboratory"));
    const CsvTable table = readCsv(arguments.operand(0));
    const NumberRows rows(table, kPoseColumns);
    MotionLimits limits = motionLimits(platform, std::nullopt, std::nullopt);
    limits.singularityMargin = 0.0; // only strokes are checked here; the path to a pose belongs to the move
    limits.leastDeterminantRatio = -std::numeric_limits<double>::infinity();

    const PlatformModel model(platform);
    bool allOk = true;
    std::string out = "l1_mm,l2_mm,l3_mm,l4_mm,l5_mm,l6_mm,status\n";
    for (const CsvTable::Row& row : everyRow(table)) {
        std::string status = "invalid-input";
        if (const auto values = rows.read(row)) {
            Pose pose;
            for (int k = 0; k < 3; ++k)
                pose.offset[k] = metresFromMm((*values)[k]);
            pose.angles = {radiansFromDeg((*values)[3]), radiansFromDeg((*values)[4]),
                           radiansFromDeg((*values)[5])};
            const LegLengths lengths = model.actuators(pose);
            for (int i = 0; i < kLegCount; ++i)
                out += mmText(lengths[i]) + ",";
            status = toWords(checkPose(model, limits, pose));
        } else {
            out += ",,,,,,";
        }
        allOk = allOk && status == "ok";
        out += status + "\n";
    }
    std::fwrite(out.data(), 1, out.size(), stdout);
    return allOk ? kExitDone : kExitSomeFailed;
}

} // namespace hexapose
