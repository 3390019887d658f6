// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace hexapose {

/// Runs work(lane) for every lane on several threads and calls poll() from the calling thread now and then.
/// Returns once every lane has returned. What a lane computes must not depend on the thread it runs on.
void runLanes(int lanes, unsigned threads, const std::function<void(int)>& work,
              const std::function<void()>& poll);

} // namespace hexapose
