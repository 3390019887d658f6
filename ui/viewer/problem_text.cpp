// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewer/problem_panel.h"

namespace hexapose {

namespace {

QString causeOf(const Problem& problem) {
    const QString text = QString::fromStdString(problem.text);
    switch (problem.kind) {
    case Problem::Kind::NotANumber:
        return ProblemPanel::tr("\"%1\" is not a number; the cell is missing").arg(text);
    case Problem::Kind::NotATime:
        return ProblemPanel::tr("\"%1\" is not a time; the row has none").arg(text);
    case Problem::Kind::TooFewFields:
        return ProblemPanel::tr("%1 fields in place of %2; the row is left out")
            .arg(problem.count)
            .arg(problem.expected);
    case Problem::Kind::TooManyFields:
        return ProblemPanel::tr("%1 fields in place of %2, too many; the row is left out")
            .arg(problem.count)
            .arg(problem.expected);
    case Problem::Kind::HalfWritten:
        return ProblemPanel::tr("half-written last line, left out");
    case Problem::Kind::QuoteNotClosed:
        return ProblemPanel::tr("a quote is not closed; the line is left out");
    case Problem::Kind::TimeGoesBack:
        return ProblemPanel::tr("time goes back; the row is kept");
    case Problem::Kind::TimeRepeated:
        return ProblemPanel::tr("the same time again; the row is kept");
    case Problem::Kind::RenamedColumn:
        return ProblemPanel::tr("this name appears twice; the column is called \"%1\"").arg(text);
    case Problem::Kind::NoName:
        return ProblemPanel::tr("a column without a name is called \"%1\"").arg(text);
    case Problem::Kind::LineTooLong:
        return ProblemPanel::tr("the line is too long and is left out");
    case Problem::Kind::FileChanged:
        return ProblemPanel::tr("the file became shorter while it was read");
    }
    return {};
}

} // namespace

QString problemText(const Problem& problem) {
    QStringList where;
    if (problem.line > 0)
        where.append(ProblemPanel::tr("line %1").arg(problem.line));
    if (!problem.column.empty())
        where.append(QString::fromStdString(problem.column));
    const QString cause = causeOf(problem);
    return where.isEmpty() ? cause : where.join(QStringLiteral(", ")) + QStringLiteral(": ") + cause;
}

} // namespace hexapose
