// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hexapose {

/// From here on SIGINT and SIGTERM are remembered rather than deadly, so that a platform is stopped and files
/// are closed.
void catchInterrupts();
bool interrupted();

} // namespace hexapose
