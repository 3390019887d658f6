// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/pose_book.h"

#include "core/base/number_text.h"
#include "ui/common/status_text.h"

#include <QSettings>
#include <QStringList>

#include <optional>

namespace hexapose {

namespace {

QString groupOf(const std::string& platformFingerprint) {
    return QStringLiteral("poses/") + QString::fromStdString(platformFingerprint);
}

/// Six numbers in mm and degrees, as on the screen.
std::optional<Pose> poseFromTexts(const QStringList& texts) {
    if (texts.size() != 6) {
        return std::nullopt;
    }
    PoseVector si;
    for (int i = 0; i < 6; ++i) {
        const auto shown = parseNumber(texts[i].toStdString());
        if (!shown) {
            return std::nullopt;
        }
        si[i] = fromDisplay(i, *shown);
    }
    return si.allFinite() ? std::optional(Pose::fromVector(si)) : std::nullopt;
}

} // namespace

std::vector<NamedPose> loadNamedPoses(QSettings& settings, const std::string& platformFingerprint) {
    std::vector<NamedPose> poses;
    const int count = settings.beginReadArray(groupOf(platformFingerprint));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const QString name = settings.value(QStringLiteral("name")).toString().simplified();
        const auto pose = poseFromTexts(settings.value(QStringLiteral("pose")).toStringList());
        if (!name.isEmpty() && pose) {
            poses.push_back({name, *pose});
        }
    }
    settings.endArray();
    return poses;
}

void saveNamedPoses(QSettings& settings, const std::string& platformFingerprint,
                    const std::vector<NamedPose>& poses) {
    settings.remove(groupOf(platformFingerprint));
    settings.beginWriteArray(groupOf(platformFingerprint), static_cast<int>(poses.size()));
    int index = 0;
    for (const NamedPose& one : poses) {
        settings.setArrayIndex(index++);
        QStringList texts;
        const PoseVector si = one.pose.toVector();
        for (int i = 0; i < 6; ++i) {
            texts.append(QString::fromStdString(formatNumber(toDisplay(i, si[i]))));
        }
        settings.setValue(QStringLiteral("name"), one.name);
        settings.setValue(QStringLiteral("pose"), texts);
    }
    settings.endArray();
}

} // namespace hexapose
