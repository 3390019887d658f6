// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/console/events/input_fault_text.h"

#include <QCoreApplication>

namespace hexapose {

namespace {

struct InputFaultText {
    Q_DECLARE_TR_FUNCTIONS(hexapose::InputFaultText)
};

QString detail(const InputFault& fault, std::size_t index) {
    return index < fault.details.size() ? QString::fromStdString(fault.details[index]) : QString();
}

QString causeText(const InputFault& fault) {
    const QString first = detail(fault, 0);
    switch (fault.kind) {
    case InputFault::Kind::Exists:
        return InputFaultText::tr("exists already");
    case InputFault::Kind::NotCreated:
        return InputFaultText::tr("cannot be created: %1").arg(first);
    case InputFault::Kind::NotWritten:
        return InputFaultText::tr("cannot be written: %1").arg(first);
    case InputFault::Kind::NotRead:
        return InputFaultText::tr("cannot be read: %1").arg(first);
    case InputFault::Kind::NotReadFurther:
        return InputFaultText::tr("cannot be read further");
    case InputFault::Kind::Directory:
        return InputFaultText::tr("is a directory");
    case InputFault::Kind::Empty:
        return InputFaultText::tr("is empty, a header row was expected");
    case InputFault::Kind::OpenQuote:
        return InputFaultText::tr("a quote is opened and never closed");
    case InputFault::Kind::NotUtf8:
        return InputFaultText::tr("is not UTF-8 text");
    case InputFault::Kind::ColumnMissing:
        return InputFaultText::tr("column %1 is missing").arg(first);
    case InputFault::Kind::NoCommas:
        return InputFaultText::tr("column %1 is missing; separate the fields by commas").arg(first);
    case InputFault::Kind::ColumnTwice:
        return InputFaultText::tr("column %1 appears twice").arg(first);
    case InputFault::Kind::LastLineIncomplete:
        return InputFaultText::tr("the last line is incomplete");
    case InputFault::Kind::FieldCount:
        return InputFaultText::tr("%1 fields, but the header has %2").arg(first, detail(fault, 1));
    case InputFault::Kind::NotFinite:
        return InputFaultText::tr("%1 \"%2\" is not a finite number").arg(first, detail(fault, 1));
    case InputFault::Kind::NoPoses:
        return InputFaultText::tr("the list holds no poses");
    }
    return {};
}

} // namespace

QString inputFaultText(const InputError& error) {
    const InputFault* fault = error.fault();
    if (fault == nullptr) {
        return QString::fromUtf8(error.what());
    }
    const QString where = QString::fromStdString(fault->where);
    const QString cause = causeText(*fault);
    return fault->line > 0
               ? InputFaultText::tr("%1, line %2: %3").arg(where, QString::number(fault->line), cause)
               : InputFaultText::tr("%1: %2").arg(where, cause);
}

} // namespace hexapose
