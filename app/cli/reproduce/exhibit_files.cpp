// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/reproduce/exhibit_files.h"

#include "app/cli/reproduce/exhibit_text.h"
#include "ui/plot/picture_files.h"

namespace hexapose::reproduce {

void writeExhibit(const Exhibit& exhibit, const std::filesystem::path& directory) {
    const std::filesystem::path stem = directory / exhibit.name;
    const auto write = [&](const char* ending, const std::string& text) {
        writeWholeFile(stem.string() + ending, QByteArray::fromStdString(text));
    };
    write(".txt", exhibitText(exhibit));
    write(".csv", exhibit.csv);
    savePicture(exhibit.picture, stem);
    if (!exhibit.timesCsv.empty())
        write("-times.csv", exhibit.timesCsv);
    if (exhibit.timesPicture)
        savePicture(*exhibit.timesPicture, stem.string() + "-times");
}

} // namespace hexapose::reproduce
