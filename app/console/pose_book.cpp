// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/pose_book.h"

#include "core/base/number_text.h"
#include "ui/common/status_text.h"

#include <QSettings>
#include <QStringList>

#include <algorithm>
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

/// The entries of an array, in order: "1", "2", ...
std::vector<int> indexesOf(const QStringList& groups) {
    std::vector<int> indexes;
    for (const QString& group : groups) {
        const int index = group.toInt();
        if (index >= 1) {
            indexes.push_back(index);
        }
    }
    std::sort(indexes.begin(), indexes.end());
    return indexes;
}

} // namespace

LoadedPoses loadNamedPoses(QSettings& settings, const std::string& platformFingerprint) {
    LoadedPoses loaded;
    settings.beginGroup(groupOf(platformFingerprint));
    // Those that are there: the size beside them may be any number after a slip of the hand.
    for (const int index : indexesOf(settings.childGroups())) {
        const QString entry = QString::number(index) + QLatin1Char('/');
        const QString name = settings.value(entry + QStringLiteral("name")).toString().simplified();
        const auto pose = poseFromTexts(settings.value(entry + QStringLiteral("pose")).toStringList());
        if (!name.isEmpty() && pose) {
            loaded.poses.push_back({name, *pose});
        } else {
            ++loaded.dropped;
        }
    }
    settings.endGroup();
    return loaded;
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
