// SPDX-FileCopyrightText: 2026 The Hexapose authors
// SPDX-License-Identifier: MIT
#include "core/table/chunked.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace hexapose {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

} // namespace

std::shared_ptr<void> allocateChunk(std::size_t bytes, bool huge) {
    // A huge page begins at a multiple of its size: more is mapped, and what stands over given back.
    const std::size_t mapped = huge ? bytes + kHugePage : bytes;
    void* const memory =
        ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED)
        throw std::bad_alloc();
    char* begin = static_cast<char*>(memory);
    if (huge) {
        const std::size_t beyond = reinterpret_cast<std::uintptr_t>(begin) % kHugePage;
        const std::size_t before = beyond == 0 ? 0 : kHugePage - beyond;
        if (before > 0)
            ::munmap(begin, before);
        begin += before;
        if (kHugePage > before)
            ::munmap(begin + bytes, kHugePage - before);
        ::madvise(begin, bytes, MADV_HUGEPAGE); // without them it is only slower
    }
    return {begin, [bytes](void* chunk) { ::munmap(chunk, bytes); }};
}

} // namespace hexapose
