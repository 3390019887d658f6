// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/reproduce/exhibit.h"

#include <QByteArray>
#include <QString>

#include <span>

namespace hexapose::reproduce {

/// All exhibits on A4: what was checked on the first page, then each with its tables and its picture.
QByteArray reproductionPdf(std::span<const Exhibit> exhibits);

struct PdfTitles {
    QString title;  ///< of the document
    QString footer; ///< of every page
};
/// Exhibits one after the other, without that first page.
QByteArray exhibitsPdf(std::span<const Exhibit> exhibits, const PdfTitles& titles);

} // namespace hexapose::reproduce
