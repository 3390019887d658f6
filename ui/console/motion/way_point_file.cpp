// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/motion/way_point_file.h"

#include "core/base/number_text.h"
#include "ui/common/status_text.h"

#include <QSaveFile>

namespace hexapose {

namespace {
constexpr int kFileDecimals = 6; // of a mm or degree
}

QString saveWayPoints(const QString& file, const std::vector<Pose>& poses) {
    std::string text = "x_mm,y_mm,z_mm,alpha_deg,beta_deg,gamma_deg\n";
    for (const Pose& pose : poses) {
        const PoseVector si = pose.toVector();
        for (int i = 0; i < 6; ++i) {
            text += formatFixed(toDisplay(i, si[i]), kFileDecimals) + (i < 5 ? ',' : '\n');
        }
    }
    QSaveFile out(file);
    const bool written = out.open(QIODevice::WriteOnly) &&
                         out.write(text.data(), static_cast<qint64>(text.size())) >= 0 && out.commit();
    return written ? QString() : out.errorString();
}

} // namespace hexapose
