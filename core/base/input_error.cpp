// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT

#include "core/base/input_error.h"

#include <utility>

namespace hexapose {

namespace {

std::string causeOf(const InputFault& fault) {
    const auto detail = [&fault](std::size_t i) {
        return i < fault.details.size() ? fault.details[i] : std::string();
    };
    switch (fault.kind) {
    case InputFault::Kind::Exists:
        return "exists already";
    case InputFault::Kind::NotCreated:
        return "cannot be created: " + detail(0);
    case InputFault::Kind::NotWritten:
        return "cannot be written: " + detail(0);
    case InputFault::Kind::NotRead:
        return "cannot be read: " + detail(0);
    case InputFault::Kind::NotReadFurther:
        return "cannot be read further";
    case InputFault::Kind::Directory:
        return "is a directory";
    case InputFault::Kind::Empty:
        return "is empty, a header row was expected";
    case InputFault::Kind::OpenQuote:
        return "a quote is opened and never closed";
    case InputFault::Kind::NotUtf8:
        return "is not UTF-8 text";
    case InputFault::Kind::ColumnMissing:
        return "column " + detail(0) + " is missing";
    case InputFault::Kind::NoCommas:
        return "column " + detail(0) + " is missing: fields are to be separated by commas";
    case InputFault::Kind::ColumnTwice:
        return "column " + detail(0) + " appears twice";
    case InputFault::Kind::LastLineIncomplete:
        return "the last line is incomplete";
    case InputFault::Kind::FieldCount:
        return detail(0) + " fields, but the header has " + detail(1);
    case InputFault::Kind::NotFinite:
        return detail(0) + " \"" + detail(1) + "\" is not a finite number";
    case InputFault::Kind::NoPoses:
        return "holds no attitudes"; // as programs that read it know it
    }
    return {};
}

} // namespace

InputError::InputError(InputFault fault)
    : std::runtime_error(fault.where + (fault.line > 0 ? ":" + std::to_string(fault.line) : "") + ": " +
                         causeOf(fault)),
      m_fault(std::make_shared<const InputFault>(std::move(fault))) {}

} // namespace hexapose
